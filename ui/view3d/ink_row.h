// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/view3d/surface_models.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;

namespace flatland::ui {

/// Whether all views are to have the same ink, and how much; which of them cannot. Every choice is
/// an undo step.
class InkRow : public QWidget {
  Q_OBJECT

 public:
  explicit InkRow(const SurfaceModels& models, QWidget* parent = nullptr);

 private:
  void showSetting();
  void showMissed();
  void edit(const std::optional<double>& share);

  SurfaceModels models_;
  QCheckBox* on_;
  QDoubleSpinBox* share_;
  QLabel* missed_;
};

}  // namespace flatland::ui
