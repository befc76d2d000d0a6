// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/brute_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>

#include "flatland/features/orientation.h"
#include "tests/support/precise.h"

namespace flatland::test {

namespace {

constexpr int kSamples = 1000;

// a0 + a1 h + a2 h^2 + a3 h^3
template <class T>
struct Series {
  std::array<T, 4> a{};
};

template <class T>
Series<T> operator+(const Series<T>& p, const Series<T>& q) {
  Series<T> r;
  for (std::size_t i = 0; i < 4; ++i) r.a[i] = p.a[i] + q.a[i];
  return r;
}
template <class T>
Series<T> operator-(const Series<T>& p, const Series<T>& q) {
  Series<T> r;
  for (std::size_t i = 0; i < 4; ++i) r.a[i] = p.a[i] - q.a[i];
  return r;
}
template <class T>
Series<T> operator*(const Series<T>& p, const Series<T>& q) {
  Series<T> r;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; i + j < 4; ++j) r.a[i + j] += p.a[i] * q.a[j];
  }
  return r;
}
template <class T>
Series<T> operator/(const Series<T>& p, const Series<T>& q) {
  Series<T> r;
  for (std::size_t i = 0; i < 4; ++i) {
    T rest = p.a[i];
    for (std::size_t j = 0; j < i; ++j) rest -= r.a[j] * q.a[i - j];
    r.a[i] = rest / q.a[0];
  }
  return r;
}
template <class T>
Series<T> rooted(const Series<T>& p) {
  using std::sqrt;
  Series<T> r;
  r.a[0] = sqrt(p.a[0]);
  for (std::size_t i = 1; i < 4; ++i) {
    T rest = p.a[i];
    for (std::size_t j = 1; j < i; ++j) rest -= r.a[j] * r.a[i - j];
    r.a[i] = rest / (2 * r.a[0]);
  }
  return r;
}
template <class T>
Series<T> slope(const Series<T>& p) {
  return {{p.a[1], 2 * p.a[2], 3 * p.a[3], T(0)}};
}

enum Quantity { kSilhouette, kInflection, kExtremum, kApparent, kQuantities };

// The four quantities whose sign changes are marks, each times powers of the speed that keep it
// smooth at near-cusps, with the size of what was subtracted; and signed dn/di.
template <class T>
struct Seen {
  std::array<T, kQuantities> value, size;
  T turn;    // dn/dt . t, that is k times speed
  T across;  // the point's motion across the line of sight, that is speed times n.w
};

template <class T>
Series<T> coordinate(const Bezier& piece, int axis, T t) {
  // Horner on the blossom would do; plain de Casteljau on values with a formal h is shortest.
  std::vector<Series<T>> b;
  for (const Vec2& p : piece.points) b.push_back({{T(p(axis)), T(0), T(0), T(0)}});
  for (std::size_t count = b.size(); count > 1; --count) {
    for (std::size_t i = 0; i + 1 < count; ++i) {
      const Series<T> step = b[i + 1] - b[i];
      Series<T> next = b[i];
      for (std::size_t m = 0; m < 4; ++m) {
        next.a[m] += t * step.a[m] + (m > 0 ? step.a[m - 1] : T(0));
      }
      b[i] = next;
    }
  }
  return b[0];
}

