// SPDX-License-Identifier: MIT
#include "flatland/screen/visibility.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <vector>

#include "flatland/screen/sight.h"

namespace flatland {

namespace {

// Samples between two neighbouring images of edges, to catch where curves cross.
constexpr int kSamples = 16;
constexpr int kFewestSamples = 4;
constexpr int kMostSamples = 2000;  // all told, unless the fewest are more

/// Finds the parts that lie over a place of the screen, nearest first: a tree over the parts by
/// their image, each node with the span and the nearest of what is below it.
class PartTree {
 public:
  explicit PartTree(const std::vector<SightPart>& parts) : parts_(parts) {
    for (std::size_t i = 0; i < parts.size(); ++i) order_.push_back(static_cast<int>(i));
    const auto middle = [&](int i) {
      return parts[static_cast<std::size_t>(i)].atLow + parts[static_cast<std::size_t>(i)].atHigh;
    };
    std::sort(order_.begin(), order_.end(),
              [&](int a, int b) { return middle(a) != middle(b) ? middle(a) < middle(b) : a < b; });
    if (!parts.empty()) build(0, static_cast<int>(parts.size()));
  }

  /// Calls visit(part index) for parts whose image, widened by `slack`, holds `image` and whose
  /// nearest point is beyond least(), which may rise meanwhile; the more promising half first.
  /// Stops when visit says true, and says so.
  template <class Visit, class Least>
  bool find(double image, double slack, const Least& least, const Visit& visit) const {
    return !nodes_.empty() && descend(0, image, slack, least, visit);
  }

 private:
  struct Node {
    double low, high, nearest;
    int first, count;  ///< of order_; children if count is beyond kLeaf
    int left, right;
  };
  static constexpr int kLeaf = 4;

  int build(int first, int count) {
    const int index = static_cast<int>(nodes_.size());
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    nodes_.push_back({kInfinite, -kInfinite, -kInfinite, first, count, -1, -1});
    Node node = nodes_.back();
    if (count > kLeaf) {
      node.left = build(first, count / 2);
      node.right = build(first + count / 2, count - count / 2);
      for (const int child : {node.left, node.right}) {
        const Node& below = nodes_[static_cast<std::size_t>(child)];
        node.low = std::min(node.low, below.low);
        node.high = std::max(node.high, below.high);
        node.nearest = std::max(node.nearest, below.nearest);
      }
    } else {
      for (int i = first; i < first + count; ++i) {
        const SightPart& part = at(i);
        node.low = std::min({node.low, part.atLow, part.atHigh});
        node.high = std::max({node.high, part.atLow, part.atHigh});
        node.nearest = std::max(node.nearest, part.nearest);
      }
    }
    nodes_[static_cast<std::size_t>(index)] = node;
    return index;
  }

  const SightPart& at(int i) const {
    return parts_[static_cast<std::size_t>(order_[static_cast<std::size_t>(i)])];
  }

  template <class Visit, class Least>
  bool descend(int index, double image, double slack, const Least& least,
               const Visit& visit) const {
    const Node& node = nodes_[static_cast<std::size_t>(index)];
    if (image < node.low - slack || image > node.high + slack || !(node.nearest > least())) {
      return false;
    }
    if (node.count > kLeaf) {
      const bool rightFirst = nodes_[static_cast<std::size_t>(node.right)].nearest >
                              nodes_[static_cast<std::size_t>(node.left)].nearest;
      const int one = rightFirst ? node.right : node.left;
      const int other = rightFirst ? node.left : node.right;
      return descend(one, image, slack, least, visit) || descend(other, image, slack, least, visit);
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      const SightPart& part = at(i);
      if (image < std::min(part.atLow, part.atHigh) - slack ||
          image > std::max(part.atLow, part.atHigh) + slack || !(part.nearest > least())) {
        continue;
      }
      if (visit(order_[static_cast<std::size_t>(i)])) return true;
    }
    return false;
  }

  const std::vector<SightPart>& parts_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

/// A run of parts without a fold between them, whose images follow each other.
struct Strip {
  int first, last;    ///< of the parts
  double start, end;  ///< image at the ends
  bool isLine;
};

/// What is in front over a stretch of the screen: several strips only where they coincide.
using Front = std::vector<int>;

struct Span {
  double low, high;
  Front front;
};

/// What is in front all along the screen.
class FrontLine {
 public:
  FrontLine(const CurveSight& sight, const std::vector<SightPart>& parts, const PartTree& tree)
      : sight_(sight), parts_(parts), tree_(tree) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const int index = static_cast<int>(i);
      if (!parts[i].goesOn) {
        strips_.push_back({index, index, parts[i].atLow, parts[i].atHigh, isLine(parts[i])});
      }
      strips_.back().last = index;
      strips_.back().end = parts[i].atHigh;
      stripOf_.push_back(static_cast<int>(strips_.size()) - 1);
    }
  }

