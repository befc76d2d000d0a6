// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/figure_cells.h"

#include <gtest/gtest.h>

#include <set>

namespace flatland::ui {
namespace {

Figure figureOf(double width, double height, std::vector<Shape> shapes) {
  Figure figure;
  figure.width = width;
  figure.height = height;
  figure.background = Rgb{1, 2, 3};
  figure.groups.push_back({"lines", "lines", std::move(shapes)});
  return figure;
}

PathShape polyline(const std::vector<Vec2>& points, bool closed = false) {
  PathShape shape;
  shape.stroke = Stroke{};
  shape.path.moveTo(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) shape.path.lineTo(points[i]);
  if (closed) shape.path.close();
  return shape;
}

double lengthOf(const PathData& path) {
  double length = 0.0;
  std::size_t next = 0;
  Vec2 at = Vec2::Zero(), first = Vec2::Zero();
  for (const auto verb : path.verbs) {
    const Vec2 to = verb == PathData::Verb::Close ? first : path.points[next++];
    if (verb == PathData::Verb::MoveTo) {
      first = to;
    } else {
      length += (to - at).norm();
    }
    at = to;
  }
  return length;
}

const PathData& pathOf(const Figure& figure, std::size_t group, std::size_t shape = 0) {
  return std::get<PathShape>(figure.groups.at(group).shapes.at(shape)).path;
}

TEST(FigureCells, PlacesFillThePictureAndDoNotOverlap) {
  for (const std::size_t count : {2u, 3u, 4u}) {
    std::vector<CellPlace> places;
    for (std::size_t i = 0; i < count; ++i) places.push_back(cellPlace(i, count, 800, 600));
    double right = 0.0, bottom = 0.0;
    for (const CellPlace& place : places) {
      EXPECT_EQ(place.width, places[0].width);
      EXPECT_EQ(place.height, places[0].height);
      EXPECT_GE(place.top - place.titleHeight, 0.0);
      right = std::max(right, place.left + place.width);
      bottom = std::max(bottom, place.top + place.height);
    }
    EXPECT_DOUBLE_EQ(right, 800.0);
    EXPECT_DOUBLE_EQ(bottom, 600.0);
    EXPECT_GT(places[1].left, places[0].left + places[0].width);
    const CellPlace& below = places.back();
    const bool rows = count > 2;
    EXPECT_EQ(below.top - below.titleHeight > places[0].top + places[0].height, rows);
  }
  const CellPlace whole = cellPlace(0, 1, 800, 600);
  EXPECT_EQ(whole.width, 800.0);
  EXPECT_EQ(whole.titleHeight, 0.0);
}

TEST(FigureCells, OneFigureStaysAsItIs) {
  const Figure one = figureOf(100, 80, {polyline({{-50, 10}, {300, 10}})});
  const Figure same = sideBySide({{one, "title"}}, 100, 80, Rgb{});
  ASSERT_EQ(same.groups.size(), 1u);
  EXPECT_EQ(same.groups[0].id, "lines");
  EXPECT_EQ(pathOf(same, 0).points, pathOf(one, 0).points);
}

TEST(FigureCells, LinesEndAtTheEdgeOfTheirCell) {
  const CellPlace place = cellPlace(1, 2, 408, 222);
  ASSERT_EQ(place.width, 200.0);
  ASSERT_EQ(place.height, 200.0);
  // Through the cell, in and out again, outside, and a square around the corner at (0, 0).
  const Figure figure = figureOf(
      200, 200,
      {polyline({{-50, 100}, {250, 100}}),
       polyline({{100, 190}, {100, 210}, {150, 210}, {150, 190}}), polyline({{-5, -5}, {-5, 300}}),
       polyline({{-10, -10}, {10, -10}, {10, 10}, {-10, 10}}, true)});
  const Figure all =
      sideBySide({{figureOf(200, 200, {}), "one"}, {figure, "two"}}, 408, 222, Rgb{});
  ASSERT_EQ(all.groups.size(), 3u);  // two titles, and what the second has
  EXPECT_EQ(all.groups[2].id, "view-2-lines");
  ASSERT_EQ(all.groups[2].shapes.size(), 3u);
  EXPECT_NEAR(lengthOf(pathOf(all, 2, 0)), 200.0, 1e-9);
  EXPECT_NEAR(lengthOf(pathOf(all, 2, 1)), 20.0, 1e-9);
  EXPECT_NEAR(lengthOf(pathOf(all, 2, 2)), 20.0, 1e-9);
  for (std::size_t i = 0; i < 3; ++i) {
    for (const Vec2& p : pathOf(all, 2, i).points) {
      EXPECT_GE(p.x(), place.left - 1e-9);
      EXPECT_LE(p.x(), place.left + place.width + 1e-9);
      EXPECT_GE(p.y(), place.top - 1e-9);
      EXPECT_LE(p.y(), place.top + place.height + 1e-9);
    }
  }
  const auto& title = std::get<TextShape>(all.groups[1].shapes[0]);
  EXPECT_EQ(title.text, "two");
  EXPECT_LT(title.position.y(), place.top);
}

TEST(FigureCells, EveryGroupHasItsOwnName) {
  const Figure one = figureOf(100, 80, {polyline({{1, 1}, {2, 2}})});
  const Figure all = sideBySide({{one, "a"}, {one, "b"}, {one, "c"}}, 400, 300, Rgb{});
  std::set<std::string> ids;
  for (const FigureGroup& group : all.groups) EXPECT_TRUE(ids.insert(group.id).second) << group.id;
  EXPECT_EQ(ids.size(), 6u);
  EXPECT_EQ(all.background, (Rgb{1, 2, 3}));
}

}  // namespace
}  // namespace flatland::ui
