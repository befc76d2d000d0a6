// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>

#include "ui/jobs/latest_job.h"
#include "ui/view3d/surface_models.h"

namespace flatland::ui {

/// The surface painted without OpenGL, beside the window's thread: where there is none, as in
/// pictures taken without a display. The last picture stays until the next is there.
class SoftCanvas : public QWidget {
  Q_OBJECT

 public:
  explicit SoftCanvas(const SurfaceModels& models, QWidget* parent = nullptr);

 signals:
  void painted(double milliseconds);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void renew();
  void paint();

  SurfaceModels models_;
  LatestJob job_;
  QImage image_;
};

}  // namespace flatland::ui
