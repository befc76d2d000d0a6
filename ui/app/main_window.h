// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <memory>

#include "ui/app/docks.h"
#include "ui/app/edit_controller.h"
#include "ui/app/file_controller.h"
#include "ui/app/import_controller.h"
#include "ui/flat/canvas.h"
#include "ui/lesson/lesson_files.h"
#include "ui/model/bridges.h"
#include "ui/model/plots.h"
#include "ui/view3d/surface_models.h"

class QSettings;
class QSplitter;
class QToolBar;

namespace flatland::ui {

class BridgeController;
class KeySheet;
class Layouts;
class Look;
class MessageBar;
class StatusLine;
class SurfaceArea;
class SurfaceProgress;
class SurfaceController;

/// The window: puts models, canvas, panels, menus and status line together and does nothing else.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// Shows `scene` as an unnamed document. `settings` keeps layout, recent files and choices from
  /// one session to the next and outlives the window; null: everything as on the first day.
  MainWindow(Scene scene, const QString& originName, QSettings* settings);
  ~MainWindow() override;

  // For what drives the window from outside: the start of the program, tests.
  Document& document() { return document_; }
  Selection& selection() { return selection_; }
  Viewport& viewport() { return viewport_; }
  Display& display() { return display_; }
  Stage& stage() { return stage_; }
  Probe& probe() { return probe_; }
  Plots& plots() { return plots_; }
  FlatCanvas& canvas() { return *canvas_; }
  FileController& files() { return *files_; }
  LessonModel& lesson() { return lesson_; }
  LessonFiles& lessons() { return *lessons_; }
  ImportController& imports() { return *imports_; }
  SurfaceModels surfaceModels() {
    return {document_,    surfaceSource_, surfaceViews_.seen(0), display_,
            surfacePick_, surfaceStudy_,  surfaceViews_,         bridges_};
  }
  Bridges& bridges() { return bridges_; }
  SurfaceController& surfaces() { return *surfaces_; }
  SurfaceArea& surfaceArea() { return *surfaceArea_; }

  void showKeys();
  void exportFigure();
  Layouts& layouts() { return *layouts_; }
  Docks& docks() { return *docks_; }

 protected:
  void closeEvent(QCloseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void buildCentre();
  void buildMenuBar();
  void connectParts();
  void connectSurface();
  static constexpr int kSurfaceShare = 2;  ///< of the width, to one of the canvas
  void shareCentre(int surfaceShare = kSurfaceShare);
  void showCentre();  ///< the surface and the curves, as far as there are any
  CanvasModels models() { return {document_, selection_, viewport_, display_, stage_, probe_}; }
  void setLanguage(const QString& code);
  void showTitle();
  void showAbout();

  QSettings* settings_;
  Document document_;
  Selection selection_;
  Viewport viewport_;
  Display display_;
  Stage stage_;
  Probe probe_;
  Plots plots_;
  LessonModel lesson_;
  SurfaceSource surfaceSource_;
  SurfaceViews surfaceViews_;
  SurfacePick surfacePick_;
  SurfaceStudy surfaceStudy_;
  Bridges bridges_;
  std::unique_ptr<Docks> docks_;
  Look* look_ = nullptr;
  Layouts* layouts_ = nullptr;
  QToolBar* pictureBar_ = nullptr;
  MessageBar* messages_ = nullptr;
  QSplitter* centre_ = nullptr;
  SurfaceArea* surfaceArea_ = nullptr;
  bool wasClosed_ = false;              ///< a surface, from its own layout, by hand
  SurfaceProgress* reading_ = nullptr;  ///< of a mesh, while no surface is shown
  SurfaceController* surfaces_ = nullptr;
  BridgeController* bridgeController_ = nullptr;
  FlatCanvas* canvas_ = nullptr;
  StatusLine* status_ = nullptr;
  FileController* files_ = nullptr;
  LessonFiles* lessons_ = nullptr;
  EditController* edits_ = nullptr;
  ImportController* imports_ = nullptr;
  KeySheet* keys_ = nullptr;
};

}  // namespace flatland::ui
