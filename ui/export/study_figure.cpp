// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/study_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "ui/export/figure_builder.h"

namespace flatland::ui {

namespace {

constexpr double kLeftPx = 14.0, kRightPx = 14.0, kTopPx = 34.0, kBottomPx = 44.0;
constexpr double kTitleRowPx = 14.0;
constexpr double kDecadePx = 40.0;  // room for the number of a decade
constexpr double kThesisRatio = 1e-5;

struct Decades {
  double low, high;
};

// Fixed, so that histograms can be compared as they grow and slide.
Decades decadesOf(StudyDiagram diagram) {
  switch (diagram) {
    case StudyDiagram::Ratio:
      return {-6.0, 4.0};
    case StudyDiagram::Displacement:
      return {-7.0, 0.0};
    case StudyDiagram::Conventions:
      break;
  }
  return {-9.0, 5.0};
}

double xOf(double decade, const StudyFigureOptions& options) {
  const Decades d = decadesOf(options.diagram);
  return kLeftPx + (decade - d.low) / (d.high - d.low) * (options.width - kLeftPx - kRightPx);
}

double decadeOf(double bin) { return bin / kRatioBinsPerDecade - kRatioDecades; }

/// A stretch of the figure in which one histogram stands.
struct Row {
  double top, bottom;
};

class Builder : FigureBuilder {
 public:
  explicit Builder(const StudyFigureOptions& options)
      : FigureBuilder(options.width, options.height, options.palette, options.textPx,
                      options.words),
        options_(options),
        bars_(styleOf(MarkKind::Inflection, options.palette).colour),
        strong_(styleOf(MarkKind::ApparentRidge, options.palette).colour) {}

  Figure build(const OffsetSummary& summary, const OffsetStudyOptions& study) {
    const double room = options_.width - kLeftPx - kRightPx;
    const std::vector<std::string> title = wrapped(titleOf(study), textPx_, room);
    const double bottom =
        options_.height - kBottomPx - kTitleRowPx * static_cast<double>(title.size() - 1);
    addAxis({kTopPx, bottom});
    addTitle(title);
    switch (options_.diagram) {
      case StudyDiagram::Ratio: {
        const PooledRatio& ratio = summary.ratio(study.convention);
        addHistogram("ratio", {kTopPx, bottom}, ratio.histogram, 1.0);
        addQuartiles({kTopPx, bottom}, ratio.perCurve, 1.0, 16.0,
                     say("medians of %1 curves", {std::to_string(summary.curves)}));
        break;
      }
      case StudyDiagram::Displacement:
        addHistogram("displacement", {kTopPx, bottom}, summary.displacement.histogram, 1.0);
        addQuartiles({kTopPx, bottom}, summary.displacement.quartiles, 1.0, 16.0,
                     say("%1 pairs", {std::to_string(summary.displacement.count)}));
        break;
      case StudyDiagram::Conventions:
        addConventions(summary, study, bottom);
        break;
    }
    return std::move(figure_);
  }

 private:
  void addAxis(const Row& row) {
    FigureGroup& axis = group("axis", "axis");
    const Decades d = decadesOf(options_.diagram);
    const Stroke faint = gridStroke();
    const double px = (xOf(1.0, options_) - xOf(0.0, options_));
    const int every = std::max(1, static_cast<int>(std::ceil(kDecadePx / px)));
    for (int decade = static_cast<int>(d.low); decade <= static_cast<int>(d.high); ++decade) {
      const double x = xOf(decade, options_);
      addLine(axis, {x, row.top}, {x, row.bottom}, faint);
      if (decade % every != 0) continue;
      addText(axis, {x, row.bottom + 13.0}, shortNumber(std::pow(10.0, decade)),
              TextShape::Anchor::Middle);
    }
    addLine(axis, {kLeftPx, row.bottom}, {options_.width - kRightPx, row.bottom}, frameStroke());
  }

  std::string titleOf(const OffsetStudyOptions& study) const {
    switch (options_.diagram) {
      case StudyDiagram::Ratio:
        return say("|offset| / |feature|") + ", " + say(std::string(nameOf(study.convention)));
      case StudyDiagram::Displacement:
        return say("apparent ridge to its ridge or valley, on the screen / length of the curve");
      case StudyDiagram::Conventions:
        break;
    }
    return say("|offset| / |feature|, the same curves in three kinds of unit");
  }

  void addTitle(const std::vector<std::string>& lines) {
    FigureGroup& title = group("title", "title");
    double y = options_.height - 12.0 - kTitleRowPx * static_cast<double>(lines.size() - 1);
    for (const std::string& line : lines) {
      addText(title, {0.5 * options_.width, y}, line, TextShape::Anchor::Middle);
      y += kTitleRowPx;
    }
  }

