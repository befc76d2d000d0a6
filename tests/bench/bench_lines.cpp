// SPDX-License-Identifier: GPL-3.0-or-later
// What a view of a mesh costs, one thread: bumpy spheres of 249 k, 1.0 M and 4.0 M triangles, as in
// the measurements of the peer, over a turn of views. Counters: triangles, segments, and ms of the
// vertex pass and of the walk.
#include <benchmark/benchmark.h>

#include <cmath>
#include <map>

#include "core3d/diff/exact_fields.h"
#include "core3d/lines/line_finder.h"
#include "core3d/mesh/build_mesh.h"

namespace {

using namespace flatland;

struct Model {
  TriangleMesh mesh;
  SurfaceFields fields;
};

// 12 n^2 triangles.
const Model& bumpySphere(int cells) {
  static std::map<int, Model> models;
  Model& model = models[cells];
  if (model.fields.vertexCount() == 0) {
    const Solid solid{SolidKind::BumpySphere, 1.0, 0.1, 5.0};
    const SolidMesh made = meshOf(solid, {.cells = cells});
    model.mesh = buildMesh(made.soup).mesh;
    model.fields = exactFields(solid, made.places, model.mesh);
  }
  return model;
}

void viewOf(benchmark::State& state, std::initializer_list<LineFamily> families, bool perspective,
            RidgeDerivative derivative = RidgeDerivative::ClosedForm) {
  const Model& model = bumpySphere(static_cast<int>(state.range(0)));
  LineFinder finder(model.mesh, model.fields);
  LineOptions options;
  options.derivative = derivative;
  for (const LineFamily family : families) options[family] = true;
  double vertexMs = 0.0, segmentMs = 0.0, angle = 0.0;
  std::size_t segments = 0;
  for (auto _ : state) {
    SurfaceView view{.towards = {std::sin(angle), 0.3, std::cos(angle)}, .eye = {}};
    view.towards.normalize();
    if (perspective) view.eye = 5.0 * view.towards;
    angle += 0.1;
    const FeatureLines lines = finder.find(view, options);
    vertexMs += finder.times().vertexMs;
    segmentMs += finder.times().segmentMs;
    for (const LineFamily family : families) segments += lines.of(family).size();
  }
  const auto average = benchmark::Counter::kAvgIterations;
  state.counters["triangles"] = static_cast<double>(model.mesh.triangleCount());
  state.counters["segments"] = benchmark::Counter(static_cast<double>(segments), average);
  state.counters["vertex_ms"] = benchmark::Counter(vertexMs, average);
  state.counters["walk_ms"] = benchmark::Counter(segmentMs, average);
}

void BM_Contours(benchmark::State& state) { viewOf(state, {LineFamily::OccludingContours}, false); }
void BM_ApparentRidges(benchmark::State& state) {
  viewOf(state, {LineFamily::ApparentRidges}, false);
}
void BM_ApparentRidgesPerspective(benchmark::State& state) {
  viewOf(state, {LineFamily::ApparentRidges}, true);
}
void BM_ApparentRidgesOneRing(benchmark::State& state) {
  viewOf(state, {LineFamily::ApparentRidges}, false, RidgeDerivative::OneRing);
}
void BM_ContoursRidgesSuggestive(benchmark::State& state) {
  viewOf(
      state,
      {LineFamily::OccludingContours, LineFamily::ApparentRidges, LineFamily::SuggestiveContours},
      false);
}

#define SIZES Arg(144)->Arg(289)->Arg(577)->Unit(benchmark::kMillisecond)
BENCHMARK(BM_Contours)->SIZES;
BENCHMARK(BM_ApparentRidges)->SIZES;
BENCHMARK(BM_ApparentRidgesPerspective)->SIZES;
BENCHMARK(BM_ApparentRidgesOneRing)->SIZES;
BENCHMARK(BM_ContoursRidgesSuggestive)->SIZES;

}  // namespace
