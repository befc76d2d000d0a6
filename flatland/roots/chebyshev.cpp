// SPDX-License-Identifier: MIT
#include "flatland/roots/chebyshev.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <queue>

namespace flatland {

namespace {

constexpr int kCoarseDegree = 16, kDegree = 32;

// Rounding of a value relative to its size; the interpolant magnifies it by less than 4 (the
// Lebesgue constant at degree 32).
constexpr double kRounding = 0x1p-50;
constexpr double kLebesgue = 4.0;

// Coefficients have converged where the last ones are below this part of the largest value.
constexpr double kConverged = 0x1p-47;

// A tail this many times larger than seen covers what lies beyond the last coefficients.
constexpr double kTailSafety = 4.0;

// Values below this part of their size cannot be told from zero: jets of formulas lose some bits.
constexpr double kZero = 0x1p-43;

// Pieces narrower than this are not halved.
constexpr double kMinWidth = 0x1p-40;

// Sizes below this have lost bits to underflow: nothing is known there.
constexpr double kSmallestSize = 1e-290;

// Places off the grid at which a proxy must agree with its function, in [0, 1].
constexpr std::array<double, 4> kChecks = {0.03713, 0.29387, 0.61803, 0.88629};

// Where to halve, in order of preference.
constexpr std::array<double, 7> kSplits = {0.5,     0.453125, 0.546875, 0.40625,
                                           0.59375, 0.34375,  0.65625};

/// cos(pi j (k + 1/2) / n) for row j, column k.
const std::vector<double>& cosines(int n) {
  const auto make = [](int count) {
    std::vector<double> table;
    for (int j = 0; j < count; ++j) {
      for (int k = 0; k < count; ++k) {
        // Reduced exactly before the cosine is taken.
        const int quarter = j * (2 * k + 1) % (4 * count);
        table.push_back(std::cos(std::numbers::pi * quarter / (2.0 * count)));
      }
    }
    return table;
  };
  static const std::vector<double> coarse = make(kCoarseDegree + 1), fine = make(kDegree + 1);
  if (n == kCoarseDegree + 1) return coarse;
  if (n == kDegree + 1) return fine;
  thread_local std::vector<double> other;
  other = make(n);
  return other;
}

double node(int k, int n) { return std::cos(std::numbers::pi * (k + 0.5) / n); }

std::vector<double> coefficientsOf(const std::vector<double>& values) {
  const int n = static_cast<int>(values.size());
  const std::vector<double>& cosine = cosines(n);
  std::vector<double> c(values.size(), 0.0);
  std::size_t at = 0;
  for (double& sum : c) {
    for (const double value : values) sum += value * cosine[at++];
    sum *= 2.0 / n;
  }
  c[0] *= 0.5;
  return c;
}

double clenshaw(const std::vector<double>& c, double x) {
  double b1 = 0.0, b2 = 0.0;
  for (std::size_t j = c.size(); j-- > 1;) {
    const double b0 = 2.0 * x * b1 - b2 + c[j];
    b2 = b1;
    b1 = b0;
  }
  return x * b1 - b2 + c[0];
}

/// Scaled Bernstein coefficients of T_0 .. T_degree on [0, 1], all raised to that degree; integers.
std::vector<std::vector<Bounded>> chebyshevRows(int degree) {
  std::vector<Bernstein> t{Bernstein::fromDoubles({1.0}), Bernstein::fromDoubles({-1.0, 1.0})};
  const Bernstein twoX = Bernstein::fromDoubles({-2.0, 2.0});
  for (std::size_t j = 2; j <= static_cast<std::size_t>(degree); ++j) {
    t.push_back(twoX * t[j - 1] - t[j - 2]);
  }
  std::vector<std::vector<Bounded>> rows;
  for (int j = 0; j <= degree; ++j) {
    rows.push_back(elevatedTo(t[static_cast<std::size_t>(j)], degree).scaled());
  }
  return rows;
}

// Proxies are cut to one of these degrees.
constexpr std::array<int, 7> kTableDegrees = {1, 4, 8, 12, 16, 24, 32};

const std::vector<std::vector<Bounded>>& rowsOf(int degree) {
  static const std::array<std::vector<std::vector<Bounded>>, kTableDegrees.size()> tables = [] {
    std::array<std::vector<std::vector<Bounded>>, kTableDegrees.size()> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = chebyshevRows(kTableDegrees[i]);
    return all;
  }();
  const auto found = std::find(kTableDegrees.begin(), kTableDegrees.end(), degree);
  return tables[static_cast<std::size_t>(found - kTableDegrees.begin())];
}

int tableDegree(std::size_t degree) {
  return *std::lower_bound(kTableDegrees.begin(), kTableDegrees.end(), static_cast<int>(degree));
}

// Sets the first coefficients that cannot be told from zero to exactly zero, the very first in any
// case. A difference of at most `error` everywhere can be this much in a coefficient: what it is in
// the Chebyshev polynomial of that degree, the largest of all (scaled form, so an integer).
void snapStart(std::vector<Bounded>& scaled, double error) {
  const std::vector<Bounded>& largest = rowsOf(static_cast<int>(scaled.size()) - 1).back();
  for (std::size_t i = 0; i + 1 < scaled.size(); ++i) {
    if (i > 0 && std::abs(scaled[i].hi) > error * std::abs(largest[i].hi)) break;
    scaled[i] = {};
  }
}

/// A function on a stretch of [0, 1] as a polynomial, and how well.
struct Proxy {
  std::vector<double> c;
  double largestValue = 0.0, largestSize = 0.0;
  double error = 0.0;  // absolute
  bool finite = true, converged = false;
};

class ProxyFinder {
 public:
  ProxyFinder(const MeasuredFunction& f, KnownEnds ends, const ProxyBudget& budget)
      : function_(f), budget_(budget) {
    const auto isZero = [](const Measured& m) { return !(std::abs(m.value) > kZero * m.size); };
    const Measured start = f_(0.0), finish = f_(1.0);
    zeroAtStart_ = ends.zeroAtStart || (std::isfinite(start.value) && isZero(start));
    zeroAtFinish_ = ends.zeroAtFinish || (std::isfinite(finish.value) && isZero(finish));
  }

