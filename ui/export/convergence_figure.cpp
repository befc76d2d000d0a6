// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/convergence_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core3d/io/convergence_text.h"
#include "ui/export/figure_builder.h"
#include "ui/export/study_figure.h"

namespace flatland::ui {

namespace {

constexpr double kLeftPx = 64.0, kRightPx = 16.0, kTopPx = 16.0, kBottomPx = 48.0;
constexpr double kLegendLinePx = 18.0, kTitleLinePx = 15.0;
constexpr double kLegendKeyPx = 30.0, kKeyGapPx = 8.0;

struct Range {
  double low, high;  // decades

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// How a series is drawn.
struct SeriesStyle {
  Rgb colour;
  MarkSymbol symbol;
  std::vector<double> dash;
};

class Builder : FigureBuilder {
 public:
  explicit Builder(const ConvergenceFigureOptions& options)
      : FigureBuilder(options.width, options.height, options.palette, options.textPx),
        options_(options) {}

  Figure build(const std::vector<ConvergenceSeries>& all, const std::string& subject) {
    findRanges(all);
    // The legend stands below the diagram, so that it covers no data.
    const std::string title =
        inWords(options_.words,
                "%1: median distance to the exact apparent ridge against the mean edge length",
                {inWords(options_.words, subject)});
    const std::vector<std::string> lines =
        wrapped(title, options_.textPx, options_.width - kLeftPx - kRightPx);
    std::vector<std::vector<std::string>> legend;
    double legendPx = 0.0;
    for (const ConvergenceSeries& series : all) {
      legend.push_back(wrapped(legendText(series), options_.textPx,
                               options_.width - kLeftPx - kLegendKeyPx - kKeyGapPx - kRightPx));
      legendPx += heightOf(legend.back());
    }
    bottom_ = options_.height - kBottomPx - legendPx -
              kTitleLinePx * static_cast<double>(lines.size() - 1);
    addAxes(lines);
    addEdgeLine();
    double y = options_.height - legendPx - 2.0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      addSeries(all[i], legend[i], y);
      y += heightOf(legend[i]);
    }
    return std::move(figure_);
  }

 private:
  static double distanceOf(const ConvergenceRow& row) { return row.medianEdges * row.edge; }
  static double heightOf(const std::vector<std::string>& legend) {
    return kLegendLinePx + kTitleLinePx * static_cast<double>(legend.size() - 1);
  }
  static bool isDrawn(const ConvergenceRow& row) {
    return std::isfinite(row.medianEdges) && row.medianEdges > 0.0;
  }

  void findRanges(const std::vector<ConvergenceSeries>& all) {
    bool any = false;
    for (const ConvergenceSeries& series : all) {
      for (const ConvergenceRow& row : series.rows) {
        const double x = std::log10(row.edge);
        if (!any) {
          across_ = {x, x};
          up_ = {x, x};
          any = true;
        }
        across_.include(x);
        up_.include(x);
        if (isDrawn(row)) up_.include(std::log10(distanceOf(row)));
      }
    }
    constexpr double kAir = 0.15;  // decades around the data
    across_ = {across_.low - kAir, across_.high + kAir};
    up_ = {std::floor(up_.low - kAir), std::ceil(up_.high + kAir)};
  }

  double xOf(double decade) const {
    return kLeftPx + (decade - across_.low) / (across_.high - across_.low) *
                         (options_.width - kLeftPx - kRightPx);
  }
  double yOf(double decade) const {
    return bottom_ - (decade - up_.low) / (up_.high - up_.low) * (bottom_ - kTopPx);
  }

  void addAxes(const std::vector<std::string>& title) {
    FigureGroup& axis = group("axis", "axis");
    for (double decade = up_.low; decade <= up_.high + 0.5; decade += 1.0) {
      const double y = yOf(decade);
      addLine(axis, {kLeftPx, y}, {options_.width - kRightPx, y}, gridStroke());
      addText(axis, {kLeftPx - 6.0, y}, shortNumber(std::pow(10.0, decade)),
              TextShape::Anchor::End);
    }
    for (int decade = static_cast<int>(std::floor(across_.low)); decade <= across_.high; ++decade) {
      for (const double step : {1.0, 2.0, 5.0}) {
        const double at = decade + std::log10(step);
        if (at < across_.low || at > across_.high) continue;
        addLine(axis, {xOf(at), kTopPx}, {xOf(at), bottom_}, gridStroke());
        addText(axis, {xOf(at), bottom_ + 12.0}, shortNumber(step * std::pow(10.0, decade)),
                TextShape::Anchor::Middle);
      }
    }
    addLine(axis, {kLeftPx, kTopPx}, {kLeftPx, bottom_}, frameStroke());
    addLine(axis, {kLeftPx, bottom_}, {options_.width - kRightPx, bottom_}, frameStroke());
    FigureGroup& words = group("title", "title");
    double y = bottom_ + 30.0;
    for (const std::string& line : title) {
      addText(words, {0.5 * (kLeftPx + options_.width - kRightPx), y}, line,
              TextShape::Anchor::Middle);
      y += kTitleLinePx;
    }
  }

