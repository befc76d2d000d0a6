// SPDX-License-Identifier: GPL-3.0-or-later
// Root isolation against exact Sturm sequences, on random and adversarial polynomials of the
// degrees that curves up to degree 8 give rise to.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "flatland/roots/isolate.h"
#include "tests/support/seed.h"
#include "tests/support/sturm.h"

namespace flatland::test {
namespace {

using Coefficients = std::vector<double>;

struct Totals {
  long polynomials = 0, roots = 0, multiple = 0, clusters = 0, unresolved = 0, zero = 0;
  int highestDegree = 0;
};

// A bracket or unresolved interval is either this narrow, or the polynomial is below 2^-kSmallBits
// of its largest coefficient all across it: no arithmetic of about 100 bits can do better, minus
// what a degree of up to 55 costs.
constexpr double kNarrow = 0x1p-40;
constexpr double kSmallBits = 80.0;

double log2Abs(double x) { return std::log2(std::abs(x)); }

bool indistinct(const ExactPolynomial& exact, double log2Scale, double low, double high) {
  for (int i = 0; i <= 8; ++i) {
    if (exact.log2AbsAt(low + (high - low) * i / 8) > log2Scale - kSmallBits) return false;
  }
  return true;
}

// Roots in the open interval, or at the point.
struct Count {
  int distinct, withMultiplicity;
};
Count countIn(const Sturm& sturm, double low, double high) {
  Count c{sturm.distinct(low, high), sturm.withMultiplicity(low, high)};
  if (low == high) return c;
  for (const double t : {low, high}) {
    c.distinct -= sturm.distinct(t, t);
    c.withMultiplicity -= sturm.withMultiplicity(t, t);
  }
  return c;
}

// What is wrong with `found` as the answer for `exact`, empty if nothing. log2Scale is that of the
// largest Bernstein coefficient of `exact`.
std::string complaint(const ExactPolynomial& exact, double log2Scale, const Roots& found) {
  std::ostringstream bad;
  bad.precision(17);
  double end = 0.0;
  bool plain = found.unresolved.empty();
  for (std::size_t i = 0; i < found.roots.size(); ++i) {
    const Root& root = found.roots[i];
    // A bracket is open, or one point: its ends may be other roots, one double away.
    const bool point = root.low == root.high;
    if (!(root.low <= root.t && root.t <= root.high && root.low >= 0.0 && root.high <= 1.0)) {
      bad << "root " << root.t << " outside its bracket; ";
    }
    const int atLow = exact.signAt(root.low), atHigh = exact.signAt(root.high);
    if (i > 0 && (root.low < end || (point && root.low == end && found.roots[i - 1].low == end))) {
      bad << "bracket at " << root.t << " overlaps the one before; ";
    }
    end = root.high;
    const int before = root.high == 0.0 ? 0
                       : point          ? exact.signBelow(root.low)
                                        : exact.signAbove(root.low);
    const int after = root.low == 1.0 ? 0
                      : point         ? exact.signAbove(root.high)
                                      : exact.signBelow(root.high);
    if (root.signBefore != before || root.signAfter != after) {
      bad << "signs at " << root.t << " are " << before << ' ' << after << "; ";
    }
    if (root.multiplicity != 1 || (point ? atLow != 0 : atLow * atHigh >= 0)) plain = false;
    if (root.high - root.low > kNarrow && !indistinct(exact, log2Scale, root.low, root.high)) {
      bad << "wide bracket at " << root.t << "; ";
    }
    if (point && root.multiplicity == 1 && exact.derivative().signAt(root.low) == 0) plain = false;
  }
  end = -1.0;
  for (const RootInterval& open : found.unresolved) {
    if (!(open.low <= open.high) || open.low < end) bad << "unresolved intervals out of order; ";
    end = open.high;
    for (const Root& root : found.roots) {
      if (root.low < open.high && open.low < root.high) bad << "unresolved holds a root; ";
    }
    if (open.high - open.low > kNarrow && !indistinct(exact, log2Scale, open.low, open.high)) {
      bad << "wide unresolved at " << open.low << "; ";
    }
  }

  const Sturm sturm(exact);
  const int total = sturm.distinct(0.0, 1.0);
  if (plain) {
    // Each bracket holds an odd number of roots; if their count is the total, each holds one.
    if (total != static_cast<int>(found.roots.size())) {
      bad << total << " roots, " << found.roots.size() << " listed; ";
    }
    return bad.str();
  }

  int covered = 0;
  for (const Root& root : found.roots) {
    const auto [distinct, counted] = countIn(sturm, root.low, root.high);
    covered += distinct;
    if (root.multiplicity > 0 && (distinct != 1 || counted != root.multiplicity)) {
      bad << "at " << root.t << " " << distinct << " distinct roots, " << counted
          << " with multiplicity, stated " << root.multiplicity << "; ";
    }
    if (root.multiplicity == 0 && (counted % 2 != 1 || !root.isCrossing())) {
      bad << "cluster at " << root.t << " of " << counted << "; ";
    }
  }
  for (const RootInterval& open : found.unresolved) {
    auto [distinct, counted] = countIn(sturm, open.low, open.high);
    // A root exactly at 0 or 1 that could not be told from none belongs to the interval there, and
    // without a sign beyond it parity says nothing.
    for (const double t : {0.0, 1.0}) {
      const bool listed = std::any_of(found.roots.begin(), found.roots.end(),
                                      [t](const Root& r) { return r.low == t && r.high == t; });
      if ((open.low == t || open.high == t) && !listed) {
        distinct += sturm.distinct(t, t);
        counted = 0;
      }
    }
    covered += distinct;
    if (counted % 2 != 0) bad << "unresolved at " << open.low << " holds " << counted << "; ";
  }
  if (covered != total) bad << total << " roots, " << covered << " covered; ";
  return bad.str();
}

void check(const Bernstein& p, const ExactPolynomial& exact, double log2Scale, Totals& totals,
           const std::string& what) {
  ++totals.polynomials;
  totals.highestDegree = std::max(totals.highestDegree, p.degree());
  const Roots found = isolateRoots(p);
  if (exact.isZero() || found.identicallyZero) {
    ++totals.zero;
    EXPECT_TRUE(exact.isZero() && found.identicallyZero) << what;
    EXPECT_TRUE(found.roots.empty() && found.unresolved.empty()) << what;
    return;
  }
  for (const Root& root : found.roots) {
    ++(root.multiplicity == 0  ? totals.clusters
       : root.multiplicity > 1 ? totals.multiple
                               : totals.roots);
  }
  totals.unresolved += static_cast<long>(found.unresolved.size());
  const std::string bad = complaint(exact, log2Scale, found);
  if (bad.empty()) return;
  std::ostringstream where;
  where.precision(17);
  for (const Root& r : found.roots) {
    where << "\n  root " << r.t << " [" << r.low << ", " << r.high << "] signs " << r.signBefore
          << ' ' << r.signAfter << " multiplicity " << r.multiplicity;
  }
  for (const RootInterval& r : found.unresolved) {
    where << "\n  unresolved [" << r.low << ", " << r.high << "]";
  }
  ADD_FAILURE() << bad << what << where.str();
}

void check(const Coefficients& c, Totals& totals) {
  std::ostringstream what;
  what.precision(17);
  what << "\n  coefficients {";
  double largest = 0.0;
  for (const double x : c) {
    what << x << ", ";
    largest = std::max(largest, std::abs(x));
  }
  what << "}";
  const int shift = ExactPolynomial::shiftFor(c);
  check(Bernstein::fromDoubles(c), ExactPolynomial::fromBernstein(c, shift),
        log2Abs(largest) + shift, totals, what.str());
}

class IsolateOracle : public testing::Test {
 protected:
  IsolateOracle() {
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    random_.seed(announcedSeed(name.c_str(), 20240501));
  }
  ~IsolateOracle() override {
    std::cout << "polynomials " << totals_.polynomials << " up to degree " << totals_.highestDegree
              << ", simple roots " << totals_.roots << ", multiple " << totals_.multiple
              << ", clusters " << totals_.clusters << ", unresolved " << totals_.unresolved
              << ", identically zero " << totals_.zero << '\n';
  }

