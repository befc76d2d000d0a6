// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

class QSettings;

namespace flatland::ui {

/// A language the window can speak, named in itself: "de", "Deutsch".
struct Language {
  const char* code;
  const char* name;
};
const std::vector<Language>& languages();

/// The code the settings hold, or "system": that of the desktop, or English.
QString chosenLanguage(const QSettings& settings);
void chooseLanguage(QSettings& settings, const QString& code);

/// Loads the words of a language (a code, or "system") into the application, Qt's own included
/// where they are installed, in place of those loaded before. To be called before any window is
/// made. Numbers are written with a point in every language: they go to files, tables and programs.
void installLanguage(const QString& code);

/// The code of the language that is installed; "en" before any is.
QString installedLanguage();

}  // namespace flatland::ui
