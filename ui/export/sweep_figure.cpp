// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/sweep_figure.h"

#include <algorithm>
#include <cmath>

#include "flatland/curve/curve.h"
#include "ui/export/figure_builder.h"
#include "ui/export/label_placement.h"
#include "ui/export/plain_text.h"

namespace flatland::ui {

namespace {

constexpr double kBottomPx = 46.0;
constexpr double kLegendRowPx = 18.0;
// Below this width the names at the right end would take too much of the plot; letters stand there.
constexpr double kRoomForNamesPx = 640.0;
constexpr double kNarrowPx = 560.0;  // tick labels of arc length take less room
constexpr double kGridDeg = 45.0;
constexpr double kLabelledBranchPx = 60.0;
constexpr double kAxisAccuracy = 1e-9;  // relative to the scene: far below a pixel

/// A round step (1, 2 or 5 times a power of ten) that divides `range` into about `count` parts.
double roundStep(double range, int count) {
  const double raw = range / count;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (raw <= factor * power) return factor * power;
  }
  return 10.0 * power;
}

/// A step in degrees with which at most `count` ticks fit into the range.
double degreeStep(double range, int count) {
  for (const double step : {45.0, 90.0, 180.0}) {
    if (range > 180.0 && range / step <= count) return step;
  }
  for (const double step : {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 15.0, 45.0, 90.0}) {
    if (range / step <= count) return step;
  }
  return 180.0;
}

bool shows(const SweepFigureOptions& options, MarkKind kind) {
  return contains(options.kinds, kind);
}

bool hasFolds(const Sweep& sweep) {
  return std::any_of(sweep.events.begin(), sweep.events.end(),
                     [](const SweepEvent& e) { return e.what == SweepEvent::What::Fold; });
}

struct LegendEntry {
  std::optional<MarkKind> kind;  ///< none: the ring of births and merges, or words alone
  bool ring;
  std::string text;
  double x, y;
};

struct Legend {
  std::vector<LegendEntry> entries;
  double height = 0.0;
};

// Entries in as many rows as the width asks for.
Legend legendOf(const Sweep& sweep, const SweepFigureOptions& options) {
  Legend legend;
  if (!options.legend) return legend;
  const double left = 20.0;
  double x = left, y = 14.0;
  const auto add = [&](std::optional<MarkKind> kind, bool ring, const std::string& text) {
    const double symbol = kind || ring ? 12.0 : 0.0;
    const double width = symbol + estimatedWidth(text, options.textPx) + 20.0;
    if (x > left && x + width > options.width) x = left, y += kLegendRowPx;
    legend.entries.push_back({kind, ring, text, x, y});
    x += width;
  };
  for (const MarkKind kind : markKindsInLegendOrder()) {
    const auto ofKind = [kind](const auto& item) { return item.kind == kind; };
    const bool present = std::any_of(sweep.lines.begin(), sweep.lines.end(), ofKind) ||
                         std::any_of(sweep.branches.begin(), sweep.branches.end(), ofKind);
    if (present && shows(options, kind)) {
      add(kind, false, inWords(options.words, std::string(styleOf(kind).pluralName)));
    }
  }
  if (hasFolds(sweep) && shows(options, MarkKind::ApparentRidge)) {
    add(std::nullopt, true, inWords(options.words, "Born or merged"));
  }
  if (options.visibility && !legend.entries.empty()) {
    add(std::nullopt, false, inWords(options.words, "paler: hidden"));
  }
  legend.height = legend.entries.empty() ? 0.0 : y + 0.5 * kLegendRowPx;
  return legend;
}

// Of the names at the ends of the level lines, px.
double widestName(const Sweep& sweep, const SweepFigureOptions& options) {
  double widest = 0.0;
  for (const SweepLine& line : sweep.lines) {
    if (!shows(options, line.kind)) continue;
    const std::string name = inWords(options.words, std::string(styleOf(line.kind).name));
    widest = std::max(widest, estimatedWidth(name, options.textPx));
  }
  return widest;
}

class Builder : FigureBuilder {
 public:
  Builder(const Sweep& sweep, const std::vector<double>& lengths, const SweepFigureOptions& options)
      : FigureBuilder(options.width, options.height, options.palette, options.textPx,
                      options.words),
        sweep_(sweep),
        options_(options),
        axes_(sweepAxes(sweep, lengths, options)) {}

  Figure build() {
    addAxes();
    addLines();
    for (const MarkKind kind : markKindsInLegendOrder()) addBranches(kind);
    addEvents();
    addLabels();
    addLegend();
    return std::move(figure_);
  }

 private:
  const SweepAxes::Box& box() const { return axes_.box(); }
  const SweepWindow& window() const { return axes_.window(); }

