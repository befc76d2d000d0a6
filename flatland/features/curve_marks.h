// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "flatland/features/features.h"
#include "flatland/features/viewed_arc.h"

namespace flatland {

/// A mark before its values are known: what and where.
struct CurveMark {
  MarkKind kind;
  int piece;
  double t;              ///< local parameter of the piece, in [0, 1]
  bool atJoint = false;  ///< judged from both sides of a joint or cusp: no equation holds there
  /// Where curvature jumps: the piece and parameter of the side whose value makes the mark. Empty:
  /// the mark's own.
  std::optional<std::pair<int, double>> valueAt = std::nullopt;
  double turnRad = 0.0;  ///< corners
};

struct CurveMarks {
  std::vector<CurveMark> marks;        ///< in no particular order
  std::vector<Unresolved> unresolved;  ///< `curve` not filled
  std::vector<Degenerate> degenerate;  ///< `curve` not filled
  ProxyQuality quality;                ///< of the worst proxy; no pieces if signs are certified
};

/// Marks of one curve: the roots of the functions of each arc (viewed_arc.h), and what happens
/// where arcs meet, be it at joints of the chain or at cusps. `side` as from normalSide().
///
/// At a joint whose tangent is continuous, silhouettes and inflections count once if the sign
/// changes across it, and an extremum counts if the value there is the largest (smallest) of both
/// sides, also when curvature or its derivative jumps. Ends of an open curve carry silhouettes and
/// inflections, but no extrema.
CurveMarks findCurveMarks(const Curve& curve, const ViewFrame& frame, int side,
                          RootMethod method = RootMethod::BestKnown);

}  // namespace flatland
