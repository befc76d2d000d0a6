// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace flatland {

/// A truncated Taylor series: the value of a function of one parameter with its derivatives up to
/// order N, all exact but for rounding (no difference quotients). Coefficient k is the k-th
/// derivative divided by k!. A plain value; the operations below are the usual recurrences of
/// automatic differentiation (bibliography: griewank2008, chapter 13).
///
/// Where a function has no derivative (sqrt at 0) the coefficients are not finite; nothing throws.
template <int N>
struct Taylor {
  static_assert(N >= 0);
  std::array<double, N + 1> c{};

  Taylor() = default;
  Taylor(double constant) { c[0] = constant; }  // NOLINT: a number is a constant series

  /// The parameter itself at `value`; `rate` is its derivative.
  static Taylor variable(double value, double rate = 1.0) {
    Taylor t(value);
    if constexpr (N > 0) t.c[1] = rate;
    return t;
  }

  double value() const { return c[0]; }

  /// The k-th derivative.
  double derivative(int k) const {
    double factorial = 1.0;
    for (int i = 2; i <= k; ++i) factorial *= i;
    return factorial * c[static_cast<std::size_t>(k)];
  }

  bool isConstant() const {
    for (std::size_t k = 1; k < c.size(); ++k)
      if (c[k] != 0.0) return false;
    return true;
  }

  bool isFinite() const {
    for (const double x : c)
      if (!std::isfinite(x)) return false;
    return true;
  }
};

namespace taylor_detail {

/// The series f with f' = g a' and the value `f0`; coefficient k needs g only below k.
template <int N, class CoefficientOfG>
Taylor<N> integratedWith(double f0, const Taylor<N>& a, CoefficientOfG&& gBelow) {
  Taylor<N> f(f0);
  for (std::size_t k = 1; k <= N; ++k) {
    double sum = 0.0;
    for (std::size_t j = 1; j <= k; ++j) {
      if (a.c[j] != 0.0) sum += static_cast<double>(j) * a.c[j] * gBelow(f, k - j);
    }
    f.c[k] = sum / static_cast<double>(k);
  }
  return f;
}

template <int N>
Taylor<N> integrated(double f0, const Taylor<N>& a, const Taylor<N>& g) {
  return integratedWith(f0, a, [&g](const Taylor<N>&, std::size_t k) { return g.c[k]; });
}

/// Coefficient k of f f.
template <int N>
double squareAt(const Taylor<N>& f, std::size_t k) {
  double sum = 0.0;
  for (std::size_t j = 0; j <= k; ++j) sum += f.c[j] * f.c[k - j];
  return sum;
}

}  // namespace taylor_detail

template <int N>
Taylor<N> operator+(Taylor<N> a, const Taylor<N>& b) {
  for (std::size_t k = 0; k <= N; ++k) a.c[k] += b.c[k];
  return a;
}
template <int N>
Taylor<N> operator-(Taylor<N> a, const Taylor<N>& b) {
  for (std::size_t k = 0; k <= N; ++k) a.c[k] -= b.c[k];
  return a;
}
template <int N>
Taylor<N> operator-(Taylor<N> a) {
  for (double& x : a.c) x = -x;
  return a;
}
template <int N>
Taylor<N> operator*(double s, Taylor<N> a) {
  for (double& x : a.c) x *= s;
  return a;
}
template <int N>
Taylor<N> operator*(const Taylor<N>& a, const Taylor<N>& b) {
  Taylor<N> p;
  for (std::size_t k = 0; k <= N; ++k) {
    for (std::size_t j = 0; j <= k; ++j) p.c[k] += a.c[j] * b.c[k - j];
  }
  return p;
}
template <int N>
Taylor<N> operator/(const Taylor<N>& a, const Taylor<N>& b) {
  Taylor<N> q;
  for (std::size_t k = 0; k <= N; ++k) {
    double rest = a.c[k];
    for (std::size_t j = 1; j <= k; ++j) rest -= b.c[j] * q.c[k - j];
    q.c[k] = rest / b.c[0];
  }
  return q;
}

