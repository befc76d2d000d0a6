// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdio>
#include <memory>

#include "core3d/lines/line_finder.h"
#include "core3d/study/section.h"
#include "flatland/io/input_error.h"
#include "flatland/io/number_text.h"
#include "flatland/io/scene_json.h"
#include "ui/cli/mesh_commands.h"
#include "ui/cli/mesh_options.h"
#include "ui/cli/number_check.h"
#include "ui/cli/picture.h"

namespace flatland::ui {

namespace {

constexpr double kUsualTolerance = 1e-3;  // of the mesh's longest side

struct Options {
  std::string mesh, output;
  std::vector<double> plane, through;
  double tolerance = 0.0;
  Eigen::Vector3d towards = Eigen::Vector3d::UnitZ();
  FieldOptions fields;
  LineOptions lines;
};

std::string whyNotOutput(const std::string& file) {
  if (extensionOf(file) == ".json") return {};
  return "the name " + file + " should end in .json";
}

CutPlane planeOf(const Options& options, const PreparedMesh& prepared, const SurfaceView& view) {
  if (!options.plane.empty()) {
    const Eigen::Vector3d normal(options.plane[0], options.plane[1], options.plane[2]);
    const double length = normal.norm();
    if (!(length > 0.0)) throw UsageError("--plane: the normal is 0,0,0");
    return planeAcross(options.plane[3] / length * normal.normalized(), normal, view.towards);
  }
  const Eigen::Vector3d p(options.through[0], options.through[1], options.through[2]);
  const auto plane = planeAlongRidge(prepared.built.mesh, prepared.fields, view, p);
  if (!plane) {
    throw UsageError("--through: view-dependent curvature has no direction there; give --plane");
  }
  return *plane;
}

std::string angleText(const std::optional<double>& angleDeg) {
  std::array<char, 32> text{};
  if (!angleDeg) return "      -";
  std::snprintf(text.data(), text.size(), "%7.2f", *angleDeg);
  return text.data();
}

std::string reportOf(const Section& section, const SectionMarks& compared) {
  std::array<char, 200> line{};
  std::snprintf(line.data(), line.size(),
                "%zu curves, at most %.3g from the section, %zu corners; %zu touched points left "
                "out\n",
                section.scene.curves.size(), section.maxDeviation, section.corners,
                section.slice.touched);
  std::string text = line.data();
  if (!compared.complete) text += "flatland leaves some marks open: see flatland features\n";
  text += "marks of the section (t_A off plane: 0 where flatland's equation is the surface's)\n";
  for (const SectionMark& each : compared.marks) {
    if (each.mark.kind != MarkKind::ApparentRidge && each.mark.kind != MarkKind::Silhouette)
      continue;
    std::snprintf(line.data(), line.size(),
                  "  %-14s curve %d t %-9.5g x %-10.5g y %-10.5g %s deg\n",
                  std::string(nameOf(each.mark.kind)).c_str(), each.mark.curve, each.mark.t,
                  each.mark.point.x(), each.mark.point.y(), angleText(each.offPlaneDeg).c_str());
    text += line.data();
  }
  text += "apparent ridges of the surface through the plane\n";
  for (const CrossedRidge& ridge : compared.ridges) {
    std::snprintf(line.data(), line.size(), "  x %-10.5g y %-10.5g %s deg, nearest mark ",
                  ridge.inPlane.x(), ridge.inPlane.y(), angleText(ridge.offPlaneDeg).c_str());
    text += line.data();
    std::snprintf(line.data(), line.size(), "%.4g away\n", ridge.toMark.value_or(0.0));
    text += ridge.toMark ? line.data() : "none\n";
  }
  return text;
}

int run(const Options& options) {
  if (options.plane.empty() == options.through.empty()) {
    throw UsageError("give either --plane or --through");
  }
  const PreparedMesh prepared = preparedMesh(options.mesh, options.fields);
  const TriangleMesh& mesh = prepared.built.mesh;
  if (const double side = 2.0 * mesh.unit;
      !(side >= 1.0 / kLargestLength && side <= kLargestLength)) {
    throw InputError(options.mesh, "",
                     "the longest side is " + numberText(side) +
                         ": sections become curves for sides from 1e-50 to 1e50");
  }
  const SurfaceView view{.towards = options.towards, .eye = {}};
  const double tolerance =
      options.tolerance > 0.0 ? options.tolerance : 2.0 * mesh.unit * kUsualTolerance;
  const Section section = sectionOf(mesh, planeOf(options, prepared, view), tolerance);
  if (section.scene.curves.empty()) throw UsageError("the plane does not cut the mesh");
  LineFinder finder(mesh, prepared.fields);
  const FeatureLines found = finder.find(view, options.lines);
  saveScene(section.scene, options.output);
  writeToStandardOutput(reportOf(section, compareSection(section, mesh, prepared.fields, view,
                                                         found.of(LineFamily::ApparentRidges))));
  return kDone;
}

}  // namespace

void addSliceCommand(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  options->lines[LineFamily::ApparentRidges] = true;
  CLI::App& command = *app.add_subcommand(
      "slice",
      "Cut a mesh by a plane and write the section as a scene of flatland, with the same view.\n"
      "Its marks, and the apparent ridges of the surface that go through the plane, go to "
      "standard\n"
      "output, with the angle between t_A and the plane: why they differ.");
  addMesh(command, options->mesh);
  isNumber(command
               .add_option("--plane", options->plane,
                           "The plane NX x + NY y + NZ z = D in the coordinates of the mesh's file")
               ->type_name("NX,NY,NZ,D")
               ->delimiter(',')
               ->expected(4));
  isNumber(
      command
          .add_option(
              "--through", options->through,
              "The plane through the vertex nearest to this place, along the view and t_A there")
          ->type_name("X,Y,Z")
          ->delimiter(',')
          ->expected(3));
  addDirection(command, "--view", options->towards, "From the mesh towards the viewer [0,0,1]");
  isNumber(
      command
          .add_option(
              "--tolerance", options->tolerance,
              "How far the curves may be from the section, in the unit of the file [1/1000 of\n"
              "the mesh's longest side]")
          ->type_name("LENGTH"),
      1e-12, 1e12);
  addFields(command, options->fields);
  command.add_option("-o,--output", options->output, "Scene file to write: .json")
      ->required()
      ->type_name("FILE")
      ->check(CLI::Validator(whyNotOutput, ""));
  command.footer(
      "Examples:\n"
      "  flatland slice skull.obj --plane 1,0,0,0 --view 0,0.2,1 -o section.json\n"
      "  flatland slice solid:torus --through 2.5,0,0 --view 1,0.5,2 -o section.json\n");
  command.final_callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace flatland::ui
