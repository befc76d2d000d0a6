// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "core3d/diff/surface_fields.h"
#include "core3d/lines/surface_view.h"
#include "core3d/mesh/triangle_mesh.h"

namespace flatland {

/// What becomes of a triangle in the search for apparent ridges; all but Kept: no line, and why.
/// The first that holds, in this order.
enum class RidgeVerdict : std::uint8_t {
  UnknownNormal,   ///< of a corner
  Creased,         ///< a sharp edge parts the surface at a corner; the edge itself is the line
  NoCrossing,      ///< all directions agree: lambda has no extremum within
  TurnedAway,      ///< a corner faces away
  SingularPoint,   ///< one edge alone is crossed: a line that would end in the triangle
  DirectionsTurn,  ///< t_A turns too far from corner to corner for a derivative along it
  Weak,            ///< sqrt(lambda) is below the threshold
  Minimum,         ///< of lambda: a direction points away from the line
  Flat,            ///< a maximum, but lambda hardly falls beside it
  Kept,
};
inline constexpr int kRidgeVerdictCount = 10;
/// "kept", "no crossing".
std::string_view nameOf(RidgeVerdict verdict);

/// The algorithm of chapter 5 (bibliography: judd2007thesis, Fig. 5-1) on one triangle, stage by
/// stage, as LineFinder does it. Places and directions in coordinates of the mesh, curvatures and
/// derivatives dimensionless (lengths in units of SurfaceFields::size).
struct TriangleLesson {
  struct Corner {
    std::uint32_t vertex = 0;
    Eigen::Vector3d at, n;
    double nw = 0.0;
    double lambda = 0.0;      ///< infinite on a contour
    Eigen::Vector3d tangent;  ///< unit, on the surface over t_A, with the sign it came with; or 0
    double derivative = 0.0;  ///< 1/2 D_tA lambda along `tangent`, per step on the screen
    bool flipped = false;     ///< `derivative` < 0, so that lambda grows against `tangent`
    Eigen::Vector3d growing;  ///< unit, `tangent` turned so that lambda grows along it; or 0

    /// The thesis's estimate of the same (Fig. 5-1 a): at w and w', where the plane of t_A and n
    /// leaves the triangles round the corner. 0 to 2 places.
    std::vector<Eigen::Vector3d> ring;
    std::vector<double> ringLambda;
    double ringDerivative = 0.0;  ///< 1/2 D lambda along `tangent`, per step on the screen
  };
  /// An edge whose two directions point apart or at each other, from corner `corner` to the next.
  struct Crossing {
    int corner = 0;
    double t = 0.0;        ///< 0 at that corner, 1 at the next
    double thesisT = 0.0;  ///< by the derivatives of lambda themselves, as the thesis has it
    Eigen::Vector3d at;
    double strength = 0.0;  ///< sqrt(lambda) there
  };
  /// A piece of line between two crossings, or a crossing and the middle of the triangle.
  struct Piece {
    Eigen::Vector3d a, b;
    double strength = 0.0;  ///< the larger of both ends
    struct Test {
      int corner = 0;
      Eigen::Vector3d foot;  ///< of the perpendicular from the corner to the line
      double cosine = 0.0;   ///< between it and `growing`; > 0: an acute angle
      bool passes = false;
    };
    std::vector<Test> tests;  ///< of all corners, or of the two at the edge
    bool isMaximum = false;   ///< all pass
    /// How sqrt(lambda) falls beside the line, as a share of itself, along a parabola with its
    /// slopes at the corners; below Contrast::kFall the walk along the surface is not even begun.
    double fall = 0.0;
    bool standsOut = false;  ///< it falls far enough on both sides (contrast.h)
    bool drawn = false;
  };

  std::uint32_t triangle = 0;
  std::array<Corner, 3> corners;
  std::array<bool, 3> opposed{};  ///< of the edge from corner k on: more than 90 degrees apart
  std::vector<Crossing> crossings;
  std::vector<Piece> pieces;  ///< 1 for two crossings, 3 for three
  double threshold = 0.0;
  bool unfiltered = false;  ///< every crossing is drawn; the verdict is what the filters would say
  RidgeVerdict verdict = RidgeVerdict::NoCrossing;

  /// What the whole walk drew. It takes the last word on a piece (`standsOut`) from the triangle
  /// before on the same line where there is one, so here and there a piece that is Flat by itself
  /// is drawn, or one that is Kept is not.
  bool drawn = false;
  bool followsNeighbour() const { return !unfiltered && drawn != (verdict == RidgeVerdict::Kept); }
};

/// Tells it for triangles of one mesh, view after view. `mesh` and `fields` outlive it.
class TriangleStudy {
 public:
  TriangleStudy(const TriangleMesh& mesh, const SurfaceFields& fields);
  ~TriangleStudy();

  /// With the closed form of the derivative, as lines are found by default. `unfiltered` as in
  /// LineOptions, where crossings lie at the zeros of the derivative itself. A search over the
  /// whole mesh: some milliseconds for a hundred thousand triangles. Not for several threads at
  /// once.
  TriangleLesson lesson(std::uint32_t triangle, const SurfaceView& view, double threshold,
                        bool unfiltered = false);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace flatland
