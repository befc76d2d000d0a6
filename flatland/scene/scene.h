// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flatland/curve/curve.h"
#include "flatland/scene/surface_setting.h"
#include "flatland/view/view.h"

namespace flatland {

/// One curve of a scene. Its normal points outward on a closed curve and towards the viewer on an
/// open one (see normalSide in features/orientation.h); `flipNormal` turns it round.
struct SceneCurve {
  Curve shape;
  bool flipNormal = false;

  /// The shape as a Bezier chain. Precondition: it is one.
  const BezierChain& chain() const { return std::get<BezierChain>(shape); }
  BezierChain& chain() { return std::get<BezierChain>(shape); }

  bool operator==(const SceneCurve&) const = default;
};

/// What is seen, and from where. A plain value.
struct Scene {
  std::vector<SceneCurve> curves;
  View view;
  std::optional<SurfaceSetting> surface = {};  ///< beside the curves; no marks are found on it

  bool operator==(const Scene&) const = default;
};

/// A built-in scene, named for the command line and the menu. "Degenerate cases" are those in which
/// a textbook formula has no answer; what the program answers is written in docs/math/features.md
/// and here in `expected`, and each has a test.
struct Preset {
  std::string id;           ///< stable, lower case: "thesis", "s-curve"
  std::string name;         ///< for people
  std::string description;  ///< one sentence: what there is to see
  Scene scene;
  std::string group = "Examples";  ///< for people: presets of one group stand together
  std::string expected = {};       ///< for people: the marks there must be; empty for an example
};

/// The presets that are worth looking at for themselves, in menu order; the first is the default
/// scene, which shows every kind of mark a smooth curve has.
const std::vector<Preset>& presets();

/// These and the catalogue of degenerate cases.
const std::vector<Preset>& allPresets();

/// presets().front().scene
const Scene& defaultScene();

/// Box around all curves and control points; {0,0}-{0,0} for a scene without curves.
Bounds boundsOf(const Scene& scene);

}  // namespace flatland
