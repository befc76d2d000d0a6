// SPDX-License-Identifier: GPL-3.0-or-later
#include "core3d/diff/height_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "tests/support/seed.h"

namespace flatland::test {
namespace {

using Point = WeightedHeight;

HeightSums sumsOf(const std::vector<Point>& points) {
  HeightSums sums;
  sums.add(points);
  return sums;
}

double value(const HeightPolynomial& polynomial, double u, double v) {
  double sum = 0.0;
  for (int d = 0; d <= 4; ++d) {
    for (int j = 0; j <= d; ++j)
      sum += polynomial.at(d - j, j) * std::pow(u, d - j) * std::pow(v, j);
  }
  return sum;
}

std::vector<Point> randomPoints(Random& random, int count) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const double u = uniform(random, -2.0, 2.0), v = uniform(random, -2.0, 2.0);
    const double h = uniform(random, -1.0, 1.0);
    points.push_back({u, v, h, uniform(random, 0.2, 1.0)});
  }
  return points;
}

// The slow way: the matrix of monomials itself, by QR with pivoting.
Eigen::MatrixXd monomials(const std::vector<Point>& points, int degree) {
  Eigen::MatrixXd A(points.size(), HeightPolynomial::sizeOf(degree));
  for (std::size_t r = 0; r < points.size(); ++r) {
    for (int d = 0; d <= degree; ++d) {
      for (int j = 0; j <= d; ++j) {
        A(static_cast<Eigen::Index>(r),
          static_cast<Eigen::Index>(HeightPolynomial::index(d - j, j))) =
            std::sqrt(points[r].weight) * std::pow(points[r].u, d - j) * std::pow(points[r].v, j);
      }
    }
  }
  return A;
}

TEST(HeightFit, AgreesWithQrOfTheMonomials) {
  Random random(announcedSeed("HeightFit", 401));
  for (int run = 0; run < 60; ++run) {
    const int degree = 2 + run % 3;
    const std::vector<Point> points = randomPoints(random, 37);
    const Eigen::MatrixXd A = monomials(points, degree);
    Eigen::VectorXd b(points.size());
    for (std::size_t r = 0; r < points.size(); ++r)
      b[static_cast<Eigen::Index>(r)] = std::sqrt(points[r].weight) * points[r].h;
    const Eigen::VectorXd x = A.colPivHouseholderQr().solve(b);

    const HeightSums sums = sumsOf(points);
    const HeightPolynomial fit = fitHeight(sums, degree);
    ASSERT_EQ(fit.degree, degree);
    // Normal equations square the condition, which is below 1e4 here.
    for (Eigen::Index i = 0; i < x.size(); ++i)
      EXPECT_NEAR(fit.coefficients[static_cast<std::size_t>(i)], x[i], 1e-8);
    for (std::size_t i = HeightPolynomial::sizeOf(degree); i < HeightPolynomial::kSize; ++i)
      EXPECT_EQ(fit.coefficients[i], 0.0);
    EXPECT_NEAR(squaredResiduals(sums, fit), (A * x - b).squaredNorm(), 1e-8);

    if (degree < 3) {
      EXPECT_EQ(fit.thirdVariance, 0.0);
      continue;
    }
    const Eigen::MatrixXd inverse = (A.transpose() * A).inverse();
    const double variance =
        36.0 * inverse(6, 6) + 12.0 * inverse(7, 7) + 12.0 * inverse(8, 8) + 36.0 * inverse(9, 9);
    EXPECT_NEAR(fit.thirdVariance / variance, 1.0, 1e-6);
    if (degree < 4) {
      EXPECT_EQ(fit.fourthVariance, 0.0);
      continue;
    }
    const double fourth = 576.0 * (inverse(10, 10) + inverse(14, 14)) +
                          4.0 * 36.0 * (inverse(11, 11) + inverse(13, 13)) +
                          6.0 * 16.0 * inverse(12, 12);
    EXPECT_NEAR(fit.fourthVariance / fourth, 1.0, 1e-6);
  }
}

