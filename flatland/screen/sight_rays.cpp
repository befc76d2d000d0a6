// SPDX-License-Identifier: MIT
#include "flatland/screen/sight_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "flatland/screen/sight.h"

namespace flatland {

namespace {

constexpr int kSteps = 16;

/// What a ray can meet: a stretch of a curve in its box.
struct Element {
  int curve, piece;
  const SightCurves::Stretch* stretch;
  Vec2 centre, half;
};

/// A curve that is no polynomial, at evenly spread places of a stretch.
struct Sample {
  double t;  ///< local to the piece
  Vec2 p, d1;
};

struct Node {
  Vec2 centre, half;
  int first, count;  ///< of the elements; children if there are any
  int left = -1, right = -1;
};

}  // namespace

struct SightRays::Shared {
  explicit Shared(const Scene& scene) : curves(scene) {
    for (std::size_t c = 0; c < curves.curves.size(); ++c) {
      for (const SightCurves::Stretch& stretch : curves.stretches[c]) add(c, stretch);
    }
    if (!elements.empty()) build(0, static_cast<int>(elements.size()));
    // Only now do the elements stand in their final order.
    for (const Element& each : elements) samples.push_back(samplesOf(each));
  }

  void add(std::size_t c, const SightCurves::Stretch& stretch) {
    const Curve& curve = curves.curves[c];
    const int piece = locate(curve, 0.5 * (stretch.low + stretch.high)).piece;
    Vec2 low = stretch.around.front(), high = low;
    for (const Vec2& p : stretch.around) low = low.cwiseMin(p), high = high.cwiseMax(p);
    const Vec2 slack = Vec2::Constant(stretch.slack);
    elements.push_back(
        {static_cast<int>(c), piece, &stretch, 0.5 * (low + high), 0.5 * (high - low) + slack});
  }

  /// Empty on a curve with a Bezier form.
  std::vector<Sample> samplesOf(const Element& element) const {
    const auto c = static_cast<std::size_t>(element.curve);
    std::vector<Sample> all;
    if (!curves.pieces[c].empty()) return all;
    const double low = element.stretch->low - element.piece;
    const double high = element.stretch->high - element.piece;
    for (int i = 0; i <= kSteps; ++i) {
      const double t = i == kSteps ? high : low + (high - low) * i / kSteps;
      const Jet jet = jetAt(curves.curves[c], element.piece, t);
      all.push_back({t, jet.p, jet.d1});
    }
    return all;
  }

  int build(int first, int count) {
    const auto begin = elements.begin() + first, end = begin + count;
    Vec2 low = begin->centre - begin->half, high = begin->centre + begin->half;
    for (auto at = begin; at != end; ++at) {
      low = low.cwiseMin(at->centre - at->half);
      high = high.cwiseMax(at->centre + at->half);
    }
    const auto index = nodes.size();
    nodes.push_back({0.5 * (low + high), 0.5 * (high - low), first, count});
    constexpr int kLeaf = 4;
    if (count <= kLeaf) return static_cast<int>(index);
    const int axis = high.x() - low.x() > high.y() - low.y() ? 0 : 1;
    std::nth_element(begin, begin + count / 2, end, [axis](const Element& a, const Element& b) {
      return a.centre[axis] < b.centre[axis];
    });
    const int left = build(first, count / 2);
    const int right = build(first + count / 2, count - count / 2);
    nodes[index].left = left;
    nodes[index].right = right;
    return static_cast<int>(index);
  }

  SightCurves curves;
  std::vector<Element> elements;
  std::vector<std::vector<Sample>> samples;  ///< of each element
  std::vector<Node> nodes;
};

namespace {

/// One line of sight, from a point of a curve to the viewer.
class Ray {
 public:
  Ray(const SightCurves& curves, int curve, double t, double angleDeg)
      : sight_(curves, View{angleDeg, std::nullopt}),
        curve_(curve),
        t_(t),
        q_(pointAt(curves.curves[static_cast<std::size_t>(curve)], t)),
        line_(sight_.lineThrough(q_)),
        nearest_(nearness(sight_.frame(), q_) + sight_.sameDepth()) {}

  /// Whether a box may hold what hides the point.
  template <class Box>
  bool meets(const Box& box) const {
    const Vec2 axis = sight_.frame().axis, towards = sight_.frame().towards;
    const Vec2 d = box.centre - q_;
    return std::abs(d.dot(axis)) <= box.half.dot(axis.cwiseAbs()) + sight_.sameImage() &&
           nearness(sight_.frame(), box.centre) + box.half.dot(towards.cwiseAbs()) > nearest_;
  }

