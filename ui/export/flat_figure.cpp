// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/flat_figure.h"

#include <algorithm>
#include <cmath>

#include "ui/export/flat_layers.h"
#include "ui/export/flat_parts.h"
#include "ui/export/label_placement.h"

namespace flatland::ui {

namespace {

constexpr double kCurveWidthPx = 2.2;
constexpr double kScreenWidthPx = 1.6;
constexpr double kImageWidthPx = 4.5;
constexpr double kLetterPx = 13.0;
constexpr double kScreenSymbolPx = 6.5;
constexpr double kLetterOffPx = 16.0;      // of the letters from the screen
constexpr double kRidgeOvershootPx = 8.0;  // of an apparent ridge's line beyond the screen
const Vec2 kLetterHalf(4.5, 6.0);
// With more letters than this that do not fit beside the screen, as in a drawing of many strokes,
// those in one place are thinned out; fewer spill over.
constexpr std::size_t kLetteredMarks = 40;
constexpr double kEyePx = 15.0;  // half side of what an eye takes, the larger one of the canvas
constexpr double kTolerancePx = 0.02;  // of cubics standing for other curves

/// Builds the figure of one scene. The parts may come in any order (FlatLayers).
class Builder {
 public:
  Builder(const Scene& scene, const FeatureSet& features, const Visibility& visibility,
          const FlatFigureOptions& options)
      : scene_(scene),
        features_(features),
        visibility_(visibility),
        options_(options),
        colours_(sceneColours(options.palette)),
        frame_(frameOf(scene.view)),
        screen_(screenLine(scene, options.controlPolygon, options.screenOffset)),
        toFigure_(options.transform ? *options.transform : fittedTransform(scene, options)),
        axis_(frame_.axis.x(), -frame_.axis.y()),
        towards_(frame_.towards.x(), -frame_.towards.y()) {}

  Figure build() {
    addControlPolygons();
    addCurves();
    addScreen();
    crowded_ = !fitBesideScreen(lettersAtScreen());
    for (const Mark& mark : features_.marks) {
      if (shows(mark)) addMark(mark);
    }
    if (options_.letters) addLetters();
    addViewer();
    return assembled();
  }

 private:
  bool shows(const Mark& mark) const {
    return contains(options_.kinds, mark.kind) && (mark.visible || showsHidden());
  }
  bool showsHidden() const { return options_.hidden == FlatFigureOptions::Hidden::Pale; }
  Rgb shade(Rgb colour, bool visible) const {
    return visible ? colour : paler(colour, colours_.background);
  }

