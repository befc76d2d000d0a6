// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/file_controller.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QSettings>
#include <algorithm>
#include <typeinfo>

#include "flatland/io/input_error.h"
#include "flatland/io/scene_json.h"
#include "ui/app/message_bar.h"
#include "ui/commands/scene_commands.h"
#include "ui/import/shown_svg.h"
#include "ui/model/core_sentences.h"
#include "ui/model/core_words.h"
#include "ui/model/loaded_surface.h"
#include "ui/model/paths.h"
#include "ui/model/unsaved_work.h"
#include "ui/panels/save_name.h"

namespace flatland::ui {

namespace {

constexpr char kRecentKey[] = "files/recent";
constexpr char kSuffix[] = ".json";

QString filter() { return FileController::tr("Flatland scenes (*.json);;All files (*)"); }
QStringList filters() { return filter().split(";;"); }

}  // namespace

QString shownName(const Document& document) {
  if (document.file().empty()) {
    return document.originName().isEmpty() ? FileController::tr("Untitled") : document.originName();
  }
  return toQString(document.file().filename());
}

QString shownTitle(const Document& document) {
  const auto& surface = document.scene().surface;
  if (!surface || surface->swept) return shownName(document);
  const QString mesh = QString::fromStdString(surfaceName(surface->mesh));
  // Beside an example that nobody asked for it is what one is looking at.
  if (document.file().empty()) return mesh;
  return FileController::tr("%1 – %2", "scene, mesh").arg(shownName(document), mesh);
}

QString presetName(const Preset& preset) { return coreWords(preset.name); }

FileController::FileController(QWidget& window, Document& document, MessageBar& messages,
                               QSettings* settings)
    : QObject(&window),
      window_(window),
      document_(document),
      messages_(messages),
      settings_(settings) {}

void FileController::startNew() { startPreset(presets().front()); }

void FileController::startPreset(const Preset& preset) {
  if (!mayDiscard()) return;
  messages_.hide();
  document_.start(preset.scene, presetName(preset));
  if (!preset.expected.empty())
    messages_.showNote(tr("Expected: %1").arg(coreWords(preset.expected)));
}

void FileController::open() {
  const QString folder = QFileInfo(suggestedName()).path();
  const QString name = QFileDialog::getOpenFileName(
      &window_, tr("Open scene"), folder, tr("Scenes and drawings (*.json *.svg);;All files (*)"));
  if (!name.isEmpty()) openFile(name);
}

void FileController::openFile(const QString& name) {
  if (other_ && other_(name)) return;
  if (!mayDiscard()) return;
  try {
    if (isSvgName(name.toStdString())) {
      // A drawing starts a scene of its own: saving must not replace the drawing.
      ImportedScene imported = loadSvgToShow(name);
      document_.start(std::move(imported.scene), QFileInfo(name).fileName());
      messages_.showNote(importForPeople(imported));
    } else {
      document_.open(toPath(name));
      messages_.hide();
    }
    remember(name);
  } catch (const InputError& error) {
    messages_.showError(errorForPeople(error));
    if (!QFileInfo::exists(name)) forget(name);
  }
}

bool FileController::save() {
  return document_.file().empty() ? saveAs() : saveTo(toQString(document_.file()));
}

bool FileController::saveAs() {
  const QString name = askSaveName(&window_, tr("Save scene as"), suggestedName(), filters());
  return !name.isEmpty() && saveTo(name);
}

bool FileController::saveLessonScene() {
  const QString name =
      askSaveName(&window_, tr("Save scene as"), tr("lesson") + kSuffix, filters());
  if (name.isEmpty()) return false;
  try {
    saveScene(document_.scene(), toPath(name));
  } catch (const InputError& error) {
    messages_.showError(errorForPeople(error));
    return false;
  }
  remember(name);
  return true;
}

bool FileController::saveTo(const QString& name) {
  emit aboutToUseFile();
  try {
    document_.save(toPath(name));
  } catch (const InputError& error) {
    messages_.showError(errorForPeople(error));
    return false;
  }
  messages_.hide();
  remember(name);
  return true;
}

namespace {

/// The text of the last command since the scene was saved that put another in its place; empty if
/// there is none. Lessons and Reset, which bring back what was there, are kinds of their own.
QString whatReplacedIt(const QUndoStack& stack) {
  for (int i = stack.index() - 1; i >= std::max(stack.cleanIndex(), 0); --i) {
    const QUndoCommand* command = stack.command(i);
    if (typeid(*command) == typeid(ReplaceScene)) return command->text();
  }
  return {};
}

}  // namespace

QMessageBox::StandardButton FileController::askToSave(const QString& question,
                                                      const QString& otherwise) {
  QMessageBox box(QMessageBox::Warning, tr("Unsaved changes"), question,
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &window_);
  box.setObjectName("unsaved");
  box.setInformativeText(otherwise);
  box.setDefaultButton(QMessageBox::Save);
  return static_cast<QMessageBox::StandardButton>(box.exec());
}

QString FileController::whatWouldBeLost() const {
  const Scene& own = ownScene_ ? ownScene_() : document_.scene();
  const int index = ownUndoIndex_ ? ownUndoIndex_() : document_.undoStack().index();
  const UnsavedWork gone = workTakenOut(document_.undoStack(), index, own, document_.saved());
  QStringList sentences;
  if (!document_.file().empty()) {
    sentences << tr("Lost otherwise: %1.").arg(changesForPeople(own, document_.saved()));
  } else if (const UnsavedWork work = unsavedWork(own, document_.saved()); work.any()) {
    sentences << tr("Lost otherwise: %1.").arg(workForPeople(work, own));
  }
  if (gone.any()) {
    sentences << tr("Only Undo brings back what was taken out of it: %1.").arg(workForPeople(gone));
  }
  return sentences.join(" ");
}

bool FileController::mayDiscard() {
  const bool unsaved = hasUnsavedWork_ ? hasUnsavedWork_() : document_.isModified();
  if (hasLessonEdits_ && hasLessonEdits_()) {
    const auto answer = askToSave(tr("Save the scene of the lesson as you changed it?"),
                                  tr("It is lost otherwise. Your own scene stays as it was."));
    if (answer == QMessageBox::Cancel) return false;
    if (answer == QMessageBox::Save && !saveLessonScene()) return false;
    emit aboutToUseFile();
  }
  if (!unsaved) {
    emit aboutToUseFile();
    return true;
  }
  // Another scene in the place of the one with that name is no change of it.
  const QString replaced = whatReplacedIt(document_.undoStack());
  const QString question = document_.file().empty()
                               ? tr("Save this scene?")
                               : tr("Save the changes to %1?").arg(shownName(document_));
  const auto answer = replaced.isEmpty()
                          ? askToSave(question, whatWouldBeLost())
                          : askToSave(tr("Save the scene that took the place of %1 (%2)?")
                                          .arg(shownName(document_), replaced),
                                      tr("It is lost otherwise."));
  switch (answer) {
    case QMessageBox::Save:
      return save();
    case QMessageBox::Discard:
      emit aboutToUseFile();
      return true;
    default:
      return false;
  }
}

QStringList FileController::recentFiles() const {
  return settings_ ? settings_->value(kRecentKey).toStringList() : QStringList();
}

void FileController::clearRecentFiles() { setRecent({}); }

void FileController::remember(const QString& name) {
  const QString full = QFileInfo(name).absoluteFilePath();
  QStringList names = recentFiles();
  names.removeAll(full);
  names.prepend(full);
  setRecent(names.mid(0, kRecentFiles));
}

void FileController::forget(const QString& name) {
  QStringList names = recentFiles();
  names.removeAll(QFileInfo(name).absoluteFilePath());
  setRecent(names);
}

void FileController::setRecent(const QStringList& names) {
  if (!settings_ || names == recentFiles()) return;
  settings_->setValue(kRecentKey, names);
  emit recentFilesChanged();
}

QString FileController::suggestedName() const {
  if (!document_.file().empty()) return toQString(document_.file());
  const QStringList recent = recentFiles();
  const QString folder = recent.isEmpty() ? QDir::homePath() : QFileInfo(recent.front()).path();
  return folder + "/" + tr("scene") + kSuffix;
}

}  // namespace flatland::ui