  /// Where the distance is as long as an edge.
  void addEdgeLine() {
    const double low = std::max(across_.low, up_.low), high = std::min(across_.high, up_.high);
    if (!(low < high)) return;
    FigureGroup& line = group("one-edge", "one-edge");
    addLine(line, {xOf(low), yOf(low)}, {xOf(high), yOf(high)},
            {.colour = colours_.faint, .width = 1.0, .dash = {2.0, 3.0}});
    addText(line, {xOf(high) - 4.0, yOf(high) + 12.0}, inWords(options_.words, "1 edge"),
            TextShape::Anchor::End);
  }

  SeriesStyle styleOfSeries(const ConvergenceSeries& series) const {
    const bool jet = series.estimator == FieldEstimator::JetFit;
    const bool closed = series.derivative == RidgeDerivative::ClosedForm;
    const MarkKind kind = jet ? MarkKind::Inflection : MarkKind::Ridge;
    return {styleOf(kind, options_.palette).colour,
            closed ? MarkSymbol::Dot : MarkSymbol::OpenSquare,
            closed ? std::vector<double>{} : std::vector<double>{5.0, 3.0}};
  }

  void addSymbol(FigureGroup& to, const Vec2& at, const SeriesStyle& style) const {
    constexpr double kSizePx = 8.0;
    SymbolOutline outline = symbolOutline(style.symbol, at, kSizePx, 0.0);
    if (outline.filled) {
      to.shapes.emplace_back(PathShape{std::move(outline.path), style.colour, std::nullopt});
    } else {
      to.shapes.emplace_back(PathShape{std::move(outline.path), colours_.background,
                                       Stroke{.colour = style.colour, .width = 1.5}});
    }
  }

  std::string legendText(const ConvergenceSeries& series) const {
    const auto word = [this](std::string_view english) {
      return inWords(options_.words, std::string(english));
    };
    std::string text = inWords(options_.words, "%1 curvature, %2 derivative",
                               {word(nameOf(series.estimator)), word(nameOf(series.derivative))});
    if (!series.order) return text;
    std::array<char, 64> order{};
    std::snprintf(order.data(), order.size(), "%.2f", *series.order);
    return text + inWords(options_.words, ", order %1", {order.data()});
  }

  /// `top`: of its lines in the legend.
  void addSeries(const ConvergenceSeries& series, const std::vector<std::string>& legend,
                 double top) {
    const SeriesStyle style = styleOfSeries(series);
    const std::string name =
        std::string(nameOf(series.estimator)) + "-" + std::string(nameOf(series.derivative));
    FigureGroup& lines = group("series-" + name, "series");
    PathData path;
    std::vector<Vec2> places;
    for (const ConvergenceRow& row : series.rows) {
      if (!isDrawn(row)) continue;
      places.emplace_back(xOf(std::log10(row.edge)), yOf(std::log10(distanceOf(row))));
      if (places.size() == 1) {
        path.moveTo(places.back());
      } else {
        path.lineTo(places.back());
      }
    }
    const Stroke stroke{.colour = style.colour, .width = 1.6, .dash = style.dash};
    if (places.size() > 1) lines.shapes.emplace_back(PathShape{std::move(path), {}, stroke});
    for (const Vec2& place : places) addSymbol(lines, place, style);

    double y = top + 0.5 * kLegendLinePx;
    addLine(lines, {kLeftPx, y}, {kLeftPx + kLegendKeyPx, y}, stroke);
    addSymbol(lines, {kLeftPx + 0.5 * kLegendKeyPx, y}, style);
    for (const std::string& line : legend) {
      addText(lines, {kLeftPx + kLegendKeyPx + kKeyGapPx, y}, line, TextShape::Anchor::Start);
      y += kTitleLinePx;
    }
  }

  const ConvergenceFigureOptions& options_;
  double bottom_ = 0.0;
  Range across_{0.0, 0.0}, up_{0.0, 0.0};
};

}  // namespace

Figure convergenceFigure(const std::vector<ConvergenceSeries>& all, const std::string& subject,
                         const ConvergenceFigureOptions& options) {
  return Builder(options).build(all, subject);
}

}  // namespace flatland::ui
