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
constexpr Rgb kNoValue{0x9A, 0x9A, 0x9A};
/// Ratios beyond a hundredth and a hundred are the same to the eye.
constexpr double kRatioExponent = 2.0;

/// Blue - white - orange, Okabe and Ito's hues darkened at the ends.
constexpr Rgb kDiverging[] = {{0x00, 0x3F, 0x75},
                              {0x3B, 0x8F, 0xC8},
                              {0xF4, 0xF4, 0xF2},
                              {0xE6, 0x8A, 0x2E},
                              {0x7A, 0x36, 0x00}};
/// After cividis: dark blue, grey, yellow.
constexpr Rgb kSequential[] = {{0x00, 0x22, 0x4E},
                               {0x43, 0x4E, 0x6C},
                               {0x7D, 0x7C, 0x78},
                               {0xBC, 0xAF, 0x6F},
                               {0xFE, 0xE8, 0x38}};

Rgb between(const Rgb (&stops)[5], double share) {
  const double place = std::clamp(share, 0.0, 1.0) * 4.0;
  const int below = std::min(static_cast<int>(place), 3);
  const double t = place - below;
  const Rgb &a = stops[below], &b = stops[below + 1];
  const auto mix = [t](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround(from + t * (to - from)));
  };
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
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
      return terms.lambda ? terms.feature : kNone;
    case SurfaceQuantity::Offset:
      return terms.lambda ? terms.offset : kNone;
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
      scale.low = percentile(seen, 1.0 - kKept);
      scale.high = percentile(seen, kKept);
      if (!(scale.high > scale.low)) scale.high = scale.low + 1.0;
      return;
    case SurfaceQuantity::OffsetShare:
      scale.high = kRatioExponent;
      break;
    default:
      for (float& value : seen) value = std::abs(value);
      scale.high = percentile(seen, kKept);
      if (!(scale.high > 0.0)) scale.high = 1.0;
      break;
  }
  scale.low = -scale.high;
}

}  // namespace

Rgb ColourScale::at(double share) const {
  return diverging ? between(kDiverging, share) : between(kSequential, share);
}

Rgb ColourScale::of(double value) const {
  if (std::isnan(value)) return kNoValue;
  return at((value - low) / (high - low));
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
  colours.rgb.reserve(count);
  for (const double value : values) colours.rgb.push_back(scale.of(value));
  return colours;
}

}  // namespace flatland::ui
