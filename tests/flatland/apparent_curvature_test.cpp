// SPDX-License-Identifier: GPL-3.0-or-later
// The dimension template against its definition in 50 digits: explicit normals, tangent frames,
// screen bases and projection matrices at neighbouring points, differentiated numerically.
#include "flatland/view/apparent_curvature.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "tests/support/precise.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

using Real = Precise;
using Vec3 = std::array<Real, 3>;

Real dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec3 operator-(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec3 operator*(const Real& s, const Vec3& a) { return {s * a[0], s * a[1], s * a[2]}; }
Vec3 unit(const Vec3& a) { return (1 / sqrt(dot(a, a))) * a; }
Vec3 crossed(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// z = h(x, y) = sum a_ij x^i y^j with 2 <= i + j <= 4: it touches the plane z = 0 at the origin.
struct HeightField {
  std::array<std::array<double, 5>, 5> a{};

  // d^(p+q) h / dx^p dy^q
  Real derivative(const Real& x, const Real& y, int p, int q) const {
    Real sum = 0;
    for (int i = p; i <= 4; ++i) {
      for (int j = q; i + j <= 4; ++j) {
        Real term = a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
        for (int m = 0; m < p; ++m) term *= i - m;
        for (int m = 0; m < q; ++m) term *= j - m;
        for (int m = p; m < i; ++m) term *= x;
        for (int m = q; m < j; ++m) term *= y;
        sum += term;
      }
    }
    return sum;
  }
  Vec3 point(const Real& x, const Real& y) const { return {x, y, derivative(x, y, 0, 0)}; }
  Vec3 normal(const Real& x, const Real& y) const {
    return unit({-derivative(x, y, 1, 0), -derivative(x, y, 0, 1), Real(1)});
  }
};

// Where the viewer is: along w from the origin, at a distance or infinitely far.
struct Viewer {
  Vec3 w;
  std::optional<double> distance;

  Vec3 towards(const Vec3& point) const { return distance ? unit(Real(*distance) * w - point) : w; }
};

// lambda at (x, y) by its definition: the largest squared singular value of Q = K P^-1, with K from
// numerically differentiated normals in an explicit tangent frame and P from an explicit screen
// basis.
Real lambdaByDefinition(const HeightField& h, const Viewer& viewer, LambdaMeasure measure,
                        const Real& x, const Real& y) {
  const Vec3 n = h.normal(x, y), p = h.point(x, y), w = viewer.towards(p);
  const Vec3 px{Real(1), Real(0), h.derivative(x, y, 1, 0)};
  const Vec3 py{Real(0), Real(1), h.derivative(x, y, 0, 1)};
  const Vec3 t1 = unit(px), t2 = crossed(n, t1);
  const Vec3 nx{derivativeAtZero([&](const Real& s) { return h.normal(x + s, y)[0]; }),
                derivativeAtZero([&](const Real& s) { return h.normal(x + s, y)[1]; }),
                derivativeAtZero([&](const Real& s) { return h.normal(x + s, y)[2]; })};
  const Vec3 ny{derivativeAtZero([&](const Real& s) { return h.normal(x, y + s)[0]; }),
                derivativeAtZero([&](const Real& s) { return h.normal(x, y + s)[1]; }),
                derivativeAtZero([&](const Real& s) { return h.normal(x, y + s)[2]; })};
  // In coordinates (dx, dy): J maps to the tangent frame, N to the change of normal, S to the
  // screen.
  const Vec3 e1 = unit(crossed(w, {Real(3) / 7, Real(-2) / 7, Real(5) / 7})), e2 = crossed(w, e1);
  const Real N[2][2] = {{dot(t1, nx), dot(t1, ny)}, {dot(t2, nx), dot(t2, ny)}};
  Real S[2][2] = {{dot(e1, px), dot(e1, py)}, {dot(e2, px), dot(e2, py)}};
  if (measure == LambdaMeasure::PerViewAngle) {
    const Vec3 sight = Real(*viewer.distance) * viewer.w - p;
    const Real d = sqrt(dot(sight, sight));
    for (auto& row : S) {
      for (Real& entry : row) entry /= d;
    }
  }
  const Real det = S[0][0] * S[1][1] - S[0][1] * S[1][0];
  const Real inverse[2][2] = {{S[1][1] / det, -S[0][1] / det}, {-S[1][0] / det, S[0][0] / det}};
  Real Q[2][2];
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) Q[i][j] = N[i][0] * inverse[0][j] + N[i][1] * inverse[1][j];
  }
  const Real a = Q[0][0] * Q[0][0] + Q[1][0] * Q[1][0], c = Q[0][1] * Q[0][1] + Q[1][1] * Q[1][1];
  const Real b = Q[0][0] * Q[0][1] + Q[1][0] * Q[1][1];
  return ((a + c) + sqrt((a - c) * (a - c) + 4 * b * b)) / 2;
}

