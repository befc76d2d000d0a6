// SPDX-License-Identifier: GPL-3.0-or-later
// flatland profile, from the outside.
#include <algorithm>
#include <sstream>

#include "tests/support/flatland_program.h"

namespace flatland::test {
namespace {

constexpr const char* kHeader =
    "curve,segment,t,u,x,y,screen,nw,k,kPrime,lambda,feature,offset,perspective,sum,ratio";
enum Column { Curve, Segment, T, U, X, Y, Screen, Nw, K, KPrime, Lambda, Feature, Offset };

std::vector<std::vector<std::string>> rowsOf(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_TRUE(line.ends_with('\r'));
    line.pop_back();
    std::vector<std::string>& row = rows.emplace_back();
    for (std::size_t at = 0; at <= line.size();) {
      const std::size_t comma = std::min(line.find(',', at), line.size());
      row.push_back(line.substr(at, comma - at));
      at = comma + 1;
    }
  }
  return rows;
}

TEST(ProfileCommand, WritesATableWithoutADisplay) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "profile.csv";
  ASSERT_EQ(run({"profile", "preset:thesis", "-o", file}).exitCode, 0);
  const std::string text = contentsOf(file);
  const auto rows = rowsOf(text);
  EXPECT_EQ(text.substr(0, text.find('\r')), kHeader);
  ASSERT_GT(rows.size(), 500u);
  // The default curve: two silhouettes, three extrema of curvature, so six segments.
  EXPECT_EQ(rows.back()[Segment], "5");
  int withoutLambda = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), rows[0].size());
    if (rows[i][Lambda].empty()) {
      ++withoutLambda;
      EXPECT_NEAR(std::stod(rows[i][Nw]), 0.0, 1e-12);
    } else {
      const double k = std::stod(rows[i][K]), nw = std::stod(rows[i][Nw]);
      EXPECT_NEAR(std::stod(rows[i][Lambda]), k * k / (nw * nw), 1e-9 * k * k / (nw * nw) + 1e-25);
    }
  }
  EXPECT_EQ(withoutLambda, 4) << "the end of one segment and the start of the next, twice";
  EXPECT_EQ(run({"profile", "preset:thesis"}).out, text);
}

TEST(ProfileCommand, ViewAndCurveCanBeChosen) {
  const std::string own = run({"profile", "preset:thesis"}).out;
  EXPECT_NE(run({"profile", "preset:thesis", "--view-angle", "40"}).out, own);
  EXPECT_EQ(run({"profile", "preset:thesis", "--curve", "0"}).out, own);
  const ProgramResult none = run({"profile", "preset:thesis", "--curve", "1"});
  EXPECT_EQ(none.exitCode, 2);
  EXPECT_NE(none.err.find("1 curve"), std::string::npos) << none.err;
  EXPECT_EQ(run({"profile", "preset:thesis", "--curve", "-1"}).exitCode, 2);
  EXPECT_EQ(run({"profile", "nowhere.json"}).exitCode, 1);
}

TEST(ProfileCommand, CountsCurvesAndSegmentsFromZero) {
  const std::string scene =
      R"({"flatland": 1, "curves": [{"bezier": [[0, 0], [1, 1], [2, 0]]},
          {"bezier": [[0, 3], [1, 4], [2, 3]]}], "view": {"angleDeg": 90}})";
  const ProgramResult result =
      runProgram(FLATLAND_PROGRAM, {.arguments = {"profile", "-"}, .input = scene});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const auto rows = rowsOf(result.out);
  EXPECT_EQ(rows[1][Curve], "0");
  EXPECT_EQ(rows[1][Segment], "0");
  const auto second =
      std::find_if(rows.begin(), rows.end(), [](const auto& row) { return row[Curve] == "1"; });
  ASSERT_NE(second, rows.end());
  EXPECT_EQ((*second)[Segment], "0");
  EXPECT_EQ((*second)[U], "0");
}

}  // namespace
}  // namespace flatland::test
