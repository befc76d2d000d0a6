// SPDX-License-Identifier: MIT
#include "flatland/features/curve_marks.h"

#include <algorithm>
#include <cmath>

#include "flatland/features/tolerances.h"
#include "flatland/features/viewed_arc.h"

namespace flatland {

namespace {

enum class End { Open, Corner, Smooth };

/// An arc and what its ends meet.
struct Arc {
  std::unique_ptr<ViewedArc> viewed;
  End start = End::Open, finish = End::Open;

  const ViewedArc* operator->() const { return viewed.get(); }
  const Roots& roots(ArcFunction function) const { return viewed->roots(function); }
};

/// Signs just inside one end of an arc, with respect to increasing t.
struct Signs {
  int nw, k, kPrime, lambdaPrime;
};

class CurveMarker {
 public:
  CurveMarker(const Curve& curve, const ViewFrame& frame, int side, RootMethod method)
      : curve_(curve),
        frame_(frame),
        side_(side),
        method_(method),
        extent_(boundsOf(curve).diagonal()) {}

  CurveMarks run() {
    for (int i = 0; i < pieceCount(curve_); ++i) addPiece(i);
    const std::size_t count = arcs_.size();
    for (std::size_t i = 0; i + 1 < count; ++i) meet(arcs_[i], arcs_[i + 1]);
    if (isClosed(curve_) && count > 0) meet(arcs_[count - 1], arcs_[0]);
    for (const Arc& arc : arcs_) addInterior(arc);
    for (const Arc& arc : arcs_) result_.quality.add(arc->quality());
    return std::move(result_);
  }

 private:
  // --- arcs ---------------------------------------------------------------------------------

  void addPiece(int index) {
    std::vector<std::unique_ptr<ViewedArc>> arcs =
        viewedArcs(curve_, index, frame_, extent_, method_);
    if (arcs.empty()) {
      result_.degenerate.push_back({Degenerate::What::Point, 0, index + 0.0, index + 1.0});
    }
    // Cuts at kinks and cusps leave no more than a few units in the last place between arcs.
    constexpr double kStandsStill = 1e-9;
    double covered = arcs.empty() ? 1.0 : 0.0;
    const auto addStillUpTo = [&](double t) {
      if (t - covered <= kStandsStill) return;
      result_.degenerate.push_back({Degenerate::What::Point, 0, index + covered, index + t});
    };
    for (const std::unique_ptr<ViewedArc>& arc : arcs) {
      addStillUpTo(arc->tLow);
      covered = arc->tHigh;
    }
    addStillUpTo(1.0);
    for (std::unique_ptr<ViewedArc>& arc : arcs) {
      if (arc->straight) {
        const auto what = arc->endOn ? Degenerate::What::StraightEndOn : Degenerate::What::Straight;
        result_.degenerate.push_back({what, 0, index + arc->tLow, index + arc->tHigh});
      }
      if (arc->constantCurvature) {
        result_.degenerate.push_back(
            {Degenerate::What::ConstantCurvature, 0, index + arc->tLow, index + arc->tHigh});
      }
      arcs_.push_back({std::move(arc)});
    }
  }

  Signs signsAt(const Arc& arc, double s) const {
    const int nw = arc->signAt(ArcFunction::Silhouette, s);
    const int c = arc->signAt(ArcFunction::Curvature, s);
    return {nw, -side_ * c, -side_ * arc->signAt(ArcFunction::CurvaturePrime, s),
            arc->signAt(ArcFunction::LambdaPrime, s) * c * nw};
  }

  // k for the curve's normal from a one-sided end value of an arc.
  std::optional<double> curvature(const std::optional<double>& ofLeftNormal) const {
    if (!ofLeftNormal) return std::nullopt;
    return -side_ * *ofLeftNormal;
  }

  // --- where arcs meet ----------------------------------------------------------------------

