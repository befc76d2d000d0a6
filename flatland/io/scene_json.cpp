// SPDX-License-Identifier: MIT
#include "flatland/io/scene_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "flatland/io/atomic_file.h"
#include "flatland/io/curve_json.h"
#include "flatland/io/json_text.h"
#include "flatland/io/number_text.h"
#include "flatland/io/read_text.h"
#include "flatland/io/surface_json.h"

namespace flatland {

namespace {

using nlohmann::json;

constexpr int kVersion = 4;
constexpr int kSurfaceVersion = 3;  ///< with which surfaces came
constexpr int kViewsVersion = 4;    ///< with further views, swept surfaces and planes

View viewFrom(const JsonNode& node) {
  node.allowKeys({"angleDeg", "distance"});
  View view;
  if (const std::optional<JsonNode> angle = node.find("angleDeg")) view.angleDeg = angle->number();
  const std::optional<JsonNode> distance = node.find("distance");
  if (distance && !distance->value().is_null()) {
    if (!distance->value().is_number()) distance->failExpected("a number or null");
    view.distance = distance->length();
    if (!(*view.distance > 0.0)) {
      distance->fail("expected a distance above 0, found " + numberText(*view.distance));
    }
  }
  return view;
}

/// The version of the file.
int versionFrom(const JsonNode& top) {
  const std::optional<JsonNode> node = top.find("flatland");
  if (!node) top.fail("missing \"flatland\": 1, which marks a scene and its version");
  const int version = node->wholeNumber();
  if (version > kVersion) {
    node->fail("version " + std::to_string(version) +
               " was made by a newer Flatland; this one reads up to version " +
               std::to_string(kVersion));
  }
  if (version < 1) node->fail("expected version 1 to 4, found " + std::to_string(version));
  return version;
}

/// The mesh that a scene file means, and what the file says for a mesh: paths in a file start at
/// its folder, so that scene and mesh can be moved together.
std::string meshFrom(const std::filesystem::path& file, const std::string& mesh) {
  if (!namesFile(mesh)) return mesh;
  return std::filesystem::absolute(file.parent_path() / mesh).lexically_normal().string();
}

std::string meshBeside(const std::filesystem::path& file, const std::string& mesh) {
  if (!namesFile(mesh)) return mesh;
  const std::filesystem::path whole = std::filesystem::absolute(mesh).lexically_normal();
  const std::filesystem::path folder =
      std::filesystem::absolute(file).lexically_normal().parent_path();
  const std::filesystem::path relative = whole.lexically_relative(folder);
  return relative.empty() ? whole.string() : relative.generic_string();
}

}  // namespace

Scene sceneFromJson(const std::string& text, const std::string& source) {
  if (text.size() > kLargestSceneBytes) {
    throw InputError(source, "", "larger than 64 MiB, too large for a scene");
  }
  const json document = parseJson(text, source);
  const JsonNode top(document, "", source);
  if (!document.is_object()) top.failExpected("an object");
  const int version = versionFrom(top);
  top.allowKeys({"flatland", "curves", "view", "surface"});
  const std::optional<JsonNode> curves = top.find("curves");
  if (!curves) top.fail("missing \"curves\"");

  Scene scene;
  const std::size_t count = curves->listSize("a list of curves");
  scene.curves.reserve(count);
  for (std::size_t i = 0; i < count; ++i) scene.curves.push_back(curveFrom(curves->at(i), version));
  if (const std::optional<JsonNode> view = top.find("view")) scene.view = viewFrom(*view);
  if (const std::optional<JsonNode> surface = top.find("surface")) {
    if (version < kSurfaceVersion) {
      surface->fail("came with version 3; write \"flatland\": 3");
    }
    scene.surface = surfaceFrom(*surface);
    if (version < kViewsVersion && needsVersion4(*scene.surface)) {
      surface->fail("panes, ink, swept and plane came with version 4; write \"flatland\": 4");
    }
  }
  return scene;
}

std::string sceneToJson(const Scene& scene) {
  // The lowest version that will do, so that older programs read what they can.
  int version = 1;
  if (scene.surface) version = needsVersion4(*scene.surface) ? kViewsVersion : kSurfaceVersion;
  for (const SceneCurve& curve : scene.curves) version = std::max(version, versionOf(curve.shape));
  std::string text = "{\n  \"flatland\": " + std::to_string(version) + ",\n  \"curves\": [";
  for (std::size_t i = 0; i < scene.curves.size(); ++i) {
    text += (i == 0 ? "\n" : ",\n") + curveText(scene.curves[i], pathTo("curves", i));
  }
  text += scene.curves.empty() ? "],\n" : "\n  ],\n";
  text += "  \"view\": {\"angleDeg\": " + finiteText(scene.view.angleDeg, "view.angleDeg") +
          ", \"distance\": ";
  text += scene.view.distance ? lengthText(*scene.view.distance, "view.distance") : "null";
  text += "}";
  if (scene.surface) text += ",\n  \"surface\": " + surfaceText(*scene.surface, "surface");
  return text + "\n}\n";
}

Scene loadScene(const std::filesystem::path& file) {
  Scene scene = sceneFromJson(readFile(file, kLargestSceneBytes), file.string());
  if (scene.surface) scene.surface->mesh = meshFrom(file, scene.surface->mesh);
  return scene;
}

Scene loadSceneFromStandardInput() {
  return sceneFromJson(readStandardInput(kLargestSceneBytes), "standard input");
}

void saveScene(const Scene& scene, const std::filesystem::path& file) {
  if (!scene.surface) return writeFileAtomically(file, sceneToJson(scene));
  Scene written = scene;
  written.surface->mesh = meshBeside(file, scene.surface->mesh);
  writeFileAtomically(file, sceneToJson(written));
}

}  // namespace flatland
