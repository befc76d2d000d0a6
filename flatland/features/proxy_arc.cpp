// SPDX-License-Identifier: MIT
#include "flatland/features/proxy_arc.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "flatland/features/regular_arc.h"
#include "flatland/features/tolerances.h"

namespace flatland {

namespace {

using Derivatives = std::array<Vec2, 5>;

// A derivative at an end below this part of its largest value on the piece is zero: the rounding of
// a formula, with room for a few operations.
constexpr double kVanishing = 0x1p-44;

// Samples for what is large on a piece. Not a grid that a periodic formula could share.
constexpr int kSamples = 61;

double sampleAt(int i) { return (i + 0.5 + 0.31 * std::sin(2.7 * i)) / kSamples; }

/// The largest length of each derivative over [low, high], as far as sampled.
std::array<double, 5> reachesOf(const PieceDerivatives& derivatives, double low, double high) {
  std::array<double, 5> reach{};
  for (int i = 0; i < kSamples; ++i) {
    const Derivatives d = derivatives(low + sampleAt(i) * (high - low));
    for (std::size_t m = 0; m < d.size(); ++m) {
      const double length = d[m].norm();
      if (std::isfinite(length)) reach[m] = std::max(reach[m], length);
    }
  }
  return reach;
}

// --- cusps ------------------------------------------------------------------------------------

// The place of least speed in an interval, by golden section.
double slowestIn(const PieceDerivatives& derivatives, double low, double high) {
  const double golden = 0.5 * (3.0 - std::sqrt(5.0));
  const auto speedSq = [&](double t) { return derivatives(t)[1].squaredNorm(); };
  double a = low + golden * (high - low), b = high - golden * (high - low);
  double fa = speedSq(a), fb = speedSq(b);
  for (int i = 0; i < 80 && low < a && b < high; ++i) {
    if (fa < fb) {
      high = b, b = a, fb = fa;
      a = low + golden * (high - low), fa = speedSq(a);
    } else {
      low = a, a = b, fa = fb;
      b = high - golden * (high - low), fb = speedSq(b);
    }
  }
  return fa < fb ? a : b;
}

// Interior parameters where the speed is zero to within rounding of t and of the formula.
std::vector<double> interiorCusps(const PieceDerivatives& derivatives) {
  constexpr double kCuspUlps = 16.0 * 0x1p-53;
  const std::array<double, 5> reach = reachesOf(derivatives, 0.0, 1.0);
  const ProxyRoots minima = proxyRoots([&](double t) {
    const Derivatives d = derivatives(t);
    return Measured{d[1].dot(d[2]), d[1].norm() * d[2].norm()};
  });
  std::vector<double> cusps;
  const auto consider = [&](double low, double high) {
    const double t = low + 2.0 * 0x1p-53 < high ? slowestIn(derivatives, low, high) : low;
    const double speed = derivatives(t)[1].norm();
    if (t > 0.0 && t < 1.0 && speed <= kCuspUlps * (reach[1] + reach[2])) cusps.push_back(t);
  };
  for (const Root& root : minima.roots.roots) consider(root.low, root.high);
  for (const RootInterval& open : minima.roots.unresolved) consider(open.low, open.high);
  std::sort(cusps.begin(), cusps.end());
  return cusps;
}

// --- kinks ------------------------------------------------------------------------------------

// Adjacent parameters between which a derivative jumps, as abs(t) does at 0.
struct Kink {
  double before, after;
};

// The jump of the first, second or third derivative between two places, relative to its reach;
// none where the position itself jumps.
double jumpBetween(const Derivatives& a, const Derivatives& b, std::size_t order,
                   const std::array<double, 5>& reach) {
  const double jump = (b[order] - a[order]).norm();
  return reach[order] > 0.0 && std::isfinite(jump) ? jump / reach[order] : 0.0;
}

// Closes in on the steepest change of a derivative: a smooth one shrinks with the interval.
std::optional<Kink> kinkIn(const PieceDerivatives& derivatives, double low, double high,
                           std::size_t order, const std::array<double, 5>& reach) {
  constexpr double kJump = 1e-6;
  Derivatives a = derivatives(low), b = derivatives(high);
  double widthBefore = high - low, jumpBefore = jumpBetween(a, b, order, reach);
  for (int step = 1; std::nextafter(low, 2.0) < high; ++step) {
    const double middle = 0.5 * (low + high);
    if (!(middle > low && middle < high)) break;
    const Derivatives m = derivatives(middle);
    const bool left = jumpBetween(a, m, order, reach) > jumpBetween(m, b, order, reach);
    (left ? high : low) = middle;
    (left ? b : a) = m;
    const double jump = jumpBetween(a, b, order, reach);
    if (!(jump > kJump)) return std::nullopt;
    if (step % 12 == 0) {  // the interval is 4096 times shorter: a smooth change has fallen
      if (jump < 0.05 * jumpBefore && high - low < 0.01 * widthBefore) return std::nullopt;
      jumpBefore = jump, widthBefore = high - low;
    }
  }
  const double apart = (b[0] - a[0]).norm();
  if (apart > 1e-9 * reach[0] + 1e-12 * reach[1]) return std::nullopt;
  return Kink{low, high};
}

// Interior places where a derivative to order 3 jumps, as far as sampled; not proved to be all.
std::vector<Kink> interiorKinks(const PieceDerivatives& derivatives) {
  constexpr int kPlaces = 401;
  constexpr std::size_t kMost = 100;
  constexpr double kSuspect = 1e-4;
  const std::array<double, 5> reach = reachesOf(derivatives, 0.0, 1.0);
  std::vector<Kink> kinks;
  double low = 0.0;
  Derivatives before = derivatives(low);
  for (int i = 0; i <= kPlaces && kinks.size() < kMost; ++i) {
    const double high = i == kPlaces ? 1.0 : (i + 0.5 + 0.31 * std::sin(2.7 * i)) / kPlaces;
    const Derivatives after = derivatives(high);
    for (std::size_t order = 1; order <= 3; ++order) {
      const double jump = jumpBetween(before, after, order, reach);
      // What the next derivative explains.
      const Vec2 slope = 0.5 * (before[order + 1] + after[order + 1]);
      const double off = (after[order] - before[order] - (high - low) * slope).norm();
      if (!(jump > kSuspect && off > 0.2 * jump * reach[order])) continue;
      const auto kink = kinkIn(derivatives, low, high, order, reach);
      if (kink && kink->before > 0.0 && kink->after < 1.0) {
        kinks.push_back(*kink);
        break;
      }
    }
    low = high;
    before = after;
  }
  return kinks;
}

// --- ends -------------------------------------------------------------------------------------

struct ArcEnd {
  int zeros = 0;  // order of the zero of the speed
  Vec2 direction;
  bool known = true;  // order and direction come from derivatives that exist
};

/// `inwards`: +1 at the start of an arc, -1 at its end.
ArcEnd endOf(const PieceDerivatives& derivatives, double t, int inwards,
             const std::array<double, 5>& reach) {
  const Derivatives d = derivatives(t);
  for (int m = 0; m < 4; ++m) {
    const Vec2& first = d[static_cast<std::size_t>(m) + 1];
    const double length = first.norm();
    if (!std::isfinite(length)) break;
    if (length > kVanishing * reach[static_cast<std::size_t>(m) + 1]) {
      return {m, (m % 2 == 1 && inwards < 0 ? -1.0 : 1.0) * first / length};
    }
  }
  const Vec2 near = derivatives(t + inwards * 0x1p-20)[1];
  return {4, near / near.norm(), false};
}

/// What one of the arcs of a piece may spend: a piece of many arcs as much as one of a few.
ProxyBudget budgetOf(std::size_t arcs) {
  constexpr std::size_t kArcsInFull = 4;
  constexpr int kFewestProbes = 61;
  ProxyBudget budget;
  if (arcs <= kArcsInFull) return budget;
  const double share = static_cast<double>(kArcsInFull) / static_cast<double>(arcs);
  budget.probes = std::max(kFewestProbes, static_cast<int>(share * budget.probes));
  budget.evaluations = static_cast<int>(share * budget.evaluations);
  return budget;
}

class ProxyArc final : public ViewedArc {
 public:
  ProxyArc(const PieceDerivatives& derivatives, int index, double low, double high,
           const ViewFrame& frame, const ProxyBudget& budget)
      : derivatives_(derivatives), frame_(frame), budget_(budget) {
    piece = index;
    tLow = low;
    tHigh = high;
    const std::array<double, 5> reach = reachesOf(derivatives, low, high);
    start_ = endOf(derivatives, low, +1, reach);
    finish_ = endOf(derivatives, high, -1, reach);
    startDirection = start_.direction;
    endDirection = finish_.direction;
    straight = proxies(ArcFunction::Curvature).roots.identicallyZero;
    if (straight) {
      startCurvature = endCurvature = 0.0;
      endOn = isEndOn();
    } else {
      constantCurvature = proxies(ArcFunction::CurvaturePrime).roots.identicallyZero;
      startCurvature = curvatureAt(low, start_, ends(ArcFunction::Curvature).first);
      endCurvature = curvatureAt(high, finish_, ends(ArcFunction::Curvature).second);
    }
  }

