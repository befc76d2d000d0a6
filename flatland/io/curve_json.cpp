// SPDX-License-Identifier: MIT
#include "flatland/io/curve_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "flatland/io/json_text.h"
#include "flatland/io/number_text.h"
#include "flatland/io/scene_json.h"

namespace flatland {

namespace {

std::string degreeTooHigh(std::size_t degree, int highest = kHighestDegree) {
  return "degree " + std::to_string(degree) + " is above " + std::to_string(highest) +
         ", the highest supported";
}

int degreeFrom(const JsonNode& node, int highest) {
  const int degree = node.wholeNumber();
  if (degree < 1) node.fail("expected a degree of at least 1, found " + std::to_string(degree));
  if (degree > highest) node.fail(degreeTooHigh(static_cast<std::size_t>(degree), highest));
  return degree;
}

bool closedFrom(const JsonNode& node) {
  const std::optional<JsonNode> closed = node.find("closed");
  return closed && closed->boolean();
}

std::vector<Vec2> pointsFrom(const JsonNode& list) {
  const std::size_t count = list.listSize("a list of points [x, y]");
  std::vector<Vec2> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const JsonNode point = list.at(i);
    const std::size_t size = point.listSize("a point [x, y]");
    if (size != 2) point.fail("expected 2 numbers [x, y], found " + std::to_string(size));
    points.emplace_back(point.at(0).length(), point.at(1).length());
  }
  return points;
}

BezierChain bezierFrom(const JsonNode& node) {
  std::vector<Vec2> points = pointsFrom(node);
  if (points.size() < 2) {
    node.fail("a Bezier curve needs at least 2 points, found " + std::to_string(points.size()));
  }
  if (points.size() > kHighestDegree + 1) node.fail(degreeTooHigh(points.size() - 1));
  return BezierChain(Bezier{std::move(points)});
}

BezierChain chainFrom(const JsonNode& node) {
  node.allowKeys({"degree", "closed", "points"});
  const JsonNode degreeNode = node.at("degree");
  const JsonNode pointsNode = node.at("points");
  const int degree = degreeFrom(degreeNode, kHighestDegree);
  const bool closed = closedFrom(node);

  std::vector<Vec2> points = pointsFrom(pointsNode);
  // A closed chain may repeat its first point at the end, as other formats do.
  const auto d = static_cast<std::size_t>(degree);
  if (closed && points.size() > 2 && (points.size() - 1) % d == 0 &&
      points.front() == points.back()) {
    points.pop_back();
  }
  if (const std::optional<std::string> why =
          BezierChain::whyInvalid(degree, closed, points.size())) {
    pointsNode.fail(*why);
  }
  return BezierChain(degree, closed, std::move(points));
}

std::vector<double> numbersFrom(const JsonNode& list, const std::string& what) {
  std::vector<double> numbers;
  const std::size_t count = list.listSize(what);
  for (std::size_t i = 0; i < count; ++i) numbers.push_back(list.at(i).number());
  return numbers;
}

BSpline splineFrom(const JsonNode& node) {
  node.allowKeys({"degree", "closed", "points", "knots"});
  const int degree = degreeFrom(node.at("degree"), kHighestSplineDegree);
  const bool closed = closedFrom(node);
  std::vector<Vec2> points = pointsFrom(node.at("points"));
  if (points.size() > kMostSplinePoints) {
    node.at("points").fail("more than " + std::to_string(kMostSplinePoints) + " points");
  }
  const std::optional<JsonNode> knotsNode = node.find("knots");
  std::vector<double> knots = knotsNode ? numbersFrom(*knotsNode, "a list of knots")
                                        : BSpline::uniformKnots(degree, closed, points.size());
  if (const auto why = BSpline::whyInvalid(degree, closed, points.size(), knots)) node.fail(*why);
  return BSpline(degree, closed, std::move(points), std::move(knots));
}

RationalBezier rationalFrom(const JsonNode& node) {
  node.allowKeys({"degree", "closed", "points", "weights"});
  std::vector<Vec2> points = pointsFrom(node.at("points"));
  std::vector<double> weights = numbersFrom(node.at("weights"), "a list of weights");
  const bool closed = closedFrom(node);
  const std::optional<JsonNode> degreeNode = node.find("degree");
  if (!degreeNode && closed) node.fail("missing \"degree\", which a closed curve needs");
  if (!degreeNode && points.size() > kHighestDegree + 1) {
    node.at("points").fail(degreeTooHigh(points.size() - 1));
  }
  const int degree =
      degreeNode ? degreeFrom(*degreeNode, kHighestDegree) : static_cast<int>(points.size()) - 1;
  if (const auto why = RationalBezier::whyInvalid(degree, closed, points.size(), weights)) {
    node.fail(*why);
  }
  return RationalBezier(degree, closed, std::move(points), std::move(weights));
}

Vec2 placeFrom(const JsonNode& node) {
  const std::optional<JsonNode> at = node.find("at");
  if (!at) return Vec2::Zero();
  if (at->listSize("a point [x, y]") != 2) at->fail("expected 2 numbers [x, y]");
  return {at->at(std::size_t{0}).length(), at->at(std::size_t{1}).length()};
}

FormulaCurve familyFrom(const JsonNode& node) {
  node.allowKeys({"name", "parameters", "at"});
  const std::string name = node.at("name").text();
  const Family* family = familyNamed(name);
  if (!family) {
    std::string names;
    for (const Family& known : families()) names += (names.empty() ? "" : ", ") + known.name;
    node.at("name").fail("there is no family " + nlohmann::json(name).dump() + "; known: " + names);
  }
  const JsonNode parameters = node.at("parameters");
  if (!parameters.value().is_object()) parameters.failExpected("an object");
  FamilyCurve curve{family->id, {}};
  for (const FamilyParameter& parameter : family->parameters) {
    curve.parameters.push_back(parameters.at(parameter.id).number());
  }
  if (parameters.value().size() != family->parameters.size()) {
    std::string names;
    for (const auto& known : family->parameters) names += (names.empty() ? "" : ", ") + known.id;
    parameters.fail("a key too many; known here: " + names);
  }
  const FormulaCurve::Result result = FormulaCurve::make(curve, placeFrom(node));
  if (!result.curve) parameters.fail(result.error.reason);
  return *result.curve;
}

/// The end of a domain: a number or a text.
std::string endFrom(const JsonNode& node) {
  if (node.value().is_number()) return numberText(node.number());
  if (!node.value().is_string()) node.failExpected("a number or a string");
  return node.text();
}

FormulaCurve formulaFrom(const JsonNode& node) {
  node.allowKeys({"x", "y", "from", "to", "constants", "at"});
  TypedFormula formula{node.at("x").text(),
                       node.at("y").text(),
                       endFrom(node.at("from")),
                       endFrom(node.at("to")),
                       {}};
  if (const std::optional<JsonNode> constants = node.find("constants")) {
    if (!constants->value().is_object()) constants->failExpected("an object");
    for (const auto& [name, ignored] : constants->value().items()) {
      formula.constants[name] = constants->at(name).number();
    }
  }
  const FormulaCurve::Result result = FormulaCurve::make(formula, placeFrom(node));
  if (result.curve) return *result.curve;
  const char* const keys[] = {"x", "y", "from", "to", "constants"};
  const FormulaError& error = result.error;
  node.at(keys[static_cast<std::size_t>(error.field)])
      .fail((error.column > 0 ? "column " + std::to_string(error.column) + ": " : "") +
            error.reason);
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

/// Numbers in one line.
std::string numbersText(const std::vector<double>& numbers, const std::string& path) {
  std::string text = "[";
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    text += (i > 0 ? ", " : "") + finiteText(numbers[i], pathTo(path, i));
  }
  return text + "]";
}

std::string headText(int degree, bool closed) {
  return "        \"degree\": " + std::to_string(degree) +
         ",\n        \"closed\": " + (closed ? "true" : "false") + ",\n";
}

std::string shapeText(const BezierChain& chain, const std::string& path) {
  if (chain.degree() > kHighestDegree) {
    throw InputError("", path, degreeTooHigh(static_cast<std::size_t>(chain.degree())));
  }
  std::string text;
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
  return text;
}

std::string shapeText(const BSpline& spline, const std::string& path) {
  const std::string here = pathTo(path, "bspline");
  if (spline.degree() > kHighestSplineDegree) {
    throw InputError(
        "", path, degreeTooHigh(static_cast<std::size_t>(spline.degree()), kHighestSplineDegree));
  }
  std::string text =
      "      \"bspline\": {\n" + headText(spline.degree(), spline.closed()) +
      "        \"points\": " + pointsText(spline.points(), pathTo(here, "points"), "        ");
  if (spline.knots() !=
      BSpline::uniformKnots(spline.degree(), spline.closed(), spline.points().size())) {
    text += ",\n        \"knots\": " + numbersText(spline.knots(), pathTo(here, "knots"));
  }
  return text + "\n      }";
}

std::string shapeText(const RationalBezier& curve, const std::string& path) {
  const std::string here = pathTo(path, "rational");
  if (curve.degree() > kHighestDegree) {
    throw InputError("", path, degreeTooHigh(static_cast<std::size_t>(curve.degree())));
  }
  const bool single = !curve.closed() && curve.pieceCount() == 1;
  return "      \"rational\": {\n" + (single ? "" : headText(curve.degree(), curve.closed())) +
         "        \"points\": " + pointsText(curve.points(), pathTo(here, "points"), "        ") +
         ",\n        \"weights\": " + numbersText(curve.weights(), pathTo(here, "weights")) +
         "\n      }";
}

/// An end of a domain: a number where the text is just one.
std::string endText(const std::string& text) {
  const nlohmann::json number = nlohmann::json::parse(text, nullptr, false);
  if (number.is_number() && std::isfinite(number.get<double>()) &&
      numberText(number.get<double>()) == text) {
    return text;
  }
  return nlohmann::json(text).dump();
}

std::string constantsText(const std::map<std::string, double>& values, const std::string& path) {
  std::string text = "{";
  for (const auto& [name, value] : values) {
    text += (text.size() > 1 ? ", " : "") + nlohmann::json(name).dump() + ": " +
            finiteText(value, pathTo(path, name));
  }
  return text + "}";
}

std::string shapeText(const FormulaCurve& curve, const std::string& path) {
  std::string text;
  if (const FamilyCurve* member = curve.family()) {
    const Family& family = familyOf(*member);
    text = "      \"family\": {\n        \"name\": \"" + family.name +
           "\",\n        \"parameters\": {";
    for (std::size_t i = 0; i < family.parameters.size(); ++i) {
      text += (i > 0 ? ", \"" : "\"") + family.parameters[i].id +
              "\": " + finiteText(member->parameters[i], pathTo(path, "family"));
    }
    text += "}";
  } else {
    const TypedFormula& typed = *curve.typed();
    text = "      \"formula\": {\n        \"x\": " + nlohmann::json(typed.x).dump() +
           ",\n        \"y\": " + nlohmann::json(typed.y).dump() +
           ",\n        \"from\": " + endText(typed.from) +
           ",\n        \"to\": " + endText(typed.to);
    if (!typed.constants.empty()) {
      text +=
          ",\n        \"constants\": " + constantsText(typed.constants, pathTo(path, "formula"));
    }
  }
  if (!(curve.at() == Vec2::Zero())) {
    text += ",\n        \"at\": [" + lengthText(curve.at().x(), pathTo(path, "at")) + ", " +
            lengthText(curve.at().y(), pathTo(path, "at")) + "]";
  }
  return text + "\n      }";
}

}  // namespace

