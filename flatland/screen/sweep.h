// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "flatland/features/features.h"

namespace flatland {

/// Every mark of a scene for every orthographic view direction (docs/math/sweep.md).
///
/// No angle is searched. At a point of a curve w = cos(psi) n + sin(psi) t makes lambda stationary
/// exactly if tan(psi) = k' / k^2, so each point belongs to one view line, and walking the curve
/// yields all branches, whole. Likewise a point is a silhouette exactly from the direction of its
/// tangent. Opposite directions see the same marks (hidden ones included), so angles are modulo 180
/// degrees.
///
/// Branches are those of the smooth parts. A corner, which is a silhouette for a whole range of
/// views, is a line; a joint at which curvature jumps, and which is an apparent ridge for a range
/// of views, is left to findFeatures.
struct SweepPoint {
  double angleDeg;  ///< view direction, unwrapped: continuous along a branch, any multiple of 180
                    ///< may be added
  double t;         ///< chain parameter
  double u;         ///< arc length
};

/// A branch: where the mark of one kind goes as the view turns. Kind is Silhouette, ApparentRidge
/// or ApparentMinimum. Neighbouring points differ by at most 2 degrees and 1/100 of the length,
/// unless the curve turns faster than t resolves. A branch ends where its kind changes and where
/// curvature is extreme.
struct SweepBranch {
  MarkKind kind;
  int curve;
  std::vector<SweepPoint> points;  ///< in order of t, at least 2
};

/// A mark that does not move: ridge, valley, flat point, inflection or corner.
struct SweepLine {
  MarkKind kind;
  int curve;
  double t, u;
};

/// A view direction at which something happens to an apparent ridge.
struct SweepEvent {
  enum class What {
    Fold,  ///< an apparent ridge and a minimum of lambda are born or merge (k^4 + k k'' = k'^2)
    MeetsSilhouette,  ///< at an inflection seen along its tangent the apparent ridge runs into the
                      ///< silhouette
    HeadOn,  ///< at a ridge, valley or flat point seen head-on the branch crosses its line (offset
             ///< 0)
  };
  What what;
  int curve;
  double angleDeg;  ///< in (-90, 90], modulo 180
  double t, u;
};

struct Sweep {
  std::vector<SweepLine> lines;
  std::vector<SweepBranch> branches;
  std::vector<SweepEvent> events;  ///< by curve, then t
  /// All events were isolated, with certified signs or within the bound of proxies.
  bool complete = true;
  bool certified = true;  ///< no proxies were needed
  /// Neighbouring points are as close as a branch promises. False where a curve or scene has so
  /// many branches that the points allowed are spent (20,000 and 400,000): then later branches have
  /// 16 steps each, and between two of them the angle may turn unseen.
  bool fine = true;
};

/// The sweep of a scene. Its own view only names the sides: ridge or valley as in that view. Its
/// distance does not matter.
Sweep sweepOf(const Scene& scene);

/// Angle modulo 180 degrees, in (-90, 90].
double halfTurnDeg(double angleDeg);

}  // namespace flatland
