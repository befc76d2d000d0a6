// SPDX-License-Identifier: MIT
#include "core3d/draw/chains.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace flatland {
namespace {

using Eigen::Vector3f;

// Ends nearer than a few spacings of float at 1 are one place: a line through a vertex crosses
// several of its edges there.
constexpr float kSamePlace = 3e-7f;
// Lines that meet at a junction go on over it if they turn by less than 60 degrees.
constexpr float kLeastCosine = 0.5f;

using End = std::uint32_t;  // 2 * piece for its low node, 2 * piece + 1 for its high one
constexpr End kNoEnd = 0xffffffff;

// A segment turned so that its nodes are in order.
struct Piece {
  std::uint32_t level;
  LineEnd low, high;
  std::uint32_t triangle;
  bool standsOut;

  const LineEnd& end(End e) const { return e % 2 == 0 ? low : high; }
};

using NodeOfLevel = std::pair<std::uint32_t, LineNode>;

// Nodes at one place, as a forest that points to smaller nodes; paths are halved as they are gone.
class MergedNodes {
 public:
  LineNode find(std::uint32_t level, LineNode node) {
    if (parent_.empty()) return node;
    for (auto at = parent_.find({level, node}); at != parent_.end();) {
      const auto above = parent_.find({level, at->second});
      if (above == parent_.end()) return at->second;
      at->second = above->second;
      node = above->second;
      at = parent_.find({level, node});
    }
    return node;
  }
  void merge(std::uint32_t level, LineNode a, LineNode b) {
    a = find(level, a);
    b = find(level, b);
    if (a != b) parent_[{level, std::max(a, b)}] = std::min(a, b);
  }

 private:
  std::map<NodeOfLevel, LineNode> parent_;
};

bool hasLength(const LineSegment& s) { return (s.a.at - s.b.at).norm() > kSamePlace; }

std::vector<Piece> piecesOf(std::span<const LineSegment> segments) {
  MergedNodes merged;
  for (const LineSegment& s : segments) {
    if (!hasLength(s)) merged.merge(s.level, s.a.node, s.b.node);
  }
  std::vector<Piece> pieces;
  pieces.reserve(segments.size());
  for (const LineSegment& s : segments) {
    Piece piece{s.level, s.a, s.b, s.triangle, s.standsOut};
    piece.low.node = merged.find(s.level, s.a.node);
    piece.high.node = merged.find(s.level, s.b.node);
    if (piece.low.node == piece.high.node) continue;
    if (piece.high.node < piece.low.node) std::swap(piece.low, piece.high);
    pieces.push_back(piece);
  }
  const auto nodes = [](const Piece& p) { return std::tuple(p.level, p.low.node, p.high.node); };
  std::sort(pieces.begin(), pieces.end(), [&nodes](const Piece& p, const Piece& q) {
    return std::tuple(nodes(p), p.triangle) < std::tuple(nodes(q), q.triangle);
  });
  const auto end =
      std::unique(pieces.begin(), pieces.end(),
                  [&nodes](const Piece& p, const Piece& q) { return nodes(p) == nodes(q); });
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
    for (End e = 0; e < partner_.size(); ++e) ends_.push_back(e);
    std::sort(ends_.begin(), ends_.end(),
              [this](End e, End f) { return std::tuple(keyOf(e), e) < std::tuple(keyOf(f), f); });
    for (std::size_t first = 0; first < ends_.size();) {
      std::size_t last = first + 1;
      while (last < ends_.size() && keyOf(ends_[last]) == keyOf(ends_[first])) ++last;
      pair(std::span(ends_).subspan(first, last - first));
      first = last;
    }
  }

  std::vector<LineChain> chains() {
    std::vector<std::pair<NodeOfLevel, LineChain>> found;
    const auto add = [&](End start, bool closed) {
      LineChain chain = walk(start, closed);
      if (chain.points.size() >= (closed ? 3u : 2u)) {
        found.emplace_back(keyOf(start), std::move(chain));
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
  NodeOfLevel keyOf(End e) const { return {pieces_[e / 2].level, endOf(e).node}; }

  void pair(std::span<const End> ends) {
    if (ends.size() == 2) {
      join(ends[0], ends[1]);
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

  void join(End e, End f) {
    partner_[e] = f;
    partner_[f] = e;
  }

  Vector3f outward(End e) const { return (endOf(e ^ 1u).at - endOf(e).at).stableNormalized(); }

  // From an end over its piece to the next, until there is none or the chain is round.
  LineChain walk(End start, bool closed) {
    LineChain chain;
    chain.family = family_;
    chain.level = pieces_[start / 2].level;
    chain.closed = closed;
    chain.points.push_back(endOf(start).at);
    chain.strength.push_back(endOf(start).strength);
    for (End e = start; e != kNoEnd && !used_[e / 2]; e = partner_[e ^ 1u]) {
      used_[e / 2] = true;
      chain.strength.back() = std::max(chain.strength.back(), endOf(e).strength);
      chain.triangles.push_back(pieces_[e / 2].triangle);
      chain.standsOut.push_back(pieces_[e / 2].standsOut);
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
  std::vector<End> ends_;  // by level and node
};

}  // namespace

std::vector<LineChain> chainSegments(LineFamily family, std::span<const LineSegment> segments) {
  return Joiner(family, piecesOf(segments)).chains();
}

}  // namespace flatland
