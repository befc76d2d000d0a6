// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "flatland/features/features.h"

namespace flatland {

/// The marks as JSON: {"flatland": 1, "view": ..., "marks": [...], "complete": bool,
/// "unresolved": [...], "degenerate": [...], "search": [...]}; keys in docs/user/command-line.md.
/// Values that do not exist are null.
std::string featuresToJson(const FeatureSet& features, const View& view);

/// The marks as CSV (RFC 4180, header line, '.' decimals, empty where a value does not exist).
std::string featuresToCsv(const FeatureSet& features);

}  // namespace flatland
