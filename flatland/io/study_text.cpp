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

std::string quartiles(double lower, double median, double upper) {
  return "{\"lowerQuartile\": " + numberText(lower) + ", \"median\": " + numberText(median) +
         ", \"upperQuartile\": " + numberText(upper) + "}";
}

std::string binEdge(std::size_t bin) {
  return numberText(std::pow(10.0, static_cast<double>(bin) / kRatioBinsPerDecade - kRatioDecades));
}

}  // namespace

std::string offsetCsvHeader() {
  return "index,length,ratioLowerQuartile,ratioMedian,ratioUpperQuartile,apparentRidges,extrema,"
         "births,deaths,displacementMax,complete\r\n";
}

std::string offsetCsvRow(const CurveOffsets& curve) {
  const std::string largest =
      curve.displacements.empty()
          ? ""
          : numberText(*std::max_element(curve.displacements.begin(), curve.displacements.end()));
  const auto ratio = [](double value) { return std::isfinite(value) ? numberText(value) : "inf"; };
  return std::to_string(curve.index) + ',' + numberText(curve.length) + ',' +
         ratio(curve.lowerQuartile) + ',' + ratio(curve.median) + ',' + ratio(curve.upperQuartile) +
         ',' + std::to_string(curve.apparentRidges) + ',' + std::to_string(curve.extrema) + ',' +
         std::to_string(curve.births) + ',' + std::to_string(curve.deaths) + ',' + largest + ',' +
         (curve.complete ? "true" : "false") + "\r\n";
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
  text += field("medianPerCurve", quartiles(summary.medianLowerQuartile, summary.medianMedian,
                                            summary.medianUpperQuartile));
  text += field("pooledRatio", quartiles(summary.pooledLowerQuartile, summary.pooledMedian,
                                         summary.pooledUpperQuartile));
  text += field("apparentRidges", std::to_string(summary.apparentRidges));
  text += field("extrema", std::to_string(summary.extrema));
  text += field("births", std::to_string(summary.births));
  text += field("deaths", std::to_string(summary.deaths));
  text +=
      field("displacement", "{\"median\": " + numberText(summary.displacementMedian) +
                                ", \"percentile90\": " + numberText(summary.displacement90) + "}");
  text += "  \"histogram\": [";
  bool first = true;
  for (std::size_t i = 0; i < summary.histogram.size(); ++i) {
    if (!(summary.histogram[i] > 0.0)) continue;
    text += first ? "\n    " : ",\n    ";
    first = false;
    // The outer bins hold all that lies beyond them.
    text += "{\"from\": " + (i == 0 ? "0" : binEdge(i)) +
            ", \"to\": " + (i + 1 == summary.histogram.size() ? "null" : binEdge(i + 1)) +
            ", \"share\": " + numberText(summary.histogram[i]) + "}";
  }
  return text + (first ? "]" : "\n  ]") + "\n}\n";
}

}  // namespace flatland
