// SPDX-License-Identifier: MIT
#include "flatland/roots/isolate.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

namespace flatland {

namespace {

// Intervals narrower than this are not divided further: split points then still have spare bits.
constexpr double kMinWidth = 0x1p-48;

// Where to divide, in order of preference. The sign at the split must be certain; if a root sits on
// the middle, one of the others is clear of it. All are exact in 4 more bits.
constexpr double kSplits[] = {0.5,  0.4375, 0.5625, 0.375,  0.625, 0.25,
                              0.75, 0.125,  0.875,  0.0625, 0.9375};

using Coefficients = std::vector<Bounded>;  // plain Bernstein coefficients

struct Segment {
  Coefficients c;  ///< on its own [0, 1]; positive factors may have been divided out
  double low, high;
};

// The fewest and most sign variations of the coefficients, over all values within their errors.
struct Variations {
  int least, most;
};

Variations countVariations(const Coefficients& coefficients) {
  Variations v{0, 0};
  int previous = 0;  // last certain sign
  int unknown = 0;   // uncertain coefficients since then
  for (const Bounded& c : coefficients) {
    if (c.isExactZero()) continue;  // Descartes' rule passes over zeros
    const int sign = c.certainSign();
    if (sign == 0) {
      ++unknown;
      continue;
    }
    if (previous == 0) {
      v.most += unknown;  // an uncertain start can alternate freely
    } else {
      // unknown + 1 steps from `previous` to `sign`: an odd or an even number of changes.
      const int parity = previous == sign ? 0 : 1;
      v.least += parity;
      v.most += unknown + 1 - ((unknown + 1 - parity) % 2);
    }
    previous = sign;
    unknown = 0;
  }
  v.most += previous == 0 ? std::max(0, unknown - 1) : unknown;
  return v;
}

int leadingExactZeros(const Coefficients& c) {
  const auto first =
      std::find_if(c.begin(), c.end(), [](const Bounded& b) { return !b.isExactZero(); });
  return static_cast<int>(first - c.begin());
}

int trailingExactZeros(const Coefficients& c) {
  const auto last =
      std::find_if(c.rbegin(), c.rend(), [](const Bounded& b) { return !b.isExactZero(); });
  return static_cast<int>(last - c.rbegin());
}

// p(s) in plain double, for a first guess only.
double plainAt(const std::vector<double>& coefficients, double s, std::vector<double>& work) {
  work = coefficients;
  for (std::size_t count = work.size(); count > 1; --count) {
    for (std::size_t i = 0; i + 1 < count; ++i) work[i] += s * (work[i + 1] - work[i]);
  }
  return work[0];
}

// Where the segment's only sign change lies, in [0, 1], as well as double arithmetic tells: the
// Illinois variant of regula falsi, with bisection when it stalls.
double guessRoot(const Coefficients& coefficients) {
  std::vector<double> c, work;
  c.reserve(coefficients.size());
  for (const Bounded& b : coefficients) c.push_back(b.hi);
  double a = 0.0, b = 1.0, fa = c.front(), fb = c.back();
  int stale = 0;
  for (int i = 0; i < 80 && b - a > 0x1p-60; ++i) {
    double s = (i % 8 == 7) ? 0.5 * (a + b) : a - fa * (b - a) / (fb - fa);
    if (!(s > a && s < b)) s = 0.5 * (a + b);
    if (!(s > a && s < b)) break;
    const double fs = plainAt(c, s, work);
    if (fs == 0.0) return s;
    if ((fs > 0.0) == (fb > 0.0)) {
      if (b - s < 0x1p-56) return s;
      b = s, fb = fs;
      if (stale == 1) fa *= 0.5;
      stale = 1;
    } else {
      if (s - a < 0x1p-56) return s;
      a = s, fa = fs;
      if (stale == -1) fb *= 0.5;
      stale = -1;
    }
  }
  return 0.5 * (a + b);
}

/// Narrows (low, high), which holds exactly one root of p, to adjacent doubles.
class Refiner {
 public:
  Refiner(const Bernstein& p, double low, double high, int signLow)
      : p_(p), low_(low), high_(high), signLow_(signLow) {}

  Root refine(double guess) {
    closeInOn(guess);
    bisect();
    return {.t = best(),
            .low = low_,
            .high = high_,
            .signBefore = signLow_,
            .signAfter = -signLow_,
            .multiplicity = 1};
  }

 private:
  // Takes t as a new end if its sign is certain; false if not.
  bool probe(double t) {
    const Bounded value = p_.at(t);
    if (value.isExactZero()) {
      low_ = high_ = t;
      return true;
    }
    const int sign = value.certainSign();
    if (sign == 0) return false;
    (sign == signLow_ ? low_ : high_) = t;
    return true;
  }

  // Probes below and above the guess at growing distances until the root is caught in between.
  void closeInOn(double guess) {
    double step = std::max(std::nextafter(guess, 2.0) - guess, 0x1p-80);
    for (; guess - step > low_; step *= 4.0) {
      const double before = low_;
      probe(guess - step);
      if (low_ == high_) return;
      if (low_ != before) break;
    }
    step = std::max(std::nextafter(guess, 2.0) - guess, 0x1p-80);
    for (; guess + step < high_; step *= 4.0) {
      const double before = high_;
      probe(guess + step);
      if (low_ == high_) return;
      if (high_ != before) break;
    }
  }

