// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "flatland/study/derivation.h"

namespace flatland {

/// A step as it stands at a place, for a file or a terminal.
struct DerivationRow {
  DerivationStepText text;
  StepReading reading;
  std::vector<StepDifference> sweep;
};

/// All steps at a place, in order.
std::vector<DerivationRow> derivationRows(const DerivationPlace& place);

/// The answer in words: "evaluated", "no tangent", "silhouette", "no normal", "no direction".
std::string wordsFor(StepAnswer answer);

/// One object per step with both variants and the step-size sweep. Numbers read back exactly.
std::string derivationToJson(const std::vector<DerivationRow>& rows);

/// The array of these objects alone, to be part of another one.
std::string derivationStepsJson(const std::vector<DerivationRow>& rows);

/// One row per step and variant; entries of vectors and matrices separated by blanks.
std::string derivationToCsv(const std::vector<DerivationRow>& rows);

/// For reading on a terminal.
std::string derivationToText(const std::vector<DerivationRow>& rows);

}  // namespace flatland
