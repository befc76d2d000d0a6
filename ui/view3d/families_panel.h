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
class QLabel;
class QSlider;
class QSpinBox;

namespace flatland::ui {

/// Which families of lines are drawn in the active view of the surface, how strong they must be and
/// how they look in all of them. Every choice is an undo step; a pull of a slider is one.
class FamiliesPanel : public QWidget {
  Q_OBJECT

 public:
  explicit FamiliesPanel(const SurfaceModels& models, QWidget* parent = nullptr);

  /// Without width, fade and sliders, which stand where there is room for them.
  QSize minimumSizeHint() const override;

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  static constexpr int kColumns = 6;
  struct Row {
    QCheckBox* on;
    QSlider* slider;
    QDoubleSpinBox* threshold;
    QAbstractButton* colour;
    QDoubleSpinBox* width;
    QCheckBox* fade;

    std::array<QWidget*, kColumns> parts() const;  ///< by column
  };
  Row makeRow(LineFamily family, QGridLayout& grid, int line);
  QWidget* makeCommon();
  void fitFields();               ///< to the digits in the font there is
  int widthOf(int column) const;  ///< at least, with the space beside it
  void showSetting();
  /// Edits one family of the setting; edits with the same gesture number become one step.
  void edit(LineFamily family, const std::function<void(SurfaceFamily&)>& change, int gesture = 0);
  void switchOn(LineFamily family, bool on);
  void editSetting(const std::function<void(SurfaceSetting&)>& change);
  void chooseColour(LineFamily family);

  SurfaceModels models_;
  std::array<Row, kLineFamilyCount> rows_{};
  std::array<QLabel*, kColumns> heads_{};  ///< by column; null: it has none
  QWidget* common_ = nullptr;
  QComboBox* hidden_ = nullptr;
  QCheckBox* unfiltered_ = nullptr;
  QSpinBox* isophotes_ = nullptr;
  QSpinBox* heights_ = nullptr;
  int gesture_ = 0;  ///< of the slider under the hand
};

}  // namespace flatland::ui
