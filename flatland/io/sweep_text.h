// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "flatland/screen/sweep.h"

namespace flatland {

/// The sweep as CSV (RFC 4180) with the header `what,kind,curve,branch,angleDeg,t,u`. `what` is
/// "line" (a mark that does not move; angle empty), "branch" (a point of a branch; rows of one
/// branch share a number and stand in order; angles are continuous along it), "fold",
/// "meets-silhouette" or "head-on" (events; angle modulo 180). Columns in
/// docs/user/command-line.md.
std::string sweepToCsv(const Sweep& sweep);

}  // namespace flatland
