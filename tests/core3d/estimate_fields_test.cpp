// SPDX-License-Identifier: GPL-3.0-or-later
#include "core3d/diff/estimate_fields.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numbers>
#include <string>

#include "core3d/diff/exact_fields.h"
#include "core3d/diff/local_fit.h"
#include "core3d/diff/one_ring.h"
#include "core3d/mesh/build_mesh.h"
#include "flatland/io/input_error.h"
#include "tests/core3d/fields_check.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

void expectFinite(const SurfaceFields& fields) {
  int bad = 0;
  for (const auto* values : arraysOf(fields))
    for (const float value : *values) bad += std::isfinite(value) ? 0 : 1;
  EXPECT_EQ(bad, 0);
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// How far two points of a surface are from each other as tensors, in the frame of the second.
struct Difference {
  double n, K, C;
};
Difference differenceOf(const SurfacePoint& p, const SurfacePoint& q) {
  const Eigen::Matrix2d turn = p.frame.transpose() * q.frame;
  const Eigen::Vector2d a = turn.col(0), b = turn.col(1);
  const auto& c = q.C.coefficients;
  const double d[4] = {p.C(a, a, a) - c[0], p.C(a, a, b) - c[1], p.C(a, b, b) - c[2],
                       p.C(b, b, b) - c[3]};
  return {(p.n - q.n).norm(), (turn.transpose() * p.K * turn - q.K).norm(),
          std::sqrt(d[0] * d[0] + 3.0 * (d[1] * d[1] + d[2] * d[2]) + d[3] * d[3])};
}

struct Sample {
  SolidMesh made;
  TriangleMesh mesh;
  SurfaceFields exact;
};
Sample sampleOf(const Solid& solid, const Meshing& meshing) {
  Sample sample{meshOf(solid, meshing), {}, {}};
  sample.mesh = buildMesh(sample.made.soup).mesh;
  sample.exact = exactFields(solid, sample.made.places, sample.mesh);
  return sample;
}

// Median errors over the vertices that are not at a border.
Difference mediansOf(const Sample& sample, const SurfaceFields& fields) {
  std::vector<double> n, K, C;
  for (std::uint32_t v = 0; v < sample.mesh.vertexCount(); ++v) {
    if (sample.mesh.isAtEdge(v)) continue;
    const Difference d = differenceOf(fields.at(sample.mesh, v), sample.exact.at(sample.mesh, v));
    n.push_back(d.n);
    K.push_back(d.K);
    C.push_back(d.C);
  }
  return {medianOf(n), medianOf(K), medianOf(C)};
}

// Slope of log(error) against log(edge) over meshes that double; errors below the floor, where
// rounding of the positions takes over, end the series.
double orderOf(const std::vector<double>& errors, double floor) {
  std::size_t used = 1;
  while (used < errors.size() && errors[used - 1] > floor) ++used;
  if (used < 2) return 99.0;
  return std::log2(errors.front() / errors[used - 1]) / static_cast<double>(used - 1);
}

struct Orders {
  double n, K, C;
};
Orders ordersOf(const Solid& solid, FieldEstimator estimator, bool irregular) {
  const bool sheet = solid.kind == SolidKind::Saddle || solid.kind == SolidKind::SineSheet ||
                     solid.kind == SolidKind::GaussianBump;
  std::vector<double> n, K, C;
  for (const int cells : {1, 2, 4}) {
    const bool globe =
        !sheet && solid.kind != SolidKind::Cylinder && solid.kind != SolidKind::Torus;
    const Sample sample = sampleOf(solid, {(globe ? 14 : 28) * cells, irregular});
    const Difference d = mediansOf(sample, estimateFields(sample.mesh, with(estimator)));
    n.push_back(d.n);
    K.push_back(d.K);
    C.push_back(d.C);
  }
  // Positions of 6e-8: about that in an angle per edge of 0.02, that by the edge in K and so on.
  const Orders orders{orderOf(n, 5e-6), orderOf(K, 5e-4), orderOf(C, 2e-2)};
  testing::Test::RecordProperty(solid.name(), std::to_string(orders.K));
  return orders;
}

// A polynomial of degree 4 leaves errors of order 5 in the heights: 4 in n, 3 in K, 2 in C, one
// more in K by symmetry where vertices lie evenly. Asked for is less by a half
// to a whole, as the neighbourhoods change on the way.
TEST(EstimateFields, JetFitConvergesOnEverySolid) {
  for (const Solid& solid : standardSolids()) {
    for (const bool irregular : {false, true}) {
      SCOPED_TRACE(solid.name() + (irregular ? ", irregular" : ", regular"));
      const Orders orders = ordersOf(solid, FieldEstimator::JetFit, irregular);
      EXPECT_GE(orders.n, 3.0);
      EXPECT_GE(orders.K, 2.5);
      EXPECT_GE(orders.C, 1.5);
    }
  }
}

// What is known of the one-ring: second order in everything where vertices lie evenly; else first
// order in n, while K stays wrong by some percent and C grows like 1/edge.
TEST(EstimateFields, OneRingConvergesWhereVerticesLieEvenly) {
  for (const Solid& solid : standardSolids()) {
    SCOPED_TRACE(solid.name());
    const Orders even = ordersOf(solid, FieldEstimator::OneRing, false);
    EXPECT_GE(even.n, 1.7);
    EXPECT_GE(even.K, 1.5);
    EXPECT_GE(even.C, 1.0);
    const Orders uneven = ordersOf(solid, FieldEstimator::OneRing, true);
    EXPECT_GE(uneven.n, 0.8);
    EXPECT_GE(uneven.K, -0.1);
    EXPECT_GE(uneven.C, -1.1);
  }
}

// The bounds that the lines need, in shares of the field's own size, on 100 uneven cells.
TEST(EstimateFields, JetFitIsAccurateOnTheSheetsOfTheThesis) {
  for (const Solid& solid :
       {Solid{SolidKind::SineSheet, 0.5, 2.0, 3.0}, Solid{SolidKind::GaussianBump, 2.0, 4.0}}) {
    SCOPED_TRACE(solid.name());
    const Sample sample = sampleOf(solid, {100, true});
    const Difference d =
        mediansOf(sample, estimateFields(sample.mesh, with(FieldEstimator::JetFit)));
    double K = 0.0, C = 0.0;
    for (std::uint32_t v = 0; v < sample.mesh.vertexCount(); ++v) {
      K = std::max(K, std::abs<double>(sample.exact.k1[v]));
      for (const auto* c : {&sample.exact.c111, &sample.exact.c222})
        C = std::max(C, std::abs<double>((*c)[v]));
    }
    EXPECT_LT(d.n, 2e-4);
    EXPECT_LT(d.K / K, 1e-3);
    EXPECT_LT(d.C / C, 2e-2);
  }
}

// Neither may lose anything on a sphere: all derivatives are known by symmetry. The one-ring is
// exact there, for its normals are.
TEST(EstimateFields, SphereOfBothEstimators) {
  const Sample sample = sampleOf({SolidKind::Sphere, 3.0}, {20, true});
  for (const auto estimator : kBoth) {
    const bool exact = estimator == FieldEstimator::OneRing;
    const SurfaceFields fields = estimateFields(sample.mesh, with(estimator));
    ASSERT_EQ(fields.vertexCount(), sample.mesh.vertexCount());
    EXPECT_DOUBLE_EQ(fields.size, surfaceSize(sample.mesh));
    for (std::uint32_t v = 0; v < fields.vertexCount(); ++v) {
      const Difference d = differenceOf(fields.at(sample.mesh, v), sample.exact.at(sample.mesh, v));
      EXPECT_LT(d.n, exact ? 5e-6 : 1e-4);
      EXPECT_LT(d.K, exact ? 5e-5 : 2e-3);
      EXPECT_LT(d.C, exact ? 1e-3 : 5e-2);
    }
  }
}

Eigen::Vector3d vertexOf(const PolygonSoup& soup, std::size_t v) {
  return {soup.positions[3 * v], soup.positions[3 * v + 1], soup.positions[3 * v + 2]};
}

// The soup with its positions multiplied by a matrix.
PolygonSoup moved(PolygonSoup soup, const Eigen::Matrix3d& by) {
  for (std::size_t v = 0; v < soup.vertexCount(); ++v) {
    const Eigen::Vector3d p = by * vertexOf(soup, v);
    for (std::size_t k = 0; k < 3; ++k) soup.positions[3 * v + k] = p[static_cast<int>(k)];
  }
  return soup;
}

// Of a smooth surface and of one as rough as a scan, on which fits of all sizes are chosen.
TEST(EstimateFields, TurnWithTheSurface) {
  for (const double roughness : {0.0, 3e-3}) {
    SCOPED_TRACE(roughness);
    Random random(announcedSeed("roughness", 5));
    PolygonSoup soup = meshOf({SolidKind::BumpySphere, 1.0, 0.1, 5.0}, {24, true}).soup;
    for (double& coordinate : soup.positions) coordinate += roughness * normal(random);
    const TriangleMesh mesh = buildMesh(soup).mesh;
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.3, -0.8, 0.5).normalized()).toRotationMatrix();
    const TriangleMesh turned = buildMesh(moved(soup, turn)).mesh;
    const double grow = mesh.unit / turned.unit;  // of lengths in the mesh
    for (const auto estimator : kBoth) {
      const SurfaceFields a = estimateFields(mesh, with(estimator));
      const SurfaceFields b = estimateFields(turned, with(estimator));
      EXPECT_NEAR(b.size, a.size * grow, 1e-6);
      std::vector<double> n, K, C;
      for (std::uint32_t v = 0; v < a.vertexCount(); ++v) {
        SurfacePoint p = a.at(mesh, v);
        const SurfacePoint q = b.at(turned, turned.meshVertex[mesh.fileVertex[v]]);
        p.n = turn * p.n;
        p.frame = turn * p.frame;
        p.K /= grow;
        for (double& c : p.C.coefficients) c /= grow * grow;
        const Difference d = differenceOf(q, p);
        n.push_back(d.n);
        K.push_back(d.K);
        C.push_back(d.C);
      }
      // All of it is rounding (n, K and C are about 1, 5 and 100), but where it decides between two
      // fits.
      EXPECT_LT(medianOf(n), 1e-5);
      EXPECT_LT(medianOf(K), 1e-3);
      EXPECT_LT(medianOf(C), 0.1);
      EXPECT_LT(
          static_cast<double>(std::count_if(K.begin(), K.end(), [](double d) { return d > 0.05; })),
          0.01 * static_cast<double>(K.size()));
    }
  }
}

