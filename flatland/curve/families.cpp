// SPDX-License-Identifier: MIT
#include "flatland/curve/families.h"

#include <algorithm>
#include <numbers>

#include "flatland/io/number_text.h"

namespace flatland {

namespace {

constexpr double kSmallest = 1e-6, kLargest = 1e6;  // of lengths: their ratios stay harmless

FamilyParameter lengthNamed(const char* id, const char* meaning, double initial, double high) {
  return {id, meaning, initial, 0.1, high, kSmallest, kLargest};
}

}  // namespace

const std::vector<Family>& families() {
  using Id = Family::Id;
  constexpr double kPi = std::numbers::pi;
  static const std::vector<Family> all = {
      {Id::Circle,
       "circle",
       "Circle",
       "x = r cos t, y = r sin t",
       true,
       {lengthNamed("r", "radius", 1.0, 3.0)}},
      {Id::Ellipse,
       "ellipse",
       "Ellipse",
       "x = a cos t, y = b sin t",
       true,
       {lengthNamed("a", "half axis along x", 1.0, 3.0),
        lengthNamed("b", "half axis along y", 1.5, 3.0)}},
      {Id::Parabola,
       "parabola",
       "Parabola",
       "y = a x\u00b2, |x| \u2264 w",
       false,
       {{"a", "steepness", 1.0, -3.0, 3.0, -kLargest, kLargest},
        lengthNamed("w", "half width", 1.5, 3.0)}},
      {Id::Sine,
       "sine",
       "Sine",
       "y = a sin(k x), |x| \u2264 w",
       false,
       {{"a", "amplitude", 0.5, -2.0, 2.0, -kLargest, kLargest},
        {"k", "wave number", 2.0, 0.5, 6.0, kSmallest, 1000.0},
        {"w", "half width", kPi, 1.0, 6.5, kSmallest, 1000.0}}},
      {Id::Gaussian,
       "gaussian",
       "Gaussian bump",
       "y = h exp(-x\u00b2 / (2 s\u00b2)), |x| \u2264 w",
       false,
       {{"h", "height", 1.0, -3.0, 3.0, -kLargest, kLargest},
        {"s", "width of the bump", 1.0, 0.2, 2.0, 1e-3, kLargest},
        lengthNamed("w", "half width of the curve", 4.0, 6.0)}},
      {Id::Superellipse,
       "superellipse",
       "Superellipse",
       "|x/a|\u207f + |y/b|\u207f = 1",
       true,
       {lengthNamed("a", "half axis along x", 1.0, 3.0),
        lengthNamed("b", "half axis along y", 1.2, 3.0),
        {"n", "exponent", 4.0, 1.0, 10.0, 1.0, 100.0}}},
      {Id::Lissajous,
       "lissajous",
       "Lissajous",
       "x = a sin(p t + \u03b4), y = b sin(q t)",
       true,
       {lengthNamed("a", "half width", 1.0, 3.0),
        lengthNamed("b", "half height", 1.0, 3.0),
        {"p", "swings along x", 1.0, 1.0, 7.0, 1.0, 50.0, true},
        {"q", "swings along y", 2.0, 1.0, 7.0, 1.0, 50.0, true},
        {"delta", "phase, degrees", 90.0, 0.0, 360.0, -3600.0, 3600.0}}},
      {Id::Cycloid,
       "cycloid",
       "Cycloid",
       "x = r t - d sin t, y = r - d cos t",
       false,
       {lengthNamed("r", "radius of the wheel", 0.5, 2.0),
        {"d", "distance of the pen from the hub; r gives cusps", 0.5, 0.0, 2.0, 0.0, kLargest},
        {"n", "arches", 3.0, 1.0, 8.0, 1.0, 100.0, true}}},
  };
  return all;
}

const Family* familyNamed(const std::string& name) {
  for (const Family& family : families()) {
    if (family.name == name) return &family;
  }
  return nullptr;
}

const Family& familyOf(const FamilyCurve& curve) {
  return families()[static_cast<std::size_t>(curve.family)];
}

FamilyCurve initialCurve(const Family& family) {
  FamilyCurve curve{family.id, {}};
  for (const FamilyParameter& parameter : family.parameters) {
    curve.parameters.push_back(parameter.initial);
  }
  return curve;
}

std::optional<std::string> whyInvalid(const FamilyCurve& curve) {
  const Family& family = familyOf(curve);
  for (std::size_t i = 0; i < family.parameters.size(); ++i) {
    const FamilyParameter& parameter = family.parameters[i];
    const double value = curve.parameters[i];
    if (!(value >= parameter.least && value <= parameter.most)) {
      return parameter.id + " must be from " + numberText(parameter.least) + " to " +
             numberText(parameter.most);
    }
    if (parameter.whole && value != std::floor(value)) {
      return parameter.id + " must be a whole number";
    }
  }
  return std::nullopt;
}

int pieceCount(const FamilyCurve& curve) {
  switch (curve.family) {
    case Family::Id::Superellipse:
      return 4;
    case Family::Id::Cycloid:
      return static_cast<int>(curve.parameters[2]);
    default:
      return 1;
  }
}

template <int N>
void evaluate(const FamilyCurve& curve, int piece, const Taylor<N>& t, Taylor<N>& x, Taylor<N>& y) {
  using Series = Taylor<N>;
  const std::vector<double>& p = curve.parameters;
  const auto across = [&t](double w) { return w * (2.0 * t - Series(1.0)); };
  Series s, c;
  switch (curve.family) {
    case Family::Id::Circle:
      sinCosOfTurns(t, s, c);
      x = p[0] * c;
      y = p[0] * s;
      return;
    case Family::Id::Ellipse:
      sinCosOfTurns(t, s, c);
      x = p[0] * c;
      y = p[1] * s;
      return;
    case Family::Id::Parabola:
      x = across(p[1]);
      y = p[0] * (x * x);
      return;
    case Family::Id::Sine:
      x = across(p[2]);
      y = p[0] * sin(p[1] * x);
      return;
    case Family::Id::Gaussian:
      x = across(p[2]);
      y = p[0] * exp((-0.5 / (p[1] * p[1])) * (x * x));
      return;
    case Family::Id::Superellipse: {
      // By the polar angle, which keeps the speed above 0. In the first quadrant sine and cosine
      // are not negative; the others are that one turned.
      sinCosOfTurns(0.25 * t, s, c);
      const bool swapped = piece % 2 == 1;
      const Series across1 = swapped ? s : c, up = swapped ? c : s;
      const double n = p[2];
      const Series r = pow(pow((1.0 / p[0]) * across1, n) + pow((1.0 / p[1]) * up, n), -1.0 / n);
      x = (piece == 1 || piece == 2 ? -1.0 : 1.0) * (r * across1);
      y = (piece >= 2 ? -1.0 : 1.0) * (r * up);
      return;
    }
    case Family::Id::Lissajous:
      sinCosOfTurns(p[2] * t + Series(p[4] / 360.0), s, c);
      x = p[0] * s;
      sinCosOfTurns(p[3] * t, s, c);
      y = p[1] * s;
      return;
    case Family::Id::Cycloid: {
      sinCosOfTurns(t, s, c);
      const double turn = 2.0 * std::numbers::pi * p[0];
      x = turn * (t + Series(piece - 0.5 * p[2])) - p[1] * s;
      y = Series(p[0]) - p[1] * c;
      return;
    }
  }
}

template void evaluate(const FamilyCurve&, int, const Taylor<0>&, Taylor<0>&, Taylor<0>&);
template void evaluate(const FamilyCurve&, int, const Taylor<4>&, Taylor<4>&, Taylor<4>&);

}  // namespace flatland
