// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/drawing_stats.h"

#include <sys/resource.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core3d/io/named_mesh.h"
#include "flatland/io/number_text.h"

namespace flatland::ui {

namespace {

/// To microseconds, and so many digits of a share: what timing and counting can mean.
std::string rounded(double value, double perUnit) {
  return numberText(std::round(value * perUnit) / perUnit);
}
std::string ms(double value) { return rounded(value, 1e3); }
std::string share(double value) { return rounded(value, 1e6); }

std::string counts(const DrawingStats& stats, std::size_t polylines) {
  return "\"segments\": " + std::to_string(stats.segments) +
         ", \"polylines\": " + std::to_string(polylines) + ", \"ink\": " + share(stats.ink) +
         ", \"share\": " + share(stats.share) +
         ", \"thresholdFactor\": " + numberText(stats.thresholdFactor, "null") +
         ", \"inkReached\": " + (stats.inkReached ? "true" : "false");
}

double peakMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;  // of KiB
}

}  // namespace

std::string statsOfDrawing(const Drawing& drawing, const TriangleMesh& mesh) {
  return "{\"triangles\": " + std::to_string(mesh.triangleCount()) +
         ", \"vertices\": " + std::to_string(mesh.vertexCount()) + ", " +
         counts(drawing.stats, drawing.polylines.size()) + "}";
}

std::string statsOfRun(const std::string& mesh, const PreparedMesh& prepared,
                       const Draughtsman::Preparation& drawer,
                       const std::vector<PictureStats>& pictures) {
  const TriangleMesh& built = prepared.built.mesh;
  std::string text =
      "{\n  \"mesh\": " +
      nlohmann::json(nameOfMesh(mesh))
          .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) +
      ",\n  \"triangles\": " + std::to_string(built.triangleCount()) +
      ",\n  \"vertices\": " + std::to_string(built.vertexCount()) +
      ",\n  \"precomputeMs\": {\"read\": " + ms(prepared.readMs) +
      ", \"fields\": " + ms(prepared.fieldsMs) + ", \"lines\": " + ms(drawer.linesMs) +
      ", \"rays\": " + ms(drawer.raysMs) +
      ", \"total\": " + ms(prepared.readMs + prepared.fieldsMs + drawer.linesMs + drawer.raysMs) +
      "},\n  \"views\": [";
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const PictureStats& picture = pictures[i];
    const DrawingStats& d = picture.drawing;
    const double total = d.vertexMs + d.segmentMs + d.chainMs + d.visibilityMs + d.strokeMs;
    text += (i == 0 ? "\n    {" : ",\n    {") + std::string("\"file\": ") +
            nlohmann::json(picture.file)
                .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) +
            ", " + counts(d, picture.polylines) + ",\n     \"ms\": {\"vertex\": " + ms(d.vertexMs) +
            ", \"segment\": " + ms(d.segmentMs) + ", \"chain\": " + ms(d.chainMs) +
            ", \"visibility\": " + ms(d.visibilityMs) + ", \"stroke\": " + ms(d.strokeMs) +
            ", \"total\": " + ms(total) + ", \"write\": " + ms(picture.writeMs) + "}}";
  }
  return text + "\n  ],\n  \"peakMemoryMb\": " + rounded(peakMegabytes(), 10.0) + "\n}\n";
}

}  // namespace flatland::ui
