// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "flatland/study/profile.h"

namespace flatland {

/// One quantity of a profile.
enum class ProfileQuantity { Curvature, Lambda, Feature, Offset, Perspective, Sum, Ratio };

std::optional<double> valueOf(const ProfileSample& sample, ProfileQuantity quantity);

/// What a profile is drawn against.
enum class Abscissa { ArcLength, Screen };

std::optional<double> abscissaOf(const ProfileSample& sample, Abscissa abscissa);

/// The quantity as polylines of (abscissa, value), each without a break: none passes a silhouette
/// (lambda, ratio), a zero of the feature term (ratio), a corner, a cusp, or a jump at a joint.
/// With `positiveOnly`, for a logarithmic axis, also none passes a value that is not positive.
std::vector<std::vector<Vec2>> linesOf(const Profile& profile, ProfileQuantity quantity,
                                       Abscissa abscissa, bool positiveOnly = false);

/// The chain parameters at which the abscissa is `x`, in order, to the accuracy of the sampling
/// (linear between samples); one for the arc length, any number for the screen.
std::vector<double> parametersAt(const Profile& profile, Abscissa abscissa, double x);

/// The lowest and highest value of the abscissa; nullopt for a profile without samples.
std::optional<std::pair<double, double>> extentOf(const Profile& profile, Abscissa abscissa);

/// The values a quantity takes, weighted by arc length: how to choose an axis that a peak of
/// infinite height does not flatten.
class ProfileSpread {
 public:
  /// Takes |value| if `magnitudes`. Only samples with the abscissa between `low` and `high` count.
  ProfileSpread(const Profile& profile, ProfileQuantity quantity, Abscissa abscissa, double low,
                double high, bool magnitudes = false);

  bool empty() const { return values_.empty(); }

  /// The value below which the quantity stays for this share of the arc length; 0: the smallest, 1:
  /// the largest. Precondition: not empty.
  double quantile(double share) const;

 private:
  std::vector<std::pair<double, double>> values_;  ///< value, weight up to and with it
};

}  // namespace flatland
