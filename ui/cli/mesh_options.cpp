// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/mesh_options.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "core3d/io/named_mesh.h"
#include "flatland/io/input_error.h"
#include "flatland/view/perspective.h"
#include "ui/cli/number_check.h"
#include "ui/cli/progress.h"
#include "ui/cli/suggestion.h"

namespace flatland::ui {

namespace {

constexpr double kLargestCreaseDeg = 180.0;  // between triangles folded onto one another

std::optional<double> numberFrom(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// "x,y,z"; nullopt if it is none.
std::optional<Eigen::Vector3d> placeFrom(std::string_view text) {
  Eigen::Vector3d place;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (i == 2)) return std::nullopt;
    const std::optional<double> value = numberFrom(text.substr(0, comma));
    if (!value) return std::nullopt;
    place[i] = *value;
    text.remove_prefix(i == 2 ? text.size() : comma + 1);
  }
  return place;
}

/// "x,y,z" as a unit vector; nullopt if it is none.
std::optional<Eigen::Vector3d> directionFrom(std::string_view text) {
  const std::optional<Eigen::Vector3d> direction = placeFrom(text);
  const double size = direction ? direction->cwiseAbs().maxCoeff() : 0.0;
  if (!(size > 0.0)) return std::nullopt;
  return (*direction / size).normalized();
}

std::vector<std::string> familyNames() {
  std::vector<std::string> names;
  for (const LineFamily family : allLineFamilies()) names.emplace_back(nameOf(family));
  return names;
}

std::vector<std::string> namesWithThreshold() {
  const std::array<double, kLineFamilyCount> usual = LineOptions::defaultThresholds();
  std::vector<std::string> names;
  for (const LineFamily family : allLineFamilies()) {
    if (usual[static_cast<std::size_t>(family)] > 0.0) names.emplace_back(nameOf(family));
  }
  return names;
}

/// "ridges" of "ridges=0.5".
std::string familyOfThreshold(const std::string& text) { return text.substr(0, text.find('=')); }

/// Why "ridges=0.5" is no threshold, or empty.
std::string whyNotThreshold(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return "expected FAMILY=VALUE, found " + text;
  const std::string name = familyOfThreshold(text);
  const std::string why = whyNotNamed("line family", name, familyNames());
  if (!why.empty()) return why;
  const std::string whyNone = whyNotNamed("threshold of", name, namesWithThreshold());
  if (!whyNone.empty()) return whyNone;
  const std::optional<double> value = numberFrom(std::string_view(text).substr(equals + 1));
  const bool isAngle = name == nameOf(LineFamily::Creases);
  if (value && *value >= 0.0 && (!isAngle || *value <= kLargestCreaseDeg)) return {};
  return isAngle ? "expected degrees from 0 to 180 after = in " + text
                 : "expected a number from 0 up after = in " + text;
}

void setLines(LineOptions& lines, const std::vector<std::string>& names) {
  lines.on.fill(false);
  for (const std::string& name : names) {
    if (name == "all") {
      lines.on.fill(true);
    } else {
      lines[*lineFamilyNamed(name)] = true;
    }
  }
}

/// Why what names a scene of curves is no mesh, or empty.
std::string whyNoMesh(const std::string& reference) {
  const bool isScene = reference.starts_with("preset:") || reference.starts_with("glyph:") ||
                       std::filesystem::path(reference).extension() == ".json" ||
                       std::filesystem::path(reference).extension() == ".svg";
  if (!isScene) return {};
  return "a scene of curves, not a mesh; flatland draw makes a picture of it";
}

}  // namespace

void addDirection(CLI::App& command, const std::string& name, Eigen::Vector3d& direction,
                  const std::string& help) {
  command
      .add_option_function<std::string>(
          name, [&direction](const std::string& text) { direction = *directionFrom(text); }, help)
      ->type_name("X,Y,Z")
      ->check(CLI::Validator(
          [](const std::string& text) {
            return directionFrom(text) ? std::string()
                                       : "expected a direction x,y,z that is not 0,0,0, for "
                                         "example 1,0.5,2, found " +
                                             text;
          },
          ""));
}

