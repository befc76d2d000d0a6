// SPDX-License-Identifier: MIT
#include "flatland/io/svg_attributes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "flatland/io/svg_scanner.h"

namespace flatland {

namespace {

constexpr double kPixelsPerInch = 96.0;
constexpr std::size_t kMostNumbers = 400'000;

SvgScanner scannerOf(std::string_view text, const SvgPlace& place) {
  return {text, place.source, place.place};
}

std::vector<double> numbersIn(SvgScanner& scan) {
  std::vector<double> numbers;
  scan.skipSpace();
  if (!scan.startsNumber()) return numbers;
  do {
    numbers.push_back(scan.number());
    if (numbers.size() > kMostNumbers) scan.fail("too many numbers");
  } while (scan.skipToNextArgument());
  return numbers;
}

void expectEnd(SvgScanner& scan, const char* what) {
  scan.skipSpace();
  if (!scan.atEnd()) scan.fail(std::string("expected ") + what + ", found " + scan.found());
}

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

// Multiples of 90 degrees exactly, so that upright things stay upright.
Eigen::Affine2d rotation(double degrees) {
  const double quarter = std::remainder(degrees, 360.0) / 90.0;
  double c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
  if (quarter == std::round(quarter)) c = std::round(c), s = std::round(s);
  Eigen::Affine2d turn = Eigen::Affine2d::Identity();
  turn.linear() << c, -s, s, c;
  return turn;
}

Eigen::Affine2d linear(double a, double b, double c, double d) {
  Eigen::Affine2d map = Eigen::Affine2d::Identity();
  map.linear() << a, c, b, d;
  return map;
}

Eigen::Affine2d shift(const Vec2& by) { return Eigen::Affine2d(Eigen::Translation2d(by)); }

Eigen::Affine2d oneTransform(SvgScanner& scan) {
  const std::string name(scan.word());
  if (name.empty()) scan.fail("expected a transform, found " + scan.found());
  scan.skipSpace();
  if (scan.peek() != '(') scan.fail("expected ( after " + name + ", found " + scan.found());
  scan.advance();
  const std::vector<double> n = numbersIn(scan);
  scan.skipSpace();
  if (scan.peek() != ')') scan.fail("expected a number or ), found " + scan.found());
  scan.advance();
  const auto has = [&](std::size_t count) { return n.size() == count; };
  if (name == "matrix" && has(6)) return shift({n[4], n[5]}) * linear(n[0], n[1], n[2], n[3]);
  if (name == "translate" && (has(1) || has(2))) return shift({n[0], has(2) ? n[1] : 0.0});
  if (name == "scale" && (has(1) || has(2))) return linear(n[0], 0, 0, has(2) ? n[1] : n[0]);
  if (name == "rotate" && has(1)) return rotation(n[0]);
  if (name == "rotate" && has(3)) {
    const Vec2 centre(n[1], n[2]);
    return shift(centre) * rotation(n[0]) * shift(-centre);
  }
  if (name == "skewX" && has(1)) return linear(1, 0, std::tan(radians(n[0])), 1);
  if (name == "skewY" && has(1)) return linear(1, std::tan(radians(n[0])), 0, 1);
  scan.fail("there is no transform " + name + " of " + std::to_string(n.size()) + " numbers");
}

Bezier line(const Vec2& a, const Vec2& b) { return {{a, b}}; }

}  // namespace

Eigen::Affine2d svgTransform(std::string_view text, const SvgPlace& place) {
  SvgScanner scan = scannerOf(text, place);
  Eigen::Affine2d all = Eigen::Affine2d::Identity();
  scan.skipSpace();
  if (text.substr(0, 4) == "none") return all;
  while (!scan.atEnd()) {
    all = all * oneTransform(scan);
    scan.skipCommaSpace();
  }
  return all;
}

double svgLength(std::string_view text, double whole, const SvgPlace& place) {
  SvgScanner scan = scannerOf(text, place);
  scan.skipSpace();
  const double value = scan.number();
  if (scan.peek() == '%') {
    scan.advance();
    expectEnd(scan, "a length");
    return 0.01 * value * whole;
  }
  const std::string_view unit = scan.word();
  expectEnd(scan, "a length");
  constexpr std::array<std::pair<std::string_view, double>, 10> kUnits{
      {{"", 1.0},
       {"px", 1.0},
       {"mm", kPixelsPerInch / 25.4},
       {"cm", kPixelsPerInch / 2.54},
       {"in", kPixelsPerInch},
       {"pt", kPixelsPerInch / 72},
       {"pc", kPixelsPerInch / 6},
       {"Q", kPixelsPerInch / 101.6},
       {"em", 16.0},
       {"ex", 8.0}}};
  for (const auto& [name, size] : kUnits) {
    if (unit == name) return value * size;
  }
  scan.fail("unknown unit " + std::string(unit));
}

std::vector<Vec2> svgPoints(std::string_view text, const SvgPlace& place) {
  SvgScanner scan = scannerOf(text, place);
  const std::vector<double> numbers = numbersIn(scan);
  expectEnd(scan, "a number");
  if (numbers.size() % 2 != 0) {
    scan.fail("expected pairs x,y, found " + std::to_string(numbers.size()) + " numbers");
  }
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < numbers.size(); i += 2)
    points.emplace_back(numbers[i], numbers[i + 1]);
  return points;
}

