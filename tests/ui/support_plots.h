// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWheelEvent>

#include "flatland/curve/arc_length.h"
#include "tests/ui/support_window.h"
#include "ui/plot/plots_panel.h"

namespace flatland::ui {

inline constexpr PlotKind kKinds[] = {PlotKind::Curvature, PlotKind::Lambda, PlotKind::Terms,
                                      PlotKind::Ratio};

/// A window high enough for all four plots, and hands for them.
class PlotsDriver {
 public:
  bool start() {
    driver_ = std::make_unique<WindowDriver>();
    if (!driver_->ready()) return false;
    driver_->window().resize(1280, 1100);
    driver_->settle();
    panel_ = driver_->window().findChild<PlotsPanel*>();
    return panel_ != nullptr;
  }
  void stop() { driver_.reset(); }

  ProfilePlot& plot(PlotKind kind) { return panel_->plot(kind); }
  double total() { return driver_->window().plots().profile().length; }
  double lengthTo(double t) {
    return arcLength(driver_->scene().curves[0].shape, 0.0, t, 1e-12).value;
  }
  QPoint at(ProfilePlot& p, double x) { return {qRound(p.pixelOf(x)), p.surface().height() / 2}; }
  void clickAt(ProfilePlot& p, double x) {
    QTest::mouseClick(&p.surface(), Qt::LeftButton, {}, at(p, x));
    driver_->settle();
  }
  void moveTo(ProfilePlot& p, const QPoint& to, Qt::MouseButton button = Qt::LeftButton) {
    QMouseEvent event(QEvent::MouseMove, to, p.surface().mapToGlobal(to), Qt::NoButton, button, {});
    QCoreApplication::sendEvent(&p.surface(), &event);
    driver_->settle();
  }
  void wheel(ProfilePlot& p, const QPoint& where, int angle) {
    QWheelEvent event(where, p.surface().mapToGlobal(where), {}, {0, angle}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&p.surface(), &event);
    driver_->settle();
  }
  void showProbePanel() {
    auto& dock = driver_->child<QWidget>("probe");
    dock.show();
    dock.raise();
    driver_->settle();
  }

 protected:
  std::unique_ptr<WindowDriver> driver_;
  PlotsPanel* panel_ = nullptr;
};

}  // namespace flatland::ui
