// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSize>
#include <QString>
#include <deque>
#include <functional>

#include "ui/jobs/job.h"
#include "ui/view3d/surface_models.h"

namespace flatland::ui {

/// Writes what is seen of the surface, by the suffix of the file's name: as PNG the views with
/// their shading, as SVG, PDF or TikZ their lines as vectors, as PLY or CSV the curvatures at the
/// vertices with the terms of the first view, as JSON the cameras in the form that `flatland lines
/// --cameras` reads, with those that are kept.
class SurfaceExporter : public QObject {
  Q_OBJECT

 public:
  explicit SurfaceExporter(const SurfaceModels& models, QObject* parent = nullptr);

  /// Pictures have this size in px. Writes what is seen now, after exports that are under way. Done
  /// beside the window's thread; written() or failed() tells the end. Nothing happens without a
  /// surface.
  void exportTo(const QString& name, const QSize& size);

  /// True until the files of all exports are written, or could not be.
  bool isBusy() const { return job_.isRunning() || !waiting_.empty(); }

 signals:
  void written(const QString& name);
  void failed(const QString& reason);
  void notYet();  ///< the lines are still being looked for
  void idle();    ///< no longer busy

 private:
  void writePicture(const QString& name, const QSize& size);
  void writeLines(const QString& name, const QSize& size);
  void writeFields(const QString& name);
  void writeCameras(const QString& name);
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
