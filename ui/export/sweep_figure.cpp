// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/sweep_figure.h"

#include <algorithm>
#include <cmath>

#include "ui/export/plain_text.h"

namespace flatland::ui {

namespace {

constexpr double kLeftPx = 62.0, kRightPx = 18.0, kTopPx = 44.0, kBottomPx = 52.0;
constexpr double kTextPx = 12.0;
constexpr double kFirstDeg = -180.0, kLastDeg = 180.0;

/// A round step (1, 2 or 5 times a power of ten) that divides `range` into about `count` parts.
double roundStep(double range, int count) {
  const double raw = range / count;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (raw <= factor * power) return factor * power;
  }
  return 10.0 * power;
}

class Builder {
 public:
  Builder(const Sweep& sweep, const std::vector<double>& lengths, const SweepFigureOptions& options)
      : sweep_(sweep),
        lengths_(lengths),
        options_(options),
        colours_(sceneColours(options.palette)) {
    for (const double length : lengths) {
      starts_.push_back(total_);
      total_ += length;
    }
    if (!(total_ > 0.0)) total_ = 1.0;
  }

  Figure build() {
    figure_.width = options_.width;
    figure_.height = options_.height;
    figure_.background = colours_.background;
    addAxes();
    addLines();
    for (const MarkKind kind : markKindsInLegendOrder()) addBranches(kind);
    addEvents();
    addLegend();
    return std::move(figure_);
  }

 private:
  double x(double angleDeg) const {
    return kLeftPx +
           (angleDeg - kFirstDeg) / (kLastDeg - kFirstDeg) * (options_.width - kLeftPx - kRightPx);
  }
  double y(int curve, double u) const { return yOf(starts_[static_cast<std::size_t>(curve)] + u); }
  double yOf(double u) const {
    return options_.height - kBottomPx - u / total_ * (options_.height - kTopPx - kBottomPx);
  }

  FigureGroup& group(const std::string& id, const std::string& classes) {
    return figure_.groups.emplace_back(FigureGroup{id, classes, {}});
  }

  static void addLine(FigureGroup& to, const Vec2& a, const Vec2& b, const Stroke& stroke) {
    PathData path;
    path.moveTo(a);
    path.lineTo(b);
    to.shapes.emplace_back(PathShape{std::move(path), std::nullopt, stroke});
  }

  void addText(FigureGroup& to, const Vec2& at, const std::string& text, TextShape::Anchor anchor) {
    to.shapes.emplace_back(TextShape{at, text, kTextPx, colours_.text, anchor, false});
  }

  void addAxes() {
    FigureGroup& grid = group("grid", "grid");
    FigureGroup axes{"axes", "axes", {}};
    const Stroke faint{.colour = paler(colours_.faint, colours_.background), .width = 0.7};
    for (int angle = -180; angle <= 180; angle += 30) {
      addLine(grid, {x(angle), yOf(0.0)}, {x(angle), yOf(total_)}, faint);
      addText(axes, {x(angle), yOf(0.0) + 14.0}, std::to_string(angle) + "\u00b0",
              TextShape::Anchor::Middle);
    }
    for (std::size_t i = 0; i < lengths_.size(); ++i) {
      if (!(lengths_[i] > 0.0)) continue;
      const double step =
          roundStep(lengths_[i], std::max(2, static_cast<int>(8 * lengths_[i] / total_)));
      for (int k = 0; k * step <= lengths_[i] * (1.0 + 1e-9); ++k) {
        const double at = yOf(starts_[i] + k * step);
        addLine(grid, {x(kFirstDeg), at}, {x(kLastDeg), at}, faint);
        addText(axes, {x(kFirstDeg) - 7.0, at}, decimalText(k * step), TextShape::Anchor::End);
      }
    }
    const Stroke frame{.colour = colours_.text, .width = 1.0};
    for (std::size_t i = 0; i <= lengths_.size(); ++i) {
      const double at = yOf(i < lengths_.size() ? starts_[i] : total_);
      addLine(grid, {x(kFirstDeg), at}, {x(kLastDeg), at}, frame);
    }
    addLine(grid, {x(kFirstDeg), yOf(0.0)}, {x(kFirstDeg), yOf(total_)}, frame);
    addLine(grid, {x(kLastDeg), yOf(0.0)}, {x(kLastDeg), yOf(total_)}, frame);
    addText(axes, {x(0.0), options_.height - 16.0}, "view direction", TextShape::Anchor::Middle);
    addText(axes, {8.0, kTopPx - 14.0}, "arc length", TextShape::Anchor::Start);
    if (options_.viewAngleDeg) {
      const double at = x(normalizedDeg(*options_.viewAngleDeg));
      addLine(axes, {at, yOf(0.0)}, {at, yOf(total_)},
              {.colour = colours_.screen, .width = 1.6, .dash = {7.0, 4.0}});
    }
    figure_.groups.push_back(std::move(axes));
  }

  void addLines() {
    for (const MarkKind kind : markKindsInLegendOrder()) {
      if (!contains(options_.kinds, kind)) continue;
      FigureGroup lines{
          "lines-" + std::string(nameOf(kind)), "line " + std::string(nameOf(kind)), {}};
      const MarkStyle& style = styleOf(kind, options_.palette);
      for (const SweepLine& line : sweep_.lines) {
        if (line.kind != kind) continue;
        const double at = y(line.curve, line.u);
        addLine(lines, {x(kFirstDeg), at}, {x(kLastDeg), at},
                {.colour = style.colour, .width = 1.3});
        lines.shapes.emplace_back(
            markSymbol(kind, {x(kLastDeg), at}, kSymbolSizePx, 0.0, options_.palette, false));
      }
      if (!lines.shapes.empty()) figure_.groups.push_back(std::move(lines));
    }
  }

