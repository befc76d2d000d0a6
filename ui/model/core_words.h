// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>

#include "ui/export/figure_words.h"

namespace flatland::ui {

/// A sentence or name that comes in English from the libraries (names and descriptions of presets,
/// expected answers, reasons) in the person's language; as it is where there is no translation.
/// What can come is listed in core_words.cpp and, with values in it, in core_sentences.cpp and
/// mesh_sentences.cpp, where the translation tools find it.
QString coreWords(const std::string& english);

/// The same for figures that the window draws or exports.
FigureWords wordsOfTheWindow();

}  // namespace flatland::ui