TEST(EstimateFields, UnitsAndNumbersOfTheFileDoNotMatter) {
  const SolidMesh made = meshOf({SolidKind::Torus, 1.0, 0.4}, {24, true});
  const TriangleMesh mesh = buildMesh(made.soup).mesh;
  const SurfaceFields usual = estimateFields(mesh);
  for (const double scale : {0x1p-66, 0x1p100}) {
    const TriangleMesh scaled =
        buildMesh(moved(made.soup, scale * Eigen::Matrix3d::Identity())).mesh;
    const SurfaceFields fields = estimateFields(scaled);
    EXPECT_NEAR(scaled.unit / mesh.unit / scale, 1.0, 1e-12);
    for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(*arraysOf(fields)[i], *arraysOf(usual)[i]);
  }
  // The last vertex first.
  PolygonSoup renumbered;
  const auto last = static_cast<std::uint32_t>(made.soup.vertexCount() - 1);
  for (std::uint32_t v = 0; v <= last; ++v) {
    const Eigen::Vector3d p = vertexOf(made.soup, last - v);
    renumbered.addVertex(p.x(), p.y(), p.z());
  }
  for (std::size_t i = 0; i < made.soup.corners.size(); i += 3) {
    const auto* c = &made.soup.corners[i];
    renumbered.addTriangle(last - c[0], last - c[1], last - c[2]);
  }
  const SurfaceFields fields = estimateFields(buildMesh(renumbered).mesh);
  for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(*arraysOf(fields)[i], *arraysOf(usual)[i]);
}