  ProxyRoots run() {
    for (int i = 0; i < budget_.probes; ++i) {
      const double t = (i + 0.5) / budget_.probes;
      probes_.push_back({t, f_(t)});
    }
    const Proxy whole = proxyOn(0.0, 1.0, kDegree);
    if (allZero_) {
      result_.roots.identicallyZero = true;
      result_.pieces.push_back({0.0, 1.0, 0, kZero});
      return std::move(result_);
    }
    process(0.0, 1.0, whole);
    while (!open_.empty()) {
      const Stretch next = open_.top();
      open_.pop();
      process(next.low, next.high, proxyOn(next.low, next.high));
    }
    finish();
    return std::move(result_);
  }

 private:
  // Widest first: a place that takes all there is to spend, a jump say, must not leave the rest of
  // the function unseen.
  struct Stretch {
    double low, high;
    bool operator<(const Stretch& other) const {
      const double own = high - low, others = other.high - other.low;
      return own != others ? own < others : low > other.low;
    }
  };

  Measured f_(double t) const {
    ++evaluations_;
    return function_(t);
  }

  Proxy proxyOn(double low, double high, int degree) {
    const int n = degree + 1;
    const double middle = 0.5 * (low + high), half = 0.5 * (high - low);
    Proxy proxy;
    std::vector<double> values;
    bool zero = true;
    const auto take = [&](const Measured& m) {
      proxy.finite = proxy.finite && std::isfinite(m.value) && std::isfinite(m.size);
      proxy.largestValue = std::max(proxy.largestValue, std::abs(m.value));
      proxy.largestSize = std::max(proxy.largestSize, m.size);
      zero = zero && !(std::abs(m.value) > kZero * m.size);
    };
    for (int k = 0; k < n; ++k) {
      const Measured m = f_(middle + half * node(k, n));
      take(m);
      values.push_back(m.value);
    }
    if (!proxy.finite) {
      allZero_ = false;
      return proxy;
    }
    proxy.c = coefficientsOf(values);
    double tail = 0.0;
    for (std::size_t j = proxy.c.size() - 3; j < proxy.c.size(); ++j) {
      tail = std::max(tail, std::abs(proxy.c[j]));
    }
    const double rounding = kRounding * proxy.largestSize;
    proxy.converged = tail <= std::max(kConverged * proxy.largestValue, rounding);
    proxy.error = kTailSafety * tail + kLebesgue * rounding;
    for (const double at : kChecks) {
      const double x = 2.0 * at - 1.0;
      const Measured m = f_(middle + half * x);
      take(m);
      if (!proxy.finite) return proxy;
      const double off = std::abs(m.value - clenshaw(proxy.c, x));
      if (off > proxy.error) {
        proxy.converged = proxy.converged && off <= 16.0 * proxy.error;
        proxy.error = kTailSafety * off;
      }
    }
    checkAtProbes(low, high, proxy, zero);
    allZero_ = zero && proxy.finite;
    return proxy;
  }

