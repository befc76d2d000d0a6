// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/surface_exporter.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImage>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>

#include "core3d/io/cameras_json.h"
#include "core3d/io/fields_text.h"
#include "flatland/io/atomic_file.h"
#include "flatland/io/input_error.h"
#include "ui/export/scene_record.h"
#include "ui/model/core_words.h"
#include "ui/model/orbit.h"
#include "ui/model/paths.h"
#include "ui/plot/figure_files.h"
#include "ui/view3d/lines_command.h"
#include "ui/view3d/surface_figure.h"

namespace flatland::ui {

namespace {

constexpr double kPxPerInch = 96.0, kMetresPerInch = 0.0254;
/// Of a shaded picture: it takes some 35 bytes a pixel, 2 GB.
constexpr double kMostPixels = 64.0 * 1024.0 * 1024.0;
constexpr std::size_t kLongestName = 64;  ///< of a camera in a list

/// A name that can be a part of a file's name: letters, digits, "-" and "_", none twice.
std::string fileNamePart(const std::string& name, std::set<std::string>& taken) {
  std::string part;
  for (const char c : name) {
    const bool kept = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      c == '_' || c == '-';
    if (kept) {
      part += c;
    } else if (!part.empty() && part.back() != '-') {
      part += '-';
    }
  }
  if (part.empty()) part = "camera";
  part.resize(std::min(part.size(), kLongestName - 8));
  std::string free = part;
  for (int i = 2; !taken.insert(free).second; ++i) free = part + "-" + std::to_string(i);
  return free;
}

}  // namespace

std::string camerasText(const SurfaceSetting& setting) {
  // Its margin and size are those of the command line: they are not written.
  constexpr double kAnySize = 100.0;
  std::set<std::string> taken{"now"};
  std::vector<NamedCamera> cameras{{"now", drawingCamera(setting.camera, kAnySize, kAnySize)}};
  for (const SavedCamera& saved : setting.savedCameras) {
    cameras.push_back(
        {fileNamePart(saved.name, taken), drawingCamera(saved.camera, kAnySize, kAnySize)});
  }
  return camerasToJson(cameras);
}

SurfaceExporter::SurfaceExporter(const SurfaceModels& models, QObject* parent)
    : QObject(parent), models_(models) {
  connect(&job_, &Job::failed, this, &SurfaceExporter::failed);
  // Queued: the job tells that it ends before it hands over what it made.
  connect(&job_, &Job::runningChanged, this, &SurfaceExporter::startNext, Qt::QueuedConnection);
}

void SurfaceExporter::enqueue(const QString& name, std::function<void()> writing) {
  waiting_.push_back([this, name, writing = std::move(writing)] {
    job_.start<QString>(
        [name, writing](const JobControl&) {
          writing();
          return std::optional(name);
        },
        [this](const QString& file) { emit written(file); });
  });
  startNext();
}

void SurfaceExporter::startNext() {
  if (job_.isRunning()) return;
  if (waiting_.empty()) return emit idle();
  const std::function<void()> start = std::move(waiting_.front());
  waiting_.pop_front();
  start();
}

void SurfaceExporter::exportTo(const QString& name, const PictureSize& size) {
  const auto& surface = models_.source.surface();
  if (!surface || !models_.there()) return;
  std::error_code notThere;  // then they differ
  if (std::filesystem::equivalent(surface->reference, toPath(name), notThere)) {
    return emit failed(tr("%1 is the mesh itself, which would be lost").arg(name));
  }
  const QString suffix = QFileInfo(name).suffix().toLower();
  if (suffix == "png") return writePicture(name, size);
  if (suffix == "json") return writeCameras(name);
  if (!surface->fields) return emit notYet();
  if (suffix == "ply" || suffix == "csv") return writeFields(name);
  writeLines(name, size);
}

std::vector<SurfacePicture> SurfaceExporter::picturesFor(const PictureSize& size) const {
  std::vector<SurfacePicture> pictures = picturesOf(models_);
  for (SurfacePicture& picture : pictures) {
    picture.lineScale = 1.0;  // large type is for screens
    if (!size.palette) continue;
    picture.palette = *size.palette;
    picture.marks.clear();
    if (picture.surface) addMarks(picture, models_.bridges);
  }
  return pictures;
}

void SurfaceExporter::writePicture(const QString& name, const PictureSize& size) {
  enqueue(name, [name, pictures = picturesFor(size), size] {
    const double ratio = size.dpi / kPxPerInch;
    const double width = std::round(size.width * ratio), height = std::round(size.height * ratio);
    if (!(width >= 1.0 && height >= 1.0 && width * height <= kMostPixels)) {
      throw InputError(name.toStdString(), "", "no picture of this size can be made");
    }
    QImage image =
        paintSurfaces(pictures, QSize(static_cast<int>(width), static_cast<int>(height)), ratio);
    const int dotsPerMetre = qRound(size.dpi / kMetresPerInch);
    image.setDotsPerMeterX(dotsPerMetre);
    image.setDotsPerMeterY(dotsPerMetre);
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, "PNG")) {
      throw InputError(name.toStdString(), "", "no picture of this size can be made");
    }
    writeFileAtomically(toPath(name),
                        std::string_view(png.constData(), static_cast<std::size_t>(png.size())));
  });
}

void SurfaceExporter::writeLines(const QString& name, const PictureSize& size) {
  const std::vector<SurfacePicture> pictures = picturesFor(size);
  for (const SurfacePicture& picture : pictures) {
    if (picture.pane.difference && !(picture.seen && picture.seen->difference)) {
      return emit notYet();
    }
  }
  const QSize px(size.width, size.height);
  enqueue(name, [name, pictures, px, title = surfaceName(models_.source.surface()->reference),
                 scene = models_.document.scene()] {
    writeFigureFile(toPath(name), {.suggestedName = {},
                                   .title = title,
                                   .sceneJson = sceneRecord(scene),
                                   .command = linesCommand(
                                       pictures, px, QFileInfo(name).fileName().toStdString()),
                                   .figure = [&] { return surfaceFigure(pictures, px); },
                                   .table = {}});
  });
}

void SurfaceExporter::writeFields(const QString& name) {
  const auto& surface = models_.source.surface();
  if (const auto why = whyNoFieldsFile(*surface->mesh)) {
    return emit failed(coreWords(*why));
  }
  const bool csv = QFileInfo(name).suffix().toLower() == "csv";
  enqueue(name, [name, surface, view = models_.foundView(), csv] {
    writeFileAtomically(toPath(name), csv ? fieldsToCsv(*surface->mesh, *surface->fields, view)
                                          : fieldsToPly(*surface->mesh, *surface->fields, view));
  });
}

void SurfaceExporter::writeCameras(const QString& name) {
  enqueue(name, [name, text = camerasText(*models_.document.scene().surface)] {
    writeFileAtomically(toPath(name), text);
  });
}

}  // namespace flatland::ui
