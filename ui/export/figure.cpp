// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/figure.h"

#include <string_view>

namespace flatland::ui {

std::string toHex(Rgb colour) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string hex = "#";
  for (const unsigned channel : {colour.r, colour.g, colour.b}) {
    hex += kDigits[channel >> 4U];
    hex += kDigits[channel & 15U];
  }
  return hex;
}

void PathData::moveTo(const Vec2& p) {
  verbs.push_back(Verb::MoveTo);
  points.push_back(p);
}

void PathData::lineTo(const Vec2& p) {
  verbs.push_back(Verb::LineTo);
  points.push_back(p);
}

void PathData::cubicTo(const Vec2& c1, const Vec2& c2, const Vec2& p) {
  verbs.push_back(Verb::CubicTo);
  points.insert(points.end(), {c1, c2, p});
}

void PathData::close() { verbs.push_back(Verb::Close); }

void PathData::addCircle(const Vec2& centre, double radius) {
  // The handle length of the cubic that meets the quarter circle in its middle: 4/3 (sqrt 2 - 1).
  constexpr double kHandle = 0.5522847498307936;
  Vec2 out(radius, 0.0);
  moveTo(centre + out);
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Vec2 next = rotateCcw(out);
    cubicTo(centre + out + kHandle * next, centre + next + kHandle * out, centre + next);
    out = next;
  }
  close();
}

Figure magnified(Figure figure, double factor) {
  figure.width *= factor;
  figure.height *= factor;
  for (FigureGroup& group : figure.groups) {
    for (Shape& shape : group.shapes) {
      if (auto* text = std::get_if<TextShape>(&shape)) {
        text->position *= factor;
        text->size *= factor;
        continue;
      }
      auto& drawn = std::get<PathShape>(shape);
      for (Vec2& point : drawn.path.points) point *= factor;
      if (!drawn.stroke) continue;
      drawn.stroke->width *= factor;
      for (double& length : drawn.stroke->dash) length *= factor;
    }
  }
  return figure;
}

double estimatedWidth(const std::string& text, double size) {
  // In thousandths of the font size, by classes of letters: a little above Helvetica's widths,
  // since what stands in for it is often wider.
  constexpr std::string_view kNarrow = "iljtfrI.,:;'|!()[] ";
  constexpr std::string_view kWide = "mwMWOQGD@%";
  double thousandths = 0.0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0U) == 0x80U) continue;  // a byte within a UTF-8 sequence
    if (kNarrow.find(c) != std::string_view::npos) {
      thousandths += 320.0;
    } else if (kWide.find(c) != std::string_view::npos) {
      thousandths += 870.0;
    } else {
      thousandths += (c >= 'A' && c <= 'Z') ? 700.0 : 600.0;
    }
  }
  return thousandths / 1000.0 * size;
}

}  // namespace flatland::ui