  /// A straight line, cut to the figure and a little beyond; nothing if it lies outside.
  void addLine(FigureGroup& to, Vec2 from, Vec2 end, const Stroke& stroke) const {
    constexpr double kBeyond = 20.0;
    // Liang and Barsky: the part of [0, 1] inside all four half planes.
    double enter = 0.0;
    double leave = 1.0;
    const Vec2 delta = end - from;
    const Vec2 size(options_.width, options_.height);
    for (int i = 0; i < 2; ++i) {
      const double low = -kBeyond - from[i];
      const double high = size[i] + kBeyond - from[i];
      if (delta[i] == 0.0) {
        if (low > 0.0 || high < 0.0) return;
        continue;
      }
      const double a = low / delta[i];
      const double b = high / delta[i];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    if (!(enter <= leave)) return;
    PathData path;
    path.moveTo(from + enter * delta);
    path.lineTo(from + leave * delta);
    to.shapes.emplace_back(PathShape{std::move(path), std::nullopt, stroke});
  }

  bool isInside(const Vec2& p) const {
    constexpr double kBeyond = 10.0;
    return p.x() > -kBeyond && p.y() > -kBeyond && p.x() < options_.width + kBeyond &&
           p.y() < options_.height + kBeyond;
  }

  void addControlPolygons() {
    if (!options_.controlPolygon) return;
    FigureGroup& to = layers_.group(FlatLayer::ControlPolygon);
    const Stroke line{.colour = colours_.controlPolygon, .width = 1.0};
    for (const SceneCurve& curve : scene_.curves) {
      const std::vector<Vec2>& points = controlPoints(curve.shape);
      if (points.empty()) continue;
      const std::size_t sides = isClosed(curve.shape) ? points.size() : points.size() - 1;
      for (std::size_t i = 0; i < sides; ++i) {
        addLine(to, toFigure_(points[i]), toFigure_(points[(i + 1) % points.size()]), line);
      }
      for (const Vec2& point : points) {
        const Vec2 at = toFigure_(point);
        if (!isInside(at)) continue;
        SymbolOutline square = symbolOutline(MarkSymbol::Square, at, 8.0, 0.0);
        to.shapes.emplace_back(
            PathShape{std::move(square.path), colours_.controlPolygon, std::nullopt});
      }
    }
  }

  /// Adds a piece to a path, without what lies outside the figure.
  void appendPiece(PathData& path, const Bezier& piece, Vec2& pen, int depth) const {
    Vec2 low = toFigure_(piece.points.front());
    Vec2 high = low;
    for (const Vec2& p : piece.points) {
      low = low.cwiseMin(toFigure_(p));
      high = high.cwiseMax(toFigure_(p));
    }
    const Vec2 size(options_.width, options_.height);
    if ((high.array() < -20.0).any() || (low.array() > size.array() + 20.0).any()) return;
    constexpr int kDepth = 40;  // each halving brings out a factor 2 of zoom
    if (depth < kDepth && (high - low).maxCoeff() > 4.0 * size.maxCoeff()) {
      const auto [first, second] = splitAt(piece, 0.5);
      appendPiece(path, first, pen, depth + 1);
      appendPiece(path, second, pen, depth + 1);
      return;
    }
    for (const Bezier& cubic : toCubics(piece, kTolerancePx / toFigure_.scale)) {
      const std::vector<Vec2>& p = cubic.points;
      const Vec2 start = toFigure_(p.front());
      const bool continues = !path.verbs.empty() && (start - pen).norm() < 1e-6;
      if (!continues) path.moveTo(start);
      switch (cubic.degree()) {
        case 1:
          path.lineTo(toFigure_(p[1]));
          break;
        case 3:
          path.cubicTo(toFigure_(p[1]), toFigure_(p[2]), toFigure_(p[3]));
          break;
        default: {  // degree 2, elevated
          const Bezier full = elevated(cubic);
          path.cubicTo(toFigure_(full.points[1]), toFigure_(full.points[2]),
                       toFigure_(full.points[3]));
        }
      }
      pen = toFigure_(p.back());
    }
  }

  void addCurvePart(int curve, double tLow, double tHigh, bool visible) {
    if (!(tLow < tHigh)) return;
    const Curve& shape = scene_.curves[static_cast<std::size_t>(curve)].shape;
    PathData path;
    Vec2 pen = Vec2::Zero();
    if (const BezierChain* chain = bezierForm(shape)) {
      for (int i = 0; i < chain->pieceCount(); ++i) {
        const double a = std::clamp(tLow - i, 0.0, 1.0);
        const double b = std::clamp(tHigh - i, 0.0, 1.0);
        if (!(a < b)) continue;
        Bezier piece = chain->piece(i);
        if (b < 1.0) piece = splitAt(piece, b).first;
        if (a > 0.0) piece = splitAt(piece, a / b).second;
        appendPiece(path, piece, pen, 0);
      }
    } else {
      const double tolerance = kTolerancePx / toFigure_.scale;
      for (const CubicStretch& stretch : cubicsWithin(shape, tLow, tHigh, tolerance)) {
        appendPiece(path, stretch.cubic, pen, 0);
      }
    }
    if (path.verbs.empty()) return;
    const bool whole = isClosed(shape) && tLow <= 0.0 && tHigh >= pieceCount(shape);
    if (whole && (path.points.front() - path.points.back()).norm() < 1e-6) path.close();
    layers_.group(FlatLayer::Curve, visible)
        .shapes.emplace_back(PathShape{std::move(path), std::nullopt,
                                       Stroke{.colour = shade(colours_.curve, visible),
                                              .width = kCurveWidthPx,
                                              .roundCaps = true}});
  }

  void addCurves() {
    for (int curve = 0; curve < static_cast<int>(scene_.curves.size()); ++curve) {
      const double end = pieceCount(scene_.curves[static_cast<std::size_t>(curve)].shape);
      double hiddenFrom = 0.0;
      for (const Visibility::Interval& seen : visibility_.visibleIntervals(curve)) {
        if (showsHidden()) addCurvePart(curve, hiddenFrom, seen.tLow, false);
        addCurvePart(curve, seen.tLow, seen.tHigh, true);
        addImage(curve, seen);
        hiddenFrom = seen.tHigh;
      }
      if (showsHidden()) addCurvePart(curve, hiddenFrom, end, false);
    }
  }

  /// A place on the drawn screen, px.
  Vec2 onScreen(double s) const {
    return toFigure_(s * frame_.axis + screen_.offset * frame_.towards);
  }

  std::optional<double> screenPlace(const Vec2& point) const {
    const std::optional<Vec2> seen = pointOnScreen(frame_, screen_, point);
    if (!seen) return std::nullopt;
    return seen->dot(frame_.axis);
  }

  void addScreen() {
    addLine(layers_.group(FlatLayer::Screen), onScreen(screen_.low), onScreen(screen_.high),
            {.colour = colours_.screen, .width = kScreenWidthPx, .roundCaps = true});
  }

  /// What a visible part of a curve covers of the screen.
  void addImage(int curve, const Visibility::Interval& seen) {
    constexpr int kSamples = 32;
    const Curve& shape = scene_.curves[static_cast<std::size_t>(curve)].shape;
    std::optional<double> low;
    std::optional<double> high;
    for (int i = 0; i <= kSamples; ++i) {
      const double f = static_cast<double>(i) / kSamples;
      const double t = (1.0 - f) * seen.tLow + f * seen.tHigh;
      if (const std::optional<double> s = screenPlace(pointAt(shape, t))) {
        low = std::min(low.value_or(*s), *s);
        high = std::max(high.value_or(*s), *s);
      }
    }
    if (!low) return;
    const double a = std::clamp(*low, screen_.low, screen_.high);
    const double b = std::clamp(*high, screen_.low, screen_.high);
    if (a < b) {
      addLine(layers_.group(FlatLayer::Image), onScreen(a), onScreen(b),
              {.colour = colours_.screen, .width = kImageWidthPx});
    }
  }

  /// Direction across the curve at a mark, in the figure; towards the viewer where it has none.
  double acrossRad(const Mark& mark) const {
    const Vec2 d1 = jetAt(scene_.curves[static_cast<std::size_t>(mark.curve)].shape, mark.t).d1;
    if (d1.norm() == 0.0) return std::atan2(towards_.y(), towards_.x());
    return std::atan2(-d1.x(), -d1.y());  // (-d1.y, d1.x) with y turned down
  }

  void addMark(const Mark& mark) {
    const MarkStyle& style = styleOf(mark.kind, options_.palette);
    const Vec2 at = toFigure_(mark.point);
    if (isInside(at)) {
      layers_.group(FlatLayer::Marks, mark)
          .shapes.emplace_back(markSymbol(mark.kind, at, kSymbolSizePx, acrossRad(mark),
                                          options_.palette, !mark.visible));
    }
    const std::optional<double> s = placeOnDrawnScreen(mark);
    if (!s) return;
    const Vec2 seen = onScreen(*s);
    const Rgb colour = shade(style.colour, mark.visible);
    const Stroke ray{
        .colour = colour, .width = style.lineWidth, .dash = style.dash, .roundCaps = true};
    const Vec2 along = (seen - at).normalized();
    if (mark.visible || !crowded_) addLine(layers_.group(FlatLayer::Rays, mark), at, seen, ray);
    if (mark.kind == MarkKind::ApparentRidge) {
      addLine(layers_.group(FlatLayer::Marks, mark), seen, seen + kRidgeOvershootPx * along, ray);
    } else if (isInside(seen)) {
      layers_.group(FlatLayer::Marks, mark)
          .shapes.emplace_back(markSymbol(mark.kind, seen, kScreenSymbolPx,
                                          std::atan2(towards_.y(), towards_.x()), options_.palette,
                                          !mark.visible));
    }
    if (frame_.distance && mark.visible && showsViewer(scene_, screen_)) {
      addLine(layers_.group(FlatLayer::Sight), seen, toFigure_(frame_.eye()),
              {.colour = colours_.faint, .width = 0.8});
    }
  }

  /// Where on the screen the mark is seen, if the screen is drawn there.
  std::optional<double> placeOnDrawnScreen(const Mark& mark) const {
    const std::optional<double> s = screenPlace(mark.point);
    return s && *s >= screen_.low && *s <= screen_.high ? s : std::nullopt;
  }

  bool getsLetter(const Mark& mark) const { return shows(mark) && (mark.visible || !crowded_); }

  TextShape letterOf(const Mark& mark, const Vec2& position) const {
    const MarkStyle& style = styleOf(mark.kind, options_.palette);
    return {.position = position,
            .text = std::string(1, style.letter),
            .size = kLetterPx,
            .colour = shade(style.letterColour, mark.visible),
            .bold = true};
  }

  /// Keeps letters off a curve, as far as it is in the figure.
  void discourageCurve(LabelPlacer& placer, const SceneCurve& curve) const {
    constexpr double kStepPx = 3.0;
    constexpr double kMostSteps =
        200.0;  // between samples; beyond, the zoom is high and they are few
    const std::vector<Vec2> samples = sampledPoints(curve);
    for (std::size_t i = 1; i < samples.size(); ++i) {
      const Vec2 from = toFigure_(samples[i - 1]);
      const Vec2 to = toFigure_(samples[i]);
      const double steps = std::clamp(std::ceil((to - from).norm() / kStepPx), 1.0, kMostSteps);
      for (double step = 0.0; step < steps; ++step) {
        const Vec2 at = from + step / steps * (to - from);
        if (isInside(at)) placer.discourage(at);
      }
    }
  }

  /// Those at the screen come first: they have one place only, those at the curve have many.
  void addLetters() {
    LabelPlacer placer;
    for (const Mark& mark : features_.marks) {
      if (!shows(mark)) continue;
      const Vec2 at = toFigure_(mark.point);
      if (isInside(at)) placer.block(at, Vec2::Constant(0.55 * kSymbolSizePx));
      const std::optional<double> s = placeOnDrawnScreen(mark);
      if (s && isInside(onScreen(*s)))
        placer.block(onScreen(*s), Vec2::Constant(0.55 * kScreenSymbolPx));
    }
    if (options_.eye) {
      placer.block(*options_.eye, Vec2::Constant(kEyePx));
    } else if (showsViewer(scene_, screen_) && isInside(toFigure_(frame_.eye()))) {
      placer.block(toFigure_(frame_.eye()), Vec2::Constant(kEyePx));
    }
    addLettersAtScreen(placer);
    addLettersAtCurve(placer);
  }

  void addLettersAtCurve(LabelPlacer& placer) {
    for (const SceneCurve& curve : scene_.curves) discourageCurve(placer, curve);
    std::vector<const Mark*> marks;
    for (const Mark& mark : features_.marks) {
      const Vec2 at = toFigure_(mark.point);
      if (!getsLetter(mark) || !isInside(at)) continue;
      marks.push_back(&mark);
      // The start of the line to the screen, as far as letters go.
      for (double along = 8.0; along < 34.0; along += 3.0) placer.discourage(at + along * towards_);
    }
    // What is seen takes the best places.
    std::stable_partition(marks.begin(), marks.end(), [](const Mark* m) { return m->visible; });
    for (const Mark* mark : marks) {
      const Vec2 at = toFigure_(mark->point);
      if (const auto place = placer.placeFree(at, kLetterHalf, -towards_))
        layers_.group(FlatLayer::Letters, *mark).shapes.emplace_back(letterOf(*mark, *place));
    }
  }

  struct Letter {
    const Mark* mark;
    double at;  // px along the screen
  };

  /// Leaves, of letters nearer than `gap` to each other, the first of its family in the legend.
  static void thinOut(std::vector<Letter>& letters, double gap) {
    const auto& order = markKindsInLegendOrder();
    const auto rank = [&order](const Letter& letter) {
      return std::find(order.begin(), order.end(), letter.mark->kind) - order.begin();
    };
    std::stable_sort(letters.begin(), letters.end(),
                     [&](const Letter& a, const Letter& b) { return rank(a) < rank(b); });
    std::vector<Letter> kept;
    for (const Letter& letter : letters) {
      const bool isFree = std::none_of(kept.begin(), kept.end(), [&](const Letter& other) {
        return std::abs(other.at - letter.at) < gap;
      });
      if (isFree) kept.push_back(letter);
    }
    letters = std::move(kept);
  }

  std::vector<Letter> lettersAtScreen() const {
    std::vector<Letter> letters;
    for (const Mark& mark : features_.marks) {
      if (!getsLetter(mark)) continue;
      const std::optional<double> s = placeOnDrawnScreen(mark);
      if (s && isInside(onScreen(*s))) letters.push_back({&mark, *s * toFigure_.scale});
    }
    return letters;
  }

  /// Between letters along the screen. Upright ones need less room side by side than one above the
  /// other.
  double letterGap() const {
    return std::min(2.0 * kLetterHalf.x() / std::max(std::abs(axis_.x()), 1e-9),
                    2.0 * kLetterHalf.y() / std::max(std::abs(axis_.y()), 1e-9)) +
           1.0;
  }

  bool fitBesideScreen(const std::vector<Letter>& letters) const {
    const double room = (screen_.high - screen_.low) * toFigure_.scale;
    return static_cast<double>(letters.size()) * letterGap() <= room;
  }

  void addLettersAtScreen(LabelPlacer& placer) {
    std::vector<Letter> letters = lettersAtScreen();
    const double unit = toFigure_.scale;
    const double gap = letterGap();
    if (letters.size() > kLetteredMarks && !fitBesideScreen(letters)) thinOut(letters, gap);
    std::stable_sort(letters.begin(), letters.end(),
                     [](const Letter& a, const Letter& b) { return a.at < b.at; });
    std::vector<double> wanted;
    wanted.reserve(letters.size());
    for (const Letter& letter : letters) wanted.push_back(letter.at);
    const std::vector<double> placed = spreadApart(wanted, gap);
    for (std::size_t i = 0; i < letters.size(); ++i) {
      const Vec2 seen = onScreen(wanted[i] / unit);
      const Vec2 place = onScreen(placed[i] / unit) + kLetterOffPx * towards_;
      if (!placer.isFree(place, kLetterHalf)) continue;
      placer.block(place, kLetterHalf);
      FigureGroup& to = layers_.group(FlatLayer::Letters, *letters[i].mark);
      constexpr double kLeaderFromPx = 4.0;  // displaced by more, a letter gets a leader
      if (std::abs(placed[i] - wanted[i]) > kLeaderFromPx) {
        const MarkStyle& style = styleOf(letters[i].mark->kind, options_.palette);
        addLine(to, seen + 4.0 * towards_, place - 6.0 * towards_,
                {.colour = shade(style.colour, letters[i].mark->visible), .width = 0.8});
      }
      to.shapes.emplace_back(letterOf(*letters[i].mark, place));
    }
  }

  /// An eye that looks at the scene: a ball with the pupil in front.
  void addViewer() {
    constexpr double kBallPx = 8.0;
    constexpr double kPupilPx = 3.4;
    if (!showsViewer(scene_, screen_)) return;
    const Vec2 eye = toFigure_(frame_.eye());
    if (!isInside(eye)) return;
    PathData ball;
    ball.addCircle(eye, kBallPx);
    PathData pupil;
    pupil.addCircle(eye - (kBallPx - kPupilPx) * towards_, kPupilPx);
    FigureGroup& to = layers_.group(FlatLayer::Viewer);
    to.shapes.emplace_back(PathShape{std::move(ball), colours_.background,
                                     Stroke{.colour = colours_.text, .width = 1.5}});
    to.shapes.emplace_back(PathShape{std::move(pupil), colours_.text, std::nullopt});
  }

  Figure assembled() {
    Figure figure{
        .width = options_.width, .height = options_.height, .background = {}, .groups = {}};
    if (!options_.transparent) figure.background = colours_.background;
    figure.groups = layers_.taken();
    FigureGroup legendGroup = legend(scene_, options_);
    if (!legendGroup.shapes.empty()) figure.groups.push_back(std::move(legendGroup));
    return figure;
  }

  const Scene& scene_;
  const FeatureSet& features_;
  const Visibility& visibility_;
  const FlatFigureOptions& options_;
  const SceneColours& colours_;
  ViewFrame frame_;
  ScreenLine screen_;
  FigureTransform toFigure_;
  Vec2 axis_, towards_;   // of the view, in the figure
  bool crowded_ = false;  // the letters do not all fit beside the screen
  FlatLayers layers_;
};

}  // namespace

Figure flatFigure(const Scene& scene, const FeatureSet& features, const Visibility& visibility,
                  const FlatFigureOptions& options) {
  if (options.scale == 1.0) return Builder(scene, features, visibility, options).build();
  // Small, then magnified: so everything grows alike.
  const FlatFigureOptions small = atUnitScale(options);
  return magnified(Builder(scene, features, visibility, small).build(), options.scale);
}

}  // namespace flatland::ui
