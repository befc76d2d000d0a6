// SPDX-License-Identifier: GPL-3.0-or-later
// Apparent ridges on meshes against exact loci, from exact fields.
#include <gtest/gtest.h>

#include <numbers>

#include "core3d/lines/families.h"
#include "tests/core3d/lines_check.h"

namespace flatland::test {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<LineSegment> ridgesOf(const SolidModel& model, const Eigen::Vector3d& towards,
                                  double threshold,
                                  RidgeDerivative derivative = RidgeDerivative::ClosedForm) {
  LineOptions options = only({LineFamily::ApparentRidges});
  options.derivative = derivative;
  options.threshold[static_cast<std::size_t>(LineFamily::ApparentRidges)] = threshold;
  const FeatureLines lines =
      LineFinder(model.mesh, model.fields).find({.towards = towards, .eye = {}}, options);
  expectFinite(lines);
  return lines.of(LineFamily::ApparentRidges);
}

// z = sin(2x) / 2 seen from 30 degrees has its apparent ridges over the roots of the flatland
// equation (docs/math/lines.md); the sheet's middle four are all there are.
double fromSheetRidges(const Eigen::Vector3d& p) {
  double least = 10.0;
  for (const double x : {0.67229729362, kPi - 0.67229729362}) {
    for (const double ridge : {x, -x}) least = std::min(least, std::abs(p.x() - ridge));
  }
  return least;
}

// log2 of how much nearer the median comes with each halving of the cells.
double orderOf(double coarse, double fine, int halvings) {
  return std::log2(coarse / fine) / halvings;
}

TEST(ApparentRidges, OfASineSheetConvergeWithNothingBesideThem) {
  const Eigen::Vector3d towards(std::sin(kPi / 6), 0, std::cos(kPi / 6));
  double first = 0.0, last = 0.0;
  for (const int n : {50, 100, 200}) {
    SCOPED_TRACE(n);
    const double edge = 6.0 / n;
    const SolidModel model =
        modelOf({SolidKind::SineSheet, 0.5, 2.0, 3.0}, {.cells = n, .irregular = true});
    // No threshold: strength alone has to keep noise away.
    const auto ridges = ridgesOf(model, towards, 0.0);
    const auto distances = distancesOf(model.mesh, ridges, fromSheetRidges);
    ASSERT_FALSE(distances.empty());
    last = median(distances);
    if (n == 50) first = last;
    EXPECT_LT(last, 0.02 * edge);
    EXPECT_LT(distances.back(), 0.2 * edge);
    EXPECT_NEAR(totalLength(model.mesh, ridges), 4 * 6.0, 0.05 * 4 * 6.0);
  }
  EXPECT_GT(orderOf(first, last, 2), 1.7);
}

// Difference quotients are good on even cells: the same lines, though only within a third of a
// cell, and nothing beside them, also where the sheet is seen at a grazing angle.
TEST(ApparentRidges, OfASineSheetByDifferencesAreTheSame) {
  for (const int n : {60, 120}) {
    SCOPED_TRACE(n);
    const double edge = 6.0 / n;
    const SolidModel model = modelOf({SolidKind::SineSheet, 0.5, 2.0, 3.0}, {.cells = n});
    for (const double degrees : {10.0, 20.0, 30.0}) {
      SCOPED_TRACE(degrees);
      const double angle = degrees * kPi / 180;
      const Eigen::Vector3d towards(std::sin(angle), 0, std::cos(angle));
      const auto exact = ridgesOf(model, towards, 0.0);
      const auto found = ridgesOf(model, towards, 0.0, RidgeDerivative::OneRing);
      // Lines are straight along y.
      std::vector<double> places;
      for (const LineSegment& segment : exact)
        places.push_back(middleInFile(model.mesh, segment).x());
      ASSERT_FALSE(places.empty());
      const auto distances = distancesOf(model.mesh, found, [&](const Eigen::Vector3d& p) {
        double least = 10.0;
        for (const double x : places) least = std::min(least, std::abs(p.x() - x));
        return least;
      });
      ASSERT_FALSE(distances.empty());
      EXPECT_LT(median(distances), 0.1 * edge);
      EXPECT_LT(distances.back(), edge);
      EXPECT_NEAR(totalLength(model.mesh, found), totalLength(model.mesh, exact),
                  0.05 * totalLength(model.mesh, exact));
    }
  }
}

// The difference quotient is per length on the surface, the closed form is multiplied with |r| and
// powers of n.w (seen_vertices.h).
TEST(ApparentRidges, DifferencesOfTheOneRingAreHalfTheDerivativePerLength) {
  const SolidModel model = modelOf({SolidKind::SineSheet, 0.5, 2.0, 3.0}, {.cells = 200});
  const SurfaceView view{.towards = {std::sin(kPi / 6), 0, std::cos(kPi / 6)}, .eye = {}};
  const VertexNeeds needs{.ridges = true, .everywhere = true};
  const VertexRun all{0, static_cast<std::uint32_t>(model.mesh.vertexCount()), true, true, false};
  SeenVertices closed;
  closed.resize(model.mesh.vertexCount(), needs);
  seeVertices(model.mesh, model.fields, view, needs.minRoot, {&all, 1}, closed);
  SeenVertices differences = closed;
  takeOneRingDerivative(model.mesh, model.fields, differences);
  std::vector<double> off;
  for (std::uint32_t v = 0; v < model.mesh.vertexCount(); ++v) {
    const float nw = std::abs(closed.nw[v]), r = closed.r(v).norm();
    if (nw < 0.2f || !(r > 0.0f)) continue;
    const double exact = closed.slope[v] / (nw * nw * nw * r);
    const double sign = closed.r(v).dot(differences.r(v)) > 0.0f ? 1.0 : -1.0;
    if (exact > 1.0) off.push_back(std::abs(sign * differences.slope[v] / exact - 1.0));
  }
  ASSERT_GT(off.size(), 1000u);
  std::sort(off.begin(), off.end());
  EXPECT_LT(median(off), 0.02);
}

TEST(ApparentRidges, OfAGaussianBumpAreItsRing) {
  constexpr double kRing = 2.004241986613;
  double first = 0.0, last = 0.0;
  for (const int n : {50, 100, 200}) {
    SCOPED_TRACE(n);
    const double edge = 8.0 / n;
    const SolidModel model =
        modelOf({SolidKind::GaussianBump, 2.0, 4.0}, {.cells = n, .irregular = true});
    const auto ridges = ridgesOf(model, Eigen::Vector3d::UnitZ(), 1.0);
    const auto distances = distancesOf(model.mesh, ridges, [](const Eigen::Vector3d& p) {
      return std::abs(p.head<2>().norm() - kRing);
    });
    ASSERT_FALSE(distances.empty());
    last = median(distances);
    if (n == 50) first = last;
    EXPECT_LT(last, 0.02 * edge);
    EXPECT_LT(distances.back(), edge);
    EXPECT_NEAR(totalLength(model.mesh, ridges), 2 * kPi * kRing, 0.02 * 2 * kPi * kRing);
  }
  EXPECT_GT(orderOf(first, last, 2), 1.7);
}

TEST(ApparentRidges, ASphereHasNone) {
  const Eigen::Vector3d towards = Eigen::Vector3d(1, 2, 3).normalized();
  const Solid sphere{SolidKind::Sphere, 2.0};
  EXPECT_TRUE(ridgesOf(modelOf(sphere, {.cells = 30, .irregular = true}), towards, 0.0).empty());
  // Where three sides of the cube meet, moved vertices can fold the surface: that is a crease.
  const SolidModel model = modelOf(sphere, {.cells = 30});
  LineOptions options;
  for (const LineFamily family : allLineFamilies()) options[family] = true;
  for (const LineFamily family :
       {LineFamily::Isophotes, LineFamily::Topographic, LineFamily::ExteriorSilhouette})
    options[family] = false;
  const FeatureLines lines =
      LineFinder(model.mesh, model.fields).find({.towards = towards, .eye = {}}, options);
  expectFinite(lines);
  for (const LineFamily family : allLineFamilies()) {
    if (family == LineFamily::OccludingContours) continue;
    EXPECT_TRUE(lines.of(family).empty()) << nameOf(family);
  }
  EXPECT_NEAR(totalLength(model.mesh, lines.of(LineFamily::OccludingContours)), 4 * kPi, 0.01);
}

}  // namespace
}  // namespace flatland::test
