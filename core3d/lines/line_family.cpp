// SPDX-License-Identifier: MIT
#include "core3d/lines/line_family.h"

#include <iterator>

#include "flatland/scene/surface_names.h"

namespace flatland {

static_assert(std::size(kLineFamilyNames) == kLineFamilyCount);

std::array<LineFamily, kLineFamilyCount> allLineFamilies() {
  std::array<LineFamily, kLineFamilyCount> all{};
  for (std::size_t i = 0; i < kLineFamilyCount; ++i) all[i] = static_cast<LineFamily>(i);
  return all;
}

std::string_view nameOf(LineFamily family) {
  return kLineFamilyNames[static_cast<std::size_t>(family)];
}

std::optional<LineFamily> lineFamilyNamed(std::string_view name) {
  for (const LineFamily family : allLineFamilies()) {
    if (nameOf(family) == name) return family;
  }
  return std::nullopt;
}

bool dependsOnView(LineFamily family) { return static_cast<std::size_t>(family) < kViewFamilies; }

}  // namespace flatland
