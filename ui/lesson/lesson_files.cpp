// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lesson_files.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>
#include <QWidget>
#include <utility>

#include "flatland/io/input_error.h"

// In a static library resources register themselves only when asked to, from outside any namespace.
static void initLessonResources() { Q_INIT_RESOURCE(lesson_resources); }

namespace flatland::ui {

namespace {

constexpr char kRecentKey[] = "lessons/recent";
constexpr char kFolder[] = ":/lesson/lessons/";

Lesson read(const QString& name) {
  QFile file(name);
  const std::string source = name.toStdString();
  if (QFileInfo(name).isDir() || !file.open(QIODevice::ReadOnly)) {
    throw InputError(source, "", "cannot be read");
  }
  const QByteArray text = file.read(static_cast<qint64>(kLargestLessonBytes) + 1);
  return lessonFromText(text.toStdString(), source);
}

}  // namespace

LessonFiles::LessonFiles(QWidget& window, LessonModel& lesson, QString language,
                         QSettings* settings)
    : QObject(&window),
      window_(window),
      lesson_(lesson),
      language_(std::move(language)),
      settings_(settings) {
  initLessonResources();
}

QList<LessonFiles::Shipped> LessonFiles::shipped() const {
  QList<Shipped> list;
  for (const char* id : {"silhouette", "apparent-ridge", "offset"}) {
    const QString translated = QString(kFolder) + language_ + "/" + id + ".md";
    const QString file = QFile::exists(translated) ? translated : QString(kFolder) + id + ".md";
    list << Shipped{file, QString::fromStdString(read(file).title)};
  }
  return list;
}

void LessonFiles::open() {
  const QStringList recent = recentFiles();
  const QString folder = recent.isEmpty() ? QDir::homePath() : QFileInfo(recent.front()).path();
  const QString name = QFileDialog::getOpenFileName(&window_, tr("Open lesson"), folder,
                                                    tr("Lessons (*.md);;All files (*)"));
  if (!name.isEmpty()) openFile(name);
}

void LessonFiles::openFile(const QString& name) {
  try {
    lesson_.start(read(name));
  } catch (const InputError& error) {
    emit failed(QString::fromStdString(error.what()));
    return;
  }
  if (settings_ && !name.startsWith(':')) {
    QStringList names = recentFiles();
    const QString full = QFileInfo(name).absoluteFilePath();
    names.removeAll(full);
    names.prepend(full);
    settings_->setValue(kRecentKey, names.mid(0, kRecentFiles));
  }
  emit opened();
}

QStringList LessonFiles::recentFiles() const {
  return settings_ ? settings_->value(kRecentKey).toStringList() : QStringList();
}

}  // namespace flatland::ui