template <int N>
Taylor<N> exp(const Taylor<N>& a) {
  return taylor_detail::integratedWith(std::exp(a.c[0]), a,
                                       [](const Taylor<N>& f, std::size_t k) { return f.c[k]; });
}

template <int N>
Taylor<N> log(const Taylor<N>& a) {
  return taylor_detail::integrated(std::log(a.c[0]), a, Taylor<N>(1.0) / a);
}

template <int N>
Taylor<N> sqrt(const Taylor<N>& a) {
  Taylor<N> s(std::sqrt(a.c[0]));
  if (a.isConstant()) return s;
  for (std::size_t k = 1; k <= N; ++k) {
    double rest = a.c[k];
    for (std::size_t j = 1; j < k; ++j) rest -= s.c[j] * s.c[k - j];
    s.c[k] = rest / (2.0 * s.c[0]);
  }
  return s;
}

/// Sine and cosine from their values at a.c[0].
template <int N>
void sinCosFrom(double sine, double cosine, const Taylor<N>& a, Taylor<N>& s, Taylor<N>& c) {
  s = Taylor<N>(sine);
  c = Taylor<N>(cosine);
  for (std::size_t k = 1; k <= N; ++k) {
    for (std::size_t j = 1; j <= k; ++j) {
      const double weight = static_cast<double>(j) * a.c[j] / static_cast<double>(k);
      s.c[k] += weight * c.c[k - j];
      c.c[k] -= weight * s.c[k - j];
    }
  }
}
template <int N>
Taylor<N> sin(const Taylor<N>& a) {
  Taylor<N> s, c;
  sinCosFrom(std::sin(a.c[0]), std::cos(a.c[0]), a, s, c);
  return s;
}
template <int N>
Taylor<N> cos(const Taylor<N>& a) {
  Taylor<N> s, c;
  sinCosFrom(std::sin(a.c[0]), std::cos(a.c[0]), a, s, c);
  return c;
}

/// sin and cos of 2 pi a, exact at multiples of a quarter turn: there a curve begins and ends.
template <int N>
void sinCosOfTurns(const Taylor<N>& a, Taylor<N>& s, Taylor<N>& c) {
  // Exactly reduced to an eighth of a turn on either side of a multiple of a quarter.
  const double quarters = std::nearbyint(4.0 * a.c[0]);
  const double rest = (a.c[0] - 0.25 * quarters) * (2.0 * std::numbers::pi);
  const double sine = std::sin(rest), cosine = std::cos(rest);
  const int quadrant = static_cast<int>(std::fmod(quarters, 4.0) + 4.0) % 4;
  const double sines[4] = {sine, cosine, -sine, -cosine};
  const double cosines[4] = {cosine, -sine, -cosine, sine};
  sinCosFrom(sines[quadrant], cosines[quadrant], (2.0 * std::numbers::pi) * a, s, c);
}

template <int N>
Taylor<N> tan(const Taylor<N>& a) {
  return taylor_detail::integratedWith(std::tan(a.c[0]), a, [](const Taylor<N>& f, std::size_t k) {
    return (k == 0 ? 1.0 : 0.0) + taylor_detail::squareAt(f, k);
  });
}
template <int N>
Taylor<N> tanh(const Taylor<N>& a) {
  return taylor_detail::integratedWith(
      std::tanh(a.c[0]), a, [&a](const Taylor<N>& f, std::size_t k) {
        if (k > 0) return -taylor_detail::squareAt(f, k);
        const double sech = 1.0 / std::cosh(a.c[0]);  // 1 - tanh^2 would cancel
        return sech * sech;
      });
}
template <int N>
Taylor<N> sinh(const Taylor<N>& a) {
  Taylor<N> s(std::sinh(a.c[0])), c(std::cosh(a.c[0]));
  for (std::size_t k = 1; k <= N; ++k) {
    for (std::size_t j = 1; j <= k; ++j) {
      const double weight = static_cast<double>(j) * a.c[j] / static_cast<double>(k);
      s.c[k] += weight * c.c[k - j];
      c.c[k] += weight * s.c[k - j];
    }
  }
  return s;
}
template <int N>
Taylor<N> cosh(const Taylor<N>& a) {
  return taylor_detail::integrated(std::cosh(a.c[0]), a, sinh(a));
}

