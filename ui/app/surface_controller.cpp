// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/surface_controller.h"

#include <QApplication>
#include <QDir>
#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>
#include <algorithm>
#include <utility>

#include "ui/app/file_controller.h"
#include "ui/app/message_bar.h"
#include "ui/app/surface_export_dialog.h"
#include "ui/commands/scene_commands.h"
#include "ui/import/mesh_name.h"
#include "ui/model/surface_look.h"
#include "ui/panels/save_name.h"

namespace flatland::ui {

namespace {

constexpr char kFolderKey[] = "surface/folder";
constexpr char kExportFolderKey[] = "export/folder";
constexpr char kExportFormatKey[] = "surface/export-format";
constexpr char kExportWidthKey[] = "surface/export-width";  ///< px

/// A mesh that is so much longer another way than upward may be standing, and may lie down.
constexpr double kUprightShare = 0.8;

bool mayLieDown(const TriangleMesh& mesh, const Eigen::Vector3d& up) {
  const auto extent = [](const std::vector<float>& places) {
    const auto [least, most] = std::minmax_element(places.begin(), places.end());
    return static_cast<double>(*most - *least);
  };
  const Eigen::Vector3d extents(extent(mesh.x), extent(mesh.y), extent(mesh.z));
  return extents.dot(up.cwiseAbs()) < kUprightShare * extents.maxCoeff();
}

QStringList meshPatterns() {
  QStringList patterns;
  for (const char* extension : kMeshExtensions) patterns << QStringLiteral("*.") + extension;
  return patterns;
}

}  // namespace

SurfaceController::SurfaceController(QWidget& window, const SurfaceModels& models,
                                     FileController& files, MessageBar& messages,
                                     QSettings* settings)
    : QObject(&window),
      window_(window),
      models_(models),
      files_(files),
      messages_(messages),
      settings_(settings),
      exporter_(models) {
  connect(&models_.source, &SurfaceSource::failed, &messages_, &MessageBar::showError);
  connect(&models_.views, &SurfaceViews::failed, &messages_, &MessageBar::showError);
  connect(&models_.source, &SurfaceSource::readingGivenUp, this, [this](const QString& reference) {
    const QString name = QString::fromStdString(surfaceName(reference.toStdString()));
    const bool stays = models_.source.surface() != nullptr;
    emit said(stays ? tr("Stopped reading %1. The surface before stays.").arg(name)
                    : tr("Stopped reading %1.").arg(name));
  });
  const Bridges& bridges = models_.bridges;
  connect(&bridges.source, &BridgeSource::failed, &messages_, &MessageBar::showError);
  connect(&bridges.section, &SectionSource::failed, &messages_, &MessageBar::showError);
  connect(&exporter_, &SurfaceExporter::failed, &messages_, &MessageBar::showError);
  connect(&exporter_, &SurfaceExporter::notYet, this,
          [this] { emit said(tr("The lines are not found yet; export again in a moment.")); });
  connect(&exporter_, &SurfaceExporter::written, this, [this](const QString& name) {
    messages_.hide();
    emit said(tr("Exported to %1").arg(QDir::toNativeSeparators(name)));
  });
  connect(&models_.source, &SurfaceSource::opened, this, [this](const QString& reference) {
    messages_.hide();
    if (!namesFile(reference.toStdString())) return;
    files_.remember(reference);
    if (settings_) settings_->setValue(kFolderKey, QFileInfo(reference).absolutePath());
  });
  connect(&models_.source, &SurfaceSource::changed, this, &SurfaceController::askWhetherItLies);
}

void SurfaceController::askWhetherItLies() {
  const auto& surface = models_.source.surface();
  const auto& setting = models_.document.scene().surface;
  if (!surface || !setting || setting->mesh != surface->reference) return;
  if (std::exchange(asked_, surface->reference) == surface->reference) return;
  if (!namesFile(surface->reference) || !mayLieDown(*surface->mesh, upAxisOf(*setting))) return;
  emit said(tr("Does it lie down? Surface > Up Axis stands it up."));
}

QString SurfaceController::folder() const {
  const auto& setting = models_.document.scene().surface;
  if (setting && namesFile(setting->mesh)) {
    return QFileInfo(QString::fromStdString(setting->mesh)).absolutePath();
  }
  return settings_ ? settings_->value(kFolderKey).toString() : QString();
}

void SurfaceController::open() {
  const QString name =
      QFileDialog::getOpenFileName(&window_, tr("Open mesh"), folder(),
                                   tr("Meshes (%1);;All files (*)").arg(meshPatterns().join(' ')));
  if (!name.isEmpty()) openFile(name);
}

void SurfaceController::openFile(const QString& name) {
  models_.source.open(QFileInfo(name).absoluteFilePath());
}

void SurfaceController::openSolid(const QString& name) {
  models_.source.open(QLatin1String(kSolidPrefix) + name);
}

bool SurfaceController::hasNeighbours() const {
  const auto& setting = models_.document.scene().surface;
  return setting && namesFile(setting->mesh);
}

void SurfaceController::openNeighbour(int step) {
  if (!hasNeighbours()) return;
  const QFileInfo now(QString::fromStdString(models_.document.scene().surface->mesh));
  const QDir dir(now.absolutePath());
  const QStringList names = dir.entryList(meshPatterns(), QDir::Files, QDir::Name);
  if (names.isEmpty()) return emit said(tr("There is no mesh in this folder any more."));
  qsizetype place = names.indexOf(now.fileName());
  if (place < 0) place = step > 0 ? -1 : 0;
  const qsizetype count = names.size();
  openFile(dir.filePath(names[(place + step + count) % count]));
}

void SurfaceController::close() {
  if (!models_.document.scene().surface) return;
  models_.source.close();
  emit closed();
}

void SurfaceController::exportPicture(const QSize& panel) {
  if (!models_.source.surface()) return;
  // Unit, colours and dots per inch are those of every export; the shape is that of the panel.
  ExportSettings settings;
  QString suffix = "svg";
  const double shape = static_cast<double>(qMax(panel.height(), 1)) / qMax(panel.width(), 1);
  settings.widthPx = panel.width();
  if (settings_) {
    settings.restore(*settings_);
    settings.widthPx = settings_->value(kExportWidthKey, panel.width()).toDouble();
    suffix = settings_->value(kExportFormatKey, suffix).toString();
  }
  settings.heightPx = settings.widthPx * shape;
  SurfaceExportDialog dialog(settings, suffix, &window_);
  if (dialog.exec() != QDialog::Accepted) return;
  settings = dialog.settings();
  suffix = dialog.suffix();
  const QString start = settings_ ? settings_->value(kExportFolderKey).toString() : QString();
  const QString name = askSaveName(&window_, tr("Export surface"),
                                   QDir(start).filePath(tr("surface") + "." + suffix),
                                   {tr("%1 files (*.%2)").arg(suffix.toUpper(), suffix)});
  if (name.isEmpty()) return;
  if (settings_) {
    ExportSettings common;
    common.restore(*settings_);
    common.unit = settings.unit;
    common.dpi = settings.dpi;
    common.figure.palette = settings.figure.palette;
    common.save(*settings_);
    settings_->setValue(kExportWidthKey, settings.widthPx);
    settings_->setValue(kExportFormatKey, suffix);
    settings_->setValue(kExportFolderKey, QFileInfo(name).absolutePath());
  }
  exporter_.exportTo(name, {qRound(settings.widthPx), qRound(settings.heightPx), settings.dpi,
                            settings.figure.palette});
}

bool SurfaceController::finishExports() {
  if (!exporter_.isBusy()) return true;
  bool allWritten = true;
  const auto watch =
      connect(&exporter_, &SurfaceExporter::failed, this, [&allWritten] { allWritten = false; });
  emit said(tr("The window closes when the export is written."));
  QApplication::setOverrideCursor(Qt::WaitCursor);
  QEventLoop loop;
  connect(&exporter_, &SurfaceExporter::idle, &loop, &QEventLoop::quit);
  loop.exec(QEventLoop::ExcludeUserInputEvents);
  QApplication::restoreOverrideCursor();
  disconnect(watch);
  return allWritten;
}

}  // namespace flatland::ui