  int signAt(ArcFunction function, double s) const override {
    if (straight && (function != ArcFunction::Silhouette || endOn)) return 0;
    const ProxyRoots& found = proxies(function);
    if (found.roots.identicallyZero) return 0;
    const auto [startOrder, finishOrder] = ends(function);
    // At an end whose zeros are taken out, the sign is that of the neighbourhood.
    if ((s <= 0.0 && startOrder > 0) || (s >= 1.0 && finishOrder > 0)) return 0;
    for (const RootInterval& open : found.roots.unresolved) {
      if (s >= open.low && s <= open.high) return 0;
    }
    int sign = 0;
    for (const Root& root : found.roots.roots) {
      if (root.t == 0.0) {
        sign = root.signAfter;
      } else if (root.t == 1.0) {
        if (sign == 0) sign = root.signBefore;
      } else if (root.high < s || (root.high == s && root.low < s)) {
        sign = root.signAfter;
      } else if (root.low < s || root.high == s) {
        return 0;
      } else {
        if (sign == 0) sign = root.signBefore;
        break;
      }
    }
    return sign != 0 ? sign : typicalSign(function);
  }

  ProxyQuality quality() const override {
    ProxyQuality all;
    for (const auto& found : proxies_) {
      if (!found) continue;
      all.pieces += static_cast<int>(found->pieces.size());
      all.error = std::max(all.error, found->errorBound());
      for (const ProxyPiece& part : found->pieces) all.degree = std::max(all.degree, part.degree);
    }
    return all;
  }

