// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/model/stage.h"

class QCheckBox;
class QDoubleSpinBox;

namespace flatland::ui {

/// From where the scene is seen, as numbers: angle, quarter turns, perspective with its distance.
class ViewPanel : public QWidget {
  Q_OBJECT

 public:
  ViewPanel(Document& document, const Stage& stage, QWidget* parent = nullptr);

 private:
  void showView();
  void typeAngle(double angleDeg);
  void typeDistance(double distance);
  void setPerspective(bool on);
  void set(const View& view);

  Document& document_;
  const Stage& stage_;
  QDoubleSpinBox* angle_;
  QCheckBox* perspective_;
  QDoubleSpinBox* distance_;
};

}  // namespace flatland::ui
