// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/surface_derivation.h"

#include <algorithm>
#include <limits>

#include "core3d/io/surface_derivation_json.h"
#include "ui/cli/number_check.h"

namespace flatland::ui {

namespace {

std::uint32_t nearestVertex(const TriangleMesh& mesh, const std::vector<double>& point) {
  const Eigen::Vector3d wanted(point[0], point[1], point[2]);
  double least = std::numeric_limits<double>::infinity();
  std::uint32_t nearest = 0;
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const double distance = (mesh.positionInFile(v) - wanted).squaredNorm();
    if (!(distance < least)) continue;
    least = distance;
    nearest = v;
  }
  return nearest;
}

std::uint32_t vertexOf(const TriangleMesh& mesh, const SurfaceDerivationOptions& options) {
  if (!options.vertex) return nearestVertex(mesh, options.point);
  const std::size_t count = mesh.meshVertex.size();
  if (*options.vertex >= count) {
    throw UsageError("--vertex " + std::to_string(*options.vertex) + ": the file has " +
                     std::to_string(count) + ", from 0");
  }
  const std::uint32_t vertex = mesh.meshVertex[*options.vertex];
  if (vertex == TriangleMesh::kNone) {
    throw UsageError("--vertex " + std::to_string(*options.vertex) + ": no triangle uses it");
  }
  return vertex;
}

std::uint32_t triangleOf(const TriangleMesh& mesh, std::uint32_t face) {
  const auto found = std::find(mesh.filePolygon.begin(), mesh.filePolygon.end(), face);
  if (found == mesh.filePolygon.end()) {
    throw UsageError("--triangle " + std::to_string(face) + ": the mesh has no such face");
  }
  return static_cast<std::uint32_t>(found - mesh.filePolygon.begin());
}

}  // namespace

const std::vector<std::string>& surfaceDerivationOptionNames() {
  static const std::vector<std::string> kNames{
      "--point", "--vertex",      "--triangle",  "--threshold", "--view",
      "--up",    "--perspective", "--estimator", "--scale",     "--threads"};
  return kNames;
}

void addSurfaceDerivation(CLI::App& command, SurfaceDerivationOptions& options) {
  isNumber(command
               .add_option("--point", options.point,
                           "Of a mesh: the vertex nearest to this place, in the file's coordinates")
               ->type_name("X,Y,Z")
               ->delimiter(',')
               ->expected(3));
  isWhole(
      command
          .add_option("--vertex", options.vertex, "Of a mesh: the vertex of this number, from 0")
          ->type_name("N"),
      0, std::numeric_limits<std::uint32_t>::max());
  isWhole(command
              .add_option(
                  "--triangle", options.triangle,
                  "Of a mesh: what becomes of the face of this number, from 0, in the search for\n"
                  "apparent ridges (Fig. 5-1 of the thesis); of a polygon its first triangle")
              ->type_name("N"),
          0, std::numeric_limits<std::uint32_t>::max());
  isNumber(command
               .add_option("--threshold", options.threshold,
                           "Of apparent ridges, for --triangle, as in flatland lines [2]")
               ->type_name("V"),
           0.0, 1e6);
  addCamera(command, options.camera);
  addFields(command, options.fields);
}

void runSurfaceDerivation(const SurfaceDerivationOptions& options, const ResultOptions& result) {
  const int places =
      !options.point.empty() + options.vertex.has_value() + options.triangle.has_value();
  if (places != 1) throw UsageError("of a mesh give one of --point, --vertex and --triangle");
  if (options.triangle && result.format == "csv") {
    throw UsageError("--triangle is told as text or json");
  }
  if (!result.output.empty()) refuseToOverwrite(options.mesh, result.output);
  const PreparedMesh prepared = preparedMesh(options.mesh, options.fields);
  const TriangleMesh& mesh = prepared.built.mesh;
  if (mesh.vertexCount() == 0) throw UsageError("the mesh has no triangle");
  const Projection projection = projectionOf(options.camera, mesh);
  const SurfaceView view = projection.view();
  if (options.triangle) {
    const std::uint32_t triangle = triangleOf(mesh, *options.triangle);
    const TriangleLesson lesson =
        TriangleStudy(mesh, prepared.fields).lesson(triangle, view, options.threshold);
    writeResult(result, result.format == "json" ? triangleLessonToJson(mesh, lesson)
                                                : triangleLessonToText(mesh, lesson));
    return;
  }
  const SurfaceDerivation derivation = surfaceDerivationAt(
      mesh, prepared.fields, view, projection.axes.row(0), vertexOf(mesh, options));
  writeResult(result, result.format == "json"  ? surfaceDerivationToJson(derivation)
                      : result.format == "csv" ? derivationToCsv(derivation.rows)
                                               : surfaceDerivationToText(derivation));
}

}  // namespace flatland::ui
