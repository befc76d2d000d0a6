// SPDX-License-Identifier: MIT
#include "flatland/io/scene_json.h"

#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "flatland/io/atomic_file.h"
#include "flatland/io/json_text.h"
#include "flatland/io/number_text.h"
#include "flatland/io/read_text.h"

namespace flatland {

namespace {

using nlohmann::json;

constexpr int kVersion = 1;

std::string nameOfType(const json& value) {
  switch (value.type()) {
    case json::value_t::null:
      return "null";
    case json::value_t::object:
      return "an object";
    case json::value_t::array:
      return "a list";
    case json::value_t::string:
      return "a string";
    case json::value_t::boolean:
      return value.get<bool>() ? "true" : "false";
    default:
      return "a number";
  }
}

std::string lengthTooLarge(double length) {
  return numberText(length) + " is beyond " + numberText(kLargestLength) +
         ", the largest length supported";
}

/// A value of the file with the path that leads to it.
class Node {
 public:
  Node(const json& value, std::string path, const std::string& source)
      : value_(value), path_(std::move(path)), source_(source) {}

  const json& value() const { return value_; }

  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(source_, path_.empty() ? "top level" : path_, reason);
  }
  [[noreturn]] void failExpected(const std::string& what) const {
    fail("expected " + what + ", found " + nameOfType(value_));
  }

  /// The object's keys must be among these.
  void allowKeys(std::initializer_list<const char*> known) const {
    if (!value_.is_object()) failExpected("an object");
    for (const auto& [key, ignored] : value_.items()) {
      bool found = false;
      std::string names;
      for (const char* name : known) {
        found = found || key == name;
        names += (names.empty() ? "" : ", ") + std::string(name);
      }
      if (!found) fail("unknown key " + json(key).dump() + "; known here: " + names);
    }
  }

  std::optional<Node> find(const char* key) const {
    const auto found = value_.find(key);
    if (found == value_.end()) return std::nullopt;
    return Node(*found, pathTo(path_, key), source_);
  }

  Node at(std::size_t index) const { return {value_[index], pathTo(path_, index), source_}; }

  std::size_t listSize(const std::string& what) const {
    if (!value_.is_array()) failExpected(what);
    return value_.size();
  }

  double number() const {
    if (!value_.is_number()) failExpected("a number");
    return value_.get<double>();
  }

  /// A coordinate or a distance.
  double length() const {
    const double number = this->number();
    if (std::abs(number) > kLargestLength) fail(lengthTooLarge(number));
    return number;
  }

  bool boolean() const {
    if (!value_.is_boolean()) failExpected("true or false");
    return value_.get<bool>();
  }

  int wholeNumber() const {
    const double number = this->number();
    if (number != std::floor(number) || std::abs(number) > 1e9) {
      fail("expected a whole number, found " + numberText(number));
    }
    return static_cast<int>(number);
  }

 private:
  const json& value_;
  std::string path_;
  const std::string& source_;
};

std::string degreeTooHigh(std::size_t degree) {
  return "degree " + std::to_string(degree) + " is above " + std::to_string(kHighestDegree) +
         ", the highest supported";
}

std::vector<Vec2> pointsFrom(const Node& list) {
  const std::size_t count = list.listSize("a list of points [x, y]");
  std::vector<Vec2> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Node point = list.at(i);
    const std::size_t size = point.listSize("a point [x, y]");
    if (size != 2) point.fail("expected 2 numbers [x, y], found " + std::to_string(size));
    points.emplace_back(point.at(0).length(), point.at(1).length());
  }
  return points;
}

BezierChain bezierFrom(const Node& node) {
  std::vector<Vec2> points = pointsFrom(node);
  if (points.size() < 2) {
    node.fail("a Bezier curve needs at least 2 points, found " + std::to_string(points.size()));
  }
  if (points.size() > kHighestDegree + 1) node.fail(degreeTooHigh(points.size() - 1));
  return BezierChain(Bezier{std::move(points)});
}

BezierChain chainFrom(const Node& node) {
  node.allowKeys({"degree", "closed", "points"});
  const std::optional<Node> degreeNode = node.find("degree");
  const std::optional<Node> pointsNode = node.find("points");
  if (!degreeNode) node.fail("missing \"degree\"");
  if (!pointsNode) node.fail("missing \"points\"");
  const int degree = degreeNode->wholeNumber();
  if (degree < 1)
    degreeNode->fail("expected a degree of at least 1, found " + std::to_string(degree));
  if (degree > kHighestDegree) degreeNode->fail(degreeTooHigh(static_cast<std::size_t>(degree)));
  const std::optional<Node> closedNode = node.find("closed");
  const bool closed = closedNode && closedNode->boolean();

  std::vector<Vec2> points = pointsFrom(*pointsNode);
  // A closed chain may repeat its first point at the end, as other formats do.
  const auto d = static_cast<std::size_t>(degree);
  if (closed && points.size() > 2 && (points.size() - 1) % d == 0 &&
      points.front() == points.back()) {
    points.pop_back();
  }
  if (const std::optional<std::string> why =
          BezierChain::whyInvalid(degree, closed, points.size())) {
    pointsNode->fail(*why);
  }
  return BezierChain(degree, closed, std::move(points));
}

