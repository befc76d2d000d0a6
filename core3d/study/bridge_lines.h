// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core3d/lines/surface_view.h"
#include "core3d/mesh/swept.h"
#include "core3d/mesh/triangle_mesh.h"
#include "flatland/features/features.h"

namespace flatland {

/// A surface swept by a plane curve (mesh/swept.h).
struct SweptSurface {
  enum class Kind : std::uint8_t { Extrusion, Revolution };
  Curve curve;
  Kind kind = Kind::Extrusion;
  double amount = 2.0;  ///< Extrusion: the height, > 0; Revolution: x of the axis
  bool turned = false;  ///< the outside is the other side than mesh/swept.h says
};

/// The surface, turned if its curve is open and its outside is not the side of the curve's normal
/// (normalSide): so that what flatland sees from the front is the front. Unchanged without a flat
/// view.
SweptSurface turnedLike(const SceneCurve& curve, SweptSurface surface, const SurfaceView& view);

/// A mesh of it: `cells` (at least) along the curve, even in t, and across as many as make cells
/// square where the curve runs with its mean speed. Polynomial curves slow down in their bends, so
/// even steps of t resolve these better than even lengths.
SweptMesh sweptMesh(const SweptSurface& surface, int cells);

/// Below this sine a direction counts as that of an axis, or of a plane's normal: the rounding of a
/// normalised direction is far below it.
inline constexpr double kSeenAlong = 1e-9;
/// Why there is no flat view of what is seen in perspective; a sentence for people.
inline constexpr std::string_view kNoFlatPerspective =
    "a perspective view turns from place to place; the bridge needs an orthographic one";

/// From where flatland has to look at the curve so that its marks are those of the surface: for an
/// extrusion along the projection of w into the curve's plane, from any direction; for a revolution
/// along its axis, from its ends. Empty, with the reason for a person, where there is no such view.
struct FlatView {
  std::optional<View> view;
  std::string whyNot;
};
FlatView flatViewOf(const SweptSurface& surface, const SurfaceView& view);

/// Why a line of the surface cannot be expected where flatland has a mark, or is not expected from
/// a mesh of the given resolution. The first that applies, in this order.
enum class BridgeLimit : std::uint8_t {
  None,            ///< the line has to be there
  FacesAway,       ///< n.w < 0: ridges are not looked for on that side
  ParallelWins,    ///< revolution: the largest turning is across the meridian, or nearly so
  Pole,            ///< revolution: the axis within a few edges, where parallels shrink to a point
  Crease,          ///< a corner, cusp, or joint where curvature jumps, within a few edges
  End,             ///< the border within a few edges: neighbourhoods are one-sided
  SilhouetteNear,  ///< n.w is small, or 0 within a few edges: lambda grows without bound
  SharpBend,       ///< the radius of curvature is only a few edges, or is at a bend within as many
  Slight,          ///< lambda hardly falls on a side of its maximum: a plain with noise on it
};
inline constexpr std::size_t kBridgeLimitCount = 9;
std::string_view nameOf(BridgeLimit limit);    ///< "silhouette-near"
std::string_view reasonOf(BridgeLimit limit);  ///< a sentence for people

/// What is near and what is small, as lengths; 0: an infinitely fine mesh, and a maximum counts
/// however slight.
struct BridgeScale {
  double edge = 0.0;  ///< of the mesh
  double size = 0.0;  ///< SurfaceFields::size in the unit of the curve
};

/// What would keep a line from being expected on a coarser mesh.
struct LimitAhead {
  BridgeLimit limit = BridgeLimit::None;  ///< the first; None: none up to 8 times coarser
  double coarser = 0.0;                   ///< how many times coarser, 1: on this mesh; 0: none
};

/// A line predicted by a mark of the curve.
struct PredictedLine {
  MarkKind kind;                        ///< ApparentRidge or Silhouette
  double t;                             ///< of the mark
  Vec2 mark;                            ///< where it passes the plane of the curve
  double facing;                        ///< n.w there, of the surface
  double lambda;                        ///< 1/length^2; infinite at a silhouette
  bool closed;                          ///< a circle: its last point is followed by the first
  std::vector<Eigen::Vector3d> points;  ///< a ruling, or 256 points on a circle; curve's unit
};

/// What flatland knows of a swept surface (docs/math/bridges.md).
class BridgePrediction {
 public:
  BridgePrediction(const SweptSurface& surface, const SurfaceView& view);

  const FlatView& flat() const { return flat_; }
  const SweptSurface& surface() const { return surface_; }
  const Eigen::Vector3d& towards() const { return towards_; }  ///< unit, to the viewer
  /// All marks' lines, also those that a limit applies to; none without a flat view.
  const std::vector<PredictedLine>& lines() const { return lines_; }

  BridgeLimit limitOf(const PredictedLine& line, const BridgeScale& scale) const;
  /// How far a line is from its next limit. Margin for what is measured of it: distances grow where
  /// a limit is near. Found to a tenth.
  LimitAhead limitAhead(const PredictedLine& line, const BridgeScale& scale) const;
  /// That of a place of the surface, over t of the curve, for a line of that kind; never Slight.
  /// Precondition: there is a flat view.
  BridgeLimit limitAt(MarkKind kind, double t, const BridgeScale& scale) const;
  /// True within a few edges of the border that an extrusion has above and below.
  bool isNearLid(const Eigen::Vector3d& p, const BridgeScale& scale) const;

  /// Distance of a place near the surface to the whole ruling or circle of a line.
  double distance(const PredictedLine& line, const Eigen::Vector3d& p) const;

 private:
  struct Place;
  Place placeAt(double t) const;
  double arcOf(double t) const;
  bool isSlight(const PredictedLine& line, double size) const;

  SweptSurface surface_;
  Eigen::Vector3d towards_;
  FlatView flat_;
  ViewFrame frame_{};
  std::vector<PredictedLine> lines_;
  std::vector<double> arcs_;                          ///< arc length at even steps of t
  std::vector<double> creases_, ends_, silhouettes_;  ///< arc lengths
  struct Bend {
    double arc, k;  ///< |k|
  };
  std::vector<Bend> bends_;  ///< local maxima of |k|
};

/// Points in the coordinates of a mesh that was built from the surface.
std::vector<Eigen::Vector3f> inMeshCoordinates(const std::vector<Eigen::Vector3d>& points,
                                               const TriangleMesh& mesh);

}  // namespace flatland