  void bisect() {
    while (std::nextafter(low_, 2.0) < high_) {
      const double mid = 0.5 * (low_ + high_);
      if (!(mid > low_ && mid < high_) || !probe(mid)) return;
    }
  }

  double best() const {
    if (low_ == high_) return low_;
    // An end of the domain or a divided-out root may evaluate to 0 without being this root.
    if (std::nextafter(low_, 2.0) < high_) return 0.5 * (low_ + high_);
    const double atLow = std::abs(p_.at(low_).value()), atHigh = std::abs(p_.at(high_).value());
    if (atLow == 0.0) return high_;
    if (atHigh == 0.0) return low_;
    return atLow < atHigh ? low_ : high_;
  }

  const Bernstein& p_;
  double low_, high_;
  int signLow_;
};

class Isolator {
 public:
  explicit Isolator(const Bernstein& p) : p_(p) {}

  Roots run() {
    if (p_.isZero()) {
      result_.identicallyZero = true;
      return std::move(result_);
    }
    const int atStart = leadingExactZeros(p_.scaled()), atEnd = trailingExactZeros(p_.scaled());
    const Bernstein q = p_.dividedByT(atStart).dividedByOneMinusT(atEnd);
    if (atStart > 0) add({0.0, 0.0, 0.0, 0, q.first().certainSign(), atStart});
    if (atEnd > 0) add({1.0, 1.0, 1.0, q.last().certainSign(), 0, atEnd});
    stack_.push_back({q.proportionalCoefficients(), 0.0, 1.0});
    while (!stack_.empty()) {
      const Segment segment = std::move(stack_.back());
      stack_.pop_back();
      process(segment);
    }
    finish();
    return std::move(result_);
  }

 private:
  void process(const Segment& segment) {
    const Variations v = countVariations(segment.c);
    if (v.most == 0) return;
    const int signLow = segment.c.front().certainSign();
    const int signHigh = segment.c.back().certainSign();
    if (v.most == 1 && v.least == 1) {
      const double guess = segment.low + guessRoot(segment.c) * (segment.high - segment.low);
      add(Refiner(p_, segment.low, segment.high, signLow).refine(guess));
      return;
    }
    if (segment.high - segment.low > kMinWidth && divide(segment)) return;
    if (signLow * signHigh < 0) {
      add({0.5 * (segment.low + segment.high), segment.low, segment.high, signLow, signHigh, 0});
    } else {
      result_.unresolved.push_back({segment.low, segment.high});
    }
  }

  // Splits where the sign is certain, or exactly at a root that can be divided out. False if the
  // polynomial cannot be told from zero at any of the split points.
  bool divide(const Segment& segment) {
    for (const double fraction : kSplits) {
      auto [left, right] = splitCoefficients(segment.c, fraction);
      const double mid = segment.low + fraction * (segment.high - segment.low);
      if (right.front().certainSign() == 0 && !divideOut(left, right, mid)) continue;
      stack_.push_back({std::move(right), mid, segment.high});
      stack_.push_back({std::move(left), segment.low, mid});
      return true;
    }
    return false;
  }

  // If the common end of the halves is exactly a root whose multiplicity is certain, lists it and
  // takes it out of both.
  bool divideOut(Coefficients& left, Coefficients& right, double t) {
    // Exact zeros on either side prove the multiplicity, so the larger count holds for both.
    const int m = std::max(leadingExactZeros(right), trailingExactZeros(left));
    if (m == 0 || m >= static_cast<int>(right.size())) return false;
    const Bernstein restLeft = Bernstein(left).dividedByOneMinusT(m);
    const Bernstein restRight = Bernstein(right).dividedByT(m);
    const int before = restLeft.last().certainSign(), after = restRight.first().certainSign();
    if (before == 0 || after == 0) return false;
    left = restLeft.proportionalCoefficients();
    right = restRight.proportionalCoefficients();
    add({t, t, t, before, after, m});
    return true;
  }

  void add(const Root& root) { result_.roots.push_back(root); }

  void finish() {
    std::sort(result_.roots.begin(), result_.roots.end(),
              [](const Root& a, const Root& b) { return a.t < b.t; });
    auto& open = result_.unresolved;
    std::sort(open.begin(), open.end(),
              [](const RootInterval& a, const RootInterval& b) { return a.low < b.low; });
    // One near-double root can leave its trace in neighbouring segments: say it once.
    std::vector<RootInterval> merged;
    for (const RootInterval& interval : open) {
      if (!merged.empty() && merged.back().high == interval.low && !rootAt(interval.low)) {
        merged.back().high = interval.high;
      } else {
        merged.push_back(interval);
      }
    }
    open = std::move(merged);
  }

  bool rootAt(double t) const {
    return std::any_of(result_.roots.begin(), result_.roots.end(),
                       [t](const Root& root) { return root.low == t && root.high == t; });
  }

  const Bernstein& p_;
  std::vector<Segment> stack_;
  Roots result_;
};

}  // namespace

Roots isolateRoots(const Bernstein& p) {
  assert(p.degree() >= 0);
  return Isolator(p).run();
}

}  // namespace flatland