TEST(EstimateFields, OtherWindingOtherSigns) {
  const Sample up = sampleOf({SolidKind::GaussianBump, 2.0, 4.0}, {40, true});
  PolygonSoup soup = up.made.soup;
  for (std::size_t i = 0; i < soup.corners.size(); i += 3)
    std::swap(soup.corners[i + 1], soup.corners[i + 2]);
  const TriangleMesh down = buildMesh(soup).mesh;
  for (const auto estimator : kBoth) {
    const SurfaceFields a = estimateFields(up.mesh, with(estimator));
    const SurfaceFields b = estimateFields(down, with(estimator));
    for (std::uint32_t v = 0; v < a.vertexCount(); ++v) {
      const SurfacePoint p = turnedRound(b.at(down, v)), q = a.at(up.mesh, v);
      const Difference d = differenceOf(p, q);
      // Floats, summed in another order: by 1e-6 of the largest n (1), K (8) and C (60).
      EXPECT_LT(d.n, 1e-5);
      EXPECT_LT(d.K, 1e-3);
      EXPECT_LT(d.C, 2e-2);
    }
    EXPECT_GT(a.nz[0], 0.0f);
    EXPECT_LT(b.nz[0], 0.0f);
  }
}

// One-sided neighbourhoods lose accuracy, not their senses.
TEST(EstimateFields, BordersAreEstimatedToo) {
  const Sample sample = sampleOf({SolidKind::SineSheet, 0.5, 2.0, 3.0}, {80, true});
  double largest = 0.0;
  for (const float k : sample.exact.k1) largest = std::max<double>(largest, k);
  for (const auto estimator : kBoth) {
    const SurfaceFields fields = estimateFields(sample.mesh, with(estimator));
    expectFinite(fields);
    std::vector<double> n, K;
    for (std::uint32_t v = 0; v < sample.mesh.vertexCount(); ++v) {
      if (!sample.mesh.isAtEdge(v)) continue;
      const Difference d = differenceOf(fields.at(sample.mesh, v), sample.exact.at(sample.mesh, v));
      n.push_back(d.n);
      K.push_back(d.K / largest);
    }
    const bool jet = estimator == FieldEstimator::JetFit;
    EXPECT_LT(medianOf(n), jet ? 5e-3 : 5e-2);
    EXPECT_LT(medianOf(K), jet ? 0.05 : 0.3);
  }
}

