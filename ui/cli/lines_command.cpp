// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "core3d/draw/compose.h"
#include "core3d/draw/draughtsman.h"
#include "core3d/io/cameras_json.h"
#include "core3d/io/drawing_json.h"
#include "core3d/io/named_mesh.h"
#include "flatland/io/atomic_file.h"
#include "flatland/io/input_error.h"
#include "ui/cli/drawing_stats.h"
#include "ui/cli/mesh_commands.h"
#include "ui/cli/mesh_options.h"
#include "ui/cli/number_check.h"
#include "ui/cli/picture.h"
#include "ui/cli/progress.h"
#include "ui/cli/suggestion.h"
#include "ui/export/drawing_figure.h"

namespace flatland::ui {

namespace {

struct Options {
  std::string mesh, output, cameras;
  std::string command;  ///< for the file's account of itself
  Camera camera;
  FieldOptions fields;
  LineOptions lines;
  StrokeOptions strokes;
  DrawingFigureOptions figure;
  PixelSize size{800, 600};
  std::optional<double> width, minLength;  ///< px, if asked for
  double dpi = 96.0;
  int turntable = 0;
  bool viewGiven = false;
  bool stats = false;
};

template <typename Value>
using Words = std::vector<std::pair<std::string, Value>>;

const Words<DrawingFigureOptions::Hidden> kHiddenWords = {
    {"remove", DrawingFigureOptions::Hidden::Remove},
    {"dash", DrawingFigureOptions::Hidden::Dash},
    {"show", DrawingFigureOptions::Hidden::Show}};
const Words<DrawingFigureOptions::Style> kStyleWords = {
    {"plain", DrawingFigureOptions::Style::Plain},
    {"width", DrawingFigureOptions::Style::Width},
    {"taper", DrawingFigureOptions::Style::Taper},
    {"fade", DrawingFigureOptions::Style::Fade}};

template <typename Value>
std::string wordOf(Value value, const Words<Value>& words) {
  for (const auto& [word, meaning] : words) {
    if (meaning == value) return word;
  }
  return {};
}

bool isJson(const std::string& file) { return extensionOf(file) == ".json"; }

std::string whyNotOutput(const std::string& file) {
  if (file == "-") return "the format is told by a file's name, which standard output has not";
  if (isPicture(file) || isJson(file)) return {};
  return "the name " + file + " should end in .svg, .pdf, .png, .tex or .json";
}

/// A camera and the file that its picture goes to.
struct View {
  Camera camera;
  std::string file;
  bool fitBall = true;  ///< several views show the mesh at one size
};

/// "a.svg" and "front" to "a-front.svg".
std::string withPart(const std::string& file, const std::string& part) {
  const std::filesystem::path path(file);
  return (path.parent_path() / (path.stem().string() + "-" + part + path.extension().string()))
      .string();
}

/// "007" where there are hundreds; two digits at least.
std::string numbered(std::size_t number, std::size_t count) {
  const std::size_t digits = std::max<std::size_t>(std::to_string(count).size(), 2);
  const std::string text = std::to_string(number);
  return std::string(digits - text.size(), '0') + text;
}

std::vector<View> viewsOf(const Options& options) {
  if (!options.cameras.empty()) {
    std::vector<View> views;
    std::map<std::string, std::size_t> cameraOf;  // by the picture's file
    const std::vector<NamedCamera> cameras = loadCameras(options.cameras, options.camera);
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      const std::string& name = cameras[i].name;
      views.push_back(
          {cameras[i].camera,
           withPart(options.output, name.empty() ? numbered(i + 1, cameras.size()) : name)});
      const auto [other, isNew] = cameraOf.try_emplace(views.back().file, i);
      if (!isNew) {
        throw InputError(options.cameras, "cameras[" + std::to_string(i) + "]",
                         "its picture would be " + views.back().file + ", as that of cameras[" +
                             std::to_string(other->second) + "]; give it another name");
      }
    }
    if (views.size() == 1) views.front().fitBall = false;
    return views;
  }
  if (options.turntable == 0) return {{options.camera, options.output, false}};
  std::vector<View> views;
  const auto count = static_cast<std::size_t>(options.turntable);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / options.turntable;
    View view{options.camera, withPart(options.output, numbered(i + 1, count))};
    view.camera.towards =
        Eigen::AngleAxisd(angle, options.camera.up.normalized()) * options.camera.towards;
    views.push_back(std::move(view));
  }
  return views;
}