 private:
  double global(double s) const { return s >= 1.0 ? tHigh : parameter(s); }

  Measured valueAt(ArcFunction function, double s) const {
    // The functions are asked for at the same places: formulas are dearer than looking up.
    const auto [known, isNew] = samples_.try_emplace(s);
    if (isNew) known->second = derivatives_(global(s));
    return arcFunctionAt(function, known->second, frame_);
  }

  const ProxyRoots& proxies(ArcFunction function) const {
    std::optional<ProxyRoots>& known = proxies_[static_cast<std::size_t>(function)];
    if (!known) {
      known = proxyRoots([&](double s) { return valueAt(function, s); },
                         {start_.zeros > 0, finish_.zeros > 0}, budget_);
    }
    return *known;
  }

  // The order of the zero at each end, without those that come from the speed: silhouettes and
  // curvature only, the others' ends are judged by what meets there.
  std::pair<int, int> ends(ArcFunction function) const {
    const int share = function == ArcFunction::Silhouette  ? 1
                      : function == ArcFunction::Curvature ? 3
                                                           : 1000;
    std::pair<int, int> orders{0, 0};
    for (const Root& root : proxies(function).roots.roots) {
      if (root.t == 0.0) orders.first = root.multiplicity - share * start_.zeros;
      if (root.t == 1.0) orders.second = root.multiplicity - share * finish_.zeros;
    }
    return orders;
  }