  Rgb shade(Rgb colour, bool visible) const {
    return visible ? colour : paler(colour, colours_.background);
  }

  void addAxes() {
    FigureGroup& grid = group("grid", "grid");
    FigureGroup axes{"axes", "axes", {}};
    const Stroke faint = gridStroke();
    const SweepWindow& w = window();
    const double range = w.angleHigh - w.angleLow;
    const double labelPx = estimatedWidth("-180\u00b0", options_.textPx) + 14.0;
    const double step =
        degreeStep(range, std::max(2, static_cast<int>((box().right - box().left) / labelPx)));
    // Every 45 degrees a line, also where the numbers need more room.
    const double lines = std::min(step, range >= kGridDeg ? kGridDeg : step);
    for (double k = std::ceil(w.angleLow / lines - 1e-9); k * lines <= w.angleHigh + 1e-9 * range;
         ++k) {
      const double at = axes_.x(k * lines);
      addLine(grid, {at, box().bottom}, {at, box().top}, faint);
      const double steps = k * lines / step;
      if (std::abs(steps - std::round(steps)) > 1e-6) continue;
      addText(axes, {at, box().bottom + 13.0}, decimalText(k * lines) + "\u00b0",
              TextShape::Anchor::Middle);
    }
    for (int curve = 0; curve < axes_.curveCount(); ++curve) addArcTicks(grid, axes, curve, faint);
    const Stroke frame = frameStroke();
    addLine(grid, {box().left, box().bottom}, {box().right, box().bottom}, frame);
    addLine(grid, {box().left, box().top}, {box().right, box().top}, frame);
    addLine(grid, {box().left, box().bottom}, {box().left, box().top}, frame);
    addLine(grid, {box().right, box().bottom}, {box().right, box().top}, frame);
    addText(axes, {0.5 * (box().left + box().right), options_.height - 14.0},
            say("view direction (orthographic)"), TextShape::Anchor::Middle);
    addText(axes, {8.0, box().top - 11.0}, say("arc length"), TextShape::Anchor::Start);
    if (options_.viewAngleDeg) {
      const double angle = normalizedDeg(*options_.viewAngleDeg);
      if (angle >= w.angleLow && angle <= w.angleHigh) {
        addLine(axes, {axes_.x(angle), box().bottom}, {axes_.x(angle), box().top},
                {.colour = colours_.screen, .width = 1.6, .dash = {7.0, 4.0}});
      }
    }
    figure_.groups.push_back(std::move(axes));
  }

  // Each curve counts its own length, from the line at which it starts.
  void addArcTicks(FigureGroup& grid, FigureGroup& axes, int curve, const Stroke& faint) {
    const double length = axes_.length(curve);
    if (!(length > 0.0)) return;
    const SweepWindow& w = window();
    const double shown = std::min(length, w.uHigh - w.uLow);
    const double px = shown / (w.uHigh - w.uLow) * (box().bottom - box().top);
    const double step = roundStep(shown, std::max(2, static_cast<int>(px / 45.0)));
    const double from = std::max(0.0, w.uLow - axes_.start(curve));
    const double to = std::min(length, w.uHigh - axes_.start(curve));
    for (double k = std::ceil(from / step - 1e-9); k * step <= to + 1e-9 * step; ++k) {
      const double at = axes_.y(curve, k * step);
      addLine(grid, {box().left, at}, {box().right, at}, faint);
      addText(axes, {box().left - 6.0, at}, decimalText(k * step), TextShape::Anchor::End);
    }
    if (curve > 0 && from == 0.0) {
      const double at = axes_.y(curve, 0.0);
      addLine(grid, {box().left, at}, {box().right, at}, {.colour = colours_.text, .width = 1.0});
    }
  }

  bool inWindow(double stackedU) const {
    return stackedU >= window().uLow && stackedU <= window().uHigh;
  }

  void addLines() {
    for (const MarkKind kind : markKindsInLegendOrder()) {
      if (!shows(options_, kind)) continue;
      FigureGroup lines{
          "lines-" + std::string(nameOf(kind)), "line " + std::string(nameOf(kind)), {}};
      for (std::size_t i = 0; i < sweep_.lines.size(); ++i) {
        const SweepLine& line = sweep_.lines[i];
        if (line.kind == kind && inWindow(axes_.start(line.curve) + line.u)) addLevel(lines, i);
      }
      if (!lines.shapes.empty()) figure_.groups.push_back(std::move(lines));
    }
  }

