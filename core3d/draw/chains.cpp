// SPDX-License-Identifier: MIT
#include "core3d/draw/chains.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core3d/draw/straight_pairs.h"

namespace flatland {
namespace {

using Eigen::Vector3f;

// Ends nearer than a few spacings of float at 1 are one place: a line through a vertex crosses
// several of its edges there.
constexpr float kSamePlace = 3e-7f;
// Lines that meet at a junction go on over it if they turn by less than 60 degrees.
constexpr float kLeastCosine = 0.5f;
// Of so many ends all pairs are compared; a fan may have any number.
constexpr std::size_t kFewEnds = 16;

using End = std::uint32_t;  // 2 * piece for its low node, 2 * piece + 1 for its high one
constexpr End kNoEnd = 0xffffffff;

// Number of a node of a level. They are in the order of levels, then of nodes.
using NodeId = std::uint32_t;

// A segment turned so that its nodes are in order.
struct Piece {
  NodeId low, high;
  const LineSegment* segment;
  bool turned;

  NodeId node(End e) const { return e % 2 == 0 ? low : high; }
  const LineEnd& end(End e) const { return (e % 2 == 1) != turned ? segment->b : segment->a; }
};

// Nodes at one place, as a forest that points to smaller nodes; paths are halved as they are gone.
class MergedNodes {
 public:
  explicit MergedNodes(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), NodeId{0});
  }
  NodeId find(NodeId node) {
    while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
    return node;
  }
  void merge(NodeId a, NodeId b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<NodeId> parent_;
};

bool hasLength(const LineSegment& s) { return (s.a.at - s.b.at).norm() > kSamePlace; }

// Of the two ends of each segment.
std::vector<NodeId> nodesOf(std::span<const LineSegment> segments) {
  struct Place {
    LineNode node;
    std::uint32_t level, end;
  };
  std::vector<Place> places;
  places.reserve(2 * segments.size());
  for (const LineSegment& s : segments) {
    for (const LineEnd* end : {&s.a, &s.b}) {
      places.push_back({end->node, s.level, static_cast<std::uint32_t>(places.size())});
    }
  }
  std::sort(places.begin(), places.end(), [](const Place& p, const Place& q) {
    return p.level != q.level ? p.level < q.level : p.node < q.node;
  });
  std::vector<NodeId> nodes(places.size());
  NodeId id = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool next =
        i > 0 && (places[i].node != places[i - 1].node || places[i].level != places[i - 1].level);
    if (next) ++id;
    nodes[places[i].end] = id;
  }
  return nodes;
}

std::vector<Piece> piecesOf(std::span<const LineSegment> segments) {
  const std::vector<NodeId> nodes = nodesOf(segments);
  MergedNodes merged(nodes.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (!hasLength(segments[i])) merged.merge(nodes[2 * i], nodes[2 * i + 1]);
  }
  std::vector<Piece> pieces;
  pieces.reserve(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const NodeId a = merged.find(nodes[2 * i]), b = merged.find(nodes[2 * i + 1]);
    if (a != b) pieces.push_back({std::min(a, b), std::max(a, b), &segments[i], b < a});
  }
  const auto key = [](const Piece& p) { return std::uint64_t{p.low} << 32 | p.high; };
  std::sort(pieces.begin(), pieces.end(), [&key](const Piece& p, const Piece& q) {
    return key(p) != key(q) ? key(p) < key(q) : p.segment->triangle < q.segment->triangle;
  });
  const auto end = std::unique(pieces.begin(), pieces.end(),
                               [&key](const Piece& p, const Piece& q) { return key(p) == key(q); });
  pieces.erase(end, pieces.end());
  return pieces;
}

class Joiner {
 public:
  Joiner(LineFamily family, std::vector<Piece> pieces)
      : family_(family),
        pieces_(std::move(pieces)),
        partner_(2 * pieces_.size(), kNoEnd),
        used_(pieces_.size(), false) {
    sortEnds();
    for (std::size_t first = 0; first < ends_.size();) {
      std::size_t last = first + 1;
      while (last < ends_.size() && nodeOf(ends_[last]) == nodeOf(ends_[first])) ++last;
      pair(std::span(ends_).subspan(first, last - first));
      first = last;
    }
  }