  Roots findRoots(ArcFunction function) const override {
    if (straight && (function != ArcFunction::Silhouette || endOn)) return {};
    if (constantCurvature && function == ArcFunction::CurvaturePrime) return {};
    Roots found = proxies(function).roots;
    const auto [startOrder, finishOrder] = ends(function);
    const auto isSpeedOnly = [&, first = startOrder, last = finishOrder](const Root& root) {
      return (root.t == 0.0 && first <= 0) || (root.t == 1.0 && last <= 0);
    };
    std::erase_if(found.roots, isSpeedOnly);
    for (Root& root : found.roots) {
      if (root.t == 0.0) root.multiplicity = startOrder;
      if (root.t == 1.0) root.multiplicity = finishOrder;
    }
    return found;
  }

  // Where there is no root to tell the sign: it is the same all along.
  int typicalSign(ArcFunction function) const {
    double largest = 0.0;
    int sign = 0;
    for (int i = 0; i < 8; ++i) {
      const Measured m = valueAt(function, sampleAt(8 * i));
      const double clear = std::abs(m.value) / m.size;
      if (clear > largest) largest = clear, sign = m.value > 0.0 ? 1 : -1;
    }
    return sign;
  }

  // `order`: of the zero of k at the end; negative where k is infinite.
  std::optional<double> curvatureAt(double t, const ArcEnd& end, int order) const {
    if (end.zeros > 0) {
      if (!end.known || order == 0) return std::nullopt;
      if (order > 0) return 0.0;
      const int sign = signAt(ArcFunction::Curvature, t == tLow ? 0.0 : 1.0);
      if (sign == 0) return std::nullopt;
      return sign * std::numeric_limits<double>::infinity();
    }
    const Derivatives d = derivatives_(t);
    const double speed = d[1].norm(), k = cross(d[1], d[2]) / (speed * speed * speed);
    if (!std::isfinite(k)) return std::nullopt;
    return order > 0 ? 0.0 : k;
  }

  bool isEndOn() const {
    const auto sine = [&](const Vec2& direction, double t) {
      return std::abs(cross(direction, towardsViewer(frame_, derivatives_(t)[0])));
    };
    return sine(startDirection, tLow) < kEndOnSine && sine(endDirection, tHigh) < kEndOnSine;
  }

