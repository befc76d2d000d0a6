// SPDX-License-Identifier: MIT
#include "core3d/io/bridge_text.h"

#include <array>
#include <cstdio>

#include "flatland/io/number_text.h"

namespace flatland {

namespace {

template <typename... Values>
std::string printed(const char* format, Values... values) {
  std::array<char, 240> line;
  std::snprintf(line.data(), line.size(), format, values...);
  return line.data();
}

BridgeLimit limitAt(std::size_t index) { return static_cast<BridgeLimit>(index); }

/// "3  silhouette-near  n.w is ...", a line for each limit that applies to something.
template <typename Number>
std::string limitLines(const std::array<Number, kBridgeLimitCount>& by, const char* format) {
  std::string text;
  for (std::size_t i = 1; i < kBridgeLimitCount; ++i) {
    if (!(by[i] > Number{})) continue;
    text += printed(format, by[i]) + "  " + std::string(nameOf(limitAt(i))) + ": " +
            std::string(reasonOf(limitAt(i))) + "\n";
  }
  return text.empty() ? "    none\n" : text;
}

std::string headOfCsv(const std::string& first) {
  std::string head = first + ",cells,edge";
  for (const char* family : {"ridge", "contour"}) {
    for (const char* column : {"Pieces", "MedianEdges", "Percentile95Edges", "StrayShare", "Lines",
                               "BackMedianEdges", "BackPercentile95Edges", "Coverage"}) {
      head += "," + std::string(family) + column;
    }
  }
  for (std::size_t i = 1; i < kBridgeLimitCount; ++i) {
    head += ",ridgeLines:" + std::string(nameOf(limitAt(i)));
  }
  return head + "\r\n";
}

std::string csvRow(const BridgeRow& row) {
  std::string text = "," + std::to_string(row.cells) + "," + numberText(row.edge);
  for (const LineAgreement* a : {&row.ridges, &row.contours}) {
    text += "," + std::to_string(a->pieces) + "," + numberText(a->medianEdges, "") + "," +
            numberText(a->percentile95Edges, "") + "," + numberText(a->strayShare) + "," +
            std::to_string(a->lines) + "," + numberText(a->backMedianEdges, "") + "," +
            numberText(a->backPercentile95Edges, "") + "," + numberText(a->coverage, "");
  }
  for (std::size_t i = 1; i < kBridgeLimitCount; ++i) {
    text += "," + std::to_string(row.ridges.linesBy[i]);
  }
  return text + "\r\n";
}

std::string tableRow(const char* family, const BridgeRow& row, const LineAgreement& a) {
  return printed("  %-8s %7d %9.4g %6zu %6zu %9.4g %9.4g %9.4g %9.4g %9.4g\n", family, row.cells,
                 row.edge, a.lines, a.pieces, a.medianEdges, a.percentile95Edges, a.backMedianEdges,
                 a.backPercentile95Edges, a.coverage);
}

}  // namespace

std::string bridgeTable(const BridgePrediction& prediction, const std::vector<BridgeSeries>& all) {
  std::string table = "predicted from flatland, seen from " +
                      printed("%.6g", prediction.flat().view->angleDeg) + " degrees:\n";
  for (const PredictedLine& line : prediction.lines()) {
    const BridgeLimit limit = prediction.limitOf(line, {});
    table +=
        printed("  %-14s t %-10.6g x %-10.6g y %-10.6g n.w %-9.4g %s\n",
                std::string(nameOf(line.kind)).c_str(), line.t, line.mark.x(), line.mark.y(),
                line.facing, limit == BridgeLimit::None ? "" : std::string(nameOf(limit)).c_str());
  }
  table +=
      "distances in edges, of what no limit applies to\n"
      "  lines      cells      edge  lines pieces    median       95%      back  back 95%   "
      "covered\n";
  for (const BridgeSeries& series : all) {
    table += std::string(nameOf(series.estimator)) + " curvature, " +
             std::string(nameOf(series.derivative)) + " derivative" +
             (series.order ? printed(", order %.2f", *series.order) : "") + "\n";
    for (const BridgeRow& row : series.rows) table += tableRow("ridges", row, row.ridges);
    // Contours do not depend on the derivative.
    if (series.derivative != all[0].derivative) continue;
    for (const BridgeRow& row : series.rows) table += tableRow("contours", row, row.contours);
  }
  if (!all.empty() && !all[0].rows.empty()) {
    const LineAgreement& finest = all[0].rows.back().ridges;
    table += "predicted ridges that are not held against the finest mesh, and why:\n" +
             limitLines(finest.linesBy, "%8zu");
    table += "length of ridges found there but not held (" + std::string(nameOf(all[0].estimator)) +
             ", " + std::string(nameOf(all[0].derivative)) + "), in edges:\n" +
             limitLines(finest.lengthBy, "%8.1f");
  }
  return table;
}

std::string bridgeTable(const BridgeTrials& trials, const BridgeTrialOptions& options) {
  std::string table =
      printed("%zu extrusions of random curves from random directions, seed %llu, %d cells, ",
              trials.trials.size(), static_cast<unsigned long long>(options.seed), options.cells) +
      std::string(nameOf(options.estimator)) + " curvature, " +
      std::string(nameOf(options.derivative)) + " derivative\n";
  const std::size_t held = trials.linesBy[0];
  table +=
      printed("median distance %.4g edges, back %.4g; below 0.1 on %zu of %zu curves, not on\n",
              trials.medianEdges, trials.backMedianEdges, trials.belowTenth, trials.trials.size());
  for (std::size_t i = 0; i < trials.trials.size(); ++i) {
    const BridgeTrial& trial = trials.trials[i];
    if (trial.row.ridges.medianEdges < BridgeTrials::kNearEdges) continue;
    table += printed("%8zu  %.4g edges, %.4g covered", i, trial.row.ridges.medianEdges,
                     trial.row.ridges.coverage);
    table += trial.ahead.limit == BridgeLimit::None
                 ? printed("; no limit is near, the gentlest bend's radius is %.3g edges\n",
                           trial.gentlestEdges)
                 : printed("; at edges %.2g times as long ", trial.ahead.coarser) +
                       std::string(nameOf(trial.ahead.limit)) + "\n";
  }
  table += printed("%zu lines that have to be there, %.4g of their length covered\n", held,
                   trials.coverage);
  table += printed(
      "not held: predicted lines of all %zu curves drawn (those without a line are not counted "
      "above)\n",
      trials.drawn);
  return table + limitLines(trials.linesBy, "%8zu");
}

std::string bridgeCsv(const std::vector<BridgeSeries>& all) {
  std::string csv = headOfCsv("estimator,derivative");
  for (const BridgeSeries& series : all) {
    for (const BridgeRow& row : series.rows) {
      csv += std::string(nameOf(series.estimator)) + "," + std::string(nameOf(series.derivative)) +
             csvRow(row);
    }
  }
  return csv;
}

std::string bridgeCsv(const BridgeTrials& trials) {
  std::string csv = headOfCsv("towardsX,towardsY,towardsZ");
  for (const BridgeTrial& trial : trials.trials) {
    csv += numberText(trial.towards.x()) + "," + numberText(trial.towards.y()) + "," +
           numberText(trial.towards.z()) + csvRow(trial.row);
  }
  return csv;
}

}  // namespace flatland
