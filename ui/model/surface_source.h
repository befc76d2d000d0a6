// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "ui/jobs/job.h"
#include "ui/model/document.h"
#include "ui/model/loaded_surface.h"
#include "ui/model/sweep_work.h"

namespace flatland::ui {

/// The surface of the document: its mesh is read and its fields are estimated beside the window's
/// thread, the mesh first, so that it can be looked at meanwhile. Nothing is read before somebody
/// looks (setActive). A surface that is swept from a curve follows the curve (SweepWork).
class SurfaceSource : public QObject {
  Q_OBJECT

 public:
  explicit SurfaceSource(Document& document, QObject* parent = nullptr);

  /// Null if the scene has no surface, or none that could be read yet. Of the fields only those of
  /// the scale asked for are kept.
  const std::shared_ptr<const LoadedSurface>& surface() const { return surface_; }

  /// Reads a mesh file, or makes a solid ("solid:torus"), and puts it beside the curves: one undo
  /// step, done when it has been read. If it cannot be read, failed() tells why and nothing
  /// changes, and nothing comes of it if another scene is opened meanwhile. A surface that is there
  /// lends its families and style to the next one; so does the last one closed in this document.
  void open(const QString& reference);
  /// Takes the surface, if there is one, out of the scene: one undo step.
  void close();

  /// Gives up reading, or else estimating: what there was before stays. That is not begun again
  /// before something else is asked for (another mesh, another scale), or goOn().
  void cancel();
  /// What was given up is still wanting: there is no mesh, none with fields of the scale asked for,
  /// or a preview.
  bool isGivenUp() const;
  /// Begins again what was given up.
  void goOn();

  bool isBusy() const { return opening_.isRunning() || fields_.isRunning() || sweep_.isLong(); }
  /// True while surface() is not yet what the document says.
  bool isStale() const { return opening_.isRunning() || fields_.isRunning() || sweep_.isStale(); }
  /// True while the mesh is still being read, and not only its fields.
  bool isReading() const { return opening_.isRunning(); }
  /// True if surface() is a coarse mesh of a swept surface, shown until the one asked for is made.
  bool isPreview() const;

  void setActive(bool active);

 signals:
  void changed();
  void busyChanged(bool busy);    ///< or it is busy with something else
  void progressed(double share);  ///< of the fields, in [0, 1]
  void opened(const QString& name);
  void failed(const QString& reason);
  void readingGivenUp(const QString& reference);  ///< by cancel()

 private:
  void follow(const Change& change);
  void update();
  void updateSwept();
  void tellBusy();
  void start(const std::string& reference, bool isNew);
  void drop();
  void readAgain();
  void wantFields();
  void show(const std::shared_ptr<const LoadedSurface>& surface, bool isNew);

  Document& document_;
  Job opening_;  ///< reads a mesh
  Job fields_;   ///< estimates those of surface_, also while another mesh is read
  SweepWork sweep_;
  std::shared_ptr<const LoadedSurface> surface_;
  std::string reads_;            ///< what opening_ reads
  std::string wanted_;           ///< reference of the last start; of one that failed too
  std::string unreadable_;       ///< the scene's own, which failed and was told of
  std::optional<double> scale_;  ///< of the last estimate for surface_, done or not
  SurfaceSetting closedLook_;    ///< how the surface looked that was closed last
  bool active_ = false;
  bool opensNew_ = false;  ///< opening_ reads what is not in the scene yet
  bool givenUp_ = false;   ///< since then nothing was begun
  bool toldBusy_ = false, toldReading_ = false;
};

}  // namespace flatland::ui