  /// The part of a strip that is seen there, or the nearest to it.
  const SightPart& partAt(int strip, double image) const {
    const Strip& run = strips_[static_cast<std::size_t>(strip)];
    const double direction = run.end > run.start ? 1.0 : -1.0;
    return *std::lower_bound(
        parts_.begin() + run.first, parts_.begin() + run.last, image,
        [direction](const SightPart& part, double x) { return (x - part.atHigh) * direction > 0; });
  }

  std::vector<Span> run() {
    // Between neighbouring images of edges the same parts are there, so only crossings matter.
    struct Edge {
      double image;
      int strip;
    };
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < strips_.size(); ++i) {
      if (std::abs(strips_[i].start - strips_[i].end) <= sight_.sameImage()) continue;
      edges.push_back({strips_[i].start, static_cast<int>(i)});
      edges.push_back({strips_[i].end, static_cast<int>(i)});
    }
    std::sort(edges.begin(), edges.end(),
              [](const Edge& a, const Edge& b) { return a.image < b.image; });
    if (!edges.empty()) {
      const int slabs = static_cast<int>(edges.size());
      samples_ = std::clamp(kMostSamples / slabs, kFewestSamples, kSamples);
    }
    std::vector<bool> open(strips_.size());
    int count = 0, bent = 0;  // strips that are there, and those of them that are no lines
    for (std::size_t i = 0; i < edges.size();) {
      const double low = edges[i].image;
      for (; i < edges.size() && edges[i].image <= low + sight_.sameImage(); ++i) {
        const auto strip = static_cast<std::size_t>(edges[i].strip);
        open[strip] = !open[strip];
        count += open[strip] ? 1 : -1;
        if (!strips_[strip].isLine) bent += open[strip] ? 1 : -1;
      }
      if (i < edges.size() && count > 0) addSlab(low, edges[i].image, count > 1 && bent > 0);
    }
    return std::move(spans_);
  }

 private:
  bool isLine(const SightPart& part) const {
    const auto& own = sight_.scene().pieces[static_cast<std::size_t>(part.curve)];
    return !own.empty() && own[static_cast<std::size_t>(part.piece)].degree() <= 1;
  }

  Front frontAt(double image) const {
    const SightLine line = sight_.lineAt(image);
    const double same = sight_.sameDepth();
    double best = -std::numeric_limits<double>::infinity();
    std::vector<std::pair<double, int>> near;
    tree_.find(
        image, 0.0, [&] { return best - same; },
        [&](int index) {
          const SightPart& part = parts_[static_cast<std::size_t>(index)];
          if (sight_.isEndOn(part) || !(sight_.nearestOn(part, line) > best - same)) return false;
          const Vec2 p = sight_.point(part, sight_.crossing(part, line));
          const double here = nearness(sight_.frame(), p);
          if (here > best - same) near.emplace_back(here, index);
          best = std::max(best, here);
          return false;
        });
    Front front;
    for (const auto& [here, index] : near) {
      if (here >= best - same) front.push_back(stripOf_[static_cast<std::size_t>(index)]);
    }
    std::sort(front.begin(), front.end());
    front.erase(std::unique(front.begin(), front.end()), front.end());
    return front;
  }

  // The ends themselves are edges, where the answer is about to change: looked at just inside.
  // Lines that are in front at both ends of a stretch are so all along it.
  void addSlab(double low, double high, bool crossingsHide) {
    constexpr double kHair = 1e-6;
    const double width = high - low;
    const double hair = std::min(std::max(kHair * width, 1.5 * sight_.sameImage()), 0.25 * width);
    const int samples = crossingsHide ? samples_ : 1;
    double before = low + hair;
    Front seen = frontAt(before);
    from_ = low;
    for (int k = 1; k <= samples; ++k) {
      const double next = k == samples ? high - hair : low + width * k / samples;
      Front now = frontAt(next);
      change(before, seen, next, now);
      before = next;
      seen = std::move(now);
    }
    emit(high, seen);
  }

