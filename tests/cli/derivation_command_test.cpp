// SPDX-License-Identifier: GPL-3.0-or-later
// flatland derivation, from the outside.
#include <sstream>

#include "tests/support/flatland_program.h"

namespace flatland::test {
namespace {

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

// --- Of a surface -------------------------------------------------------------------------------

TEST(DerivationCommand, OfASurfaceHasTheMatricesAndEveryStep) {
  const std::vector<std::string> place{"derivation", "solid:torus:60", "--point",  "1.3,0.1,0.2",
                                       "--view",     "1,0.4,1",        "--format", "json"};
  for (const bool perspective : {false, true}) {
    std::vector<std::string> arguments = place;
    if (perspective) arguments.insert(arguments.end(), {"--perspective", "40"});
    const ProgramResult result = run(arguments);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const json root = json::parse(result.out);
    EXPECT_EQ(root.at("place").at("distance").is_null(), !perspective);
    const json& m = root.at("matrices");
    // From the fields of a mesh, so float; the torus has k = 1/b, cos/(a + b cos) in units of b.
    const double size = root.at("place").at("size").get<double>();
    const double k1 = m.at("K").at(0).at(0).get<double>();
    EXPECT_NEAR(k1, size / 0.4, 0.02 * k1);
    const auto at = [&m](const char* name, int i, int j) {
      return m.at(name).at(i).at(j).get<double>();
    };
    EXPECT_NEAR(at("P", 0, 0) * at("P", 1, 1) - at("P", 0, 1) * at("P", 1, 0),
                m.at("nw").get<double>(), 1e-12);
    EXPECT_NEAR(at("QtQ", 0, 0) + at("QtQ", 1, 1),
                m.at("lambda").get<double>() + m.at("otherLambda").get<double>(),
                1e-9 * m.at("lambda").get<double>());
    std::string misprinted;
    ASSERT_EQ(root.at("steps").size(), 20u);
    for (const json& step : root.at("steps")) {
      EXPECT_EQ(step.at("answer"), "evaluated");
      EXPECT_LT(step.at("corrected").at("residual").get<double>(), 1e-14) << step.at("id");
      if (!step.contains("printed")) continue;
      misprinted += step.at("id").get<std::string>() + " ";
      EXPECT_GT(step.at("printed").at("apart").get<double>(), 0.01);
    }
    EXPECT_EQ(misprinted, "footnote 4.7 4.8 ");
    const json& terms = root.at("steps").at(perspective ? 19 : 18);
    EXPECT_NEAR(terms.at("corrected").at("right").at("values").at(0).get<double>(),
                m.at("feature").get<double>() + m.at("offset").get<double>() +
                    m.at("perspective").get<double>(),
                1e-9 * std::abs(m.at("lambda").get<double>()));
    EXPECT_EQ(m.at("perspective").get<double>() != 0.0, perspective);
  }
}

TEST(DerivationCommand, OfASurfaceAsTextAndCsv) {
  const ProgramResult text = run({"derivation", "solid:bumpy-sphere:20", "--vertex", "100"});
  ASSERT_EQ(text.exitCode, 0) << text.err;
  for (const char* part : {"Vertex 100 of the file", "Q^T Q", "(4.3) View-dependent curvature",
                           "as printed:", "(perspective)"}) {
    EXPECT_NE(text.out.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(text.out.find("nan"), std::string::npos);
  const ProgramResult csv =
      run({"derivation", "solid:bumpy-sphere:20", "--vertex", "100", "--format", "csv"});
  ASSERT_EQ(csv.exitCode, 0) << csv.err;
  EXPECT_EQ(std::count(csv.out.begin(), csv.out.end(), '\n'), 1 + 20 + 3);
}

TEST(DerivationCommand, TellsWhatBecomesOfATriangle) {
  const auto lessonOf = [](int face) {
    const ProgramResult result =
        run({"derivation", "solid:sine-sheet:40", "--triangle", std::to_string(face), "--view",
             "0.5,0,0.866", "--threshold", "0", "--format", "json"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return json::parse(result.out);
  };
  // One row of faces across the ridges: some of them hold a line, some a minimum.
  std::string verdicts;
  for (int face = 1600; face < 1680; ++face) {
    const json lesson = lessonOf(face);
    verdicts += lesson.at("verdict").get<std::string>() + " ";
    ASSERT_EQ(lesson.at("corners").size(), 3u);
    for (const json& piece : lesson.at("pieces")) {
      bool all = true;
      for (const json& test : piece.at("tests")) all = all && test.at("passes").get<bool>();
      EXPECT_EQ(piece.at("isMaximum").get<bool>(), all);
    }
    if (lesson.at("verdict") == "kept") {
      EXPECT_EQ(lesson.at("pieces").at(0).at("isMaximum"), true);
      EXPECT_EQ(lesson.at("drawn"), true);
    }
  }
  for (const char* verdict : {"kept", "minimum", "no crossing"}) {
    EXPECT_NE(verdicts.find(verdict), std::string::npos) << verdicts;
  }
  const ProgramResult text =
      run({"derivation", "solid:sine-sheet:40", "--triangle", "1600", "--view", "0.5,0,0.866"});
  ASSERT_EQ(text.exitCode, 0) << text.err;
  EXPECT_NE(text.out.find("Verdict: "), std::string::npos);
}

TEST(DerivationCommand, RefusesWhatDoesNotFitTheSurface) {
  using Words = std::vector<std::string>;
  for (const Words& words :
       {Words{"solid:torus:20"}, Words{"solid:torus:20", "--vertex", "1", "--triangle", "1"},
        Words{"solid:torus:20", "--vertex", "100000"},
        Words{"solid:torus:20", "--triangle", "100000"},
        Words{"solid:torus:20", "--vertex", "1", "--t", "0.3"},
        Words{"preset:thesis", "--vertex", "1"},
        Words{"solid:torus:20", "--triangle", "1", "--format", "csv"},
        Words{"solid:torus:20", "--point", "1,2"}}) {
    Words arguments{"derivation"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exitCode, 2) << words.back();
    EXPECT_FALSE(result.err.empty());
    EXPECT_TRUE(result.out.empty());
  }
  EXPECT_EQ(run({"derivation", "nothing-there.ply", "--vertex", "1"}).exitCode, 1);
}

}  // namespace
}  // namespace flatland::test
