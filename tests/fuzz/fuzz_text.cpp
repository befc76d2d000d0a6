// SPDX-License-Identifier: GPL-3.0-or-later
// One reader of text (FUZZED_TEXT) on arbitrary bytes: it refuses them with a message, or what it
// gives is sound and can be written.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "flatland/curve/expression.h"
#include "flatland/io/input_error.h"
#include "flatland/io/lesson_text.h"
#include "flatland/io/scene_json.h"
#include "flatland/io/svg_attributes.h"
#include "flatland/io/svg_file.h"

namespace {

using namespace flatland;

void require(bool condition) {
  if (!condition) std::abort();
}

void check(const Scene& scene) {
  for (const SceneCurve& curve : scene.curves) {
    for (const Vec2& p : controlPoints(curve.shape)) {
      require(p.allFinite() && p.cwiseAbs().maxCoeff() <= kLargestLength);
    }
    for (const double t : {0.0, 0.3, 1.0}) require(pointAt(curve.shape, t).allFinite());
  }
}

// What was read is written so that it reads back to the same.
[[maybe_unused]] void scene(const std::string& text) {
  const Scene read = sceneFromJson(text, "fuzz");
  check(read);
  std::string written;
  try {
    written = sceneToJson(read);
  } catch (const InputError&) {
    std::abort();
  }
  require(sceneFromJson(written, "written") == read);
}

[[maybe_unused]] void svg(const std::string& text) {
  const ImportedScene imported = sceneFromSvg(text, "fuzz");
  require(!imported.scene.curves.empty());
  check(imported.scene);
  require(!sceneToJson(imported.scene).empty());
}

// The little languages of SVG's attributes, one behind the other.
[[maybe_unused]] void path(const std::string& text) {
  const SvgPlace place{"fuzz", "here"};
  const auto tried = [](const auto& read) {
    try {
      read();
    } catch (const InputError&) {
    }
  };
  tried([&] { svgTransform(text, place); });
  tried([&] { svgLength(text, 100.0, place); });
  tried([&] { svgPoints(text, place); });
  tried([&] { svgViewBox(text, place); });
  ChainNotes notes;
  for (const Subpath& subpath : subpathsFromSvg(text, "fuzz", "d")) chainOf(subpath, notes);
}

[[maybe_unused]] void lesson(const std::string& text) {
  const Lesson read = lessonFromText(text, "fuzz");
  require(!read.title.empty() && !read.steps.empty() && read.steps.size() <= kMostLessonSteps);
  for (const LessonStep& step : read.steps) {
    require(!step.title.empty());
    if (step.state.scene) check(*step.state.scene);
  }
}

[[maybe_unused]] void formula(const std::string& text) {
  const Expression::Result read = Expression::parse(text, {{"a", 2.0}});
  require(read.expression.has_value() == read.error.reason.empty());
  if (!read.expression) {
    require(read.error.column >= 1 && read.error.column <= static_cast<int>(text.size()) + 1);
    return;
  }
  // Whatever the values are, finite or not; a varying exponent rounds differently with derivatives.
  for (const double at : {-1.5, 0.0, 0.3, 1e300}) {
    read.expression->at(Taylor<0>(at));
    read.expression->at(Taylor<4>::variable(at));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    FUZZED_TEXT(std::string(reinterpret_cast<const char*>(data), size));
  } catch (const InputError&) {
  }
  return 0;
}
