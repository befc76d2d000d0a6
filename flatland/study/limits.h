// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "flatland/scene/scene.h"

namespace flatland {

/// How view-dependent curvature and the two terms behave on the way to a silhouette: measured along
/// three ways, with the power laws that theory predicts (docs/math/limits.md). Views are
/// orthographic.
enum class LimitExperiment {
  Turn,  ///< a fixed point, the view turned towards its tangent; x is |n.w|, from 1 downwards
  Walk,  ///< a fixed view, a walk along the curve to the nearest silhouette or cusp; x is the arc
         ///< length to go
  Slide  ///< an apparent ridge runs into the silhouette at an inflection as the view turns; x is
         ///< the angle to go, in radians
};

/// What is found at the end of the way.
enum class LimitCase {
  FixedPoint,              ///< Turn
  OrdinarySilhouette,      ///< k is not zero there
  SilhouetteAtInflection,  ///< k goes through zero there: n.w ~ s^2
  HigherContact,           ///< k vanishes to a higher order
  CuspSeenAcross,          ///< the speed vanishes, n.w does not
  CuspSeenAlong,           ///< the speed vanishes and the cusp points at the viewer or away
  Merging                  ///< Slide
};

enum class LimitQuantity {
  Lambda,
  Feature,             ///< |feature term|
  Offset,              ///< |offset term|
  Ratio,               ///< |offset| / |feature|
  RidgeDistance,       ///< Slide: arc length from the nearest apparent ridge to the inflection
  SilhouetteDistance,  ///< Slide: the same of the silhouette, from the other side of the angle
};

/// Names for files: "turn", "ordinary-silhouette", "lambda", ...
std::string_view nameOf(LimitExperiment experiment);
std::string_view nameOf(LimitCase limitCase);
std::string_view nameOf(LimitQuantity quantity);

/// A straight line through log y against log x, by least squares.
struct LogLogFit {
  double slope, slopeError;  ///< and its standard error
  double coefficient;        ///< y ~ coefficient x^slope
  double xLow, xHigh;        ///< of the points it goes through
  int points;
};

/// The fit through the points with x in [xLow, xHigh] and a positive, finite y; nullopt with fewer
/// than 4. Precondition: sizes are equal.
std::optional<LogLogFit> fitLogLog(const std::vector<double>& x, const std::vector<double>& y,
                                   double xLow, double xHigh);

/// One quantity along the way: y ~ coefficient x^order as x goes to 0.
struct LimitLaw {
  LimitQuantity quantity;
  std::optional<double> order;        ///< predicted; empty if the quantity vanishes, or none is
  std::optional<double> coefficient;  ///< predicted
  std::vector<double> values;         ///< at each x; NaN where there is none
  std::optional<LogLogFit> fit;       ///< over the last decade that rounding leaves alone
};

struct LimitSeries {
  LimitExperiment experiment;
  LimitCase limitCase;
  int curve;
  double t, u;            ///< where the way ends; Turn: the point
  double angleDeg;        ///< of the view there
  std::vector<double> x;  ///< descending
  std::vector<LimitLaw> laws;
};

/// Turn at a point. Exact in theory: lambda = k^2 / (n.w)^2. nullopt at a cusp.
std::optional<LimitSeries> turnToSilhouette(const Scene& scene, int curve, double t);

/// Walk from the point to the silhouette or cusp nearest along the curve, in the scene's direction
/// of view; on a closed curve the shorter way around. nullopt if the curve has none, or only at a
/// corner.
std::optional<LimitSeries> walkToSilhouette(const Scene& scene, int curve, double t);

/// Slide at the inflection nearest to the point along the curve. Every root is found anew, by
/// findFeatures. On a formula on which that takes more than 2 million evaluations there are fewer
/// views, which end at a larger angle, as `x` says (at least 1.5 decades with 4 views each). Of a
/// typed formula as dear only what lies up to the second inflection on either side is then
/// searched. nullopt if the curve has no inflection with k' != 0 that is not at an end, or once
/// `goOn`, which is asked before each view, says no.
std::optional<LimitSeries> slideIntoSilhouette(const Scene& scene, int curve, double t,
                                               const std::function<bool()>& goOn = {});

/// What grows and what vanishes at a place in the scene's view, as amounts: without the signs that
/// come from the side of the normal.
struct ForeshortenedTerms {
  double nw;                     ///< |n.w|
  double feature, offset;        ///< 1/length^3, see Terms
  std::optional<double> lambda;  ///< empty where |n.w| is below 1e-12, the rounding of the view's
                                 ///< angle: a silhouette
};
/// nullopt where the speed vanishes.
std::optional<ForeshortenedTerms> foreshortenedTerms(const Scene& scene, int curve, double t);

/// The direction of view, in degrees, from which a point with this tangent (unit) has |n.w| = `nw`
/// (0 to 1): on the side of the normal and of the tangent on which `nearDeg` sees it.
double angleDegWithForeshortening(const Vec2& tangent, double nw, double nearDeg);

}  // namespace flatland
