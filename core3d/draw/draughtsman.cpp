// SPDX-License-Identifier: MIT
#include "core3d/draw/draughtsman.h"

#include <chrono>
#include <optional>

#include "core3d/draw/compose.h"
#include "core3d/draw/sight.h"
#include "core3d/lines/line_finder.h"

namespace flatland {

namespace {

// What `make` makes, and the milliseconds that it takes.
template <typename Make>
auto timed(double& ms, const Make& make) {
  const auto start = std::chrono::steady_clock::now();
  auto made = make();
  ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return made;
}

}  // namespace

struct Draughtsman::State {
  State(const TriangleMesh& m, const SurfaceFields& f)
      : mesh(&m),
        fields(&f),
        finder(timed(preparation.linesMs, [&] { return LineFinder(m, f); })) {}

  const TriangleMesh* mesh;
  const SurfaceFields* fields;
  Preparation preparation;
  LineFinder finder;
  std::optional<Sight> sight;  // from the first drawing on
};

Draughtsman::Draughtsman(const TriangleMesh& mesh, const SurfaceFields& fields)
    : state_(std::make_unique<State>(mesh, fields)) {}
Draughtsman::~Draughtsman() = default;
Draughtsman::Draughtsman(Draughtsman&&) noexcept = default;
Draughtsman& Draughtsman::operator=(Draughtsman&&) noexcept = default;

const Draughtsman::Preparation& Draughtsman::preparation() const { return state_->preparation; }

Drawing Draughtsman::draw(const Projection& projection, const LineOptions& lines,
                          const StrokeOptions& strokes) {
  return draw(projection, projection.view(), lines, strokes);
}

Drawing Draughtsman::draw(const Projection& projection, const FeatureLines& found,
                          const LineOptions& lines, const StrokeOptions& strokes) {
  if (!state_->sight) {
    state_->sight =
        timed(state_->preparation.raysMs, [this] { return Sight(*state_->mesh, *state_->fields); });
  }
  return composeDrawing(found, *state_->sight, projection, lines, strokes);
}

Drawing Draughtsman::draw(const Projection& projection, const SurfaceView& view,
                          const LineOptions& lines, const StrokeOptions& strokes) {
  Drawing stopped;
  stopped.projection = projection;
  const FeatureLines found = state_->finder.find(view, linesToFind(lines, strokes));
  if (strokes.stop.stop_requested()) return stopped;
  Drawing drawing = draw(projection, found, lines, strokes);
  const LineFinder::Times& times = state_->finder.times();
  drawing.stats.vertexMs = times.vertexMs;
  drawing.stats.segmentMs = times.segmentMs + times.fixedMs;
  return drawing;
}

}  // namespace flatland
