// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMessageBox>
#include <QObject>
#include <QStringList>
#include <functional>
#include <utility>

#include "flatland/scene/scene.h"
#include "ui/model/document.h"

class QSettings;
class QWidget;

namespace flatland::ui {

class MessageBar;

/// Opening, saving and starting over, with the question about unsaved work before anything is lost.
/// Failures go to the message bar and leave document and files as they were.
class FileController : public QObject {
  Q_OBJECT

 public:
  /// `settings` remembers recent files and the last folder; null: nothing is remembered.
  FileController(QWidget& window, Document& document, MessageBar& messages, QSettings* settings);

  void startNew();
  /// Says the answer expected, where the preset has one.
  void startPreset(const Preset& preset);
  void open();  ///< asks which file
  /// A scene; or a drawing (.svg), which starts an unnamed scene; or what the other opener takes.
  void openFile(const QString& name);
  /// Asked first about every file; true if it has taken it. A mesh is no scene of its own.
  void setOtherOpener(std::function<bool(const QString&)> opener) { other_ = std::move(opener); }
  bool save();  ///< asks for a name if there is none; false if not saved
  bool saveAs();
  bool saveTo(const QString& name);

  /// True if nothing unsaved is left, the person let it go, or it has been saved now.
  bool mayDiscard();

  /// What mayDiscard() asks instead of Document::isModified(): a lesson is no work of the person's,
  /// whose own scene is another.
  void setUnsavedWork(std::function<bool()> has, std::function<const Scene&()> scene,
                      std::function<int()> undoIndex) {
    hasUnsavedWork_ = std::move(has);
    ownScene_ = std::move(scene);
    ownUndoIndex_ = std::move(undoIndex);
  }

  /// Whether a lesson is open whose scene was changed: mayDiscard() offers to save that scene too,
  /// which is not the person's own.
  void setLessonEdits(std::function<bool()> has) { hasLessonEdits_ = std::move(has); }

  /// Files opened or saved last, newest first; also those that are gone in the meantime.
  QStringList recentFiles() const;
  void clearRecentFiles();
  /// Puts a file that was opened at the head of the list.
  void remember(const QString& name);
  static constexpr int kRecentFiles = 8;

 signals:
  /// Before the scene is saved or given up, when every question about that has been answered.
  void aboutToUseFile();
  void recentFilesChanged();

 private:
  /// Of Save, Discard and Cancel.
  QMessageBox::StandardButton askToSave(const QString& question, const QString& otherwise);
  QString whatWouldBeLost() const;
  /// Asks for a name and writes what is shown, whatever the document's own file is.
  bool saveLessonScene();
  void forget(const QString& name);
  void setRecent(const QStringList& names);
  QString suggestedName() const;

  QWidget& window_;
  Document& document_;
  MessageBar& messages_;
  QSettings* settings_;
  std::function<bool()> hasUnsavedWork_, hasLessonEdits_;
  std::function<const Scene&()> ownScene_;
  std::function<int()> ownUndoIndex_;
  std::function<bool(const QString&)> other_;
};

/// "Untitled" or the name of the file without its folder.
QString shownName(const Document& document);

/// What the window shows: the scene, the mesh beside it, or the mesh alone beside a scene that
/// never had a file.
QString shownTitle(const Document& document);

/// The name of a preset in the person's language.
QString presetName(const Preset& preset);

}  // namespace flatland::ui
