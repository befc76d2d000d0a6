// SPDX-License-Identifier: MIT
#include "flatland/io/study_text.h"

#include <algorithm>
#include <cmath>

#include "flatland/io/number_text.h"

namespace flatland {

namespace {

std::string field(const char* key, const std::string& value) {
  return "  \"" + std::string(key) + "\": " + value + ",\n";
}

std::string quartiles(const Quartiles& q) {
  return "{\"lowerQuartile\": " + numberText(q.lower) + ", \"median\": " + numberText(q.median) +
         ", \"upperQuartile\": " + numberText(q.upper) + "}";
}

// The outer bins hold all that lies beyond them.
std::string histogram(const RatioHistogram& shares) {
  std::string text = "[";
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (!(shares[i] > 0.0)) continue;
    text += text.size() == 1 ? "\n    " : ",\n    ";
    text += "{\"from\": " + (i == 0 ? "0" : numberText(ratioBinStart(i))) +
            ", \"to\": " + (i + 1 == shares.size() ? "null" : numberText(ratioBinStart(i + 1))) +
            ", \"share\": " + numberText(shares[i]) + "}";
  }
  return text + (text.size() == 1 ? "]" : "\n  ]");
}

std::string distance(const PooledDistance& d) {
  return "{\"count\": " + std::to_string(d.count) +
         ", \"lowerQuartile\": " + numberText(d.quartiles.lower) +
         ", \"median\": " + numberText(d.quartiles.median) +
         ", \"upperQuartile\": " + numberText(d.quartiles.upper) +
         ", \"percentile90\": " + numberText(d.percentile90) + "}";
}

// The median of a few numbers; of an even count the lower one of the middle two, so that it is one
// of them.
double middleOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::string offsetCsvHeader() {
  return "index,length,ratioPercentile5,ratioLowerQuartile,ratioMedian,ratioUpperQuartile,"
         "ratioPercentile95,medianArcLength,medianParameter,medianUnnormalised,apparentRidges,"
         "extrema,births,deaths,displacementMedian,displacementMax,nearestMedian,nearestMax,"
         "complete\r\n";
}

std::string offsetCsvRow(const CurveOffsets& curve, TermConvention convention) {
  std::string row = std::to_string(curve.index) + ',' + numberText(curve.length);
  const auto ratio = [&row](double value) {
    row += ',' + (std::isfinite(value) ? numberText(value) : "inf");
  };
  const RatioDistribution& own = curve.ratio(convention);
  for (const double value :
       {own.percentile5, own.lowerQuartile, own.median, own.upperQuartile, own.percentile95}) {
    ratio(value);
  }
  for (const RatioDistribution& each : curve.ratios) ratio(each.median);
  for (const int count : {curve.apparentRidges, curve.extrema, curve.births, curve.deaths}) {
    row += ',' + std::to_string(count);
  }
  for (const std::vector<double>* distances : {&curve.displacements, &curve.nearest}) {
    row += distances->empty()
               ? ",,"
               : ',' + numberText(middleOf(*distances)) + ',' +
                     numberText(*std::max_element(distances->begin(), distances->end()));
  }
  return row + (curve.complete ? ",true" : ",false") + "\r\n";
}

std::string offsetSummaryToJson(const OffsetSummary& summary, const OffsetStudyOptions& options) {
  std::string text = "{\n" + field("flatland", "1") + field("study", "\"offset\"");
  text += field("options", "{\"curves\": " + std::to_string(options.curves) +
                               ", \"points\": " + std::to_string(options.points) +
                               ", \"seed\": " + std::to_string(options.seed) + ", \"scale\": " +
                               numberText(options.scale) + ", \"convention\": \"" +
                               std::string(nameOf(options.convention)) + "\"}");
  text += field("curves", std::to_string(summary.curves));
  text += field("incompleteCurves", std::to_string(summary.incomplete));
  const PooledRatio& ratio = summary.ratio(options.convention);
  text += field("medianPerCurve", quartiles(ratio.perCurve));
  text += field("pooledRatio", quartiles(ratio.pooled));
  std::string conventions = "{";
  for (std::size_t c = 0; c < summary.ratios.size(); ++c) {
    const auto convention = static_cast<TermConvention>(c);
    conventions += (c == 0 ? "\n    \"" : ",\n    \"") + std::string(nameOf(convention)) +
                   "\": " + quartiles(summary.ratio(convention).perCurve);
  }
  text += field("conventions", conventions + "\n  }");
  text += field("apparentRidges", std::to_string(summary.apparentRidges));
  text += field("extrema", std::to_string(summary.extrema));
  text += field("births", std::to_string(summary.births));
  text += field("deaths", std::to_string(summary.deaths));
  text += field("displacement", distance(summary.displacement));
  text += field("nearestExtremum", distance(summary.nearest));
  text += field("displacementHistogram", histogram(summary.displacement.histogram));
  text += field("nearestHistogram", histogram(summary.nearest.histogram));
  return text + "  \"histogram\": " + histogram(ratio.histogram) + "\n}\n";
}

}  // namespace flatland
