// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/limits_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "ui/export/figure_builder.h"
#include "ui/export/study_figure.h"

namespace flatland::ui {

namespace {

constexpr double kLeftPx = 58.0, kRightPx = 16.0, kBottomPx = 42.0;
constexpr double kTickPx = 46.0;
constexpr double kRowPx = 16.0;      // of the words above
constexpr double kOneRowPx = 380.0;  // narrower, the slopes take a row each
constexpr double kPointPx = 2.2;

struct Range {
  double low, high;  ///< decades
};

std::string withError(double slope, double error) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%.5f \u00b1 %.1e", slope, error);
  return text.data();
}

class Builder : FigureBuilder {
 public:
  Builder(const LimitSeries& series, const LimitsFigureOptions& options)
      : FigureBuilder(options.width, options.height, options.palette, options.textPx,
                      options.words),
        series_(series),
        law_(series.laws[std::min(options.law, series.laws.size() - 1)]),
        options_(options) {
    x_ = {std::log10(series.x.back()), std::log10(series.x.front())};
    y_ = {1e9, -1e9};
    for (const double value : law_.values) {
      if (!(value > 0.0) || !std::isfinite(value)) continue;
      y_.low = std::min(y_.low, std::log10(value));
      y_.high = std::max(y_.high, std::log10(value));
    }
    hasValues_ = y_.low <= y_.high;
    if (!hasValues_) y_ = {-1.0, 1.0};
    // At least a decade, so that a constant is seen to be one.
    const double middle = 0.5 * (y_.low + y_.high), half = std::max(0.5, 0.53 * (y_.high - y_.low));
    y_ = {middle - half, middle + half};
  }

  Figure build() {
    addAxes();
    if (hasValues_) {
      addPredicted();
      addPoints();
      addFit();
    }
    addWords();
    return std::move(figure_);
  }

 private:
  bool isNarrow() const { return options_.width < kOneRowPx; }
  double top() const { return isNarrow() ? 30.0 + kRowPx : 30.0; }

  // The way goes to the right, towards small x.
  double px(double logX) const {
    return kLeftPx + (x_.high - logX) / (x_.high - x_.low) * (options_.width - kLeftPx - kRightPx);
  }
  double py(double logY) const {
    return options_.height - kBottomPx -
           (logY - y_.low) / (y_.high - y_.low) * (options_.height - top() - kBottomPx);
  }

  static int stepFor(double decades, double lengthPx) {
    return std::max(1, static_cast<int>(std::ceil(decades * kTickPx / lengthPx)));
  }

  void addAxes() {
    FigureGroup& axes = group("axes", "axes");
    const Stroke faint = gridStroke();
    const double left = kLeftPx, right = options_.width - kRightPx;
    const double top = this->top(), bottom = options_.height - kBottomPx;
    const int xStep = stepFor(x_.high - x_.low, right - left);
    for (int d = static_cast<int>(std::ceil(x_.low - 1e-9)); d <= x_.high + 1e-9; ++d) {
      if (d % xStep != 0) continue;
      addLine(axes, {px(d), top}, {px(d), bottom}, faint);
      addText(axes, {px(d), bottom + 12.0}, shortNumber(std::pow(10.0, d)),
              TextShape::Anchor::Middle);
    }
    const int yStep = stepFor(y_.high - y_.low, (bottom - top) * 2.0);
    for (int d = static_cast<int>(std::ceil(y_.low)); d <= y_.high; ++d) {
      if (d % yStep != 0) continue;
      addLine(axes, {left, py(d)}, {right, py(d)}, faint);
      addText(axes, {left - 6.0, py(d)}, shortNumber(std::pow(10.0, d)), TextShape::Anchor::End);
    }
    const Stroke frame = frameStroke();
    addLine(axes, {left, bottom}, {right, bottom}, frame);
    addLine(axes, {left, top}, {left, bottom}, frame);
    if (options_.markedX && *options_.markedX > 0.0) {
      const double at = std::log10(*options_.markedX);
      if (at >= x_.low && at <= x_.high) {
        addLine(axes, {px(at), top}, {px(at), bottom},
                {.colour = colours_.screen, .width = 1.6, .dash = {7.0, 4.0}});
      }
    }
  }

  void addPoints() {
    FigureGroup& points = group("points", "points");
    for (std::size_t i = 0; i < series_.x.size(); ++i) {
      if (!(law_.values[i] > 0.0) || !std::isfinite(law_.values[i])) continue;
      PathData dot;
      dot.addCircle({px(std::log10(series_.x[i])), py(std::log10(law_.values[i]))}, kPointPx);
      points.shapes.emplace_back(PathShape{std::move(dot), colours_.text, std::nullopt});
    }
  }

  // y = coefficient x^order over [low, high] decades of x, cut at the frame.
  void addPower(FigureGroup& to, double order, double coefficient, double low, double high,
                const Stroke& stroke) const {
    const double at = std::log10(coefficient);
    if (order != 0.0) {
      double enter = (y_.low - at) / order, leave = (y_.high - at) / order;
      if (enter > leave) std::swap(enter, leave);
      low = std::max(low, enter);
      high = std::min(high, leave);
    } else if (at < y_.low || at > y_.high) {
      return;
    }
    if (low >= high) return;
    addLine(to, {px(low), py(at + order * low)}, {px(high), py(at + order * high)}, stroke);
  }

  void addPredicted() {
    if (!law_.order || !law_.coefficient) return;
    addPower(group("predicted", "predicted"), *law_.order, *law_.coefficient, x_.low, x_.high,
             {.colour = styleOf(MarkKind::Inflection, options_.palette).colour,
              .width = 1.6,
              .dash = {6.0, 4.0}});
  }

  void addFit() {
    if (!law_.fit) return;
    addPower(group("fit", "fit"), law_.fit->slope, law_.fit->coefficient,
             std::log10(law_.fit->xLow), std::log10(law_.fit->xHigh),
             {.colour = styleOf(MarkKind::ApparentRidge, options_.palette).colour, .width = 3.5});
  }

  void addWords() {
    FigureGroup& words = group("words", "words");
    const double middle = 0.5 * (kLeftPx + options_.width - kRightPx);
    addText(words, {middle, options_.height - 11.0}, options_.xName, TextShape::Anchor::Middle);
    addText(words, {8.0, 12.0}, options_.yName, TextShape::Anchor::Start);
    const double right = options_.width - kRightPx;
    std::string text = say("no power law here");
    if (law_.order) text = say("predicted slope %1", {shortNumber(*law_.order)});
    const std::string fitted =
        law_.fit ? say("fitted %1", {withError(law_.fit->slope, law_.fit->slopeError)})
                 : std::string();
    if (!isNarrow() && law_.fit) text += ", " + fitted;
    addText(words, {right, 12.0}, text, TextShape::Anchor::End);
    if (isNarrow() && law_.fit) {
      addText(words, {right, 12.0 + kRowPx}, fitted, TextShape::Anchor::End);
    }
  }

  const LimitSeries& series_;
  const LimitLaw& law_;
  const LimitsFigureOptions& options_;
  Range x_{}, y_{};
  bool hasValues_ = false;
};

}  // namespace

Figure limitsFigure(const LimitSeries& series, const LimitsFigureOptions& options) {
  return Builder(series, options).build();
}

}  // namespace flatland::ui
