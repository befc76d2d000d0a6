// SPDX-License-Identifier: GPL-3.0-or-later
// The offset study: units, determinism, and the order of magnitude it exists to report.
#include "flatland/study/offset_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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
  const Quartiles medians = summary.ratio(TermConvention::ArcLength).perCurve;
  EXPECT_NEAR(medians.median, 0.21, 0.02);
  EXPECT_NEAR(medians.lower, 0.09, 0.01);
  EXPECT_NEAR(medians.upper, 0.495, 0.05);
  EXPECT_EQ(summary.incomplete, 0);
  const auto sum = [](const RatioHistogram& shares) {
    return std::accumulate(shares.begin(), shares.end(), 0.0);
  };
  for (const PooledRatio& ratio : summary.ratios) EXPECT_NEAR(sum(ratio.histogram), 1.0, 1e-4);
  EXPECT_NEAR(sum(summary.displacement.histogram), 1.0, 1e-9);
  EXPECT_NEAR(sum(summary.nearest.histogram), 1.0, 1e-9);
}

TEST(OffsetStudy, ArcLengthRatioDoesNotDependOnScaleTheOthersDo) {
  const auto medianAt = [](TermConvention convention, double scale) {
    return summaryOf({.curves = 300, .scale = scale}).ratio(convention).perCurve.median;
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
  const double median = summaryOf({.curves = 2000, .scale = 100.0})
                            .ratio(TermConvention::Unnormalised)
                            .perCurve.median;
  // As printed once; 20,000 curves give 1.475e-5. A factor of 2 lost in any of the units would
  // show.
  EXPECT_NEAR(median, 1.638e-5, 0.02e-5);
}

// What the Study panel relies on when its scale slider moves: a study at another scale is the same
// study with its ratios multiplied, curve by curve, also where the scale is no power of two.
TEST(OffsetStudy, AnotherScaleIsTheSameStudyTimesAFactor) {
  constexpr double kRounding = 1e-9;  // the terms cancel digits near inflections
  for (const double scale : {3.0, 100.0, 0.037, 1e5}) {
    for (std::int64_t i = 0; i < 60; ++i) {
      const CurveOffsets unit = measureOffsets({.seed = 11}, i);
      const CurveOffsets scaled = measureOffsets({.seed = 11, .scale = scale}, i);
      EXPECT_NEAR(scaled.length / unit.length / scale, 1.0, kRounding);
      for (std::size_t c = 0; c < unit.ratios.size(); ++c) {
        const double factor = scaleFactor(static_cast<TermConvention>(c), scale);
        const auto near = [&](double a, double b) {
          if (!(b > 0.0) || !std::isfinite(b)) return;
          EXPECT_NEAR(a / (b * factor), 1.0, kRounding) << i;
        };
        near(scaled.ratios[c].lowerQuartile, unit.ratios[c].lowerQuartile);
        near(scaled.ratios[c].median, unit.ratios[c].median);
        near(scaled.ratios[c].upperQuartile, unit.ratios[c].upperQuartile);
      }
    }
  }
}

// An example of a bin has what the bin counts.
TEST(OffsetStudy, ExamplesHaveWhatTheirBinCounts) {
  const OffsetStudyOptions options{.curves = 300, .convention = TermConvention::Parameter};
  OffsetCollector collector(options.convention);
  runOffsetStudy(options, 0, 2, [&](const CurveOffsets& curve) {
    collector.add(curve);
    return true;
  });
  const OffsetSummary summary = collector.summary();
  int examples = 0;
  for (std::size_t bin = 0; bin < kRatioBins; ++bin) {
    const OffsetExample& example = summary.ratioExamples[bin];
    EXPECT_EQ(example.index >= 0, summary.ratio(options.convention).histogram[bin] > 0.0);
    if (example.index >= 0) {
      ++examples;
      const CurveOffsets curve = measureOffsets(options, example.index);
      EXPECT_EQ(curve.ratio(options.convention).histogram[bin], static_cast<float>(example.share));
    }
    const OffsetExample& moved = summary.displacementExamples[bin];
    if (moved.index < 0) continue;
    const CurveOffsets curve = measureOffsets(options, moved.index);
    EXPECT_TRUE(std::any_of(curve.displacements.begin(), curve.displacements.end(),
                            [bin](double d) { return ratioBin(d) == bin; }));
  }
  EXPECT_GT(examples, 30);
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
    EXPECT_EQ(one[i].ratios[0].median, three[i].ratios[0].median);
    EXPECT_EQ(one[i].displacements, three[i].displacements);
  }
  for (std::size_t i = 0; i < tail.size(); ++i) {
    EXPECT_EQ(tail[i].ratios[0].median, one[777 + i].ratios[0].median);
  }
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
    for (const RatioDistribution& ratio : curve.ratios) {
      EXPECT_LE(ratio.percentile5, ratio.lowerQuartile);
      EXPECT_LE(ratio.lowerQuartile, ratio.median);
      EXPECT_LE(ratio.median, ratio.upperQuartile);
      EXPECT_LE(ratio.upperQuartile, ratio.percentile95);
    }
    EXPECT_EQ(curve.nearest.size(),
              curve.extrema > 0 ? static_cast<std::size_t>(curve.apparentRidges) : 0u);
    // The nearest extremum is no farther than the partner.
    if (!curve.displacements.empty()) {
      EXPECT_LE(*std::min_element(curve.nearest.begin(), curve.nearest.end()),
                *std::min_element(curve.displacements.begin(), curve.displacements.end()));
    }
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
  const auto median = [](double scale, std::int64_t curve) {
    return measureOffsets({.scale = scale}, curve).ratio(TermConvention::ArcLength).median;
  };
  EXPECT_GT(median(1e50, 0), 0.0);
  EXPECT_EQ(median(0x1p160, 3), median(1.0, 3));
}

}  // namespace
