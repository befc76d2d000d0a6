// SPDX-License-Identifier: MIT
#include "flatland/screen/sweep.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>

#include "flatland/features/curve_marks.h"
#include "flatland/features/orientation.h"
#include "flatland/features/viewed_arc.h"

namespace flatland {

namespace {

constexpr double kDegPerRad = 180.0 / std::numbers::pi;
constexpr double kMaxAngleStepDeg = 2.0;
constexpr double kMaxLengthStep = 0.01;  // of the curve
// Enough for a tangent that turns within 1e-8 of a branch. Where the speed vanishes to second order
// angles within about 1e-5 of the place are noise, which no halving smooths: some thousand samples.
constexpr int kMaxHalvings = 28;
constexpr double kLengthAccuracy = 1e-12;  // of the control polygon

// What may be spent on closeness beyond 16 steps a branch: of a curve, and of a scene
// (docs/decisions/0022-budgets.md). The default curve takes 500 points, a circle of four pieces
// 800.
constexpr int kMostPointsOfCurve = 20000;
constexpr int kMostPointsOfScene = 400000;
constexpr int kLeastHalvings = 4;

double angleDegOf(const Vec2& v) { return std::atan2(v.y(), v.x()) * kDegPerRad; }

// The view from which the point is a root of dlambda/du. The left normal serves: w and -w are the
// same.
double ridgeAngleDeg(const Jet& jet) {
  const Frame f = frameOf(jet);
  // t lies at -90 degrees from the left normal.
  return angleDegOf(f.normal) - std::atan2(f.kPrime, f.k * f.k) * kDegPerRad;
}

double silhouetteAngleDeg(const Jet& jet) { return angleDegOf(jet.d1); }

/// Sweeps one curve.
class CurveSweeper {
 public:
  CurveSweeper(int index, const Curve& curve, int side, int budget, Sweep& result)
      : index_(index),
        curve_(curve),
        side_(side),
        budget_(budget),
        result_(result),
        accuracy_(kLengthAccuracy * lengthScale(curve)),
        extent_(boundsOf(curve).diagonal()) {
    if (extent_ > 0.0) length_ = arcLength(curve_, 0.0, pieceCount(curve_), accuracy_).value;
  }

  void run() {
    if (!(length_ > 0.0)) return;  // all points coincide
    addLines();
    for (int i = 0; i < pieceCount(curve_); ++i) {
      piece_ = i;
      for (const auto& arc : viewedArcs(curve_, i, frameOf(View{}), extent_)) {
        if (!arc->straight) addArc(*arc);
      }
    }
  }

 private:
  double lengthBetween(double low, double high) const {
    return arcLength(curve_, piece_ + low, piece_ + high, accuracy_).value;
  }

  // Up to a place of the piece: from the nearest one before it whose length is known.
  double lengthAt(double t) {
    const double at = piece_ + t;
    const auto after = known_.upper_bound(at);
    const auto [from, length] = *std::prev(after);
    if (from == at) return length;
    const double u = length + arcLength(curve_, from, at, accuracy_).value;
    known_.emplace_hint(after, at, u);
    return u;
  }

  void addLines() {
    // Any view will do: with the side given, these kinds do not depend on it.
    const CurveMarks found = findCurveMarks(curve_, frameOf(View{}), side_);
    for (const Unresolved& open : found.unresolved) {
      const bool moves = open.kind == MarkKind::Silhouette || open.kind == MarkKind::ApparentRidge;
      result_.complete = result_.complete && moves;
    }
    for (const CurveMark& mark : found.marks) {
      switch (mark.kind) {
        case MarkKind::Silhouette:
        case MarkKind::ApparentRidge:
        case MarkKind::ApparentMinimum:
          continue;
        default:
          break;
      }
      piece_ = mark.piece;
      result_.lines.push_back({mark.kind, index_, mark.piece + mark.t, lengthAt(mark.t)});
    }
  }

  void addArc(const ViewedArc& arc) {
    std::vector<double> cuts{arc.tLow, arc.tHigh};
    const auto addEvents = [&](ArcFunction function, SweepEvent::What what) {
      const Roots& roots = arc.roots(function);
      result_.complete = result_.complete && roots.resolved();
      for (const Root& root : roots.roots) {
        if (root.t <= 0.0 || root.t >= 1.0 || !root.isCrossing()) continue;
        const double t = arc.parameter(root.t);
        // Where curvature is extreme the direction may turn by half a turn within a hair's breadth,
        // which sampling from afar would take for no turn at all: branches are cut there too.
        cuts.push_back(t);
        const Jet jet = jetAt(curve_, piece_, t);
        const double angle = what == SweepEvent::What::MeetsSilhouette ? silhouetteAngleDeg(jet)
                             : what == SweepEvent::What::HeadOn ? angleDegOf(frameOf(jet).normal)
                                                                : ridgeAngleDeg(jet);
        result_.events.push_back({what, index_, halfTurnDeg(angle), piece_ + t, lengthAt(t)});
      }
    };
    addEvents(ArcFunction::Curvature, SweepEvent::What::MeetsSilhouette);
    addEvents(ArcFunction::CurvaturePrime, SweepEvent::What::HeadOn);
    addEvents(ArcFunction::Fold, SweepEvent::What::Fold);

    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      if (!(cuts[i + 1] > cuts[i])) continue;
      addBranch(MarkKind::Silhouette, cuts[i], cuts[i + 1], silhouetteAngleDeg);
      const double middle = 0.5 * (cuts[i] + cuts[i + 1]);
      const int sign = arc.signAt(ArcFunction::Fold, (middle - arc.tLow) / (arc.tHigh - arc.tLow));
      addBranch(sign < 0 ? MarkKind::ApparentRidge : MarkKind::ApparentMinimum, cuts[i],
                cuts[i + 1], ridgeAngleDeg);
    }
  }