  // Compares with what was seen beforehand in [low, high].
  void checkAtProbes(double low, double high, Proxy& proxy, bool& zero) const {
    auto probe = std::lower_bound(probes_.begin(), probes_.end(), low,
                                  [](const Probe& p, double t) { return p.t < t; });
    for (; probe != probes_.end() && probe->t <= high; ++probe) {
      const Measured& m = probe->seen;
      zero = zero && !(std::abs(m.value) > kZero * m.size);
      if (!std::isfinite(m.value) || !std::isfinite(m.size)) {
        proxy.finite = false;
        return;
      }
      const double off =
          std::abs(m.value - clenshaw(proxy.c, (2.0 * probe->t - low - high) / (high - low)));
      const double rounding = kLebesgue * kRounding * m.size;
      if (off <= std::max(proxy.error, rounding)) continue;
      proxy.converged = proxy.converged && off <= 16.0 * proxy.error;
      proxy.error = kTailSafety * off;
      proxy.largestSize = std::max(proxy.largestSize, m.size);
      proxy.largestValue = std::max(proxy.largestValue, std::abs(m.value));
    }
  }

  // The better of two degrees.
  Proxy proxyOn(double low, double high) {
    Proxy proxy = proxyOn(low, high, kCoarseDegree);
    return proxy.converged ? proxy : proxyOn(low, high, kDegree);
  }

  void process(double low, double high, const Proxy& proxy) {
    const bool last = high - low <= kMinWidth || evaluations_ >= budget_.evaluations;
    const bool underflows = proxy.finite && !(proxy.largestSize >= kSmallestSize);
    if (!underflows && (!proxy.finite || (!proxy.converged && !isNoise(low, high, proxy)))) {
      if (!last) return divide(low, high);
    }
    if (!proxy.finite) return giveUp(low, high, 0, 1.0);
    if (!(proxy.largestSize >= kSmallestSize)) {
      return giveUp(low, high, static_cast<int>(proxy.c.size()) - 1, 1.0);
    }
    // Nothing but error: halving would only multiply the question.
    const double blur = proxy.error / proxy.largestSize;
    if (proxy.largestValue <= 2.0 * proxy.error && !touchesZeroEnd(low, high)) {
      return giveUp(low, high, static_cast<int>(proxy.c.size()) - 1, blur);
    }
    double error = proxy.error;
    const std::vector<double> c = trimmed(proxy.c, error);
    const Roots found = isolateRoots(withZeroEnds(bernsteinOf(c, error), error, low, high));
    if (!found.resolved() && !last) return divide(low, high);
    result_.pieces.push_back(
        {low, high, static_cast<int>(c.size()) - 1, error / proxy.largestSize});
    collect(found, low, high, error);
  }

