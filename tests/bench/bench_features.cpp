// SPDX-License-Identifier: GPL-3.0-or-later
// What a drag costs: all marks of one random curve, over the degree, orthographic and perspective.
#include <benchmark/benchmark.h>

#include <random>

#include "flatland/features/features.h"
#include "flatland/screen/visibility.h"
#include "flatland/study/profile.h"

namespace {

using namespace flatland;

// A hundred curves per run, so that a figure is a mean over easy and hard ones.
std::vector<Scene> randomScenes(int points, bool perspective) {
  std::mt19937 generator(20070201);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Scene> scenes;
  for (int i = 0; i < 100; ++i) {
    std::vector<Vec2> polygon;
    for (int j = 0; j < points; ++j) {
      const double x = unit(generator);
      polygon.emplace_back(x, unit(generator));
    }
    View view{360.0 * unit(generator), std::nullopt};
    if (perspective) view.distance = 4.0;
    scenes.push_back({{{BezierChain(Bezier{std::move(polygon)})}}, view});
  }
  return scenes;
}

void findFeaturesOf(benchmark::State& state, bool perspective) {
  const auto scenes = randomScenes(static_cast<int>(state.range(0)), perspective);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(findFeatures(scenes[i++ % scenes.size()]));
}

void BM_Features(benchmark::State& state) { findFeaturesOf(state, false); }
void BM_FeaturesPerspective(benchmark::State& state) { findFeaturesOf(state, true); }
BENCHMARK(BM_Features)->DenseRange(3, 9)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_FeaturesPerspective)->DenseRange(3, 9)->Unit(benchmark::kMicrosecond);

void BM_VisibleIntervals(benchmark::State& state) {
  const auto scenes = randomScenes(static_cast<int>(state.range(0)), false);
  std::size_t i = 0;
  for (auto _ : state) {
    const Visibility visibility(scenes[i++ % scenes.size()]);
    benchmark::DoNotOptimize(visibility.visibleIntervals(0));
  }
}
BENCHMARK(BM_VisibleIntervals)->DenseRange(3, 9)->Unit(benchmark::kMicrosecond);

void BM_Profile(benchmark::State& state) {
  const auto scenes = randomScenes(static_cast<int>(state.range(0)), false);
  std::vector<FeatureSet> features;
  for (const Scene& scene : scenes) features.push_back(findFeatures(scene));
  std::size_t i = 0;
  for (auto _ : state) {
    const std::size_t at = i++ % scenes.size();
    benchmark::DoNotOptimize(profileOf(scenes[at], features[at], 0));
  }
}
BENCHMARK(BM_Profile)->DenseRange(3, 9)->Unit(benchmark::kMicrosecond);

}  // namespace
