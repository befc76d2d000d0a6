// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "ui/plot/profile_drawing.h"

class QLabel;

namespace flatland::ui {

/// One plot along the curve with its title and the values at the probe. Click or drag moves the
/// probe, the wheel zooms, keys do both; all of it acts on the Plots that every plot shares.
/// Several changes in one turn of the event loop are one replot, and a hidden plot waits.
class ProfilePlot : public QWidget {
  Q_OBJECT

 public:
  ProfilePlot(Plots& plots, PlotKind kind, QWidget* parent = nullptr);
  ~ProfilePlot() override;

  PlotKind kind() const { return kind_; }
  const ProfileDrawing& drawing() const { return *drawing_; }
  int replots() const { return replots_; }

  /// Whether the abscissa has its numbers below this plot.
  void setNumbersBelow(bool on);

  /// The widget that takes mouse and keys, and where in it a value of the abscissa lies.
  QWidget& surface();
  double pixelOf(double x) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  /// The context menu was asked for at this place of the screen.
  void menuWanted(const QPoint& globalPos);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  enum Part { Nothing = 0, ProbePart = 1, RangePart = 2, LinesPart = 4, LookPart = 8 };
  void need(int parts);
  void update_();
  void showValues();
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool wheel(const QWheelEvent& event);
  bool key(const QKeyEvent& event);
  double abscissaAt(double pixel) const;

  Plots& plots_;
  PlotKind kind_;
  QCustomPlot* plot_;
  QLabel* title_;
  QLabel* values_;
  std::unique_ptr<ProfileDrawing> drawing_;
  int needed_ = LookPart;
  bool scheduled_ = false;
  int replots_ = 0;
  bool hasNumbers_ = false;
  bool panKey_ = false;  ///< Space is down
  bool dragging_ = false;
  std::optional<double> panFrom_;  ///< abscissa under the pointer while panning
};

}  // namespace flatland::ui
