// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "flatland/study/limits.h"

namespace flatland {

/// Series as JSON: {"flatland": 1, "study": "limits", "experiments": [...]}. Keys in
/// docs/user/command-line.md.
std::string limitsToJson(const std::vector<LimitSeries>& series);

/// Series as CSV (RFC 4180): `experiment,case,quantity,x,value`, one row a sample and quantity; an
/// empty field where there is no value.
std::string limitsToCsv(const std::vector<LimitSeries>& series);

}  // namespace flatland
