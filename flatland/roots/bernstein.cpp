// SPDX-License-Identifier: MIT
#include "flatland/roots/bernstein.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <numeric>

namespace flatland {

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// Row n of Pascal's triangle by addition: exact while it fits in 106 bits (n up to about 108),
// bounded beyond.
std::vector<Bounded> pascalRow(int n) {
  std::vector<Bounded> row{Bounded(1.0)};
  for (int m = 1; m <= n; ++m) {
    row.push_back(Bounded(1.0));
    for (int i = m - 1; i > 0; --i) row[index(i)] = row[index(i)] + row[index(i - 1)];
  }
  return row;
}

// Degrees that occur for curves of up to about 8 control points in perspective come from a table.
constexpr int kTableSize = 80;

template <class Row>
const std::vector<Bounded>& tabulated(int n, std::vector<Bounded>& storage, Row rowOf) {
  static const std::vector<std::vector<Bounded>> table = [&] {
    std::vector<std::vector<Bounded>> rows;
    for (int m = 0; m < kTableSize; ++m) rows.push_back(rowOf(m));
    return rows;
  }();
  if (n < kTableSize) return table[index(n)];
  storage = rowOf(n);
  return storage;
}

const std::vector<Bounded>& binomials(int n, std::vector<Bounded>& storage) {
  return tabulated(n, storage, [](int m) { return pascalRow(m); });
}

// The least common multiple of row n of Pascal's triangle, lcm(1 .. n + 1) / (n + 1), over each of
// its entries: integers. Empty where the multiple exceeds 2^53.
const std::vector<Bounded>& exactDivisors(int n, std::vector<Bounded>& storage) {
  return tabulated(n, storage, [](int m) {
    constexpr int kLargestDegree = 41;
    std::vector<Bounded> row;
    if (m > kLargestDegree) return row;
    std::int64_t multiple = 1;
    for (std::int64_t i = 2; i <= m + 1; ++i) multiple = std::lcm(multiple, i);
    multiple /= m + 1;
    for (const Bounded& binomial : pascalRow(m)) {
      row.push_back(
          Bounded(static_cast<double>(multiple / static_cast<std::int64_t>(binomial.hi))));
    }
    return row;
  });
}

// a / b for b > 0.
Bounded quotient(const Bounded& a, const Bounded& b) {
  if (b.lo == 0.0 && b.error == 0.0) return dividedBy(a, b.hi);
  if (a.isExactZero()) return {};
  const double q1 = a.hi / b.hi;
  const Bounded rest = Bounded(a.hi, a.lo, 0.0) - Bounded(q1) * Bounded(b.hi, b.lo, 0.0);
  const double q2 = rest.hi / b.hi;
  const auto r = detail::quickTwoSum(q1, q2);
  const double magnitude = std::abs(q1);
  // The remainder is good to 2^-102 of a, its quotient is rounded once: below 2^-100 in all.
  return {r.high, r.low,
          (a.error / b.hi + magnitude * (b.error / b.hi) + magnitude * 0x1p-100) * (1.0 + 0x1p-40)};
}

}  // namespace

Bernstein::Bernstein(const std::vector<Bounded>& coefficients) {
  std::vector<Bounded> storage;
  const auto& binomial = binomials(static_cast<int>(coefficients.size()) - 1, storage);
  s_.reserve(coefficients.size());
  for (std::size_t i = 0; i < coefficients.size(); ++i) s_.push_back(binomial[i] * coefficients[i]);
}

Bernstein Bernstein::fromScaled(std::vector<Bounded> scaled) {
  Bernstein p;
  p.s_ = std::move(scaled);
  return p;
}

Bernstein Bernstein::fromDoubles(const std::vector<double>& coefficients) {
  return Bernstein(std::vector<Bounded>(coefficients.begin(), coefficients.end()));
}

std::vector<Bounded> Bernstein::coefficients() const {
  std::vector<Bounded> storage, c;
  const auto& binomial = binomials(degree(), storage);
  c.reserve(s_.size());
  for (std::size_t i = 0; i < s_.size(); ++i) {
    c.push_back(i == 0 || i + 1 == s_.size() ? s_[i] : quotient(s_[i], binomial[i]));
  }
  return c;
}

std::vector<Bounded> Bernstein::proportionalCoefficients() const {
  std::vector<Bounded> storage;
  const auto& factor = exactDivisors(degree(), storage);
  if (factor.empty()) return coefficients();
  std::vector<Bounded> c;
  c.reserve(s_.size());
  for (std::size_t i = 0; i < s_.size(); ++i) c.push_back(times(s_[i], factor[i].hi));
  return c;
}

bool Bernstein::isZero() const {
  return std::all_of(s_.begin(), s_.end(), [](const Bounded& s) { return s.certainSign() == 0; });
}

Bounded Bernstein::at(double t) const {
  assert(!s_.empty());
  const auto complement = detail::twoSum(1.0, -t);
  const Bounded rest(complement.high, complement.low, 0.0);  // 1 - t, exactly
  Bounded power(1.0), sum = s_[0];
  for (std::size_t i = 1; i < s_.size(); ++i) {
    power = times(power, t);
    sum = sum * rest + power * s_[i];
  }
  return sum;
}

