// SPDX-License-Identifier: GPL-3.0-or-later
// flatland sweep and flatland study, from the outside.
#include <csignal>
#include <filesystem>
#include <fstream>

#include "tests/support/flatland_program.h"
#include "tests/support/xml_check.h"

namespace flatland::test {
namespace {

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

TEST(SweepCommand, WritesATableOfLinesBranchesAndEvents) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "sweep.csv";
  const ProgramResult result = run({"sweep", "preset:thesis", "-o", file});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const std::string table = contentsOf(file);
  EXPECT_EQ(table.rfind("what,kind,curve,branch,angleDeg,t,u\r\n", 0), 0u);
  // The default curve: two ridges, a valley, two inflections; they do not move.
  EXPECT_EQ(countOf(table, "\nline,ridge,"), 2u);
  EXPECT_EQ(countOf(table, "\nline,valley,"), 1u);
  EXPECT_EQ(countOf(table, "\nline,inflection,"), 2u);
  EXPECT_EQ(countOf(table, "\nfold,"), 2u);
  EXPECT_EQ(countOf(table, "\nmeets-silhouette,"), 2u);
  EXPECT_EQ(countOf(table, "\nhead-on,"), 3u);
}

TEST(SweepCommand, DrawsAWellFormedPicture) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "sweep.svg";
  const ProgramResult result = run({"sweep", "preset:thesis", "-o", file, "--size", "800x500"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const std::string svg = contentsOf(file);
  EXPECT_EQ(readXml(svg).error, std::nullopt);
  for (const char* id :
       {"branches-silhouette", "branches-apparent-ridge", "lines-ridge", "events-fold"}) {
    EXPECT_NE(svg.find("id=\"" + std::string(id) + "\""), std::string::npos) << id;
  }
}

TEST(SweepCommand, RefusesAnUnknownFormat) {
  const ProgramResult result = run({"sweep", "preset:thesis", "-o", "sweep.doc"});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_NE(result.err.find(".csv, .svg, .pdf, .png or .tex"), std::string::npos) << result.err;
}

TEST(StudyCommand, SummaryHasTheOrderOfMagnitude) {
  const ProgramResult result = run({"study", "offset", "--curves", "1000", "--threads", "2"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const json summary = json::parse(result.out);
  EXPECT_EQ(summary["curves"], 1000);
  EXPECT_EQ(summary["options"]["convention"], "arc-length");
  EXPECT_NEAR(summary["medianPerCurve"]["median"].get<double>(), 0.21, 0.04);
  double share = 0.0;
  for (const json& bin : summary["histogram"]) share += bin["share"].get<double>();
  EXPECT_NEAR(share, 1.0, 1e-4);
  for (const char* key : {"displacementHistogram", "nearestHistogram"}) {
    share = 0.0;
    for (const json& bin : summary[key]) share += bin["share"].get<double>();
    EXPECT_NEAR(share, 1.0, 1e-9) << key;
  }
  EXPECT_EQ(summary["nearestExtremum"]["count"], summary["apparentRidges"]);
  EXPECT_EQ(summary["displacement"]["count"].get<int>(),
            summary["apparentRidges"].get<int>() - summary["births"].get<int>());
  EXPECT_EQ(summary["conventions"]["arc-length"], summary["medianPerCurve"]);
}

// 0.21 as derived; with the derivative by t and the normal left as long as the derivative, on a
// curve of 100 pixels, a hundred-thousandth.
TEST(StudyCommand, SaysWhatMixingUnitsDoes) {
  const auto conventions = [](const char* scale) {
    const ProgramResult result = run({"study", "offset", "--curves", "400", "--scale", scale});
    return json::parse(result.out)["conventions"];
  };
  const json unit = conventions("1"), pixels = conventions("100");
  const auto median = [](const json& of, const char* name) {
    return of[name]["median"].get<double>();
  };
  EXPECT_NEAR(median(pixels, "arc-length") / median(unit, "arc-length"), 1.0, 1e-6);
  EXPECT_NEAR(median(pixels, "parameter") / median(unit, "parameter"), 1e-2, 1e-8);
  EXPECT_NEAR(median(pixels, "unnormalised") / median(unit, "unnormalised"), 1e-4, 1e-10);
  EXPECT_LT(median(pixels, "unnormalised"), 3e-5);
}

TEST(StudyCommand, TheSuffixSaysTheFormat) {
  const TemporaryFolder folder;
  const std::string csv = folder.path() / "study.csv", other = folder.path() / "study.txt";
  ASSERT_EQ(run({"study", "offset", "--curves", "3", "-o", csv}).exitCode, 0);
  EXPECT_EQ(contentsOf(csv).rfind("index,length,", 0), 0u);
  ASSERT_EQ(run({"study", "offset", "--curves", "3", "-o", other}).exitCode, 0);
  EXPECT_EQ(json::parse(contentsOf(other))["curves"], 3);
  // Said, it is as said.
  const std::string said = folder.path() / "said.csv";
  ASSERT_EQ(run({"study", "offset", "--curves", "3", "--format", "json", "-o", said}).exitCode, 0);
  EXPECT_EQ(json::parse(contentsOf(said))["curves"], 3);
  EXPECT_EQ(run({"study", "offset", "--curves", "5", "-o", csv, "--resume"}).exitCode, 0);
  EXPECT_EQ(countOf(contentsOf(csv), "\n"), 6u);
}

std::vector<std::string> table(const std::string& file, const std::string& curves,
                               const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"study",    "offset", "--format", "csv",
                                     "--curves", curves,   "-o",       file};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(StudyCommand, ResumedTableEqualsOneWrittenAtOnce) {
  const TemporaryFolder folder;
  const std::string whole = folder.path() / "whole.csv", parts = folder.path() / "parts.csv";
  ASSERT_EQ(run(table(whole, "300")).exitCode, 0);
  const std::string all = contentsOf(whole);
  EXPECT_EQ(countOf(all, "\n"), 301u);
  // Cut at the start, within the header, and within a row.
  for (const std::size_t kept :
       {std::size_t{0}, std::size_t{10}, all.size() / 3, all.size() - 1, all.size()}) {
    std::ofstream(parts, std::ios::binary) << all.substr(0, kept);
    const ProgramResult result = run(table(parts, "300", {"--resume"}));
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(contentsOf(parts), all) << "kept " << kept;
  }
}

// A run that is killed in the middle has written whole rows, which the next one keeps.
TEST(StudyCommand, AKilledRunLosesNothingThatWasWritten) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "killed.csv", whole = folder.path() / "whole.csv";
  const auto sizeOf = [&] {
    std::error_code error;
    const auto size = std::filesystem::file_size(file, error);
    return error ? std::uintmax_t{0} : size;
  };
  const ProgramResult killed = runProgram(
      FLATLAND_PROGRAM,
      {.arguments = table(file, "1000000"), .killWhen = [&] { return sizeOf() > 50000; }});
  EXPECT_EQ(killed.exitCode, -SIGKILL);
  const std::string kept = contentsOf(file);
  const std::size_t rows = countOf(kept, "\n") - 1;
  ASSERT_GT(rows, 100u);
  ASSERT_LT(rows, 100000u);
  const std::string more = std::to_string(rows + 100);
  ASSERT_EQ(run(table(file, more, {"--resume"})).exitCode, 0);
  ASSERT_EQ(run(table(whole, more)).exitCode, 0);
  const std::string all = contentsOf(whole);
  EXPECT_TRUE(contentsOf(file) == all);
  EXPECT_TRUE(all.starts_with(kept.substr(0, kept.rfind('\n') + 1)));
}

TEST(StudyCommand, NeverOverwritesNorContinuesAnotherStudy) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "study.csv";
  ASSERT_EQ(run(table(file, "20")).exitCode, 0);
  const std::string before = contentsOf(file);
  EXPECT_EQ(run(table(file, "20")).exitCode, 1);
  EXPECT_EQ(run(table(file, "40", {"--resume", "--seed", "2"})).exitCode, 1);
  EXPECT_EQ(contentsOf(file), before);
}

TEST(StudyCommand, RefusesOptionsThatMakeNoSense) {
  EXPECT_EQ(run({"study", "offset", "--points", "2"}).exitCode, 2);
  EXPECT_EQ(run({"study", "offset", "--scale", "-1"}).exitCode, 2);
  EXPECT_EQ(run({"study", "offset", "--resume"}).exitCode, 2);
  EXPECT_EQ(run({"study"}).exitCode, 2);
}

TEST(LimitsCommand, TellsPredictedAndFittedOrders) {
  const ProgramResult result = run({"study", "limits", "preset:thesis", "--t", "0.4"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const json limits = json::parse(result.out)["experiments"];
  ASSERT_EQ(limits.size(), 3u);
  for (const json& experiment : limits) {
    for (const json& law : experiment["laws"]) {
      EXPECT_EQ(law["values"].size(), experiment["x"].size());
      EXPECT_NEAR(law["fittedOrder"].get<double>(), law["predictedOrder"].get<double>(), 1e-3)
          << experiment["experiment"] << ' ' << law["quantity"];
    }
  }
  EXPECT_EQ(limits[1]["case"], "ordinary-silhouette");
}

TEST(LimitsCommand, WritesATableAndLeavesOutWhatTheCurveHasNot) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "limits.csv";
  // A circle has no inflection to slide into.
  ASSERT_EQ(run({"study", "limits", "preset:circle", "--t", "0.4", "-o", file}).exitCode, 0);
  const std::string table = contentsOf(file);
  EXPECT_EQ(table.rfind("experiment,case,quantity,x,value\r\n", 0), 0u);
  EXPECT_GT(countOf(table, "\nturn,fixed-point,lambda,"), 50u);
  EXPECT_GT(countOf(table, "\nwalk,ordinary-silhouette,ratio,"), 50u);
  EXPECT_EQ(countOf(table, "slide"), 0u);
}

TEST(LimitsCommand, RefusesPlacesThatDoNotExist) {
  EXPECT_EQ(run({"study", "limits", "preset:thesis", "--curve", "1"}).exitCode, 2);
  EXPECT_EQ(run({"study", "limits", "preset:thesis", "--t", "1.5"}).exitCode, 2);
  EXPECT_EQ(run({"study", "limits"}).exitCode, 2);
}

}  // namespace
}  // namespace flatland::test
