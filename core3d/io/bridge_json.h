// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core3d/study/bridge.h"

namespace flatland {

/// The predicted lines and all series, or all trials. Keys in docs/user/bridges.md.
std::string bridgeJson(const BridgePrediction& prediction, const std::vector<BridgeSeries>& all);
std::string bridgeJson(const BridgeTrials& trials, const BridgeTrialOptions& options);

}  // namespace flatland