  std::vector<LineChain> chains() {
    std::vector<std::pair<NodeId, LineChain>> found;
    const auto add = [&](End start, bool closed) {
      LineChain chain = walk(start, closed);
      if (chain.points.size() >= (closed ? 3u : 2u)) {
        found.emplace_back(nodeOf(start), std::move(chain));
      }
    };
    for (const End e : ends_) {
      if (partner_[e] == kNoEnd && !used_[e / 2]) add(e, false);
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (!used_[i]) add(static_cast<End>(2 * i), true);
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<LineChain> chains;
    chains.reserve(found.size());
    for (auto& [key, chain] : found) chains.push_back(std::move(chain));
    return chains;
  }

 private:
  const LineEnd& endOf(End e) const { return pieces_[e / 2].end(e); }
  NodeId nodeOf(End e) const { return pieces_[e / 2].node(e); }

  // By node, then by number.
  void sortEnds() {
    NodeId most = 0;
    for (const Piece& piece : pieces_) most = std::max(most, piece.high);
    std::vector<std::uint32_t> before(most + 2, 0);  // how many ends there are at smaller nodes
    for (End e = 0; e < partner_.size(); ++e) ++before[nodeOf(e) + 1];
    std::partial_sum(before.begin(), before.end(), before.begin());
    ends_.resize(partner_.size());
    for (End e = 0; e < partner_.size(); ++e) ends_[before[nodeOf(e)]++] = e;
  }

  void pair(std::span<const End> ends) {
    if (ends.size() == 2) {
      join(ends[0], ends[1]);
      return;
    }
    if (ends.size() > kFewEnds) {
      pairMany(ends);
      return;
    }
    struct Candidate {
      float cosine;
      End e, f;
    };
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      for (std::size_t k = i + 1; k < ends.size(); ++k) {
        const float cosine = -outward(ends[i]).dot(outward(ends[k]));
        if (cosine > kLeastCosine) candidates.push_back({cosine, ends[i], ends[k]});
      }
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.cosine > b.cosine; });
    for (const Candidate& c : candidates) {
      if (partner_[c.e] == kNoEnd && partner_[c.f] == kNoEnd) join(c.e, c.f);
    }
  }

  void pairMany(std::span<const End> ends) {
    std::vector<Eigen::Vector3d> directions;
    directions.reserve(ends.size());
    for (const End e : ends) {
      const Eigen::Vector3d along = endOf(e ^ 1u).at.cast<double>() - endOf(e).at.cast<double>();
      directions.push_back(along.stableNormalized());
    }
    for (const auto& [i, k] : straightPairs(directions).pairs) join(ends[i], ends[k]);
  }

  void join(End e, End f) {
    partner_[e] = f;
    partner_[f] = e;
  }

  Vector3f outward(End e) const { return (endOf(e ^ 1u).at - endOf(e).at).stableNormalized(); }

  // From an end over its piece to the next, until there is none or the chain is round.
  LineChain walk(End start, bool closed) {
    LineChain chain;
    chain.family = family_;
    chain.level = pieces_[start / 2].segment->level;
    chain.closed = closed;
    chain.points.push_back(endOf(start).at);
    chain.strength.push_back(endOf(start).strength);
    for (End e = start; e != kNoEnd && !used_[e / 2]; e = partner_[e ^ 1u]) {
      used_[e / 2] = true;
      chain.strength.back() = std::max(chain.strength.back(), endOf(e).strength);
      chain.triangles.push_back(pieces_[e / 2].segment->triangle);
      chain.standsOut.push_back(pieces_[e / 2].segment->standsOut);
      chain.others.push_back(pieces_[e / 2].segment->other);
      chain.points.push_back(endOf(e ^ 1u).at);
      chain.strength.push_back(endOf(e ^ 1u).strength);
    }
    if (closed) {  // the last point is the first again
      chain.strength.front() = std::max(chain.strength.front(), chain.strength.back());
      chain.points.pop_back();
      chain.strength.pop_back();
    }
    return chain;
  }

  LineFamily family_;
  std::vector<Piece> pieces_;
  std::vector<End> partner_;  // the end that the line goes on with
  std::vector<bool> used_;
  std::vector<End> ends_;  // by node
};

}  // namespace

std::vector<LineChain> chainSegments(LineFamily family, std::span<const LineSegment> segments) {
  return Joiner(family, piecesOf(segments)).chains();
}

}  // namespace flatland