  bool touchesZeroEnd(double low, double high) const {
    return (low == 0.0 && zeroAtStart_) || (high == 1.0 && zeroAtFinish_);
  }

  // Where halves do no better than the whole, the tail is noise of the function.
  bool isNoise(double low, double high, const Proxy& proxy) {
    if (proxy.error > 1e-9 * proxy.largestSize) return false;
    const double middle = 0.5 * (low + high);
    const Proxy a = proxyOn(low, middle, kDegree), b = proxyOn(middle, high, kDegree);
    return a.finite && b.finite && std::max(a.error, b.error) > 0.1 * proxy.error;
  }

  void divide(double low, double high) {
    double best = 0.5, largest = -1.0;
    for (const double split : kSplits) {
      const Measured m = f_(low + split * (high - low));
      const double clear = std::isfinite(m.value) && m.size > 0 ? std::abs(m.value) / m.size : 0.0;
      if (clear > largest) best = split, largest = clear;
      if (clear > 1e-3) break;  // far from any root
    }
    const double middle = low + best * (high - low);
    open_.push({low, middle});
    open_.push({middle, high});
  }

  void giveUp(double low, double high, int degree, double blur) {
    result_.pieces.push_back({low, high, degree, blur});
    result_.roots.unresolved.push_back({low, high});
  }

  // Without the coefficients that are below the error anyway; what they add up to goes into it.
  static std::vector<double> trimmed(const std::vector<double>& c, double& error) {
    std::size_t degree = c.size() - 1;
    double dropped = 0.0;
    while (degree > 1 && dropped + std::abs(c[degree]) <= 0.25 * error) {
      dropped += std::abs(c[degree--]);
    }
    const auto size = static_cast<std::size_t>(tableDegree(degree)) + 1;
    std::vector<double> kept(c.begin(),
                             c.begin() + static_cast<std::ptrdiff_t>(std::min(size, c.size())));
    kept.resize(size, 0.0);
    error += dropped;
    return kept;
  }

  // The function is known to vanish at an end: so must the polynomial.
  Bernstein withZeroEnds(const Bernstein& p, double error, double low, double high) const {
    const bool start = low == 0.0 && zeroAtStart_, finish = high == 1.0 && zeroAtFinish_;
    if (!start && !finish) return p;
    std::vector<Bounded> scaled = p.scaled();
    if (start) snapStart(scaled, error);
    if (finish) {
      std::reverse(scaled.begin(), scaled.end());
      snapStart(scaled, error);
      std::reverse(scaled.begin(), scaled.end());
    }
    return Bernstein::fromScaled(std::move(scaled));
  }

  void collect(const Roots& found, double low, double high, double error) {
    const auto global = [&](double s) { return s == 1.0 ? high : low + s * (high - low); };
    for (Root root : found.roots) {
      root.low = global(root.low);
      root.high = global(root.high);
      root.t = global(root.t);
      if (root.low < root.high && !polish(root, error)) {
        result_.roots.unresolved.push_back({root.low, root.high});
        continue;
      }
      result_.roots.roots.push_back(root);
    }
    for (const RootInterval& open : found.unresolved) {
      result_.roots.unresolved.push_back({global(open.low), global(open.high)});
    }
    if (found.identicallyZero) result_.roots.unresolved.push_back({low, high});
  }

