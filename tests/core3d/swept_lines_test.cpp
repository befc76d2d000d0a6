// SPDX-License-Identifier: GPL-3.0-or-later
// The bridges of docs/math/lines.md: apparent ridges of extrusions and revolutions of random curves
// lie over the marks that flatland finds with proof.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "core3d/mesh/swept.h"
#include "flatland/features/features.h"
#include "flatland/features/terms.h"
#include "tests/core3d/lines_check.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

constexpr double kPi = std::numbers::pi;

// A gentle arch of degree 4: no cusps, no loops.
Curve randomArch(Random& random) {
  std::vector<Vec2> points;
  for (int i = 0; i < 5; ++i)
    points.emplace_back(1.0 + 0.5 * i + uniform(random, -0.2, 0.2), uniform(random, -1.0, 1.0));
  return BezierChain(4, false, points);
}

// Exact fields of a swept mesh: `pointOf` vertex, in the coordinates of the mesh.
template <typename PointOf>
SurfaceFields fieldsOf(const TriangleMesh& mesh, const PointOf& pointOf) {
  SurfaceFields fields;
  fields.resize(mesh.vertexCount());
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    SurfacePoint point = pointOf(v, mesh.positionInFile(v));
    point.K *= mesh.unit;
    for (double& c : point.C.coefficients) c *= mesh.unit * mesh.unit;
    fields.set(v, point);
  }
  fields.size = surfaceSize(mesh);
  return fields;
}

std::vector<Mark> ridgeMarks(const Curve& curve, double angleDeg) {
  std::vector<Mark> marks;
  const FeatureSet features =
      findFeatures(Scene{{SceneCurve{curve}}, View{.angleDeg = angleDeg, .distance = {}}});
  for (const Mark& mark : features.marks) {
    if (mark.kind == MarkKind::ApparentRidge) marks.push_back(mark);
  }
  return marks;
}

// n.w of the surface, whose normal is to the left of the curve.
double facing(const Curve& curve, double t, const Vec2& w) {
  const Vec2 d = jetAt(curve, t).d1.normalized();
  return Vec2(-d.y(), d.x()).dot(w);
}

// sqrt(lambda) falls by a tenth on both sides within a fifth of the size: a line that has to be
// drawn.
bool isPlain(const Curve& curve, const Mark& mark, double angleDeg, double size) {
  const ViewFrame frame = frameOf(View{.angleDeg = angleDeg, .distance = {}});
  const auto root = [&](double t) { return std::sqrt(*termsAt(jetAt(curve, t), frame, 1).lambda); };
  const double top = root(mark.t);
  for (const double sign : {-1.0, 1.0}) {
    double t = mark.t, low = top;
    const Vec2 from = pointAt(curve, mark.t);
    while ((pointAt(curve, t) - from).norm() < 0.2 * size) {
      t += 0.002 * sign;
      if (t < 0.02 || t > 0.98) return false;
      low = std::min(low, root(t));
      if (root(t) > 1.01 * top) return false;
    }
    if (low > 0.9 * top) return false;
  }
  return true;
}