std::optional<SvgViewBox> svgViewBox(std::string_view text, const SvgPlace& place) {
  SvgScanner scan = scannerOf(text, place);
  const std::vector<double> n = numbersIn(scan);
  expectEnd(scan, "a number");
  if (n.size() != 4) scan.fail("expected 4 numbers, found " + std::to_string(n.size()));
  if (!(n[2] > 0.0 && n[3] > 0.0)) return std::nullopt;
  return SvgViewBox{{n[0], n[1]}, {n[2], n[3]}};
}

Eigen::Affine2d fitViewBox(const SvgViewBox& box, const Vec2& size, std::string_view aspect) {
  Vec2 scale = size.cwiseQuotient(box.size);
  const auto has = [&](std::string_view word) {
    return aspect.find(word) != std::string_view::npos;
  };
  Vec2 rest = Vec2::Zero();
  if (!has("none")) {
    scale.setConstant(has("slice") ? scale.maxCoeff() : scale.minCoeff());
    const Vec2 spare = size - scale.cwiseProduct(box.size);
    rest.x() = has("xMin") ? 0.0 : has("xMax") ? spare.x() : 0.5 * spare.x();
    rest.y() = has("YMin") ? 0.0 : has("YMax") ? spare.y() : 0.5 * spare.y();
  }
  return shift(rest) * linear(scale.x(), 0, 0, scale.y()) * shift(-box.corner);
}

Subpath svgRectangle(const Vec2& corner, const Vec2& size, const Vec2& radii) {
  const Vec2 r = radii.cwiseMin(0.5 * size);
  const bool round = r.minCoeff() > 0.0;
  const Vec2 low = corner, high = corner + size;
  if (!round) return svgPolyline({low, {high.x(), low.y()}, high, {low.x(), high.y()}}, true);
  const std::array<Vec2, 8> at{{{low.x() + r.x(), low.y()},
                                {high.x() - r.x(), low.y()},
                                {high.x(), low.y() + r.y()},
                                {high.x(), high.y() - r.y()},
                                {high.x() - r.x(), high.y()},
                                {low.x() + r.x(), high.y()},
                                {low.x(), high.y() - r.y()},
                                {low.x(), low.y() + r.y()}}};
  Subpath path{at[0], {}, true};
  for (std::size_t i = 0; i < at.size(); i += 2) {
    // Sides of no length, where the corners meet, are no segments; half a side rounds either way.
    const Vec2 end = (at[i + 1] - at[i]).norm() > kSameEnd * size.norm() ? at[i + 1] : at[i];
    if (end != at[i]) path.segments.push_back(line(at[i], end));
    for (PathSegment& conic : conicsOfArc(end, at[(i + 2) % at.size()], {r, 0.0, false, true})) {
      path.segments.push_back(std::move(conic));
    }
  }
  return path;
}

Subpath svgEllipse(const Vec2& centre, const Vec2& radii) {
  const Vec2 x(radii.x(), 0.0), y(0.0, radii.y());
  const std::array<Vec2, 5> at{centre + x, centre + y, centre - x, centre - y, centre + x};
  Subpath path{at[0], {}, true};
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    for (PathSegment& conic : conicsOfArc(at[i], at[i + 1], {radii, 0.0, false, true})) {
      path.segments.push_back(std::move(conic));
    }
  }
  return path;
}

Subpath svgPolyline(const std::vector<Vec2>& points, bool closed) {
  Subpath path;
  path.closed = closed;
  if (!points.empty()) path.start = points.front();
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    path.segments.push_back(line(points[i], points[i + 1]));
  }
  return path;
}

}  // namespace flatland
