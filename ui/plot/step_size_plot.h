// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "flatland/study/derivation.h"

class QCustomPlot;

namespace flatland::ui {

/// How far difference quotients are from the formula, against their step size, both axes
/// logarithmic: truncation falls to the left with slope 2, rounding rises with slope -1.
class StepSizePlot : public QWidget {
  Q_OBJECT

 public:
  explicit StepSizePlot(QWidget* parent = nullptr);

  /// `stepName` says what h is; in the tooltip.
  void show(const std::vector<StepDifference>& sweep, const QString& stepName);

  int pointCount() const { return points_; }

  QSize sizeHint() const override { return {250, 110}; }
  QSize minimumSizeHint() const override { return {170, 100}; }

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void restyle();

  QCustomPlot* plot_;
  int points_ = 0;
};

}  // namespace flatland::ui
