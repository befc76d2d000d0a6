// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <limits>
#include <thread>

#include "flatland/io/input_error.h"
#include "flatland/io/offset_table.h"
#include "flatland/io/study_text.h"
#include "ui/cli/command_line.h"
#include "ui/cli/number_check.h"
#include "ui/cli/progress.h"
#include "ui/cli/result_options.h"

namespace flatland::ui {

namespace {

struct Options {
  OffsetStudyOptions study;
  std::string convention = "arc-length";
  ResultOptions result;
  bool resume = false;
  int threads = 0;
};

std::string soFar(std::int64_t done, const Options& options) {
  return std::to_string(done) + " of " + std::to_string(options.study.curves) + " curves";
}

void writeTable(const Options& options, int threads) {
  Progress progress;
  if (options.result.output.empty()) {
    std::cout << offsetCsvHeader();
    runOffsetStudy(options.study, 0, threads, [&](const CurveOffsets& curve) {
      std::cout << offsetCsvRow(curve, options.study.convention);
      progress.say(soFar(curve.index, options));
      return static_cast<bool>(std::cout);
    });
    std::cout.flush();
    if (!std::cout) throw InputError("standard output", "", "cannot be written to the end");
    return;
  }
  OffsetTable table(
      options.result.output, options.study,
      options.resume ? OffsetTable::Existing::Continue : OffsetTable::Existing::Refuse);
  runOffsetStudy(options.study, table.rows(), threads, [&](const CurveOffsets& curve) {
    table.add(curve);
    progress.say(soFar(curve.index, options));
    return true;
  });
  table.close();
}

std::string summaryText(const Options& options, int threads) {
  OffsetCollector collector(options.study.convention);
  Progress progress;
  runOffsetStudy(options.study, 0, threads, [&](const CurveOffsets& curve) {
    collector.add(curve);
    progress.say(soFar(curve.index, options));
    return true;
  });
  return offsetSummaryToJson(collector.summary(), options.study);
}

int run(Options options) {
  options.study.convention = *termConventionNamed(options.convention);
  if (const auto why = options.study.whyInvalid())
    throw UsageError(*why + " (see flatland study offset --help)");
  const bool csv = wantsCsv(options.result);
  if (options.resume && (!csv || options.result.output.empty())) {
    throw UsageError("--resume needs a table: -o FILE.csv, or --format csv and -o FILE");
  }
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  const int threads = options.threads > 0 ? options.threads : std::max(1, cores);
  if (csv) {
    writeTable(options, threads);
  } else {
    writeResult(options.result, summaryText(options, threads));
  }
  return kDone;
}

}  // namespace

void addStudyCommand(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App& study = *app.add_subcommand(
      "study", "Measure: the offset term over many random curves, the limits at silhouettes.");
  study.require_subcommand(1);
  study.footer(
      "Examples:\n"
      "  flatland study offset --curves 20000 --points 5 --seed 1\n"
      "  flatland study limits preset:thesis --curve 0 --t 0.4\n"
      "  flatland study offset --help              what each can do\n");
  CLI::App& command = *study.add_subcommand(
      "offset",
      "How large is the offset term of the apparent-ridge equation against the feature term? "
      "Random\n"
      "Bezier curves in a square, seen along one side; |offset| / |feature| is weighted by arc "
      "length.\n"
      "JSON gives all curves together, CSV one row a curve. The same seed gives the same curves\n"
      "whatever the number of threads.");
  isWhole(command.add_option("--curves", options->study.curves, "How many curves [20000]")
              ->type_name("N"),
          1, std::numeric_limits<std::int64_t>::max());
  isWhole(command.add_option("--points", options->study.points, "Control points per curve [5]")
              ->type_name("N"),
          3, 9);
  isWhole(
      command.add_option("--seed", options->study.seed, "Which random curves [1]")->type_name("S"),
      0);
  isNumber(command
               .add_option("--scale", options->study.scale,
                           "Side of the square, for example in pixels [1]")
               ->type_name("PX"));
  command
      .add_option(
          "--convention", options->convention,
          "Units of the terms [arc-length]: arc-length as derived; parameter, with the\n"
          "derivative of k by the curve's parameter; unnormalised, with the normal left as long\n"
          "as the derivative too. Only the first does not depend on --scale")
      ->type_name("NAME")
      ->check(CLI::IsMember({"arc-length", "parameter", "unnormalised"}).description(""));
  addJsonOrCsv(command, options->result);
  addOutput(command, options->result);
  command.add_flag("--resume", options->resume, "Continue an interrupted CSV file");
  isWhole(command.add_option("--threads", options->threads, "Threads [all cores]")->type_name("N"),
          1, 1024);
  command.footer(
      "Examples:\n"
      "  flatland study offset --curves 20000 --points 5 --seed 1\n"
      "  flatland study offset --scale 100 --convention unnormalised   the thesis's 1/100,000\n"
      "  flatland study offset --curves 1000000 -o study.csv\n"
      "  flatland study offset --curves 1000000 -o study.csv --resume\n");
  command.final_callback([options, &action] { action = [options] { return run(*options); }; });
  addLimitsCommand(study, action);
}

}  // namespace flatland::ui