struct Sample {
  HeightField surface;
  Viewer viewer;
  double turn;  // of the tangent frame against x, y
  SeenPoint<2> seen;
};

// A random surface seen from a random side, described at the origin in a turned tangent frame.
Sample randomSample(Random& random, bool perspective) {
  Sample s;
  for (int i = 0; i <= 4; ++i) {
    for (int j = 0; i + j <= 4; ++j) {
      if (i + j >= 2) {
        s.surface.a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = normal(random);
      }
    }
  }
  Vec3 w;
  do {
    w = unit({Real(normal(random)), Real(normal(random)), Real(normal(random))});
  } while (abs(w[2]) < 0.05);
  s.viewer.w = w;
  if (perspective) s.viewer.distance = uniform(random, 0.5, 5.0);
  s.turn = uniform(random, 0.0, 6.283);

  const Real cs = cos(Real(s.turn)), sn = sin(Real(s.turn));
  const Real T[2][2] = {{cs, -sn}, {sn, cs}};  // columns: the frame's vectors
  // With n up and no slope at the origin, K = -h_ij and C = -h_ijk.
  const auto& a = s.surface;
  const auto form = [&](std::initializer_list<int> frame) {
    Real sum = 0;
    const std::vector<int> f(frame);
    for (int bits = 0; bits < (1 << f.size()); ++bits) {
      Real product = 1;
      int ys = 0;
      for (std::size_t m = 0; m < f.size(); ++m) {
        const int axis = (bits >> m) & 1;
        ys += axis;
        product *= T[axis][f[m]];
      }
      sum -= product * a.derivative(0, 0, static_cast<int>(f.size()) - ys, ys);
    }
    return static_cast<double>(sum);
  };
  s.seen.K << form({0, 0}), form({0, 1}), form({0, 1}), form({1, 1});
  s.seen.C.coefficients = {form({0, 0, 0}), form({0, 0, 1}), form({0, 1, 1}), form({1, 1, 1})};
  s.seen.wT = {static_cast<double>(T[0][0] * w[0] + T[1][0] * w[1]),
               static_cast<double>(T[0][1] * w[0] + T[1][1] * w[1])};
  s.seen.nw = static_cast<double>(w[2]);
  s.seen.distance = s.viewer.distance;
  return s;
}

// The inputs are rounded to double (1e-16), amplified by cancellation between the terms and by the
// direction, which is known to 1e-16 / relativeGap.
constexpr double kRounding = 1e-13;

class OnSurfaces : public testing::TestWithParam<std::tuple<bool, LambdaMeasure>> {};

TEST_P(OnSurfaces, LambdaAndItsDerivativeFollowTheDefinition) {
  const auto [perspective, measure] = GetParam();
  if (!perspective && measure == LambdaMeasure::PerViewAngle) FAIL() << "no such view";
  Random random(announcedSeed("surfaces", 20261));
  int offsetMattered = 0, perspectiveMattered = 0;
  constexpr int kSamples = 150;
  for (int i = 0; i < kSamples; ++i) {
    const Sample s = randomSample(random, perspective);
    const auto result = apparentCurvature(s.seen, measure);
    ASSERT_TRUE(result);
    const auto lambdaAlong = [&](const Real& step) {
      const Real cs = cos(Real(s.turn)), sn = sin(Real(s.turn));
      const Real rx = cs * result->r(0) - sn * result->r(1),
                 ry = sn * result->r(0) + cs * result->r(1);
      return lambdaByDefinition(s.surface, s.viewer, measure, step * rx, step * ry);
    };
    const double lambda = static_cast<double>(lambdaAlong(0));
    EXPECT_NEAR(result->lambda, lambda, 1e-14 * lambda) << "sample " << i;

    // The direction: unit length on the screen, K r = sqrt(lambda) v, |v| = 1.
    const double step = measure == LambdaMeasure::PerViewAngle ? *s.seen.distance : 1.0;
    const double screenSq = result->r.squaredNorm() - std::pow(result->r.dot(s.seen.wT), 2);
    EXPECT_NEAR(screenSq, step * step, 1e-12 * result->r.squaredNorm() / result->relativeGap);
    EXPECT_LE((s.seen.K * result->r - std::sqrt(lambda) * result->v).norm(),
              1e-13 * std::sqrt(lambda) / result->relativeGap);
    EXPECT_NEAR(result->v.norm(), 1.0, 1e-15 * 4);
    EXPECT_GT(std::abs(result->v(0)) >= std::abs(result->v(1)) ? result->v(0) : result->v(1), 0.0);

    const double expected = 0.5 * static_cast<double>(derivativeAtZero(lambdaAlong));
    // Size of what is summed: |C| |r|^2 |Kr| and not C(r, r, Kr), which may cancel.
    double normC = 0.0;
    for (const double c : s.seen.C.coefficients) normC += std::abs(c);
    const double size = normC * result->r.squaredNorm() * std::sqrt(result->lambda) +
                        std::abs(result->offset) + std::abs(result->perspective) +
                        std::abs(s.seen.K.norm() * result->r.squaredNorm() * result->lambda);
    const double tolerance = kRounding * size / (result->relativeGap * std::abs(s.seen.nw));
    EXPECT_NEAR(result->sum(), expected, tolerance) << "sample " << i;
    if (std::abs(result->feature - result->offset + result->perspective - expected) >
        1e6 * tolerance) {
      ++offsetMattered;
    }
    if (std::abs(result->feature + result->offset - expected) > 1e6 * tolerance) {
      ++perspectiveMattered;
    }
  }
  // The check is one only if a turned sign or a lost term would have been noticed.
  EXPECT_GT(offsetMattered, kSamples * 9 / 10);
  if (perspective) {
    EXPECT_GT(perspectiveMattered, kSamples * 9 / 10);
  } else {
    EXPECT_EQ(perspectiveMattered, 0);
  }
}

