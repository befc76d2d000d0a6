// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/view3d/surface_models.h"

namespace flatland::ui {

/// The legend of the colours of the surface, as a row below its views, where it hides nothing. They
/// look from one place at one quantity, so there is one scale for all of them.
class ColourStrip : public QWidget {
  Q_OBJECT

 public:
  explicit ColourStrip(const SurfaceModels& models, QWidget* parent = nullptr);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {0, sizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void follow();

  SurfaceModels models_;
};

}  // namespace flatland::ui
