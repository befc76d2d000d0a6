// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <functional>

namespace flatland::test {

/// 50 decimal digits: the arithmetic of the references.
using Precise = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_50::backend_type,
                                              boost::multiprecision::et_off>;

/// f'(0) by the symmetric six-point difference at step h: error of order h^6 against 1e-50 / h of
/// rounding, so h = 1e-7 leaves about 1e-40.
inline Precise derivativeAtZero(const std::function<Precise(const Precise&)>& f) {
  const Precise h = Precise("1e-7");
  return (45 * (f(h) - f(-h)) - 9 * (f(2 * h) - f(-2 * h)) + (f(3 * h) - f(-3 * h))) / (60 * h);
}

}  // namespace flatland::test
