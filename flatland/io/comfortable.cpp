// SPDX-License-Identifier: MIT
#include "flatland/io/comfortable.h"

#include <cmath>

#include "flatland/io/input_error.h"
#include "flatland/io/number_text.h"

namespace flatland {

namespace {

constexpr double kSmallestSide = 1e-50;

std::string scaleText(int exponent) {
  if (exponent == 0) return "centred";
  const double factor = std::ldexp(1.0, std::abs(exponent));
  return "scaled by " + (exponent < 0 ? "1/" : std::string()) + numberText(factor) + " and centred";
}

}  // namespace

std::string makeComfortable(Scene& scene, const std::string& source) {
  const Bounds box = boundsOf(scene);
  const double side = (box.high - box.low).maxCoeff();
  if (!(side > kSmallestSide)) throw InputError(source, "", "is too small to be seen");
  int exponent = 0;
  const double mantissa = std::frexp(side, &exponent);  // in [0.5, 1)
  const int power = (mantissa == 0.5 ? 3 : 2) - exponent;
  const Vec2 centre = box.centre();
  const auto place = [&](auto& shape) {
    for (std::size_t i = 0; i < shape.points().size(); ++i) {
      const Vec2 p = shape.points()[i] - centre;
      shape.setPoint(i, {std::ldexp(p.x(), power), std::ldexp(p.y(), power)});
    }
  };
  for (SceneCurve& curve : scene.curves) {
    if (auto* conics = std::get_if<RationalBezier>(&curve.shape)) {
      place(*conics);
    } else {
      place(curve.chain());
    }
  }
  return scaleText(power);
}

}  // namespace flatland