  // Mostly the low degrees, which are quick to check exactly, now and then up to `highest`.
  int someDegree(int highest = 32) {
    const int kind = uniformInt(random_, 0, 99);
    return uniformInt(random_, 1,
                      std::min(highest, kind < 80   ? 7
                                        : kind < 97 ? 12
                                        : kind < 99 ? 20
                                                    : highest));
  }

  Coefficients randomNormal(int degree) {
    Coefficients c(static_cast<std::size_t>(degree) + 1);
    for (double& x : c) x = normal(random_);
    return c;
  }

  // Bernstein coefficients, rounded to double, of the product of (t - r) over the roots times a
  // random polynomial of degree `more`.
  Coefficients withRoots(const std::vector<double>& roots, int more) {
    std::vector<long double> c;
    for (const double x : randomNormal(more)) c.push_back(x);
    for (const double r : roots) {
      const std::size_t n = c.size();  // the new degree
      std::vector<long double> next(n + 1, 0.0L);
      for (std::size_t i = 0; i <= n; ++i) {
        const auto share = static_cast<long double>(i) / static_cast<long double>(n);
        if (i > 0) next[i] += share * (1.0L - r) * c[i - 1];
        if (i < n) next[i] += (1.0L - share) * (0.0L - r) * c[i];
      }
      c = next;
    }
    return Coefficients(c.begin(), c.end());
  }

