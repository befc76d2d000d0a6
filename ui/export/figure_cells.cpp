// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/figure_cells.h"

#include <algorithm>
#include <utility>

namespace flatland::ui {

namespace {

constexpr std::size_t kColumns = 2;
constexpr double kGapPx = 8.0;
constexpr double kTitlePx = 14.0;  ///< height of the type
constexpr double kTitleRowPx = 22.0;

struct Box {
  double width, height;
  bool holds(const Vec2& p) const {
    return p.x() >= 0.0 && p.y() >= 0.0 && p.x() <= width && p.y() <= height;
  }
};

/// The part of a straight line within the box, as shares of the way (Liang and Barsky); from > to
/// if there is none.
std::pair<double, double> within(const Box& box, const Vec2& a, const Vec2& b) {
  double from = 0.0, to = 1.0;
  const Vec2 d = b - a;
  const auto cut = [&](double towards, double room) {
    // towards * t <= room
    if (towards > 0.0) {
      to = std::min(to, room / towards);
    } else if (towards < 0.0) {
      from = std::max(from, room / towards);
    } else if (room < 0.0) {
      from = 2.0;
    }
  };
  cut(-d.x(), a.x());
  cut(d.x(), box.width - a.x());
  cut(-d.y(), a.y());
  cut(d.y(), box.height - a.y());
  return {from, to};
}

/// Draws what is within the box of one straight line, going on from where the path is if it can.
void addCut(PathData& path, const Box& box, const Vec2& a, const Vec2& b, bool& goesOn) {
  const auto [from, to] = within(box, a, b);
  if (from > to) {
    goesOn = false;
    return;
  }
  if (!goesOn || from > 0.0) path.moveTo(a + from * (b - a));
  path.lineTo(a + to * (b - a));
  goesOn = to >= 1.0;
}

PathData cutToBox(const PathData& path, const Box& box) {
  if (std::all_of(path.points.begin(), path.points.end(),
                  [&box](const Vec2& p) { return box.holds(p); })) {
    return path;
  }
  PathData cut;
  std::size_t next = 0;
  Vec2 at = Vec2::Zero(), first = Vec2::Zero();
  bool goesOn = false;
  for (const PathData::Verb verb : path.verbs) {
    if (verb == PathData::Verb::MoveTo) {
      at = first = path.points[next++];
      goesOn = false;
    } else {
      const bool closes = verb == PathData::Verb::Close;
      const Vec2 to = closes ? first : path.points[next++];
      addCut(cut, box, at, to, goesOn);
      at = to;
    }
  }
  return cut;
}

void move(Shape& shape, const Vec2& by) {
  if (auto* text = std::get_if<TextShape>(&shape)) {
    text->position += by;
  } else {
    for (Vec2& point : std::get<PathShape>(shape).path.points) point += by;
  }
}

/// False if nothing of it is left.
bool cut(Shape& shape, const Box& box) {
  auto* drawn = std::get_if<PathShape>(&shape);
  if (!drawn) return true;
  if (drawn->fill) {
    return std::any_of(drawn->path.points.begin(), drawn->path.points.end(),
                       [&box](const Vec2& p) { return box.holds(p); });
  }
  drawn->path = cutToBox(drawn->path, box);
  return !drawn->path.verbs.empty();
}

}  // namespace

CellPlace cellPlace(std::size_t index, std::size_t count, double width, double height) {
  if (count < 2) return {0.0, 0.0, std::max(width, 1.0), std::max(height, 1.0), 0.0};
  const auto rows = static_cast<double>((count + kColumns - 1) / kColumns);
  const auto columns = static_cast<double>(kColumns);
  const double wide = (width - (columns - 1.0) * kGapPx) / columns;
  const double high = (height - (rows - 1.0) * kGapPx) / rows;
  const auto column = static_cast<double>(index % kColumns);
  const auto row = static_cast<double>(index / kColumns);
  return {column * (wide + kGapPx), row * (high + kGapPx) + kTitleRowPx, std::max(wide, 1.0),
          std::max(high - kTitleRowPx, 1.0), kTitleRowPx};
}

Figure sideBySide(std::vector<FigureCell> cells, double width, double height, Rgb titleColour) {
  if (cells.size() == 1) return std::move(cells.front().figure);
  Figure all;
  all.width = width;
  all.height = height;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    Figure& figure = cells[i].figure;
    if (i == 0) all.background = figure.background;
    const CellPlace place = cellPlace(i, cells.size(), width, height);
    const std::string view = "view-" + std::to_string(i + 1);
    const Box box{place.width, place.height};
    FigureGroup title{view + "-title", "title", {}};
    title.shapes.emplace_back(
        TextShape{.position = {place.left + 4.0, place.top - 0.5 * place.titleHeight},
                  .text = cells[i].title,
                  .size = kTitlePx,
                  .colour = titleColour,
                  .anchor = TextShape::Anchor::Start});
    all.groups.push_back(std::move(title));
    for (FigureGroup& group : figure.groups) {
      std::erase_if(group.shapes, [&box](Shape& shape) { return !cut(shape, box); });
      if (group.shapes.empty()) continue;
      for (Shape& shape : group.shapes) move(shape, {place.left, place.top});
      group.id = view + "-" + group.id;
      all.groups.push_back(std::move(group));
    }
  }
  return all;
}

}  // namespace flatland::ui