  void meet(Arc& a, Arc& b) {
    const Vec2 in = a->endDirection, out = b->startDirection;
    double turn = std::atan2(cross(in, out), in.dot(out));
    if (turn < 0.0 && std::abs(cross(in, out)) < kSmoothJointRad && in.dot(out) < 0.0) turn = -turn;
    joint_ = {MarkKind::Corner, b->piece, b->tLow, true, {}, turn};
    if (std::abs(turn) > kSmoothJointRad) {
      a.finish = b.start = End::Corner;
      meetAtCorner(a, b);
    } else {
      a.finish = b.start = End::Smooth;
      meetSmoothly(a, b);
    }
  }

  void addAtJoint(MarkKind kind) {
    CurveMark mark = joint_;
    mark.kind = kind;
    if (kind != MarkKind::Corner) mark.turnRad = 0.0;
    result_.marks.push_back(mark);
  }

  void meetAtCorner(const Arc& a, const Arc& b) {
    addAtJoint(MarkKind::Corner);
    const int before = a->signAt(ArcFunction::Silhouette, 1.0);
    const int after = b->signAt(ArcFunction::Silhouette, 0.0);
    // The image folds, or one side leaves along the line of sight.
    if (before * after <= 0) {
      addAtJoint(MarkKind::Silhouette);
    }
  }

  void meetSmoothly(const Arc& a, const Arc& b) {
    const Signs before = signsAt(a, 1.0 - kJointWindow), after = signsAt(b, kJointWindow);
    const bool silhouette =
        settle(MarkKind::Silhouette, ArcFunction::Silhouette, a, b, before.nw * after.nw < 0, true);
    settle(MarkKind::Inflection, ArcFunction::Curvature, a, b, before.k * after.k < 0, false);

    const auto ka = curvature(a->endCurvature);
    const auto kb = curvature(b->startCurvature);
    if (!ka || !kb) {
      const double t = b->piece + b->tLow;
      for (const MarkKind kind : {MarkKind::Ridge, MarkKind::ApparentRidge}) {
        result_.unresolved.push_back(
            {kind, 0, t, t, "curvature is infinite here, of undecided sign"});
      }
      return;
    }
    meetExtrema(a, *ka, before, b, *kb, after);
    if (!silhouette) meetApparentRidges(a, *ka, before, b, *kb, after);  // else lambda is infinite
  }

  // Two one-sided values that count as one.
  bool same(double p, double q) const {
    if (std::isinf(p) || std::isinf(q)) return p == q;
    return std::abs(p - q) <= kSameCurvature * std::max({std::abs(p), std::abs(q), 1.0 / extent_});
  }

  void meetExtrema(const Arc& a, double ka, const Signs& before, const Arc& b, double kb,
                   const Signs& after) {
    if (same(ka, kb)) {
      if (before.kPrime * after.kPrime >= 0) return;
      settle(extremumKind(before.kPrime > 0, ka), ArcFunction::CurvaturePrime, a, b, true, false);
      return;
    }
    // The side with the larger (smaller) value decides, and must lead up (down) to the joint.
    const bool fromA = ka > kb;
    if (fromA ? before.kPrime > 0 : after.kPrime < 0) {
      addAtJump(extremumKind(true, std::max(ka, kb)), fromA, a);
    }
    if (!fromA ? before.kPrime < 0 : after.kPrime > 0) {
      addAtJump(extremumKind(false, std::min(ka, kb)), !fromA, a);
    }
  }

  void meetApparentRidges(const Arc& a, double ka, const Signs& before, const Arc& b, double kb,
                          const Signs& after) {
    const double sizeA = std::abs(ka), sizeB = std::abs(kb);
    // A minimum needs k to keep its sign: at an inflection lambda is 0, and that is its mark.
    const bool keepsSign = before.k * after.k > 0;
    if (same(sizeA, sizeB)) {
      const bool turns = before.lambdaPrime * after.lambdaPrime < 0;
      if (!turns || (before.lambdaPrime < 0 && !keepsSign)) return;
      settle(before.lambdaPrime > 0 ? MarkKind::ApparentRidge : MarkKind::ApparentMinimum,
             ArcFunction::LambdaPrime, a, b, true, false);
      return;
    }
    const bool fromA = sizeA > sizeB;
    if (fromA ? before.lambdaPrime > 0 : after.lambdaPrime < 0) {
      addAtJump(MarkKind::ApparentRidge, fromA, a);
    }
    if (keepsSign && (!fromA ? before.lambdaPrime < 0 : after.lambdaPrime > 0)) {
      addAtJump(MarkKind::ApparentMinimum, !fromA, a);
    }
  }

