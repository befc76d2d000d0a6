// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <memory>

#include "flatland/io/input_error.h"
#include "ui/cli/command_line.h"
#include "ui/cli/help_text.h"
#include "ui/cli/mesh_commands.h"
#include "ui/cli/mesh_options.h"
#include "ui/cli/number_check.h"

namespace {

using namespace flatland::ui;

/// One line on standard error, whatever the message holds; names of files may hold what terminals
/// act on.
int report(std::string message, ExitCode code) {
  std::replace_if(
      message.begin(), message.end(), [](unsigned char c) { return c < ' ' || c == '\x7f'; }, ' ');
  std::fprintf(stderr, "flatland: %s\n", message.c_str());
  return code;
}

/// What CLI::ExtrasError says, with the arguments in the order in which they were given.
std::string unexpectedArguments(const CLI::App& app) {
  const std::vector<std::string> extras = app.remaining(true);
  std::string said = extras.size() > 1 ? "The following arguments were not expected:"
                                       : "The following argument was not expected:";
  for (const std::string& extra : extras) said += " " + extra;
  return said;
}

void describe(CLI::App& app) {
  app.name("flatland");
  app.formatter(std::make_shared<WrappedHelp>());  // of the subcommands too
  app.set_version_flag("--version", "flatland " FLATLAND_VERSION);
  app.footer(
      "Examples:\n"
      "  flatland                                  the window, on a curve that shows every mark\n"
      "  flatland scene.json                       the window, on a scene of yours\n"
      "  flatland features preset:thesis           every mark, as JSON\n"
      "  flatland draw preset:thesis -o fig.svg    a picture (also .pdf, .png, .tex)\n"
      "  flatland sweep preset:thesis -o sweep.svg the marks for every view direction\n"
      "  flatland study offset                     how large the offset term is\n"
      "  flatland import drawing.svg -o scene.json a scene from the outlines of a drawing\n"
      "  flatland derivation preset:thesis         the derivation, checked at a place\n"
      "  flatland lines mesh.obj -o lines.svg      a mesh as a line drawing\n"
      "  flatland SUBCOMMAND --help                more on each\n"
      "\n"
      "Exit codes: 0 done, 1 bad input, 2 bad usage, 3 internal error.\n");
}

int run(int argc, char** argv) {
  CLI::App app(
      "Flatland shows curves as a flatlander sees them: on a screen that is a line. It finds\n"
      "silhouettes, ridges, valleys, inflections and apparent ridges, the maxima of "
      "view-dependent\n"
      "curvature.");
  describe(app);
  Action action;
  addWindowCommand(app, action);
  addFeaturesCommand(app, action);
  addDrawCommand(app, action, commandWithoutFolders(argc, argv));
  addProfileCommand(app, action);
  addSweepCommand(app, action, commandWithoutFolders(argc, argv));
  addStudyCommand(app, action);
  addDerivationCommand(app, action);
  addLinesCommand(app, action, commandWithoutFolders(argc, argv));
  addFieldsCommand(app, action);
  addConvergenceCommand(app, action, commandWithoutFolders(argc, argv));
  addBridgeCommand(app, action, commandWithoutFolders(argc, argv));
  addSliceCommand(app, action);
  addShotCommand(app, action);
  addPresetsCommand(app, action);
  addImportCommand(app, action);
  app.require_subcommand(0, 1);
  try {
    app.parse(argc, argv);
    if (const std::string why = whyNotLists(app, argc, argv); !why.empty()) {
      throw CLI::ParseError(why, CLI::ExitCodes::ValidationError);
    }
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // help or version
    const bool isExtra = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
    const std::string what = isExtra ? unexpectedArguments(app) : error.what();
    std::string help = "flatland";
    for (const CLI::App* command = &app; !command->get_subcommands().empty();) {
      command = command->get_subcommands().back();
      help += " " + command->get_name();
    }
    return report(what + " (see " + help + " --help)" + likelyMeaning(app, argc, argv), kBadUsage);
  }
  const bool isWindow = app.get_subcommands().empty();
  const std::string meant = isWindow ? likelyMeaning(app, argc, argv) : std::string();
  if (meant.empty()) return action();
  try {
    return action();
  } catch (const flatland::InputError& error) {
    return report(error.what() + meant, kBadInput);
  } catch (const UsageError& error) {
    return report(error.what() + meant, kBadUsage);
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const flatland::InputError& error) {
    return report(error.what(), kBadInput);
  } catch (const UsageError& error) {
    return report(error.what(), kBadUsage);
  } catch (const std::exception& error) {
    return report(std::string("internal error: ") + error.what(), kInternalError);
  }
}