TEST(SweptLines, ExtrusionsHaveTheirRidgesOverTheCurvesMarks) {
  Random random(announcedSeed("extruded", 51));
  constexpr int kSamples = 200;
  int drawn = 0;
  for (int i = 0; i < 25; ++i) {
    const Curve curve = randomArch(random);
    const SweptMesh swept = extrude(curve, 2.0, {.samplesPerPiece = kSamples, .layers = 40});
    const TriangleMesh mesh = buildMesh(swept.soup).mesh;
    const SurfaceFields fields = fieldsOf(mesh, [&](std::uint32_t v, const Eigen::Vector3d& p) {
      return extrudedPoint(curve, swept.parameters[mesh.fileVertex[v]], p.z());
    });
    const double angleDeg = uniform(random, 40, 140);
    const Vec2 w(std::cos(angleDeg * kPi / 180), std::sin(angleDeg * kPi / 180));
    // From above the plane too: what counts is the projection.
    const Eigen::Vector3d towards =
        Eigen::Vector3d(w.x(), w.y(), uniform(random, -1, 1)).normalized();
    LineOptions options = only({LineFamily::ApparentRidges});
    options.threshold.fill(0.0);
    const auto ridges = LineFinder(mesh, fields)
                            .find({.towards = towards, .eye = {}}, options)
                            .of(LineFamily::ApparentRidges);
    const auto marks = ridgeMarks(curve, angleDeg);
    double edge = 0.0;
    for (int s = 0; s < kSamples; ++s) {
      edge = std::max(
          edge, (pointAt(curve, (s + 1.0) / kSamples) - pointAt(curve, 1.0 * s / kSamples)).norm());
    }
    std::vector<double> length(marks.size(), 0.0);
    for (const LineSegment& segment : ridges) {
      const Vec2 p = middleInFile(mesh, segment).head<2>();
      double least = 100.0;
      std::size_t nearest = 0;
      for (std::size_t m = 0; m < marks.size(); ++m) {
        const double distance = (marks[m].point - p).norm();
        if (distance < least) least = distance, nearest = m;
      }
      ASSERT_LT(least, 0.5 * edge) << "a ridge over no mark, curve " << i;
      length[nearest] += lengthInFile(mesh, segment);
    }
    for (std::size_t m = 0; m < marks.size(); ++m) {
      if (facing(curve, marks[m].t, w) < 0.1 ||
          !isPlain(curve, marks[m], angleDeg, fields.size * mesh.unit))
        continue;
      ++drawn;
      EXPECT_NEAR(length[m], 2.0, 0.1) << "a mark without its ridge, curve " << i;
    }
  }
  EXPECT_GT(drawn, 8);
}

TEST(SweptLines, RevolutionsHaveCirclesThroughTheProfilesMarks) {
  Random random(announcedSeed("revolved", 52));
  constexpr int kSamples = 200;
  int drawn = 0;
  for (int i = 0; i < 12; ++i) {
    const Curve curve = randomArch(random);
    const SweptMesh swept = revolve(curve, 0.0, {.samplesPerPiece = kSamples, .layers = 128});
    const TriangleMesh mesh = buildMesh(swept.soup).mesh;
    const SurfaceFields fields = fieldsOf(mesh, [&](std::uint32_t v, const Eigen::Vector3d& p) {
      return revolvedPoint(curve, 0.0, swept.parameters[mesh.fileVertex[v]],
                           std::atan2(p.z(), p.x()));
    });
    LineOptions options = only({LineFamily::ApparentRidges});
    options.threshold.fill(0.0);
    const auto ridges = LineFinder(mesh, fields)
                            .find({.towards = Eigen::Vector3d::UnitY(), .eye = {}}, options)
                            .of(LineFamily::ApparentRidges);
    const auto marks = ridgeMarks(curve, 90.0);
    std::vector<double> length(marks.size(), 0.0);
    double stray = 0.0;
    for (const LineSegment& segment : ridges) {
      const Eigen::Vector3d p = middleInFile(mesh, segment);
      const Vec2 inProfile(std::hypot(p.x(), p.z()), p.y());
      bool found = false;
      for (std::size_t m = 0; m < marks.size(); ++m) {
        if ((marks[m].point - inProfile).norm() > 0.03) continue;
        length[m] += lengthInFile(mesh, segment);
        found = true;
      }
      if (!found) stray += lengthInFile(mesh, segment);
    }
    EXPECT_LT(stray, 0.1) << "ridges over no mark, profile " << i;
    for (std::size_t m = 0; m < marks.size(); ++m) {
      // Where the meridian clearly wins the eigenvalue.
      const double parallel =
          std::pow(jetAt(curve, marks[m].t).d1.normalized().y() / marks[m].point.x(), 2);
      if (facing(curve, marks[m].t, Vec2::UnitY()) < 0.1 || *marks[m].lambda < 2.0 * parallel ||
          !isPlain(curve, marks[m], 90.0, fields.size * mesh.unit))
        continue;
      ++drawn;
      EXPECT_NEAR(length[m], 2 * kPi * marks[m].point.x(), 0.03 * 2 * kPi * marks[m].point.x())
          << "a mark without its circle, profile " << i;
    }
  }
  EXPECT_GT(drawn, 3);
}

}  // namespace
}  // namespace flatland::test
