// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "ui/model/view_turner.h"

namespace flatland::ui {

/// Turns the view by itself: once around, counter-clockwise, at a speed. What it turned is one step
/// for undo. Ends by itself when something else changes the scene or the view.
class ViewPlayer : public QObject {
  Q_OBJECT

 public:
  ViewPlayer(Document& document, Stage& stage, QObject* parent = nullptr);

  bool isPlaying() const { return timer_.isActive(); }
  double speed() const { return speed_; }
  void setSpeed(double degreesPerSecond) { speed_ = degreesPerSecond; }

  void play();
  /// Stays where it is.
  void pause();
  /// Back to the view before.
  void cancel();

 signals:
  void playingChanged(bool playing);

 private:
  void advance();
  void follow(const Change& change);

  Document& document_;
  ViewTurner turner_;
  QTimer timer_;
  QElapsedTimer clock_;
  double speed_ = 30.0;
  double start_ = 0.0, turned_ = 0.0;  ///< degrees
  bool turning_ = false;               ///< the change of view is our own
};

}  // namespace flatland::ui
