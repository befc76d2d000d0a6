// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/math/constants/constants.hpp>
#include <functional>
#include <vector>

#include "flatland/curve/bezier.h"
#include "tests/support/precise.h"

namespace flatland::test {

using PreciseFunction = std::function<Precise(const Precise&)>;

/// Bernstein coefficients on [0, 1] of the polynomial of this degree that interpolates f(low..high)
/// at Chebyshev points, in 50 digits, rounded to double once.
inline std::vector<double> fittedCoefficients(const PreciseFunction& f, const Precise& low,
                                              const Precise& high, int degree) {
  const auto n = static_cast<std::size_t>(degree);
  std::vector<Precise> node, difference;
  for (std::size_t i = 0; i <= n; ++i) {
    const Precise pi = boost::math::constants::pi<Precise>();
    node.push_back((1 - cos(pi * (2 * static_cast<int>(i) + 1) / (2 * degree + 2))) / 2);
    difference.push_back(f(low + (high - low) * node.back()));
  }
  // Newton's divided differences, then Horner in powers of s.
  for (std::size_t k = 1; k <= n; ++k) {
    for (std::size_t i = n; i >= k; --i) {
      difference[i] = (difference[i] - difference[i - 1]) / (node[i] - node[i - k]);
    }
  }
  std::vector<Precise> power{difference[n]};
  for (std::size_t k = n; k-- > 0;) {
    power.insert(power.begin(), Precise(0));
    for (std::size_t i = 0; i + 1 < power.size(); ++i) power[i] -= node[k] * power[i + 1];
    power[0] += difference[k];
  }
  std::vector<double> bernstein;
  for (std::size_t j = 0; j <= n; ++j) {
    Precise sum = 0, ratio = 1;  // binom(j, k) / binom(n, k)
    for (std::size_t k = 0; k <= j; ++k) {
      sum += ratio * power[k];
      if (k < j) ratio *= Precise(static_cast<int>(j - k)) / static_cast<int>(n - k);
    }
    bernstein.push_back(static_cast<double>(sum));
  }
  return bernstein;
}

/// The curve (x(s), y(s)), s from low to high, as one Bezier of this degree.
inline Bezier fittedBezier(const PreciseFunction& x, const PreciseFunction& y, const Precise& low,
                           const Precise& high, int degree) {
  const std::vector<double> xs = fittedCoefficients(x, low, high, degree);
  const std::vector<double> ys = fittedCoefficients(y, low, high, degree);
  Bezier curve;
  for (std::size_t i = 0; i < xs.size(); ++i) curve.points.emplace_back(xs[i], ys[i]);
  return curve;
}

}  // namespace flatland::test