std::string nameOfView(const testing::TestParamInfo<std::tuple<bool, LambdaMeasure>>& info) {
  const bool perAngle = std::get<1>(info.param) == LambdaMeasure::PerViewAngle;
  return std::string(std::get<0>(info.param) ? "Perspective" : "Orthographic") +
         (perAngle ? "PerViewAngle" : "PerLength");
}

INSTANTIATE_TEST_SUITE_P(Views, OnSurfaces,
                         testing::Values(std::tuple{false, LambdaMeasure::PerLength},
                                         std::tuple{true, LambdaMeasure::PerLength},
                                         std::tuple{true, LambdaMeasure::PerViewAngle}),
                         nameOfView);

// The printed (4.8) with (4.7): the tangent frame t1, t2 of the principal directions turns in its
// plane, D_r t1 = C(t1, t2, r) / Delta t2, D_r t2 = -C(t1, t2, r) / Delta t1, with Delta the
// difference of the view-dependent curvatures, and + in D(P^-1). Every choice of the four signs and
// of Delta (view dependent or principal curvatures, squared or not) is tried.
TEST(PrintedEquation48, NoSignVariantIsTheDerivative) {
  Random random(announcedSeed("printed 4.8", 4807));
  constexpr int kSamples = 60;
  int closed = 0;
  std::array<int, 16> agreed{};
  for (int i = 0; i < kSamples; ++i) {
    Sample s = randomSample(random, false);
    const auto result = apparentCurvature(s.seen);
    ASSERT_TRUE(result);
    const double cs = std::cos(s.turn), sn = std::sin(s.turn);
    const auto lambdaAlong = [&](const Real& step) {
      return lambdaByDefinition(s.surface, s.viewer, LambdaMeasure::PerLength,
                                step * (cs * result->r(0) - sn * result->r(1)),
                                step * (sn * result->r(0) + cs * result->r(1)));
    };
    const double expected = static_cast<double>(derivativeAtZero(lambdaAlong));
    if (std::abs(2.0 * result->sum() - expected) < 1e-9 * std::abs(expected)) ++closed;

    // P in the frame of principal directions with the screen basis along and across w_T.
    const Eigen::Vector2d wT = s.seen.wT, along = wT.normalized(), across(-along.y(), along.x());
    Eigen::Matrix2d P;
    P.row(0) = s.seen.nw * along.transpose();
    P.row(1) = across.transpose();
    const Eigen::Matrix2d inverse = P.inverse(), Q = s.seen.K * inverse;
    const Eigen::Vector2d tA = P * result->r;
    Eigen::Matrix2d Cr;
    const Eigen::Vector2d e1(1, 0), e2(0, 1);
    const auto& C = s.seen.C;
    Cr << C(e1, e1, result->r), C(e1, e2, result->r), C(e1, e2, result->r), C(e2, e2, result->r);
    // Principal directions of K.
    const double angle = 0.5 * std::atan2(2.0 * s.seen.K(0, 1), s.seen.K(0, 0) - s.seen.K(1, 1));
    const Eigen::Vector2d t1(std::cos(angle), std::sin(angle)), t2(-t1.y(), t1.x());
    const double principal = t1.dot(s.seen.K * t1) - t2.dot(s.seen.K * t2);
    const double delta = result->relativeGap * result->lambda;
    const double turning = C(t1, t2, result->r);
    int variant = 0;
    for (const double divisor : {delta, principal}) {
      for (const double turnSign : {1.0, -1.0}) {
        for (const double inverseSign : {1.0, -1.0}) {
          for (const double featureSign : {1.0, -1.0}) {
            // D t1 = q t2, D t2 = -q t1 in the plane: DP = P times that rotation.
            Eigen::Matrix2d spin;
            spin << 0.0, -1.0, 1.0, 0.0;
            const Eigen::Matrix2d DP = P * spin * (turnSign * turning / divisor);
            const double printed =
                2.0 * (Q * tA).dot((featureSign * Cr + inverseSign * s.seen.K * inverse * DP) *
                                   inverse * tA);
            if (std::abs(printed - expected) < 1e-6 * std::abs(expected)) {
              ++agreed[static_cast<std::size_t>(variant)];
            }
            ++variant;
          }
        }
      }
    }
  }
  EXPECT_EQ(closed, kSamples);
  for (const int count : agreed) EXPECT_EQ(count, 0);
}

