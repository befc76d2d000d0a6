// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "flatland/curve/curve.h"
#include "flatland/roots/isolate.h"
#include "flatland/view/view.h"

namespace flatland {

/// The functions of s, the parameter of an arc, whose roots are its marks.
enum class ArcFunction {
  Silhouette,      ///< sign of n.w for the left normal
  Curvature,       ///< sign of -k for the left normal
  CurvaturePrime,  ///< sign of -dk/du for the left normal
  LambdaPrime,     ///< sign of dlambda/du * Curvature * Silhouette
  Fold,            ///< sign of k^4 + k k'' - k'^2 (docs/math/sweep.md); no view enters
};
inline constexpr int kArcFunctionCount = 5;

/// How good proxies were, where roots came from them.
struct ProxyQuality {
  int pieces = 0;      ///< polynomials over all functions; 0 where signs are certified
  int degree = 0;      ///< largest of them
  double error = 0.0;  ///< largest estimated error, relative to the size of the function

  void add(const ProxyQuality& other) {
    pieces += other.pieces;
    degree = std::max(degree, other.degree);
    error = std::max(error, other.error);
  }
};

/// A stretch of a piece on which the curve has a tangent everywhere, and the view it is seen in:
/// all that decides its marks, whatever the kind of curve. Pieces are cut at interior cusps, so a
/// cusp is always an end. s runs over [0, 1]. Zeros that a function has only because the speed is
/// zero at an end are taken out of it.
class ViewedArc {
 public:
  virtual ~ViewedArc() = default;

  int piece = 0;
  double tLow = 0.0, tHigh = 1.0;     ///< the stretch in the piece's parameter
  bool straight = false;              ///< k = 0 throughout: only Silhouette has roots
  bool endOn = false;                 ///< straight and along the line of sight: no roots at all
  bool constantCurvature = false;     ///< a circle: CurvaturePrime has no roots
  Vec2 startDirection, endDirection;  ///< unit tangents at s = 0 and s = 1, one-sided

  /// -k for the left normal at s = 0 and s = 1, one-sided, 1/length; infinite at most cusps, empty
  /// where the sign of the infinity is undecided.
  std::optional<double> startCurvature, endCurvature;

  double parameter(double s) const {
    return tLow == 0.0 && tHigh == 1.0 ? s : tLow + s * (tHigh - tLow);
  }

  /// Roots in s; found at the first call and kept.
  const Roots& roots(ArcFunction function) const;

  /// +1 or -1 where the sign is certain, else 0.
  virtual int signAt(ArcFunction function, double s) const = 0;

  /// Of all roots found so far.
  virtual ProxyQuality quality() const { return {}; }

 private:
  virtual Roots findRoots(ArcFunction function) const = 0;

  mutable std::array<std::optional<Roots>, kArcFunctionCount> roots_;
};

/// How roots are to be found.
enum class RootMethod {
  BestKnown,  ///< certified where the curve has a Bezier form, else by proxies
  Proxies,    ///< by proxies whatever the curve: to compare
};

/// The arcs of a piece, in order; empty if all of it is one point. `extent` is the size of the
/// curve (length), which says what is small. The arcs keep a reference to `curve`. An arc is not
/// thread safe.
std::vector<std::unique_ptr<ViewedArc>> viewedArcs(const Curve& curve, int piece,
                                                   const ViewFrame& frame, double extent,
                                                   RootMethod method = RootMethod::BestKnown);

/// Parameters in [0, 1], ascending, at which the image of a piece on the screen may fold, or at
/// which it passes beside a viewer in perspective: between them it does neither.
std::vector<double> foldCuts(const Curve& curve, int piece, const ViewFrame& frame, double extent);

}  // namespace flatland