std::pair<std::vector<Bounded>, std::vector<Bounded>> splitCoefficients(
    const std::vector<Bounded>& coefficients, double t) {
  std::vector<Bounded> b = coefficients;
  const std::size_t size = b.size();
  std::vector<Bounded> low(size), high(size);
  const auto complement = detail::twoSum(1.0, -t);
  const Bounded rest(complement.high, complement.low, 0.0);
  const bool half = t == 0.5;
  for (std::size_t count = size; count > 0; --count) {
    low[size - count] = b[0];
    high[count - 1] = b[count - 1];
    for (std::size_t i = 0; i + 1 < count; ++i) {
      b[i] = half ? halved(b[i] + b[i + 1]) : rest * b[i] + times(b[i + 1], t);
    }
  }
  return {std::move(low), std::move(high)};
}

std::pair<Bernstein, Bernstein> Bernstein::split(double t) const {
  auto [low, high] = splitCoefficients(coefficients(), t);
  return {Bernstein(low), Bernstein(high)};
}

Bernstein Bernstein::reversed() const {
  return fromScaled(std::vector<Bounded>(s_.rbegin(), s_.rend()));
}

Bernstein Bernstein::dividedByT(int m) const {
  // p = t q: the scaled coefficients of q are those of p but for the first.
  assert(0 <= m && m <= degree());
  return fromScaled(std::vector<Bounded>(s_.begin() + m, s_.end()));
}

Bernstein Bernstein::dividedByOneMinusT(int m) const {
  assert(0 <= m && m <= degree());
  return fromScaled(std::vector<Bounded>(s_.begin(), s_.end() - m));
}

Bernstein elevatedTo(const Bernstein& p, int degree) {
  assert(degree >= p.degree());
  if (degree == p.degree()) return p;
  std::vector<Bounded> storage;
  return p * Bernstein::fromScaled(binomials(degree - p.degree(), storage));
}

Bernstein operator+(const Bernstein& p, const Bernstein& q) {
  if (p.degree() < q.degree()) return elevatedTo(p, q.degree()) + q;
  if (q.degree() < p.degree()) return p + elevatedTo(q, p.degree());
  std::vector<Bounded> sum = p.scaled();
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = sum[i] + q.scaled()[i];
  return Bernstein::fromScaled(std::move(sum));
}

Bernstein operator-(const Bernstein& p) {
  std::vector<Bounded> negated = p.scaled();
  for (Bounded& s : negated) s = -s;
  return Bernstein::fromScaled(std::move(negated));
}

Bernstein operator-(const Bernstein& p, const Bernstein& q) { return p + (-q); }

Bernstein operator*(const Bounded& factor, const Bernstein& p) {
  std::vector<Bounded> multiplied = p.scaled();
  for (Bounded& s : multiplied) s = factor * s;
  return Bernstein::fromScaled(std::move(multiplied));
}

Bernstein operator*(const Bernstein& p, const Bernstein& q) {
  const auto &a = p.scaled(), &b = q.scaled();
  std::vector<Bounded> product(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) product[i + j] = product[i + j] + a[i] * b[j];
  }
  return Bernstein::fromScaled(std::move(product));
}

Bernstein derivative(const Bernstein& p) {
  const int n = p.degree();
  if (n == 0) return Bernstein::fromScaled({Bounded()});
  // binom(n - 1, i) n (c_(i+1) - c_i) in terms of s
  const auto& s = p.scaled();
  std::vector<Bounded> d;
  d.reserve(index(n));
  for (int i = 0; i < n; ++i)
    d.push_back(times(s[index(i) + 1], i + 1) - times(s[index(i)], n - i));
  return Bernstein::fromScaled(std::move(d));
}

Bernstein degreeTimesWronskian(const Bernstein& p, const Bernstein& q) {
  // With p0, p1 the first and last n coefficients, p = (1 - t) p0 + t p1 and p' = n (p1 - p0);
  // inserted, all but two products cancel: p' q - p q' = n (p1 q0 - p0 q1). In scaled form n p0 and
  // n p1 are integer multiples of s.
  assert(p.degree() == q.degree());
  const int n = p.degree();
  if (n == 0) return Bernstein::fromScaled({Bounded()});
  const auto start = [n](const Bernstein& f) {
    std::vector<Bounded> part;
    for (int i = 0; i < n; ++i) part.push_back(times(f.scaled()[index(i)], n - i));
    return Bernstein::fromScaled(std::move(part));
  };
  const auto end = [n](const Bernstein& f) {
    std::vector<Bounded> part;
    for (int i = 0; i < n; ++i) part.push_back(times(f.scaled()[index(i) + 1], i + 1));
    return Bernstein::fromScaled(std::move(part));
  };
  return end(p) * start(q) - start(p) * end(q);
}

}  // namespace flatland
