// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/surface_look.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include "flatland/scene/surface_names.h"
#include "ui/export/line_style.h"

namespace flatland::ui {

namespace {

static_assert(std::size(kSurfaceStyleNames) == kSurfaceStyleCount);
static_assert(std::size(kSurfaceQuantityNames) == kSurfaceQuantityCount);
static_assert(std::size(kHiddenLineNames) == kHiddenLinesCount);

template <std::size_t N>
std::optional<std::size_t> indexOf(const std::string_view (&names)[N], const std::string& name) {
  const auto found = std::find(std::begin(names), std::end(names), name);
  if (found == std::end(names)) return std::nullopt;
  return static_cast<std::size_t>(found - std::begin(names));
}

bool isOnByDefault(LineFamily family) {
  return family == LineFamily::OccludingContours || family == LineFamily::ApparentRidges ||
         family == LineFamily::Boundaries;
}

}  // namespace

std::string_view nameOf(SurfaceStyle style) {
  return kSurfaceStyleNames[static_cast<std::size_t>(style)];
}
std::string_view nameOf(SurfaceQuantity quantity) {
  return kSurfaceQuantityNames[static_cast<std::size_t>(quantity)];
}
std::string_view nameOf(HiddenLines hidden) {
  return kHiddenLineNames[static_cast<std::size_t>(hidden)];
}

SurfaceStyle styleOf(const SurfaceSetting& setting) {
  const auto usual = static_cast<std::size_t>(SurfaceStyle::Lambert);
  return static_cast<SurfaceStyle>(indexOf(kSurfaceStyleNames, setting.style).value_or(usual));
}

SurfaceQuantity quantityOf(const SurfaceSetting& setting) {
  const auto usual = static_cast<std::size_t>(SurfaceQuantity::Lambda);
  return static_cast<SurfaceQuantity>(
      indexOf(kSurfaceQuantityNames, setting.quantity).value_or(usual));
}

HiddenLines hiddenOf(const SurfaceSetting& setting) {
  return static_cast<HiddenLines>(indexOf(kHiddenLineNames, setting.hidden).value_or(0));
}

SurfaceFamily usualFamily(LineFamily family) {
  static const LineOptions kUsual;
  SurfaceFamily usual;
  usual.name = nameOf(family);
  usual.on = isOnByDefault(family);
  usual.threshold = kUsual.threshold[static_cast<std::size_t>(family)];
  return usual;
}

SurfaceFamily familyOf(const SurfaceSetting& setting, LineFamily family) {
  for (const SurfaceFamily& one : setting.families) {
    if (one.name != nameOf(family)) continue;
    SurfaceFamily look = one;
    if (!look.threshold) look.threshold = usualFamily(family).threshold;
    return look;
  }
  return usualFamily(family);
}

SurfaceSetting withFamily(SurfaceSetting setting, const SurfaceFamily& family) {
  for (SurfaceFamily& one : setting.families) {
    if (one.name != family.name) continue;
    one = family;
    return setting;
  }
  setting.families.push_back(family);
  return setting;
}

std::optional<Rgb> rgbOf(const std::string& hex) {
  std::uint32_t value = 0;
  if (hex.size() != 7 || hex[0] != '#') return std::nullopt;
  const auto read = std::from_chars(hex.data() + 1, hex.data() + 7, value, 16);
  if (read.ptr != hex.data() + 7) return std::nullopt;
  return Rgb{static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 8),
             static_cast<std::uint8_t>(value)};
}

Rgb colourOf(const SurfaceFamily& family, Palette palette) {
  if (const std::optional<Rgb> own = rgbOf(family.colour)) return *own;
  const std::optional<LineFamily> known = lineFamilyNamed(family.name);
  return known ? lineColour(*known, palette) : sceneColours(palette).curve;
}

Eigen::Vector3d upAxisOf(const SurfaceSetting& setting) {
  const std::string& axis = setting.upAxis;
  const char letter = axis.empty() ? 'y' : axis.back();
  const Eigen::Vector3d along = letter == 'x'   ? Eigen::Vector3d::UnitX()
                                : letter == 'z' ? Eigen::Vector3d::UnitZ()
                                                : Eigen::Vector3d::UnitY();
  return axis.size() > 1 ? Eigen::Vector3d(-along) : along;
}

LineOptions lineOptionsOf(const SurfaceSetting& setting) {
  LineOptions options;
  for (const LineFamily family : allLineFamilies()) {
    const SurfaceFamily look = familyOf(setting, family);
    options[family] = look.on;
    options.threshold[static_cast<std::size_t>(family)] = *look.threshold;
  }
  options.unfiltered = setting.unfiltered;
  options.isophoteLevels = setting.isophotes;
  options.topographicLevels = setting.heights;
  options.topographicUp = upAxisOf(setting);
  return options;
}

float inkOf(float strength, double threshold) {
  if (!(threshold > 0.0)) return 1.0f;
  const float above = strength / static_cast<float>(threshold) - 1.0f;
  return std::clamp(kWeakestInk + (1.0f - kWeakestInk) * above, kWeakestInk, 1.0f);
}

}  // namespace flatland::ui
