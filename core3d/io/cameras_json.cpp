// SPDX-License-Identifier: MIT
#include "core3d/io/cameras_json.h"

#include <nlohmann/json.hpp>
#include <set>

#include "flatland/io/input_error.h"
#include "flatland/io/json_node.h"
#include "flatland/io/json_text.h"
#include "flatland/io/number_text.h"
#include "flatland/io/read_text.h"
#include "flatland/view/perspective.h"

namespace flatland {

namespace {

constexpr std::size_t kLargestBytes = 64U * 1024U * 1024U;
constexpr std::size_t kLongestName = 64;

Eigen::Vector3d placeFrom(const JsonNode& node) {
  if (node.listSize("three numbers [x, y, z]") != 3) node.fail("expected 3 numbers [x, y, z]");
  Eigen::Vector3d place;
  for (std::size_t i = 0; i < 3; ++i) place[static_cast<Eigen::Index>(i)] = node.at(i).length();
  return place;
}

Eigen::Vector3d directionFrom(const JsonNode& node) {
  const Eigen::Vector3d direction = placeFrom(node);
  // Of the largest part and not of the length, whose square may be 0 or infinite.
  const double size = direction.cwiseAbs().maxCoeff();
  if (!(size > 0.0)) node.fail("a direction must not be [0, 0, 0]");
  return (direction / size).normalized();
}

std::string nameFrom(const JsonNode& node, std::set<std::string>& taken) {
  std::string name = node.text();
  constexpr std::string_view kAllowed =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
  if (name.empty() || name.size() > kLongestName ||
      name.find_first_not_of(kAllowed) != std::string::npos) {
    node.fail("a name becomes part of a file's name: 1 to 64 letters, digits, - and _");
  }
  if (!taken.insert(name).second) node.fail("the name \"" + name + "\" stands twice");
  return name;
}

NamedCamera cameraFrom(const JsonNode& node, const Camera& usual, std::set<std::string>& taken) {
  node.allowKeys({"name", "view", "up", "perspectiveDeg", "zoom", "centre"});
  NamedCamera named{{}, usual};
  if (const auto name = node.find("name")) named.name = nameFrom(*name, taken);
  if (const auto view = node.find("view")) named.camera.towards = directionFrom(*view);
  if (const auto up = node.find("up")) named.camera.up = directionFrom(*up);
  if (const auto angle = node.find("perspectiveDeg")) {
    named.camera.perspectiveDeg.reset();
    if (!angle->value().is_null()) {
      if (!angle->value().is_number()) angle->failExpected("a number of degrees or null");
      named.camera.perspectiveDeg = angle->number();
      if (!isPerspective(*named.camera.perspectiveDeg)) {
        angle->fail("expected an angle from " + numberText(kLeastPerspectiveDeg) + " to " +
                    numberText(kMostPerspectiveDeg) + " degrees, found " +
                    numberText(*named.camera.perspectiveDeg));
      }
    }
  }
  if (const auto zoom = node.find("zoom")) {
    named.camera.zoom = zoom->number();
    if (!(named.camera.zoom > 0.0 && named.camera.zoom <= kMostZoom)) {
      zoom->fail("expected a zoom above 0, at most " + numberText(kMostZoom) + ", found " +
                 numberText(named.camera.zoom));
    }
  }
  const auto centre = node.find("centre");
  if (centre && !centre->value().is_null()) named.camera.centre = placeFrom(*centre);
  return named;
}

std::string vectorText(const Eigen::Vector3d& v) {
  return "[" + numberText(v.x()) + ", " + numberText(v.y()) + ", " + numberText(v.z()) + "]";
}

}  // namespace

std::vector<NamedCamera> camerasFromJson(const std::string& text, const std::string& source,
                                         const Camera& usual) {
  if (text.size() > kLargestBytes) {
    throw InputError(source, "", "larger than 64 MiB, too large for a list of cameras");
  }
  const nlohmann::json document = parseJson(text, source);
  const JsonNode top(document, "", source);
  top.allowKeys({"flatland", "cameras"});
  const JsonNode version = top.at("flatland");
  if (version.wholeNumber() != 1) version.fail("expected version 1");
  const JsonNode list = top.at("cameras");
  const std::size_t count = list.listSize("a list of cameras");
  if (count == 0) list.fail("no camera");
  if (count > kMostCameras) list.fail("more than " + std::to_string(kMostCameras) + " cameras");
  std::vector<NamedCamera> cameras;
  std::set<std::string> taken;
  for (std::size_t i = 0; i < count; ++i) {
    cameras.push_back(cameraFrom(list.at(i), usual, taken));
  }
  return cameras;
}

std::vector<NamedCamera> loadCameras(const std::filesystem::path& file, const Camera& usual) {
  return camerasFromJson(readFile(file, kLargestBytes), file.string(), usual);
}

std::string cameraToJson(const Camera& camera) {
  return "{\"view\": " + vectorText(camera.towards) + ", \"up\": " + vectorText(camera.up) +
         ", \"perspectiveDeg\": " + numberText(camera.perspectiveDeg, "null") +
         ", \"zoom\": " + numberText(camera.zoom) +
         (camera.centre ? ", \"centre\": " + vectorText(*camera.centre) : "") + "}";
}

std::string camerasToJson(const std::vector<NamedCamera>& cameras) {
  std::string text = "{\n  \"flatland\": 1,\n  \"cameras\": [";
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    text += i == 0 ? "\n    " : ",\n    ";
    std::string camera = cameraToJson(cameras[i].camera);
    if (!cameras[i].name.empty()) camera.insert(1, "\"name\": \"" + cameras[i].name + "\", ");
    text += camera;
  }
  return text + "\n  ]\n}\n";
}

}  // namespace flatland
