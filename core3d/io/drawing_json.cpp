// SPDX-License-Identifier: MIT
#include "core3d/io/drawing_json.h"

#include <cstddef>

#include "flatland/io/number_text.h"

namespace flatland {

namespace {

/// "[a, b, ...]" of what `textOf` makes of 0, 1, ..., count - 1.
template <typename TextOf>
std::string listText(std::size_t count, const TextOf& textOf) {
  std::string list = "[";
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) list += ", ";
    list += textOf(i);
  }
  return list + "]";
}

bool hasLevels(LineFamily family) {
  return family == LineFamily::Isophotes || family == LineFamily::Topographic;
}

std::string polylineText(const Polyline& line, const TriangleMesh& mesh) {
  std::string text = "    {\"family\": \"" + std::string(nameOf(line.family)) + "\"";
  if (hasLevels(line.family)) text += ", \"level\": " + std::to_string(line.level);
  text += std::string(", \"visible\": ") + (line.visible ? "true" : "false") +
          ", \"closed\": " + (line.closed ? "true" : "false");
  text +=
      ",\n     \"points\": " + listText(line.points.size(), [&](std::size_t i) {
        const Eigen::Vector3d p = mesh.origin + mesh.unit * line.points[i].cast<double>();
        return "[" + numberText(p.x()) + ", " + numberText(p.y()) + ", " + numberText(p.z()) + "]";
      });
  text +=
      ",\n     \"screen\": " + listText(line.screen.size(), [&](std::size_t i) {
        return "[" + numberText(line.screen[i].x()) + ", " + numberText(line.screen[i].y()) + "]";
      });
  text += ",\n     \"strength\": " + listText(line.strength.size(), [&](std::size_t i) {
            return numberText(static_cast<double>(line.strength[i]), "null");
          });
  return text + "}";
}

}  // namespace

std::string drawingToJson(const Drawing& drawing, const TriangleMesh& mesh,
                          const std::string& statsJson) {
  std::string text = "{\n  \"polylines\": [";
  for (std::size_t i = 0; i < drawing.polylines.size(); ++i) {
    text += (i == 0 ? "\n" : ",\n") + polylineText(drawing.polylines[i], mesh);
  }
  text += drawing.polylines.empty() ? "],\n" : "\n  ],\n";
  return text + "  \"stats\": " + statsJson + "\n}\n";
}

}  // namespace flatland