  void addBranches(MarkKind kind) {
    if (!contains(options_.kinds, kind)) return;
    FigureGroup branches{
        "branches-" + std::string(nameOf(kind)), "branch " + std::string(nameOf(kind)), {}};
    const MarkStyle& style = styleOf(kind, options_.palette);
    Stroke stroke{.colour = style.colour, .width = 2.2};
    if (kind == MarkKind::ApparentMinimum)
      stroke = {.colour = style.colour, .width = 1.4, .dash = {3.0, 3.0}};
    for (const SweepBranch& branch : sweep_.branches) {
      if (branch.kind != kind) continue;
      const auto [low, high] = std::minmax_element(
          branch.points.begin(), branch.points.end(),
          [](const SweepPoint& a, const SweepPoint& b) { return a.angleDeg < b.angleDeg; });
      // Every copy of the branch, 180 degrees apart, that reaches into the diagram.
      const int first = static_cast<int>(std::floor((kFirstDeg - high->angleDeg) / 180.0));
      const int last = static_cast<int>(std::ceil((kLastDeg - low->angleDeg) / 180.0));
      for (int copy = first; copy <= last; ++copy) addCopy(branches, branch, 180.0 * copy, stroke);
    }
    if (!branches.shapes.empty()) figure_.groups.push_back(std::move(branches));
  }

  // One copy of a branch, cut where it leaves the diagram.
  void addCopy(FigureGroup& to, const SweepBranch& branch, double shiftDeg,
               const Stroke& stroke) const {
    PathData path;
    bool drawing = false;
    const auto at = [&](double angle, double u) { return Vec2(x(angle), y(branch.curve, u)); };
    for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
      const double a = branch.points[i].angleDeg + shiftDeg,
                   b = branch.points[i + 1].angleDeg + shiftDeg;
      const double ua = branch.points[i].u, ub = branch.points[i + 1].u;
      const double from = std::clamp(a, kFirstDeg, kLastDeg),
                   until = std::clamp(b, kFirstDeg, kLastDeg);
      if (from == until && a != b) {
        drawing = false;
        continue;
      }
      const auto uAt = [&](double angle) {
        return a == b ? ub : ua + (ub - ua) * (angle - a) / (b - a);
      };
      if (!drawing) path.moveTo(at(from, a == b ? ua : uAt(from)));
      path.lineTo(at(until, uAt(until)));
      drawing = until == b;
    }
    if (!path.verbs.empty())
      to.shapes.emplace_back(PathShape{std::move(path), std::nullopt, stroke});
  }

  void addEvents() {
    if (!contains(options_.kinds, MarkKind::ApparentRidge)) return;
    FigureGroup folds{"events-fold", "event fold", {}};
    for (const SweepEvent& event : sweep_.events) {
      if (event.what != SweepEvent::What::Fold) continue;
      for (const double turn : {-180.0, 0.0, 180.0}) {
        const double angle = event.angleDeg + turn;
        if (angle < kFirstDeg || angle > kLastDeg) continue;
        PathData ring;
        ring.addCircle({x(angle), y(event.curve, event.u)}, 5.0);
        folds.shapes.emplace_back(PathShape{std::move(ring), std::nullopt,
                                            Stroke{.colour = colours_.text, .width = 1.4}});
      }
    }
    if (!folds.shapes.empty()) figure_.groups.push_back(std::move(folds));
  }

  void addLegend() {
    FigureGroup legend{"legend", "legend", {}};
    double at = kLeftPx + 26.0;
    const auto entry = [&](const std::string& text) {
      addText(legend, {at + 12.0, 16.0}, text, TextShape::Anchor::Start);
      at += 34.0 + estimatedWidth(text, kTextPx);
    };
    for (const MarkKind kind : markKindsInLegendOrder()) {
      const auto ofKind = [kind](const auto& item) { return item.kind == kind; };
      const bool present = std::any_of(sweep_.lines.begin(), sweep_.lines.end(), ofKind) ||
                           std::any_of(sweep_.branches.begin(), sweep_.branches.end(), ofKind);
      if (!present || !contains(options_.kinds, kind)) continue;
      legend.shapes.emplace_back(
          markSymbol(kind, {at, 16.0}, kSymbolSizePx, 0.0, options_.palette, false));
      entry(std::string(styleOf(kind).pluralName));
    }
    const bool folds =
        std::any_of(sweep_.events.begin(), sweep_.events.end(),
                    [](const SweepEvent& e) { return e.what == SweepEvent::What::Fold; });
    if (folds && contains(options_.kinds, MarkKind::ApparentRidge)) {
      PathData ring;
      ring.addCircle({at, 16.0}, 5.0);
      legend.shapes.emplace_back(
          PathShape{std::move(ring), std::nullopt, Stroke{.colour = colours_.text, .width = 1.4}});
      entry("Born or merged");
    }
    figure_.groups.push_back(std::move(legend));
  }

  const Sweep& sweep_;
  const std::vector<double>& lengths_;
  const SweepFigureOptions& options_;
  const SceneColours& colours_;
  std::vector<double> starts_;
  double total_ = 0.0;
  Figure figure_;
};

}  // namespace

Figure sweepFigure(const Sweep& sweep, const std::vector<double>& curveLengths,
                   const SweepFigureOptions& options) {
  return Builder(sweep, curveLengths, options).build();
}

}  // namespace flatland::ui