  Random random_;
  Totals totals_;
};

TEST(SturmItself, CountsKnownRoots) {
  // (t - 1/4)^3 (t - 1/2) (t - 3/4)^2 (t^2 + 1), with integer coefficients.
  const auto linear = [](int constant, int slope) {
    return ExactPolynomial({Integer(constant), Integer(slope)});
  };
  const ExactPolynomial quarter = linear(-1, 4), half = linear(-1, 2), last = linear(-3, 4);
  const ExactPolynomial p = quarter * quarter * quarter * half * last * last *
                            ExactPolynomial({Integer(1), Integer(0), Integer(1)});
  const Sturm s(p);
  EXPECT_EQ(s.distinct(0.0, 1.0), 3);
  EXPECT_EQ(s.withMultiplicity(0.0, 1.0), 6);
  EXPECT_EQ(s.distinctHalfOpen(0.25, 0.5), 1);
  EXPECT_EQ(s.distinct(0.25, 0.5), 2);
  EXPECT_EQ(s.withMultiplicity(0.25, 0.25), 3);
  EXPECT_EQ(s.withMultiplicity(0.625, 1.0), 2);
  EXPECT_EQ(s.distinct(0.5000000000000001, 0.7499999999999999), 0);
  EXPECT_EQ(p.signAbove(0.25), 1 * -p.signBelow(0.25));
  EXPECT_EQ(p.signAbove(0.75), p.signBelow(0.75));
  // t^9 (t - 1): skips degrees in the remainder sequence.
  std::vector<Integer> sparse(11);
  sparse[9] = -1;
  sparse[10] = 1;
  EXPECT_EQ(Sturm(ExactPolynomial(sparse)).withMultiplicity(0.0, 1.0), 10);
  EXPECT_EQ(Sturm(ExactPolynomial(sparse)).distinctHalfOpen(0.0, 1.0), 1);
  // Bernstein {1, -1, 1} is (1 - 2t)^2; 3/2 + its half is clear of zero.
  EXPECT_EQ(Sturm(ExactPolynomial::fromBernstein({1, -1, 1})).withMultiplicity(0.0, 1.0), 2);
  EXPECT_EQ(Sturm(ExactPolynomial::fromBernstein({1, -1, 1.0000000000000002})).distinct(0.0, 1.0),
            0);
  EXPECT_EQ(Sturm(ExactPolynomial::fromBernstein({1, -1, 0.9999999999999999})).distinct(0.0, 1.0),
            2);
}

TEST_F(IsolateOracle, RandomNormalNothingUnresolved) {
  for (int i = 0; i < 45000; ++i) check(randomNormal(someDegree()), totals_);
  EXPECT_EQ(totals_.unresolved, 0);
  EXPECT_EQ(totals_.clusters, 0);
  EXPECT_GT(totals_.roots, 30000);
}

TEST_F(IsolateOracle, HighDegreesOfPerspective) {
  for (int i = 0; i < 60; ++i) check(randomNormal(uniformInt(random_, 33, 55)), totals_);
  EXPECT_EQ(totals_.unresolved, 0);
}

TEST_F(IsolateOracle, SmallIntegers) {
  for (int i = 0; i < 30000; ++i) {
    const int range = uniformInt(random_, 1, 4);
    Coefficients c(static_cast<std::size_t>(someDegree(16)) + 1);
    for (double& x : c) x = uniformInt(random_, -range, range);
    check(c, totals_);
  }
  EXPECT_GT(totals_.multiple, 100);  // double roots and ends really occur
  EXPECT_GT(totals_.zero, 0);
}

TEST_F(IsolateOracle, ChosenRootsAndClusters) {
  for (int i = 0; i < 16000; ++i) {
    std::vector<double> roots;
    const int groups = uniformInt(random_, 1, 3);
    for (int g = 0; g < groups; ++g) {
      const double special[] = {0.0, 1.0, 0.5, 0.25, 0.4375};
      const double centre = uniformInt(random_, 0, 2) ? uniform(random_, 0.0, 1.0)
                                                      : special[uniformInt(random_, 0, 4)];
      const int count = uniformInt(random_, 1, 3);
      const double spread =
          uniformInt(random_, 0, 3) ? std::pow(10.0, -uniform(random_, 3.0, 15.0)) : 0.0;
      for (int k = 0; k < count; ++k) roots.push_back(centre + spread * k);
    }
    check(withRoots(roots, uniformInt(random_, 0, 3)), totals_);
  }
}

TEST_F(IsolateOracle, ExactMultipleRootsOnBisectionPoints) {
  // Products that fit in a double exactly: all is stated with its multiplicity, nothing unresolved.
  for (int i = 0; i < 3000; ++i) {
    ExactPolynomial p({Integer(uniformInt(random_, 1, 9))});
    const int count = uniformInt(random_, 1, 3);
    for (int k = 0; k < count; ++k) {
      const int place = uniformInt(random_, 0, 4),
                times = uniformInt(random_, 1, count == 1 ? 6 : 3);
      for (int m = 0; m < times; ++m) p = p * ExactPolynomial({Integer(-place), Integer(4)});
    }
    // To Bernstein coefficients times binomials' common multiple, in integers.
    const int n = p.degree();
    Integer multiple = 1;
    std::vector<Integer> binomial{1};
    for (int k = 1; k <= n; ++k) binomial.push_back(binomial.back() * (n - k + 1) / k);
    for (const Integer& b : binomial) multiple = lcm(multiple, b);
    Coefficients c;
    for (int j = 0; j <= n; ++j) {
      Integer sum = 0, choose = 1;
      for (int k = 0; k <= j; ++k) {
        sum += choose * p[k] * (multiple / binomial[static_cast<std::size_t>(k)]);
        choose = choose * (j - k) / (k + 1);
      }
      c.push_back(static_cast<double>(sum));
      ASSERT_EQ(Integer(c.back()), sum);
    }
    check(c, totals_);
  }
  EXPECT_EQ(totals_.unresolved, 0);
  EXPECT_EQ(totals_.clusters, 0);
  EXPECT_GT(totals_.multiple, 1000);
}

TEST_F(IsolateOracle, WilkinsonLike) {
  for (int n = 1; n <= 24; ++n) {
    for (int variant = 0; variant < 6; ++variant) {
      std::vector<double> roots;
      for (int k = 0; k <= n; ++k) {
        const double even = variant % 2 ? (k + 0.5) / (n + 1) : static_cast<double>(k) / n;
        roots.push_back(variant < 2   ? even
                        : variant < 4 ? 0.5 - 0.5 * std::cos(3.14159 * even)
                                      : even * even);
      }
      Coefficients c = withRoots(roots, 0);
      check(c, totals_);
      c[c.size() / 2] = std::nextafter(c[c.size() / 2], 2.0);
      check(c, totals_);
    }
  }
}

TEST_F(IsolateOracle, TinyAndHuge) {
  for (int i = 0; i < 6000; ++i) {
    Coefficients c = randomNormal(someDegree(10));
    if (i % 2) {
      for (double& x : c) x = std::round(x);
    }
    const double scale = std::pow(10.0, uniform(random_, -150.0, 150.0));
    for (double& x : c) x *= i % 4 < 2 ? scale : std::pow(10.0, uniform(random_, -20.0, 20.0));
    check(c, totals_);
  }
}

TEST_F(IsolateOracle, SparseAndNearlyConstant) {
  for (int i = 0; i < 9000; ++i) {
    const int degree = someDegree(14);
    Coefficients c(static_cast<std::size_t>(degree) + 1, 0.0);
    switch (i % 3) {
      case 0:  // few that are not zero
        for (int k = 0; k < 3; ++k) {
          c[static_cast<std::size_t>(uniformInt(random_, 0, degree))] = normal(random_);
        }
        break;
      case 1: {  // one value and rounding
        const double value = normal(random_);
        for (double& x : c) x = value * (1.0 + 0x1p-50 * uniformInt(random_, -4, 4));
        break;
      }
      default:  // nothing but rounding
        for (double& x : c) x = 1e-17 * uniformInt(random_, -3, 3);
        break;
    }
    check(c, totals_);
  }
}

TEST_F(IsolateOracle, NearMissesAndNearDoubles) {
  // q^2 * r moved up or down by a few units in the last place, or by 1e-20 and less in one
  // coefficient.
  for (int i = 0; i < 8000; ++i) {
    const double a = i % 5 == 0 ? 0.5 : uniform(random_, 0.0, 1.0);
    std::vector<double> roots{a, a};
    if (i % 3 == 0) roots.push_back(uniform(random_, 0.0, 1.0));
    Coefficients c = withRoots(roots, uniformInt(random_, 0, 4));
    const double lift = std::pow(10.0, -uniform(random_, 12.0, 25.0)) * (i % 2 ? 1.0 : -1.0);
    for (double& x : c) x += lift;
    check(c, totals_);
  }
}

// The polynomials of curves, built with the certified arithmetic and, independently, exactly.
TEST_F(IsolateOracle, PolynomialsOfCurves) {
  for (int i = 0; i < 3000; ++i) {
    const int n = i % 75 == 0 ? uniformInt(random_, 6, 8) : uniformInt(random_, 2, i % 8 ? 4 : 5);
    Coefficients x, y;
    const bool coarse = i % 3 == 0;  // on a grid: exact zeros, symmetric curves
    for (int k = 0; k <= n; ++k) {
      x.push_back(coarse ? uniformInt(random_, -4, 4)
                         : static_cast<double>(static_cast<float>(uniform(random_, -1, 1))));
      y.push_back(coarse ? uniformInt(random_, -4, 4)
                         : static_cast<double>(static_cast<float>(uniform(random_, -1, 1))));
    }
    Coefficients both = x;
    both.insert(both.end(), y.begin(), y.end());
    const int shift = ExactPolynomial::shiftFor(both);
    const ExactPolynomial ex = ExactPolynomial::fromBernstein(x, shift).derivative();
    const ExactPolynomial ey = ExactPolynomial::fromBernstein(y, shift).derivative();
    const ExactPolynomial ec = Integer(n - 1) * (ex * ey.derivative() - ey * ex.derivative());
    const ExactPolynomial es = ex * ex + ey * ey;
    const ExactPolynomial ev = es * ex;

    const Bernstein bx = derivative(Bernstein::fromDoubles(x)),
                    by = derivative(Bernstein::fromDoubles(y));
    const Bernstein bc = degreeTimesWronskian(by, bx), bs = bx * bx + by * by;
    const Bernstein bv = bs * bx;

    std::ostringstream what;
    what.precision(17);
    for (int k = 0; k <= n; ++k) {
      what << " (" << x[static_cast<std::size_t>(k)] << ", " << y[static_cast<std::size_t>(k)]
           << ")";
    }
    const auto scaleOf = [&](const Bernstein& p, int factors) {
      double largest = 0.0;
      for (const Bounded& c : p.coefficients()) largest = std::max(largest, std::abs(c.hi));
      return log2Abs(largest) + factors * shift;
    };
    const auto compare = [&](const Bernstein& p, const ExactPolynomial& e, int factors,
                             const char* name) {
      check(p, e, scaleOf(p, factors), totals_, std::string("\n  ") + name + " of" + what.str());
    };
    compare(bx, ex, 1, "silhouette");
    EXPECT_EQ(bx.degree(), n - 1);
    compare(bc, ec, 2, "inflection");
    EXPECT_EQ(bc.degree(), std::max(0, 2 * n - 4));
    if (n < 3) continue;
    const Bernstein ridge = derivative(bc) * bs - Bounded(1.5) * (bc * derivative(bs));
    const ExactPolynomial exactRidge =
        Integer(2) * (ec.derivative() * es) - Integer(3) * (ec * es.derivative());
    check(ridge, exactRidge, scaleOf(ridge, 4) + 1.0, totals_, "\n  ridge of" + what.str());
    EXPECT_EQ(ridge.degree(), 4 * n - 7);
    const Bernstein apparent = derivative(bc) * bv - bc * derivative(bv);
    compare(apparent, ec.derivative() * ev - ec * ev.derivative(), 5, "apparent ridge");
    EXPECT_EQ(apparent.degree(), 5 * n - 8);
  }
}

TEST(IsolateStated, EndsDoublesAndZero) {
  EXPECT_TRUE(isolateRoots(Bernstein::fromDoubles({0, 0, 0})).identicallyZero);
  EXPECT_TRUE(isolateRoots(Bernstein::fromDoubles({0})).identicallyZero);
  EXPECT_TRUE(isolateRoots(Bernstein::fromDoubles({3})).roots.empty());
  const Roots ends = isolateRoots(Bernstein::fromDoubles({0, 0, 1, -2, 0}));
  ASSERT_EQ(ends.roots.size(), 3u);
  EXPECT_EQ(ends.roots[0].t, 0.0);
  EXPECT_EQ(ends.roots[0].multiplicity, 2);
  EXPECT_EQ(ends.roots[0].signBefore, 0);
  EXPECT_EQ(ends.roots[0].signAfter, 1);
  EXPECT_EQ(ends.roots[2].multiplicity, 1);
  EXPECT_EQ(ends.roots[2].signBefore, -1);
  EXPECT_EQ(ends.roots[2].signAfter, 0);
  const Roots doubled = isolateRoots(Bernstein::fromDoubles({1, -1, 1}));
  ASSERT_EQ(doubled.roots.size(), 1u);
  EXPECT_EQ(doubled.roots[0].t, 0.5);
  EXPECT_EQ(doubled.roots[0].multiplicity, 2);
  EXPECT_FALSE(doubled.roots[0].isCrossing());
}

}  // namespace
}  // namespace flatland::test
