// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/mark_lines.h"

#include <cmath>

#include "ui/export/mark_style.h"

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
  explicit Dasher(std::vector<LineVertex>& ends) : ends_(ends) {}

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

 private:
  void add(const Vector3f& p) { ends_.push_back({p.x(), p.y(), p.z(), 1.0f}); }

  std::vector<LineVertex>& ends_;
  float walked_ = 0.0f;
};

}  // namespace

std::vector<MarkLines> predictedLines(const BridgeView& bridge, Palette palette) {
  std::vector<MarkLines> all;
  const TriangleMesh& mesh = *bridge.seen->surface->mesh;
  const std::vector<PredictedLine>& lines = bridge.prediction.lines();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::vector<Vector3f> points = inMeshCoordinates(lines[i].points, mesh);
    MarkLines marks;
    marks.colour = styleOf(lines[i].kind, palette).colour;
    marks.widthPx = kPredictedWidthPx;
    marks.ink = bridge.limits[i] == BridgeLimit::None ? 1.0f : kLimitedInk;
    Dasher dasher(marks.ends);
    for (std::size_t k = 0; k + 1 < points.size(); ++k) dasher.follow(points[k], points[k + 1]);
    if (lines[i].closed && points.size() > 2) dasher.follow(points.back(), points.front());
    all.push_back(std::move(marks));
  }
  return all;
}

Rgb sectionColour(Palette palette) {
  return palette == Palette::Light ? Rgb{0x00, 0x7A, 0x5A} : Rgb{0x2E, 0xD9, 0xA3};
}

MarkLines sectionLine(const SectionView& section, Palette palette) {
  return {section.lines, sectionColour(palette), kSectionWidthPx, 1.0f};
}

}  // namespace flatland::ui