  // A mark at the joint that takes its values from the end of `a`, or from the start of what
  // follows.
  void addAtJump(MarkKind kind, bool valueOfA, const Arc& a) {
    addAtJoint(kind);
    if (valueOfA) result_.marks.back().valueAt = {a->piece, a->tHigh};
  }

  // Judges one kind of root in the windows on both sides of a smooth joint: marks the root itself
  // if it is the only one, the joint if there are none or several. `changes`: the sign differs
  // across the windows. `touches`: a root counts even without a change of sign. True if something
  // was marked.
  bool settle(MarkKind kind, ArcFunction function, const Arc& a, const Arc& b, bool changes,
              bool touches) {
    std::vector<CurveMark> near;
    for (const Root& root : a.roots(function).roots) {
      if (root.t > 1.0 - kJointWindow) near.push_back({kind, a->piece, a->parameter(root.t)});
    }
    for (const Root& root : b.roots(function).roots) {
      if (root.t < kJointWindow) near.push_back({kind, b->piece, b->parameter(root.t)});
    }
    if (!changes && !(touches && !near.empty())) return false;
    if (near.size() == 1 && near[0].t != 0.0 && near[0].t != 1.0) {
      result_.marks.push_back(near[0]);
    } else {
      addAtJoint(kind);
    }
    return true;
  }

  // --- inside arcs --------------------------------------------------------------------------

  // Whether a root at s belongs to the arc's inside, not to what meets at its ends.
  static bool isInside(const Arc& arc, double s, bool endsCount) {
    const auto inside = [&](End end, double distance) {
      switch (end) {
        case End::Open:
          return endsCount || distance > 0.0;
        case End::Corner:
          return distance > 0.0;
        case End::Smooth:
          return distance >= kJointWindow;
      }
      return true;
    };
    return inside(arc.start, s) && inside(arc.finish, 1.0 - s);
  }

  void addInterior(const Arc& arc) {
    const auto mark = [&](MarkKind kind, const Root& root) {
      result_.marks.push_back({kind, arc->piece, arc->parameter(root.t)});
    };
    for (const Root& root : arc.roots(ArcFunction::Silhouette).roots) {
      if (isInside(arc, root.t, true)) mark(MarkKind::Silhouette, root);
    }
    for (const Root& root : arc.roots(ArcFunction::Curvature).roots) {
      if (!isInside(arc, root.t, true)) continue;
      // At an open end only the multiplicity tells that the curve's continuation would cross over.
      const bool crosses =
          root.signBefore * root.signAfter != 0 ? root.isCrossing() : root.multiplicity % 2 == 1;
      if (crosses) mark(MarkKind::Inflection, root);
    }
    for (const Root& root : arc.roots(ArcFunction::CurvaturePrime).roots) {
      if (!isInside(arc, root.t, false) || !root.isCrossing()) continue;
      const int kSign = -side_ * arc->signAt(ArcFunction::Curvature, root.t);
      mark(extremumKind(-side_ * root.signBefore > 0, kSign), root);
    }
    for (const Root& root : arc.roots(ArcFunction::LambdaPrime).roots) {
      // At a silhouette of even multiplicity lambda rises to infinity from both sides.
      if (!isInside(arc, root.t, false)) continue;
      if (holdsRoot(arc.roots(ArcFunction::Silhouette), root.low, root.high)) continue;
      const int before = lambdaTrend(arc, root, -1), after = lambdaTrend(arc, root, +1);
      if (before > 0 && after < 0) mark(MarkKind::ApparentRidge, root);
      if (before < 0 && after > 0) mark(MarkKind::ApparentMinimum, root);
    }
    addOpenQuestions(arc, MarkKind::Silhouette, arc.roots(ArcFunction::Silhouette));
    addOpenQuestions(arc, MarkKind::Inflection, arc.roots(ArcFunction::Curvature));
    addOpenQuestions(arc, MarkKind::Ridge, arc.roots(ArcFunction::CurvaturePrime));
    addOpenQuestions(arc, MarkKind::ApparentRidge, arc.roots(ArcFunction::LambdaPrime));
  }

