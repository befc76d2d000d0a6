// SPDX-License-Identifier: GPL-3.0-or-later
// flatland derivation, from the outside.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/run_program.h"

namespace flatland {
namespace {

using nlohmann::json;
using test::ProgramResult;

ProgramResult run(const std::vector<std::string>& arguments, const std::string& input = {}) {
  return test::runProgram(FLATLAND_PROGRAM, {.arguments = arguments, .input = input});
}

TEST(DerivationCommand, JsonHasBothVariantsOfEveryMisprint) {
  const ProgramResult result =
      run({"derivation", "preset:thesis", "--t", "0.3", "--format", "json"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const json steps = json::parse(result.out).at("steps");
  ASSERT_EQ(steps.size(), 18u);
  std::string misprinted;
  for (const json& step : steps) {
    EXPECT_LT(step.at("corrected").at("residual").get<double>(), 1e-14) << step.at("id");
    EXPECT_EQ(step.at("corrected").at("left").at("values").size(),
              step.at("corrected").at("right").at("values").size());
    if (!step.contains("printed")) continue;
    misprinted += step.at("id").get<std::string>() + " ";
    EXPECT_GT(step.at("printed").at("apart").get<double>(), 0.01) << step.at("id");
    EXPECT_EQ(step.at("stepSizes").at("rows").at(0).size(), 3u);
  }
  EXPECT_EQ(misprinted, "3.10 3.11 3.12 3.13 footnote 4.7 4.8 ");
  // An independent number: on the parabola y = x^2 seen along y, lambda = 4/(1 + 4 x^2)^2, so
  // dlambda/dx = -64 x / (1 + 4 x^2)^3, here at x = 1/2 (t = 3/4).
  const std::string parabola =
      R"({"flatland": 1, "curves": [{"bezier": [[-1, 1], [0, -1], [1, 1]]}],
          "view": {"angleDeg": 90}})";
  const ProgramResult other = run({"derivation", "-", "--t", "0.75", "--format", "json"}, parabola);
  ASSERT_EQ(other.exitCode, 0) << other.err;
  const json twelve = json::parse(other.out).at("steps").at(11);
  EXPECT_EQ(twelve.at("id"), "3.12");
  EXPECT_NEAR(twelve.at("corrected").at("right").at("values").at(0).get<double>(), 0.5 * -4.0,
              1e-13);
}

TEST(DerivationCommand, AnIdentityAgainstZeroIsNotCalledApart) {
  const ProgramResult result = run({"derivation", "preset:thesis", "--t", "0.3"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const std::string first = result.out.substr(0, result.out.find("(3.2)"));
  EXPECT_EQ(first.find("apart"), std::string::npos) << first;
  EXPECT_NE(first.find("zero but for rounding"), std::string::npos) << first;
}

TEST(DerivationCommand, CsvHasARowForEachVariant) {
  const ProgramResult result =
      run({"derivation", "preset:loop", "--t", "0.6", "--format", "csv", "--view-angle", "10"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  std::istringstream lines(result.out);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "step,variant,answer,left,right,residual,apart,bestDifference\r");
  int rows = 0;
  while (std::getline(lines, line)) {
    ++rows;
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 7) << line;
  }
  EXPECT_EQ(rows, 18 + 7);
}

TEST(DerivationCommand, TextSaysWhyThereIsNoAnswer) {
  const std::string parabola =
      R"({"flatland": 1, "curves": [{"bezier": [[-1, 1], [0, -1], [1, 1]]}], "view": {"angleDeg": 0}})";
  const ProgramResult result = run({"derivation", "-", "--t", "0.5"}, parabola);
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_NE(result.out.find("no answer:  silhouette"), std::string::npos);
  EXPECT_EQ(result.out.find("nan"), std::string::npos);
}

TEST(DerivationCommand, RefusesPlacesThatAreNotThere) {
  EXPECT_EQ(run({"derivation", "preset:thesis", "--t", "1.5"}).exitCode, 2);
  EXPECT_EQ(run({"derivation", "preset:thesis", "--curve", "1"}).exitCode, 2);
  EXPECT_EQ(run({"derivation", "preset:thesis", "--t", "nan"}).exitCode, 2);
  EXPECT_EQ(run({"derivation", "preset:nothing"}).exitCode, 1);
}

}  // namespace
}  // namespace flatland
