// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "core3d/io/fields_text.h"
#include "flatland/io/atomic_file.h"
#include "flatland/io/input_error.h"
#include "ui/cli/mesh_commands.h"
#include "ui/cli/mesh_options.h"
#include "ui/cli/picture.h"

namespace flatland::ui {

namespace {

struct Options {
  std::string mesh, output;
  Camera camera;
  FieldOptions fields;
};

std::string whyNotOutput(const std::string& file) {
  const std::string extension = extensionOf(file);
  if (extension == ".ply" || extension == ".csv") return {};
  return "the name " + file + " should end in .ply or .csv";
}

int run(const Options& options) {
  refuseToOverwrite(options.mesh, options.output);
  const PreparedMesh prepared = preparedMesh(options.mesh, options.fields);
  const TriangleMesh& mesh = prepared.built.mesh;
  if (const auto why = whyNoFieldsFile(mesh)) throw InputError(options.mesh, "", *why);
  const SurfaceView view = projectionOf(options.camera, mesh).view();
  const bool csv = extensionOf(options.output) == ".csv";
  writeFileAtomically(options.output, csv ? fieldsToCsv(mesh, prepared.fields, view)
                                          : fieldsToPly(mesh, prepared.fields, view));
  return kDone;
}

}  // namespace

void addFieldsCommand(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand(
      "fields",
      "Write what a mesh has at each vertex: normal, principal curvatures and directions, their\n"
      "derivatives, and for a view lambda with the terms of the apparent-ridge equation.");
  addMesh(command, options->mesh);
  command
      .add_option("-o,--output", options->output,
                  "File to write: .ply (binary, with the triangles) or .csv")
      ->required()
      ->type_name("FILE")
      ->check(CLI::Validator(whyNotOutput, ""));
  addCamera(command, options->camera);
  addFields(command, options->fields);
  command.footer(
      "Examples:\n"
      "  flatland fields skull.obj -o skull-fields.ply --view 1,0.5,2\n"
      "  flatland fields solid:torus:50 -o torus.csv --estimator one-ring\n");
  command.final_callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace flatland::ui
