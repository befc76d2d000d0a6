// SPDX-License-Identifier: GPL-3.0-or-later
// What is computed once for a mesh: normals, K and C by both estimators, on one thread, over the
// triangles of a bumpy sphere as in the peer's figures; and the jet fit where noise asks for wide
// neighbourhoods.
#include <benchmark/benchmark.h>

#include <random>

#include "core3d/diff/estimate_fields.h"
#include "core3d/mesh/build_mesh.h"
#include "core3d/mesh/solids.h"

namespace {

using namespace flatland;

// `noise` in shares of an edge.
TriangleMesh bumpySphere(int cells, double noise) {
  TriangleMesh mesh =
      buildMesh(meshOf({SolidKind::BumpySphere, 1.0, 0.1, 5.0}, {cells, true}).soup).mesh;
  std::mt19937 generator(1);
  const auto size = static_cast<float>(noise * 1.5 / cells);
  std::uniform_real_distribution<float> move(-size, size);
  if (noise > 0.0) {
    for (auto* coordinates : {&mesh.x, &mesh.y, &mesh.z})
      for (float& x : *coordinates) x += move(generator);
  }
  return mesh;
}

void estimate(benchmark::State& state, FieldEstimator estimator, int threads, double noise) {
  const auto cells = static_cast<int>(state.range(0));
  const TriangleMesh mesh = bumpySphere(cells, noise);
  FieldOptions options;
  options.estimator = estimator;
  options.threads = threads;
  for (auto _ : state) benchmark::DoNotOptimize(estimateFields(mesh, options));
  state.counters["triangles"] = static_cast<double>(mesh.triangleCount());
}

void BM_JetFit(benchmark::State& state) { estimate(state, FieldEstimator::JetFit, 1, 0.0); }
void BM_JetFitNoisy(benchmark::State& state) { estimate(state, FieldEstimator::JetFit, 1, 0.01); }
void BM_JetFitTwoThreads(benchmark::State& state) {
  estimate(state, FieldEstimator::JetFit, 2, 0.0);
}
void BM_OneRing(benchmark::State& state) { estimate(state, FieldEstimator::OneRing, 1, 0.0); }

// 249 k and 1.0 M triangles.
BENCHMARK(BM_JetFit)->Arg(144)->Arg(289)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_JetFitNoisy)->Arg(144)->Arg(289)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_JetFitTwoThreads)->Arg(289)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BM_OneRing)->Arg(144)->Arg(289)->Unit(benchmark::kMillisecond);

}  // namespace