void addMesh(CLI::App& command, std::string& mesh) {
  command.add_option("mesh", mesh, kMeshHelp)
      ->required()
      ->type_name("MESH")
      ->check(CLI::Validator(
          [](const std::string& name) {
            return name == "-" ? std::string("a mesh is read from a file, not from standard input")
                               : std::string();
          },
          ""));
}

void addCamera(CLI::App& command, Camera& camera) {
  addDirection(command, "--view", camera.towards,
               "From the mesh towards the viewer [0,0,1; across --up if that is along it]");
  addDirection(command, "--up", camera.up, "What appears upward [0,1,0]");
  isNumber(
      command
          .add_option_function<double>(
              "--perspective", [&camera](const double& angle) { camera.perspectiveDeg = angle; },
              "Vertical field of view; without it the view is orthographic")
          ->type_name("DEG"),
      kLeastPerspectiveDeg, kMostPerspectiveDeg);
}

void addFraming(CLI::App& command, Camera& camera) {
  isNumber(
      command.add_option("--zoom", camera.zoom, "How much larger than fitted into the picture [1]")
          ->type_name("Z"),
      1e-6, kMostZoom);
  command
      .add_option_function<std::string>(
          "--centre", [&camera](const std::string& text) { camera.centre = *placeFrom(text); },
          "Seen in the middle: coordinates in which the middle of the mesh is 0,0,0 and its "
          "longest\n"
          "side 2. Then the ball that holds the mesh is fitted, and not its outline")
      ->type_name("X,Y,Z")
      ->check(CLI::Validator(
          [](const std::string& text) {
            return placeFrom(text) ? std::string()
                                   : "expected a place x,y,z, for example 0,0.5,0, found " + text;
          },
          ""));
}

void addFields(CLI::App& command, FieldOptions& fields) {
  command
      .add_option_function<std::string>(
          "--estimator",
          [&fields](const std::string& name) {
            fields.estimator = name == "jet" ? FieldEstimator::JetFit : FieldEstimator::OneRing;
          },
          "How curvature is found: jet, a local polynomial; one-ring, fast and rough [jet]")
      ->type_name("NAME")
      ->check(oneOf("estimator", {"jet", "one-ring"}));
  isNumber(
      command
          .add_option("--scale", fields.scale,
                      "Widens the neighbourhoods that curvature is found on: smooths noise, and\n"
                      "features of that width with it [1]; one-ring takes 10 at most")
          ->type_name("R"),
      1.0, 100.0);
  isWhole(command
              .add_option("--threads", fields.threads,
                          "Threads that estimate curvature [all cores]; drawing takes all")
              ->type_name("N"),
          1, 1024);
}

