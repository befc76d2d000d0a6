// SPDX-License-Identifier: GPL-3.0-or-later
// The default scene's marks by way of the installed library.
#include <algorithm>
#include <cstdio>

#include "flatland/features/features.h"
#include "flatland/roots/double_double.h"
#include "flatland/scene/scene.h"

int main() {
  const flatland::FeatureSet found = flatland::findFeatures(flatland::defaultScene());
  const auto ridges = std::count_if(found.marks.begin(), found.marks.end(), [](const auto& mark) {
    return mark.kind == flatland::MarkKind::ApparentRidge;
  });
  std::printf("%d marks, %d of them apparent ridges\n", int(found.marks.size()), int(ridges));
  return found.complete() && ridges > 0 ? 0 : 1;
}