TEST(OnSurfaces, SphereIsIsotropicOnlyHeadOn) {
  SeenPoint<2> p{
      .K = 0.5 * Eigen::Matrix2d::Identity(), .C = {}, .wT = {0, 0}, .nw = 1, .distance = {}};
  auto seen = apparentCurvature(p);
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->relativeGap, 0.0);
  EXPECT_DOUBLE_EQ(seen->lambda, 0.25);
  EXPECT_DOUBLE_EQ(seen->v.norm(), 1.0);
  EXPECT_EQ(seen->sum(), 0.0);
  p.wT = {0.0, 0.6};
  p.nw = 0.8;
  seen = apparentCurvature(p);
  ASSERT_TRUE(seen);
  EXPECT_DOUBLE_EQ(seen->lambda, 0.25 / 0.64);
  EXPECT_DOUBLE_EQ(seen->v(1), 1.0);
  EXPECT_DOUBLE_EQ(seen->r(1), 1.25);
  EXPECT_DOUBLE_EQ(seen->relativeGap, 0.36);
  // lambda = k^2 / nw^2 along a meridian of unit-speed angle a: d(lambda)/da / 2 = k^2 tan a /
  // cos^2 a, negative along r, which here runs towards the viewer.
  EXPECT_NEAR(seen->sum(), -0.25 * 0.5 * (0.6 / 0.8) / 0.64 * 1.25, 1e-15);
}

TEST(OnSurfaces, NearlyIsotropicKeepsItsDirection) {
  // K = I + e diag(1, -1) turned by 0.3: the direction is that of the larger principal curvature.
  for (const double e : {1e-3, 1e-7, 1e-11, 1e-14}) {
    // Entries taken so that their differences are exact to rounding.
    Eigen::Matrix2d K = Eigen::Matrix2d::Identity();
    K(0, 0) += e * std::cos(0.6);
    K(1, 1) -= e * std::cos(0.6);
    K(0, 1) = K(1, 0) = e * std::sin(0.6);
    const SeenPoint<2> p{.K = K, .C = {}, .wT = {0, 0}, .nw = 1, .distance = {}};
    const auto seen = apparentCurvature(p);
    ASSERT_TRUE(seen);
    const Eigen::Vector2d expected(std::cos(0.3), std::sin(0.3));
    EXPECT_LT((seen->v - expected).norm(), 3e-16 / e) << e;
    // The terms stay finite and of their size whatever the direction.
    EXPECT_NEAR(seen->lambda, (1.0 + e) * (1.0 + e), 1e-15 * 4);
  }
}

TEST(OnSurfaces, DegenerateAnswers) {
  SeenPoint<2> p{.K = Eigen::Matrix2d::Identity(),
                 .C = {{1, 2, 3, 4}},
                 .wT = {1, 0},
                 .nw = 0,
                 .distance = 3.0};
  EXPECT_FALSE(apparentCurvature(p));
  EXPECT_FALSE(apparentCurvature(p, LambdaMeasure::PerViewAngle));
  p.K.setZero();
  p.wT = {0.6, 0.0};
  p.nw = -0.8;
  const auto flat = apparentCurvature(p);
  ASSERT_TRUE(flat);
  EXPECT_EQ(flat->lambda, 0.0);
  EXPECT_EQ(flat->r.norm(), 0.0);
  EXPECT_EQ(flat->sum(), 0.0);
  EXPECT_EQ(flat->relativeGap, 0.0);
  EXPECT_EQ(flat->v, Eigen::Vector2d(1, 0));
  SeenPoint<1> q{};  // braces leave Eigen's matrices as they are
  q.K.setZero();
  q.wT.setZero();
  EXPECT_FALSE(apparentCurvature(q));
  q.nw = 1.0;
  ASSERT_TRUE(apparentCurvature(q));
  EXPECT_EQ(apparentCurvature(q)->lambda, 0.0);
  EXPECT_EQ(apparentCurvature(q)->relativeGap, 1.0);
}

}  // namespace
}  // namespace flatland::test