// A wavy sheet of edges 1e-20 of a triangle's: K fits a float, C does not.
TEST(EstimateFields, WhatIsBeyondFloatCountsAsUnknown) {
  PolygonSoup soup = moved(meshOf({SolidKind::SineSheet, 0.5, 2.0, 3.0}, {.cells = 12}).soup,
                           1e-20 * Eigen::Matrix3d::Identity());
  const auto first = static_cast<std::uint32_t>(soup.vertexCount());
  soup.addVertex(-1.0, -1.0, 0.0);
  soup.addVertex(1.0, -1.0, 0.0);
  soup.addVertex(0.0, 1.0, 0.0);
  soup.addTriangle(first, first + 1, first + 2);
  const TriangleMesh mesh = buildMesh(soup).mesh;
  ASSERT_EQ(mesh.vertexCount(), first + 3);
  for (const auto estimator : kBoth) {
    const SurfaceFields fields = estimateFields(mesh, with(estimator));
    ASSERT_EQ(fields.vertexCount(), mesh.vertexCount());
    expectFinite(fields);
  }
  // K and C go together: the one without the other would be another surface.
  SurfaceFields fields;
  fields.resize(2);
  SurfacePoint point;
  point.n = Eigen::Vector3d::UnitZ();
  point.frame << 1, 0, 0, 1, 0, 0;
  point.K << 3, 0, 0, 2;
  for (const double c111 : {1e38, -1e39}) {
    point.C.coefficients = {c111, 1, 1, 1};
    fields.set(c111 < 0 ? 1 : 0, point);
  }
  EXPECT_EQ(fields.k1[0], 3.0f);
  EXPECT_EQ(fields.c111[0], 1e38f);
  for (const auto* values : {&fields.k1, &fields.k2, &fields.c111, &fields.c222})
    EXPECT_EQ((*values)[1], 0.0f);
  EXPECT_EQ(fields.normal(1), Eigen::Vector3f::UnitZ());
}

