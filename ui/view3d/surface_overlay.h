// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/model/surface_probe.h"
#include "ui/view3d/surface_models.h"

namespace flatland::ui {

/// What is written over the picture of the surface: its name and size, how long frame and lines
/// took, the bar of colours, and what is under the pointer. Lets every event through.
class SurfaceOverlay : public QWidget {
  Q_OBJECT

 public:
  SurfaceOverlay(const SurfaceModels& models, QWidget* parent);

  void setFrameMs(double milliseconds);
  void setReading(const std::optional<SurfaceReading>& reading);
  const std::optional<SurfaceReading>& reading() const { return reading_; }
  /// The predicted line under the pointer, by its number.
  void setPredicted(const std::optional<std::size_t>& line);

  /// The words at each corner, for tests and for who cannot see them.
  QStringList titleLines() const;
  QStringList timeLines() const;
  QStringList readingLines() const;
  QStringList differenceWords() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QStringList predictedLines() const;

  SurfaceModels models_;
  double frameMs_ = 0.0;
  std::optional<SurfaceReading> reading_;
  std::optional<std::size_t> predicted_;
};

/// "k1 (largest curvature)" in the person's language.
QString quantityWords(SurfaceQuantity quantity);

}  // namespace flatland::ui
