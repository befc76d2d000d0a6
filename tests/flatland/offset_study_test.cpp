// SPDX-License-Identifier: GPL-3.0-or-later
// The offset study: units, determinism, and the order of magnitude it exists to report.
#include "flatland/study/offset_study.h"

#include <gtest/gtest.h>

#include <numeric>

namespace {

using namespace flatland;

OffsetSummary summaryOf(const OffsetStudyOptions& options, int threads = 2) {
  OffsetCollector collector;
  runOffsetStudy(options, 0, threads, [&](const CurveOffsets& curve) {
    collector.add(curve);
    return true;
  });
  return collector.summary();
}

TEST(OffsetStudy, OffsetIsAFifthOfTheFeatureTermNotAHundredThousandth) {
  const OffsetSummary summary = summaryOf({.curves = 4000});
  // 20,000 curves give 0.2102 (0.0901, 0.4956); the spread of 4,000 is about 3 %.
  EXPECT_NEAR(summary.medianMedian, 0.21, 0.02);
  EXPECT_NEAR(summary.medianLowerQuartile, 0.09, 0.01);
  EXPECT_NEAR(summary.medianUpperQuartile, 0.495, 0.05);
  EXPECT_EQ(summary.incomplete, 0);
  EXPECT_NEAR(std::accumulate(summary.histogram.begin(), summary.histogram.end(), 0.0), 1.0, 1e-4);
}

TEST(OffsetStudy, ArcLengthRatioDoesNotDependOnScaleTheOthersDo) {
  const auto medianAt = [](TermConvention convention, double scale) {
    return summaryOf({.curves = 300, .scale = scale, .convention = convention}).medianMedian;
  };
  const float kFloatRounding = 1e-6f;  // medians are kept as floats
  EXPECT_NEAR(medianAt(TermConvention::ArcLength, 128.0) / medianAt(TermConvention::ArcLength, 1.0),
              1.0, kFloatRounding);
  EXPECT_NEAR(medianAt(TermConvention::Parameter, 128.0) / medianAt(TermConvention::Parameter, 1.0),
              1.0 / 128.0, kFloatRounding / 128.0);
  EXPECT_NEAR(
      medianAt(TermConvention::Unnormalised, 128.0) / medianAt(TermConvention::Unnormalised, 1.0),
      1.0 / 16384.0, kFloatRounding / 16384.0);
}

TEST(OffsetStudy, MixedUnitsOnAHundredPixelCurveMakeTheThesisFigure) {
  const double median =
      summaryOf({.curves = 2000, .scale = 100.0, .convention = TermConvention::Unnormalised})
          .medianMedian;
  // As printed once; 20,000 curves give 1.475e-5. A factor of 2 lost in any of the units would
  // show.
  EXPECT_NEAR(median, 1.638e-5, 0.02e-5);
}

TEST(OffsetStudy, RowsAreTheSameForAnyNumberOfThreadsAndAnyStart) {
  const OffsetStudyOptions options{.curves = 1000, .seed = 42};
  const auto rows = [&](std::int64_t first, int threads) {
    std::vector<CurveOffsets> all;
    EXPECT_EQ(runOffsetStudy(options, first, threads,
                             [&](const CurveOffsets& curve) {
                               all.push_back(curve);
                               return true;
                             }),
              options.curves - first);
    return all;
  };
  const auto one = rows(0, 1), three = rows(0, 3), tail = rows(777, 2);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].index, static_cast<std::int64_t>(i));
    EXPECT_EQ(one[i].median, three[i].median);
    EXPECT_EQ(one[i].displacements, three[i].displacements);
  }
  for (std::size_t i = 0; i < tail.size(); ++i) EXPECT_EQ(tail[i].median, one[777 + i].median);
}

TEST(OffsetStudy, AnotherSeedMakesOtherCurves) {
  EXPECT_NE(studyCurve({.seed = 1}, 0).points[0], studyCurve({.seed = 2}, 0).points[0]);
  EXPECT_NE(studyCurve({.seed = 1}, 0).points[0], studyCurve({.seed = 1}, 1).points[0]);
}

TEST(OffsetStudy, StopsWhenTheReaderHasEnough) {
  int rows = 0;
  EXPECT_EQ(
      runOffsetStudy({.curves = 1000000}, 0, 2, [&](const CurveOffsets&) { return ++rows < 10; }),
      10);
}

TEST(OffsetStudy, BookkeepingAddsUp) {
  const OffsetStudyOptions options{.curves = 300};
  int withPartner = 0;
  for (std::int64_t i = 0; i < options.curves; ++i) {
    const CurveOffsets curve = measureOffsets(options, i);
    const int partners = static_cast<int>(curve.displacements.size());
    EXPECT_EQ(curve.apparentRidges, partners + curve.births);
    EXPECT_EQ(curve.extrema, partners + curve.deaths);
    EXPECT_LE(curve.lowerQuartile, curve.median);
    EXPECT_LE(curve.median, curve.upperQuartile);
    withPartner += partners;
  }
  EXPECT_GT(withPartner, 0);
}

TEST(OffsetStudy, RefusesOptionsThatMakeNoSense) {
  EXPECT_FALSE(OffsetStudyOptions{}.whyInvalid());
  EXPECT_TRUE(OffsetStudyOptions{.curves = 0}.whyInvalid());
  EXPECT_TRUE(OffsetStudyOptions{.points = 2}.whyInvalid());
  EXPECT_TRUE(OffsetStudyOptions{.points = 10}.whyInvalid());
  EXPECT_TRUE(OffsetStudyOptions{.scale = -1.0}.whyInvalid());
  EXPECT_TRUE(OffsetStudyOptions{.scale = 1e51}.whyInvalid());
  EXPECT_FALSE(OffsetStudyOptions{.scale = 1e50}.whyInvalid());
  EXPECT_GT(measureOffsets({.scale = 1e50}, 0).median, 0.0);
  EXPECT_EQ(measureOffsets({.scale = 0x1p160}, 3).median, measureOffsets({.scale = 1.0}, 3).median);
}

}  // namespace
