// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flatland/scene/scene.h"

namespace flatland {

/// What a mark on a curve stands for. Signs refer to the normal of normalSide().
enum class MarkKind {
  Silhouette,       ///< n.w = 0, or the curve's image on the screen folds (at a corner or cusp)
  Inflection,       ///< k changes sign
  Ridge,            ///< local maximum of k, k > 0
  Valley,           ///< local minimum of k, k < 0
  Flat,             ///< local minimum of |k| that is no inflection
  Corner,           ///< the tangent jumps: a kink between pieces, or a cusp (turn of 180 degrees)
  ApparentRidge,    ///< local maximum of lambda where it is finite
  ApparentMinimum,  ///< local minimum of lambda that is no inflection
};
inline constexpr int kMarkKindCount = 8;

/// "silhouette", "inflection", "ridge", "valley", "flat", "corner", "apparent-ridge",
/// "apparent-minimum": the names in files and on the command line.
std::string_view nameOf(MarkKind kind);
std::optional<MarkKind> markKindNamed(std::string_view name);

/// One mark. Values that do not exist at the mark (lambda at a silhouette, terms at a corner) are
/// empty.
struct Mark {
  MarkKind kind;
  int curve;  ///< index in Scene::curves
  double t;   ///< chain parameter, in [0, pieceCount]
  double u;   ///< arc length from the start of the curve
  Vec2 point;
  std::optional<double> screen;   ///< 1D screen coordinate; empty at or behind the viewer
  bool visible;                   ///< nothing of the scene lies between the point and the viewer
  std::optional<double> lambda;   ///< |dn/di|^2 = k^2 / (n.w)^2, 1/length^2
  std::optional<double> feature;  ///< (n.w) k k', 1/length^3
  std::optional<double>
      offset;  ///< -k^3 (t.w), 1/length^3; feature + offset + perspective = 0 at an apparent ridge
  std::optional<double>
      perspective;  ///< -(n.w) k^2 (t.w) / distance to the viewer; 0 when orthographic
  double residual;  ///< dimensionless size of the defining equation at t, see terms.h; 0 where none
                    ///< applies (corners, folds there, extrema where the derivative jumps)
  double turnDeg =
      0.0;  ///< corners: by how much the tangent turns, counter-clockwise, in (-180, 180]
};

/// An interval of a curve in which marks of a kind could not be counted in double precision:
/// several roots, or none, closer together than can be told apart.
struct Unresolved {
  MarkKind kind;
  int curve;
  double tLow, tHigh;
  std::string reason;
};

/// A piece of a curve on which some kinds of mark are undefined by nature, with the stated answer.
struct Degenerate {
  enum class What {
    Point,              ///< all of it is one point (a formula may stand still): no marks
    Straight,           ///< k = 0 throughout: no inflections, extrema or apparent ridges
    StraightEndOn,      ///< straight and seen end-on: every point is a silhouette, none is marked
    ConstantCurvature,  ///< part of a circle: no extrema of k
  };
  What what;
  int curve;
  double tLow, tHigh;
};

/// How the marks of one curve were looked for.
struct CurveSearch {
  int curve;
  bool certified;      ///< by Bernstein polynomials with certified signs; else by Chebyshev proxies
  int pieces, degree;  ///< proxies: how many polynomials, and the largest degree; else 0
  /// Proxies: largest estimated distance between polynomial and function, relative to the size of
  /// the function. What comes nearer to 0 than that without crossing is listed as unresolved.
  double errorBound;
};

struct FeatureSet {
  std::vector<Mark> marks;  ///< by curve, then t, then kind
  std::vector<Unresolved> unresolved;
  std::vector<Degenerate> degenerate;
  std::vector<CurveSearch> searches;  ///< one for each curve that was examined, in order

  /// True if nothing is left open. If also certified(), every mark was found and none is invented,
  /// with proof. Where a curve is no polynomial it says less: that holds for any function within
  /// errorBound() of the one sampled, and what is narrower than the samples (1/500 of an arc, 1/30
  /// of a proxy's piece) can have escaped it. Within kJointWindow of a smooth joint marks are
  /// judged by the net change across it, and next to a cusp the certificate is for the curve with
  /// the cusp made exact (tolerances.h).
  bool complete() const { return unresolved.empty(); }

  /// True if no proxies were needed.
  bool certified() const;
  /// The largest of the searches; 0 if certified.
  double errorBound() const;
};

/// All marks of the scene. Every kind comes from the roots of a polynomial that are isolated with
/// certified signs (roots/isolate.h), or on a curve without Bezier form from proxies
/// (roots/chebyshev.h), on which a budget is spent and no more
/// (docs/decisions/0022-budgets.md); see docs/math/features.md for the polynomials and for the
/// answers in degenerate cases. t is accurate to its last bits where the root is simple, u to 1e-12
/// of the curve's length. Invariant under rotation of scene and view together, scaling,
/// reversal and splitting. Cost: about 0.1 ms of a 2.5 GHz core for one curve of 5 control points
/// (tests/bench).
/// Curves longer than 1e52 or shorter than 1e-52 are not examined; they are listed as unresolved.
FeatureSet findFeatures(const Scene& scene);

}  // namespace flatland
