// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "flatland/study/offset_study.h"

namespace flatland {

/// One line of the per-curve table, and its header. Columns in docs/user/command-line.md. Lines end
/// with CR LF (RFC 4180); a line without its end was interrupted.
std::string offsetCsvHeader();
std::string offsetCsvRow(const CurveOffsets& curve);

/// The summary as JSON with its options: {"flatland": 1, "study": "offset", "options": {...},
/// "curves": N, ..., "histogram": [{"from", "to", "share"}, ...]}; empty bins are left out.
std::string offsetSummaryToJson(const OffsetSummary& summary, const OffsetStudyOptions& options);

}  // namespace flatland
