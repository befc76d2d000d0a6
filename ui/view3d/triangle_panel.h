// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

#include "ui/model/surface_study.h"
#include "ui/view3d/triangle_view.h"

class QLabel;
class QSpinBox;
class QToolButton;

namespace flatland::ui {

/// Chapter 5 on the picked triangle: the drawing of Fig. 5-1 with its stages as buttons, the
/// numbers at the corners, and what becomes of it.
class TrianglePanel : public QWidget {
  Q_OBJECT

 public:
  TrianglePanel(SurfaceStudy& study, const Display& display, QWidget* parent = nullptr);

  QSize sizeHint() const override { return {360, 340}; }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QToolButton* stageButton(TriangleStage stage, const QString& text, const QString& tip);
  void refresh();
  QString numbers(const TriangleLesson& lesson) const;

  SurfaceStudy& study_;
  QSpinBox* triangle_;
  TriangleView* view_;
  QLabel* words_;
  QLabel* numbers_;
};

/// What becomes of the triangle, in a sentence of the person's language.
QString verdictForPeople(const TriangleLesson& lesson);

}  // namespace flatland::ui