  void addHistogram(const std::string& id, const Row& row, const RatioHistogram& shares,
                    double factor) {
    const double most = *std::max_element(shares.begin(), shares.end());
    if (!(most > 0.0)) return;
    FigureGroup& bars = group("bars-" + id, "bars");
    const double shift = std::log10(factor);
    const Decades d = decadesOf(options_.diagram);
    for (std::size_t i = 0; i < shares.size(); ++i) {
      const auto bin = static_cast<double>(i);
      const double low = std::max(decadeOf(bin) + shift, d.low);
      const double high = std::min(decadeOf(bin + 1.0) + shift, d.high);
      if (!(shares[i] > 0.0) || low >= high) continue;
      const double left = xOf(low, options_), right = xOf(high, options_) - 0.6;
      const double top = row.bottom - shares[i] / most * (row.bottom - row.top - 22.0);
      PathData bar;
      bar.moveTo({left, row.bottom});
      bar.lineTo({left, top});
      bar.lineTo({std::max(right, left + 0.4), top});
      bar.lineTo({std::max(right, left + 0.4), row.bottom});
      bar.close();
      const bool selected = options_.selectedBin == i;
      bars.shapes.emplace_back(
          PathShape{std::move(bar), selected ? strong_ : bars_,
                    selected ? std::optional(Stroke{.colour = colours_.text}) : std::nullopt});
    }
  }

  void addQuartiles(const Row& row, const Quartiles& quartiles, double factor, double textAt,
                    const std::string& before) {
    FigureGroup& lines =
        group("quartiles-" + std::to_string(static_cast<int>(row.top)), "quartile");
    if (!(quartiles.median > 0.0)) return;
    const Decades d = decadesOf(options_.diagram);
    const auto line = [&](double value, const Stroke& stroke) {
      const double decade = std::log10(value * factor);
      if (!(decade > d.low && decade < d.high)) return;
      addLine(lines, {xOf(decade, options_), row.top}, {xOf(decade, options_), row.bottom}, stroke);
    };
    const Stroke dashed{.colour = colours_.text, .width = 1.0, .dash = {4.0, 3.0}};
    line(quartiles.lower, dashed);
    line(quartiles.upper, dashed);
    line(quartiles.median, {.colour = colours_.text, .width = 1.8});
    // As much as there is room for, the median first.
    const std::string median = say("median %1", {shortNumber(quartiles.median * factor)});
    const std::string rest =
        ", " + say("quartiles %1, %2",
                   {shortNumber(quartiles.lower * factor), shortNumber(quartiles.upper * factor)});
    const double room = options_.width - kLeftPx - kRightPx;
    std::string text = before + ": " + median + rest;
    if (estimatedWidth(text, textPx_) > room) text = before + ": " + median;
    if (estimatedWidth(text, textPx_) > room) text = median;
    addText(lines, {kLeftPx, textAt}, text, TextShape::Anchor::Start);
  }

  void addConventions(const OffsetSummary& summary, const OffsetStudyOptions& study,
                      double bottom) {
    const double height = (bottom - kTopPx) / kTermConventions;
    FigureGroup& thesis = group("thesis", "thesis");
    const double x = xOf(std::log10(kThesisRatio), options_);
    addLine(thesis, {x, kTopPx - 6.0}, {x, bottom},
            {.colour = styleOf(MarkKind::Ridge, options_.palette).colour,
             .width = 1.4,
             .dash = {2.0, 3.0}});
    addText(thesis, {x, 14.0}, say("thesis: 1/100,000"), TextShape::Anchor::Middle);
    addText(thesis, {options_.width - kRightPx, 14.0},
            say("square of side %1", {shortNumber(options_.scale)}), TextShape::Anchor::End);
    for (int c = 0; c < kTermConventions; ++c) {
      const auto convention = static_cast<TermConvention>(c);
      const Row row{kTopPx + c * height + 14.0, kTopPx + (c + 1) * height};
      const double factor =
          scaleFactor(convention, options_.scale) / scaleFactor(convention, study.scale);
      const PooledRatio& ratio = summary.ratio(convention);
      addHistogram(std::string(nameOf(convention)), {row.top - 18.0, row.bottom}, ratio.histogram,
                   factor);
      addQuartiles(row, ratio.perCurve, factor, row.top - 7.0,
                   say(std::string(nameOf(convention))));
      addLine(group("base-" + std::to_string(c), "axis"), {kLeftPx, row.bottom},
              {options_.width - kRightPx, row.bottom}, {.colour = colours_.text, .width = 0.8});
    }
  }

  const StudyFigureOptions& options_;
  Rgb bars_, strong_;
};

}  // namespace

Figure studyFigure(const OffsetSummary& summary, const OffsetStudyOptions& study,
                   const StudyFigureOptions& options) {
  return Builder(options).build(summary, study);
}

std::optional<std::size_t> studyBinAt(double xPx, const StudyFigureOptions& options) {
  if (options.diagram == StudyDiagram::Conventions) return std::nullopt;
  if (xPx < kLeftPx || xPx > options.width - kRightPx) return std::nullopt;
  const Decades d = decadesOf(options.diagram);
  const double decade =
      d.low + (xPx - kLeftPx) / (options.width - kLeftPx - kRightPx) * (d.high - d.low);
  const double bin = std::floor((decade + kRatioDecades) * kRatioBinsPerDecade);
  return static_cast<std::size_t>(std::clamp(bin, 0.0, kRatioBins - 1.0));
}

double studyBinX(std::size_t bin, const StudyFigureOptions& options) {
  return xOf(decadeOf(static_cast<double>(bin) + 0.5), options);
}

std::string shortNumber(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), value != 0.0 && std::abs(value) < 1e-3 ? "%.3g" : "%.4g",
                value);
  // "1e-05" is "1e-5" to people.
  std::string result = text.data();
  for (const char* padded : {"e-0", "e+0"}) {
    const std::size_t at = result.find(padded);
    if (at != std::string::npos) result.erase(at + 2, 1);
  }
  return result;
}

}  // namespace flatland::ui