/// What made the picture, beside the command, in words of the options. The thresholds are those
/// that were used: the given ones times `factor` where ink moves them.
std::string recordOf(const Options& options, const View& view, double factor) {
  using nlohmann::json;
  json record{{"mesh", nameOfMesh(options.mesh)},
              {"camera", json::parse(cameraToJson(view.camera))},
              {"size", {options.size.width, options.size.height}},
              {"estimator", nameOf(options.fields.estimator)},
              {"scale", options.fields.scale},
              {"derivative", nameOf(options.lines.derivative)},
              {"lines", json::array()},
              {"thresholds", json::object()},
              {"ink", nullptr},
              {"unfiltered", options.lines.unfiltered},
              {"minLength",
               options.strokes.minLengthPx * pictureScale(options.size.width, options.size.height)},
              {"simplify", options.strokes.tolerancePx},
              {"fit", view.fitBall ? "ball" : "outline"},
              {"hidden", wordOf(options.figure.hidden, kHiddenWords)},
              {"style", wordOf(options.figure.style, kStyleWords)},
              {"width", options.figure.widthPx},
              {"colours", options.figure.colours},
              {"dark", options.figure.palette == Palette::Dark},
              {"transparent", options.figure.transparent}};
  for (const LineFamily family : allLineFamilies()) {
    if (!options.lines[family]) continue;
    record["lines"].push_back(nameOf(family));
    const double moved = movesWithInk(family) ? factor : 1.0;
    record["thresholds"][std::string(nameOf(family))] = moved * options.lines.thresholdOf(family);
    if (family == LineFamily::Isophotes) record["isophotes"] = options.lines.isophoteLevels;
    if (family == LineFamily::Topographic) {
      const Eigen::Vector3d& up = options.lines.topographicUp;
      record["topographic"] = options.lines.topographicLevels;
      record["topographicUp"] = {up.x(), up.y(), up.z()};
    }
  }
  if (options.strokes.ink) {
    record["ink"] = *options.strokes.ink;
    record["thresholdFactor"] = factor;
  }
  return record.dump(1, ' ', false, json::error_handler_t::replace);
}

void write(const Options& options, const View& view, const Drawing& drawing,
           const TriangleMesh& mesh) {
  if (isJson(view.file)) {
    writeFileAtomically(view.file, drawingToJson(drawing, mesh, statsOfDrawing(drawing, mesh)));
    return;
  }
  DrawingFigureOptions figure = options.figure;
  figure.threshold = drawing.weak;
  writePicture(view.file, drawingFigure(drawing, figure),
               {.title = "Flatland: " + nameOfMesh(options.mesh),
                .program = "flatland " FLATLAND_VERSION,
                .command = options.command,
                .sceneJson = recordOf(options, view, drawing.stats.thresholdFactor),
                .sceneName = "drawing"},
               options.dpi);
}

void tellInk(const std::string& file, double reached, double asked) {
  // Four digits are more than the tolerance within which ink counts as reached.
  std::fprintf(stderr,
               "flatland: %s: ink of %.4g is not reached; strokes worth drawing give %.4g\n",
               file.c_str(), asked, reached);
}

int run(const Options& given) {
  Options options = given;
  if (options.turntable > 0 && !options.cameras.empty()) {
    throw UsageError("--turntable and --cameras exclude each other");
  }
  requireQtFor(options.output);
  if (looksAlongUp(options.camera)) {
    if (!options.viewGiven) {
      // The usual view z with the usual up y, turned until y is this up.
      options.camera.towards = {0.0, options.camera.up.z() > 0.0 ? -1.0 : 1.0, 0.0};
    } else if (options.turntable > 0) {
      throw UsageError(
          "--turntable turns the view about --up, but --view is along it; choose another");
    }
  }
  options.camera.width = options.size.width;
  options.camera.height = options.size.height;
  options.strokes.hidden = options.figure.hidden != DrawingFigureOptions::Hidden::Remove;
  // Unless px are asked for, pictures of all sizes look alike.
  const double scale = pictureScale(options.size.width, options.size.height);
  options.camera.margin *= scale;
  options.figure.widthPx = options.width.value_or(options.figure.widthPx * scale);
  if (options.minLength) options.strokes.minLengthPx = *options.minLength / scale;
  options.strokes.inkWidthPx = options.figure.widthPx / scale;
  const std::vector<View> views = viewsOf(options);
  for (const View& view : views) refuseToOverwrite(options.mesh, view.file);

  const PreparedMesh prepared = preparedMesh(options.mesh, options.fields);
  const TriangleMesh& mesh = prepared.built.mesh;
  Draughtsman draughtsman(mesh, prepared.fields);
  std::vector<PictureStats> pictures;
  Progress progress;
  for (const View& view : views) {
    const Projection projection = projectionOf(view.camera, mesh, view.fitBall);
    const Drawing drawing = draughtsman.draw(projection, options.lines, options.strokes);
    if (!drawing.stats.inkReached) tellInk(view.file, drawing.stats.ink, *options.strokes.ink);
    const auto start = std::chrono::steady_clock::now();
    write(options, view, drawing, mesh);
    pictures.push_back({std::filesystem::path(view.file).filename().string(), drawing.stats,
                        drawing.polylines.size(), millisecondsSince(start)});
    progress.say(std::to_string(pictures.size()) + " of " + std::to_string(views.size()) +
                 " views");
  }
  if (options.stats)
    writeToStandardOutput(statsOfRun(options.mesh, prepared, draughtsman.preparation(), pictures));
  return kDone;
}

