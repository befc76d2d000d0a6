// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "flatland/study/offset_study.h"

namespace flatland {

/// One line of the per-curve table, and its header. Columns in docs/user/command-line.md. Lines end
/// with CR LF (RFC 4180); a line without its end was interrupted.
std::string offsetCsvHeader();
std::string offsetCsvRow(const CurveOffsets& curve, TermConvention convention);

/// The summary as JSON with its options; keys in docs/user/command-line.md. Empty bins of
/// histograms are left out.
std::string offsetSummaryToJson(const OffsetSummary& summary, const OffsetStudyOptions& options);

}  // namespace flatland
