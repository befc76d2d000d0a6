// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "ui/export/limits_figure.h"
#include "ui/model/display.h"

namespace flatland::ui {

/// One power law on the way to a silhouette, in log-log axes.
class LimitsView : public QWidget {
  Q_OBJECT

 public:
  explicit LimitsView(const Display& display, QWidget* parent = nullptr);

  /// None: `why` is shown instead.
  void setSeries(std::optional<LimitSeries> series, const QString& why);
  const std::optional<LimitSeries>& series() const { return series_; }
  void setLaw(std::size_t law);
  void setMarkedX(std::optional<double> x);

  /// For a file, on a light background. Precondition: there is a series.
  Figure figureForFile() const;

  QSize sizeHint() const override { return {390, 200}; }
  QSize minimumSizeHint() const override { return {200, 120}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  LimitsFigureOptions options() const;

  const Display& display_;
  std::optional<LimitSeries> series_;
  QString why_;
  std::size_t law_ = 0;
  std::optional<double> markedX_;
};

}  // namespace flatland::ui
