// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace flatland {

/// A number with the size of what it was computed from: the sum of the absolute values of the
/// products, each factor's own cancellation counted to first order. Rounding disturbs the number by
/// about 1e-16 of its size, so the difference of two such numbers over the sum of their sizes is
/// what a residual without dimension means, however much cancelled on the way.
struct Sized {
  double value = 0.0;
  double size = 0.0;

  Sized() = default;
  Sized(double v) : value(v), size(std::abs(v)) {}  // NOLINT: a double is such a number
  Sized(double v, double s) : value(v), size(s) {}
};

inline Sized operator-(const Sized& a) { return {-a.value, a.size}; }
inline Sized operator+(const Sized& a, const Sized& b) {
  return {a.value + b.value, a.size + b.size};
}
inline Sized operator-(const Sized& a, const Sized& b) { return a + (-b); }
inline Sized operator*(const Sized& a, const Sized& b) {
  const double product = a.value * b.value;
  // The last term is of second order; it counts where both factors have cancelled to nothing.
  return {product, a.size * std::abs(b.value) + std::abs(a.value) * b.size - std::abs(product) +
                       0x1p-53 * a.size * b.size};
}
inline Sized operator/(const Sized& a, const Sized& b) {
  const double quotient = a.value / b.value, divisor = std::abs(b.value);
  return {quotient, a.size / divisor + std::abs(quotient) * (b.size / divisor - 1.0)};
}
inline Sized sqrt(const Sized& a) {
  const double root = std::sqrt(a.value);
  return {root, a.value > 0.0 ? 0.5 * (a.size / root + root) : std::sqrt(a.size)};
}
inline double valueOf(double a) { return a; }
inline double valueOf(const Sized& a) { return a.value; }

/// A power series cut off after the square, c[0] + c[1] e + c[2] e^2: carried through a formula it
/// gives the formula's first two derivatives, exact to rounding (forward differentiation).
struct Series {
  std::array<Sized, 3> c{};

  Series() = default;
  Series(const Sized& a) : c{a, Sized(0.0), Sized(0.0)} {}  // NOLINT: a constant
  Series(double a) : Series(Sized(a)) {}                    // NOLINT: a constant
  Series(const Sized& a, const Sized& b, const Sized& d) : c{a, b, d} {}
};

inline double valueOf(const Series& a) { return a.c[0].value; }
inline Series operator-(const Series& a) { return {-a.c[0], -a.c[1], -a.c[2]}; }
inline Series operator+(const Series& a, const Series& b) {
  return {a.c[0] + b.c[0], a.c[1] + b.c[1], a.c[2] + b.c[2]};
}
inline Series operator-(const Series& a, const Series& b) { return a + (-b); }
inline Series operator*(const Series& a, const Series& b) {
  return {a.c[0] * b.c[0], a.c[0] * b.c[1] + a.c[1] * b.c[0],
          a.c[0] * b.c[2] + a.c[1] * b.c[1] + a.c[2] * b.c[0]};
}
inline Series operator/(const Series& a, const Series& b) {
  Series q;
  q.c[0] = a.c[0] / b.c[0];
  q.c[1] = (a.c[1] - q.c[0] * b.c[1]) / b.c[0];
  q.c[2] = (a.c[2] - q.c[0] * b.c[2] - q.c[1] * b.c[1]) / b.c[0];
  return q;
}
inline Series sqrt(const Series& a) {
  Series r;
  r.c[0] = sqrt(a.c[0]);
  const Sized twice = Sized(2.0) * r.c[0];
  r.c[1] = a.c[1] / twice;
  r.c[2] = (a.c[2] - r.c[1] * r.c[1]) / twice;
  return r;
}
/// The series of the derivative; its last coefficient is not known and 0.
inline Series derivative(const Series& a) { return {a.c[1], Sized(2.0) * a.c[2], Sized(0.0)}; }

/// Short vectors over any of the numbers above.
template <class S, std::size_t N>
using VectorOf = std::array<S, N>;

template <class S, std::size_t N>
VectorOf<S, N> operator+(const VectorOf<S, N>& a, const VectorOf<S, N>& b) {
  VectorOf<S, N> sum;
  for (std::size_t i = 0; i < N; ++i) sum[i] = a[i] + b[i];
  return sum;
}
template <class S, std::size_t N>
VectorOf<S, N> operator-(const VectorOf<S, N>& a) {
  VectorOf<S, N> minus;
  for (std::size_t i = 0; i < N; ++i) minus[i] = -a[i];
  return minus;
}
template <class S, std::size_t N>
VectorOf<S, N> operator*(const S& s, const VectorOf<S, N>& a) {
  VectorOf<S, N> product;
  for (std::size_t i = 0; i < N; ++i) product[i] = s * a[i];
  return product;
}
template <class S, std::size_t N>
S dotOf(const VectorOf<S, N>& a, const VectorOf<S, N>& b) {
  S sum = a[0] * b[0];
  for (std::size_t i = 1; i < N; ++i) sum = sum + a[i] * b[i];
  return sum;
}

}  // namespace flatland
