// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core3d/study/convergence.h"

namespace flatland {

/// For people: a table in columns, the fitted order below each series.
std::string convergenceTable(const std::vector<ConvergenceSeries>& all);

/// One row for a mesh and a series (RFC 4180). Columns in docs/user/lines.md.
std::string convergenceCsv(const std::vector<ConvergenceSeries>& all);

/// The options and all series. Keys in docs/user/lines.md.
std::string convergenceJson(const std::vector<ConvergenceSeries>& all,
                            const ConvergenceOptions& options);

}  // namespace flatland
