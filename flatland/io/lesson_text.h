// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flatland/io/input_error.h"
#include "flatland/scene/scene.h"
#include "flatland/study/derivation.h"

namespace flatland {

/// A point of the scene's surface that a step picks.
struct LessonPick {
  bool isTriangle = false;   ///< else a vertex
  std::uint32_t number = 0;  ///< of the mesh, from 0

  bool operator==(const LessonPick&) const = default;
};

/// What a step of a lesson puts before the class. What a step does not name stays as in the step
/// before; a step holds it all, so it can be gone to directly.
struct LessonState {
  std::optional<Scene> scene;          ///< empty: the person's own
  std::optional<double> viewAngleDeg;  ///< over the scene's own view
  std::size_t probeCurve = 0;
  std::optional<double> probeT;           ///< empty: the probe stays where it is
  std::optional<Eigen::Vector3d> camera;  ///< unit: from where the surface is seen; empty: scene's
  std::optional<LessonPick> pick;         ///< on the surface; empty: as it is
  /// Names of nameOf(MarkKind), perhaps none; empty: as the person has them.
  std::optional<std::vector<std::string>> families;
  std::optional<DerivationStep> equation;
  bool printed = false;       ///< the equation as the thesis prints it
  bool printedRoots = false;  ///< the roots of (3.13) as printed, on the curve
  /// One of kSurfaceEquations, for the panel "surface-derivation" to show; empty: none.
  std::string surfaceEquation;
  std::string panel;  ///< dock to bring to the front; empty: none
};

struct LessonStep {
  std::string title;
  std::string text;   ///< Markdown
  bool stop = false;  ///< a place to talk at: "next stop" goes here
  /// Names its scene, view or probe itself: they are shown anew, whatever was dragged before.
  bool setsPlace = false;
  LessonState state;
};

/// A lesson: steps to go through, in a file a teacher writes by hand (docs/user/lesson-format.md).
struct Lesson {
  std::string title;
  std::vector<LessonStep> steps;  ///< at least one
};

/// The panels that a step may ask for: the docks of the window.
inline constexpr std::string_view kLessonPanels[] = {
    "view",    "legend", "probe",  "points",  "curve",    "plots",  "sweep",   "study",
    "limits",  "marks",  "lesson", "surface", "families", "bridge", "section", "surface-derivation",
    "triangle"};

/// The equations of a surface, as surfaceStepNamed() of core3d/study knows them.
inline constexpr std::string_view kSurfaceEquations[] = {
    "view",   "4.1",       "4.2",   "foreshortening", "projection", "inverse", "metric", "4.3",
    "lambda", "direction", "unit",  "turn",           "4.4",        "4.5",     "4.6",    "footnote",
    "4.7",    "4.8",       "terms", "perspective"};

inline constexpr std::size_t kLargestLessonBytes = 1024U * 1024U;
inline constexpr std::size_t kMostLessonSteps = 500;

/// Reads a lesson. `source` names the text in errors. Throws InputError with the line and the
/// reason: nothing is guessed or dropped, an unknown key is an error.
Lesson lessonFromText(const std::string& text, const std::string& source);

/// Reads a file. Throws InputError, also when the file cannot be read.
Lesson loadLesson(const std::filesystem::path& file);

}  // namespace flatland
