// SPDX-License-Identifier: MIT
#include "core3d/io/convergence_text.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "flatland/io/number_text.h"

namespace flatland {

namespace {

// "-" for what does not exist.
std::string cell(const char* format, double value, bool exists) {
  if (!exists || !std::isfinite(value)) return "-";
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string inQuotes(std::string_view name) { return "\"" + std::string(name) + "\""; }

}  // namespace

std::string convergenceTable(const std::vector<ConvergenceSeries>& all) {
  std::string table =
      "estimator derivative   cells      edge  pieces  median/edge  95%/edge   stray  missed\n";
  std::array<char, 160> line;
  for (const ConvergenceSeries& series : all) {
    const std::string estimator(nameOf(series.estimator)), derivative(nameOf(series.derivative));
    for (const ConvergenceRow& row : series.rows) {
      const bool found = row.pieces > 0;
      std::snprintf(line.data(), line.size(), "%-9s %-11s %7d %9.4g %7zu %12s %9s %7s %7.4f\n",
                    estimator.c_str(), derivative.c_str(), row.cells, row.edge, row.pieces,
                    cell("%.4g", row.medianEdges, found).c_str(),
                    cell("%.4g", row.percentile95Edges, found).c_str(),
                    cell("%.4f", row.strayShare, found).c_str(), row.missedShare);
      table += line.data();
    }
    if (series.order) {
      std::snprintf(line.data(), line.size(), "%-9s %-11s   order %.2f\n", estimator.c_str(),
                    derivative.c_str(), *series.order);
    } else {
      std::snprintf(line.data(), line.size(), "%-9s %-11s   no order\n", estimator.c_str(),
                    derivative.c_str());
    }
    table += line.data();
  }
  return table;
}

std::string convergenceCsv(const std::vector<ConvergenceSeries>& all) {
  std::string csv =
      "estimator,derivative,cells,edge,pieces,medianEdges,percentile95Edges,strayShare,"
      "missedShare\r\n";
  for (const ConvergenceSeries& series : all) {
    for (const ConvergenceRow& row : series.rows) {
      csv += std::string(nameOf(series.estimator)) + "," + std::string(nameOf(series.derivative)) +
             "," + std::to_string(row.cells) + "," + numberText(row.edge) + "," +
             std::to_string(row.pieces) + "," + numberText(row.medianEdges, "") + "," +
             numberText(row.percentile95Edges, "") + "," + numberText(row.strayShare) + "," +
             numberText(row.missedShare) + "\r\n";
    }
  }
  return csv;
}

std::string convergenceJson(const std::vector<ConvergenceSeries>& all,
                            const ConvergenceOptions& options) {
  std::string text = "{\n  \"case\": " + inQuotes(nameOf(options.subject)) +
                     ",\n  \"irregular\": " + (options.irregular ? "true" : "false") +
                     ",\n  \"seed\": " + std::to_string(options.seed) +
                     ",\n  \"threshold\": " + numberText(options.threshold) + ",\n  \"series\": [";
  for (std::size_t i = 0; i < all.size(); ++i) {
    const ConvergenceSeries& series = all[i];
    text += (i == 0 ? "\n    {" : ",\n    {") + std::string("\"estimator\": ") +
            inQuotes(nameOf(series.estimator)) +
            ", \"derivative\": " + inQuotes(nameOf(series.derivative)) +
            ", \"order\": " + numberText(series.order, "null") + ", \"rows\": [";
    for (std::size_t k = 0; k < series.rows.size(); ++k) {
      const ConvergenceRow& row = series.rows[k];
      text += (k == 0 ? "\n      {" : ",\n      {") + std::string("\"cells\": ") +
              std::to_string(row.cells) + ", \"edge\": " + numberText(row.edge) +
              ", \"pieces\": " + std::to_string(row.pieces) +
              ", \"medianEdges\": " + numberText(row.medianEdges, "null") +
              ", \"percentile95Edges\": " + numberText(row.percentile95Edges, "null") +
              ", \"strayShare\": " + numberText(row.strayShare) +
              ", \"missedShare\": " + numberText(row.missedShare) + "}";
    }
    text += "\n    ]}";
  }
  return text + "\n  ]\n}\n";
}

}  // namespace flatland