template <int N>
Taylor<N> atan(const Taylor<N>& a) {
  return taylor_detail::integrated(std::atan(a.c[0]), a, Taylor<N>(1.0) / (Taylor<N>(1.0) + a * a));
}
template <int N>
Taylor<N> asin(const Taylor<N>& a) {
  const Taylor<N> one(1.0);
  return taylor_detail::integrated(std::asin(a.c[0]), a, one / sqrt((one - a) * (one + a)));
}
template <int N>
Taylor<N> acos(const Taylor<N>& a) {
  Taylor<N> f = -asin(a);
  f.c[0] = std::acos(a.c[0]);
  return f;
}
template <int N>
Taylor<N> asinh(const Taylor<N>& a) {
  const Taylor<N> one(1.0);
  return taylor_detail::integrated(std::asinh(a.c[0]), a, one / sqrt(one + a * a));
}
template <int N>
Taylor<N> acosh(const Taylor<N>& a) {
  const Taylor<N> one(1.0);
  return taylor_detail::integrated(std::acosh(a.c[0]), a, one / sqrt((a - one) * (a + one)));
}
template <int N>
Taylor<N> atanh(const Taylor<N>& a) {
  const Taylor<N> one(1.0);
  return taylor_detail::integrated(std::atanh(a.c[0]), a, one / ((one - a) * (one + a)));
}

/// The angle of (x, y), in (-pi, pi]; not finite at the origin.
template <int N>
Taylor<N> atan2(const Taylor<N>& y, const Taylor<N>& x) {
  const Taylor<N> normSq = x * x + y * y;
  const Taylor<N> gx = x / normSq, gy = y / normSq;
  Taylor<N> f = taylor_detail::integrated(0.0, y, gx) - taylor_detail::integrated(0.0, x, gy);
  f.c[0] = std::atan2(y.c[0], x.c[0]);
  return f;
}

/// |a|; where a passes through 0 the derivatives are those to the right.
template <int N>
Taylor<N> abs(const Taylor<N>& a) {
  for (const double x : a.c) {
    if (x > 0.0) return a;
    if (x < 0.0) return -a;
  }
  return a;
}

/// a to a constant power. A whole exponent takes any base; another one none below 0. At a = 0 the
/// derivatives below the exponent are 0, those above do not exist (infinite).
template <int N>
Taylor<N> pow(const Taylor<N>& a, double exponent) {
  constexpr double kLargestWhole = 1024.0;
  if (exponent == std::floor(exponent) && std::abs(exponent) <= kLargestWhole) {
    Taylor<N> result(1.0), base = a;
    for (auto n = static_cast<unsigned>(std::abs(exponent)); n > 0; n /= 2) {
      if (n % 2 == 1) result = result * base;
      if (n > 1) base = base * base;
    }
    result = exponent < 0.0 ? Taylor<N>(1.0) / result : result;
    result.c[0] = std::pow(a.c[0], exponent);  // correctly rounded where squaring is not
    return result;
  }
  Taylor<N> p(std::pow(a.c[0], exponent));
  if (a.isConstant()) return p;
  for (std::size_t k = 1; k <= N; ++k) {
    const auto order = static_cast<double>(k);
    if (a.c[0] == 0.0) {
      p.c[k] = order < exponent ? 0.0 : HUGE_VAL;
      continue;
    }
    double sum = 0.0;
    for (std::size_t j = 1; j <= k; ++j) {
      const auto i = static_cast<double>(j);
      sum += (exponent * i - (order - i)) * a.c[j] * p.c[k - j];
    }
    p.c[k] = sum / (order * a.c[0]);
  }
  return p;
}

/// a to the power b; if b varies, a must be positive.
template <int N>
Taylor<N> pow(const Taylor<N>& a, const Taylor<N>& b) {
  return b.isConstant() ? pow(a, b.c[0]) : exp(b * log(a));
}

}  // namespace flatland
