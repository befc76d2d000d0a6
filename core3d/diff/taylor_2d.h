// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "core3d/diff/surface_jet.h"

namespace flatland {

/// A function of two variables near a point, as its Taylor polynomial of degree 3: arithmetic on
/// these differentiates formulas exactly (up to rounding).
class Taylor2D {
 public:
  Taylor2D(double constant = 0.0) { at(0, 0) = constant; }  // NOLINT: numbers are constants

  static Taylor2D u(double value) { return variable(value, 1, 0); }
  static Taylor2D v(double value) { return variable(value, 0, 1); }

  /// d^(i+j) / du^i dv^j at the point; i + j <= 3.
  double derivative(int i, int j) const {
    constexpr double kFactorial[] = {1.0, 1.0, 2.0, 6.0};
    return at(i, j) * kFactorial[i] * kFactorial[j];
  }
  double value() const { return at(0, 0); }

  /// Coefficient of du^i dv^j.
  double& at(int i, int j) { return coefficients_[index(i, j)]; }
  double at(int i, int j) const { return coefficients_[index(i, j)]; }

  friend Taylor2D operator+(Taylor2D a, const Taylor2D& b) {
    for (std::size_t i = 0; i < kSize; ++i) a.coefficients_[i] += b.coefficients_[i];
    return a;
  }
  friend Taylor2D operator-(Taylor2D a, const Taylor2D& b) {
    for (std::size_t i = 0; i < kSize; ++i) a.coefficients_[i] -= b.coefficients_[i];
    return a;
  }
  friend Taylor2D operator*(const Taylor2D& a, const Taylor2D& b) {
    Taylor2D product;
    for (int i = 0; i <= 3; ++i) {
      for (int j = 0; i + j <= 3; ++j) {
        for (int k = 0; i + j + k <= 3; ++k) {
          for (int l = 0; i + j + k + l <= 3; ++l)
            product.at(i + k, j + l) += a.at(i, j) * b.at(k, l);
        }
      }
    }
    return product;
  }

  /// f(a), from f and its first three derivatives at a.value().
  friend Taylor2D composed(const Taylor2D& a, double f, double f1, double f2, double f3) {
    Taylor2D step = a;
    step.at(0, 0) = 0.0;
    return Taylor2D(f) +
           step * (Taylor2D(f1) + step * (Taylor2D(f2 / 2.0) + step * Taylor2D(f3 / 6.0)));
  }
  friend Taylor2D sin(const Taylor2D& a) {
    const double s = std::sin(a.value()), c = std::cos(a.value());
    return composed(a, s, c, -s, -c);
  }
  friend Taylor2D cos(const Taylor2D& a) {
    const double s = std::sin(a.value()), c = std::cos(a.value());
    return composed(a, c, -s, -c, s);
  }
  friend Taylor2D exp(const Taylor2D& a) {
    const double e = std::exp(a.value());
    return composed(a, e, e, e, e);
  }
  /// Precondition: a.value() > 0.
  friend Taylor2D pow(const Taylor2D& a, double p) {
    const double x = a.value(), f = std::pow(x, p);
    return composed(a, f, p * f / x, p * (p - 1.0) * f / (x * x),
                    p * (p - 1.0) * (p - 2.0) * f / (x * x * x));
  }

 private:
  static constexpr std::size_t kSize = 10;
  static constexpr std::size_t index(int i, int j) {
    const int degree = i + j;
    return static_cast<std::size_t>(degree * (degree + 1) / 2 + j);
  }
  static Taylor2D variable(double value, int i, int j) {
    Taylor2D result(value);
    result.at(i, j) = 1.0;
    return result;
  }

  std::array<double, kSize> coefficients_{};
};

/// The jet of the surface with these coordinates.
inline SurfaceJet jetOf(const std::array<Taylor2D, 3>& r) {
  const auto derivative = [&r](int i, int j) {
    return Eigen::Vector3d(r[0].derivative(i, j), r[1].derivative(i, j), r[2].derivative(i, j));
  };
  return {derivative(0, 0), derivative(1, 0), derivative(0, 1), derivative(2, 0), derivative(1, 1),
          derivative(0, 2), derivative(3, 0), derivative(2, 1), derivative(1, 2), derivative(0, 3)};
}

}  // namespace flatland