void addLineFamilies(CLI::App& command, LineOptions& lines) {
  std::string all;
  for (const std::string& name : familyNames()) all += name + ", ";
  std::vector<std::string> names = familyNames();
  names.emplace_back("all");
  command
      .add_option_function<std::vector<std::string>>(
          "--lines", [&lines](const std::vector<std::string>& chosen) { setLines(lines, chosen); },
          "Line families, separated by commas: " + all +
              "or all [contours,apparent-ridges,boundaries]")
      ->type_name("LIST")
      ->delimiter(',')
      ->check(oneOf("line family", names));
  std::string defaults;
  for (const std::string& name : namesWithThreshold()) {
    std::array<char, 32> value{};
    std::snprintf(value.data(), value.size(), "=%g", lines.thresholdOf(*lineFamilyNamed(name)));
    defaults += (defaults.empty() ? "" : ", ") + name + value.data();
  }
  command
      .add_option_function<std::vector<std::string>>(
          "--threshold",
          [&lines](const std::vector<std::string>& thresholds) {
            for (const std::string& text : thresholds) {
              const std::string name = familyOfThreshold(text);
              lines.threshold[static_cast<std::size_t>(*lineFamilyNamed(name))] =
                  *numberFrom(std::string_view(text).substr(name.size() + 1));
            }
          },
          "Draw less or more of a family; may be repeated. Dimensionless: curvature times the\n"
          "size of the mesh; of creases the angle between the triangles in degrees [" +
              defaults + "]")
      ->type_name("FAMILY=V")
      ->allow_extra_args(false)
      ->check(CLI::Validator(whyNotThreshold, ""));
  command.add_flag("--unfiltered", lines.unfiltered,
                   "Every crossing of the defining equations, weak and false ones too");
  command
      .add_option_function<std::string>(
          "--derivative",
          [&lines](const std::string& name) {
            lines.derivative =
                name == "one-ring" ? RidgeDerivative::OneRing : RidgeDerivative::ClosedForm;
          },
          "Apparent ridges: closed-form, or one-ring as the thesis did it [closed-form]")
      ->type_name("NAME")
      ->check(oneOf("derivative", {"closed-form", "one-ring"}));
  isWhole(command.add_option("--isophotes", lines.isophoteLevels, "How many levels of n.w [10]")
              ->type_name("N"),
          1, 1000);
  isWhole(
      command
          .add_option("--topographic", lines.topographicLevels, "How many levels of height [20]")
          ->type_name("N"),
      1, 10000);
  addDirection(command, "--topographic-up", lines.topographicUp, "Which way height grows [0,1,0]");
}

void refuseIdleOptions(const CLI::App& command, const LineOptions& lines) {
  const auto needs = [&lines](const std::string& option, LineFamily family) {
    if (lines[family]) return;
    throw CLI::ValidationError(option, std::string(nameOf(family)) +
                                           " are not among the lines drawn; name them in --lines");
  };
  for (const std::string& text : command.get_option("--threshold")->results())
    needs("--threshold", *lineFamilyNamed(familyOfThreshold(text)));
  if (command.count("--isophotes") > 0) needs("--isophotes", LineFamily::Isophotes);
  for (const char* option : {"--topographic", "--topographic-up"}) {
    if (command.count(option) > 0) needs(option, LineFamily::Topographic);
  }
}

void setUsualLines(LineOptions& lines) {
  lines[LineFamily::OccludingContours] = true;
  lines[LineFamily::ApparentRidges] = true;
  lines[LineFamily::Boundaries] = true;
}

PreparedMesh preparedMesh(const std::string& mesh, const FieldOptions& fields) {
  if (const std::string whyNot = whyNotFields(fields); !whyNot.empty()) {
    throw UsageError("--scale: " + whyNot);
  }
  if (const std::string whyNot = whyNoMesh(mesh); !whyNot.empty()) {
    throw InputError(mesh, "", whyNot);
  }
  PreparedMesh prepared;
  const auto start = std::chrono::steady_clock::now();
  prepared.built = loadNamedMesh(mesh);
  prepared.readMs = millisecondsSince(start);
  std::string mended;
  if (!mesh.starts_with(kSolidReference)) {
    for (const std::string& sentence : prepared.built.report.sentences()) {
      mended += (mended.empty() ? "" : "; ") + sentence;
    }
  }
  if (!mended.empty()) std::fprintf(stderr, "flatland: %s: %s\n", mesh.c_str(), mended.c_str());

  const auto fieldsStart = std::chrono::steady_clock::now();
  FieldOptions options = fields;
  Progress progress;
  options.progress = [&progress](double share) {
    progress.say("curvature: " + std::to_string(std::lround(100.0 * share)) + " %");
  };
  prepared.fields = estimateFields(prepared.built.mesh, options);
  prepared.fieldsMs = millisecondsSince(fieldsStart);
  return prepared;
}

void refuseToOverwrite(const std::string& mesh, const std::string& output) {
  std::error_code notThere;  // then they differ
  if (std::filesystem::equivalent(mesh, output, notThere)) {
    throw UsageError("the output " + output + " is the mesh itself, which would be lost");
  }
}

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

}  // namespace flatland::ui