  bool isHiddenByPiece(const Element& element) {
    // Most often the control points settle it: all on one side of the line, or the ends on either
    // side of it and all before the point.
    double least = std::numeric_limits<double>::infinity(), most = -least, farthest = least;
    for (const Vec2& p : element.stretch->around) {
      const double beside = sight_.image(p) - line_.image;
      least = std::min(least, beside);
      most = std::max(most, beside);
      farthest = std::min(farthest, nearness(sight_.frame(), p));
    }
    const double same = sight_.sameImage();
    if (least > same || most < -same) return false;
    const double a = sight_.image(element.stretch->around.front()) - line_.image;
    const double b = sight_.image(element.stretch->around.back()) - line_.image;
    if (farthest > nearest_ && std::min(a, b) < -same && std::max(a, b) > same) return true;
    parts_.clear();
    sight_.cut(element.curve, element.piece, parts_);
    return isHiddenByParts();
  }

  bool isHiddenBySamples(const Element& element, const std::vector<Sample>& samples) {
    const Vec2 axis = sight_.frame().axis;
    constexpr double kAnywhere = std::numeric_limits<double>::infinity();
    const double same = sight_.sameImage();
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
      const Sample &a = samples[i], &b = samples[i + 1];
      const double besideA = a.p.dot(axis) - line_.image, besideB = b.p.dot(axis) - line_.image;
      const double slopeA = a.d1.dot(axis), slopeB = b.d1.dot(axis);
      const bool folds = slopeA * slopeB < 0.0;
      // Both ends on one side and no fold between them that reaches over.
      if (besideA > same && besideB > same && !(folds && slopeA < 0.0)) continue;
      if (besideA < -same && besideB < -same && !(folds && slopeA > 0.0)) continue;
      parts_.clear();
      if (folds) {
        const double fold = foldBetween(element, a.t, b.t, slopeA);
        sight_.add(*element.stretch, element.curve, element.piece, a.t, fold, kAnywhere, parts_);
        sight_.add(*element.stretch, element.curve, element.piece, fold, b.t, kAnywhere, parts_);
      } else {
        sight_.add(*element.stretch, element.curve, element.piece, a.t, b.t, kAnywhere, parts_);
      }
      if (isHiddenByParts()) return true;
    }
    return false;
  }

 private:
  bool isHiddenByParts() const {
    return std::any_of(parts_.begin(), parts_.end(), [&](const SightPart& part) {
      return sight_.concerns(part, curve_, t_) && sight_.hides(part, q_, line_);
    });
  }

  double foldBetween(const Element& element, double low, double high, double slopeLow) const {
    const Curve& curve = sight_.scene().curves[static_cast<std::size_t>(element.curve)];
    const Vec2 axis = sight_.frame().axis;
    constexpr int kHalvings = 52;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (low + high);
      if (!(middle > low && middle < high)) break;
      const double slope = jetAt(curve, element.piece, middle).d1.dot(axis);
      ((slope < 0.0) == (slopeLow < 0.0) ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  const CurveSight sight_;
  const int curve_;
  const double t_;
  const Vec2 q_;
  const SightLine line_;
  const double nearest_;
  std::vector<SightPart> parts_;
};

}  // namespace

SightRays::SightRays(const Scene& scene) : shared_(std::make_unique<Shared>(scene)) {}
SightRays::~SightRays() = default;
SightRays::SightRays(SightRays&&) noexcept = default;
SightRays& SightRays::operator=(SightRays&&) noexcept = default;

bool SightRays::isVisible(int curve, double t, double angleDeg) const {
  Ray ray(shared_->curves, curve, t, angleDeg);
  std::vector<int> open;
  if (!shared_->nodes.empty()) open.push_back(0);
  while (!open.empty()) {
    const Node& node = shared_->nodes[static_cast<std::size_t>(open.back())];
    open.pop_back();
    if (!ray.meets(node)) continue;
    if (node.left >= 0) {
      open.push_back(node.left);
      open.push_back(node.right);
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      const Element& element = shared_->elements[static_cast<std::size_t>(i)];
      const std::vector<Sample>& samples = shared_->samples[static_cast<std::size_t>(i)];
      if (!ray.meets(element)) continue;
      if (samples.empty() ? ray.isHiddenByPiece(element)
                          : ray.isHiddenBySamples(element, samples)) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace flatland
