// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDir>
#include <QFile>
#include <QString>

namespace flatland::ui {

/// A mesh of the example data; empty where there is none. FLATLAND_DATA names the folder.
inline QString dataMesh(const char* name) {
  const QString folder = qEnvironmentVariable("FLATLAND_DATA", FLATLAND_DATA_FOLDER);
  const QString file = QDir::cleanPath(folder + "/meshes/" + name);
  return QFile::exists(file) ? file : QString();
}

}  // namespace flatland::ui
