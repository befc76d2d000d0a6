// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/flat/canvas_models.h"
#include "ui/plot/study_source.h"
#include "ui/plot/study_view.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSlider;
class QSpinBox;

namespace flatland::ui {

/// The offset study: how large the offset term is against the feature term, over many random
/// curves, and what mixing units makes of it.
class StudyPanel : public QWidget {
  Q_OBJECT

 public:
  explicit StudyPanel(const CanvasModels& models, QWidget* parent = nullptr);

  const StudySource& source() const { return source_; }
  StudyView& view() { return *view_; }

  /// What the form says; nullopt if the seed is no number.
  std::optional<OffsetStudyOptions> options() const;

 signals:
  /// For the status line.
  void said(const QString& text);

 private:
  QWidget* buildForm();
  QWidget* buildTools();
  QPushButton* addButton(const char* id, const QString& text, const QString& tip);
  void start();
  void writeTable();
  void exportPicture();
  void showState();
  void showScale();
  void showExample(std::int64_t curve);

  CanvasModels models_;
  StudySource source_;
  StudyView* view_;
  QSpinBox* curves_;
  QSpinBox* points_;
  QLineEdit* seed_;
  QDoubleSpinBox* scale_;
  QComboBox* convention_;
  QComboBox* diagram_;
  QSlider* slide_;
  QPushButton* run_;
  QPushButton* table_;
  QPushButton* export_;
  QProgressBar* progress_;
  QLabel* state_;
  QString described_;
};

}  // namespace flatland::ui
