// SPDX-License-Identifier: GPL-3.0-or-later
// flatland sweep and flatland study, from the outside.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"
#include "tests/support/xml_check.h"

namespace flatland {
namespace {

using nlohmann::json;
using test::contentsOf;
using test::ProgramResult;
using test::TemporaryFolder;

ProgramResult run(const std::vector<std::string>& arguments) {
  return test::runProgram(FLATLAND_PROGRAM, {.arguments = arguments,
                                             .environment = {{"DISPLAY", std::nullopt},
                                                             {"QT_QPA_PLATFORM", "nonsense"}}});
}

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
  EXPECT_EQ(test::readXml(svg).error, std::nullopt);
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

}  // namespace
}  // namespace flatland
