// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "core3d/draw/drawing.h"

namespace flatland {

/// Draws one mesh from many views: finds lines, chains and filters strokes, removes what is hidden.
/// Keeps the structure for casting rays, which is built at the first drawing, and a LineFinder.
/// `mesh` and `fields` must outlive it and stay unchanged. Not for several threads at once.
class Draughtsman {
 public:
  Draughtsman(const TriangleMesh& mesh, const SurfaceFields& fields);
  ~Draughtsman();
  Draughtsman(Draughtsman&&) noexcept;
  Draughtsman& operator=(Draughtsman&&) noexcept;

  /// Without polylines if stopped.
  Drawing draw(const Projection& projection, const LineOptions& lines,
               const StrokeOptions& strokes);

  /// The lines that are found for `view`, looked at from elsewhere.
  Drawing draw(const Projection& projection, const SurfaceView& view, const LineOptions& lines,
               const StrokeOptions& strokes);

  /// Lines that are given, as the families they stand for, with what hides them.
  Drawing draw(const Projection& projection, const FeatureLines& found, const LineOptions& lines,
               const StrokeOptions& strokes);

  /// What was prepared once for all drawings, wall clock.
  struct Preparation {
    double linesMs = 0.0;  ///< what a LineFinder keeps
    double raysMs = 0.0;   ///< the structure for rays; 0 before the first drawing
  };
  const Preparation& preparation() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace flatland
