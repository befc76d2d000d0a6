// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace flatland::ui {

/// What core3d says of mesh files in English, with %1 for values: why they are refused, what was
/// mended, and the words that stand in other sentences. For sentenceInWords() and the translation
/// tools; the more particular ones stand first.
std::span<const char* const> meshSentences();

}  // namespace flatland::ui
