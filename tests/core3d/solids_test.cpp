// SPDX-License-Identifier: GPL-3.0-or-later
// The analytic solids against closed forms, and against differences of their normals in 50 digits.
#include "core3d/mesh/solids.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>

#include "core3d/mesh/build_mesh.h"
#include "tests/core3d/mesh_check.h"
#include "tests/support/precise.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

using Real = Precise;
using Vec = std::array<Real, 3>;

Real dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec unit(const Vec& a) {
  const Real length = sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

// Each surface again, as the zeros of a function with its gradient: nothing in common with
// solids.cpp. The gradient points to the side of the normal.
Real valueOf(const Solid& s, const Vec& p) {
  const Real a = s.a, b = s.b, c = s.c;
  const auto& [x, y, z] = p;
  const Real r = sqrt(dot(p, p));
  switch (s.kind) {
    case SolidKind::Sphere:
      return r - a;
    case SolidKind::Cylinder:
      return sqrt(x * x + y * y) - a;
    case SolidKind::Torus: {
      const Real ring = sqrt(x * x + y * y) - a;
      return sqrt(ring * ring + z * z) - b;
    }
    case SolidKind::Ellipsoid:
      return x * x / (a * a) + y * y / (b * b) + z * z / (c * c) - 1;
    case SolidKind::Saddle:
      return z - a * (x * x - y * y) / 2;
    case SolidKind::SineSheet:
      return z - a * sin(b * x);
    case SolidKind::GaussianBump:
      return z - a * exp(-(x * x + y * y) / 2);
    case SolidKind::RoundedCube:
      return (pow(x, 4) + pow(y, 4) + pow(z, 4)) / pow(a, 4) - 1;
    case SolidKind::BumpySphere:
      return r - a * (1 + b * sin(c * x / r) * sin(c * y / r) * sin(c * z / r));
  }
  return 0;
}

Vec gradient(const Solid& s, const Vec& p) {
  Vec g;
  for (std::size_t k = 0; k < 3; ++k) {
    g[k] = derivativeAtZero([&](const Real& h) {
      Vec q = p;
      q[k] += h;
      return valueOf(s, q);
    });
  }
  return g;
}

// The point of the surface nearest to p along the gradient at p: three steps of Newton from within
// 1e-6 leave less than 1e-40.
Vec pulled(const Solid& s, Vec p) {
  for (int step = 0; step < 4; ++step) {
    const Vec g = gradient(s, p);
    const Real along = valueOf(s, p) / dot(g, g);
    for (std::size_t k = 0; k < 3; ++k) p[k] -= along * g[k];
  }
  return p;
}

// The shape operator as a 3 x 3 matrix with the normal in its kernel: the second derivatives of the
// function, projected, over the length of its gradient.
using Matrix = std::array<Vec, 3>;
Matrix shapeOperator(const Solid& s, const Vec& p) {
  const Vec g = gradient(s, p), n = unit(g);
  const Real length = sqrt(dot(g, g));
  Matrix hessian;
  for (std::size_t k = 0; k < 3; ++k) {
    const Real h = Real("1e-9");
    Vec plus = p, minus = p;
    plus[k] += h;
    minus[k] -= h;
    const Vec gp = gradient(s, plus), gm = gradient(s, minus);
    for (std::size_t i = 0; i < 3; ++i) hessian[i][k] = (gp[i] - gm[i]) / (2 * h * length);
  }
  Matrix half, result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      half[i][j] = hessian[i][j] -
                   n[i] * (n[0] * hessian[0][j] + n[1] * hessian[1][j] + n[2] * hessian[2][j]);
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = half[i][j] - dot(half[i], n) * n[j];
  }
  return result;
}

Eigen::Matrix2d inFrame(const Matrix& m, const SurfacePoint& point) {
  Eigen::Matrix3d d;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      d(i, j) = static_cast<double>(m[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
    }
  }
  return point.frame.transpose() * d * point.frame;
}

Eigen::Vector3d randomPlace(const Solid& solid, Random& random) {
  switch (solid.kind) {
    case SolidKind::Cylinder:
    case SolidKind::Saddle:
    case SolidKind::SineSheet:
    case SolidKind::GaussianBump:
    case SolidKind::Torus:
      return {uniform(random, -1, 1), uniform(random, -1, 1), 0.0};
    default:
      return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
  }
}

