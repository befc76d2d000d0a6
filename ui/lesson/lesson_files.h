// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

#include "ui/lesson/lesson_model.h"

class QSettings;
class QWidget;

namespace flatland::ui {

/// The lessons there are: those that come with the program, and files. One that cannot be read is
/// told by `failed`, and nothing changes.
class LessonFiles : public QObject {
  Q_OBJECT

 public:
  /// `language` is the code of the window's language. `settings` remembers recent files; null:
  /// nothing is remembered.
  LessonFiles(QWidget& window, LessonModel& lesson, QString language, QSettings* settings);

  struct Shipped {
    QString file;
    QString title;
  };
  /// In the language of the window where there is a translation (a folder of the language's code
  /// beside them), else in English.
  QList<Shipped> shipped() const;

  void open();  ///< asks which file
  void openFile(const QString& name);

  QStringList recentFiles() const;
  static constexpr int kRecentFiles = 8;

 signals:
  void failed(const QString& why);
  void opened();

 private:
  QWidget& window_;
  LessonModel& lesson_;
  QString language_;
  QSettings* settings_;
};

}  // namespace flatland::ui
