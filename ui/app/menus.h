// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QList>
#include <functional>

#include "ui/app/edit_controller.h"
#include "ui/app/file_controller.h"
#include "ui/app/import_controller.h"
#include "ui/flat/canvas.h"
#include "ui/lesson/lesson_files.h"

class QAction;
class QDockWidget;
class QMainWindow;
class QMenu;
class QToolBar;

namespace flatland::ui {

class Layouts;
class Plots;
class SurfaceArea;
class BridgeController;
class SurfaceController;

/// What the menus act on; all of it outlives them.
struct MenuParts {
  QMainWindow& window;
  CanvasModels models;
  FlatCanvas& canvas;
  FileController& files;
  EditController& edits;
  Plots& plots;
  LessonModel& lesson;
  LessonFiles& lessons;
  ImportController& imports;
  SurfaceController& surfaces;
  BridgeController& bridges;
  SurfaceArea& surfaceArea;
  QList<QDockWidget*> docks;
  std::function<void()> exportFigure;
  std::function<void()> showKeys;
  std::function<void()> showAbout;
  Layouts& layouts;
  QToolBar& pictureBar;
  QString language;                                 ///< the one chosen, see language.h
  std::function<void(const QString&)> setLanguage;  ///< from the next start on
};

/// Fills the menu bar. Every action has an object name ("file.open"), which tests and later
/// shortcut editors find it by, and a tip.
void buildMenus(const MenuParts& parts);

// One menu each, for buildMenus().
void buildFileMenu(QMenu& menu, const MenuParts& parts);
void buildEditMenu(QMenu& menu, const MenuParts& parts);
void buildCurveMenu(QMenu& menu, const MenuParts& parts);
void buildViewMenu(QMenu& menu, const MenuParts& parts);
void addLayoutMenus(QMenu& viewMenu, const MenuParts& parts);  ///< layout, theme, size, language
void buildProbeMenu(QMenu& menu, const MenuParts& parts);      // within the View menu
void buildSurfaceMenu(QMenu& menu, const MenuParts& parts);
void buildCompareMenu(QMenu& menu, const MenuParts& parts);         // within the Surface menu
void addBridgeActions(QMenu& surfaceMenu, const MenuParts& parts);  // between curves and surfaces
void buildLessonMenu(QMenu& menu, const MenuParts& parts);
void buildHelpMenu(QMenu& menu, const MenuParts& parts);

/// How an action is met: by name, in the menu, by keys, in words.
struct ActionText {
  const char* id;
  QString text;
  QString tip;
  QList<QKeySequence> keys{};
};

/// Adds a menu in a menu.
QMenu& addSubmenu(QMenu& menu, const char* id, const QString& title);

/// Adds an action that calls `act`.
QAction* addAction(QMenu& menu, const ActionText& text, std::function<void()> act);

/// Adds an action that is on or off and calls `act` with its state.
QAction* addSwitch(QMenu& menu, const ActionText& text, std::function<void(bool)> act);

}  // namespace flatland::ui
