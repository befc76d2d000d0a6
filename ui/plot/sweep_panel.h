// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/plot/sweep_source.h"
#include "ui/plot/sweep_view.h"
#include "ui/plot/view_player.h"

class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace flatland::ui {

/// The view sweep: every mark for every view direction, to look at, to go to and to play.
class SweepPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SweepPanel(const CanvasModels& models, QWidget* parent = nullptr);

  const SweepSource& source() const { return source_; }
  SweepView& view() { return *view_; }

 signals:
  /// For the status line.
  void said(const QString& text);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* buildTools();
  QLayout* buildFooter();
  QToolButton* addTool(const char* id, const QString& text, const QString& tip);
  void togglePlay();
  void showAngle();
  void showState();
  void exportDiagram();

  CanvasModels models_;
  SweepSource source_;
  ViewPlayer player_;
  SweepView* view_;
  QDoubleSpinBox* angle_;
  QDoubleSpinBox* speed_;
  QToolButton* play_;
  QToolButton* export_;
  QLabel* state_;
  QString hovered_;
};

}  // namespace flatland::ui