/// An option with one of a few words, each for a value.
template <typename Value>
void addChoice(CLI::App& command, const std::string& name, Value& value,
               const Words<Value>& choices, const std::string& help) {
  std::vector<std::string> words;
  for (const auto& choice : choices) words.push_back(choice.first);
  command
      .add_option_function<std::string>(
          name,
          [&value, choices](const std::string& word) {
            for (const auto& choice : choices) {
              if (choice.first == word) value = choice.second;
            }
          },
          help)
      ->type_name("HOW")
      ->check(oneOf("value", words));
}

void addViews(CLI::App& command, Options& options) {
  addCamera(command, options.camera);
  addFraming(command, options.camera);
  addSize(command, options.size);
  isWhole(command
              .add_option("--turntable", options.turntable,
                          "N pictures, turned about --up once round: FILE-01.svg, FILE-02.svg, ...")
              ->type_name("N"),
          2, 100000);
  command
      .add_option("--cameras", options.cameras,
                  "One picture for each camera of a list (docs/user/lines.md)")
      ->type_name("FILE");
}

void addStrokes(CLI::App& command, Options& options) {
  isNumber(
      command
          .add_option_function<double>(
              "--ink", [&options](const double& share) { options.strokes.ink = share; },
              "Solve for the thresholds with which strokes cover this share of the pixels, for\n"
              "example 0.04")
          ->type_name("SHARE"),
      1e-6, 1.0);
  isNumber(command
               .add_option_function<double>(
                   "--min-length", [&options](const double& px) { options.minLength = px; },
                   "Leave out strokes shorter than this, but for whole contours [6 at 800x600, in\n"
                   "proportion at other sizes]")
               ->type_name("PX"),
           0.0, 10000.0);
  isNumber(command
               .add_option("--simplify", options.strokes.tolerancePx,
                           "How far a stroke may be moved to save points [0.2]")
               ->type_name("PX"),
           0.0, 100.0);
}

void addStyle(CLI::App& command, Options& options) {
  addChoice(command, "--hidden", options.figure.hidden, kHiddenWords,
            "Lines behind the mesh: remove, dash or show [remove]");
  addChoice(command, "--style", options.figure.style, kStyleWords,
            "What a line's strength does: plain, nothing; width or fade of each stroke;\n"
            "taper, width along the stroke with pointed ends [plain]");
  isNumber(command
               .add_option_function<double>(
                   "--width", [&options](const double& px) { options.width = px; },
                   "Width of the strokes [1.5 at 800x600, in proportion at other sizes]")
               ->type_name("PX"),
           0.01, 100.0);
  command.add_flag("--colours", options.figure.colours, "A colour for each family");
  isNumber(command
               .add_option(
                   "--dpi", options.dpi,
                   "PNG: pixels per inch; a pixel of --size is 1/96 inch, so 192 doubles it [96]")
               ->type_name("DPI"),
           8.0, 4800.0);
  command.add_flag("--transparent", options.figure.transparent, "No background");
  command.add_flag_callback(
      "--dark", [&options] { options.figure.palette = Palette::Dark; },
      "Colours for a dark background");
}

}  // namespace

void addLinesCommand(CLI::App& app, Action& action, const std::string& commandLine) {
  const auto options = std::make_shared<Options>();
  options->command = commandLine;
  setUsualLines(options->lines);
  CLI::App& command = *app.add_subcommand(
      "lines",
      "Draw a mesh as lines: contours, apparent ridges and others, hidden ones removed. The name\n"
      "of the output says the format: SVG, PDF, PNG, TikZ for .tex, or the strokes as JSON.");
  addMesh(command, options->mesh);
  command
      .add_option("-o,--output", options->output, "File to write: .svg, .pdf, .png, .tex or .json")
      ->required()
      ->type_name("FILE")
      ->check(CLI::Validator(whyNotOutput, ""));
  addLineFamilies(command, options->lines);
  addViews(command, *options);
  addStrokes(command, *options);
  addStyle(command, *options);
  addFields(command, options->fields);
  command.add_flag("--stats", options->stats,
                   "Print counts, times and memory as JSON on standard output");
  command.footer(
      "Examples:\n"
      "  flatland lines skull.obj -o skull.svg --view 1,0.5,2\n"
      "  flatland lines hand.obj -o hand.pdf --ink 0.009 --style taper\n"
      "  flatland lines solid:torus -o torus.json --lines contours --hidden dash\n"
      "  flatland lines boot.obj -o boot.svg --turntable 36 --perspective 30\n");
  command.final_callback([options, &command, &action] {
    options->viewGiven = command.count("--view") > 0;
    refuseIdleOptions(command, options->lines);
    action = [options] { return run(*options); };
  });
}

}  // namespace flatland::ui
