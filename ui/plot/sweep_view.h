// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPixmap>
#include <QWidget>

#include "ui/export/sweep_figure.h"
#include "ui/flat/canvas_models.h"
#include "ui/model/view_turner.h"
#include "ui/plot/sweep_source.h"

namespace flatland::ui {

/// The sweep's diagram, to click and drag in: the view follows the pointer sideways, the probe goes
/// where the click was. Wheel and middle button zoom and move, keys turn the view.
class SweepView : public QWidget {
  Q_OBJECT

 public:
  SweepView(const CanvasModels& models, const SweepSource& source, QWidget* parent = nullptr);

  /// The whole diagram again.
  void showAll();
  const std::optional<SweepWindow>& window() const { return window_; }

  /// Where the diagram shows an angle and an arc length, in widget pixels; nullopt without a
  /// diagram.
  std::optional<QPointF> positionOf(double angleDeg, int curve, double u) const;

  /// The view at the next (`step` = 1) or previous (-1) event of an apparent ridge.
  void goToEvent(int step);

  /// The picture for a file, whole, on a light background. Precondition: the source has data.
  Figure figureForFile() const;

  QSize sizeHint() const override { return {390, 330}; }
  QSize minimumSizeHint() const override { return {200, 150}; }

 signals:
  /// What is under the pointer, in words; empty when it leaves.
  void hovered(const QString& text);
  /// Space was pressed.
  void playToggled();
  /// Esc was pressed and there was no drag to take back.
  void escaped();

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  double scale() const;
  SweepFigureOptions options() const;
  std::optional<SweepAxes> axes() const;
  Vec2 toFigure(const QPointF& widget) const;
  void redraw();
  void goTo(const QPointF& widget);
  void moveBy(const QPointF& pixels);
  void zoom(const QPointF& widget, double factor, bool angles, bool lengths);
  void setWindow(SweepWindow window);
  const SweepEvent* eventAt(const QPointF& widget) const;
  QString describe(const QPointF& widget) const;

  CanvasModels models_;
  const SweepSource& source_;
  ViewTurner turner_;
  std::optional<SweepWindow> window_;
  QPixmap picture_;  ///< everything but view and probe; null when it must be drawn anew
  QPointF hover_;
  bool hovering_ = false;
  std::optional<QPointF> panning_;
  std::optional<Probe::Place> before_;  ///< the probe when the drag began
};

}  // namespace flatland::ui
