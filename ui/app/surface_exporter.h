// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <deque>
#include <functional>
#include <optional>

#include "ui/jobs/job.h"
#include "ui/view3d/surface_models.h"
#include "ui/view3d/surface_picture.h"

namespace flatland::ui {

/// How large a picture is made, and for which background.
struct PictureSize {
  int width = 0, height = 0;         ///< px of 1/96 inch, which is what lines are wide in
  double dpi = 96.0;                 ///< of PNG: pixels per inch
  std::optional<Palette> palette{};  ///< empty: that of the window
};

/// Writes what is seen of the surface, by the suffix of the file's name: as PNG the views with
/// their shading, as SVG, PDF or TikZ their lines as vectors, as PLY or CSV the curvatures at the
/// vertices with the terms of the first view, as JSON the cameras in the form that `flatland lines
/// --cameras` reads, with those that are kept.
class SurfaceExporter : public QObject {
  Q_OBJECT

 public:
  explicit SurfaceExporter(const SurfaceModels& models, QObject* parent = nullptr);

  /// Pictures have this size. Writes what is seen now, after exports that are under way. Done
  /// beside the window's thread; written() or failed() tells the end. Nothing happens without a
  /// surface.
  void exportTo(const QString& name, const PictureSize& size);

  /// True until the files of all exports are written, or could not be.
  bool isBusy() const { return job_.isRunning() || !waiting_.empty(); }

 signals:
  void written(const QString& name);
  void failed(const QString& reason);
  void notYet();  ///< the lines are still being looked for
  void idle();    ///< no longer busy

 private:
  void writePicture(const QString& name, const PictureSize& size);
  void writeLines(const QString& name, const PictureSize& size);
  void writeFields(const QString& name);
  void writeCameras(const QString& name);
  std::vector<SurfacePicture> picturesFor(const PictureSize& size) const;
  void startNext();
  /// `writing` runs beside the window's thread, when the exports before it are done.
  void enqueue(const QString& name, std::function<void()> writing);

  SurfaceModels models_;
  Job job_;
  std::deque<std::function<void()>> waiting_;  ///< exports, in the order they were asked for
};

/// The camera that the first view is looked at from, then those that are kept, as a list for
/// `flatland lines --cameras`. Names lose what a file's name cannot have.
std::string camerasText(const SurfaceSetting& setting);

}  // namespace flatland::ui
