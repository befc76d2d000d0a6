// SPDX-License-Identifier: GPL-3.0-or-later
// From segments to strokes: chaining and looking at what is hidden, swept over the size of the
// mesh.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <map>

#include "core3d/diff/exact_fields.h"
#include "core3d/draw/chains.h"
#include "core3d/draw/compose.h"
#include "core3d/draw/mesh_places.h"
#include "core3d/mesh/build_mesh.h"
#include "core3d/mesh/solids.h"
#include "tests/core3d/contours.h"

namespace flatland::test {
namespace {

// A bumpy sphere with its contours, which hide one another in part.
struct Bumpy {
  TriangleMesh mesh;
  SurfaceFields fields;
  Projection projection;
  FeatureLines found;

  explicit Bumpy(int cells) {
    const Solid solid{SolidKind::BumpySphere, 1.0, 0.3, 9.0};
    const SolidMesh made = meshOf(solid, {.cells = cells, .irregular = true});
    mesh = buildMesh(made.soup).mesh;
    fields = exactFields(solid, made.places, mesh);
    Camera camera;
    camera.towards = {1.0, 0.5, 0.7};
    projection = projectionOf(camera, mesh);
    found.of(LineFamily::OccludingContours) = interpolatedContours(mesh, fields, projection.view());
  }
  static const Bumpy& of(benchmark::State& state) {
    static std::map<std::int64_t, Bumpy> made;
    const auto cells = state.range(0);
    const Bumpy& bumpy = made.try_emplace(cells, static_cast<int>(cells)).first->second;
    state.counters["triangles"] = static_cast<double>(bumpy.mesh.triangleCount());
    state.counters["segments"] =
        static_cast<double>(bumpy.found.of(LineFamily::OccludingContours).size());
    return bumpy;
  }
};

void chain(benchmark::State& state) {
  const Bumpy& bumpy = Bumpy::of(state);
  for (auto _ : state) {
    benchmark::DoNotOptimize(chainSegments(LineFamily::OccludingContours,
                                           bumpy.found.of(LineFamily::OccludingContours)));
  }
}
BENCHMARK(chain)->Arg(50)->Arg(150)->Arg(300)->Unit(benchmark::kMillisecond);

void buildSight(benchmark::State& state) {
  const Bumpy& bumpy = Bumpy::of(state);
  for (auto _ : state) benchmark::DoNotOptimize(Sight(bumpy.mesh, bumpy.fields));
}
BENCHMARK(buildSight)->Arg(50)->Arg(150)->Arg(300)->Unit(benchmark::kMillisecond)->UseRealTime();

// What is under a pointer that wanders over the picture.
void firstHit(benchmark::State& state) {
  const Bumpy& bumpy = Bumpy::of(state);
  const MeshPlaces places(bumpy.mesh);
  double angle = 0.0;
  for (auto _ : state) {
    angle += 0.1;
    const Eigen::Vector3d from(0.9 * std::cos(angle), 0.7 * std::sin(1.7 * angle), 2.0);
    benchmark::DoNotOptimize(places.firstHit(from, -Eigen::Vector3d::UnitZ(), true));
  }
}
BENCHMARK(firstHit)->Arg(50)->Arg(150)->Arg(300)->Unit(benchmark::kMicrosecond);

// A place of the surface before it moved a little.
void nearestPlace(benchmark::State& state) {
  const Bumpy& bumpy = Bumpy::of(state);
  const MeshPlaces places(bumpy.mesh);
  std::uint32_t vertex = 0;
  for (auto _ : state) {
    vertex = (vertex + 37) % static_cast<std::uint32_t>(bumpy.mesh.vertexCount());
    benchmark::DoNotOptimize(places.nearest(1.01 * bumpy.mesh.position(vertex).cast<double>()));
  }
}
BENCHMARK(nearestPlace)->Arg(50)->Arg(150)->Arg(300)->Unit(benchmark::kMicrosecond);

void compose(benchmark::State& state) {
  const Bumpy& bumpy = Bumpy::of(state);
  const Sight sight(bumpy.mesh, bumpy.fields);
  LineOptions lines;
  lines[LineFamily::OccludingContours] = true;
  DrawingStats stats;
  for (auto _ : state) {
    stats = composeDrawing(bumpy.found, sight, bumpy.projection, lines, {}).stats;
  }
  state.counters["rays"] = static_cast<double>(stats.rays);
  state.counters["visibility_ms"] = stats.visibilityMs;
}
BENCHMARK(compose)->Arg(50)->Arg(150)->Arg(300)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace flatland::test
