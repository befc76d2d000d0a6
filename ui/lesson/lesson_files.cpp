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
#include "ui/model/core_sentences.h"
#include "ui/model/paths.h"

// In a static library resources register themselves only when asked to, from outside any namespace.
static void initLessonResources() { Q_INIT_RESOURCE(lesson_resources); }

namespace flatland::ui {

namespace {

constexpr char kRecentKey[] = "lessons/recent";
constexpr char kFolder[] = ":/lesson/lessons/";

bool isShipped(const QString& name) { return name.startsWith(':'); }

Lesson read(const QString& name) {
  if (!isShipped(name)) return loadLesson(toPath(name));
  QFile file(name);  // within the program, where only Qt can read
  file.open(QIODevice::ReadOnly);
  return lessonFromText(file.readAll().toStdString(), name.toStdString());
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
  for (const char* id : {"silhouette", "apparent-ridge", "offset", "surface"}) {
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
    emit failed(errorForPeople(error));
    return;
  }
  if (settings_ && !isShipped(name)) {
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
