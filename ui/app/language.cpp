// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>
#include <algorithm>

namespace flatland::ui {

namespace {

constexpr char kKey[] = "window/language";
constexpr char kInstalled[] = "flatland.language";  // a property of the application
const QString kSystem = QStringLiteral("system");

bool isKnown(const QString& code) {
  return std::any_of(languages().begin(), languages().end(), [&code](const Language& language) {
    return code == QLatin1String(language.code);
  });
}

QString systemLanguage() {
  for (const QString& name : QLocale::system().uiLanguages()) {
    const QString code = name.section('-', 0, 0).section('_', 0, 0);
    if (isKnown(code)) return code;
  }
  return QStringLiteral("en");
}

void load(const QString& file, const QString& folder) {
  auto* translator = new QTranslator(qApp);
  translator->setObjectName("language");
  if (translator->load(file, folder)) {
    QCoreApplication::installTranslator(translator);
  } else {
    delete translator;
  }
}

}  // namespace

const std::vector<Language>& languages() {
  static const std::vector<Language> kLanguages{{"en", "English"}, {"de", "Deutsch"}};
  return kLanguages;
}

QString chosenLanguage(const QSettings& settings) {
  const QString code = settings.value(kKey).toString();
  return isKnown(code) ? code : kSystem;
}

void chooseLanguage(QSettings& settings, const QString& code) { settings.setValue(kKey, code); }

void installLanguage(const QString& code) {
  QLocale::setDefault(QLocale::c());
  for (QTranslator* translator : qApp->findChildren<QTranslator*>("language")) delete translator;
  const QString language = isKnown(code) ? code : systemLanguage();
  load("qtbase_" + language, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  load("flatland_" + language, ":/translations");
  qApp->setProperty(kInstalled, language);
}

QString installedLanguage() {
  const QString language = qApp->property(kInstalled).toString();
  return language.isEmpty() ? QStringLiteral("en") : language;
}

}  // namespace flatland::ui
