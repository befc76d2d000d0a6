// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "flatland/features/features.h"

namespace flatland::test {

/// A scene of one curve.
inline Scene sceneOf(Curve curve, double angleDeg) {
  Scene scene;
  scene.curves.push_back({std::move(curve), false});
  scene.view.angleDeg = angleDeg;
  return scene;
}

/// The marks of these kinds.
inline std::vector<Mark> marksOf(const FeatureSet& found, std::initializer_list<MarkKind> kinds) {
  std::vector<Mark> marks;
  for (const Mark& mark : found.marks) {
    if (std::count(kinds.begin(), kinds.end(), mark.kind)) marks.push_back(mark);
  }
  return marks;
}

/// For messages: all marks, and what was left open.
inline std::string said(const FeatureSet& found) {
  std::string text;
  for (const Mark& mark : found.marks) {
    text += std::string(nameOf(mark.kind)) + " " + std::to_string(mark.t) + "; ";
  }
  for (const Unresolved& open : found.unresolved) {
    text += "open " + std::string(nameOf(open.kind)) + " " + std::to_string(open.tLow) + " to " +
            std::to_string(open.tHigh) + " " + open.reason + "; ";
  }
  return text;
}

}  // namespace flatland::test