TEST(Solids, CurvaturesAreThoseOfTheirImplicitForms) {
  constexpr double kTolerance =
      1e-11;  // the differences leave 1e-17, doubles with K near 1..30 the rest
  Random random(announcedSeed("implicit", 21));
  for (const Solid& solid : standardSolids()) {
    SCOPED_TRACE(solid.name());
    for (int sample = 0; sample < 4; ++sample) {
      const SurfacePoint point = pointAt(solid, randomPlace(solid, random));
      const Vec p = pulled(solid, {point.p.x(), point.p.y(), point.p.z()});
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(static_cast<double>(p[static_cast<std::size_t>(k)]), point.p[k], 1e-14);
        EXPECT_NEAR(static_cast<double>(unit(gradient(solid, p))[static_cast<std::size_t>(k)]),
                    point.n[k], 1e-13);
      }
      EXPECT_NEAR(point.frame.col(0).cross(point.frame.col(1)).dot(point.n), 1.0, 1e-14);
      const double size = std::max(1.0, point.K.norm());
      EXPECT_LT((inFrame(shapeOperator(solid, p), point) - point.K).norm(), kTolerance * size);
      // C(., ., e_k) is the derivative of K along e_k on the surface, seen in the tangent plane.
      const Real step = Real("1e-6");
      for (int k = 0; k < 2; ++k) {
        const auto at = [&](int sign) {
          Vec q = p;
          for (std::size_t i = 0; i < 3; ++i)
            q[i] += sign * step * point.frame(static_cast<int>(i), k);
          return inFrame(shapeOperator(solid, pulled(solid, q)), point);
        };
        // Doubles enter in inFrame: 1e-16 / 1e-6. Symmetric differences err by 1e-12 K'''.
        const Eigen::Matrix2d derivative = (at(1) - at(-1)) / 2e-6;
        const auto& c = point.C.coefficients;
        const auto first = static_cast<std::size_t>(k);
        const Eigen::Matrix2d claimed =
            (Eigen::Matrix2d() << c[first], c[first + 1], c[first + 1], c[first + 2]).finished();
        EXPECT_LT((derivative - claimed).norm(), 1e-7 * std::max(1.0, claimed.norm())) << k;
      }
    }
  }
}

TEST(Solids, ClosedForms) {
  const SurfacePoint sphere = pointAt({SolidKind::Sphere, 2.0}, {0.6, 0.0, 0.8});
  EXPECT_LT((sphere.K - 0.5 * Eigen::Matrix2d::Identity()).norm(), 1e-14);
  for (const double c : sphere.C.coefficients) EXPECT_NEAR(c, 0.0, 1e-14);
  // Torus: 1/b round the tube, cos(v) / (a + b cos(v)) round the axis; the derivative of the latter
  // along the tube by arc length, -a sin(v) / (b (a + b cos(v))^2), and nothing else.
  const double a = 1.0, b = 0.4, v = 0.7;
  const SurfacePoint torus = pointAt({SolidKind::Torus, a, b}, {0.3, v, 0.0});
  const double radius = a + b * std::cos(v);
  EXPECT_NEAR(torus.K(0, 0), std::cos(v) / radius, 1e-14);  // e1 runs round the axis
  EXPECT_NEAR(torus.K(1, 1), 1.0 / b, 1e-14);
  EXPECT_NEAR(torus.K(0, 1), 0.0, 1e-14);
  EXPECT_NEAR(torus.C.coefficients[0], 0.0, 1e-13);
  EXPECT_NEAR(torus.C.coefficients[1], -a * std::sin(v) / (b * radius * radius), 1e-13);
  EXPECT_NEAR(torus.C.coefficients[2], 0.0, 1e-13);
  EXPECT_NEAR(torus.C.coefficients[3], 0.0, 1e-13);
  // A sheet over x alone: curvature of the graph, with the normal up: k = -f'' / (1 + f'^2)^1.5.
  const double x = 0.9, f1 = std::cos(2 * x), f2 = -2 * std::sin(2 * x);
  const SurfacePoint sheet = pointAt({SolidKind::SineSheet, 0.5, 2.0, 3.0}, {x, 0.4, 0.0});
  EXPECT_NEAR(sheet.K(0, 0), -f2 / std::pow(1 + f1 * f1, 1.5), 1e-14);
  EXPECT_NEAR(sheet.K(1, 1), 0.0, 1e-15);
}

