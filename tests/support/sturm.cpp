// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/sturm.h"

#include <cassert>

namespace flatland::test {

namespace {

ExactPolynomial divided(const ExactPolynomial& p, const Integer& divisor) {
  std::vector<Integer> a = p.coefficients();
  for (Integer& c : a) {
    assert((c % divisor).is_zero());
    c /= divisor;
  }
  return ExactPolynomial(std::move(a));
}

ExactPolynomial primitive(const ExactPolynomial& p) {
  Integer content = 0;
  for (const Integer& c : p.coefficients()) content = gcd(content, c);
  return divided(p, content);
}

const Integer& leading(const ExactPolynomial& p) { return p[p.degree()]; }

// |lc(b)|^(deg a - deg b + 1) a mod b: a positive multiple of the remainder over the rationals.
// The quotient by the same factor goes to `quotient` if asked for.
ExactPolynomial remainder(const ExactPolynomial& a, const ExactPolynomial& b,
                          std::vector<Integer>* quotient = nullptr) {
  const int steps = a.degree() - b.degree() + 1;
  const Integer factor = abs(leading(b));
  const int sign = leading(b).sign();
  std::vector<Integer> r = a.coefficients();
  if (quotient) quotient->assign(static_cast<std::size_t>(steps), Integer(0));
  for (int k = steps - 1; k >= 0; --k) {
    const Integer top = sign * r[static_cast<std::size_t>(k + b.degree())];
    for (Integer& c : r) c *= factor;
    if (quotient) {
      for (Integer& c : *quotient) c *= factor;
      (*quotient)[static_cast<std::size_t>(k)] += top;
    }
    for (int i = 0; i <= b.degree(); ++i) r[static_cast<std::size_t>(i + k)] -= top * b[i];
    r.pop_back();
  }
  return ExactPolynomial(std::move(r));
}

// p, p', and the negated remainders up to positive factors, down to the last that is not zero. The
// factors divided out are the subresultant ones, which are known without a gcd.
std::vector<ExactPolynomial> sturmChain(const ExactPolynomial& p) {
  std::vector<ExactPolynomial> chain{p};
  if (p.degree() == 0) return chain;
  chain.push_back(p.derivative());
  Integer psi = 1, beta = 1;
  while (chain.back().degree() > 0) {
    const ExactPolynomial &a = chain[chain.size() - 2], &b = chain.back();
    const int step = a.degree() - b.degree();
    if (chain.size() > 2) beta = abs(leading(a)) * pow(psi, static_cast<unsigned>(step));
    const ExactPolynomial r = remainder(a, b);
    if (r.isZero()) break;
    const Integer head = abs(leading(b));
    psi = step == 0   ? psi
          : step == 1 ? head
                      : Integer(pow(head, static_cast<unsigned>(step)) /
                                pow(psi, static_cast<unsigned>(step - 1)));
    chain.push_back(divided(Integer(-1) * r, beta));
  }
  return chain;
}

}  // namespace

Sturm::Sturm(const ExactPolynomial& p) {
  assert(!p.isZero());
  chain_ = sturmChain(primitive(p));
  if (chain_.back().degree() == 0) return;
  const ExactPolynomial common = primitive(chain_.back());
  repeated_ = std::make_unique<Sturm>(common);
  std::vector<Integer> quotient;
  [[maybe_unused]] const ExactPolynomial rest = remainder(chain_.front(), common, &quotient);
  assert(rest.isZero());
  chain_ = sturmChain(primitive(ExactPolynomial(std::move(quotient))));
}

int Sturm::variations(double t) const {
  int count = 0, previous = 0;
  for (const ExactPolynomial& p : chain_) {
    const int sign = p.signAt(t);
    if (sign == 0) continue;
    if (previous * sign < 0) ++count;
    previous = sign;
  }
  return count;
}

int Sturm::distinctHalfOpen(double low, double high) const {
  return variations(low) - variations(high);
}

int Sturm::distinct(double low, double high) const {
  const int atLow = chain_.front().signAt(low) == 0 ? 1 : 0;
  return atLow + (low < high ? distinctHalfOpen(low, high) : 0);
}

int Sturm::withMultiplicity(double low, double high) const {
  return distinct(low, high) + (repeated_ ? repeated_->withMultiplicity(low, high) : 0);
}

}  // namespace flatland::test
