// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "ui/jobs/latest_job.h"
#include "ui/model/loaded_surface.h"

namespace flatland::ui {

/// A surface to be swept, how finely, and how smoothly its fields are estimated.
struct SweepWish {
  SweptSurface surface;
  int cells;
  double fitScale;

  bool operator==(const SweepWish& other) const;
};

/// Makes meshes of a swept surface, with their fields, beside the window's thread, while the curve
/// is dragged. One that is being made is not cut off by the next wish (LatestJob), so the surface
/// follows the hand and never piles up. While wishes come, cells are as many as can be
/// had in about kLiveMs; when the hand rests, as many as are wished
/// (docs/decisions/0025-live-sweeping.md).
class SweepWork : public QObject {
  Q_OBJECT

 public:
  static constexpr double kLiveMs = 50.0;

  explicit SweepWork(QObject* parent = nullptr);

  /// nullopt: nothing is wanted any more.
  void setWish(const std::optional<SweepWish>& wish);

  /// Gives up what is being made; what was made last stays.
  void cancel();

  /// A mesh of another wish, or a finer one, is on its way.
  bool isStale() const { return job_.isStale() || rest_.isActive(); }
  /// It takes so long that a person wants to see how far it is.
  bool isLong() const { return job_.isRunning() && long_; }

 signals:
  void made(const std::shared_ptr<const flatland::ui::LoadedSurface>& surface);
  void longChanged();
  void progressed(double share);
  void failed(const QString& reason);

 private:
  void begin();
  int liveCells() const;

  LatestJob job_;
  QTimer rest_;
  std::optional<SweepWish> wish_;
  std::optional<SweepWish> tried_;  ///< what was begun last, with the cells it is made with
  bool long_ = false;
  double msPerSquare_;  ///< time over the square of the cells, as it was last
};

}  // namespace flatland::ui
