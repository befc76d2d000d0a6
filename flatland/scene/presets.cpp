// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "flatland/scene/degenerate_presets.h"
#include "flatland/scene/scene.h"

namespace flatland {

namespace {

Scene single(std::vector<Vec2> points, View view = {}) {
  return {{{BezierChain(Bezier{std::move(points)})}}, view};
}

// The circle that drawing programs make, round to 2.7e-4 of its radius; more pieces would be
// rounder, but that it is not quite round is what there is to see.
Scene circle() {
  const double h = 4.0 / 3.0 * (std::numbers::sqrt2 - 1.0);
  return {{{BezierChain(3, true,
                        {{1, 0},
                         {1, h},
                         {h, 1},
                         {0, 1},
                         {-h, 1},
                         {-1, h},
                         {-1, 0},
                         {-1, -h},
                         {-h, -1},
                         {0, -1},
                         {h, -1},
                         {1, -h}})}},
          {}};
}

// Seen from well off the line through its ends, where the sides would change names; the normal is
// flipped to point out of the loop.
Scene loop() {
  Scene scene = single({{-1.0, -1.0}, {2.2, 0.6}, {0.0, 2.0}, {-2.2, 0.6}, {1.0, -1.0}},
                       {40.0, std::nullopt});
  scene.curves[0].flipNormal = true;
  return scene;
}

std::vector<Preset> makePresets() {
  return {
      {"thesis", "Thesis figure 3-4",
       "Five control points, seen from the right: silhouettes, ridges, a valley, inflections and "
       "apparent ridges on one curve.",
       single({{-1.3, -1.2}, {2.8, -1.5}, {-3.0, 0.4}, {2.9, 1.3}, {-1.5, 1.0}})},
      {"circle", "Almost a circle",
       "The four-piece circle of drawing programs: its curvature wavers by three per cent, and so "
       "it has ridges that a circle has not.",
       circle()},
      {"s-curve", "S-curve",
       "A cubic with one inflection; turn the view until the silhouettes meet in it.",
       single({{-0.4, -1.0}, {1.6, -0.6}, {-1.6, 0.6}, {0.4, 1.0}})},
      {"bump", "Bump",
       "A bump on a plain, seen from straight above: the foot of the bump shows where the offset "
       "term moves an apparent ridge away from the ridge.",
       single({{-2.0, 0.25},
               {-1.2, 0.0},
               {-0.5, -0.1},
               {-0.4, 1.6},
               {0.4, 1.6},
               {0.5, -0.1},
               {1.2, 0.0},
               {2.0, 0.25}},
              {90.0, std::nullopt})},
      {"cusp", "Cusp",
       "A cubic whose speed vanishes at t = 1/2: the tangent turns back, a corner of 180 degrees.",
       single({{-1.0, -0.8}, {1.0, 0.8}, {-1.0, 0.8}, {1.0, -0.8}}, {30.0, std::nullopt}),
       kDegenerateGroup,
       "One corner of 180 degrees at the tip, which is a silhouette too because the image folds "
       "there, and one apparent minimum near the lower left end. No ridge: at the tip curvature is "
       "infinite and changes sign."},
      {"loop", "Loop", "A curve that crosses itself and hides part of itself from the screen.",
       loop()},
  };
}

}  // namespace

const std::vector<Preset>& presets() {
  static const std::vector<Preset> all = makePresets();
  return all;
}

const std::vector<Preset>& allPresets() {
  static const std::vector<Preset> all = [] {
    std::vector<Preset> both = presets();
    for (Preset& preset : degeneratePresets()) both.push_back(std::move(preset));
    return both;
  }();
  return all;
}

const Scene& defaultScene() { return presets().front().scene; }

}  // namespace flatland