std::string finiteText(double value, const std::string& path) {
  if (!std::isfinite(value)) throw InputError("", path, "not a finite number");
  return numberText(value);
}

std::string lengthText(double value, const std::string& path) {
  const std::string text = finiteText(value, path);
  if (std::abs(value) > kLargestLength) throw InputError("", path, lengthTooLarge(value));
  return text;
}

int versionOf(const Curve& curve) { return std::holds_alternative<BezierChain>(curve) ? 1 : 2; }

SceneCurve curveFrom(const JsonNode& node, int version) {
  constexpr const char* kNewer[] = {"bspline", "rational", "family", "formula"};
  if (version == 1) {
    for (const char* key : kNewer) {
      if (node.value().is_object() && node.find(key)) {
        node.fail("\"" + std::string(key) + "\" came with version 2; write \"flatland\": 2");
      }
    }
    node.allowKeys({"bezier", "chain", "flipNormal"});
  } else {
    node.allowKeys({"bezier", "chain", "bspline", "rational", "family", "formula", "flipNormal"});
  }
  std::optional<Curve> shape;
  std::string taken;
  const auto read = [&](const char* key, auto from) {
    const std::optional<JsonNode> found = node.find(key);
    if (!found) return;
    if (shape) node.fail("has both \"" + taken + "\" and \"" + key + "\"; give one");
    taken = key;
    shape = from(*found);
  };
  read("bezier", bezierFrom);
  read("chain", chainFrom);
  read("bspline", splineFrom);
  read("rational", rationalFrom);
  read("family", familyFrom);
  read("formula", formulaFrom);
  if (!shape) {
    node.fail(version == 1 ? "missing \"bezier\" or \"chain\""
                           : "missing \"bezier\", \"chain\", \"bspline\", \"rational\", "
                             "\"family\" or \"formula\"");
  }
  SceneCurve curve{std::move(*shape)};
  if (const std::optional<JsonNode> flip = node.find("flipNormal"))
    curve.flipNormal = flip->boolean();
  return curve;
}

std::string curveText(const SceneCurve& curve, const std::string& path) {
  std::string text =
      "    {\n" + std::visit([&](const auto& kind) { return shapeText(kind, path); }, curve.shape);
  if (curve.flipNormal) text += ",\n      \"flipNormal\": true";
  return text + "\n    }";
}

}  // namespace flatland