TEST(HeightFit, ReproducesAQuarticAndItsFourthDerivatives) {
  Random random(announcedSeed("HeightFit", 402));
  const auto quartic = [](double u, double v) {
    return 1.0 - u + 2.0 * u * v - v * v * v + 0.5 * u * u * u * v + 0.25 * v * v * v * v;
  };
  std::vector<Point> points = randomPoints(random, 20);
  for (Point& p : points) p.h = quartic(p.u, p.v);
  const HeightPolynomial fit = fitHeight(sumsOf(points), 4);
  ASSERT_EQ(fit.degree, 4);
  EXPECT_NEAR(fit.at(1, 1), 2.0, 1e-8);
  EXPECT_NEAR(fit.at(0, 3), -1.0, 1e-8);
  EXPECT_NEAR(fit.at(3, 1), 0.5, 1e-8);
  EXPECT_NEAR(value(fit, 0.3, -0.7), quartic(0.3, -0.7), 1e-8);
  // h_uuuv = 3 stands four times among the sixteen, h_vvvv = 6 once.
  EXPECT_NEAR(fit.fourthNorm(), std::sqrt(4.0 * 9.0 + 36.0), 1e-6);
  // h_uv = 2 stands twice among the four.
  EXPECT_NEAR(fit.secondNorm(), std::sqrt(8.0), 1e-7);
}

TEST(HeightFit, SumsOfPartsAreTheSumOfTheWhole) {
  Random random(announcedSeed("HeightFit", 403));
  const std::vector<Point> first = randomPoints(random, 20), second = randomPoints(random, 15);
  HeightSums parts = sumsOf(first);
  parts.add(sumsOf(second), 0.25);
  std::vector<Point> all = first;
  for (Point p : second) {
    p.weight *= 0.25;
    all.push_back(p);
  }
  const HeightPolynomial a = fitHeight(parts, 4), b = fitHeight(sumsOf(all), 4);
  EXPECT_EQ(parts.points, 35);
  for (std::size_t i = 0; i < HeightPolynomial::kSize; ++i)
    EXPECT_NEAR(a.coefficients[i], b.coefficients[i], 1e-10);
}

TEST(HeightFit, FallsToTheDegreeThatThePointsDecide) {
  Random random(announcedSeed("HeightFit", 404));
  std::vector<Point> points = randomPoints(random, 14);
  EXPECT_EQ(fitHeight(sumsOf(points), 4).degree, 3);
  points.resize(9);
  EXPECT_EQ(fitHeight(sumsOf(points), 4).degree, 2);
  // Enough of them, but on three lines: v^3 is a combination of 1, v, v^2.
  points.clear();
  for (int i = -4; i <= 4; ++i) {
    for (int j = -1; j <= 1; ++j) points.push_back({0.5 * i, 1.0 * j, 0.3 * i * i + 0.2 * j, 1.0});
  }
  const HeightPolynomial lines = fitHeight(sumsOf(points), 4);
  EXPECT_EQ(lines.degree, 2);
  EXPECT_NEAR(lines.at(2, 0), 1.2, 1e-6);
  EXPECT_NEAR(lines.at(0, 1), 0.2, 1e-6);
}

TEST(HeightFit, IsFiniteWithoutEnoughPointsForAnyDegree) {
  // One edge bent upwards: u^2 is half decided, v not at all.
  const std::vector<Point> edge = {{0.0, 0.0, 0.0, 1.0}, {1.0, 0.0, 0.5, 1.0}};
  for (const auto& points : {std::vector<Point>{}, std::vector<Point>{edge[0]}, edge}) {
    const HeightPolynomial fit = fitHeight(sumsOf(points), 4);
    EXPECT_EQ(fit.degree, 2);
    for (const double c : fit.coefficients) {
      EXPECT_TRUE(std::isfinite(c));
      EXPECT_LE(std::abs(c), 1.0);
    }
    EXPECT_EQ(fit.at(0, 2), 0.0);
    for (const Point& p : points) EXPECT_NEAR(value(fit, p.u, p.v), p.h, 1e-4);
  }
}

}  // namespace
}  // namespace flatland::test
