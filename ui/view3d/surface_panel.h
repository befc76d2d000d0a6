// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>

#include "flatland/scene/surface_setting.h"
#include "ui/view3d/surface_models.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace flatland::ui {

/// How the surface below its lines is shown, how smoothly curvature is estimated, the cameras kept,
/// and what was found in the file.
class SurfacePanel : public QWidget {
  Q_OBJECT

 public:
  explicit SurfacePanel(const SurfaceModels& models, QWidget* parent = nullptr);

 private:
  QWidget* makeLook();
  QWidget* makeCameras();
  void showSetting();
  void showReport();
  void edit(const QString& text, const std::function<void(SurfaceSetting&)>& change);
  void keepCamera();
  void useCamera();
  void forgetCamera();

  SurfaceModels models_;
  QComboBox* style_ = nullptr;
  QComboBox* quantity_ = nullptr;
  QDoubleSpinBox* scale_ = nullptr;
  QListWidget* cameras_ = nullptr;
  QPushButton* forget_ = nullptr;
  QLabel* report_ = nullptr;
};

/// "Lambert", "Colour map" in the person's language.
QString styleWords(SurfaceStyle style);

}  // namespace flatland::ui
