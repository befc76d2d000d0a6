// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

#include "ui/model/surface_look.h"
#include "ui/view3d/surface_models.h"

class QAbstractButton;
class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QSlider;
class QSpinBox;

namespace flatland::ui {

/// Which families of lines are drawn in the active view of the surface, how strong they must be and
/// how they look in all of them. Every choice is an undo step; a pull of a slider is one.
class FamiliesPanel : public QWidget {
  Q_OBJECT

 public:
  explicit FamiliesPanel(const SurfaceModels& models, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Row {
    QCheckBox* on;
    QSlider* slider;
    QDoubleSpinBox* threshold;
    QAbstractButton* colour;
    QDoubleSpinBox* width;
    QCheckBox* fade;
  };
  Row makeRow(LineFamily family, QGridLayout& grid, int line);
  QWidget* makeCommon();
  void showSetting();
  /// Edits one family of the setting; edits with the same gesture number become one step.
  void edit(LineFamily family, const std::function<void(SurfaceFamily&)>& change, int gesture = 0);
  void switchOn(LineFamily family, bool on);
  void editSetting(const std::function<void(SurfaceSetting&)>& change);
  void chooseColour(LineFamily family);

  SurfaceModels models_;
  std::array<Row, kLineFamilyCount> rows_{};
  QComboBox* hidden_ = nullptr;
  QCheckBox* unfiltered_ = nullptr;
  QSpinBox* isophotes_ = nullptr;
  QSpinBox* heights_ = nullptr;
  int gesture_ = 0;  ///< of the slider under the hand
};

}  // namespace flatland::ui
