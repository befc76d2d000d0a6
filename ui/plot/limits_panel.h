// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/flat/canvas_models.h"
#include "ui/jobs/job.h"
#include "ui/model/view_turner.h"
#include "ui/plot/limits_view.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSlider;

namespace flatland::ui {

/// What happens on the way to a silhouette: n.w as a slider that turns the view, and how lambda and
/// the terms grow or vanish, measured beside predicted.
class LimitsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LimitsPanel(const CanvasModels& models, QWidget* parent = nullptr);

  LimitsView& view() { return *view_; }
  bool isStale() const { return job_.isRunning() || waiting_; }

  /// The probe's place; without one, the middle of the first curve. nullopt without curves.
  std::optional<Probe::Place> place() const;

 signals:
  /// For the status line.
  void said(const QString& text);

 protected:
  void showEvent(QShowEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QLayout* buildChoices();
  QLayout* buildSlider();
  void turnTo(double nw);
  void sceneChanged();
  void start();
  void showSeries(const std::optional<LimitSeries>& series);
  void showNow();
  QString explanation() const;
  void exportDiagram();

  CanvasModels models_;
  ViewTurner turner_;
  Job job_;
  bool waiting_ = true;  ///< the scene has changed since the last start
  LimitsView* view_;
  QComboBox* experiment_;
  QComboBox* law_;
  QSlider* slide_;
  QDoubleSpinBox* nw_;
  QPushButton* export_;
  QLabel* now_;
  QLabel* words_;
};

}  // namespace flatland::ui
