// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core3d/diff/surface_fields.h"
#include "core3d/lines/surface_view.h"
#include "flatland/study/derivation.h"

namespace flatland {

/// The steps of chapter 4 of the thesis at a point of a surface (bibliography: judd2007thesis;
/// docs/math/derivation.md), in its order. Texts, sides and residuals are as those of
/// flatland/study/derivation.h.
enum class SurfaceStep {
  View,            ///< w in the frame of the place
  Eq4_1,           ///< the curvature matrix K, from how the normal turns
  Eq4_2,           ///< its derivative C
  Foreshortening,  ///< det P = n.w
  Projection,      ///< P^T P, which needs no screen
  Inverse,         ///< P^-1 P = 1
  Metric,          ///< G = (P^T P)^-1
  Eq4_3,           ///< Q = K P^-1
  Lambda,          ///< the largest turn of n per step on the screen, squared
  Direction,       ///< t_A is an eigenvector
  UnitDirection,   ///< t_A has length 1
  Turn,            ///< how n turns along t_A
  Eq4_4,           ///< the terms of D lambda that vanish
  Eq4_5,           ///< the one that is left
  Eq4_6,           ///< D K
  Footnote,        ///< D P^-1; misprinted
  Eq4_7,           ///< D P; misprinted
  Eq4_8,           ///< D lambda; misprinted
  Terms,           ///< 1/2 D lambda, feature plus offset
  Perspective,     ///< the same with lines of sight that meet in the viewer
};
inline constexpr int kSurfaceStepCount = 20;

const DerivationStepText& textOf(SurfaceStep step);
std::optional<SurfaceStep> surfaceStepNamed(std::string_view id);

/// A point of a surface and from where it is seen. Lengths in units of SurfaceFields::size.
struct SurfacePlace {
  SurfacePoint point;      ///< in its principal frame, exactly orthonormal; K = diag(k1, k2)
  Eigen::Vector3d w;       ///< unit, towards the viewer
  Eigen::Vector3d ux, uy;  ///< right and up on the screen, orthonormal, ux x uy = w
  std::optional<double> distance;  ///< of the viewer; empty: orthographic
};

/// The place at a vertex. `right`, any length, is what is horizontal on the picture. Empty where
/// the normal is unknown, or at the viewer itself.
std::optional<SurfacePlace> surfacePlaceAt(const TriangleMesh& mesh, const SurfaceFields& fields,
                                           const SurfaceView& view, const Eigen::Vector3d& right,
                                           std::uint32_t vertex);

/// What chapter 4 is about, as numbers. Matrices act on (t1, t2) or give it; the screen is (ux,
/// uy).
struct SurfaceMatrices {
  Eigen::Matrix2d K, P;
  Eigen::Vector2d wT;
  double nw;
  /// The rest only where nw is not 0, see apparentCurvature().
  std::optional<ApparentCurvature<2>> seen;
  Eigen::Matrix2d inverseP, Q, QtQ;
  double otherLambda;  ///< the smaller eigenvalue of Q^T Q
  Eigen::Vector2d tA;  ///< on the screen
};
SurfaceMatrices surfaceMatrices(const SurfacePlace& place);

/// Evaluates a step. Left sides come from their definitions on the surface that has K and C here
/// and no more (a cubic graph over the tangent plane): normals, projections and eigenvalues of
/// neighbouring points, differentiated exactly (flatland/study/series.h). Every step but
/// Perspective keeps the line of sight of the place, as the thesis does. Cost: microseconds.
StepReading readStep(SurfaceStep step, const SurfacePlace& place);

/// Difference quotients of the left side, as for curves; only of steps that differentiate along r.
std::vector<StepDifference> stepSizeSweep(SurfaceStep step, const SurfacePlace& place);

}  // namespace flatland
