// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/model/bridges.h"
#include "ui/model/display.h"
#include "ui/model/viewport.h"

namespace flatland::ui {

/// Painted over the canvas while its curves are a section of the surface: where the apparent ridges
/// of the surface go through the plane, with the numbers of the Section panel. Lets every event
/// through.
class CrossingOverlay : public QWidget {
  Q_OBJECT

 public:
  CrossingOverlay(const Bridges& bridges, const Viewport& viewport, const Display& display,
                  QWidget& canvas);

  /// Places on the canvas, px, in the order of the numbers; those without a ridge are left out.
  std::vector<QPointF> crossings() const;
  /// Of the chosen pair: its ridge, its mark, or both.
  std::vector<QPointF> chosen() const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  const Bridges& bridges_;
  const Viewport& viewport_;
  const Display& display_;
};

}  // namespace flatland::ui
