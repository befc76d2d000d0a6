// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core3d/mesh/polygon_soup.h"
#include "flatland/curve/curve.h"

namespace flatland {

/// Surfaces whose apparent ridges are known, since flatland has them: swept by a plane curve and
/// seen from where the ridges lie over those of the curve (docs/math/convergence.md).
enum class KnownCase : std::uint8_t {
  SineSheet,     ///< z = sin(2x)/2 over [-3, 3]^2 seen 30 degrees from its normal: straight lines
  GaussianBump,  ///< z = 2 exp(-r^2/2) over [-4, 4]^2 seen along its axis: a circle
  Extrusion,     ///< of a random Bezier graph, seen obliquely: straight lines
  Revolution,    ///< of a random Bezier graph, seen along its axis: circles
};

std::vector<std::string> knownCaseNames();
std::string_view nameOf(KnownCase subject);  ///< "sine-sheet"
std::optional<KnownCase> knownCaseNamed(std::string_view name);

/// A mesh of n x n cells; inner vertices are moved by up to a quarter of a cell if irregular. They
/// lie on the surface exactly.
struct KnownMeshing {
  int cells = 100;
  bool irregular = true;
  std::uint64_t seed = 1;  ///< of the moves
};

/// One of the surfaces with its apparent ridges, exact to 1e-12.
class KnownRidges {
 public:
  /// `curveSeed` chooses the random curve of Extrusion and Revolution.
  explicit KnownRidges(KnownCase subject, std::uint64_t curveSeed = 1);

  /// From the surface to the viewer, unit.
  const Eigen::Vector3d& towards() const { return towards_; }
  PolygonSoup meshed(const KnownMeshing& meshing) const;

  /// Distance from a place near the surface to the nearest apparent ridge; infinite without any.
  double distanceToRidge(const Eigen::Vector3d& p) const;
  /// Places on the ridges that face the viewer, `perRidge` evenly along each, none within a
  /// twentieth of a border.
  std::vector<Eigen::Vector3d> samples(int perRidge) const;
  /// Where the ridges pass the plane curve.
  const std::vector<Vec2>& marks() const { return marks_; }

 private:
  bool turns() const;
  Eigen::Vector3d place(const Vec2& onCurve, double along) const;
  Vec2 onCurvePlane(const Eigen::Vector3d& p) const;

  KnownCase subject_;
  Curve curve_;
  Eigen::Vector3d towards_;
  std::vector<Vec2> marks_;
};

}  // namespace flatland