SceneCurve curveFrom(const Node& node) {
  node.allowKeys({"bezier", "chain", "flipNormal"});
  const std::optional<Node> bezier = node.find("bezier");
  const std::optional<Node> chain = node.find("chain");
  if (bezier && chain) node.fail("has both \"bezier\" and \"chain\"; give one");
  if (!bezier && !chain) node.fail("missing \"bezier\" or \"chain\"");
  SceneCurve curve{bezier ? bezierFrom(*bezier) : chainFrom(*chain)};
  if (const std::optional<Node> flip = node.find("flipNormal")) curve.flipNormal = flip->boolean();
  return curve;
}

View viewFrom(const Node& node) {
  node.allowKeys({"angleDeg", "distance"});
  View view;
  if (const std::optional<Node> angle = node.find("angleDeg")) view.angleDeg = angle->number();
  const std::optional<Node> distance = node.find("distance");
  if (distance && !distance->value().is_null()) {
    if (!distance->value().is_number()) distance->failExpected("a number or null");
    view.distance = distance->length();
    if (!(*view.distance > 0.0)) {
      distance->fail("expected a distance above 0, found " + numberText(*view.distance));
    }
  }
  return view;
}

void checkVersion(const Node& top) {
  const std::optional<Node> node = top.find("flatland");
  if (!node) top.fail("missing \"flatland\": 1, which marks a scene and its version");
  const int version = node->wholeNumber();
  if (version > kVersion) {
    node->fail("version " + std::to_string(version) +
               " was made by a newer Flatland; this one reads version " + std::to_string(kVersion));
  }
  if (version != kVersion) node->fail("expected version 1, found " + std::to_string(version));
}

std::string finiteText(double value, const std::string& path) {
  if (!std::isfinite(value)) throw InputError("", path, "not a finite number");
  return numberText(value);
}

std::string lengthText(double value, const std::string& path) {
  const std::string text = finiteText(value, path);
  if (std::abs(value) > kLargestLength) throw InputError("", path, lengthTooLarge(value));
  return text;
}

/// The points of a list, one on a line.
std::string pointsText(const std::vector<Vec2>& points, const std::string& path,
                       const std::string& indent) {
  std::string text = "[\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string here = pathTo(path, i);
    text += indent + "  [" + lengthText(points[i].x(), pathTo(here, 0)) + ", " +
            lengthText(points[i].y(), pathTo(here, 1)) + "]" +
            (i + 1 < points.size() ? ",\n" : "\n");
  }
  return text + indent + "]";
}

std::string curveText(const SceneCurve& curve, const std::string& path) {
  if (!std::holds_alternative<BezierChain>(curve.shape)) {
    throw InputError("", path, "this kind of curve cannot be saved yet");
  }
  const BezierChain& chain = curve.chain();
  if (chain.degree() > kHighestDegree) {
    throw InputError("", path, degreeTooHigh(static_cast<std::size_t>(chain.degree())));
  }
  std::string text = "    {\n";
  if (!chain.closed() && chain.pieceCount() == 1) {
    text += "      \"bezier\": " + pointsText(chain.points(), pathTo(path, "bezier"), "      ");
  } else {
    std::vector<Vec2> points = chain.points();
    // Reading drops a repeated first point; one that is really there is written once more.
    if (chain.closed() && points.size() > 1 && points.front() == points.back() &&
        (points.size() - 1) % static_cast<std::size_t>(chain.degree()) == 0) {
      points.push_back(points.front());
    }
    text += "      \"chain\": {\n        \"degree\": " + std::to_string(chain.degree()) +
            ",\n        \"closed\": " + (chain.closed() ? "true" : "false") +
            ",\n        \"points\": " +
            pointsText(points, pathTo(pathTo(path, "chain"), "points"), "        ") + "\n      }";
  }
  if (curve.flipNormal) text += ",\n      \"flipNormal\": true";
  return text + "\n    }";
}

}  // namespace

Scene sceneFromJson(const std::string& text, const std::string& source) {
  if (text.size() > kLargestSceneBytes) {
    throw InputError(source, "", "larger than 64 MiB, too large for a scene");
  }
  const json document = parseJson(text, source);
  const Node top(document, "", source);
  if (!document.is_object()) top.failExpected("an object");
  checkVersion(top);
  top.allowKeys({"flatland", "curves", "view"});
  const std::optional<Node> curves = top.find("curves");
  if (!curves) top.fail("missing \"curves\"");

  Scene scene;
  const std::size_t count = curves->listSize("a list of curves");
  scene.curves.reserve(count);
  for (std::size_t i = 0; i < count; ++i) scene.curves.push_back(curveFrom(curves->at(i)));
  if (const std::optional<Node> view = top.find("view")) scene.view = viewFrom(*view);
  return scene;
}

std::string sceneToJson(const Scene& scene) {
  std::string text = "{\n  \"flatland\": " + std::to_string(kVersion) + ",\n  \"curves\": [";
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
