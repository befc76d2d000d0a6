// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/surface_colours.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core3d/lines/vertex_terms.h"

namespace flatland::ui {

namespace {

constexpr double kKept = 0.98;  ///< share of the vertices within the scale
/// What depends on the view has no bound towards silhouettes: only what is turned so far to the
/// viewer sets the scale.
constexpr double kFacing = 0.4;
constexpr double kLeastLambda = 1e-9;  ///< less is as good as flat, and has a logarithm
/// Ratios beyond a hundredth and a hundred are the same to the eye.
constexpr double kRatioExponent = 2.0;
/// The least part of a scale that is linear: what is smaller beside the ends is as good as 0.
constexpr double kLeastKnee = 1e-4;
/// A scale whose ends are nearer than so many times the median is linear.
constexpr double kLongTail = 3.0;

using Stops = std::array<Rgb, 5>;
// Teal - background - purple, after Brewer's PRGn.
constexpr Stops kDiverging{{{0x00, 0x4F, 0x47},
                            {0x5B, 0xB3, 0xA0},
                            {0xF6, 0xF6, 0xF4},
                            {0xB0, 0x8B, 0xC9},
                            {0x54, 0x27, 0x8F}}};
constexpr Stops kDivergingDark{{{0x8F, 0xE0, 0xCB},
                                {0x2F, 0x8C, 0x7B},
                                {0x2A, 0x2B, 0x30},
                                {0x80, 0x58, 0xA8},
                                {0xCD, 0xB2, 0xEA}}};
// Background to blue. Not to its darkest or palest: contours are drawn on it.
constexpr Stops kSequential{{{0xF3, 0xEF, 0xDD},
                             {0xC9, 0xDB, 0xD3},
                             {0x8F, 0xBC, 0xC4},
                             {0x54, 0x90, 0xB4},
                             {0x1F, 0x5A, 0x8C}}};
constexpr Stops kSequentialDark{{{0x23, 0x26, 0x2C},
                                 {0x1F, 0x42, 0x57},
                                 {0x26, 0x68, 0x8A},
                                 {0x3F, 0x95, 0xB8},
                                 {0x62, 0xB4, 0xD4}}};

/// Rounded away from 0 to so many digits, so that a legend can say it.
double roundedUp(double value, int digits) {
  if (!(value > 0.0) || !std::isfinite(value)) return value;
  const double step = std::pow(10.0, std::floor(std::log10(value)) - digits + 1.0);
  return std::ceil(value / step - 1e-9) * step;
}

double valueOf(const SurfaceTerms& terms, SurfaceQuantity quantity) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  switch (quantity) {
    case SurfaceQuantity::K1:
      return terms.k1;
    case SurfaceQuantity::K2:
      return terms.k2;
    case SurfaceQuantity::Lambda:
      return terms.lambda ? std::log10(std::max(*terms.lambda, kLeastLambda)) : kNone;
    case SurfaceQuantity::Feature:
      return terms.lambda ? terms.towardsGrowth().feature : kNone;
    case SurfaceQuantity::Offset:
      return terms.lambda ? terms.towardsGrowth().offset : kNone;
    case SurfaceQuantity::OffsetShare:
      break;
  }
  const std::optional<double> share = terms.offsetShare();
  return share ? std::clamp(std::log10(*share), -99.0, 99.0) : kNone;
}

/// What this share of the values stay below.
double percentile(std::vector<float>& values, double share) {
  if (values.empty()) return 0.0;
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// The ends of the scale, from the values of what is turned to the viewer.
void setEnds(ColourScale& scale, std::vector<float> seen) {
  switch (scale.quantity) {
    case SurfaceQuantity::Lambda:
      // It spans orders of magnitude: on a linear scale all but the sharpest edges are alike.
      scale.high = std::log10(roundedUp(std::pow(10.0, percentile(seen, kKept)), 2));
      scale.low = -std::log10(roundedUp(std::pow(10.0, -percentile(seen, 1.0 - kKept)), 2));
      if (!(scale.high > scale.low)) scale.high = scale.low + 1.0;
      return;
    case SurfaceQuantity::OffsetShare:
      scale.high = kRatioExponent;
      break;
    default:
      for (float& value : seen) value = std::abs(value);
      scale.high = roundedUp(percentile(seen, kKept), 2);
      if (!(scale.high > 0.0)) scale.high = 1.0;
      // A surface that is flat for the most part has its half at 0.
      scale.knee = roundedUp(std::max(percentile(seen, 0.5), kLeastKnee * scale.high), 1);
      if (scale.high < kLongTail * scale.knee) scale.knee = 0.0;
      break;
  }
  scale.low = -scale.high;
}

}  // namespace

double ColourScale::share(double value) const {
  if (std::isnan(value)) return -1.0;
  const double share = knee > 0.0 ? 0.5 + 0.5 * std::asinh(value / knee) / std::asinh(high / knee)
                                  : (value - low) / (high - low);
  return std::clamp(share, 0.0, 1.0);
}

std::array<Rgb, 5> ColourScale::stops(Palette palette) const {
  const bool light = palette == Palette::Light;
  if (diverging) return light ? kDiverging : kDivergingDark;
  return light ? kSequential : kSequentialDark;
}

Rgb ColourScale::at(double share, Palette palette) const {
  if (share < 0.0) return kNoValue;
  const Stops row = stops(palette);
  const double place = std::min(share, 1.0) * 4.0;
  const std::size_t below = std::min(static_cast<std::size_t>(place), std::size_t{3});
  const double t = place - static_cast<double>(below);
  const Rgb &a = row[below], &b = row[below + 1];
  const auto mix = [t](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround(from + t * (to - from)));
  };
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

std::vector<double> ColourScale::ticks() const {
  std::vector<double> all{low, high};
  if (diverging) all.push_back(0.0);
  if (logarithmic) {
    for (double e = std::ceil(low); e <= high; e += 1.0) all.push_back(e);
  } else if (knee > 0.0) {
    for (double e = std::ceil(std::log10(knee)); e <= std::log10(high); e += 1.0) {
      for (const double sign : {-1.0, 1.0}) all.push_back(sign * std::pow(10.0, e));
    }
  }
  return all;
}

VertexColours vertexColours(const TriangleMesh& mesh, const SurfaceFields& fields,
                            const SurfaceView& view, SurfaceQuantity quantity) {
  const auto count = static_cast<std::uint32_t>(mesh.vertexCount());
  std::vector<double> values(count, std::numeric_limits<double>::quiet_NaN());
  std::vector<float> seen;
  seen.reserve(count);
  const bool ofTheView = quantity != SurfaceQuantity::K1 && quantity != SurfaceQuantity::K2;
  const double least = ofTheView ? kFacing : 0.0;
  for (std::uint32_t v = 0; v < count; ++v) {
    const std::optional<SurfaceTerms> terms = termsAt(mesh, fields, view, v);
    if (!terms) continue;
    values[v] = valueOf(*terms, quantity);
    // What is turned away is not seen and must not stretch the scale.
    if (terms->nw > least && std::isfinite(values[v])) {
      seen.push_back(static_cast<float>(values[v]));
    }
  }
  VertexColours colours;
  ColourScale& scale = colours.scale;
  scale.quantity = quantity;
  scale.diverging = quantity != SurfaceQuantity::Lambda;
  scale.logarithmic = quantity == SurfaceQuantity::OffsetShare || !scale.diverging;
  setEnds(scale, std::move(seen));
  colours.share.reserve(count);
  for (const double value : values) colours.share.push_back(static_cast<float>(scale.share(value)));
  return colours;
}

}  // namespace flatland::ui
