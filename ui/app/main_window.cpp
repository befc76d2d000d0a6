// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/main_window.h"

#include <QCloseEvent>
#include <QCoreApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QStatusBar>
#include <QVBoxLayout>

#include "flatland/io/input_error.h"
#include "ui/app/export_dialog.h"
#include "ui/app/key_sheet.h"
#include "ui/app/menus.h"
#include "ui/app/message_bar.h"
#include "ui/app/paths.h"
#include "ui/app/status_line.h"
#include "ui/panels/legend_panel.h"
#include "ui/panels/marks_panel.h"
#include "ui/panels/points_panel.h"
#include "ui/panels/view_panel.h"

namespace flatland::ui {

namespace {

constexpr int kLayoutVersion = 1;  ///< of saveState(): raise when docks come, go or change names
constexpr QSize kDefaultSize(1280, 800);
constexpr int kSideWidth = 280;
constexpr int kMarksHeight = 190;

QString droppedFile(const QMimeData& data) {
  const QList<QUrl> urls = data.urls();
  return urls.size() == 1 ? urls.front().toLocalFile() : QString();
}

}  // namespace

MainWindow::MainWindow(Scene scene, const QString& originName, QSettings* settings)
    : settings_(settings),
      document_(std::move(scene), originName),
      selection_(document_),
      stage_(document_) {
  setObjectName("window");
  setAcceptDrops(true);
  setDockNestingEnabled(true);
  status_ = new StatusLine(*statusBar(), document_);
  buildCentre();
  buildDocks();
  files_ = new FileController(*this, document_, *messages_, settings_);
  edits_ = new EditController({document_, selection_, viewport_, display_, stage_}, this);
  buildMenuBar();
  connectParts();
  resize(kDefaultSize);
  restoreDefaultLayout();
  if (settings_) {
    display_.restore(*settings_);
    restoreGeometry(settings_->value("window/geometry").toByteArray());
    restoreState(settings_->value("window/layout").toByteArray(), kLayoutVersion);
  }
  showTitle();
  canvas_->setFocus(Qt::OtherFocusReason);
}

MainWindow::~MainWindow() {
  // An undo stack that goes tells that it is clean; there is no title left to show it.
  disconnect(&document_.undoStack(), nullptr, this, nullptr);
  // The widgets look at the models to their end, so they go first.
  delete takeCentralWidget();
  for (QDockWidget* dock : {viewDock_, legendDock_, pointsDock_, marksDock_}) delete dock;
}

void MainWindow::buildCentre() {
  auto* centre = new QWidget(this);
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins({});
  layout->setSpacing(0);
  messages_ = new MessageBar(centre);
  canvas_ = new FlatCanvas({document_, selection_, viewport_, display_, stage_}, centre);
  layout->addWidget(messages_);
  layout->addWidget(canvas_, 1);
  setCentralWidget(centre);
}

QDockWidget* MainWindow::addDock(const char* id, const QString& title, QWidget* panel,
                                 Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(id);
  dock->setWidget(panel);
  addDockWidget(area, dock);
  return dock;
}

void MainWindow::buildDocks() {
  const CanvasModels models{document_, selection_, viewport_, display_, stage_};
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  viewDock_ =
      addDock("view", tr("View"), new ViewPanel(document_, stage_), Qt::RightDockWidgetArea);
  legendDock_ = addDock("legend", tr("Legend"), new LegendPanel(document_, display_),
                        Qt::RightDockWidgetArea);
  auto* points = new PointsPanel(document_, selection_);
  connect(points, &PointsPanel::refused, status_, &StatusLine::say);
  pointsDock_ = addDock("points", tr("Points"), points, Qt::RightDockWidgetArea);
  marksDock_ = addDock("marks", tr("Marks"), new MarksPanel(models), Qt::BottomDockWidgetArea);
}

void MainWindow::restoreDefaultLayout() {
  for (QDockWidget* dock : {viewDock_, legendDock_, pointsDock_, marksDock_}) {
    dock->setFloating(false);
    removeDockWidget(dock);
    addDockWidget(dock == marksDock_ ? Qt::BottomDockWidgetArea : Qt::RightDockWidgetArea, dock);
    dock->show();
  }
  const int rest = height() - viewDock_->sizeHint().height() - legendDock_->sizeHint().height();
  resizeDocks({viewDock_, legendDock_, pointsDock_},
              {viewDock_->sizeHint().height(), legendDock_->sizeHint().height(), rest},
              Qt::Vertical);
  resizeDocks({viewDock_}, {kSideWidth}, Qt::Horizontal);
  resizeDocks({marksDock_}, {kMarksHeight}, Qt::Vertical);
}

void MainWindow::buildMenuBar() {
  buildMenus({.window = *this,
              .models = {document_, selection_, viewport_, display_, stage_},
              .canvas = *canvas_,
              .files = *files_,
              .edits = *edits_,
              .docks = {viewDock_, legendDock_, pointsDock_, marksDock_},
              .exportFigure = [this] { exportFigure(); },
              .showKeys = [this] { showKeys(); },
              .showAbout = [this] { showAbout(); },
              .restoreLayout = [this] { restoreDefaultLayout(); }});
}

void MainWindow::connectParts() {
  connect(canvas_, &FlatCanvas::hint, status_, &StatusLine::showHint);
  connect(canvas_, &FlatCanvas::pointerAt, status_, [this](const std::optional<Vec2>& world) {
    status_->showPointer(world, viewport_.scale());
  });
  connect(edits_, &EditController::refused, status_, &StatusLine::say);
  connect(&document_.undoStack(), &QUndoStack::cleanChanged, this, &MainWindow::showTitle);
  connect(&document_, &Document::changed, this, [this](const Change& change) {
    if (change.what == Change::What::File || change.what == Change::What::Scene) showTitle();
  });
  status_->showHint(describe({document_, selection_, viewport_, display_, stage_}, {}));
}

void MainWindow::showTitle() {
  setWindowTitle(tr("%1[*] – Flatland").arg(shownName(document_)));
  setWindowModified(document_.isModified());
}

void MainWindow::showKeys() {
  if (!keys_) keys_ = new KeySheet(this);
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
    if (!files_->mayReplace(name)) return;
  }
  try {
    exportTo(toPath(name), document_, settings);
  } catch (const InputError& error) {
    messages_->showError(QString::fromStdString(error.what()));
    return;
  }
  messages_->hide();
  status_->say(tr("Exported to %1").arg(QDir::toNativeSeparators(name)));
  if (!settings_) return;
  settings.save(*settings_);
  settings_->setValue("export/folder", QFileInfo(name).absolutePath());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!files_->mayDiscard()) {
    event->ignore();
    return;
  }
  if (settings_) {
    settings_->setValue("window/geometry", saveGeometry());
    settings_->setValue("window/layout", saveState(kLayoutVersion));
    display_.save(*settings_);
  }
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!droppedFile(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  files_->openFile(droppedFile(*event->mimeData()));
}

}  // namespace flatland::ui
