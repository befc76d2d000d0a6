// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/save_name.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

namespace flatland::ui {

namespace {

struct SaveName {
  Q_DECLARE_TR_FUNCTIONS(SaveName)
};

QString suffixOfFilter(const QString& filter) {
  QString suffix = filter.section('*', 1, 1);
  while (suffix.endsWith(' ') || suffix.endsWith(')')) suffix.chop(1);
  return suffix;
}

}  // namespace

bool mayReplace(QWidget* parent, const QString& name) {
  if (!QFileInfo::exists(name)) return true;
  return QMessageBox::question(
             parent, SaveName::tr("Replace file"),
             SaveName::tr("%1 exists. Replace it?").arg(QFileInfo(name).fileName())) ==
         QMessageBox::Yes;
}

QString askSaveName(QWidget* parent, const QString& title, const QString& suggested,
                    const QStringList& filters) {
  QString filter = filters.front();
  QString name =
      QFileDialog::getSaveFileName(parent, title, suggested, filters.join(";;"), &filter);
  if (name.isEmpty() || !QFileInfo(name).suffix().isEmpty()) return name;
  // The dialog has asked about the bare name only.
  const QString suffix = suffixOfFilter(filter);
  name += suffix.isEmpty() ? suffixOfFilter(filters.front()) : suffix;  // "All files (*)" has none
  return mayReplace(parent, name) ? name : QString();
}

}  // namespace flatland::ui
