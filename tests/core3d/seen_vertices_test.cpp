// SPDX-License-Identifier: GPL-3.0-or-later
// The SIMD kernel of a view against the double reference, flatland/view/apparent_curvature.h.
#include "core3d/lines/seen_vertices.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core3d/diff/exact_fields.h"
#include "core3d/diff/surface_jet.h"
#include "core3d/lines/families.h"
#include "core3d/lines/vertex_clusters.h"
#include "core3d/mesh/build_mesh.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

// Of float (6e-8), a few dozen operations and the cancellation between the terms, which are
// measured against their size.
constexpr double kTolerance = 2e-5;

struct Cloud {
  TriangleMesh mesh;
  SurfaceFields fields;
  std::uint32_t count() const { return static_cast<std::uint32_t>(mesh.vertexCount()); }
};

void add(Cloud& cloud, const Eigen::Vector3d& p, const SurfacePoint& point) {
  cloud.mesh.x.push_back(static_cast<float>(p.x()));
  cloud.mesh.y.push_back(static_cast<float>(p.y()));
  cloud.mesh.z.push_back(static_cast<float>(p.z()));
  const std::uint32_t v = cloud.count() - 1;
  cloud.fields.resize(v + 1);
  cloud.fields.set(v, point);
}

SurfacePoint randomPoint(Random& random) {
  SurfacePoint point;
  point.p.setZero();
  point.n = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
  point.frame.col(0) = point.n.unitOrthogonal();
  point.frame.col(1) = point.n.cross(Eigen::Vector3d(point.frame.col(0)));
  const double scale = std::pow(10.0, uniform(random, -3, 3));
  const double a = scale * normal(random), b = scale * normal(random), c = scale * normal(random);
  point.K << a, b, b, c;
  for (double& x : point.C.coefficients) x = scale * scale * normal(random);
  return point;
}

SeenVertices seen(const Cloud& cloud, const SurfaceView& view, float minRoot = -1.0f) {
  SeenVertices out;
  out.resize(cloud.count(), {.ridges = true, .radial = true});
  const VertexRun run{0, cloud.count(), true, true, true};
  seeVertices(cloud.mesh, cloud.fields, view, minRoot, {&run, 1}, out);
  return out;
}

// Everything of vertex v against the reference.
void expectAsReference(const Cloud& cloud, const SurfaceView& view, const SeenVertices& out,
                       std::uint32_t v) {
  SCOPED_TRACE(v);
  const SurfacePoint point = cloud.fields.at(cloud.mesh, v);
  const Eigen::Vector3d w = view.towardsViewer(point.p);
  const SeenPoint<2> at = seenFrom(point, w, view.distanceTo(point.p));
  const double k = std::max(std::abs(at.K(0, 0)), std::abs(at.K(1, 1)));
  EXPECT_NEAR(out.nw[v], at.nw, 1e-6);
  EXPECT_NEAR(out.radial[v], at.wT.dot(at.K * at.wT), kTolerance * k);
  if (std::abs(at.nw) > 1e-6) {
    EXPECT_EQ((out.flags[v] & VertexFlag::kFront) != 0, at.nw > 0);
  }
  const auto reference = apparentCurvature(at);
  ASSERT_TRUE(reference);
  const double nw = std::abs(at.nw);
  EXPECT_NEAR(out.root[v], nw * std::sqrt(reference->lambda), kTolerance * k);
  if (reference->relativeGap < 0.02 || nw < 0.02) return;  // the direction is not known that well
  const double fourth = std::pow(nw, 4);
  const double terms =
      std::abs(reference->feature) + std::abs(reference->offset) + std::abs(reference->perspective);
  const double slack = kTolerance * fourth * terms / (reference->relativeGap * nw);
  EXPECT_NEAR(out.slope[v], fourth * std::abs(reference->sum()), slack);
  if (std::abs(reference->sum()) * fourth < 3 * slack) return;  // nor is its sign
  const Eigen::Vector3d r = (point.frame * reference->r) * (reference->sum() > 0 ? nw : -nw);
  EXPECT_LT((out.r(v).cast<double>() - r).norm(),
            kTolerance * r.norm() / (reference->relativeGap * nw));
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ((out.flags[v] & (1 << i)) != 0, out.r(v)[i] > 0.0f);
  }
}

