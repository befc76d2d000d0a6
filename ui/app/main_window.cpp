// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/main_window.h"

#include <QCloseEvent>
#include <QCoreApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QKeyEvent>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QSplitter>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>
#include <utility>

#include "flatland/io/input_error.h"
#include "ui/app/bridge_controller.h"
#include "ui/app/export_dialog.h"
#include "ui/app/key_sheet.h"
#include "ui/app/language.h"
#include "ui/app/layouts.h"
#include "ui/app/lesson_controller.h"
#include "ui/app/look.h"
#include "ui/app/menus.h"
#include "ui/app/message_bar.h"
#include "ui/app/panels.h"
#include "ui/app/status_line.h"
#include "ui/app/surface_controller.h"
#include "ui/flat/crossing_overlay.h"
#include "ui/import/mesh_name.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/model/core_sentences.h"
#include "ui/model/paths.h"
#include "ui/panels/save_name.h"
#include "ui/view3d/derivation_panel.h"
#include "ui/view3d/section_panel.h"
#include "ui/view3d/surface_area.h"
#include "ui/view3d/surface_progress.h"
#include "ui/view3d/triangle_panel.h"

namespace flatland::ui {

namespace {

constexpr QSize kDefaultSize(1280, 800);

QString droppedFile(const QMimeData& data) {
  const QList<QUrl> urls = data.urls();
  return urls.size() == 1 ? urls.front().toLocalFile() : QString();
}

}  // namespace

MainWindow::MainWindow(Scene scene, const QString& originName, QSettings* settings)
    : settings_(settings),
      document_(std::move(scene), originName),
      selection_(document_),
      stage_(document_),
      probe_(document_),
      plots_(document_, selection_, display_, probe_),
      lesson_(document_, probe_, display_),
      surfaceSource_(document_),
      surfaceViews_(document_, surfaceSource_),
      surfacePick_(surfaceSource_),
      surfaceStudy_(document_, surfacePick_, surfaceViews_),
      bridges_(document_, surfaceSource_, surfaceViews_.seen(0)),
      docks_(std::make_unique<Docks>(*this)) {
  setObjectName("window");
  setAcceptDrops(true);
  setDockNestingEnabled(true);
  look_ = new Look(display_, this);
  status_ = new StatusLine(*statusBar(), document_);
  buildCentre();
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  const SurfaceModels surface = surfaceModels();
  addPanels(*docks_, models(),
            {.status = *status_,
             .messages = *messages_,
             .plots = plots_,
             .lesson = lesson_,
             .surface = surface,
             .settings = settings_});
  files_ = new FileController(*this, document_, *messages_, settings_);
  lessons_ = new LessonFiles(*this, lesson_, installedLanguage(), settings_);
  edits_ = new EditController(models(), this);
  imports_ = new ImportController(*this, models(), *messages_);
  surfaces_ = new SurfaceController(*this, surface, *files_, *messages_, settings_);
  bridgeController_ = new BridgeController(models(), *docks_, *findChild<SectionPanel*>(), this);
  resize(kDefaultSize);
  pictureBar_ = addToolBar(tr("Picture"));
  pictureBar_->setObjectName("picture-bar");
  layouts_ = new Layouts(*this, *docks_, display_, *pictureBar_, *surfaceArea_);
  buildMenuBar();
  connectParts();
  connectSurface();
  if (settings_) {
    display_.restore(*settings_);
    layouts_->restore(*settings_);
  }
  showCentre();
  // The layout kept may be that of a surface which is not there any more.
  if (document_.scene().surface) {
    layouts_->use(Layouts::Kind::Surface);
    shareCentre();
  } else if (layouts_->current() == Layouts::Kind::Surface) {
    layouts_->use(Layouts::Kind::Work);
  }
  showTitle();
  canvas_->setFocus(Qt::OtherFocusReason);
}

MainWindow::~MainWindow() {
  // An undo stack that goes tells that it is clean; there is no title left to show it.
  disconnect(&document_.undoStack(), nullptr, this, nullptr);
  // The widgets look at the models to their end, so they go first.
  surfaceSource_.cancel();
  delete takeCentralWidget();
  docks_.reset();
}

void MainWindow::buildCentre() {
  auto* centre = new QWidget(this);
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins({});
  layout->setSpacing(0);
  messages_ = new MessageBar(centre);
  reading_ = new SurfaceProgress(surfaceModels(), SurfaceProgress::Says::Reading, centre);
  centre_ = new QSplitter(Qt::Horizontal, centre);
  centre_->setChildrenCollapsible(false);
  surfaceArea_ = new SurfaceArea(surfaceModels(), centre_);
  canvas_ = new FlatCanvas(models(), centre_);
  new CrossingOverlay(bridges_, viewport_, display_, *canvas_);
  centre_->setStretchFactor(0, kSurfaceShare);
  centre_->setStretchFactor(1, 1);
  surfaceArea_->hide();
  layout->addWidget(messages_);
  layout->addWidget(reading_);
  layout->addWidget(centre_, 1);
  setCentralWidget(centre);
}

void MainWindow::buildMenuBar() {
  buildMenus({.window = *this,
              .models = models(),
              .canvas = *canvas_,
              .files = *files_,
              .edits = *edits_,
              .plots = plots_,
              .lesson = lesson_,
              .lessons = *lessons_,
              .imports = *imports_,
              .surfaces = *surfaces_,
              .bridges = *bridgeController_,
              .surfaceArea = *surfaceArea_,
              .docks = docks_->all(),
              .exportFigure = [this] { exportFigure(); },
              .showKeys = [this] { showKeys(); },
              .showAbout = [this] { showAbout(); },
              .layouts = *layouts_,
              .pictureBar = *pictureBar_,
              .language = settings_ ? chosenLanguage(*settings_) : QStringLiteral("system"),
              .setLanguage = [this](const QString& code) { setLanguage(code); }});
}

void MainWindow::connectParts() {
  connect(canvas_, &FlatCanvas::hint, status_, [this](const QString& text) {
    if (canvas_->isVisible()) status_->showHint(text);  // else the surface has all the room
  });
  connect(canvas_, &FlatCanvas::pointerAt, status_, [this](const std::optional<Vec2>& world) {
    status_->showPointer(world, viewport_.scale());
  });
  connect(status_, &StatusLine::placePicked, &viewport_, &Viewport::centreOn);
  connect(&display_, &Display::changed, status_,
          [this] { status_->setFewFields(display_.isProjector()); });
  connect(lessons_, &LessonFiles::failed, messages_, &MessageBar::showError);
  connect(lessons_, &LessonFiles::opened, messages_, &QWidget::hide);
  auto* lessons = new LessonController(lesson_, *layouts_, *docks_, *findChild<LessonPanel*>(),
                                       *surfaceArea_, *canvas_, *centre_, this);
  lessons->lendKeys(*findChild<DerivationPanel*>());
  lessons->lendKeys(*findChild<TrianglePanel*>());
  connect(&lesson_, &LessonModel::pickWanted, this, [this](const LessonPick& pick) {
    surfacePick_.pickWhenRead(pick.isTriangle, pick.number);
  });
  // A file is about the person's own scene, never about a step's.
  connect(files_, &FileController::aboutToUseFile, &lesson_, &LessonModel::leave);
  files_->setUnsavedWork([this] { return lesson_.hasUnsavedWork(); },
                         [this]() -> const Scene& { return lesson_.ownScene(); },
                         [this] { return lesson_.ownUndoIndex(); });
  files_->setLessonEdits([this] { return lesson_.hasEdits(); });
  connect(edits_, &EditController::refused, status_, &StatusLine::say);
  connect(&lesson_, &LessonModel::changed, this, &MainWindow::showTitle);
  connect(&document_.undoStack(), &QUndoStack::cleanChanged, this, &MainWindow::showTitle);
  connect(&document_.undoStack(), &QUndoStack::indexChanged, this, &MainWindow::showTitle);
  connect(&document_, &Document::changed, this, [this](const Change& change) {
    if (change.what == Change::What::File || change.touchesSurface()) showTitle();
  });
  status_->showHint(describe(models(), {}));
}

void MainWindow::shareCentre(int surfaceShare) {
  constexpr int kMuch = 10000;  // the splitter makes it fit
  centre_->setSizes({surfaceShare * kMuch, kMuch});
}

void MainWindow::showCentre() {
  const bool surface = document_.scene().surface.has_value();
  const bool appears = surface && surfaceArea_->isHidden();
  layouts_->setSurfaceThere(surface);
  if (appears && !surfaceArea_->isHidden()) shareCentre();
  reading_->setWanted(surfaceArea_->isHidden());  // else it says so itself
  const bool unwanted =
      document_.scene().curves.empty() || (surface && !layouts_->showsFlatBeside());
  canvas_->setHidden(!surfaceArea_->isHidden() && unwanted);
}

void MainWindow::connectSurface() {
  connect(layouts_, &Layouts::changed, this, &MainWindow::showCentre);
  files_->setOtherOpener([this](const QString& name) {
    if (!isMeshName(name.toStdString())) return false;
    surfaces_->openFile(name);
    return true;
  });
  connect(surfaceArea_, &SurfaceArea::hint, status_, &StatusLine::showHint);
  connect(surfaceArea_, &SurfaceArea::failed, messages_, &MessageBar::showError);
  connect(surfaces_, &SurfaceController::said, status_, &StatusLine::say);
  // Who opens a surface, or a scene with one, wants to see it; from then on it is the layout's.
  const auto showSurface = [this] {
    if (layouts_->showsSurfaces()) return;
    layouts_->use(Layouts::Kind::Surface);
    shareCentre();
  };
  connect(&surfaceSource_, &SurfaceSource::opened, this, [this, showSurface] {
    showSurface();
    // Its keys and hints are wanted now, unless one is at work in a panel.
    const QWidget* at = focusWidget();
    if (!at || at == canvas_) surfaceArea_->focusView();
  });
  connect(surfaceArea_, &SurfaceArea::openWanted, surfaces_, &SurfaceController::open);
  connect(surfaces_, &SurfaceController::closed, this, [this] {
    wasClosed_ = layouts_->current() == Layouts::Kind::Surface;
    if (wasClosed_) layouts_->use(Layouts::Kind::Work);
    canvas_->setFocus(Qt::OtherFocusReason);
  });
  connect(bridgeController_, &BridgeController::surfaceWanted, this, showSurface);
  connect(bridgeController_, &BridgeController::said, status_, &StatusLine::say);
  // Who opens a section wants to see the curve, and the marks of both beside one another.
  connect(bridgeController_, &BridgeController::curvesWanted, this, [this] {
    layouts_->setFlatBeside(true);
    if (canvas_->width() < surfaceArea_->width()) shareCentre(1);
  });
  connect(&document_, &Document::changed, this, [this, showSurface](const Change& change) {
    if (change.touchesScene() || change.touchesSurface()) showCentre();
    // Undo of closing brings the surface back where it was.
    if (document_.scene().surface && std::exchange(wasClosed_, false)) showSurface();
    if (change.what != Change::What::Scene) return;
    if (document_.scene().surface) {
      showSurface();
    } else if (layouts_->current() == Layouts::Kind::Surface) {
      // What was opened is flat: an empty panel would take its place.
      layouts_->use(Layouts::Kind::Work);
    }
  });
}

void MainWindow::setLanguage(const QString& code) {
  if (settings_) chooseLanguage(*settings_, code);
  status_->say(tr("The language changes when the window is opened the next time."));
}

void MainWindow::showTitle() {
  const QString shown =
      lesson_.isOpen() ? QString::fromStdString(lesson_.lesson().title) : shownTitle(document_);
  setWindowTitle(tr("%1[*] – Flatland").arg(shown));
  setWindowModified(lesson_.hasUnsavedWork() || lesson_.hasEdits());
}

void MainWindow::showKeys() {
  // Anew: the window may have another width, the type another size.
  if (!keys_ || !keys_->isVisible()) {
    delete keys_;
    keys_ = new KeySheet(this);
  }
  keys_->show();
  keys_->raise();
  keys_->activateWindow();
}

void MainWindow::showAbout() {
  QMessageBox::about(
      this, tr("About Flatland"),
      tr("<h3>Flatland %1</h3><p>View-dependent curvature and apparent ridges of plane curves, "
         "seen "
         "on a one-dimensional screen.</p><p>Free software under the GNU General Public License, "
         "version 3 or later.</p>")
          .arg(QCoreApplication::applicationVersion()));
}

void MainWindow::exportFigure() {
  ExportSettings settings;
  settings.figure.kinds = display_.families();
  if (settings_) settings.restore(*settings_);
  ExportDialog dialog(document_, settings, this);
  if (dialog.exec() != QDialog::Accepted) return;
  settings = dialog.settings();
  const QString suffix = suffixOf(settings.format);
  const QString folder = settings_ ? settings_->value("export/folder").toString() : QString();
  QString name = QFileDialog::getSaveFileName(this, tr("Export picture"),
                                              QDir(folder).filePath(tr("picture") + "." + suffix),
                                              tr("%1 files (*.%2)").arg(suffix.toUpper(), suffix));
  if (name.isEmpty()) return;
  if (QFileInfo(name).suffix().compare(suffix, Qt::CaseInsensitive) != 0) {
    name += "." + suffix;
    if (!mayReplace(this, name)) return;
  }
  try {
    exportTo(toPath(name), document_, settings);
  } catch (const InputError& error) {
    messages_->showError(errorForPeople(error));
    return;
  }
  messages_->hide();
  status_->say(tr("Exported to %1").arg(QDir::toNativeSeparators(name)));
  if (!settings_) return;
  settings.save(*settings_);
  settings_->setValue("export/folder", QFileInfo(name).absolutePath());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!surfaces_->finishExports() || !files_->mayDiscard()) {
    event->ignore();
    return;
  }
  if (settings_) {
    layouts_->save(*settings_);
    display_.save(*settings_);
  }
  event->accept();
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && display_.isProjector()) {
    layouts_->toggleProjector();
  } else {
    QMainWindow::keyPressEvent(event);
  }
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!droppedFile(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  files_->openFile(droppedFile(*event->mimeData()));
}

}  // namespace flatland::ui
