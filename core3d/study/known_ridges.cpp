// SPDX-License-Identifier: MIT
#include "core3d/study/known_ridges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "core3d/mesh/grid.h"
#include "core3d/mesh/solids.h"
#include "core3d/study/unit_random.h"
#include "flatland/features/features.h"

namespace flatland {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kObliqueDeg = 30.0;  // of the sine sheet and the extrusion, in the curve's plane
constexpr double kAcross = 0.4;       // of the extrusion's view, out of that plane
constexpr double kHalfSweep = 1.5;    // half the height of the extrusion
constexpr double kMargin = 0.05;      // of a sheet's width, kept free of samples
constexpr std::array kNames = {"sine-sheet", "gaussian-bump", "extrusion", "revolution"};

Curve formula(Family::Id family, std::vector<double> parameters) {
  return *FormulaCurve::make(FamilyCurve{family, std::move(parameters)}).curve;
}

/// A graph over [left, right]: control points at equal steps, heights in [-1, 1].
Curve randomGraph(double left, double right, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  std::vector<Vec2> points;
  for (int i = 0; i < 5; ++i) {
    points.emplace_back(left + (right - left) * i / 4.0, 2.0 * unitRandom(engine) - 1.0);
  }
  return BezierChain(4, false, points);
}

Curve curveOf(KnownCase subject, std::uint64_t seed) {
  switch (subject) {
    case KnownCase::SineSheet:
      return formula(Family::Id::Sine, {0.5, 2.0, 3.0});
    case KnownCase::GaussianBump:
      return formula(Family::Id::Gaussian, {2.0, 1.0, 4.0});
    case KnownCase::Extrusion:
      return randomGraph(-2.0, 2.0, seed);
    case KnownCase::Revolution:
      break;
  }
  return randomGraph(1.0, 3.0, seed);
}

}  // namespace

std::vector<std::string> knownCaseNames() { return {kNames.begin(), kNames.end()}; }

std::string_view nameOf(KnownCase subject) { return kNames[static_cast<std::size_t>(subject)]; }

std::optional<KnownCase> knownCaseNamed(std::string_view name) {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames[i] == name) return static_cast<KnownCase>(i);
  }
  return std::nullopt;
}

// The curve lies in the plane of x and z, z up, and is swept along y or turned about z.
KnownRidges::KnownRidges(KnownCase subject, std::uint64_t curveSeed)
    : subject_(subject), curve_(curveOf(subject, curveSeed)) {
  const double tilt = turns() ? 0.0 : kObliqueDeg * kPi / 180.0;
  towards_ = {std::sin(tilt), subject == KnownCase::Extrusion ? kAcross : 0.0, std::cos(tilt)};
  towards_.normalize();
  const Vec2 flat(towards_.x(), towards_.z());
  const double angleDeg = turns() ? 90.0 : 90.0 - kObliqueDeg;
  const Scene scene{.curves = {{curve_}}, .view = {.angleDeg = angleDeg, .distance = {}}};
  for (const Mark& mark : findFeatures(scene).marks) {
    if (mark.kind != MarkKind::ApparentRidge) continue;
    const Vec2 normal = frameOf(jetAt(curve_, mark.t)).normal;  // the upper side of a graph
    if (!(normal.dot(flat) > 0.0)) continue;
    if (turns()) {
      // Only where the meridian wins the eigenvalue from the parallel, which turns the normal by
      // its radial part per radius; not at the pole itself.
      if (!(mark.point.x() > 0.0)) continue;
      const double parallel = normal.x() / mark.point.x();
      if (!(*mark.lambda > parallel * parallel * (1.0 + 1e-9))) continue;
    }
    marks_.push_back(mark.point);
  }
}

bool KnownRidges::turns() const {
  return subject_ == KnownCase::GaussianBump || subject_ == KnownCase::Revolution;
}

Eigen::Vector3d KnownRidges::place(const Vec2& onCurve, double along) const {
  if (!turns()) return {onCurve.x(), along, onCurve.y()};
  return {onCurve.x() * std::cos(along), onCurve.x() * std::sin(along), onCurve.y()};
}

Vec2 KnownRidges::onCurvePlane(const Eigen::Vector3d& p) const {
  return {turns() ? std::hypot(p.x(), p.y()) : p.x(), p.z()};
}

PolygonSoup KnownRidges::meshed(const KnownMeshing& meshing) const {
  const Meshing square{
      .cells = meshing.cells, .irregular = meshing.irregular, .seed = meshing.seed};
  if (subject_ == KnownCase::SineSheet) {
    return meshOf({SolidKind::SineSheet, 0.5, 2.0, 3.0}, square).soup;
  }
  if (subject_ == KnownCase::GaussianBump) {
    return meshOf({SolidKind::GaussianBump, 2.0, 4.0}, square).soup;
  }
  PolygonSoup soup;
  std::mt19937_64 engine(meshing.seed);
  const int n = meshing.cells, rows = turns() ? n : n + 1;
  const double start = turns() ? 0.0 : -kHalfSweep, sweep = turns() ? 2.0 * kPi : 2.0 * kHalfSweep;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i <= n; ++i) {
      double u = i, v = j;
      if (meshing.irregular && i > 0 && i < n && (turns() || (j > 0 && j < n))) {
        u += 0.5 * unitRandom(engine) - 0.25;
        v += 0.5 * unitRandom(engine) - 0.25;
      }
      const Eigen::Vector3d p = place(pointAt(curve_, u / n), start + sweep * v / n);
      soup.addVertex(p.x(), p.y(), p.z());
    }
  }
  addGrid(soup, {.columns = n + 1, .rows = rows, .closedRows = turns()});
  return soup;
}

double KnownRidges::distanceToRidge(const Eigen::Vector3d& p) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec2& mark : marks_) nearest = std::min(nearest, (onCurvePlane(p) - mark).norm());
  return nearest;
}

std::vector<Eigen::Vector3d> KnownRidges::samples(int perRidge) const {
  const double half = subject_ == KnownCase::SineSheet ? 3.0 : kHalfSweep;
  std::vector<Eigen::Vector3d> places;
  for (const Vec2& mark : marks_) {
    for (int i = 0; i < perRidge; ++i) {
      const double share = (i + 0.5) / perRidge;
      const double along =
          turns() ? 2.0 * kPi * share : half * (1.0 - 2.0 * kMargin) * (2.0 * share - 1.0);
      places.push_back(place(mark, along));
    }
  }
  return places;
}

}  // namespace flatland
