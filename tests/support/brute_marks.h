// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "flatland/features/features.h"

namespace flatland::test {

/// A mark found by sampling.
struct BruteMark {
  MarkKind kind;
  double t;  ///< chain parameter
};

/// The marks strictly inside the pieces of a curve, ascending, by a dense search that shares
/// nothing with the program: power series of the unit normal and the screen coordinate along the
/// curve, signs at about 1,000 samples a piece (in 50 digits where long double is in doubt),
/// bisection between samples of unlike sign, and a search for the bottom wherever samples of one
/// sign come nearer to zero than their neighbours. `looked` are places to sample more closely, down
/// to 2^-40 around each; what is found there is decided by the same signs.
std::vector<BruteMark> bruteMarks(const BezierChain& chain, const ViewFrame& frame, int side,
                                  const std::vector<double>& looked);

/// |dn/di|^2 at local parameter t of a piece, from the series.
double bruteLambda(const Bezier& piece, const ViewFrame& frame, double t);

/// What differs between the marks inside the pieces that the program found for curve `index` and
/// the brute ones; empty if they agree in kind, order and place (to 1e-8 in t). Also holds every
/// strict local maximum of sampled lambda against the apparent ridges.
std::string differenceFromBrute(const Scene& scene, const FeatureSet& found, int index);

/// The scene in control points, to 17 digits, for failures.
std::string described(const Scene& scene);

}  // namespace flatland::test
