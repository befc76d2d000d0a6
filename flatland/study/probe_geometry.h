// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "flatland/curve/curve.h"
#include "flatland/features/terms.h"

namespace flatland {

/// n.w below which a place counts as a silhouette, where lambda and dn/di are infinite: a probe put
/// on one misses it by rounding.
inline constexpr double kSilhouetteNw = 1e-9;

/// Terms::lambda, but nullopt at a silhouette to within kSilhouetteNw.
std::optional<double> lambdaAt(const Terms& terms);

/// dn/di, how fast the normal turns for a step on the screen: its component along the screen axis,
/// k / |n.w| (1/length). Its size is sqrt(lambda), and it is k where the curve is seen head-on.
/// nullopt at a silhouette.
std::optional<double> screenTurnAt(const Terms& terms);

/// |offset| / |feature|, 0 at an inflection. nullopt where the feature term is 0 to rounding on a
/// curve of size `size` (> 0, length): at a silhouette (kSilhouetteNw), where k is extreme, on a
/// straight piece.
std::optional<double> termRatioAt(const Terms& terms, double size);

/// The circle that touches the curve to second order.
struct OsculatingCircle {
  Vec2 centre;
  double radius;  ///< 1 / |k|
};

/// nullopt where the radius is above `largest` (length > 0): the circle is then its tangent line.
/// Precondition: jet.d1 is not zero.
std::optional<OsculatingCircle> osculatingCircle(const Jet& jet, double largest);

/// A tooth of a curvature comb: from the curve, along the normal, to the side to which the curve
/// bulges, `scale` |k| long.
struct CombTooth {
  Vec2 foot, tip;
};

/// The comb of a curve: teeth at equal steps of about `spacing` (length > 0) along it, at most
/// 2,000 for a piece and with one at each end; one list for each piece, between which k may jump.
/// `scale` in length^2; no tooth is longer than `longest` (length). Places without a tangent have
/// no tooth.
std::vector<std::vector<CombTooth>> curvatureComb(const Curve& curve, double spacing, double scale,
                                                  double longest);

}  // namespace flatland
