// SPDX-License-Identifier: GPL-3.0-or-later
#include "flatland/io/features_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

namespace flatland {
namespace {

using nlohmann::json;

/// One mark of values that differ, one with as little as a mark may have, and of the rest one each.
FeatureSet handMade() {
  FeatureSet set;
  set.marks = {{.kind = MarkKind::ApparentRidge,
                .curve = 2,
                .t = 0.1,
                .u = 1.0 / 3.0,
                .point = {1.5, -2.25},
                .screen = 2.25,
                .visible = true,
                .lambda = 4.0,
                .feature = -0.5,
                .offset = 0.25,
                .perspective = 0.125,
                .residual = 1e-16},
               {.kind = MarkKind::Corner,
                .curve = 0,
                .t = 1.0,
                .u = 2.0,
                .point = {-0.0, 5e-324},
                .screen = std::nullopt,
                .visible = false,
                .lambda = std::numeric_limits<double>::infinity(),
                .feature = std::nullopt,
                .offset = std::nullopt,
                .perspective = -0.0,
                .residual = 0.0,
                .turnDeg = -90.0}};
  set.unresolved = {{MarkKind::Flat, 1, 0.25, 0.5, "two \"near\" roots\n"}};
  set.degenerate = {{Degenerate::What::Point, 0, 0.0, 1.0},
                    {Degenerate::What::Straight, 1, 1.0, 2.0},
                    {Degenerate::What::StraightEndOn, 2, 2.0, 3.0},
                    {Degenerate::What::ConstantCurvature, 3, 0.0, 1.0}};
  set.searches = {{0, true, 0, 0, 0.0}, {3, false, 17, 32, 2.5e-14}};
  return set;
}

TEST(FeaturesJson, HasEveryFieldUnderItsName) {
  const json read = json::parse(featuresToJson(handMade(), {30.5, 4.0}));
  const json expected = {
      {"flatland", 1},
      {"view", {{"angleDeg", 30.5}, {"distance", 4}}},
      {"marks",
       {{{"kind", "apparent-ridge"},
         {"curve", 2},
         {"t", 0.1},
         {"u", 1.0 / 3.0},
         {"point", {1.5, -2.25}},
         {"screen", 2.25},
         {"visible", true},
         {"lambda", 4},
         {"feature", -0.5},
         {"offset", 0.25},
         {"perspective", 0.125},
         {"residual", 1e-16},
         {"turnDeg", nullptr}},
        {{"kind", "corner"},
         {"curve", 0},
         {"t", 1},
         {"u", 2},
         {"point", {0, 5e-324}},
         {"screen", nullptr},
         {"visible", false},
         {"lambda", nullptr},
         {"feature", nullptr},
         {"offset", nullptr},
         {"perspective", 0},
         {"residual", 0},
         {"turnDeg", -90}}}},
      {"complete", false},
      {"unresolved",
       {{{"kind", "flat"}, {"curve", 1}, {"t", {0.25, 0.5}}, {"reason", "two \"near\" roots\n"}}}},
      {"degenerate",
       {{{"what", "point"}, {"curve", 0}, {"t", {0, 1}}},
        {{"what", "straight"}, {"curve", 1}, {"t", {1, 2}}},
        {{"what", "straight-end-on"}, {"curve", 2}, {"t", {2, 3}}},
        {{"what", "constant-curvature"}, {"curve", 3}, {"t", {0, 1}}}}},
      {"search",
       {{{"curve", 0}, {"method", "bernstein"}},
        {{"curve", 3},
         {"method", "chebyshev"},
         {"pieces", 17},
         {"degree", 32},
         {"errorBound", 2.5e-14}}}}};
  EXPECT_EQ(read, expected) << read.dump(1);
}

TEST(FeaturesJson, OrthographicAndEmpty) {
  EXPECT_EQ(featuresToJson({}, {}),
            "{\n  \"flatland\": 1,\n  \"view\": {\"angleDeg\": 0, \"distance\": null},\n"
            "  \"marks\": [],\n  \"complete\": true,\n  \"unresolved\": [],\n"
            "  \"degenerate\": [],\n  \"search\": []\n}\n");
}

TEST(FeaturesJson, NumbersReadBackToTheSameBits) {
  const FeatureSet found = findFeatures(defaultScene());
  ASSERT_FALSE(found.marks.empty());
  const json read = json::parse(featuresToJson(found, defaultScene().view));
  ASSERT_EQ(read["marks"].size(), found.marks.size());
  for (std::size_t i = 0; i < found.marks.size(); ++i) {
    EXPECT_EQ(read["marks"][i]["t"].get<double>(), found.marks[i].t);
    EXPECT_EQ(read["marks"][i]["u"].get<double>(), found.marks[i].u);
    EXPECT_EQ(read["marks"][i]["point"][1].get<double>(), found.marks[i].point.y());
    EXPECT_EQ(read["marks"][i]["kind"], std::string(nameOf(found.marks[i].kind)));
  }
}

TEST(FeaturesCsv, HasOneRowForAMarkAndEmptyFieldsForNothing) {
  EXPECT_EQ(
      featuresToCsv(handMade()),
      "kind,curve,t,u,x,y,screen,visible,lambda,feature,offset,perspective,residual,turnDeg\r\n"
      "apparent-ridge,2,0.1,0.3333333333333333,1.5,-2.25,2.25,true,4,-0.5,0.25,0.125,1e-16,\r\n"
      "corner,0,1,2,0,5e-324,,false,,,,0,0,-90\r\n");
}

}  // namespace
}  // namespace flatland