  // A level line, paler over the directions from which the mark is hidden.
  void addLevel(FigureGroup& to, std::size_t index) {
    const SweepLine& line = sweep_.lines[index];
    const double at = axes_.y(line.curve, line.u);
    const Rgb colour = styleOf(line.kind, options_.palette).colour;
    const auto seen = [&](double angle) {
      return !options_.visibility || options_.visibility->lineAt(index, angle);
    };
    double from = window().angleLow;
    bool visible = seen(from);
    const auto stretch = [&](double until) {
      addLine(to, {axes_.x(from), at}, {axes_.x(until), at},
              {.colour = shade(colour, visible), .width = 1.4});
    };
    for (double degree = std::ceil(from); degree < window().angleHigh; ++degree) {
      if (seen(degree) == visible) continue;
      stretch(std::max(from, degree - 0.5));
      from = std::max(from, degree - 0.5);
      visible = !visible;
    }
    stretch(window().angleHigh);
  }

  void addBranches(MarkKind kind) {
    if (!shows(options_, kind)) return;
    FigureGroup branches{
        "branches-" + std::string(nameOf(kind)), "branch " + std::string(nameOf(kind)), {}};
    const MarkStyle& style = styleOf(kind, options_.palette);
    Stroke stroke{.colour = style.colour, .width = 2.2};
    if (kind == MarkKind::ApparentMinimum)
      stroke = {.colour = style.colour, .width = 1.4, .dash = {3.0, 3.0}};
    for (std::size_t i = 0; i < sweep_.branches.size(); ++i) {
      const SweepBranch& branch = sweep_.branches[i];
      if (branch.kind != kind) continue;
      const auto [low, high] = std::minmax_element(
          branch.points.begin(), branch.points.end(),
          [](const SweepPoint& a, const SweepPoint& b) { return a.angleDeg < b.angleDeg; });
      // Every copy of the branch, 180 degrees apart, that reaches into the diagram.
      const int first = static_cast<int>(std::floor((window().angleLow - high->angleDeg) / 180.0));
      const int last = static_cast<int>(std::ceil((window().angleHigh - low->angleDeg) / 180.0));
      for (int copy = first; copy <= last; ++copy) addCopy(branches, i, copy, stroke);
    }
    if (!branches.shapes.empty()) figure_.groups.push_back(std::move(branches));
  }

  // One copy of a branch, cut where it leaves the diagram and where it goes out of sight.
  void addCopy(FigureGroup& to, std::size_t index, int copy, Stroke stroke) {
    const SweepBranch& branch = sweep_.branches[index];
    const Rgb colour = stroke.colour;
    PathData path;
    bool drawing = false, visible = true;
    double lengthPx = 0.0;
    Vec2 middle = Vec2::Zero();
    const auto flush = [&] {
      if (path.verbs.empty()) return;
      stroke.colour = shade(colour, visible);
      to.shapes.emplace_back(PathShape{std::move(path), std::nullopt, stroke});
      path = {};
    };
    const auto at = [&](const SweepPoint& p) {
      return Vec2(p.angleDeg + 180.0 * copy, axes_.start(branch.curve) + p.u);
    };
    for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
      const Vec2 a = at(branch.points[i]), b = at(branch.points[i + 1]);
      const auto clip = axes_.clipped(a, b);
      if (!clip) {
        drawing = false;
        continue;
      }
      // Both ends in sight, as a hidden stretch is never drawn longer than it is known to be.
      const bool seen = !options_.visibility || (options_.visibility->branchAt(index, i, copy) &&
                                                 options_.visibility->branchAt(index, i + 1, copy));
      const auto px = [&](double share) {
        const Vec2 p = a + share * (b - a);
        return Vec2(axes_.x(p.x()), axes_.yOf(p.y()));
      };
      if (seen != visible) flush(), drawing = false;
      visible = seen;
      if (!drawing) path.moveTo(px(clip->from));
      path.lineTo(px(clip->to));
      drawing = clip->to == 1.0;
      const double step = (px(clip->to) - px(clip->from)).norm();
      if (lengthPx < kLabelledBranchPx && lengthPx + step >= kLabelledBranchPx) {
        middle = px(clip->to);
      }
      lengthPx += step;
    }
    flush();
    if (lengthPx > 2.0 * kLabelledBranchPx) branchLabels_.push_back({branch.kind, middle});
  }

  void addEvents() {
    if (!shows(options_, MarkKind::ApparentRidge)) return;
    FigureGroup folds{"events-fold", "event fold", {}};
    for (const SweepEvent& event : sweep_.events) {
      if (event.what != SweepEvent::What::Fold) continue;
      if (!inWindow(axes_.start(event.curve) + event.u)) continue;
      for (const double turn : {-180.0, 0.0, 180.0}) {
        const double angle = event.angleDeg + turn;
        if (angle < window().angleLow || angle > window().angleHigh) continue;
        PathData ring;
        ring.addCircle({axes_.x(angle), axes_.y(event.curve, event.u)}, kEventRingPx);
        folds.shapes.emplace_back(PathShape{std::move(ring), std::nullopt,
                                            Stroke{.colour = colours_.text, .width = 1.4}});
      }
    }
    if (!folds.shapes.empty()) figure_.groups.push_back(std::move(folds));
  }