TEST(SeenVertices, AgreeWithTheDoubleReference) {
  Random random(announcedSeed("seen", 41));
  for (const bool perspective : {false, true}) {
    // Lengths that are no multiple of a vector's, and shorter than one.
    for (const int count : {1, 3, 7, 19, 1000, 2003}) {
      Cloud cloud;
      for (int i = 0; i < count; ++i) {
        add(cloud, {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)},
            randomPoint(random));
      }
      SurfaceView view{.towards = Eigen::Vector3d(1, 2, 3).normalized(), .eye = {}};
      if (perspective) view.eye = Eigen::Vector3d(0.7, 1.1, 1.9);
      const SeenVertices out = seen(cloud, view);
      for (std::uint32_t v = 0; v < cloud.count(); ++v) expectAsReference(cloud, view, out, v);
    }
  }
}

TEST(SeenVertices, PerspectiveTermCounts) {
  // A near viewer and a far one in the same direction differ by the perspective term alone.
  Cloud cloud;
  SurfacePoint point;
  point.p.setZero();
  point.n = {0, 0, 1};
  point.frame << 1, 0, 0, 1, 0, 0;
  point.K << 1, 0, 0, 1;
  point.C.coefficients = {0, 0, 0, 0};
  add(cloud, {0, 0, 0}, point);
  const Eigen::Vector3d w = Eigen::Vector3d(0.6, 0, 0.8);
  const SurfaceView far{.towards = w, .eye = {}}, near{.towards = w, .eye = 2.0 * w};
  const auto reference = apparentCurvature(seenFrom(point, w, 2.0));
  ASSERT_TRUE(reference);
  // Of the sum along the reference's r: SeenVertices turns r so that lambda grows.
  const auto along = [&](const SurfaceView& view) {
    const SeenVertices out = seen(cloud, view);
    return std::copysign(out.slope[0], out.r(0).cast<double>().dot(point.frame * reference->r));
  };
  EXPECT_GT(std::abs(reference->perspective), 0.1);
  EXPECT_NEAR(along(near) - along(far), std::pow(0.8, 4) * reference->perspective, 1e-5);
  EXPECT_NEAR(along(far), std::pow(0.8, 4) * reference->offset, 1e-5);
}

// Finite differences of n.w on a torus along the direction of the larger curvature, the viewer near
// and far. Inside the ring that curvature is negative, and nearness can turn the sign round.
TEST(SeenVertices, HighlightsHaveTheDerivativeOfNw) {
  const Solid torus{SolidKind::Torus, 1.0, 0.7};
  const auto onTorus = [&torus](const Eigen::Vector3d& p) {
    return pointAt(torus,
                   {std::atan2(p.y(), p.x()), std::atan2(p.z(), p.head<2>().norm() - torus.a), 0});
  };
  const SolidMesh made = meshOf(torus, {.cells = 30, .irregular = true});
  const TriangleMesh mesh = buildMesh(made.soup).mesh;
  const SurfaceFields fields = exactFields(torus, made.places, mesh);
  const Eigen::Vector3d w = Eigen::Vector3d(0.3, -0.6, 0.74).normalized();
  for (const double distance : {0.0, 0.1, 1.5}) {  // 0: from afar; 0.1: inside the ring
    SCOPED_TRACE(distance);
    SurfaceView view{.towards = w, .eye = {}};
    if (distance > 0.0) view.eye = distance * w;
    SeenVertices seen;
    seeHighlights(mesh, fields, view, seen);
    for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
      const bool second = std::abs(fields.k2[v]) > std::abs(fields.k1[v]);
      const Eigen::Vector3d e = (second ? fields.e2(v) : fields.e1(v)).cast<double>();
      constexpr double kStep = 1e-4;
      const auto facing = [&](double step) {
        const SurfacePoint point =
            onTorus(mesh.origin + mesh.unit * mesh.position(v).cast<double>() + step * e);
        return point.n.dot(view.towardsViewer((point.p - mesh.origin) / mesh.unit));
      };
      const double expected = mesh.unit * (facing(kStep) - facing(-kStep)) / (2 * kStep);
      EXPECT_NEAR(seen.slope[v] * seen.r(v).cast<double>().dot(e), expected, 2e-3);
    }
  }
}

