// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/flat_figure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/support/random_scene.h"

namespace flatland::ui {
namespace {

// A pixel's thousandth: placing on the figure involves a few roundings at sizes of a thousand px.
constexpr double kPx = 1e-3;

Figure figureOf(const Scene& scene, const FlatFigureOptions& options = {}) {
  return flatFigure(scene, findFeatures(scene), Visibility(scene), options);
}

Scene preset(const std::string& id) {
  const auto found = std::find_if(presets().begin(), presets().end(),
                                  [&id](const Preset& p) { return p.id == id; });
  EXPECT_NE(found, presets().end());
  return found->scene;
}

const FigureGroup* groupOf(const Figure& figure, const std::string& id) {
  const FigureGroup* found = nullptr;
  for (const FigureGroup& group : figure.groups) {
    if (group.id != id) continue;
    EXPECT_EQ(found, nullptr) << "two groups " << id;
    found = &group;
  }
  return found;
}

/// Middle of a path's points: of a symbol, its centre.
Vec2 middleOf(const PathShape& shape) {
  Vec2 low = shape.path.points.front();
  Vec2 high = low;
  for (const Vec2& p : shape.path.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return 0.5 * (low + high);
}

std::vector<PathShape> pathsOf(const FigureGroup& group) {
  std::vector<PathShape> paths;
  for (const Shape& shape : group.shapes) {
    if (const auto* path = std::get_if<PathShape>(&shape)) paths.push_back(*path);
  }
  return paths;
}

int letterCount(const Figure& figure, const std::string& id) {
  const FigureGroup* group = groupOf(figure, id);
  if (group == nullptr) return 0;
  return static_cast<int>(
      std::count_if(group->shapes.begin(), group->shapes.end(),
                    [](const Shape& s) { return std::holds_alternative<TextShape>(s); }));
}

TEST(MarkStyles, AreToldApartWithoutColour) {
  std::set<char> letters;
  std::set<MarkSymbol> symbols;
  for (const MarkKind kind : markKindsInLegendOrder()) {
    letters.insert(styleOf(kind).letter);
    symbols.insert(styleOf(kind).symbol);
    EXPECT_EQ(styleOf(kind, Palette::Dark).letter, styleOf(kind).letter);
    EXPECT_EQ(styleOf(kind, Palette::Dark).symbol, styleOf(kind).symbol);
  }
  EXPECT_EQ(letters.size(), static_cast<std::size_t>(kMarkKindCount));
  EXPECT_EQ(symbols.size(), static_cast<std::size_t>(kMarkKindCount));
  EXPECT_EQ(styleOf(MarkKind::ApparentRidge).letter, 'a');
  EXPECT_EQ(styleOf(MarkKind::Valley).letter, 'v');
}

double luminance(Rgb c) {
  const auto linear = [](std::uint8_t channel) {
    const double v = channel / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}

TEST(MarkStyles, LettersReachTheContrastOfWcag) {
  for (const Palette palette : {Palette::Light, Palette::Dark}) {
    const double background = luminance(sceneColours(palette).background);
    for (const MarkKind kind : markKindsInLegendOrder()) {
      const double letter = luminance(styleOf(kind, palette).letterColour);
      const double ratio =
          (std::max(letter, background) + 0.05) / (std::min(letter, background) + 0.05);
      EXPECT_GE(ratio, 4.5) << nameOf(kind) << (palette == Palette::Light ? " light" : " dark");
    }
  }
}

TEST(MarkStyles, FlatPointsAndMinimaAreOffAtFirst) {
  const MarkKinds kinds = defaultMarkKinds();
  EXPECT_EQ(kinds.count(), 6U);
  EXPECT_FALSE(contains(kinds, MarkKind::Flat));
  EXPECT_FALSE(contains(kinds, MarkKind::ApparentMinimum));
}

TEST(ScreenLine, StandsBeyondTheCurveOnTheViewersSide) {
  test::Random random(test::announcedSeed("screen line", 20070503));
  for (int run = 0; run < 200; ++run) {
    std::vector<Vec2> points;
    for (int i = 0; i < 5; ++i) {
      points.emplace_back(test::uniform(random, -1, 1), test::uniform(random, -1, 1));
    }
    Scene scene{{{BezierChain(Bezier{points})}}, {test::uniform(random, -180, 180), {}}};
    if (run % 2 == 1) scene.view.distance = 12.0;  // clear of the curve
    const ViewFrame frame = frameOf(scene.view);
    const ScreenLine screen = screenLine(scene, true);
    for (const Vec2& p : points) EXPECT_LT(p.dot(frame.towards), screen.offset);
    if (frame.distance) {
      EXPECT_LT(screen.offset, *frame.distance);
    }
    for (int i = 0; i <= 20; ++i) {
      const Vec2 p = pointAt(scene.curves[0].chain(), i / 20.0);
      const std::optional<Vec2> seen = pointOnScreen(frame, screen, p);
      ASSERT_TRUE(seen);
      EXPECT_NEAR(seen->dot(frame.towards), screen.offset, 1e-12);
      EXPECT_GE(seen->dot(frame.axis), screen.low);
      EXPECT_LE(seen->dot(frame.axis), screen.high);
      // On the line of sight: from the point towards the viewer.
      EXPECT_NEAR(cross(*seen - p, towardsViewer(frame, p)), 0.0, 1e-12);
      EXPECT_GT((*seen - p).dot(towardsViewer(frame, p)), 0.0);
    }
  }
}

TEST(ScreenLine, GivesTheScreenCoordinatesUpToOneScale) {
  Scene scene = preset("thesis");
  scene.view = {20.0, 9.0};
  const ViewFrame frame = frameOf(scene.view);
  const ScreenLine screen = screenLine(scene, false);
  const double scale =
      (9.0 - screen.offset) / 9.0;  // the coordinate refers to the line through the origin
  for (int i = 0; i <= 10; ++i) {
    const Vec2 p = pointAt(scene.curves[0].chain(), i / 10.0);
    EXPECT_NEAR(pointOnScreen(frame, screen, p)->dot(frame.axis),
                scale * *screenCoordinate(frame, p), 1e-12);
  }
  EXPECT_FALSE(pointOnScreen(frame, screen, 9.5 * frame.towards));
}

TEST(FlatFigure, EveryDefaultMarkIsOnCurveAndScreen) {
  const Scene scene = defaultScene();
  const FlatFigureOptions options;
  const Figure figure = figureOf(scene, options);
  const FigureTransform toFigure = fittedTransform(scene, options);
  const ViewFrame frame = frameOf(scene.view);
  const ScreenLine screen = screenLine(scene, false);
  int checked = 0;
  for (const Mark& mark : findFeatures(scene).marks) {
    if (!contains(options.kinds, mark.kind)) continue;
    const std::string suffix = std::string(nameOf(mark.kind)) + (mark.visible ? "" : "-hidden");
    const FigureGroup* marks = groupOf(figure, "marks-" + suffix);
    ASSERT_NE(marks, nullptr) << suffix;
    const Vec2 onCurve = toFigure(mark.point);
    const Vec2 onScreen = toFigure(*pointOnScreen(frame, screen, mark.point));
    EXPECT_GT(onScreen.x(), onCurve.x()) << "angle 0 has the screen at the right";
    EXPECT_NEAR(onScreen.y(), onCurve.y(), kPx);
    bool curveFound = false;
    bool screenFound = false;
    for (const PathShape& shape : pathsOf(*marks)) {
      curveFound = curveFound || (middleOf(shape) - onCurve).norm() < 2.0;
      screenFound = screenFound || (middleOf(shape) - onScreen).norm() < 5.0;
    }
    EXPECT_TRUE(curveFound) << suffix;
    EXPECT_TRUE(screenFound) << suffix;
    const FigureGroup* rays = groupOf(figure, "rays-" + suffix);
    ASSERT_NE(rays, nullptr);
    bool rayFound = false;
    for (const PathShape& ray : pathsOf(*rays)) {
      rayFound = rayFound || ((ray.path.points.front() - onCurve).norm() < kPx &&
                              (ray.path.points.back() - onScreen).norm() < kPx);
      EXPECT_EQ(ray.stroke->dash.empty(), mark.kind == MarkKind::ApparentRidge);
    }
    EXPECT_TRUE(rayFound) << suffix;
    ++checked;
  }
  EXPECT_GE(checked, 8) << "the default scene shows every kind";
}

TEST(FlatFigure, CrowdedLettersAreThinnedOut) {
  // Twenty-five small copies of the default curve, as a drawing of many strokes has them.
  Scene crowd = defaultScene();
  const SceneCurve one = crowd.curves.front();
  crowd.curves.clear();
  for (int i = 0; i < 25; ++i) {
    crowd.curves.push_back(one);
    crowd.curves.back().shape = translated(one.shape, Vec2(2.2 * (i % 5), 2.4 * (i / 5)));
  }
  FlatFigureOptions small;
  small.width = 320.0;
  small.height = 240.0;
  small.legend = false;
  const Figure figure = figureOf(crowd, small);
  std::vector<Vec2> letters;
  for (const FigureGroup& group : figure.groups) {
    for (const Shape& shape : group.shapes) {
      if (const auto* text = std::get_if<TextShape>(&shape)) letters.push_back(text->position);
    }
  }
  EXPECT_GT(letters.size(), 10u);
  EXPECT_LT(letters.size(), 25u * 12u / 2u) << "there are about twelve marks on each";
  for (std::size_t i = 0; i < letters.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vec2 apart = (letters[i] - letters[j]).cwiseAbs();
      EXPECT_TRUE(apart.x() > 9.0 - kPx || apart.y() > 12.0 - kPx);
    }
  }
  // Hidden marks keep their symbols and lose letters and projecting lines.
  int symbols = 0;
  for (const FigureGroup& group : figure.groups) {
    if (!group.id.ends_with("-hidden")) continue;
    EXPECT_NE(group.id.rfind("letters-", 0), 0u) << group.id;
    EXPECT_NE(group.id.rfind("rays-", 0), 0u) << group.id;
    if (group.id.rfind("marks-", 0) == 0) ++symbols;
  }
  EXPECT_GT(symbols, 0);
}

TEST(FlatFigure, LettersKeepClearOfSymbolsAndOfTheEye) {
  const Vec2 half(4.5, 6.0);
  int left = 0, all = 0;
  for (const Preset& preset : presets()) {
    for (const double scale : {1.0, 2.0}) {
      Scene scene = preset.scene;
      FlatFigureOptions options;
      options.width = 260.0 * scale;
      options.height = 200.0 * scale;
      options.legend = false;
      options.scale = scale;
      const auto lettersOf = [&] {
        std::vector<Vec2> letters;
        for (const FigureGroup& group : figureOf(scene, options).groups) {
          for (const Shape& shape : group.shapes) {
            if (const auto* text = std::get_if<TextShape>(&shape)) {
              letters.push_back(text->position / scale);
            }
          }
        }
        return letters;
      };
      const std::vector<Vec2> before = lettersOf();
      if (before.empty()) continue;
      // An eye where a letter stood.
      const Vec2 eye = before[before.size() / 2];
      options.eye = scale * eye;
      const std::vector<Vec2> letters = lettersOf();
      for (const Vec2& letter : letters) {
        const Vec2 apart = (letter - eye).cwiseAbs() - half;
        EXPECT_GE(apart.maxCoeff(), 15.0 - kPx) << preset.id;
      }
      const FigureTransform toFigure = fittedTransform(scene, options);
      for (const Mark& mark : findFeatures(scene).marks) {
        if (!contains(options.kinds, mark.kind)) continue;
        const Vec2 at = toFigure(mark.point) / scale;
        for (const Vec2& letter : letters) {
          EXPECT_GT(((letter - at).cwiseAbs() - half).maxCoeff(), 4.0) << preset.id;
        }
      }
      all += static_cast<int>(before.size());
      left += static_cast<int>(letters.size());
    }
  }
  EXPECT_GT(left, all / 2) << "most are still there";
}

TEST(FlatFigure, LettersStandTwiceForEachMark) {
  const Scene scene = defaultScene();
  const Figure figure = figureOf(scene);
  for (const MarkKind kind : {MarkKind::Silhouette, MarkKind::Ridge, MarkKind::ApparentRidge,
                              MarkKind::Inflection, MarkKind::Valley}) {
    int marks = 0;
    for (const Mark& mark : findFeatures(scene).marks) {
      if (mark.kind == kind && mark.visible) ++marks;
    }
    EXPECT_GT(marks, 0) << nameOf(kind);
    EXPECT_EQ(letterCount(figure, "letters-" + std::string(nameOf(kind))), 2 * marks)
        << nameOf(kind);
  }
}

TEST(FlatFigure, NoTwoLettersOverlapInThePresets) {
  for (const Preset& preset : presets()) {
    for (double angle = 0.0; angle < 360.0; angle += 30.0) {
      Scene scene = preset.scene;
      scene.view.angleDeg = angle;
      std::vector<Vec2> letters;
      for (const FigureGroup& group : figureOf(scene).groups) {
        if (group.id.rfind("letters-", 0) != 0) continue;
        for (const Shape& shape : group.shapes) {
          if (const auto* text = std::get_if<TextShape>(&shape)) letters.push_back(text->position);
        }
      }
      for (std::size_t i = 0; i < letters.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          const Vec2 apart = (letters[i] - letters[j]).cwiseAbs();
          // The body of a lower-case letter of this size is about 7 x 7 px.
          EXPECT_TRUE(apart.x() > 7.0 || apart.y() > 7.0) << preset.id << " seen from " << angle;
        }
      }
    }
  }
}

TEST(FlatFigure, EverythingIsWithinTheFigure) {
  test::Random random(test::announcedSeed("flat figure", 20070504));
  for (int run = 0; run < 200; ++run) {
    std::vector<Vec2> points;
    const double size = std::pow(10.0, test::uniform(random, -6.0, 6.0));
    const Vec2 centre = size * Vec2(test::uniform(random, -3, 3), test::uniform(random, -3, 3));
    for (int i = 0; i < 5; ++i) {
      points.push_back(centre +
                       size * Vec2(test::uniform(random, -1, 1), test::uniform(random, -1, 1)));
    }
    Scene scene{{{BezierChain(Bezier{points})}}, {test::uniform(random, -180, 180), {}}};
    FlatFigureOptions options;
    options.controlPolygon = run % 3 == 0;
    options.kinds.set();
    options.width = test::uniformInt(random, 300, 1200);
    options.height = test::uniformInt(random, 300, 1200);
    if (run % 2 == 1) scene.view.distance = size * test::uniform(random, 8.0, 20.0);
    for (const FigureGroup& group : figureOf(scene, options).groups) {
      for (const Shape& shape : group.shapes) {
        std::vector<Vec2> extent;
        if (const auto* path = std::get_if<PathShape>(&shape)) extent = path->path.points;
        if (const auto* text = std::get_if<TextShape>(&shape)) extent = {text->position};
        // Cubic handles may lie a little outside their curve.
        const double slack = group.id.rfind("curve", 0) == 0 ? 100.0 : 1.0;
        for (const Vec2& p : extent) {
          EXPECT_TRUE(p.x() >= -slack && p.y() >= -slack && p.x() <= options.width + slack &&
                      p.y() <= options.height + slack)
              << group.id << " at " << p.transpose();
        }
      }
    }
  }
}

TEST(FlatFigure, TheCurveIsDrawnWhereItIs) {
  const Scene scene = preset("loop");
  const FlatFigureOptions options;
  const FigureTransform toFigure = fittedTransform(scene, options);
  const Figure figure = figureOf(scene, options);
  const FigureGroup* seen = groupOf(figure, "curve");
  const FigureGroup* hidden = groupOf(figure, "curve-hidden");
  ASSERT_NE(seen, nullptr);
  ASSERT_NE(hidden, nullptr);
  const Visibility visibility(scene);
  for (const FigureGroup* group : {seen, hidden}) {
    for (const PathShape& shape : pathsOf(*group)) {
      for (const Vec2& end : {shape.path.points.front(), shape.path.points.back()}) {
        const Vec2 world((end.x() - toFigure.origin.x()) / toFigure.scale,
                         -(end.y() - toFigure.origin.y()) / toFigure.scale);
        EXPECT_LT(nearestPoint(scene.curves[0].chain(), world).distance * toFigure.scale, 0.1);
      }
      // The middle of the path's first cubic is seen, or is not.
      ASSERT_GE(shape.path.points.size(), 4U);
      const Vec2* p = shape.path.points.data();
      const Vec2 middle = (p[0] + 3.0 * p[1] + 3.0 * p[2] + p[3]) / 8.0;
      const Vec2 world((middle.x() - toFigure.origin.x()) / toFigure.scale,
                       -(middle.y() - toFigure.origin.y()) / toFigure.scale);
      const Nearest nearest = nearestPoint(scene.curves[0].chain(), world);
      EXPECT_LT(nearest.distance * toFigure.scale, 0.1);
      EXPECT_EQ(visibility.isVisible(0, nearest.t), group == seen);
    }
  }
}

TEST(FlatFigure, OptionsDoWhatTheySay) {
  const Scene scene = preset("circle");
  const auto has = [&scene](const FlatFigureOptions& options, const std::string& id) {
    return groupOf(figureOf(scene, options), id) != nullptr;
  };
  FlatFigureOptions options;
  EXPECT_TRUE(has(options, "curve-hidden"));
  EXPECT_TRUE(has(options, "marks-ridge-hidden"));
  EXPECT_TRUE(has(options, "legend"));
  EXPECT_TRUE(has(options, "letters-ridge"));
  EXPECT_FALSE(has(options, "control-polygon"));
  EXPECT_EQ(figureOf(scene, options).background, sceneColours(Palette::Light).background);

  options.hidden = FlatFigureOptions::Hidden::Remove;
  options.legend = false;
  options.letters = false;
  options.controlPolygon = true;
  options.transparent = true;
  EXPECT_FALSE(has(options, "curve-hidden"));
  EXPECT_FALSE(has(options, "marks-ridge-hidden"));
  EXPECT_FALSE(has(options, "legend"));
  EXPECT_FALSE(has(options, "letters-ridge"));
  EXPECT_TRUE(has(options, "control-polygon"));
  EXPECT_TRUE(has(options, "marks-ridge"));
  EXPECT_FALSE(figureOf(scene, options).background);

  options.kinds.reset();
  EXPECT_FALSE(has(options, "marks-ridge"));
  EXPECT_FALSE(has(options, "rays-silhouette"));
  EXPECT_TRUE(has(options, "curve"));
}

TEST(FlatFigure, HiddenIsPaler) {
  const Rgb background = sceneColours(Palette::Light).background;
  const Figure figure = figureOf(preset("circle"));
  const auto strokeOf = [&figure](const std::string& id) {
    const FigureGroup* group = groupOf(figure, id);
    EXPECT_NE(group, nullptr) << id;
    return pathsOf(*group).front().stroke->colour;
  };
  EXPECT_EQ(strokeOf("curve-hidden"), paler(strokeOf("curve"), background));
  EXPECT_EQ(strokeOf("rays-ridge-hidden"), paler(strokeOf("rays-ridge"), background));
  EXPECT_GT(luminance(strokeOf("curve-hidden")), luminance(strokeOf("curve")));
}

TEST(FlatFigure, TheViewerIsShownWhenNear) {
  Scene scene = preset("thesis");
  EXPECT_EQ(groupOf(figureOf(scene), "viewer"), nullptr);
  scene.view.distance = 5.0;
  const Figure nearby = figureOf(scene);
  EXPECT_NE(groupOf(nearby, "viewer"), nullptr);
  EXPECT_NE(groupOf(nearby, "sight"), nullptr);
  scene.view.distance = 500.0;
  EXPECT_EQ(groupOf(figureOf(scene), "viewer"), nullptr);
}

TEST(FlatFigure, AViewportOfAnyZoomStaysSmallAndFinite) {
  const Scene scene = defaultScene();
  const ViewFrame frame = frameOf(scene.view);
  const std::vector<Mark> marks = findFeatures(scene).marks;
  const auto ridge = std::find_if(marks.begin(), marks.end(), [](const Mark& mark) {
    return mark.kind == MarkKind::Ridge && mark.visible;
  });
  ASSERT_NE(ridge, marks.end());
  const Vec2 onScreen = *pointOnScreen(frame, screenLine(scene, false), ridge->point);
  // What passes through the middle of the figure, and so must be drawn at any zoom.
  struct Target {
    std::string group;
    Vec2 middle;
  };
  for (const Target& target :
       {Target{"curve", pointAt(scene.curves[0].chain(), 0.4)},
        Target{"rays-ridge", 0.5 * (ridge->point + onScreen)}, Target{"screen", onScreen}}) {
    for (const double scale : {1e-3, 1.0, 1e3, 1e6, 1e9}) {
      FlatFigureOptions options;
      options.legend = false;
      options.transform = FigureTransform{
          scale, Vec2(320.0 - scale * target.middle.x(), 240.0 + scale * target.middle.y())};
      const Figure figure = figureOf(scene, options);
      std::size_t points = 0;
      for (const FigureGroup& group : figure.groups) {
        for (const PathShape& shape : pathsOf(group)) {
          for (const Vec2& p : shape.path.points) {
            EXPECT_TRUE(p.allFinite());
            EXPECT_LT(p.cwiseAbs().maxCoeff(), 1e4) << group.id << " at scale " << scale;
            ++points;
          }
        }
      }
      EXPECT_LT(points, 2000U);
      EXPECT_NE(groupOf(figure, target.group), nullptr) << target.group << " at scale " << scale;
    }
  }
}

TEST(FlatFigure, DegenerateScenesHaveAPicture) {
  const Scene nothing;
  const Scene onePoint{{{BezierChain(Bezier{{{2, 3}, {2, 3}}})}}, {}};
  const Scene endOn{{{BezierChain(Bezier{{{0, 0}, {1, 0}}})}}, {}};
  const Scene behind{{{BezierChain(Bezier{{{5, 0}, {6, 1}}})}}, {0.0, 2.0}};
  for (const Scene& scene : {nothing, onePoint, endOn, behind}) {
    const Figure figure = figureOf(scene);
    EXPECT_NE(groupOf(figure, "screen"), nullptr);
    for (const FigureGroup& group : figure.groups) {
      for (const PathShape& shape : pathsOf(group)) {
        for (const Vec2& p : shape.path.points) EXPECT_TRUE(p.allFinite()) << group.id;
      }
    }
  }
}

}  // namespace
}  // namespace flatland::ui
