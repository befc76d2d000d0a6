// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/predicted_dashes.h"

#include <cmath>

namespace flatland::ui {

namespace {

using Eigen::Vector3f;

/// Of the coordinates of a mesh, which is 2 long: dash and gap.
constexpr float kDash = 0.035f, kGap = 0.03f;
/// Pieces of a dash: each is hidden or not by its middle.
constexpr int kPerDash = 3;

/// Dashes along a polyline.
class Dasher {
 public:
  void follow(const Vector3f& from, const Vector3f& to) {
    const Vector3f along = to - from;
    const float length = along.norm();
    float done = 0.0f;
    while (done < length) {
      const float period = kDash + kGap, phase = std::fmod(walked_, period);
      const bool drawn = phase < kDash;
      const float rest = drawn ? std::min(kDash - phase, kDash / kPerDash) : period - phase;
      const float step = std::min(std::max(rest, 1e-4f), length - done);
      if (drawn) {
        add(from + along * (done / length));
        add(from + along * ((done + step) / length));
      }
      done += step;
      walked_ += step;
    }
  }

  std::vector<LineVertex> take() { return std::move(ends_); }

 private:
  void add(const Vector3f& p) { ends_.push_back({p.x(), p.y(), p.z(), 1.0f}); }

  std::vector<LineVertex> ends_;
  float walked_ = 0.0f;
};

LineEnds dashesOf(const PredictedLine& line, const TriangleMesh& mesh) {
  const std::vector<Vector3f> points = inMeshCoordinates(line.points, mesh);
  Dasher dasher;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) dasher.follow(points[k], points[k + 1]);
  if (line.closed && points.size() > 2) dasher.follow(points.back(), points.front());
  return std::make_shared<const std::vector<LineVertex>>(dasher.take());
}

}  // namespace

const std::vector<LineEnds>& PredictedDashes::of(const std::shared_ptr<const BridgeView>& view) {
  if (view_ == view) return dashes_;
  view_ = view;
  dashes_.clear();
  for (const PredictedLine& line : view->prediction.lines()) {
    dashes_.push_back(dashesOf(line, *view->seen->surface->mesh));
  }
  return dashes_;
}

}  // namespace flatland::ui
