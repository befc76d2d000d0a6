// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "flatland/io/json_node.h"
#include "flatland/scene/scene.h"

namespace flatland {

/// One curve of a scene file of the given version. Throws InputError; a kind that came with a later
/// version is refused.
SceneCurve curveFrom(const JsonNode& node, int version);

/// The curve as an entry of the list of curves; `path` is its place, for errors. Throws InputError
/// for what the format cannot hold.
std::string curveText(const SceneCurve& curve, const std::string& path);

/// The version of the format with which this kind of curve came: 1 or 2.
int versionOf(const Curve& curve);

/// B-splines beyond these are refused.
inline constexpr int kHighestSplineDegree = 16;
inline constexpr std::size_t kMostSplinePoints = 100000;

// Numbers as the format writes them; InputError if it cannot.
std::string finiteText(double value, const std::string& path);
std::string lengthText(double value, const std::string& path);

}  // namespace flatland
