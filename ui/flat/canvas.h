// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "ui/flat/gesture.h"

class QNativeGestureEvent;

namespace flatland::ui {

/// Flatland itself: the curves with their control points, the view handle on its ring, the screen,
/// and the marks on both. Turns pointer events into gestures and keys into edits; everything it
/// shows is read from the models when it paints.
class FlatCanvas : public QWidget {
  Q_OBJECT

 public:
  explicit FlatCanvas(const CanvasModels& models, QWidget* parent = nullptr);
  ~FlatCanvas() override;

  /// Shows the whole scene with its ring.
  void fit();

  /// Puts the probe on the place of a curve nearest to the pointer, or at home if that is
  /// elsewhere.
  void placeProbe();

  QSize sizeHint() const override { return {720, 560}; }
  QSize minimumSizeHint() const override { return {240, 200}; }

 signals:
  /// What a drag would do now, or what the one under way does.
  void hint(const QString& text);
  /// The pointer moved over this place, or left.
  void pointerAt(const std::optional<flatland::Vec2>& world);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void leaveEvent(QEvent* event) override;
  bool focusNextPrevChild(bool next) override;

 private:
  void documentChanged(const Change& change);
  void resizeDrawing();  ///< for another size or scale
  void begin(std::unique_ptr<Gesture> gesture);
  void cancelGesture();
  void hover(const QPointF& position);
  void showHint();
  /// The mark under the pointer, if it is pointed at on its curve.
  std::optional<Mark> markOnCurve(const Target& target, const QPointF& at) const;
  void insertPointAt(std::size_t curve, double t);
  void nudge(const Vec2& direction, const QKeyEvent& event);
  void pinch(const QNativeGestureEvent& event);

  CanvasModels models_;
  std::unique_ptr<Gesture> gesture_;
  Target hovered_;
  std::optional<QPointF> pointer_;  ///< while it is over the canvas
  bool panKey_ = false;             ///< Space is down
  bool showsFocus_ = false;         ///< the focus came by keyboard, so it is drawn
  int nudge_ = 0;                   ///< gesture of a held arrow key
};

}  // namespace flatland::ui
