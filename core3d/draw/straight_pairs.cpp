// SPDX-License-Identifier: MIT
#include "core3d/draw/straight_pairs.h"

#include <algorithm>
#include <numeric>

namespace flatland {
namespace {

using Eigen::Vector3d;
using End = std::uint32_t;
constexpr End kNoEnd = 0xffffffff;

// The squared length of a sum of unit vectors is 0 if one goes straight on into the other and
// 2 - 2 cos 60 degrees = 1 at the largest turn. Near 0 it is exact where the cosine is rounded
// to 1.
constexpr double kLargestBend = 1.0;
constexpr std::size_t kLeafSize = 8;  // comparing a few is cheaper than going down further

struct Partner {
  double bend = kLargestBend;
  End end = 0;  // so that nothing is better at the largest bend itself

  // For one end: a total order of pairs, so that two ends are each other's best at the same time.
  bool isBetterThan(const Partner& other) const {
    return bend != other.bend ? bend < other.bend : end < other.end;
  }
};

// Directions in boxes that are halved at the median of their longest side. Ends that are taken out
// leave the boxes as they are.
class DirectionTree {
 public:
  explicit DirectionTree(std::span<const Vector3d> directions)
      : directions_(directions), order_(directions.size()), alive_(directions.size(), true) {
    std::iota(order_.begin(), order_.end(), End{0});
    leafOf_.resize(order_.size());
    if (!order_.empty()) build(0, order_.size(), kNoEnd);
  }

  bool isAlive(End e) const { return alive_[e]; }
  std::size_t compared() const { return compared_; }

  void remove(End e) {
    alive_[e] = false;
    std::uint32_t i = leafOf_[e];
    nodes_[i].least = leastOf(nodes_[i]);
    for (i = nodes_[i].parent; i != kNoEnd; i = nodes_[i].parent) {
      nodes_[i].least = std::min(nodes_[nodes_[i].left].least, nodes_[nodes_[i].right].least);
    }
  }

  // The best partner of an end, `known` if there is no better one.
  Partner bestOf(End e, Partner known) {
    search(0, e, known);
    return known;
  }

 private:
  struct Node {
    Vector3d low, high;
    std::size_t first, last;                    // of order_
    std::uint32_t parent, left = 0, right = 0;  // nodes; leaves have no children
    End least = kNoEnd;                         // smallest end that is alive

    bool isLeaf() const { return left == 0; }
  };

  std::uint32_t build(std::size_t first, std::size_t last, std::uint32_t parent) {
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    Node node{directions_[order_[first]], directions_[order_[first]], first, last, parent};
    for (std::size_t i = first; i < last; ++i) {
      node.low = node.low.cwiseMin(directions_[order_[i]]);
      node.high = node.high.cwiseMax(directions_[order_[i]]);
      node.least = std::min(node.least, order_[i]);
    }
    nodes_.push_back(node);
    if (last - first <= kLeafSize) {
      for (std::size_t i = first; i < last; ++i) leafOf_[order_[i]] = number;
      return number;
    }
    Eigen::Index axis = 0;
    (node.high - node.low).maxCoeff(&axis);
    const std::size_t middle = first + (last - first) / 2;
    const auto at = [this](std::size_t i) {
      return order_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::nth_element(at(first), at(middle), at(last),
                     [&](End e, End f) { return directions_[e][axis] < directions_[f][axis]; });
    const std::uint32_t left = build(first, middle, number);
    const std::uint32_t right = build(middle, last, number);
    nodes_[number].left = left;
    nodes_[number].right = right;
    return number;
  }

  End leastOf(const Node& leaf) const {
    End least = kNoEnd;
    for (std::size_t i = leaf.first; i < leaf.last; ++i) {
      if (alive_[order_[i]]) least = std::min(least, order_[i]);
    }
    return least;
  }

  // What no end of a node can be better than.
  Partner bound(std::uint32_t node, End e) const {
    const Node& n = nodes_[node];
    const Vector3d onward = -directions_[e];
    const Vector3d outside = (n.low - onward).cwiseMax(onward - n.high).cwiseMax(Vector3d::Zero());
    return {outside.squaredNorm(), n.least};
  }

  void search(std::uint32_t number, End e, Partner& best) {
    const Node& node = nodes_[number];
    if (node.isLeaf()) {
      for (std::size_t i = node.first; i < node.last; ++i) {
        const End f = order_[i];
        if (f == e || !alive_[f]) continue;
        ++compared_;
        const Partner partner{(directions_[e] + directions_[f]).squaredNorm(), f};
        if (partner.isBetterThan(best)) best = partner;
      }
      return;
    }
    std::uint32_t near = node.left, far = node.right;
    Partner nearBound = bound(near, e), farBound = bound(far, e);
    if (farBound.isBetterThan(nearBound)) {
      std::swap(near, far);
      std::swap(nearBound, farBound);
    }
    if (nearBound.end != kNoEnd && nearBound.isBetterThan(best)) search(near, e, best);
    if (farBound.end != kNoEnd && farBound.isBetterThan(best)) search(far, e, best);
  }

  std::span<const Vector3d> directions_;
  std::vector<End> order_;
  std::vector<bool> alive_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> leafOf_;
  std::size_t compared_ = 0;
};

}  // namespace

StraightPairs straightPairs(std::span<const Vector3d> outward) {
  StraightPairs found;
  DirectionTree tree(outward);
  struct Link {
    End end;
    double bend;  // to the link before
  };
  std::vector<Link> chain;  // each the best partner of the one before, ever straighter
  for (End start = 0; start < outward.size(); ++start) {
    if (!tree.isAlive(start)) continue;
    chain.push_back({start, kLargestBend});
    while (!chain.empty()) {
      const Link last = chain.back();
      const bool isFirst = chain.size() == 1;
      // Begun from the link before, the search cannot give a worse one: the chain never goes round.
      const End before = isFirst ? kNoEnd : chain[chain.size() - 2].end;
      const Partner known = isFirst ? Partner{} : Partner{last.bend, before};
      const Partner best = tree.bestOf(last.end, known);
      if (isFirst && best.bend >= kLargestBend) {  // nobody's partner
        tree.remove(last.end);
        chain.pop_back();
      } else if (best.end == before) {
        found.pairs.emplace_back(std::min(last.end, before), std::max(last.end, before));
        tree.remove(last.end);
        tree.remove(before);
        chain.resize(chain.size() - 2);
      } else {
        chain.push_back({best.end, best.bend});
      }
    }
  }
  found.compared = tree.compared();
  return found;
}

}  // namespace flatland