TEST(EstimateFields, SmallAndFlatMeshesAreFinite) {
  const double s = std::sqrt(0.5);
  PolygonSoup triangle, tetrahedron, needle, cone;
  for (auto* soup : {&triangle, &tetrahedron}) {
    soup->addVertex(1.0, 0.0, -s);
    soup->addVertex(-1.0, 0.0, -s);
    soup->addVertex(0.0, 1.0, s);
  }
  triangle.addTriangle(0, 1, 2);
  tetrahedron.addVertex(0.0, -1.0, s);
  for (const auto& t : {std::array{0u, 2u, 1u}, {0u, 3u, 2u}, {1u, 2u, 3u}, {0u, 1u, 3u}})
    tetrahedron.addTriangle(t[0], t[1], t[2]);
  // A triangle on a line stays where it fills a slit; its middle vertex has one triangle with an
  // area.
  needle.addVertex(0.0, 0.0, 0.0);
  needle.addVertex(1.0, 0.0, 0.0);
  needle.addVertex(0.5, 0.0, 0.0);
  needle.addVertex(0.5, 1.0, 0.0);
  needle.addTriangle(0, 1, 3);
  needle.addTriangle(0, 2, 1);
  cone.addVertex(0.0, 0.0, 1.0);
  constexpr std::uint32_t kSides = 4000;
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kSides;
    cone.addVertex(std::cos(angle), std::sin(angle), 0.0);
    cone.addTriangle(0, 1 + i, 1 + (i + 1) % kSides);
  }
  for (const auto* soup : {&triangle, &tetrahedron, &needle, &cone}) {
    const TriangleMesh mesh = buildMesh(*soup).mesh;
    for (const auto estimator : kBoth) {
      for (const double scale : {1.0, 3.0}) {
        const SurfaceFields fields = estimateFields(mesh, with(estimator, scale));
        ASSERT_EQ(fields.vertexCount(), mesh.vertexCount());
        expectFinite(fields);
      }
    }
  }
  // Flat: nothing bends.
  const TriangleMesh flat = buildMesh(triangle).mesh;
  for (const auto estimator : kBoth) {
    const SurfaceFields fields = estimateFields(flat, with(estimator));
    for (std::uint32_t v = 0; v < 3; ++v) {
      EXPECT_NEAR(fields.normal(v).norm(), 1.0, 1e-6);
      EXPECT_NEAR(fields.k1[v], 0.0, 1e-5);
      EXPECT_NEAR(fields.k2[v], 0.0, 1e-5);
    }
  }
  // A vertex with no triangle but that on the line has no normal; where it is one, all is 0.
  const TriangleMesh slit = buildMesh(needle).mesh;
  const SurfaceFields fields = estimateFields(slit);
  int without = 0;
  for (std::uint32_t v = 0; v < slit.vertexCount(); ++v) {
    if (fields.normal(v).norm() > 0.5f) continue;
    ++without;
    EXPECT_EQ(fields.normal(v).norm(), 0.0f);
    EXPECT_EQ(fields.k1[v], 0.0f);
    EXPECT_EQ(fields.c111[v], 0.0f);
  }
  EXPECT_EQ(without, 1);
}

