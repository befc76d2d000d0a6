// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace flatland {

/// A height over a plane as a polynomial of degree 2, 3 or 4 in u and v, by degree and then by
/// powers of v: 1, u, v, uu, uv, vv, ... Coefficients above the degree are 0.
struct HeightPolynomial {
  static constexpr std::size_t kSize = 15;
  static constexpr std::size_t index(int i, int j) {
    return static_cast<std::size_t>((i + j) * (i + j + 1) / 2 + j);
  }
  static constexpr std::size_t sizeOf(int degree) { return index(0, degree) + 1; }

  int degree = 0;
  std::array<double, kSize> coefficients{};
  /// How errors of the heights with variance 1 reach the derivatives: sum of the variances of all
  /// eight third ones, h_uuu, h_uuv, h_uvu, ..., and of all sixteen fourth ones; 0 where the degree
  /// is lower.
  double thirdVariance = 0.0, fourthVariance = 0.0;

  /// Of u^i v^j.
  double at(int i, int j) const { return coefficients[index(i, j)]; }
  /// Root of the sum of the squares of all four second derivatives, h_uu, h_uv, h_vu, h_vv.
  double secondNorm() const { return derivativeNorm(2); }
  /// The same of all sixteen fourth ones.
  double fourthNorm() const { return derivativeNorm(4); }

 private:
  double derivativeNorm(int order) const;
};

/// A point over a plane and how much it counts.
struct WeightedHeight {
  double u, v, h, weight;
};

/// Weighted points over a plane, reduced to the sums that a least squares fit of any degree up to 4
/// is made from: sums of w u^i v^j and w h u^i v^j. Two sets of points are joined by adding their
/// sums. Coordinates should be about 1 in size.
struct HeightSums {
  static constexpr std::size_t kPowers = 45;  // i + j <= 8
  std::array<double, kPowers> powers{};
  std::array<double, HeightPolynomial::kSize> heights{};
  double heightsSq = 0.0;  ///< sum of w h^2
  int points = 0;

  /// About 10 nanoseconds a point with AVX-512, else up to 40. The sums are the same whatever the
  /// processor.
  void add(std::span<const WeightedHeight> added);
  /// Adds the points of another set, their weights multiplied.
  void add(const HeightSums& other, double weight);
};

/// The polynomial of least squares, of the highest degree up to `degree` (2 to 4) that the points
/// decide: at least as many points as coefficients, and no coefficient's column nearly a
/// combination of those before it. For degree 2 that is not asked; undecided coefficients are then
/// as small as the others allow, and without points all are 0. About half a microsecond.
HeightPolynomial fitHeight(const HeightSums& sums, int degree);

/// Sum of w (h - polynomial)^2, >= 0.
double squaredResiduals(const HeightSums& sums, const HeightPolynomial& polynomial);

}  // namespace flatland