template <class T>
Seen<T> seenAt(const Bezier& piece, const ViewFrame& frame, int side, T t) {
  using std::abs;
  const Series<T> x = coordinate(piece, 0, t), y = coordinate(piece, 1, t);
  const Series<T> dx = slope(x), dy = slope(y), speed = rooted(dx * dx + dy * dy);
  const Series<T> tx = dx / speed, ty = dy / speed;
  const T s = T(side);
  const Series<T> zero{};
  const Series<T> nx = s > 0 ? zero - ty : ty, ny = s > 0 ? tx : zero - tx;
  const Series<T> turn = slope(nx) * tx + slope(ny) * ty;
  Series<T> wx{{T(frame.towards.x()), T(0), T(0), T(0)}},
      wy{{T(frame.towards.y()), T(0), T(0), T(0)}};
  if (frame.distance) {
    const T d = T(*frame.distance);
    wx.a[0] *= d, wy.a[0] *= d;
    wx = wx - x, wy = wy - y;
    const Series<T> rho = rooted(wx * wx + wy * wy);
    wx = wx / rho, wy = wy / rho;
  }
  const Series<T> across = (nx * wx + ny * wy) * speed;
  const T s2 = speed.a[0] * speed.a[0];
  Seen<T> seen;
  seen.turn = turn.a[0];
  seen.across = across.a[0];
  const T turning = abs(dx.a[0] * dy.a[1]) + abs(dy.a[0] * dx.a[1]);
  seen.value[kSilhouette] = across.a[0];
  seen.size[kSilhouette] = speed.a[0];
  seen.value[kInflection] = turn.a[0] * s2;
  seen.size[kInflection] = turning;
  seen.value[kExtremum] = (turn.a[1] * speed.a[0] - turn.a[0] * speed.a[1]) * s2;
  seen.size[kExtremum] = (abs(turn.a[1] * speed.a[0]) + abs(turn.a[0] * speed.a[1])) * s2;
  seen.value[kApparent] = (turn.a[1] * across.a[0] - turn.a[0] * across.a[1]) * s2 * s2;
  seen.size[kApparent] = (abs(turn.a[1] * across.a[0]) + abs(turn.a[0] * across.a[1])) * s2 * s2;
  return seen;
}

