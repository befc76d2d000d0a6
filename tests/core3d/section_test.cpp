// SPDX-License-Identifier: GPL-3.0-or-later
// Sections as flatland curves beside the surface's own apparent ridges.
#include "core3d/study/section.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "flatland/features/orientation.h"
#include "tests/core3d/lines_check.h"

namespace flatland::test {
namespace {

using Eigen::Vector3d;

// The bump's ridge is a circle of radius 2.004241986613 when seen along its axis, where a plane
// through the axis holds t_A.
constexpr double kRidgeOfBump = 2.004241986613;

TEST(Section, ThroughTheAxisOfABumpHoldsTheDirectionOfTheRidge) {
  const SolidModel bump =
      modelOf({SolidKind::GaussianBump, 2.0, 4.0}, {.cells = 150, .irregular = true});
  const SurfaceView view{.towards = Vector3d::UnitZ(), .eye = {}};
  const CutPlane plane = planeAcross({0, 0.003, 0}, Vector3d(0.3, 1, 0), view.towards);
  EXPECT_TRUE(plane.up.isApprox(view.towards, 1e-12));
  const Section section = sectionOf(bump.mesh, plane, 2e-3);
  ASSERT_EQ(section.scene.curves.size(), 1u);
  EXPECT_LE(section.maxDeviation, 2e-3);
  // Up is outside on a sheet, and so it is to flatland.
  const ViewFrame frame = frameOf(section.scene.view);
  EXPECT_EQ(normalSide(section.scene.curves[0], frame), 1);
  LineOptions options = only({LineFamily::ApparentRidges});
  const auto ridges =
      LineFinder(bump.mesh, bump.fields).find(view, options).of(LineFamily::ApparentRidges);
  const SectionMarks compared = compareSection(section, bump.mesh, bump.fields, view, ridges);
  ASSERT_EQ(compared.ridges.size(), 2u);
  for (const CrossedRidge& ridge : compared.ridges) {
    EXPECT_NEAR(ridge.at.head<2>().norm(), kRidgeOfBump, 0.01);
    ASSERT_TRUE(ridge.offPlaneDeg && ridge.toMark);
    EXPECT_LT(*ridge.offPlaneDeg, 3.0);
    EXPECT_LT(*ridge.toMark, 0.1);
  }
}

TEST(Section, TellsByHowMuchTheDirectionLeavesThePlane) {
  const SolidModel sheet =
      modelOf({SolidKind::SineSheet, 0.5, 2.0, 3.0}, {.cells = 60, .irregular = false});
  const SurfaceView view{.towards = Vector3d::UnitZ(), .eye = {}};
  // Seen from above t_A is along x throughout; the plane is turned from it by a known angle.
  for (const double degrees : {0.0, 20.0, 75.0}) {
    const double a = degrees * std::acos(-1.0) / 180.0;
    const CutPlane plane = planeAlong({0.1, 0.05, 0}, {std::cos(a), std::sin(a), 0}, view.towards);
    const Slice slice = sliceMesh(sheet.mesh, plane);
    ASSERT_FALSE(slice.lines.empty());
    const std::uint32_t triangle = slice.lines[0].triangles[slice.lines[0].triangles.size() / 3];
    const auto off = offPlaneDeg(sheet.mesh, sheet.fields, view, plane, triangle);
    ASSERT_TRUE(off);
    EXPECT_NEAR(*off, degrees, 0.5);
  }
}

TEST(Section, TheDirectionHasNoSign) {
  // t_A points away from the axis, so it differs from corner to corner.
  const SolidModel bump =
      modelOf({SolidKind::GaussianBump, 2.0, 4.0}, {.cells = 60, .irregular = true});
  const SurfaceView view{.towards = Vector3d::UnitZ(), .eye = {}};
  const CutPlane plane = planeAcross({0, 0.5, 0}, Vector3d::UnitY(), view.towards);
  const SliceLine line = sliceMesh(bump.mesh, plane).lines.at(0);
  std::size_t at = 0;
  while (at + 1 < line.triangles.size() && line.points[at].at.head<2>().norm() > kRidgeOfBump) ++at;
  const std::uint32_t triangle = line.triangles[at];
  const auto before = offPlaneDeg(bump.mesh, bump.fields, view, plane, triangle);
  ASSERT_TRUE(before);
  EXPECT_NEAR(*before, std::asin(0.5 / kRidgeOfBump) * 180.0 / std::acos(-1.0), 3.0);
  // One corner after the other with its frame turned half round: the same surface.
  for (const std::uint32_t v : bump.mesh.triangles[triangle]) {
    SurfaceFields turned = bump.fields;
    SurfacePoint point = turned.at(bump.mesh, v);
    point.frame = -point.frame;
    for (double& c : point.C.coefficients) c = -c;
    turned.set(v, point);
    const auto after = offPlaneDeg(bump.mesh, turned, view, plane, triangle);
    ASSERT_TRUE(after);
    EXPECT_NEAR(*after, *before, 1e-3);
  }
}

TEST(Section, AMarkIsJudgedWhereItLies) {
  const SolidModel bump =
      modelOf({SolidKind::GaussianBump, 2.0, 4.0}, {.cells = 150, .irregular = true});
  const SurfaceView view{.towards = Vector3d::UnitZ(), .eye = {}};
  constexpr double kBeside = 0.5;
  const CutPlane plane = planeAcross({0, kBeside, 0}, Vector3d::UnitY(), view.towards);
  const Section section = sectionOf(bump.mesh, plane, 2e-3);
  const SectionMarks compared = compareSection(section, bump.mesh, bump.fields, view, {});
  int checked = 0;
  for (const SectionMark& mark : compared.marks) {
    const double radius = mark.at.head<2>().norm();
    if (mark.mark.kind != MarkKind::ApparentRidge || std::abs(radius - kRidgeOfBump) > 0.3)
      continue;
    // t_A points away from the axis.
    ASSERT_TRUE(mark.offPlaneDeg);
    EXPECT_NEAR(*mark.offPlaneDeg, std::asin(kBeside / radius) * 180.0 / std::acos(-1.0), 2.0);
    ++checked;
  }
  EXPECT_EQ(checked, 2);
}

TEST(Section, AlongTheRidgeAtAPickedPlace) {
  const SolidModel sheet =
      modelOf({SolidKind::SineSheet, 0.5, 2.0, 3.0}, {.cells = 60, .irregular = false});
  const SurfaceView view{.towards = Vector3d(0.5, 0, 1).normalized(), .eye = {}};
  const auto plane = planeAlongRidge(sheet.mesh, sheet.fields, view, {0.7, 0.4, 0.5});
  ASSERT_TRUE(plane);
  // View and bending lie in the plane of x and z.
  EXPECT_NEAR(std::abs(plane->normal.y()), 1.0, 1e-4);
  EXPECT_NEAR(plane->normal.dot(view.towards), 0.0, 1e-9);
  // Without curvature there is none.
  SurfaceFields none = sheet.fields;
  for (auto* k : {&none.k1, &none.k2}) std::fill(k->begin(), k->end(), 0.0f);
  EXPECT_FALSE(planeAlongRidge(sheet.mesh, none, view, {0.7, 0.4, 0.5}));
}

}  // namespace
}  // namespace flatland::test
