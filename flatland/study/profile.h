// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "flatland/features/features.h"
#include "flatland/features/terms.h"

namespace flatland {

/// What the plots show at one place of a curve. Signs and units as in Terms (features/terms.h).
struct ProfileSample {
  double t;                      ///< chain parameter
  double u;                      ///< arc length from the start of the curve
  Vec2 point;                    ///< on the curve
  std::optional<double> screen;  ///< 1D screen coordinate; empty at or behind the viewer
  double nw, tw;                 ///< n.w and t.w
  double k, kPrime;              ///< 1/length, 1/length^2
  std::optional<double> lambda;  ///< k^2 / nw^2; empty at a silhouette and on a piece seen end-on
  double feature, offset, perspective;  ///< 1/length^3
  std::optional<double> ratio;          ///< |offset| / |feature|; empty where the feature term is 0

  double sum() const { return feature + offset + perspective; }
};

/// A stretch of the curve inside which all of the quantities above are smooth; values may be
/// missing at its ends, but in a straight piece also throughout.
struct ProfileSegment {
  std::vector<ProfileSample> samples;  ///< in order of t, at least 2
};

/// The quantities along one curve, sampled. Cut at silhouettes, curvature extrema (where the
/// feature term passes 0), corners, cusps, and joints where a quantity jumps: one segment ends
/// there and the next begins at the same t, with the one-sided values. At a cusp, where nothing is
/// defined, both keep a hair's breadth away. Every mark of the curve but a cusp is a sample.
struct Profile {
  int curve = 0;
  double length = 0.0;  ///< arc length; 0 if all points of the curve coincide: no segments then
  std::vector<ProfileSegment> segments;

  std::size_t sampleCount() const;
};

struct ProfileOptions {
  /// How far a sample may be from the straight line between its neighbours. 1: 1/500 of the median
  /// of |k|, 0.4 % of a term (absolute below the median of the terms) and 1 % of lambda and the
  /// ratio: less than a pixel on a plot of 500 pixels' height. The number of samples goes with the
  /// inverse square root at most.
  double tolerance = 1.0;
};

/// The profile of curve `curve` of the scene, whose marks are `features`. Bounded cost: at most
/// about 4,000 samples for a piece; 0.5 ms for a curve of 5 control points (tests/bench). u is
/// accurate to 1e-9 of the length. Lambda is followed into silhouettes and inflections over eight
/// decades from its median, the ratio over five. Precondition: the curve exists.
Profile profileOf(const Scene& scene, const FeatureSet& features, int curve,
                  const ProfileOptions& options = {});

/// Arc length from the start to chain parameter `t`, to 1e-9 of the length; `profile` is that of
/// `curve`.
double lengthAt(const Curve& curve, const Profile& profile, double t);

/// The chain parameter at arc length `u`, clamped to the curve; to 1e-9 of the length.
double parameterAtLength(const Curve& curve, const Profile& profile, double u);

}  // namespace flatland
