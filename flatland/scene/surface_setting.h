// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace flatland {

// What a scene says of the surface beside its curves: which one, from where it is seen and how it
// is drawn. Plain values; what the names stand for is known to the rooms above.

/// From where the surface is seen, in coordinates that neither unit nor place of its file changes
/// (the middle of the bounding box is 0, its longest side 2).
struct SurfaceCamera {
  Eigen::Vector3d towards = Eigen::Vector3d(0.45, 0.3, 1.0).normalized();  ///< to the viewer, unit
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();     ///< on the picture; not along `towards`
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< seen in the middle of the picture
  double zoom = 1.0;                                 ///< > 1: larger than fitted
  /// Vertical field of view within the limits of flatland/view/perspective.h; empty: none.
  std::optional<double> perspectiveDeg;

  bool operator==(const SurfaceCamera&) const = default;
};

struct SavedCamera {
  std::string name;
  SurfaceCamera camera;

  bool operator==(const SavedCamera&) const = default;
};

/// One family of lines. The name is that of the command line, "apparent-ridges".
struct SurfaceFamily {
  std::string name;
  bool on = true;
  std::optional<double> threshold;  ///< dimensionless, >= 0; empty: as usual for the family
  std::string colour;               ///< "#rrggbb"; empty: the one that suits the background
  double widthPx = 1.6;             ///< > 0
  bool fade = true;                 ///< weak lines are paler

  bool operator==(const SurfaceFamily&) const = default;
};

/// A further view of the surface, beside the first. What it does not say is as in the first.
struct SurfacePane {
  std::optional<std::vector<std::string>> families = {};  ///< names of those it draws
  std::string derivative =
      "closed-form";            ///< of its apparent ridges; "one-ring": as the thesis did
  std::string shows = "lines";  ///< "difference": where it and the first view disagree
  /// Looks from elsewhere at the lines that are found for the camera of the first view.
  std::optional<SurfaceCamera> camera = {};

  bool operator==(const SurfacePane&) const = default;
};

/// A surface made of one of the scene's curves, which it follows.
struct SweptSetting {
  std::string kind = "extrusion";  ///< or "revolution"
  std::size_t curve = 0;           ///< index into Scene::curves; a surface of none is not shown
  double amount = 1.0;  ///< extrusion: height, > 0; revolution: x of the axis; unit of the curve
  int cells = 64;       ///< along the curve, 3 to 1000

  bool operator==(const SweptSetting&) const = default;
};
inline constexpr int kFewestSweptCells = 3, kMostSweptCells = 1000;

/// A plane that cuts the surface, in the coordinates of SurfaceCamera.
struct SurfacePlane {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  ///< unit

  bool operator==(const SurfacePlane&) const = default;
};

struct SurfaceSetting {
  /// A mesh file (in files: relative to the scene's folder; in memory: absolute), "solid:" and the
  /// name of a built-in one, or "swept:" for what `swept` says.
  std::string mesh;
  SurfaceCamera camera;
  std::vector<SavedCamera> savedCameras;
  std::vector<SurfaceFamily> families;  ///< each name once; those not listed are as usual
  std::string style = "lambert";        ///< what is below the lines: "paper", "lambert", ...
  std::string quantity = "lambda";      ///< what the style "colours" shows: "k1", "k2", ...
  std::string hidden = "off";           ///< hidden lines: "off", "dashed", "shown"
  bool unfiltered = false;              ///< every crossing of the defining equations
  int isophotes = 10, heights = 20;     ///< how many levels, >= 1
  double fitScale = 1.0;                ///< of the neighbourhoods of the jet fit, >= 1
  std::string upAxis = "y";             ///< of the file, upward in standard views; or "-z", ...
  std::vector<SurfacePane> panes;       ///< beside the first view; at most kMostPanes
  std::optional<double> ink;            ///< share of each view its lines cover, in (0, 1]
  std::optional<SweptSetting> swept;    ///< there if `mesh` is "swept:"
  std::optional<SurfacePlane> plane;

  bool operator==(const SurfaceSetting&) const = default;
};

inline constexpr std::size_t kMostPanes = 3;
inline constexpr const char* kUpAxes[] = {"x", "-x", "y", "-y", "z", "-z"};
inline constexpr char kSolidPrefix[] = "solid:";
inline constexpr char kSweptMesh[] = "swept:";
/// True if the reference names a built-in solid, not a file.
inline bool namesSolid(const std::string& mesh) { return mesh.rfind(kSolidPrefix, 0) == 0; }
/// True if it names a mesh file.
inline bool namesFile(const std::string& mesh) { return !namesSolid(mesh) && mesh != kSweptMesh; }

}  // namespace flatland
