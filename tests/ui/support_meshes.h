// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDir>
#include <QFile>
#include <QString>
#include <QTest>

namespace flatland::ui {

/// A mesh of the example data; empty where there is none. FLATLAND_DATA names the folder.
inline QString dataMesh(const char* name) {
  const QString folder = qEnvironmentVariable("FLATLAND_DATA", FLATLAND_DATA_FOLDER);
  const QString file = QDir::cleanPath(folder + "/meshes/" + name);
  return QFile::exists(file) ? file : QString();
}

}  // namespace flatland::ui

/// For test functions: the file of an example mesh as a QString `file`. Without the data the test
/// is skipped at home, but not where everything must be there.
#define NEEDS_DATA_MESH(file, name)                                                               \
  const QString file = flatland::ui::dataMesh(name);                                              \
  if (qgetenv("CI") == "true") QVERIFY2(!file.isEmpty(), "no example meshes; set FLATLAND_DATA"); \
  if (file.isEmpty()) QSKIP("no example meshes")