  // Names or letters at the right end of the level lines, kept apart, and letters on the branches.
  void addLabels() {
    FigureGroup labels{"labels", "labels", {}};
    std::vector<const SweepLine*> lines;
    for (const SweepLine& line : sweep_.lines) {
      if (shows(options_, line.kind) && inWindow(axes_.start(line.curve) + line.u)) {
        lines.push_back(&line);
      }
    }
    std::sort(lines.begin(), lines.end(), [&](const SweepLine* a, const SweepLine* b) {
      return axes_.y(a->curve, a->u) < axes_.y(b->curve, b->u);
    });
    std::vector<double> wanted;
    for (const SweepLine* line : lines) wanted.push_back(axes_.y(line->curve, line->u));
    const std::vector<double> places = spreadApart(wanted, options_.textPx + 1.0);
    const bool names = options_.width >= kRoomForNamesPx;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const MarkStyle& style = styleOf(lines[i]->kind, options_.palette);
      const Vec2 end(box().right, wanted[i]), label(box().right + 18.0, places[i]);
      addLine(labels, end, {label.x() - 9.0, label.y()}, {.colour = style.colour, .width = 0.8});
      labels.shapes.emplace_back(
          markSymbol(lines[i]->kind, label, kSymbolSizePx, 0.0, options_.palette, false));
      labels.shapes.emplace_back(
          TextShape{label + Vec2(9.0, 0.0),
                    names ? say(std::string(style.name)) : std::string(1, style.letter),
                    options_.textPx, style.letterColour, TextShape::Anchor::Start, false});
    }
    for (const BranchLabel& label : branchLabels_) {
      const MarkStyle& style = styleOf(label.kind, options_.palette);
      PathData disc;
      disc.addCircle(label.at, 0.62 * options_.textPx);
      labels.shapes.emplace_back(PathShape{std::move(disc), colours_.background, std::nullopt});
      labels.shapes.emplace_back(TextShape{label.at, std::string(1, style.letter), options_.textPx,
                                           style.letterColour, TextShape::Anchor::Middle, true});
    }
    if (!labels.shapes.empty()) figure_.groups.push_back(std::move(labels));
  }

  void addLegend() {
    FigureGroup legend{"legend", "legend", {}};
    for (const LegendEntry& entry : legendOf(sweep_, options_).entries) {
      if (entry.kind) {
        legend.shapes.emplace_back(markSymbol(*entry.kind, {entry.x, entry.y}, kSymbolSizePx, 0.0,
                                              options_.palette, false));
      } else if (entry.ring) {
        PathData ring;
        ring.addCircle({entry.x, entry.y}, kEventRingPx);
        legend.shapes.emplace_back(PathShape{std::move(ring), std::nullopt,
                                             Stroke{.colour = colours_.text, .width = 1.4}});
      }
      const double indent = entry.kind || entry.ring ? 10.0 : -4.0;
      addText(legend, {entry.x + indent, entry.y}, entry.text, TextShape::Anchor::Start);
    }
    figure_.groups.push_back(std::move(legend));
  }

  struct BranchLabel {
    MarkKind kind;
    Vec2 at;
  };

  const Sweep& sweep_;
  const SweepFigureOptions& options_;
  SweepAxes axes_;
  std::vector<BranchLabel> branchLabels_;
};

}  // namespace

SweepAxes sweepAxes(const Sweep& sweep, const std::vector<double>& curveLengths,
                    const SweepFigureOptions& options) {
  const double legend = legendOf(sweep, options).height;
  const double names = options.width >= kRoomForNamesPx ? 34.0 + widestName(sweep, options) : 42.0;
  const double left = options.width >= kNarrowPx ? 54.0 : 40.0;
  return {curveLengths,
          {left, legend + 24.0, std::max(options.width - names, left + 10.0),
           std::max(options.height - kBottomPx, legend + 34.0)},
          options.window};
}

Figure sweepFigure(const Sweep& sweep, const std::vector<double>& curveLengths,
                   const SweepFigureOptions& options) {
  return Builder(sweep, curveLengths, options).build();
}

std::vector<double> curveLengths(const Scene& scene) {
  const double size = boundsOf(scene).diagonal();
  std::vector<double> lengths;
  for (const SceneCurve& curve : scene.curves) {
    const double end = pieceCount(curve.shape);
    lengths.push_back(size > 0.0 ? arcLength(curve.shape, 0.0, end, kAxisAccuracy * size).value
                                 : 0.0);
  }
  return lengths;
}

}  // namespace flatland::ui