  // Closes in on where what is in front changes between two places.
  void change(double low, Front atLow, double high, const Front& atHigh) {
    if (atLow == atHigh) return;
    for (;;) {
      const double middle = 0.5 * (low + high);
      const double apart = std::max(std::abs(low), std::abs(high));
      if (!(middle > low && middle < high) || high - low <= 4.0 * 0x1p-53 * apart) break;
      Front there = frontAt(middle);
      if (there == atLow) {
        low = middle;
      } else if (there == atHigh) {
        high = middle;
      } else {
        change(low, std::move(atLow), middle, there);
        low = middle;
        atLow = std::move(there);
      }
    }
    emit(high, atLow);
  }

  void emit(double to, const Front& front) {
    if (!front.empty() && to > from_) spans_.push_back({from_, to, front});
    from_ = to;
  }

  const CurveSight& sight_;
  const std::vector<SightPart>& parts_;
  const PartTree& tree_;
  std::vector<Strip> strips_;
  std::vector<int> stripOf_;  // of each part
  std::vector<Span> spans_;
  double from_ = 0.0;
  int samples_ = kSamples;
};

}  // namespace

struct Visibility::Parts {
  explicit Parts(const Scene& scene)
      : curves(scene), sight(curves, scene.view), parts(cutAll(sight)), tree(parts) {}

  static std::vector<SightPart> cutAll(const CurveSight& sight) {
    std::vector<SightPart> parts;
    const std::vector<Curve>& curves = sight.scene().curves;
    for (std::size_t c = 0; c < curves.size(); ++c) {
      for (int i = 0; i < pieceCount(curves[c]); ++i) sight.cut(static_cast<int>(c), i, parts);
    }
    return parts;
  }

  double parameterAt(const SightPart& part, double image) const {
    if (std::abs(image - part.atLow) <= sight.sameImage()) return part.piece + part.low;
    if (std::abs(image - part.atHigh) <= sight.sameImage()) return part.piece + part.high;
    return part.piece + sight.crossing(part, sight.lineAt(image));
  }

  std::vector<std::vector<Interval>> findIntervals() const {
    std::vector<std::vector<Interval>> found(curves.curves.size());
    FrontLine line(sight, parts, tree);
    for (const Span& span : line.run()) {
      for (const int strip : span.front) {
        const SightPart& first = line.partAt(strip, span.low);
        const double a = parameterAt(first, span.low);
        const double b = parameterAt(line.partAt(strip, span.high), span.high);
        if (a == b) continue;
        found[static_cast<std::size_t>(first.curve)].push_back({std::min(a, b), std::max(a, b)});
      }
    }
    for (std::vector<Interval>& own : found) {
      std::sort(own.begin(), own.end(),
                [](const Interval& a, const Interval& b) { return a.tLow < b.tLow; });
      std::vector<Interval> joined;
      for (const Interval& each : own) {
        if (!joined.empty() && each.tLow <= joined.back().tHigh) {
          joined.back().tHigh = std::max(joined.back().tHigh, each.tHigh);
        } else {
          joined.push_back(each);
        }
      }
      own = std::move(joined);
    }
    return found;
  }

  SightCurves curves;
  CurveSight sight;
  std::vector<SightPart> parts;
  PartTree tree;
  std::mutex mutex;  ///< for the intervals, found when first asked for
  std::optional<std::vector<std::vector<Interval>>> intervals;
};

Visibility::Visibility(const Scene& scene) : parts_(std::make_unique<Parts>(scene)) {}
Visibility::~Visibility() = default;
Visibility::Visibility(Visibility&&) noexcept = default;
Visibility& Visibility::operator=(Visibility&&) noexcept = default;

bool Visibility::isVisible(int curve, double t) const {
  const CurveSight& sight = parts_->sight;
  const Vec2 q = pointAt(parts_->curves.curves[static_cast<std::size_t>(curve)], t);
  if (!screenCoordinate(sight.frame(), q)) return false;
  const SightLine line = sight.lineThrough(q);
  const double nearest = nearness(sight.frame(), q) + sight.sameDepth();
  return !parts_->tree.find(
      line.image, sight.sameImage(), [&] { return nearest; },
      [&](int index) {
        const SightPart& part = parts_->parts[static_cast<std::size_t>(index)];
        return sight.concerns(part, curve, t) && sight.hides(part, q, line);
      });
}

const std::vector<Visibility::Interval>& Visibility::visibleIntervals(int curve) const {
  const std::scoped_lock lock(parts_->mutex);
  if (!parts_->intervals) parts_->intervals = parts_->findIntervals();
  return (*parts_->intervals)[static_cast<std::size_t>(curve)];
}

}  // namespace flatland
