// SPDX-License-Identifier: MIT
#pragma once

#include "core3d/draw/drawing.h"
#include "core3d/draw/sight.h"

namespace flatland {

/// What a LineFinder has to be asked for so that composeDrawing can make a drawing with `lines` and
/// `strokes`: lines down to where hysteresis follows them, all of them if ink is to be met, and the
/// families that exterior silhouettes are picked from.
LineOptions linesToFind(const LineOptions& lines, const StrokeOptions& strokes);

/// True if the family's threshold says how much is drawn, so that ink may change it. That of
/// creases is an angle that says what an edge is.
bool movesWithInk(LineFamily family);

/// Makes strokes from the lines that were found: chains them, asks what is seen of them, filters,
/// solves for ink, simplifies. `lines` are the options of the drawing, not linesToFind of them.
/// With LineOptions::unfiltered strokes are neither filtered by strength nor by length.
///
/// The result does not depend on the order of the segments nor on the number of threads (all cores
/// are used for visibility). Fills all stats but those of finding. No polylines if stopped.
Drawing composeDrawing(const FeatureLines& found, const Sight& sight, const Projection& projection,
                       const LineOptions& lines, const StrokeOptions& strokes);

/// The lines that strokes go along, to be drawn by other means than polylines.
struct StrokeLines {
  FeatureLines visible, hidden;
};

/// The strokes that composeDrawing makes, as segments: not simplified, hidden ones too if asked
/// for. With StrokeOptions::ink they are those of the factor that it found (DrawingStats::
/// thresholdFactor), which is not solved for again. Segments that follow one another share nodes;
/// what joins torn lines is among them, and lies in the triangle where it starts.
///
/// Without `sight` all count as visible, also what is far outside the picture; visible parts are
/// then not judged by their own length, nor loops by what is behind them, and exterior silhouettes
/// are all contours.
StrokeLines strokeLines(const FeatureLines& found, const Sight* sight, const Projection& projection,
                        const LineOptions& lines, const StrokeOptions& strokes,
                        double factor = 1.0);

}  // namespace flatland