int signOf(const Precise& v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

class PieceSearch {
 public:
  PieceSearch(const Bezier& piece, const ViewFrame& frame, int side)
      : piece_(piece), frame_(frame), side_(side) {
    for (std::size_t i = 0; i + 1 < piece.points.size(); ++i) {
      fastest_ =
          std::max(fastest_, piece.degree() * (piece.points[i + 1] - piece.points[i]).norm());
    }
  }

  std::vector<BruteMark> run(const std::vector<double>& looked) {
    nodes_.clear();
    for (int i = 0; i <= kSamples; ++i) nodes_.push_back(static_cast<double>(i) / kSamples);
    for (const double t : looked) {
      for (int j = 10; j <= 40; ++j) {
        nodes_.push_back(t - std::ldexp(1.0, -j));
        nodes_.push_back(t + std::ldexp(1.0, -j));
      }
    }
    // Ends belong to the joints.
    std::erase_if(nodes_, [](double t) { return !(t > kEnd && t < 1.0 - kEnd); });
    nodes_.push_back(kEnd);
    nodes_.push_back(1.0 - kEnd);
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    for (const double t : nodes_) samples_.push_back(seenAt<long double>(piece_, frame_, side_, t));
    for (int q = 0; q < kQuantities; ++q) search(static_cast<Quantity>(q));
    std::sort(marks_.begin(), marks_.end(),
              [](const BruteMark& a, const BruteMark& b) { return a.t < b.t; });
    return marks_;
  }

  // Brackets around strict maxima of sampled lambda that no silhouette explains.
  std::vector<std::pair<double, double>> sampledMaxima() const {
    std::vector<std::pair<double, double>> maxima;
    const auto lambda = [&](std::size_t i) {
      const long double q = samples_[i].turn / samples_[i].across;
      return q * q;
    };
    for (std::size_t i = 1; i + 1 < nodes_.size(); ++i) {
      // A margin for rounding, and no pole between.
      const long double here = lambda(i) * (1.0L - 1e-11L);
      if (!(here > lambda(i - 1) && here > lambda(i + 1)) || isSlow(samples_[i])) continue;
      const bool left = samples_[i - 1].across > 0, mid = samples_[i].across > 0,
                 right = samples_[i + 1].across > 0;
      if (left == mid && mid == right) maxima.emplace_back(nodes_[i - 1], nodes_[i + 1]);
    }
    return maxima;
  }

  static constexpr double kEnd = 0x1p-30;

 private:
  int signAt(Quantity q, double t) const {
    const auto seen = seenAt<long double>(piece_, frame_, side_, t);
    return sign(q, t, seen);
  }

  // Where the curve nearly stands still, direction and turn are differences of small numbers.
  bool isSlow(const Seen<long double>& seen) const {
    return seen.size[kSilhouette] < 1e-3L * fastest_;
  }

  int sign(Quantity q, double t, const Seen<long double>& seen) const {
    if (!isSlow(seen) && std::abs(seen.value[q]) > 1e-9L * seen.size[q])
      return seen.value[q] > 0 ? 1 : -1;
    return signOf(seenAt<Precise>(piece_, frame_, side_, Precise(t)).value[q]);
  }

  void search(Quantity q) {
    std::vector<int> signs;
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      signs.push_back(sign(q, nodes_[i], samples_[i]));
    for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
      if (signs[i] == 0) {  // exactly a root: the change is between its neighbours
        if (i > 0 && signs[i - 1] * signs[i + 1] < 0)
          mark(q, nodes_[i], signs[i - 1], signs[i + 1]);
        continue;
      }
      if (signs[i] * signs[i + 1] < 0) bisect(q, nodes_[i], nodes_[i + 1], signs[i]);
      const auto height = [&](std::size_t m) { return std::abs(samples_[m].value[q]); };
      if (i > 0 && signs[i - 1] == signs[i] && signs[i + 1] == signs[i] &&
          height(i) <= height(i - 1) && height(i) <= height(i + 1)) {
        bottom(q, nodes_[i - 1], nodes_[i + 1], signs[i]);
      }
    }
  }

  // Golden section towards the bottom between samples of one sign; a pair of roots if it dips below
  // 0.
  void bottom(Quantity q, double low, double high, int sign) {
    const double golden = 0.5 * (3.0 - std::sqrt(5.0));
    const double start = low, end = high;
    double a = low + golden * (high - low), b = high - golden * (high - low);
    const auto height = [&](double t) {
      return sign * seenAt<long double>(piece_, frame_, side_, t).value[q];
    };
    long double fa = height(a), fb = height(b);
    for (int i = 0; i < 60; ++i) {
      const double lowest = fa < fb ? a : b;
      if (std::min(fa, fb) < 0 && signAt(q, lowest) == -sign) {
        bisect(q, start, lowest, sign);
        bisect(q, lowest, end, -sign);
        return;
      }
      if (fa < fb) {
        high = b, b = a, fb = fa;
        a = low + golden * (high - low), fa = height(a);
      } else {
        low = a, a = b, fa = fb;
        b = high - golden * (high - low), fb = height(b);
      }
    }
  }

  void bisect(Quantity q, double low, double high, int signLow) {
    while (high - low > 1e-11) {
      const double mid = 0.5 * (low + high);
      const int s = signAt(q, mid);
      if (s == 0) {
        low = high = mid;
        break;
      }
      (s == signLow ? low : high) = mid;
    }
    mark(q, 0.5 * (low + high), signLow, -signLow);
  }

  void mark(Quantity q, double t, int before, int after) {
    const auto seen = seenAt<Precise>(piece_, frame_, side_, Precise(t));
    const int k = signOf(seen.turn), seenTurn = k * signOf(seen.across);
    const bool maximum = before > 0 && after < 0;
    switch (q) {
      case kSilhouette:
        marks_.push_back({MarkKind::Silhouette, t});
        break;
      case kInflection:
        marks_.push_back({MarkKind::Inflection, t});
        break;
      case kExtremum:
        marks_.push_back({maximum && k > 0    ? MarkKind::Ridge
                          : !maximum && k < 0 ? MarkKind::Valley
                                              : MarkKind::Flat,
                          t});
        break;
      default:  // of |dn/di| where signed dn/di has an extremum of its own sign
        marks_.push_back(
            {maximum == (seenTurn > 0) ? MarkKind::ApparentRidge : MarkKind::ApparentMinimum, t});
        break;
    }
  }

  const Bezier& piece_;
  const ViewFrame& frame_;
  int side_;
  double fastest_ = 0.0;  // a bound on the speed
  std::vector<double> nodes_;
  std::vector<Seen<long double>> samples_;
  std::vector<BruteMark> marks_;
};