// Rings summed one by one and added with their weights, against all of them summed at once.
TEST(EstimateFields, AFitInOneGoIsThatOfItsRings) {
  const Sample sample = sampleOf({SolidKind::BumpySphere, 1.0, 0.1, 5.0}, {12, true});
  const VertexNeighbours neighbours(sample.mesh);
  const std::vector<Eigen::Vector3d> normals = vertexNormals(sample.mesh, with(kBoth[0]));
  LocalFit rings(sample.mesh, neighbours, normals), once(sample.mesh, neighbours, normals);
  for (std::uint32_t v = 0; v < sample.mesh.vertexCount(); v += 7) {
    for (const double size : {2.0, 2.6, 4.0, 5.5}) {
      ASSERT_TRUE(rings.startAt(v));
      const HeightPolynomial a = rings.over(size);
      const auto b = once.at(v, size);
      ASSERT_TRUE(b);
      ASSERT_EQ(a.degree, b->degree);
      EXPECT_EQ(rings.edge(), once.edge());
      for (std::size_t i = 0; i < HeightPolynomial::kSize; ++i)
        EXPECT_NEAR(a.coefficients[i], b->coefficients[i], 1e-10) << v << " " << size;
    }
  }
}

TEST(EstimateFields, ScalesThatAreNoneAreRefused) {
  const TriangleMesh mesh = buildMesh(meshOf({SolidKind::Sphere}, {6}).soup).mesh;
  const auto refused = [&mesh](FieldEstimator estimator, double scale) {
    const FieldOptions options = with(estimator, scale);
    try {
      estimateFields(mesh, options);
    } catch (const InputError& error) {
      EXPECT_EQ(error.reason(), whyNotFields(options));
      return !error.reason().empty();
    }
    EXPECT_EQ(whyNotFields(options), "");
    return false;
  };
  for (const FieldEstimator estimator : kBoth) {
    for (const double none : {0.0, -1.0, 0.99, HUGE_VAL, std::nan("")})
      EXPECT_TRUE(refused(estimator, none)) << none;
  }
  EXPECT_FALSE(refused(FieldEstimator::OneRing, kMostOneRingScale));
  EXPECT_TRUE(refused(FieldEstimator::OneRing, kMostOneRingScale * 1.01));
  EXPECT_FALSE(refused(FieldEstimator::JetFit, kMostOneRingScale * 1.01));
}

TEST(EstimateFields, ThreadsDoNotMatter) {
  const TriangleMesh mesh =
      buildMesh(meshOf({SolidKind::BumpySphere, 1.0, 0.1, 5.0}, {40, true}).soup).mesh;
  for (const auto estimator : kBoth) {
    const SurfaceFields one = estimateFields(mesh, with(estimator, 1.5, 1));
    const SurfaceFields three = estimateFields(mesh, with(estimator, 1.5, 3));
    for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(*arraysOf(one)[i], *arraysOf(three)[i]);
  }
}

TEST(EstimateFields, ProgressGrowsToOneAndStopIsHeard) {
  const TriangleMesh mesh =
      buildMesh(meshOf({SolidKind::BumpySphere, 1.0, 0.1, 5.0}, {40, true}).soup).mesh;
  for (const auto estimator : kBoth) {
    FieldOptions options = with(estimator, 1.5, 2);
    std::atomic<int> calls{0};
    double last = 0.0;
    bool fell = false;
    options.progress = [&](double share) {
      fell = fell || share < last;
      last = share;
      ++calls;
    };
    EXPECT_EQ(estimateFields(mesh, options).vertexCount(), mesh.vertexCount());
    EXPECT_FALSE(fell);
    EXPECT_DOUBLE_EQ(last, 1.0);
    const int all = calls;
    EXPECT_GT(all, 10);

    std::stop_source stop;
    options.stop = stop.get_token();
    calls = 0;
    options.progress = [&](double) {
      if (++calls == all / 2) stop.request_stop();
    };
    EXPECT_EQ(estimateFields(mesh, options).vertexCount(), 0u);
    EXPECT_LT(calls, all / 2 + 4);
    calls = 0;
    EXPECT_EQ(estimateFields(mesh, options).vertexCount(), 0u);
    EXPECT_EQ(calls, 0);
  }
}

}  // namespace
}  // namespace flatland::test
