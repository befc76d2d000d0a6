// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>

#include "flatland/features/orientation.h"
#include "flatland/io/derivation_text.h"
#include "flatland/io/number_text.h"
#include "ui/cli/command_line.h"
#include "ui/cli/number_check.h"
#include "ui/cli/result_options.h"
#include "ui/cli/scene_argument.h"
#include "ui/cli/surface_derivation.h"

namespace flatland::ui {

namespace {

struct Options {
  std::string scene;
  std::size_t curve = 0;
  std::optional<double> t;
  std::optional<double> viewAngleDeg;
  SurfaceDerivationOptions surface;
  std::string misplaced;  ///< an option given that is of the other kind of scene
  ResultOptions result{.format = "text", .output = {}};
};

bool hasTangent(const SceneCurve& curve, double t) {
  constexpr double kStandsStill = 1e-9;
  return jetAt(curve.shape, t).d1.norm() > kStandsStill * lengthScale(curve.shape);
}

/// The place asked for, or the first of some that has a tangent. Says on standard error where the
/// equations have no meaning, and why.
double placeOn(const SceneCurve& curve, const std::optional<double>& wanted) {
  const auto note = [](double t, const char* what) {
    std::fprintf(stderr, "flatland: at t = %g the curve has no tangent%s\n", t, what);
  };
  if (wanted) {
    requirePlace(curve, *wanted);
    if (!hasTangent(curve, *wanted)) {
      note(*wanted, ", so the equations have no answer there; try another --t");
    }
    return *wanted;
  }
  constexpr double kMiddle = 0.5;
  for (const double t : {kMiddle, 0.3, 0.7, 0.15}) {
    if (!hasTangent(curve, t)) continue;
    if (t != kMiddle) note(kMiddle, (": taken at t = " + numberText(t)).c_str());
    return t;
  }
  note(kMiddle, ", so the equations have no answer there; try another --t");
  return kMiddle;
}

int run(const Options& options) {
  if (!options.misplaced.empty()) {
    throw UsageError(options.misplaced + (namesSurface(options.scene)
                                              ? " is for curves, not meshes"
                                              : " is for meshes, not curves"));
  }
  if (namesSurface(options.scene)) {
    SurfaceDerivationOptions surface = options.surface;
    surface.mesh = options.scene;
    runSurfaceDerivation(surface, options.result);
    return kDone;
  }
  const Scene scene = sceneFromArgument(options.scene, options.viewAngleDeg);
  requireCurve(scene, options.curve);
  const SceneCurve& curve = scene.curves[options.curve];
  const double t = placeOn(curve, options.t);
  const ViewFrame frame = frameOf(scene.view);
  const auto rows = derivationRows({curve.shape, t, frame, normalSide(curve, frame)});
  const std::string text = options.result.format == "json"  ? derivationToJson(rows)
                           : options.result.format == "csv" ? derivationToCsv(rows)
                                                            : derivationToText(rows);
  writeResult(options.result, text);
  return kDone;
}

}  // namespace

void addDerivationCommand(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand(
      "derivation",
      "Check the derivation of the apparent-ridge equation at a place of a curve (chapter 3 of "
      "the\n"
      "thesis) or at a vertex of a mesh (chapter 4): for each equation both sides, the residual, "
      "the\n"
      "same as printed where the print is wrong, and difference quotients over a range of step "
      "sizes.\n"
      "Or tell what becomes of a triangle (chapter 5).");
  command
      .add_option("scene", options->scene,
                  std::string(kSceneHelp) +
                      "; or a mesh (.ply .obj .stl .off .gltf .glb), or "
                      "solid:NAME[:CELLS[:irregular]]")
      ->required()
      ->type_name("SCENE");
  isWhole(command.add_option("--curve", options->curve, "Which curve, from 0 [0]")->type_name("N"),
          0);
  isNumber(
      command
          .add_option(
              "--t", options->t,
              "Where on it: piece number plus parameter, from 0 [0.5, or another place if the\n"
              "curve has no tangent there]")
          ->type_name("T"));
  addViewAngle(command, options->viewAngleDeg);
  addSurfaceDerivation(command, options->surface);
  command.add_option("--format", options->result.format, "text, json or csv [text]")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"text", "json", "csv"}).description(""));
  addOutput(command, options->result);
  command.footer(
      "Examples:\n"
      "  flatland derivation preset:thesis --t 0.3\n"
      "  flatland derivation scene.json --curve 1 --t 2.5 --format json -o check.json\n"
      "  flatland derivation solid:torus --point 1.3,0,0.2 --view 1,0.4,1\n"
      "  flatland derivation mesh.obj --triangle 17 --view 0,0,1 --perspective 35\n");
  const CLI::App* self = &command;
  command.final_callback([options, &action, self] {
    const std::vector<std::string> ofCurves{"--curve", "--t", "--view-angle"};
    for (const std::string& name :
         namesSurface(options->scene) ? ofCurves : surfaceDerivationOptionNames()) {
      if (self->count(name) > 0) options->misplaced = name;
    }
    action = [options] { return run(*options); };
  });
}

}  // namespace flatland::ui
