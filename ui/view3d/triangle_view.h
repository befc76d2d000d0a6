// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <memory>

#include "core3d/study/triangle_lesson.h"
#include "ui/model/display.h"

namespace flatland::ui {

/// The stages of Fig. 5-1 of the thesis.
enum class TriangleStage { Ring, Directions, Crossing, Perpendiculars };
inline constexpr int kTriangleStageCount = 4;

/// A triangle of the mesh in its own plane, turned as it is seen, with the stages of Fig. 5-1 over
/// it: (a) where lambda is compared, (b) t_A turned to where lambda grows, the ones flipped dashed
/// as they came, (c) crossings and the piece of line, (d) the perpendiculars it is judged by.
class TriangleView : public QWidget {
  Q_OBJECT

 public:
  explicit TriangleView(const Display& display, QWidget* parent = nullptr);

  /// `right` and `up` of the picture, in coordinates of the mesh; null: nothing to draw.
  void show(std::shared_ptr<const TriangleLesson> lesson, const Eigen::Vector3d& right,
            const Eigen::Vector3d& up);
  void setShown(TriangleStage stage, bool shown);
  bool isShown(TriangleStage stage) const { return shown_[static_cast<std::size_t>(stage)]; }

  QSize sizeHint() const override { return {320, 130}; }
  QSize minimumSizeHint() const override { return {160, 120}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Sheet;
  void fitRing(Sheet& sheet) const;
  void paintRing(QPainter& painter, const Sheet& sheet) const;
  void paintDirections(QPainter& painter, const Sheet& sheet) const;
  void paintCrossing(QPainter& painter, const Sheet& sheet) const;
  void paintPerpendiculars(QPainter& painter, const Sheet& sheet) const;

  const Display& display_;
  std::shared_ptr<const TriangleLesson> lesson_;
  Eigen::Vector3d right_ = Eigen::Vector3d::UnitX(), up_ = Eigen::Vector3d::UnitY();
  std::array<bool, kTriangleStageCount> shown_{true, true, true, true};
};

}  // namespace flatland::ui
