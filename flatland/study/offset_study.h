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

/// What one curve says. Lengths in units of the curve's own arc length unless stated.
struct CurveOffsets {
  std::int64_t index;                           ///< of the curve in the study
  double length;                                ///< arc length, in the units of `scale`
  double lowerQuartile, median, upperQuartile;  ///< of |offset|/|feature|, weighted by arc length
  int apparentRidges;
  int extrema;  ///< ridges and valleys
  int births;   ///< apparent ridges that have no extremum of |k| of their own
  int deaths;   ///< ridges and valleys that are no apparent ridge
  /// For each apparent ridge with a partner, the distance on the screen to it, relative to the
  /// length.
  std::vector<double> displacements;
  bool complete;                            ///< all marks of the curve were certified
  std::array<float, kRatioBins> histogram;  ///< share of the arc length in each bin; sums to 1
};

/// The curve number `index` of a study: control points uniform in the square [0, scale]^2, from a
/// counter-based generator, so it depends on seed, points, scale and index alone. Seen along +y.
Bezier studyCurve(const OffsetStudyOptions& options, std::int64_t index);

/// Measures one curve. An apparent ridge and a ridge or valley are partners if each is the other's
/// nearest along the arc and no inflection or silhouette lies between. The weighted distribution is
/// sampled at 512 points of equal parameter step; its quartiles are good to about 1 %.
CurveOffsets measureOffsets(const OffsetStudyOptions& options, std::int64_t index);

/// All curves together.
struct OffsetSummary {
  std::int64_t curves = 0;
  std::int64_t incomplete = 0;  ///< curves with an unresolved interval
  std::int64_t apparentRidges = 0, extrema = 0, births = 0, deaths = 0;
  /// Quartiles over the curves of each curve's median ratio.
  double medianLowerQuartile = 0, medianMedian = 0, medianUpperQuartile = 0;
  /// Quartiles of the pooled ratio: every curve weighs the same, its points by arc length.
  double pooledLowerQuartile = 0, pooledMedian = 0, pooledUpperQuartile = 0;
  double displacementMedian = 0, displacement90 = 0;  ///< screen distance over curve length
  std::array<double, kRatioBins> histogram{};         ///< pooled; sums to 1
};

/// Collects curves into a summary; the result depends on the order of add() only in the last bits,
/// and runOffsetStudy keeps the order.
class OffsetCollector {
 public:
  void add(const CurveOffsets& curve);
  OffsetSummary summary() const;

 private:
  OffsetSummary totals_;
  std::vector<float> medians_;
  std::vector<float> displacements_;
};

/// Runs curves [first, options.curves) on all cores and hands each to `row` on the calling thread,
/// in order of index whatever the number of threads. `row` returns false to stop. Returns the
/// number of curves handed over. Memory does not grow with the number of curves. Precondition:
/// options.whyInvalid() is empty, threads >= 1.
std::int64_t runOffsetStudy(const OffsetStudyOptions& options, std::int64_t first, int threads,
                            const std::function<bool(const CurveOffsets&)>& row);

}  // namespace flatland
