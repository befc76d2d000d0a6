// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "flatland/curve/bezier.h"

namespace flatland {

/// In which units the two terms of the apparent-ridge equation are compared.
enum class TermConvention {
  ArcLength,  ///< as derived: unit normal, derivative of k by arc length. |offset|/|feature| has no
              ///< dimension and does not depend on the curve's size
  Parameter,  ///< derivative of k by the curve's parameter: the ratio shrinks with 1 / size
  Unnormalised,  ///< also the normal left at the length of the derivative: shrinks with 1 / size^2
};

/// "arc-length", "parameter", "unnormalised".
std::string_view nameOf(TermConvention convention);
std::optional<TermConvention> termConventionNamed(std::string_view name);

struct OffsetStudyOptions {
  std::int64_t curves = 20000;
  int points = 5;  ///< control points per curve, 3 to 9
  std::uint64_t seed = 1;
  double scale = 1.0;  ///< side of the square the control points are drawn from, e.g. pixels
  TermConvention convention = TermConvention::ArcLength;

  /// Why the options make no sense, for a person; empty if they do.
  std::optional<std::string> whyInvalid() const;
};

/// Ratios |offset|/|feature| are counted in bins of a tenth of a decade, 1e-12 to 1e12, with the
/// rest beyond either end in the outer bins.
inline constexpr int kRatioBinsPerDecade = 10;
inline constexpr int kRatioDecades = 12;
inline constexpr int kRatioBins = 2 * kRatioDecades * kRatioBinsPerDecade;

inline constexpr int kTermConventions = 3;

/// By what factor the ratio of the same curve changes when it is drawn `scale` times as large: 1,
/// 1 / scale, 1 / scale^2. The terms are products of a power of the size, so this is exact but for
/// rounding.
double scaleFactor(TermConvention convention, double scale);

/// A number counted in the bins of a ratio: shares that sum to 1, or to 0 if there was nothing to
/// count.
using RatioHistogram = std::array<double, kRatioBins>;

/// The bin of a value >= 0.
std::size_t ratioBin(double value);
/// The lower end of a bin, and of the one after the last.
double ratioBinStart(std::size_t bin);

/// How |offset|/|feature| is distributed over one curve, weighted by arc length.
struct RatioDistribution {
  double percentile5, lowerQuartile, median, upperQuartile, percentile95;
  std::array<float, kRatioBins> histogram;  ///< share of the arc length in each bin; sums to 1
};

/// What one curve says. Lengths in units of the curve's own arc length unless stated.
struct CurveOffsets {
  std::int64_t index;                                      ///< of the curve in the study
  double length;                                           ///< arc length, in the units of `scale`
  std::array<RatioDistribution, kTermConventions> ratios;  ///< under each convention
  int apparentRidges;
  int extrema;  ///< ridges and valleys
  int births;   ///< apparent ridges that have no extremum of |k| of their own
  int deaths;   ///< ridges and valleys that are no apparent ridge
  /// For each apparent ridge with a partner, the distance on the screen to it, relative to the
  /// length.
  std::vector<double> displacements;
  /// For each apparent ridge of a curve with a ridge or valley, the distance on the screen to the
  /// one that is nearest there, partner or not.
  std::vector<double> nearest;
  bool complete;  ///< all marks of the curve were certified

  const RatioDistribution& ratio(TermConvention convention) const {
    return ratios[static_cast<std::size_t>(convention)];
  }
};

/// The curve number `index` of a study: control points uniform in the square [0, scale]^2, from a
/// counter-based generator, so it depends on seed, points, scale and index alone. Seen along +y.
Bezier studyCurve(const OffsetStudyOptions& options, std::int64_t index);

/// Measures one curve. An apparent ridge and a ridge or valley are partners if each is the other's
/// nearest along the arc and no inflection or silhouette lies between. The weighted distribution is
/// sampled at 512 points of equal parameter step; its quartiles are good to about 1 %.
CurveOffsets measureOffsets(const OffsetStudyOptions& options, std::int64_t index);

/// A curve to look at: one that has much of what is counted in a bin.
struct OffsetExample {
  std::int64_t index = -1;  ///< of the curve; -1: none
  double share = 0.0;       ///< of the curve's arc length in the bin
};

/// Quartiles of a number, and where the rest lies.
struct Quartiles {
  double lower = 0.0, median = 0.0, upper = 0.0;
};

/// The ratio over all curves, under one convention.
struct PooledRatio {
  Quartiles perCurve;          ///< over the curves, of each curve's median
  Quartiles pooled;            ///< every curve weighs the same, its points by arc length; to 12 %
  RatioHistogram histogram{};  ///< pooled
};

/// How far something is from something else on the screen, over the curve's length.
struct PooledDistance {
  std::int64_t count = 0;
  Quartiles quartiles;
  double percentile90 = 0.0;
  RatioHistogram histogram{};
};

/// All curves together.
struct OffsetSummary {
  std::int64_t curves = 0;
  std::int64_t incomplete = 0;  ///< curves with an unresolved interval
  std::int64_t apparentRidges = 0, extrema = 0, births = 0, deaths = 0;
  std::array<PooledRatio, kTermConventions> ratios;
  PooledDistance displacement;  ///< apparent ridges to their partners
  PooledDistance nearest;       ///< apparent ridges to the nearest ridge or valley
  /// For each bin of the chosen convention's histogram, and of the displacements'.
  std::array<OffsetExample, kRatioBins> ratioExamples, displacementExamples;

  const PooledRatio& ratio(TermConvention convention) const {
    return ratios[static_cast<std::size_t>(convention)];
  }
};

/// Collects curves into a summary; the result depends on the order of add() only in the last bits,
/// and runOffsetStudy keeps the order.
class OffsetCollector {
 public:
  /// `convention`: of the bins that get examples.
  explicit OffsetCollector(TermConvention convention = TermConvention::ArcLength)
      : convention_(convention) {}

  void add(const CurveOffsets& curve);
  OffsetSummary summary() const;

 private:
  TermConvention convention_;
  OffsetSummary totals_;
  std::array<std::vector<float>, kTermConventions> medians_;
  std::vector<float> displacements_, nearest_;
};

/// Runs curves [first, options.curves) on all cores and hands each to `row` on the calling thread,
/// in order of index whatever the number of threads. `row` returns false to stop. Returns the
/// number of curves handed over. Memory does not grow with the number of curves. Precondition:
/// options.whyInvalid() is empty, threads >= 1.
std::int64_t runOffsetStudy(const OffsetStudyOptions& options, std::int64_t first, int threads,
                            const std::function<bool(const CurveOffsets&)>& row);

}  // namespace flatland
