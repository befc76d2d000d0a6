// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <thread>

#include "flatland/io/atomic_file.h"
#include "flatland/io/input_error.h"
#include "flatland/io/study_text.h"
#include "ui/cli/command_line.h"

namespace flatland::ui {

namespace {

struct Options {
  OffsetStudyOptions study;
  std::string convention = "arc-length";
  std::string format = "json";
  std::string output;
  bool resume = false;
  int threads = 0;
};

/// Says on a terminal how far a long run is, at most twice a second.
class Progress {
 public:
  explicit Progress(std::int64_t total) : total_(total), shown_(isatty(STDERR_FILENO) != 0) {}
  ~Progress() {
    if (printed_) std::fputs("\r\033[K", stderr);
  }

  void at(std::int64_t done) {
    const auto now = std::chrono::steady_clock::now();
    if (!shown_ || now - last_ < std::chrono::milliseconds(500)) return;
    last_ = now;
    printed_ = true;
    std::fprintf(stderr, "\r%lld of %lld curves", static_cast<long long>(done),
                 static_cast<long long>(total_));
    std::fflush(stderr);
  }

 private:
  std::int64_t total_;
  bool shown_, printed_ = false;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// A per-curve table begun earlier: its complete rows, and where they end in the file.
struct Begun {
  std::int64_t rows = 0;
  std::uintmax_t bytes = 0;
};

// Reads a table and checks that it is of this very study: its first and last rows must be what the
// options give.
Begun readBegun(const Options& options) {
  std::ifstream file(options.output, std::ios::binary);
  if (!file) throw InputError(options.output, "", "cannot be read, so there is nothing to resume");
  const auto fail = [&](std::int64_t row) {
    throw InputError(options.output, "line " + std::to_string(row + 2),
                     "is not of this study: other options, or not a table of flatland");
  };
  Begun begun;
  const std::string header = offsetCsvHeader();
  std::string line, last;
  std::string start(header.size(), '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  if (!header.starts_with(start)) {
    throw InputError(options.output, "line 1", "is not a table of this study");
  }
  if (start != header) return begun;  // interrupted within the header
  begun.bytes = header.size();
  // A line without its end was being written when the run was interrupted.
  while (std::getline(file, line) && !file.eof()) {
    line += '\n';
    if (begun.rows == 0 && line != offsetCsvRow(measureOffsets(options.study, 0))) fail(0);
    begun.bytes += line.size();
    ++begun.rows;
    last = line;
  }
  if (begun.rows > 0 && last != offsetCsvRow(measureOffsets(options.study, begun.rows - 1))) {
    fail(begun.rows - 1);
  }
  return begun;
}

void writeTable(const Options& options, int threads) {
  Begun begun;
  std::ofstream file;
  if (!options.output.empty()) {
    const bool exists = std::filesystem::exists(options.output);
    if (exists && !options.resume) {
      throw InputError(options.output, "",
                       "exists already; --resume continues it, or remove it to start over");
    }
    if (exists) begun = readBegun(options);
    if (exists) std::filesystem::resize_file(options.output, begun.bytes);
    file.open(options.output, std::ios::binary | std::ios::app);
    if (!file) throw InputError(options.output, "", "cannot be written");
  }
  std::ostream& out = options.output.empty() ? std::cout : file;
  if (begun.bytes == 0) out << offsetCsvHeader();
  Progress progress(options.study.curves);
  runOffsetStudy(options.study, begun.rows, threads, [&](const CurveOffsets& curve) {
    out << offsetCsvRow(curve);
    // Now and then onto the disk, so that an interrupted run has lost little.
    if (curve.index % 256 == 0) out.flush();
    progress.at(curve.index);
    return static_cast<bool>(out);
  });
  out.flush();
  if (!out) {
    throw InputError(options.output.empty() ? "standard output" : options.output, "",
                     "cannot be written to the end");
  }
}

std::string summaryText(const Options& options, int threads) {
  OffsetCollector collector;
  Progress progress(options.study.curves);
  runOffsetStudy(options.study, 0, threads, [&](const CurveOffsets& curve) {
    collector.add(curve);
    progress.at(curve.index);
    return true;
  });
  return offsetSummaryToJson(collector.summary(), options.study);
}

int run(Options options) {
  options.study.convention = *termConventionNamed(options.convention);
  if (const auto why = options.study.whyInvalid())
    throw UsageError(*why + " (see flatland study offset --help)");
  if (options.resume && (options.format != "csv" || options.output.empty())) {
    throw UsageError("--resume needs --format csv and -o FILE");
  }
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  const int threads = options.threads > 0 ? options.threads : std::max(1, cores);
  if (options.format == "csv") {
    writeTable(options, threads);
  } else if (options.output.empty()) {
    writeToStandardOutput(summaryText(options, threads));
  } else {
    writeFileAtomically(options.output, summaryText(options, threads));
  }
  return kDone;
}

}  // namespace

void addStudyCommand(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App& study = *app.add_subcommand("study", "Measure over many random curves.");
  study.require_subcommand(1);
  CLI::App& command = *study.add_subcommand(
      "offset",
      "How large is the offset term of the apparent-ridge equation against the feature term? "
      "Random\n"
      "Bezier curves in a square, seen along one side; |offset| / |feature| is weighted by arc "
      "length.\n"
      "JSON gives all curves together, CSV one row a curve. The same seed gives the same curves\n"
      "whatever the number of threads.");
  command.add_option("--curves", options->study.curves, "How many curves [20000]")->type_name("N");
  command.add_option("--points", options->study.points, "Control points per curve, 3 to 9 [5]")
      ->type_name("N");
  command.add_option("--seed", options->study.seed, "Which random curves [1]")->type_name("S");
  command
      .add_option("--scale", options->study.scale, "Side of the square, for example in pixels [1]")
      ->type_name("PX");
  command
      .add_option(
          "--convention", options->convention,
          "Units of the terms [arc-length]: arc-length as derived; parameter, with the\n"
          "derivative of k by the curve's parameter; unnormalised, with the normal left as long\n"
          "as the derivative too. Only the first does not depend on --scale")
      ->type_name("NAME")
      ->check(CLI::IsMember({"arc-length", "parameter", "unnormalised"}).description(""));
  command.add_option("--format", options->format, "json or csv [json]")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"json", "csv"}).description(""));
  command.add_option("-o,--output", options->output, "Write to this file, not to standard output")
      ->type_name("FILE");
  command.add_flag("--resume", options->resume, "Continue an interrupted CSV file");
  command.add_option("--threads", options->threads, "Threads [all cores]")
      ->type_name("N")
      ->check(CLI::Range(1, 1024).description(""));
  command.footer(
      "Examples:\n"
      "  flatland study offset --curves 20000 --points 5 --seed 1\n"
      "  flatland study offset --scale 100 --convention unnormalised   the thesis's 1/100,000\n"
      "  flatland study offset --curves 1000000 --format csv -o study.csv\n"
      "  flatland study offset --curves 1000000 --format csv -o study.csv --resume\n");
  command.final_callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace flatland::ui