TEST(SeenVertices, DegenerateVerticesHaveStatedAnswers) {
  Random random(announcedSeed("degenerate", 42));
  SurfacePoint unknown{};
  unknown.p.setZero();
  unknown.n.setZero();
  unknown.frame.setZero();
  unknown.K.setZero();
  unknown.C.coefficients = {0, 0, 0, 0};
  SurfacePoint flat = randomPoint(random);
  flat.K.setZero();
  SurfacePoint umbilic = randomPoint(random);
  umbilic.K = Eigen::Matrix2d::Identity() * 3.0;
  SurfacePoint edgeOn = randomPoint(random);
  edgeOn.n = Eigen::Vector3d::UnitX();
  edgeOn.frame.col(0) = Eigen::Vector3d::UnitY();
  edgeOn.frame.col(1) = Eigen::Vector3d::UnitZ();
  SurfacePoint huge = randomPoint(random);
  huge.K *= 1e15;
  for (double& c : huge.C.coefficients) c = 1e30;
  Cloud cloud;
  for (const SurfacePoint& point : {unknown, flat, umbilic, edgeOn, huge})
    add(cloud, point.p, point);
  const SurfaceView straight{.towards = Eigen::Vector3d::UnitZ(), .eye = {}};
  const SurfaceView atVertex{.towards = Eigen::Vector3d::UnitZ(), .eye = Eigen::Vector3d::Zero()};
  for (const SurfaceView& view : {straight, atVertex}) {
    const SeenVertices out = seen(cloud, view);
    for (std::uint32_t v = 0; v < cloud.count(); ++v) {
      EXPECT_TRUE(std::isfinite(out.nw[v]) && std::isfinite(out.root[v]) &&
                  std::isfinite(out.slope[v]) && out.r(v).allFinite() &&
                  std::isfinite(out.radial[v]))
          << v;
    }
    EXPECT_EQ(out.flags[0] & (VertexFlag::kKnown | VertexFlag::kFront), 0);
    EXPECT_EQ(out.root[1], 0.0f);
    EXPECT_EQ(out.slope[1], 0.0f);
    EXPECT_EQ(out.root[4], 0.0f);
  }
  const SeenVertices out = seen(cloud, straight);
  EXPECT_EQ(out.nw[3], 0.0f);
  // At a silhouette K w_T is left of it, along w.
  const SurfacePoint side = cloud.fields.at(cloud.mesh, 3);
  const Eigen::Vector2d wT = side.frame.transpose() * straight.towards;
  EXPECT_NEAR(out.root[3], (side.K * wT).norm(), 1e-4 * side.K.norm());
  expectAsReference(cloud, straight, out, 2);
}

// Head on, radial curvature is 0 whatever the surface: it takes the sign of the curvatures, so that
// a convex vertex and the convex clusters beside it, which are passed over, do not differ.
TEST(SeenVertices, RadialCurvatureHeadOnIsPositiveOnAConvexSurface) {
  Cloud cloud;
  for (const auto& [k1, k2] : {std::pair(2.0, 1.0), {1.0, -1.0}, {-1.0, -2.0}, {1.0, 0.0}}) {
    SurfacePoint point;
    point.p.setZero();
    point.n = Eigen::Vector3d::UnitZ();
    point.frame << 1, 0, 0, 1, 0, 0;
    point.K << k1, 0.0, 0.0, k2;
    point.C.coefficients = {1, 1, 1, 1};
    add(cloud, point.p, point);
  }
  const SeenVertices out = seen(cloud, {.towards = Eigen::Vector3d::UnitZ(), .eye = {}});
  EXPECT_GT(out.radial[0], 0.0f);
  EXPECT_LT(out.radial[0], 1e-30f);
  for (const std::uint32_t v : {1u, 2u, 3u}) EXPECT_EQ(out.radial[v], 0.0f);
  for (const std::uint32_t v : {0u, 1u, 2u, 3u}) {
    EXPECT_EQ((out.flags[v] & VertexFlag::kRadial) != 0, out.radial[v] > 0.0f) << v;
  }
}

TEST(SeenVertices, StrongMeansThatTheBoundIsReached) {
  Random random(announcedSeed("strong", 43));
  Cloud cloud;
  for (int i = 0; i < 500; ++i) add(cloud, Eigen::Vector3d::Zero(), randomPoint(random));
  const SurfaceView view{.towards = Eigen::Vector3d::UnitZ(), .eye = {}};
  const SeenVertices out = seen(cloud, view, 2.0f);
  int strong = 0;
  for (std::uint32_t v = 0; v < cloud.count(); ++v) {
    const bool flagged = (out.flags[v] & VertexFlag::kStrong) != 0;
    strong += flagged;
    const float root = out.root[v] / std::abs(out.nw[v]);
    if (std::abs(root - 2.0f) > 1e-4f) {
      EXPECT_EQ(flagged, root >= 2.0f) << v;
    }
  }
  EXPECT_GT(strong, 50);
  EXPECT_LT(strong, 450);
}

}  // namespace
}  // namespace flatland::test
