// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMouseEvent>
#include <QTest>
#include <cmath>
#include <memory>
#include <numbers>

#include "flatland/view/view.h"
#include "tests/ui/support_window.h"
#include "ui/view3d/surface_area.h"

namespace flatland::ui {

/// The azimuth that a camera looks from.
inline double azimuthDeg(const SurfaceCamera& camera) {
  return std::atan2(camera.towards.y(), camera.towards.x()) * 180.0 / std::numbers::pi;
}

inline bool sameAngle(double a, double b) { return std::abs(normalizedDeg(a - b)) < 1e-6; }

/// The window where flatland and surfaces meet: what tests of both directions do in it.
class BridgingWindow {
 protected:
  void open() {
    driver_ = std::make_unique<WindowDriver>();
    QVERIFY(driver_->ready());
  }
  void close() { driver_.reset(); }

  QWidget& surface() { return *driver_->window().surfaceArea().canvas(); }
  const SurfaceCamera& camera() { return driver_->scene().surface->camera; }
  SurfaceSource& source() { return driver_->window().surfaceModels().source; }
  SeenSource& seen() { return driver_->window().surfaceModels().seen; }
  SectionSource& section() { return driver_->window().bridges().section; }
  BridgeSource& bridge() { return driver_->window().bridges().source; }

  bool quiet() {
    const bool done = QTest::qWaitFor(
        [this] {
          return !source().isStale() && !seen().isStale() && !driver_->window().bridges().isStale();
        },
        kPatienceMs);
    driver_->settle();
    return done;
  }
  void extrude() {
    driver_->trigger("surface.extrude");
    QVERIFY(quiet());
    QVERIFY(source().surface() && source().surface()->swept);
    driver_->window().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&driver_->window()));
  }
  /// The section of a torus by a plane through the line of sight, as the scene's curves.
  void openSectionOfTorus() {
    driver_->trigger("surface.solid.torus");
    QVERIFY(quiet());
    driver_->trigger("surface.plane.view");
    QVERIFY(quiet());
    driver_->trigger("surface.plane.open");
    QVERIFY(quiet());
  }
  void dragSurface(const QPoint& from, const QPoint& to) {
    QTest::mousePress(&surface(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 4; ++i) {
      const QPoint p = from + (to - from) * i / 4;
      QMouseEvent event(QEvent::MouseMove, p, surface().mapToGlobal(p), Qt::NoButton,
                        Qt::LeftButton, {});
      QCoreApplication::sendEvent(&surface(), &event);
    }
    QTest::mouseRelease(&surface(), Qt::LeftButton, {}, to);
    driver_->settle();
  }

  std::unique_ptr<WindowDriver> driver_;

 private:
  static constexpr int kPatienceMs = 60000;
};

}  // namespace flatland::ui
