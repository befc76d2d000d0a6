// SPDX-License-Identifier: MIT
#include "core3d/diff/height_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

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

}  // namespace

void HeightSums::add(double u, double v, double h, double weight) {
  std::array<double, kPowers> power;
  power[0] = weight;
  for (std::size_t d = 1, row = 1, before = 0; d <= 8; before = row, row += ++d) {
    for (std::size_t j = 0; j < d; ++j) power[row + j] = power[before + j] * u;
    power[row + d] = power[before + d - 1] * v;
  }
  for (std::size_t k = 0; k < kPowers; ++k) powers[k] += power[k];
  for (std::size_t k = 0; k < kSize; ++k) heights[k] += h * power[k];
  heightsSq += weight * h * h;
  ++points;
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
  std::size_t size = HeightPolynomial::sizeOf(degree);

  // Cholesky of the normal equations, scaled to a diagonal of 1 (so units and the size of the
  // neighbourhood do not count). Columns stand by degree: a smaller degree is a leading block.
  double scale[kSize], L[kSize][kSize], inverse[kSize];
  for (std::size_t i = 0; i < size; ++i) {
    const double diagonal = sums.powers[kProducts.at[i][i]];
    scale[i] = diagonal > 0.0 ? 1.0 / std::sqrt(diagonal) : 0.0;
  }
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      double entry = scale[i] * scale[j] * sums.powers[kProducts.at[i][j]];
      for (std::size_t k = 0; k < j; ++k) entry -= L[i][k] * L[j][k];
      L[i][j] = entry * inverse[j];
    }
    double pivot = 1.0 + kRidge;
    for (std::size_t k = 0; k < i; ++k) pivot -= L[i][k] * L[i][k];
    if (i >= HeightPolynomial::sizeOf(2)) {
      if (!(pivot > kLeastPivot)) {
        degree = i < HeightPolynomial::sizeOf(3) ? 2 : 3;
        size = HeightPolynomial::sizeOf(degree);
        break;
      }
    } else {
      pivot = std::max(pivot, kRidge);
    }
    inverse[i] = 1.0 / std::sqrt(pivot);
  }

  HeightPolynomial polynomial;
  polynomial.degree = degree;
  double* x = polynomial.coefficients.data();
  for (std::size_t i = 0; i < size; ++i) {
    double entry = scale[i] * sums.heights[i];
    for (std::size_t k = 0; k < i; ++k) entry -= L[i][k] * x[k];
    x[i] = entry * inverse[i];
  }
  for (std::size_t i = size; i-- > 0;) {
    double entry = x[i];
    for (std::size_t k = i + 1; k < size; ++k) entry -= L[k][i] * x[k];
    x[i] = entry * inverse[i];
  }
  for (std::size_t i = 0; i < size; ++i) x[i] *= scale[i];

  // The inverse's diagonal: the squares of column i of L's inverse.
  for (std::size_t i = HeightPolynomial::sizeOf(2); i < size; ++i) {
    double column[kSize], squares = 0.0;
    for (std::size_t k = i; k < size; ++k) {
      double entry = k == i ? 1.0 : 0.0;
      for (std::size_t m = i; m < k; ++m) entry -= L[k][m] * column[m];
      column[k] = entry * inverse[k];
      squares += column[k] * column[k];
    }
    double& variance =
        i < HeightPolynomial::sizeOf(3) ? polynomial.thirdVariance : polynomial.fourthVariance;
    variance += kDerivatives[i] * squares * scale[i] * scale[i];
  }
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