  // Samples a branch from both ends inwards until neighbours are close. At a cusp the direction is
  // that of the limit, so the ends are taken a hair inside.
  template <class Angle>
  void addBranch(MarkKind kind, double low, double high, Angle angleOf) {
    const auto sample = [&](double t) {
      const Jet jet = jetAt(curve_, piece_, t);
      const bool moves = jet.d1.squaredNorm() > 0.0;  // else it has no direction here
      return SweepPoint{moves ? angleOf(jet) : std::numeric_limits<double>::quiet_NaN(), piece_ + t,
                        0.0};
    };
    // Where the speed vanishes to a higher order it rounds to 0 a hair inside too.
    const auto endSample = [&](double end, double inwards) {
      double hair = 0x1p-40;
      SweepPoint point = sample(end + hair * inwards);
      while (!std::isfinite(point.angleDeg) && hair < 0x1p-4) {
        hair *= 2.0;
        point = sample(end + hair * inwards);
      }
      return point;
    };
    SweepBranch branch{kind, index_, {endSample(low, high - low)}};
    if (!std::isfinite(branch.points.front().angleDeg)) return;
    branch.points.front().u = lengthAt(branch.points.front().t - piece_);
    refine(branch, endSample(high, low - high), sample, 0);
    for (std::size_t i = 1; i < branch.points.size(); ++i) {
      const SweepPoint& before = branch.points[i - 1];
      SweepPoint& point = branch.points[i];
      point.u = before.u + lengthBetween(before.t - piece_, point.t - piece_);
    }
    result_.branches.push_back(std::move(branch));
  }

  // Appends points from the branch's last one up to `to`, unwrapping the angle.
  template <class Sample>
  void refine(SweepBranch& branch, SweepPoint to, const Sample& sample, int depth) {
    const SweepPoint& from = branch.points.back();
    if (!std::isfinite(to.angleDeg)) to.angleDeg = from.angleDeg;
    to.angleDeg = from.angleDeg + halfTurnDeg(to.angleDeg - from.angleDeg);
    const double chord = (pointAt(curve_, to.t) - pointAt(curve_, from.t)).norm();
    const bool close = std::abs(to.angleDeg - from.angleDeg) <= kMaxAngleStepDeg &&
                       chord <= kMaxLengthStep * length_ && depth >= kLeastHalvings;
    const bool spent = depth >= kLeastHalvings && budget_ <= 0;
    if (spent && !close) result_.fine = false;
    if (close || spent || depth == kMaxHalvings) {
      --budget_;
      branch.points.push_back(to);
      return;
    }
    const SweepPoint middle = sample(0.5 * (from.t + to.t) - piece_);
    refine(branch, middle, sample, depth + 1);
    refine(branch, to, sample, depth + 1);
  }

  int index_;
  const Curve& curve_;
  int side_;
  int budget_;
  Sweep& result_;
  double accuracy_, extent_, length_ = 0.0;
  int piece_ = 0;
  std::map<double, double> known_{{0.0, 0.0}};  // arc lengths up to chain parameters
};

}  // namespace

double halfTurnDeg(double angleDeg) {
  const double a = std::remainder(angleDeg, 180.0);
  return a == -90.0 ? 90.0 : a;
}

Sweep sweepOf(const Scene& scene) {
  const ViewFrame frame = frameOf(scene.view);
  Sweep result;
  int left = kMostPointsOfScene;
  std::size_t counted = 0;
  for (std::size_t i = 0; i < scene.curves.size(); ++i) {
    const SceneCurve& curve = scene.curves[i];
    result.certified = result.certified && bezierForm(curve.shape) != nullptr;
    CurveSweeper(static_cast<int>(i), curve.shape, normalSide(curve, frame),
                 std::min(kMostPointsOfCurve, left), result)
        .run();
    for (; counted < result.branches.size(); ++counted) {
      left -= static_cast<int>(result.branches[counted].points.size());
    }
  }
  std::sort(result.events.begin(), result.events.end(),
            [](const SweepEvent& a, const SweepEvent& b) {
              return a.curve != b.curve ? a.curve < b.curve : a.t < b.t;
            });
  return result;
}

}  // namespace flatland