  const PieceDerivatives derivatives_;
  const ViewFrame frame_;
  const ProxyBudget budget_;
  ArcEnd start_, finish_;
  mutable std::array<std::optional<ProxyRoots>, kArcFunctionCount> proxies_;
  mutable std::unordered_map<double, Derivatives> samples_;
};

}  // namespace

Measured arcFunctionAt(ArcFunction function, const std::array<Vec2, 5>& d, const ViewFrame& frame) {
  const double l1 = d[1].norm(), l2 = d[2].norm(), l3 = d[3].norm();
  const double s2 = d[1].squaredNorm(), c = cross(d[1], d[2]), h = d[1].dot(d[2]);
  const double cDot = cross(d[1], d[3]);
  // B = c' s2 - 3 c h, the numerator of k'
  const auto prime = [&] {
    return Measured{cDot * s2 - 3.0 * c * h, l1 * l1 * l1 * (l3 + 3.0 * l2 * l2 / l1)};
  };
  // n.w times the speed (and the distance to the viewer), and its derivative
  struct Facing {
    double value, slope, size, slopeSize;
    double across, depth, xi, eta;
  };
  const auto facing = [&] {
    const double xi = d[1].dot(frame.axis), xiDot = d[2].dot(frame.axis);
    if (!frame.distance) return Facing{xi, xiDot, l1, l2, 0.0, 0.0, xi, 0.0};
    const double across = d[0].dot(frame.axis);
    const double depth = *frame.distance - d[0].dot(frame.towards);
    const double eta = d[1].dot(frame.towards), etaDot = d[2].dot(frame.towards);
    const double reach = std::abs(across) + *frame.distance + d[0].norm();
    return Facing{xi * depth + across * eta,
                  xiDot * depth + across * etaDot,
                  l1 * reach,
                  l2 * reach,
                  across,
                  depth,
                  xi,
                  eta};
  };
  switch (function) {
    case ArcFunction::Silhouette: {
      const Facing w = facing();
      return {w.value, w.size};
    }
    case ArcFunction::Curvature:
      return {c, l1 * l2};
    case ArcFunction::CurvaturePrime:
      return prime();
    case ArcFunction::LambdaPrime: {
      const Facing w = facing();
      double value = cDot * s2 * w.value - c * (2.0 * h * w.value + s2 * w.slope);
      double size =
          l1 * l1 * l1 * l3 * w.size + l1 * l2 * (2.0 * l1 * l2 * w.size + l1 * l1 * w.slopeSize);
      if (frame.distance) {
        const double rhoSq = w.across * w.across + w.depth * w.depth;
        const double turning = w.across * w.xi - w.depth * w.eta;  // (rho^2)'/2
        value = rhoSq * value + turning * c * s2 * w.value;
        size = rhoSq * size + std::sqrt(rhoSq) * l1 * l1 * l2 * l1 * l1 * w.size;
      }
      return {value, size};
    }
    case ArcFunction::Fold: {
      // With k = c / s2^(3/2): k' = B / s2^3 and k'' = (B' s2 - 6 B h) / s2^(9/2); all over s2^6.
      const double l4 = d[4].norm();
      const Measured b = prime();
      const double bDot = (cross(d[2], d[3]) + cross(d[1], d[4])) * s2 - cDot * h -
                          3.0 * c * (d[2].squaredNorm() + d[1].dot(d[3]));
      const double bDotSize =
          (l2 * l3 + l1 * l4) * s2 + l1 * l3 * l1 * l2 + 3.0 * l1 * l2 * (l2 * l2 + l1 * l3);
      const double cSize = l1 * l2;
      return {c * c * c * c + c * (bDot * s2 - 6.0 * b.value * h) - b.value * b.value,
              cSize * cSize * cSize * cSize + cSize * (bDotSize * s2 + 6.0 * b.size * l1 * l2) +
                  b.size * b.size};
    }
  }
  return {0.0, 0.0};
}

std::vector<std::unique_ptr<ViewedArc>> proxyArcs(const PieceDerivatives& derivatives, int index,
                                                  const ViewFrame& frame, double extent) {
  // A power of two for the plane, so that products stay in range.
  const double scale = unitScale(extent);
  const PieceDerivatives scaled = [derivatives, scale](double t) {
    Derivatives d = derivatives(t);
    for (Vec2& v : d) v *= scale;
    return d;
  };
  ViewFrame scaledFrame = frame;
  if (frame.distance) scaledFrame.distance = scale * *frame.distance;

  std::vector<std::unique_ptr<ViewedArc>> arcs;
  constexpr double kPoint = 1e-13;
  if (!(reachesOf(scaled, 0.0, 1.0)[1] > kPoint)) return arcs;
  std::vector<Kink> cuts = interiorKinks(scaled);
  for (const double cusp : interiorCusps(scaled)) {
    const bool isKink = std::any_of(cuts.begin(), cuts.end(), [&](const Kink& cut) {
      return std::abs(cut.before - cusp) < 0x1p-20;
    });
    if (!isKink) cuts.push_back({cusp, cusp});
  }
  std::sort(cuts.begin(), cuts.end(),
            [](const Kink& a, const Kink& b) { return a.before < b.before; });
  cuts.insert(cuts.begin(), {0.0, 0.0});
  cuts.push_back({1.0, 1.0});
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double low = cuts[i].after, high = cuts[i + 1].before;
    if (!(high > low) || !(reachesOf(scaled, low, high)[1] > kPoint)) continue;
    arcs.push_back(std::make_unique<ProxyArc>(scaled, index, low, high, scaledFrame,
                                              budgetOf(cuts.size() - 1)));
    for (std::optional<double>* k : {&arcs.back()->startCurvature, &arcs.back()->endCurvature}) {
      if (*k) **k *= scale;
    }
  }
  return arcs;
}

}  // namespace flatland
