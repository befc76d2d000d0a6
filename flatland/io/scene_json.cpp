// SPDX-License-Identifier: MIT
#include "flatland/io/scene_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "flatland/io/atomic_file.h"
#include "flatland/io/curve_json.h"
#include "flatland/io/json_text.h"
#include "flatland/io/number_text.h"
#include "flatland/io/read_text.h"

namespace flatland {

namespace {

using nlohmann::json;

constexpr int kVersion = 2;

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
  if (version < 1) node->fail("expected version 1 or 2, found " + std::to_string(version));
  return version;
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
  top.allowKeys({"flatland", "curves", "view"});
  const std::optional<JsonNode> curves = top.find("curves");
  if (!curves) top.fail("missing \"curves\"");

  Scene scene;
  const std::size_t count = curves->listSize("a list of curves");
  scene.curves.reserve(count);
  for (std::size_t i = 0; i < count; ++i) scene.curves.push_back(curveFrom(curves->at(i), version));
  if (const std::optional<JsonNode> view = top.find("view")) scene.view = viewFrom(*view);
  return scene;
}

std::string sceneToJson(const Scene& scene) {
  // The lowest version that will do, so that older programs read what they can.
  int version = 1;
  for (const SceneCurve& curve : scene.curves) version = std::max(version, versionOf(curve.shape));
  std::string text = "{\n  \"flatland\": " + std::to_string(version) + ",\n  \"curves\": [";
  for (std::size_t i = 0; i < scene.curves.size(); ++i) {
    text += (i == 0 ? "\n" : ",\n") + curveText(scene.curves[i], pathTo("curves", i));
  }
  text += scene.curves.empty() ? "],\n" : "\n  ],\n";
  text += "  \"view\": {\"angleDeg\": " + finiteText(scene.view.angleDeg, "view.angleDeg") +
          ", \"distance\": ";
  text += scene.view.distance ? lengthText(*scene.view.distance, "view.distance") : "null";
  return text + "}\n}\n";
}

Scene loadScene(const std::filesystem::path& file) {
  return sceneFromJson(readFile(file, kLargestSceneBytes), file.string());
}

Scene loadSceneFromStandardInput() {
  return sceneFromJson(readStandardInput(kLargestSceneBytes), "standard input");
}

void saveScene(const Scene& scene, const std::filesystem::path& file) {
  writeFileAtomically(file, sceneToJson(scene));
}

}  // namespace flatland
