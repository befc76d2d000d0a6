// SPDX-License-Identifier: GPL-3.0-or-later
// Sections and predicted lines in drawings: what is hidden of them, against closed forms.
#include "core3d/study/drawn_segments.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "core3d/diff/estimate_fields.h"
#include "core3d/diff/exact_fields.h"
#include "core3d/draw/draughtsman.h"
#include "core3d/mesh/build_mesh.h"
#include "core3d/study/section.h"
#include "flatland/curve/formula_curve.h"
#include "tests/core3d/lines_check.h"

namespace flatland::test {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

double lengthOf(const Polyline& line) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    length += (line.points[i + 1] - line.points[i]).norm();
  }
  if (line.closed) length += (line.points.front() - line.points.back()).norm();
  return length;
}

Drawing drawn(const TriangleMesh& mesh, const SurfaceFields& fields, const Vector3d& towards,
              LineFamily family, std::vector<LineSegment> segments) {
  LineOptions lines;
  lines[family] = true;
  lines.unfiltered = true;
  StrokeOptions strokes;
  strokes.hidden = true;
  FeatureLines found;
  found.of(family) = std::move(segments);
  Camera camera;
  camera.towards = towards;
  return Draughtsman(mesh, fields).draw(projectionOf(camera, mesh), found, lines, strokes);
}

TEST(DrawnSections, OfAGreatCircleHalfIsSeen) {
  const SolidModel model = modelOf({SolidKind::Sphere, 1.0}, {.cells = 24, .irregular = true});
  const CutPlane plane = planeAcross(Vector3d::Zero(), {0.3, 1.0, 0.2}, Vector3d::UnitZ());
  const Slice slice = sliceMesh(model.mesh, plane);
  ASSERT_EQ(slice.lines.size(), 1u);
  const Vector3d towards = Vector3d(0.2, 0.5, 1.0).normalized();
  const std::vector<LineSegment> segments = segmentsOf(slice, model.mesh);
  for (const LineSegment& segment : segments) {
    // In the plane, and in the triangle that it names.
    const auto& corners = model.mesh.triangles[segment.triangle];
    const Eigen::Vector3f a = model.mesh.position(corners[0]);
    const Eigen::Vector3f n =
        (model.mesh.position(corners[1]) - a).cross(model.mesh.position(corners[2]) - a);
    for (const LineEnd& end : {segment.a, segment.b}) {
      EXPECT_NEAR(plane.height(model.mesh.origin + model.mesh.unit * end.at.cast<double>()), 0.0,
                  1e-6);
      EXPECT_NEAR(n.normalized().dot(end.at - a), 0.0f, 1e-5f);
    }
  }
  double seen = 0.0, hidden = 0.0;
  for (const Polyline& line :
       drawn(model.mesh, model.fields, towards, LineFamily::Topographic, segments).polylines) {
    (line.visible ? seen : hidden) += lengthOf(line);
    for (std::size_t i = 1; i + 1 < line.points.size(); ++i) {
      const double facing = line.points[i].cast<double>().normalized().dot(towards);
      // Beside the outline facets decide.
      if (std::abs(facing) > 0.1) {
        EXPECT_EQ(facing > 0.0, line.visible);
      }
    }
  }
  EXPECT_NEAR(seen, kPi, 0.05 * kPi);
  EXPECT_NEAR(hidden, kPi, 0.05 * kPi);
}

TEST(DrawnSections, LinesThatAreOpenStayOpen) {
  const SolidModel model = modelOf({SolidKind::SineSheet}, {.cells = 24});
  const CutPlane plane = planeAcross(model.mesh.origin, {1.0, 0.0, 0.3}, Vector3d::UnitY());
  const Slice slice = sliceMesh(model.mesh, plane);
  ASSERT_EQ(slice.lines.size(), 1u);
  ASSERT_FALSE(slice.lines[0].closed);
  const std::vector<LineSegment> segments = segmentsOf(slice, model.mesh);
  EXPECT_EQ(segments.size(), slice.lines[0].triangles.size());
  double length = 0.0;
  for (const LineSegment& segment : segments) length += (segment.b.at - segment.a.at).norm();
  EXPECT_NEAR(length, slice.lines[0].length() / model.mesh.unit, 1e-4 * length);
}

