// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>

#include "ui/export/mark_style.h"
#include "ui/model/document.h"
#include "ui/model/surface_look.h"

class QAbstractButton;
class QCheckBox;
class QDoubleSpinBox;
class QGridLayout;
class QSlider;
class QWidget;

namespace flatland::ui {

/// One family of lines in the panel Lines: its name, threshold, colour, width and fade in a line,
/// and below it, as wide as the panel, a slider for the threshold, where there is one.
class FamilyRow : public QObject {
  Q_OBJECT

 public:
  enum Column { kName, kNumber, kColour, kWidth, kFade, kColumns };
  static constexpr int kLines = 2;  ///< of the grid

  /// The widgets become children of the panel.
  FamilyRow(LineFamily family, Document& document, QWidget& panel);

  void addTo(QGridLayout& grid, int line);
  void show(const SurfaceFamily& look, Palette palette);
  /// To the digits in the font there is.
  void fitFields();
  /// What stands in a column. Null: nothing of this family.
  QWidget* part(int column) const;

 signals:
  void switched(bool on);
  /// Edits with the same gesture number, if it is not 0, are one step.
  void edited(const std::function<void(SurfaceFamily&)>& change, int gesture);
  void colourWanted();

 private:
  void addThreshold(Document& document, QWidget& panel, const QString& title);
  void addLook(QWidget& panel, const QString& title);

  LineFamily family_;
  QCheckBox* on_ = nullptr;
  QSlider* slider_ = nullptr;            ///< null without a threshold
  QDoubleSpinBox* threshold_ = nullptr;  ///< null without a threshold
  QAbstractButton* colour_ = nullptr;
  QDoubleSpinBox* width_ = nullptr;
  QCheckBox* fade_ = nullptr;  ///< null without a threshold: none of its lines is weak
  int gesture_ = 0;            ///< of the slider under the hand
};

}  // namespace flatland::ui
