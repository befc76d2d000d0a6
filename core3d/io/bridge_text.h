// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core3d/study/bridge.h"

namespace flatland {

/// For people: a table in columns, what was left out of it and why below.
std::string bridgeTable(const BridgePrediction& prediction, const std::vector<BridgeSeries>& all);
std::string bridgeTable(const BridgeTrials& trials, const BridgeTrialOptions& options);

/// One row for a mesh and a series, or for a trial (RFC 4180). Columns in docs/user/bridges.md.
std::string bridgeCsv(const std::vector<BridgeSeries>& all);
std::string bridgeCsv(const BridgeTrials& trials);

}  // namespace flatland