  static MarkKind extremumKind(bool maximum, double k) {
    if (maximum && k > 0.0) return MarkKind::Ridge;
    if (!maximum && k < 0.0) return MarkKind::Valley;
    return MarkKind::Flat;
  }

  // Sign of dlambda/du on one side of a root of lambdaPrime. k or n.w may vanish at the very same
  // place (an undulation), so their signs are taken a little further out, where they are certain.
  static int lambdaTrend(const Arc& arc, const Root& root, int direction) {
    const int own = direction < 0 ? root.signBefore : root.signAfter;
    for (double step = 0x1p-53; step < kJointWindow; step *= 8.0) {
      const double s = (direction < 0 ? root.low : root.high) + direction * step;
      if (s < 0.0 || s > 1.0) break;
      const int c = arc->signAt(ArcFunction::Curvature, s);
      const int w = arc->signAt(ArcFunction::Silhouette, s);
      if (c != 0 && w != 0) return own * c * w;
    }
    return 0;
  }

  // Intervals that could not be decided, and clusters, which are marked but not counted.
  void addOpenQuestions(const Arc& arc, MarkKind kind, const Roots& roots) {
    const auto open = [&](double low, double high, const char* reason) {
      result_.unresolved.push_back(
          {kind, 0, arc->piece + arc->parameter(low), arc->piece + arc->parameter(high), reason});
    };
    if (roots.identicallyZero && !arc->straight) {
      open(0.0, 1.0, "the defining polynomial cannot be told from zero");
    }
    for (const RootInterval& interval : roots.unresolved) {
      const double middle = 0.5 * (interval.low + interval.high);
      if (!isInside(arc, middle, true) || isExplained(arc, kind, interval)) continue;
      open(interval.low, interval.high, "none or an even number of roots too close to tell apart");
    }
    for (const Root& root : roots.roots) {
      if (root.multiplicity != 0 || !isInside(arc, root.t, true)) continue;
      open(root.low, root.high, "an odd number of roots too close to count; one is marked");
    }
  }

  // A multiple root of n.w or k is a multiple root of the derivatives too (docs/math/features.md):
  // where one is known, an unresolved derivative there asks nothing new.
  static bool isExplained(const Arc& arc, MarkKind kind, const RootInterval& interval) {
    const auto holdsMultiple = [&](const Roots& roots) {
      return holdsRoot(roots, interval.low, interval.high, 2);
    };
    if (kind == MarkKind::ApparentRidge) {
      return holdsMultiple(arc.roots(ArcFunction::Silhouette)) ||
             holdsMultiple(arc.roots(ArcFunction::Curvature));
    }
    return kind == MarkKind::Ridge && holdsMultiple(arc.roots(ArcFunction::Curvature));
  }

  // True if the interval meets a root of at least that multiplicity; a cluster has any.
  static bool holdsRoot(const Roots& roots, double low, double high, int multiplicity = 1) {
    return std::any_of(roots.roots.begin(), roots.roots.end(), [&](const Root& root) {
      const bool multiple = root.multiplicity == 0 || root.multiplicity >= multiplicity;
      return multiple && root.high >= low && root.low <= high;
    });
  }

  const Curve& curve_;
  const ViewFrame& frame_;
  const int side_;
  const RootMethod method_;
  const double extent_;
  std::vector<Arc> arcs_;
  CurveMark joint_{};  ///< the joint being judged
  CurveMarks result_;
};

}  // namespace

CurveMarks findCurveMarks(const Curve& curve, const ViewFrame& frame, int side, RootMethod method) {
  return CurveMarker(curve, frame, side, method).run();
}

}  // namespace flatland
