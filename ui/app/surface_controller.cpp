// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/surface_controller.h"

#include <QBuffer>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

#include "flatland/io/atomic_file.h"
#include "flatland/io/input_error.h"
#include "flatland/io/scene_json.h"
#include "ui/app/file_controller.h"
#include "ui/app/message_bar.h"
#include "ui/commands/scene_commands.h"
#include "ui/import/mesh_name.h"
#include "ui/model/paths.h"
#include "ui/plot/figure_files.h"
#include "ui/view3d/surface_figure.h"
#include "ui/view3d/surface_picture.h"

namespace flatland::ui {

namespace {

constexpr char kFolderKey[] = "surface/folder";
constexpr char kExportFolderKey[] = "export/folder";
constexpr QSize kPictureSize(1600, 1200);  ///< of exported pictures

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
      settings_(settings) {
  connect(&models_.source, &SurfaceSource::failed, &messages_, &MessageBar::showError);
  connect(&models_.views, &SurfaceViews::failed, &messages_, &MessageBar::showError);
  connect(&export_, &Job::failed, &messages_, &MessageBar::showError);
  connect(&models_.source, &SurfaceSource::opened, this, [this](const QString& reference) {
    messages_.hide();
    if (!namesFile(reference.toStdString())) return;
    files_.remember(reference);
    if (settings_) settings_->setValue(kFolderKey, QFileInfo(reference).absolutePath());
  });
  // A scene may have come from a newer program, or from a hand.
  connect(&models_.document, &Document::changed, this, [this](const Change& change) {
    const auto& setting = models_.document.scene().surface;
    if (change.what != Change::What::Scene || !setting) return;
    const std::string unknown = unknownNames(*setting);
    if (unknown.empty()) return;
    messages_.showError(tr("Unknown here and left out: %1").arg(QString::fromStdString(unknown)));
  });
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
  models_.document.push(
      std::make_unique<SetSurface>(models_.document, std::nullopt, tr("close surface")));
}

void SurfaceController::exportPicture() {
  if (!models_.source.surface()) return;
  const QString start = settings_ ? settings_->value(kExportFolderKey).toString() : QString();
  QString name = QFileDialog::getSaveFileName(
      &window_, tr("Export surface"), QDir(start).filePath(tr("surface") + ".svg"),
      tr("Lines as vectors (*.svg *.pdf *.tex);;Picture with shading (*.png)"));
  if (name.isEmpty()) return;
  if (QFileInfo(name).suffix().isEmpty()) {
    name += ".svg";
    if (!files_.mayReplace(name)) return;
  }
  if (settings_) settings_->setValue(kExportFolderKey, QFileInfo(name).absolutePath());
  exportTo(name, kPictureSize);
}

void SurfaceController::exportTo(const QString& name, const QSize& size) {
  const SurfacePicture picture = pictureOf(models_);
  if (!picture.surface) return;
  if (QFileInfo(name).suffix().toLower() == "png") {
    export_.start<QImage>(
        [picture, size](const JobControl&) { return std::optional(paintSurface(picture, size)); },
        [this, name](const QImage& image) {
          write(name, [&] {
            QByteArray png;
            QBuffer buffer(&png);
            buffer.open(QIODevice::WriteOnly);
            if (!image.save(&buffer, "PNG")) {
              throw InputError(name.toStdString(), "", "no picture of this size can be made");
            }
            writeFileAtomically(
                toPath(name),
                std::string_view(png.constData(), static_cast<std::size_t>(png.size())));
          });
        });
    return;
  }
  if (!picture.surface->fields) {
    return emit said(tr("The lines are not found yet; export again in a moment."));
  }
  export_.start<Figure>(
      [picture, size](const JobControl&) { return std::optional(surfaceFigure(picture, size)); },
      [this, name, title = surfaceName(picture.setting.mesh),
       scene = models_.document.scene()](const Figure& figure) {
        write(name, [&] {
          writeFigureFile(toPath(name), {.suggestedName = {},
                                         .title = title,
                                         .sceneJson = sceneToJson(scene),
                                         .figure = [&figure] { return figure; },
                                         .table = {}});
        });
      });
}

void SurfaceController::write(const QString& name, const std::function<void()>& writing) {
  try {
    writing();
  } catch (const InputError& error) {
    messages_.showError(QString::fromStdString(error.what()));
    return;
  }
  messages_.hide();
  emit said(tr("Exported to %1").arg(QDir::toNativeSeparators(name)));
}

}  // namespace flatland::ui
