// SPDX-License-Identifier: MIT
#include "core3d/diff/height_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

// A function compiled for several processors, of which the program takes the best when it starts.
// Products are never fused with sums, so that all of them give the same numbers.
#if defined(__x86_64__) && defined(__gnu_linux__)
#define FLATLAND_CLONES [[gnu::target_clones("avx512f", "avx2", "default")]]
#else
#define FLATLAND_CLONES
#endif

namespace flatland {

namespace {

constexpr std::size_t kSize = HeightPolynomial::kSize;

// A column whose part independent of those before it is smaller than this (squared, of its own
// length) is not decided by the points: rounding of float positions would be blown up a thousand
// times in it. Points on one side of a border leave 1e-5.
constexpr double kLeastPivot = 1e-6;
// Added to the diagonal (scaled to 1), so that degree 2 is always decided: far above rounding and
// far below what any decided coefficient feels.
constexpr double kRidge = 1e-11;

// Where the product of two monomials stands among the powers.
struct Products {
  std::array<std::array<std::uint8_t, kSize>, kSize> at{};
  constexpr Products() {
    for (int d = 0; d <= 4; ++d) {
      for (int j = 0; j <= d; ++j) {
        for (int e = 0; e <= 4; ++e) {
          for (int k = 0; k <= e; ++k) {
            at[HeightPolynomial::index(d - j, j)][HeightPolynomial::index(e - k, k)] =
                static_cast<std::uint8_t>(HeightPolynomial::index(d - j + e - k, j + k));
          }
        }
      }
    }
  }
};
constexpr Products kProducts;

// The square of i! j!, which makes a derivative of a coefficient, times the number of orders of its
// indices.
constexpr double kDerivatives[kSize] = {1.0,   1.0,        1.0,        4.0,        2.0,
                                        4.0,   36.0,       3.0 * 4.0,  3.0 * 4.0,  36.0,
                                        576.0, 4.0 * 36.0, 6.0 * 16.0, 4.0 * 36.0, 576.0};

// Eight numbers that the compiler computes with at once, in as many registers as they need.
using Row [[gnu::vector_size(64)]] = double;

// Sums over points of w u^i v^j, i < 8 along a row (those of i + j > 8 are computed in vain), of
// w u^8, of w h u^i v^j and of w h^2.
struct Rows {
  Row powers[9];
  Row heights[5];
  double eighth, heightsSq;
};

FLATLAND_CLONES
void sumRows(const WeightedHeight* points, std::size_t count, Rows& sums) {
  using Mask [[gnu::vector_size(64)]] = long long;
  constexpr Mask kOdd = {0, -1, 0, -1, 0, -1, 0, -1}, kTwos = {0, 0, -1, -1, 0, 0, -1, -1},
                 kFours = {0, 0, 0, 0, -1, -1, -1, -1};
  constexpr Row kOnes = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
  Row powers[9] = {}, heights[5] = {};
  double eighth = 0.0, heightsSq = 0.0;
  for (std::size_t p = 0; p < count; ++p) {
    const auto [u, v, h, weight] = points[p];
    const double square = u * u, fourth = square * square;
    Row row = (kOdd ? kOnes * u : kOnes) * (kTwos ? kOnes * square : kOnes) *
              ((kFours ? kOnes * fourth : kOnes) * weight);
    eighth += weight * (fourth * fourth);
    heightsSq += weight * h * h;
#pragma GCC unroll 9
    for (int j = 0; j <= 8; ++j) {
      powers[j] += row;
      if (j <= 4) heights[j] += row * h;
      row *= v;
    }
  }
  std::copy(powers, powers + 9, sums.powers);
  std::copy(heights, heights + 5, sums.heights);
  sums.eighth = eighth;
  sums.heightsSq = heightsSq;
}

// Least squares of the degree that the polynomial has; lowers it if the points do not decide it.
// Loops go along padded rows, which the compiler turns into a few wide registers each.
FLATLAND_CLONES
void solve(const HeightSums& sums, HeightPolynomial& polynomial) {
  constexpr std::size_t kPadded = 16;
  std::size_t size = HeightPolynomial::sizeOf(polynomial.degree);

  // Cholesky of the normal equations, scaled to a diagonal of 1 (so units and the size of the
  // neighbourhood do not count). Columns stand by degree: a smaller degree is a leading block.
  // L[k] is column k of the factor; above the diagonal it means nothing.
  alignas(64) double L[kSize][kPadded], scale[kPadded] = {}, inverse[kSize];
  for (std::size_t i = 0; i < size; ++i) {
    const double diagonal = sums.powers[kProducts.at[i][i]];
    scale[i] = diagonal > 0.0 ? 1.0 / std::sqrt(diagonal) : 0.0;
  }
  for (std::size_t j = 0; j < size; ++j) {
    alignas(64) double column[kPadded] = {};
    for (std::size_t i = j + 1; i < size; ++i) column[i] = sums.powers[kProducts.at[i][j]];
    for (std::size_t i = 0; i < kPadded; ++i) column[i] *= scale[i] * scale[j];
    column[j] = 1.0 + kRidge;
    for (std::size_t k = 0; k < j; ++k) {
      const double factor = L[k][j];
      for (std::size_t i = 0; i < kPadded; ++i) column[i] -= factor * L[k][i];
    }
    double pivot = column[j];
    if (j >= HeightPolynomial::sizeOf(2)) {
      if (!(pivot > kLeastPivot)) {
        polynomial.degree = j < HeightPolynomial::sizeOf(3) ? 2 : 3;
        size = HeightPolynomial::sizeOf(polynomial.degree);
        break;
      }
    } else {
      pivot = std::max(pivot, kRidge);
    }
    inverse[j] = 1.0 / std::sqrt(pivot);
    for (std::size_t i = 0; i < kPadded; ++i) L[j][i] = column[i] * inverse[j];
  }

  // With the rows X of the factor's inverse the solution is the sum of (X b) X, and the variances
  // are the sums of their squares.
  alignas(64) double X[kSize][kPadded], squares[kPadded] = {}, solution[kPadded] = {};
  double y[kSize];
  for (std::size_t i = 0; i < size; ++i) {
    alignas(64) double row[kPadded] = {};
    row[i] = 1.0;
    y[i] = scale[i] * sums.heights[i];
    for (std::size_t k = 0; k < i; ++k) {
      const double factor = L[k][i];
      y[i] -= factor * y[k];
      for (std::size_t c = 0; c < kPadded; ++c) row[c] -= factor * X[k][c];
    }
    y[i] *= inverse[i];
    for (std::size_t c = 0; c < kPadded; ++c) {
      X[i][c] = row[c] * inverse[i];
      squares[c] += X[i][c] * X[i][c];
      solution[c] += y[i] * X[i][c];
    }
  }
  for (std::size_t i = 0; i < size; ++i) polynomial.coefficients[i] = solution[i] * scale[i];
  for (std::size_t i = HeightPolynomial::sizeOf(2); i < size; ++i) {
    double& variance =
        i < HeightPolynomial::sizeOf(3) ? polynomial.thirdVariance : polynomial.fourthVariance;
    variance += kDerivatives[i] * squares[i] * scale[i] * scale[i];
  }
}

}  // namespace

void HeightSums::add(std::span<const WeightedHeight> added) {
  Rows rows;
  sumRows(added.data(), added.size(), rows);
  for (int j = 0; j <= 8; ++j) {
    for (int i = 0; i <= std::min(7, 8 - j); ++i)
      powers[HeightPolynomial::index(i, j)] += rows.powers[j][i];
  }
  powers[HeightPolynomial::index(8, 0)] += rows.eighth;
  for (int j = 0; j <= 4; ++j) {
    for (int i = 0; i <= 4 - j; ++i) heights[HeightPolynomial::index(i, j)] += rows.heights[j][i];
  }
  heightsSq += rows.heightsSq;
  points += static_cast<int>(added.size());
}

void HeightSums::add(const HeightSums& other, double weight) {
  for (std::size_t k = 0; k < kPowers; ++k) powers[k] += weight * other.powers[k];
  for (std::size_t k = 0; k < kSize; ++k) heights[k] += weight * other.heights[k];
  heightsSq += weight * other.heightsSq;
  points += other.points;
}

double HeightPolynomial::derivativeNorm(int order) const {
  double sum = 0.0;
  for (std::size_t i = sizeOf(order - 1); i < sizeOf(order); ++i)
    sum += kDerivatives[i] * coefficients[i] * coefficients[i];
  return std::sqrt(sum);
}

HeightPolynomial fitHeight(const HeightSums& sums, int degree) {
  while (degree > 2 && static_cast<std::size_t>(sums.points) < HeightPolynomial::sizeOf(degree))
    --degree;
  HeightPolynomial polynomial;
  polynomial.degree = degree;
  solve(sums, polynomial);
  return polynomial;
}

double squaredResiduals(const HeightSums& sums, const HeightPolynomial& polynomial) {
  const auto& c = polynomial.coefficients;
  const std::size_t size = HeightPolynomial::sizeOf(polynomial.degree);
  double squares = sums.heightsSq;
  for (std::size_t i = 0; i < size; ++i) {
    double column = 0.5 * sums.powers[kProducts.at[i][i]] * c[i];
    for (std::size_t j = 0; j < i; ++j) column += sums.powers[kProducts.at[i][j]] * c[j];
    squares += 2.0 * c[i] * (column - sums.heights[i]);
  }
  return std::max(0.0, squares);
}

}  // namespace flatland
