// SPDX-License-Identifier: MIT
#include "core3d/draw/draughtsman.h"

#include <optional>

#include "core3d/draw/compose.h"
#include "core3d/draw/sight.h"
#include "core3d/lines/line_finder.h"

namespace flatland {

struct Draughtsman::State {
  State(const TriangleMesh& m, const SurfaceFields& f) : mesh(&m), fields(&f), finder(m, f) {}

  const TriangleMesh* mesh;
  const SurfaceFields* fields;
  LineFinder finder;
  std::optional<Sight> sight;  // from the first drawing on
};

Draughtsman::Draughtsman(const TriangleMesh& mesh, const SurfaceFields& fields)
    : state_(std::make_unique<State>(mesh, fields)) {}
Draughtsman::~Draughtsman() = default;
Draughtsman::Draughtsman(Draughtsman&&) noexcept = default;
Draughtsman& Draughtsman::operator=(Draughtsman&&) noexcept = default;

Drawing Draughtsman::draw(const Projection& projection, const LineOptions& lines,
                          const StrokeOptions& strokes) {
  Drawing stopped;
  stopped.projection = projection;
  const FeatureLines found = state_->finder.find(projection.view(), linesToFind(lines, strokes));
  if (strokes.stop.stop_requested()) return stopped;
  if (!state_->sight) state_->sight.emplace(*state_->mesh, *state_->fields);
  Drawing drawing = composeDrawing(found, *state_->sight, projection, lines, strokes);
  const LineFinder::Times& times = state_->finder.times();
  drawing.stats.vertexMs = times.vertexMs;
  drawing.stats.segmentMs = times.segmentMs + times.fixedMs;
  return drawing;
}

}  // namespace flatland