std::vector<double> onPiece(const std::vector<double>& looked, int piece) {
  std::vector<double> local;
  for (const double t : looked) {
    if (t >= piece && t <= piece + 1) local.push_back(t - piece);
  }
  return local;
}

}  // namespace

std::vector<BruteMark> bruteMarks(const BezierChain& chain, const ViewFrame& frame, int side,
                                  const std::vector<double>& looked) {
  std::vector<BruteMark> all;
  for (int m = 0; m < chain.pieceCount(); ++m) {
    const Bezier piece = chain.piece(m);
    for (BruteMark mark : PieceSearch(piece, frame, side).run(onPiece(looked, m))) {
      mark.t += m;
      all.push_back(mark);
    }
  }
  return all;
}

double bruteLambda(const Bezier& piece, const ViewFrame& frame, double t) {
  const auto seen = seenAt<long double>(piece, frame, 1, t);
  return static_cast<double>((seen.turn / seen.across) * (seen.turn / seen.across));
}

std::string differenceFromBrute(const Scene& scene, const FeatureSet& found, int index) {
  const SceneCurve& curve = scene.curves[static_cast<std::size_t>(index)];
  const ViewFrame frame = frameOf(scene.view);
  const int side = normalSide(curve, frame);
  std::vector<double> looked;
  std::vector<BruteMark> ours;
  for (const Mark& mark : found.marks) {
    if (mark.curve != index) continue;
    looked.push_back(mark.t);
    const double local = mark.t - std::floor(mark.t);
    if (local > PieceSearch::kEnd && local < 1.0 - PieceSearch::kEnd) {
      ours.push_back({mark.kind, mark.t});
    }
  }
  std::ostringstream difference;
  difference.precision(17);
  const auto byKind = [](const BruteMark& a, const BruteMark& b) {
    return a.kind != b.kind ? a.kind < b.kind : a.t < b.t;
  };
  std::vector<BruteMark> brute = bruteMarks(curve.chain(), frame, side, looked);
  std::sort(brute.begin(), brute.end(), byKind);
  std::sort(ours.begin(), ours.end(), byKind);
  constexpr double kSamePlace = 1e-8;
  std::size_t i = 0, j = 0;
  while (i < ours.size() || j < brute.size()) {
    const bool haveBoth = i < ours.size() && j < brute.size();
    if (haveBoth && ours[i].kind == brute[j].kind &&
        std::abs(ours[i].t - brute[j].t) <= kSamePlace) {
      ++i, ++j;
    } else if (j == brute.size() || (haveBoth && byKind(ours[i], brute[j]))) {
      difference << "invented " << nameOf(ours[i].kind) << " at " << ours[i].t << "; ";
      ++i;
    } else {
      difference << "missed " << nameOf(brute[j].kind) << " at " << brute[j].t << "; ";
      ++j;
    }
  }
  for (int m = 0; m < curve.chain().pieceCount(); ++m) {
    const Bezier piece = curve.chain().piece(m);
    PieceSearch search(piece, frame, side);
    search.run(onPiece(looked, m));
    for (const auto& [low, high] : search.sampledMaxima()) {
      const bool known = std::any_of(ours.begin(), ours.end(), [&](const BruteMark& mark) {
        return mark.kind == MarkKind::ApparentRidge && mark.t > m + low - kSamePlace &&
               mark.t < m + high + kSamePlace;
      });
      if (!known)
        difference << "lambda has an unmarked maximum in " << m + low << ", " << m + high << "; ";
    }
  }
  return difference.str();
}

std::string described(const Scene& scene) {
  std::ostringstream text;
  text.precision(17);
  text << "\nview " << scene.view.angleDeg << " deg";
  if (scene.view.distance) text << " from " << *scene.view.distance;
  for (const SceneCurve& curve : scene.curves) {
    text << "\ndegree " << curve.chain().degree() << (curve.chain().closed() ? " closed" : " open")
         << (curve.flipNormal ? " flipped" : "") << ":";
    for (const Vec2& p : curve.chain().points()) text << " (" << p.x() << ", " << p.y() << ")";
  }
  return text.str() + "\n";
}

}  // namespace flatland::test
