// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "ui/jobs/job.h"
#include "ui/model/surface_panes.h"
#include "ui/model/surface_source.h"

namespace flatland::ui {

/// Thresholds with which a view has the ink that was asked for.
struct PaneInk {
  double factor = 1.0;  ///< on the thresholds of the families that have one, creases excepted
  double share = 0.0;   ///< of the picture that the visible strokes cover
  bool reached = true;  ///< share is within 1 % of what was asked for
};

/// Solves for equal ink in every view of the document's surface (SurfaceSetting::ink), beside the
/// window's thread and as soon as the camera rests. The numbers are those of
/// `flatland lines --ink`: of the drawing with hidden lines removed, 800 x 600 px, from the camera
/// of the first view (drawingCamera), whatever the size of the window.
class InkSource : public QObject {
  Q_OBJECT

 public:
  InkSource(const Document& document, const SurfaceSource& source, QObject* parent = nullptr);
  ~InkSource() override;

  /// What was found last for a view; null if no ink is asked for, or it was never found.
  const PaneInk* of(std::size_t pane) const;

  /// The view with the thresholds that were found last.
  PaneSetting withInk(PaneSetting view, std::size_t pane) const;

  /// True while of() is that of another camera or other settings.
  bool isStale() const { return rest_.isActive() || job_.isRunning(); }
  int solutions() const { return solutions_; }  ///< ended so far

 signals:
  void changed();
  void failed(const QString& reason);

 private:
  struct Worker;
  void follow();
  void solve();
  void forget();

  const Document& document_;
  const SurfaceSource& source_;
  Job job_;
  QTimer rest_;
  std::stop_source stop_;
  std::shared_ptr<Worker> worker_;  ///< of the surface there is, shared with its jobs
  std::vector<PaneSetting> asked_;  ///< of the last start
  std::vector<PaneInk> found_;      ///< by view
  int solutions_ = 0;
};

}  // namespace flatland::ui
