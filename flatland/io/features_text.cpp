// SPDX-License-Identifier: MIT
#include "flatland/io/features_text.h"

#include <nlohmann/json.hpp>

#include "flatland/io/number_text.h"

namespace flatland {

namespace {

std::string jsonString(std::string_view text) { return nlohmann::json(text).dump(); }

std::string intervalText(double low, double high) {
  return "[" + numberText(low, "null") + ", " + numberText(high, "null") + "]";
}

std::string_view nameOf(Degenerate::What what) {
  switch (what) {
    case Degenerate::What::Point:
      return "point";
    case Degenerate::What::Straight:
      return "straight";
    case Degenerate::What::StraightEndOn:
      return "straight-end-on";
    case Degenerate::What::ConstantCurvature:
      return "constant-curvature";
  }
  return "";
}

/// The turn of a corner; other marks have none.
std::optional<double> turnOf(const Mark& mark) {
  if (mark.kind != MarkKind::Corner) return std::nullopt;
  return mark.turnDeg;
}

/// Minus zero tells a reader nothing here.
double plainZero(double value) { return value == 0.0 ? 0.0 : value; }
std::optional<double> plainZero(const std::optional<double>& value) {
  return value ? std::optional(plainZero(*value)) : std::nullopt;
}

std::string entry(const Mark& mark) {
  return "{\"kind\": " + jsonString(nameOf(mark.kind)) +
         ", \"curve\": " + std::to_string(mark.curve) +
         ", \"t\": " + numberText(plainZero(mark.t), "null") +
         ", \"u\": " + numberText(plainZero(mark.u), "null") + ", \"point\": [" +
         numberText(plainZero(mark.point.x()), "null") + ", " +
         numberText(plainZero(mark.point.y()), "null") +
         "], \"screen\": " + numberText(plainZero(mark.screen), "null") +
         ", \"visible\": " + (mark.visible ? "true" : "false") +
         ", \"lambda\": " + numberText(plainZero(mark.lambda), "null") +
         ", \"feature\": " + numberText(plainZero(mark.feature), "null") +
         ", \"offset\": " + numberText(plainZero(mark.offset), "null") +
         ", \"perspective\": " + numberText(plainZero(mark.perspective), "null") +
         ", \"residual\": " + numberText(plainZero(mark.residual), "null") +
         ", \"turnDeg\": " + numberText(turnOf(mark), "null") + "}";
}

std::string entry(const Unresolved& unresolved) {
  return "{\"kind\": " + jsonString(nameOf(unresolved.kind)) +
         ", \"curve\": " + std::to_string(unresolved.curve) +
         ", \"t\": " + intervalText(unresolved.tLow, unresolved.tHigh) +
         ", \"reason\": " + jsonString(unresolved.reason) + "}";
}

std::string entry(const Degenerate& degenerate) {
  return "{\"what\": " + jsonString(nameOf(degenerate.what)) +
         ", \"curve\": " + std::to_string(degenerate.curve) +
         ", \"t\": " + intervalText(degenerate.tLow, degenerate.tHigh) + "}";
}

std::string entry(const CurveSearch& search) {
  const std::string start = "{\"curve\": " + std::to_string(search.curve) + ", \"method\": ";
  if (search.certified) return start + "\"bernstein\"}";
  return start + "\"chebyshev\", \"pieces\": " + std::to_string(search.pieces) +
         ", \"degree\": " + std::to_string(search.degree) +
         ", \"errorBound\": " + numberText(search.errorBound, "null") + "}";
}

/// A list with one entry on a line.
template <class Item>
std::string listText(const std::vector<Item>& items) {
  std::string text = "[";
  for (std::size_t i = 0; i < items.size(); ++i) {
    text += (i == 0 ? "\n    " : ",\n    ") + entry(items[i]);
  }
  return text + (items.empty() ? "]" : "\n  ]");
}

}  // namespace

std::string featuresToJson(const FeatureSet& features, const View& view) {
  return "{\n  \"flatland\": 1,\n  \"view\": {\"angleDeg\": " + numberText(view.angleDeg, "null") +
         ", \"distance\": " + numberText(view.distance, "null") +
         "},\n  \"marks\": " + listText(features.marks) +
         ",\n  \"complete\": " + (features.complete() ? "true" : "false") +
         ",\n  \"unresolved\": " + listText(features.unresolved) +
         ",\n  \"degenerate\": " + listText(features.degenerate) +
         ",\n  \"search\": " + listText(features.searches) + "\n}\n";
}

std::string featuresToCsv(const FeatureSet& features) {
  std::string text =
      "kind,curve,t,u,x,y,screen,visible,lambda,feature,offset,perspective,residual,turnDeg\r\n";
  for (const Mark& mark : features.marks) {
    text += std::string(nameOf(mark.kind)) + "," + std::to_string(mark.curve);
    for (const std::optional<double>& value :
         {std::optional(mark.t), std::optional(mark.u), std::optional(mark.point.x()),
          std::optional(mark.point.y()), mark.screen}) {
      text += "," + numberText(plainZero(value), "");
    }
    text += mark.visible ? ",true" : ",false";
    for (const std::optional<double>& value :
         {mark.lambda, mark.feature, mark.offset, mark.perspective, std::optional(mark.residual),
          turnOf(mark)}) {
      text += "," + numberText(plainZero(value), "");
    }
    text += "\r\n";
  }
  return text;
}

}  // namespace flatland