  // Halves the bracket by signs of the function itself, to adjacent doubles: Illinois, with a plain
  // halving whenever that does not halve. False if the function contradicts the polynomial: its own
  // sign at an end of the bracket is the other one, by more than both are blurred.
  bool polish(Root& root, double error) const {
    double a = root.low, b = root.high;
    const int sign = root.signBefore;
    const Measured ma = f_(a), mb = f_(b);
    double fa = ma.value * sign, fb = mb.value * sign;
    if (root.isCrossing() && b - a > 8.0 * 0x1p-53) {
      const auto clear = [error](const Measured& m) {
        return 64.0 * std::max(error, kZero * m.size);
      };
      if (fa < -clear(ma) || fb > clear(mb)) return false;
    }
    if (!(fa > 0.0 && fb < 0.0)) return true;  // the bracket is at rounding already
    bool halve = false;
    while (std::nextafter(a, 2.0) < b) {
      double t = halve ? 0.5 * (a + b) : a + (b - a) * (fa / (fa - fb));
      if (!(t > a && t < b)) t = 0.5 * (a + b);
      if (!(t > a && t < b)) break;
      const double before = b - a, ft = f_(t).value * root.signBefore;
      if (ft == 0.0) {
        root.t = root.low = root.high = t;
        return true;
      }
      (ft > 0.0 ? a : b) = t;
      (ft > 0.0 ? fa : fb) = ft;
      halve = !halve && b - a > 0.5 * before;
    }
    root.low = a, root.high = b;
    root.t = fa < -fb ? a : b;
    return true;
  }

  // One near-double root can leave its trace on both sides of a cut: say it once.
  void finish() {
    auto& open = result_.roots.unresolved;
    std::sort(open.begin(), open.end(),
              [](const RootInterval& a, const RootInterval& b) { return a.low < b.low; });
    std::vector<RootInterval> merged;
    for (const RootInterval& interval : open) {
      if (!merged.empty() && merged.back().high >= interval.low) {
        merged.back().high = std::max(merged.back().high, interval.high);
      } else {
        merged.push_back(interval);
      }
    }
    open = std::move(merged);
    std::sort(result_.roots.roots.begin(), result_.roots.roots.end(),
              [](const Root& a, const Root& b) { return a.t < b.t; });
    std::sort(result_.pieces.begin(), result_.pieces.end(),
              [](const ProxyPiece& a, const ProxyPiece& b) { return a.low < b.low; });
    result_.evaluations = evaluations_;
  }

  const MeasuredFunction& function_;
  const ProxyBudget budget_;
  mutable int evaluations_ = 0;
  bool zeroAtStart_ = false, zeroAtFinish_ = false, allZero_ = false;
  struct Probe {
    double t;
    Measured seen;
  };
  std::vector<Probe> probes_;  // ascending
  std::priority_queue<Stretch> open_;
  ProxyRoots result_;
};

}  // namespace

double ProxyRoots::errorBound() const {
  double bound = 0.0;
  for (const ProxyPiece& piece : pieces) {
    const bool unknown = std::any_of(
        roots.unresolved.begin(), roots.unresolved.end(),
        [&](const RootInterval& open) { return open.low <= piece.low && open.high >= piece.high; });
    if (!unknown) bound = std::max(bound, piece.error);
  }
  return bound;
}

ProxyRoots proxyRoots(const MeasuredFunction& f, KnownEnds ends, const ProxyBudget& budget) {
  return ProxyFinder(f, ends, budget).run();
}

std::vector<double> chebyshevCoefficients(const std::function<double(double)>& f, double low,
                                          double high, int degree) {
  std::vector<double> values;
  for (int k = 0; k <= degree; ++k) {
    values.push_back(f(0.5 * (low + high) + 0.5 * (high - low) * node(k, degree + 1)));
  }
  return coefficientsOf(values);
}

Bernstein bernsteinOf(const std::vector<double>& chebyshev, double error) {
  assert(!chebyshev.empty() && chebyshev.size() <= kDegree + 1);
  const int degree = tableDegree(chebyshev.size() - 1);
  const auto& rows = rowsOf(degree);
  std::vector<Bounded> scaled(static_cast<std::size_t>(degree) + 1);
  for (std::size_t j = 0; j < chebyshev.size(); ++j) {
    for (std::size_t i = 0; i < scaled.size(); ++i) {
      scaled[i] = scaled[i] + times(rows[j][i], chebyshev[j]);
    }
  }
  // Row 0 is the constant 1: the binomials, by which a coefficient's error scales.
  for (std::size_t i = 0; i < scaled.size(); ++i) scaled[i].error += error * rows[0][i].hi;
  return Bernstein::fromScaled(std::move(scaled));
}

}  // namespace flatland
