// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "flatland/io/input_error.h"
#include "flatland/io/svg_file.h"

namespace flatland::ui {

/// An English sentence of the libraries that has values in it ("degree 30 is above 25, the highest
/// supported") in the person's language; nullopt if its form is not known, or there is no
/// translation. The values are translated too, where they are words.
std::optional<QString> sentenceInWords(const QString& english);

/// Why an input is refused, for a person: source, place and reason, the latter two in the person's
/// language where their form is known.
QString errorForPeople(const InputError& error);

/// What an import did and left out, for a person: its note() in the person's language.
QString importForPeople(const ImportedScene& imported);

}  // namespace flatland::ui
