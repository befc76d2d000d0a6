// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSize>
#include <QString>

#include "ui/app/surface_exporter.h"
#include "ui/view3d/surface_models.h"

class QSettings;
class QWidget;

namespace flatland::ui {

class FileController;
class MessageBar;

/// Opening meshes, stepping through a folder of them, and asking where an export goes to. What
/// cannot be read or written is told by the message bar and changes nothing.
class SurfaceController : public QObject {
  Q_OBJECT

 public:
  SurfaceController(QWidget& window, const SurfaceModels& models, FileController& files,
                    MessageBar& messages, QSettings* settings);

  void open();  ///< asks which file
  void openFile(const QString& name);
  void openSolid(const QString& name);  ///< without "solid:"
  /// The next (1) or previous (-1) mesh in the folder of this one, by name, around the end.
  void openNeighbour(int step);
  /// True if there are meshes to step to.
  bool hasNeighbours() const;
  void close();

  /// Asks as what and where to, see SurfaceExporter. Pictures have the shape of the panel, whose
  /// size is given in px, unless the person wants another one.
  void exportPicture(const QSize& panel);
  SurfaceExporter& exporter() { return exporter_; }
  /// Waits for the exports under way, if there are any, while the window is painted but takes no
  /// input. False if one of them failed: it has been told, and the window should stay.
  bool finishExports();

  const SurfaceModels& models() const { return models_; }

 signals:
  void said(const QString& text);
  void closed();  ///< by hand

 private:
  /// Once for each mesh, from wherever it came.
  void askWhetherItLies();
  QString folder() const;

  QWidget& window_;
  SurfaceModels models_;
  FileController& files_;
  MessageBar& messages_;
  QSettings* settings_;
  SurfaceExporter exporter_;
  std::string asked_;  ///< the mesh last asked about, by its reference
};

}  // namespace flatland::ui
