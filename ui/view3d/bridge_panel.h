// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>

#include "ui/flat/canvas_models.h"
#include "ui/model/bridges.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace flatland::ui {

class BridgeStudy;

/// A curve as a surface: which one and how it is swept, whether the views are linked, and how well
/// the lines of the surface agree with what flatland predicts.
class BridgePanel : public QWidget {
  Q_OBJECT

 public:
  BridgePanel(const CanvasModels& models, Bridges& bridges, QWidget* parent = nullptr);

 signals:
  /// For the status line.
  void said(const QString& text);

 private:
  void addSweep(QFormLayout& form);
  void addSwitches(QFormLayout& form);
  void showSetting();
  void showAgreement();
  void chooseKind(int index);
  void edit(const QString& text, const std::function<void(SweptSetting&)>& change);

  CanvasModels models_;
  Bridges& bridges_;
  QComboBox* kind_ = nullptr;
  QComboBox* curve_ = nullptr;
  QLabel* amountName_ = nullptr;
  QDoubleSpinBox* amount_ = nullptr;
  QSpinBox* cells_ = nullptr;
  QCheckBox* link_ = nullptr;
  QCheckBox* predicted_ = nullptr;
  QLabel* why_ = nullptr;
  QLabel* agreement_ = nullptr;
  BridgeStudy* study_ = nullptr;
};

}  // namespace flatland::ui