TEST(Solids, TheSheetAndTheBumpHaveTheirApparentRidgesWhereTheyAreKnown) {
  // mathematics: the sine sheet seen from p degrees off its normal, and the bump from its axis.
  const Solid sheet{SolidKind::SineSheet, 0.5, 2.0, 3.0};
  const std::array<std::pair<double, double>, 3> crests = {
      {{15, 0.739422981666}, {30, 0.67229729362}, {40, 0.534538108401}}};
  for (const auto& [degrees, x] : crests) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    const Eigen::Vector3d w(std::sin(angle), 0.0, std::cos(angle));
    const auto sumAt = [&](double at) {
      const auto seen = apparentCurvature(seenFrom(pointAt(sheet, {at, 0.3, 0.0}), w));
      return seen->sum() * (seen->r(0) > 0 ? 1.0 : -1.0);
    };
    EXPECT_GT(sumAt(x - 1e-9), 0.0);
    EXPECT_LT(sumAt(x + 1e-9), 0.0);
  }
  const Solid bump{SolidKind::GaussianBump, 2.0, 4.0};
  const Eigen::Vector3d along(std::cos(0.4), std::sin(0.4), 0.0);
  const auto slopeAt = [&](double radius) {
    const SurfacePoint point = pointAt(bump, radius * along);
    const auto seen = apparentCurvature(seenFrom(point, Eigen::Vector3d::UnitZ()));
    return seen->sum() * ((point.frame * seen->r).dot(along) > 0 ? 1.0 : -1.0);
  };
  EXPECT_GT(slopeAt(2.004241986613 - 1e-9), 0.0);
  EXPECT_LT(slopeAt(2.004241986613 + 1e-9), 0.0);
}

TEST(Solids, MeshesLieOnTheSolidAndFaceItsWay) {
  for (const Solid& solid : standardSolids()) {
    SCOPED_TRACE(solid.name());
    for (const bool irregular : {false, true}) {
      const SolidMesh made = meshOf(solid, {.cells = 12, .irregular = irregular});
      ASSERT_EQ(made.places.size(), made.soup.vertexCount());
      for (std::size_t v = 0; v < made.places.size(); ++v) {
        const Eigen::Vector3d p(&made.soup.positions[3 * v]);
        EXPECT_LT((pointAt(solid, made.places[v]).p - p).norm(), 1e-14);
      }
      const auto [mesh, report] = buildMesh(made.soup);
      expectSound(mesh);
      EXPECT_EQ(report.pieces, 1u);
      EXPECT_EQ(report.turnedTriangles, 0u);
      EXPECT_EQ(report.invertedPieces, 0u);
      EXPECT_EQ(report.collapsedTriangles, 0u);
      const bool sheet = solid.kind == SolidKind::Saddle || solid.kind == SolidKind::SineSheet ||
                         solid.kind == SolidKind::GaussianBump;
      EXPECT_EQ(report.borderEdges, sheet ? 48u : solid.kind == SolidKind::Cylinder ? 24u : 0u);
      for (const auto& [a, b, c] : mesh.triangles) {
        const Eigen::Vector3f p = mesh.position(a);
        const Eigen::Vector3d n =
            (mesh.position(b) - p).cross(mesh.position(c) - p).cast<double>().normalized();
        EXPECT_GT(n.dot(pointAt(solid, made.places[mesh.fileVertex[a]]).n), 0.2);
      }
    }
  }
}

TEST(Solids, IrregularMeshesAreIrregularAsStated) {
  const Solid sheet{SolidKind::SineSheet, 0.5, 2.0, 3.0};
  const SolidMesh plain = meshOf(sheet, {.cells = 40});
  const SolidMesh moved = meshOf(sheet, {.cells = 40, .irregular = true});
  const double cell = 6.0 / 40;
  double sum = 0.0, squares = 0.0, most = 0.0;
  int inner = 0;
  for (std::size_t v = 0; v < plain.places.size(); ++v) {
    const Eigen::Vector3d move = (moved.places[v] - plain.places[v]) / cell;
    const bool border = plain.places[v].cwiseAbs().maxCoeff() > 3.0 - 1e-9;
    if (border) {
      EXPECT_EQ(move.norm(), 0.0);
      continue;
    }
    ++inner;
    for (const double m : {move.x(), move.y()}) {
      most = std::max(most, std::abs(m));
      sum += m;
      squares += m * m;
    }
  }
  EXPECT_LE(most, 0.25 + 1e-12);
  // Uniform on [-1/4, 1/4]: mean 0, mean square 1/48; 3042 draws.
  EXPECT_NEAR(sum / (2 * inner), 0.0, 0.01);
  EXPECT_NEAR(squares / (2 * inner), 1.0 / 48.0, 0.001);
  // Another seed, another mesh; the same seed, the same.
  EXPECT_NE(meshOf(sheet, {.cells = 40, .irregular = true, .seed = 2}).soup.positions,
            moved.soup.positions);
  EXPECT_EQ(meshOf(sheet, {.cells = 40, .irregular = true}).soup.positions, moved.soup.positions);
}

}  // namespace
}  // namespace flatland::test