class DrawnPredictions : public testing::Test {
 protected:
  /// The ruling of an extrusion, or circle of a revolution, over t.
  static PredictedLine over(const SweptSurface& surface, double t) {
    PredictedLine line{MarkKind::ApparentRidge, t, pointAt(surface.curve, t), 0, 0, false, {}};
    const Vec2 p = line.mark;
    if (surface.kind == SweptSurface::Kind::Extrusion) {
      for (const double side : {-0.5, 0.5}) {
        line.points.emplace_back(p.x(), p.y(), side * surface.amount);
      }
      return line;
    }
    line.closed = true;
    for (int i = 0; i < 256; ++i) {
      const double angle = 2.0 * kPi * i / 256, radius = p.x() - surface.amount;
      line.points.emplace_back(surface.amount + radius * std::cos(angle), p.y(),
                               radius * std::sin(angle));
    }
    return line;
  }

  static Curve ellipse() {
    return *FormulaCurve::make(FamilyCurve{Family::Id::Ellipse, {1.0, 0.6}}).curve;
  }

  static SurfaceFields fieldsOf(const TriangleMesh& mesh) { return estimateFields(mesh, {}); }
};

// Seen across its rulings, a convex tube shows what faces the viewer and nothing else.
TEST_F(DrawnPredictions, RulingsOfAConvexTubeAreSeenWhereTheyFaceTheViewer) {
  const SweptSurface surface{ellipse(), SweptSurface::Kind::Extrusion, 1.5};
  const SweptMesh swept = sweptMesh(surface, 48);
  const TriangleMesh mesh = buildMesh(swept.soup).mesh;
  const SurfaceFields fields = fieldsOf(mesh);
  const double end = pieceCount(surface.curve);
  for (const double angle : {0.0, 1.0, 2.5}) {
    const Vector3d towards(std::cos(angle), std::sin(angle), 0.0);
    std::vector<LineSegment> segments;
    std::vector<double> facing;
    for (std::uint32_t i = 0; i < 60; ++i) {
      const double t = end * (i + 0.37) / 60.0;
      for (const LineSegment& segment : segmentsOf(over(surface, t), swept, mesh, i)) {
        segments.push_back(segment);
      }
      const Vec2 along = jetAt(surface.curve, t).d1.normalized();
      facing.push_back(Vec2(along.y(), -along.x()).dot(towards.head<2>()));
    }
    std::vector<double> length(60, 0.0);
    for (const Polyline& line :
         drawn(mesh, fields, towards, LineFamily::Isophotes, segments).polylines) {
      // Where the tube turns away within a cell, its facets decide.
      if (std::abs(facing[line.level]) > 0.15) {
        EXPECT_EQ(line.visible, facing[line.level] > 0.0) << facing[line.level];
      }
      length[line.level] += lengthOf(line);
    }
    for (const double each : length) EXPECT_NEAR(each, 1.5 / mesh.unit, 1e-3);
  }
}

TEST_F(DrawnPredictions, EachPieceIsAboveTheTriangleThatItNames) {
  const BezierChain wave(Bezier{{{0.2, 0}, {2, 0.5}, {-0.6, 1}, {1.5, 1.6}, {0.4, 2}}});
  for (const SweptSurface& surface :
       {SweptSurface{wave, SweptSurface::Kind::Extrusion, 1.0},
        SweptSurface{wave, SweptSurface::Kind::Revolution, -1.0},
        SweptSurface{ellipse(), SweptSurface::Kind::Revolution, -2.0}}) {
    const SweptMesh swept = sweptMesh(surface, 40);
    const TriangleMesh mesh = buildMesh(swept.soup).mesh;
    const double end = pieceCount(surface.curve);
    // At the joint of a closed curve too.
    for (const double t : {0.0, 0.001 * end, 0.3 * end, 0.5 * end, 0.77 * end, 0.9999 * end}) {
      const PredictedLine line = over(surface, t);
      const std::vector<LineSegment> segments = segmentsOf(line, swept, mesh);
      ASSERT_GT(segments.size(), 5u);
      EXPECT_EQ(segments.back().b.node == segments.front().a.node, line.closed);
      for (std::size_t i = 0; i < segments.size(); ++i) {
        const LineSegment& segment = segments[i];
        if (i > 0) {
          EXPECT_EQ(segment.a.node, segments[i - 1].b.node);
        }
        const Eigen::Vector3f p = 0.5f * (segment.a.at + segment.b.at);
        float nearest = 1e9f;
        for (const std::uint32_t v : mesh.triangles[segment.triangle]) {
          nearest = std::min(nearest, (mesh.position(v) - p).norm());
        }
        EXPECT_LT(nearest, 0.12f) << t;  // the longest edge of a cell
      }
    }
  }
}

}  // namespace
}  // namespace flatland::test
