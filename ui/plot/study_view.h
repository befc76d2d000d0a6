// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/export/study_figure.h"
#include "ui/model/display.h"
#include "ui/plot/study_source.h"

namespace flatland::ui {

/// The histograms of a study. A bin is picked with the mouse, or with Left and Right and Enter.
class StudyView : public QWidget {
  Q_OBJECT

 public:
  StudyView(const StudySource& source, const Display& display, QWidget* parent = nullptr);

  StudyDiagram diagram() const { return diagram_; }
  void setDiagram(StudyDiagram diagram);
  /// For StudyDiagram::Conventions.
  double scale() const { return scale_; }
  void setScale(double scale);

  /// The middle of a bin, widget pixels from the left.
  double xOfBin(std::size_t bin) const;

  /// For a file, on a light background. Precondition: the source has data.
  Figure figureForFile() const;

  QSize sizeHint() const override { return {390, 220}; }
  QSize minimumSizeHint() const override { return {200, 120}; }

 signals:
  /// A bin was clicked or confirmed: a curve that shows what it counts.
  void examplePicked(std::int64_t curve);
  /// What is under the pointer or selected, in words.
  void described(const QString& text);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  StudyFigureOptions options() const;
  const RatioHistogram* histogram() const;
  std::int64_t exampleOf(std::size_t bin) const;
  QString describe(std::size_t bin) const;
  void select(std::optional<std::size_t> bin);
  void selectNext(int step);
  void pick();

  const StudySource& source_;
  const Display& display_;
  StudyDiagram diagram_ = StudyDiagram::Ratio;
  double scale_ = 1.0;
  std::optional<std::size_t> selected_;
};

}  // namespace flatland::ui
