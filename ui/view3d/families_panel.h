// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

#include "ui/model/surface_look.h"
#include "ui/view3d/family_row.h"
#include "ui/view3d/surface_models.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QSpinBox;

namespace flatland::ui {

/// Which families of lines are drawn in the active view of the surface, how strong they must be and
/// how they look in all of them. Every choice is an undo step; a pull of a slider is one.
class FamiliesPanel : public QWidget {
  Q_OBJECT

 public:
  explicit FamiliesPanel(const SurfaceModels& models, QWidget* parent = nullptr);

  /// Without width and fade, which stand where there is room for them.
  QSize minimumSizeHint() const override;

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void addRow(LineFamily family, QGridLayout& grid, int line);
  /// How many levels there are of a family that has no threshold, in the place of one.
  QSpinBox* addLevels(LineFamily family, const char* id, const QString& tip,
                      int SurfaceSetting::*count);
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
  std::array<FamilyRow*, kLineFamilyCount> rows_{};
  std::array<QLabel*, FamilyRow::kColumns> heads_{};  ///< by column; null: it has none
  QGridLayout* grid_ = nullptr;
  QWidget* common_ = nullptr;
  QComboBox* hidden_ = nullptr;
  QCheckBox* unfiltered_ = nullptr;
  QSpinBox* isophotes_ = nullptr;
  QSpinBox* heights_ = nullptr;
};

}  // namespace flatland::ui
