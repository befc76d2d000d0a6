// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/lesson/lesson_model.h"

class QCheckBox;
class QLabel;
class QTextBrowser;
class QToolButton;

namespace flatland::ui {

class FormulaView;
class StepSizePlot;

/// The lesson strip: words, formula, both sides at the probe, their difference, step-size sweep.
class LessonPanel : public QWidget {
  Q_OBJECT

 public:
  LessonPanel(LessonModel& lesson, Probe& probe, Display& display, QWidget* parent = nullptr);

  QSize sizeHint() const override { return {860, 180}; }
  QSize minimumSizeHint() const override { return {520, 80}; }

  /// What the steps of the lesson need at this width without scrolling: all with an equation alike,
  /// and all without, so that the picture above keeps its size from step to step.
  int wantedHeight() const;

 signals:
  void heightWanted();  ///< the strip has another width or type
  void chooseLesson();  ///< no lesson is open and the person asks for one

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QLayout* buildHeader();
  QLayout* buildEquation();
  QToolButton* addButton(const char* id, const QString& text, const QString& tip);
  void showStep();
  void showValues();
  void showSwitches();
  void showMisses();

  LessonModel& lesson_;
  Probe& probe_;
  Display& display_;
  QLabel* title_;
  QToolButton* first_;
  QToolButton* back_;
  QToolButton* next_;
  QToolButton* stop_;
  QToolButton* again_;
  QToolButton* leave_;
  QTextBrowser* words_;
  FormulaView* formula_;
  QToolButton* printed_;
  QToolButton* corrected_;
  QCheckBox* roots_;
  QLabel* values_;
  QLabel* misses_;
  QWidget* equation_;
  StepSizePlot* plot_;
};

}  // namespace flatland::ui
