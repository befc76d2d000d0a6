// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/triangle_view.h"

#include <Eigen/Geometry>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/export/figure_qt.h"
#include "ui/export/mark_style.h"
#include "ui/model/theme.h"
#include "ui/view3d/arrow.h"

namespace flatland::ui {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Lesson = TriangleLesson;

constexpr double kTriangleShare = 0.52;  ///< of the smaller side: there is room for arrows
constexpr double kArrowShare = 0.2;      ///< of the same
constexpr double kDotPx = 3.5;
constexpr double kMarginPx = 4.0;
constexpr double kLeastShare = 0.3;  ///< of the usual scale, where neighbours are far away

}  // namespace

/// The plane of the triangle on the widget.
struct TriangleView::Sheet {
  Vector3d middle, right, up;
  double scale = 1.0, arrow = 40.0, ui = 1.0;
  QPointF centre;
  QColor text, faint, line, ground, good, bad;

  QPointF at(const Vector3d& p) const {
    const Vector3d d = p - middle;
    return centre + QPointF(scale * right.dot(d), -scale * up.dot(d));
  }
  /// A direction, as long as all of them are shown.
  QPointF along(const Vector3d& direction) const {
    const Vector2d d(right.dot(direction), -up.dot(direction));
    const double length = d.norm();
    return length > 0.0 ? arrow / length * QPointF(d.x(), d.y()) : QPointF();
  }
};

TriangleView::TriangleView(const Display& display, QWidget* parent)
    : QWidget(parent), display_(display) {
  setObjectName("triangle.view");
  setAccessibleName(tr("The triangle"));
  setToolTip(
      tr("The picked triangle in its own plane. Bars: crossings; orange: t_A to where λ "
         "grows; dashed: as it came"));
  connect(&display_, &Display::changed, this, qOverload<>(&QWidget::update));
}

void TriangleView::show(std::shared_ptr<const TriangleLesson> lesson, const Vector3d& right,
                        const Vector3d& up) {
  lesson_ = std::move(lesson);
  right_ = right;
  up_ = up;
  update();
}

void TriangleView::setShown(TriangleStage stage, bool shown) {
  bool& now = shown_[static_cast<std::size_t>(stage)];
  if (now == shown) return;
  now = shown;
  update();
}

void TriangleView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const SceneColours& colours = sceneColours(themePalette());
  Sheet sheet;
  sheet.ui = display_.uiScale();
  sheet.text = toQColor(colours.text);
  sheet.faint = toQColor(colours.faint);
  sheet.ground = toQColor(colours.background);
  sheet.line = toQColor(styleOf(MarkKind::ApparentRidge, themePalette()).colour);
  sheet.good = toQColor(styleOf(MarkKind::Inflection, themePalette()).colour);
  sheet.bad = toQColor(styleOf(MarkKind::Ridge, themePalette()).colour);
  painter.fillRect(rect(), sheet.ground);
  if (!lesson_) return;
  const auto& corners = lesson_->corners;
  const Vector3d a = corners[0].at, b = corners[1].at, c = corners[2].at;
  const Vector3d normal = (b - a).cross(c - a);
  if (!(normal.norm() > 0.0)) return;
  // The picture's upward direction, laid into the plane; seen from the side its normal points to.
  const Vector3d n = normal.normalized();
  Vector3d up = up_ - n * n.dot(up_);
  if (up.norm() < 1e-6) up = right_.cross(n);
  sheet.up = up.normalized();
  sheet.right = sheet.up.cross(n);
  sheet.middle = (a + b + c) / 3.0;
  const double reach =
      std::max({(a - sheet.middle).norm(), (b - sheet.middle).norm(), (c - sheet.middle).norm()});
  const double side = std::min(width(), height());
  sheet.scale = kTriangleShare * 0.72 * side / reach;
  sheet.arrow = kArrowShare * side;
  sheet.centre = QPointF(0.5 * width(), 0.5 * height());
  if (isShown(TriangleStage::Ring)) fitRing(sheet);
  painter.setPen(QPen(sheet.faint, 1.5 * sheet.ui));
  painter.drawPolygon(QPolygonF{sheet.at(a), sheet.at(b), sheet.at(c)});
  if (isShown(TriangleStage::Ring)) paintRing(painter, sheet);
  if (isShown(TriangleStage::Perpendiculars)) paintPerpendiculars(painter, sheet);
  if (isShown(TriangleStage::Crossing)) paintCrossing(painter, sheet);
  if (isShown(TriangleStage::Directions)) paintDirections(painter, sheet);
  painter.setPen(sheet.text);
  painter.setBrush(Qt::NoBrush);
  for (std::size_t k = 0; k < 3; ++k) {
    const QPointF p = sheet.at(corners[k].at), away = p - sheet.centre;
    const double length = std::hypot(away.x(), away.y());
    const QPointF at = p + (length > 0.0 ? 14.0 * sheet.ui / length * away : QPointF());
    const QRectF box(at.x() - 20.0, at.y() - 20.0, 40.0, 40.0);
    painter.drawText(box, Qt::AlignCenter, QString(QChar('A' + static_cast<int>(k))));
  }
}

/// Smaller, as far as it helps, so that the places of the ring are on the widget.
void TriangleView::fitRing(Sheet& sheet) const {
  const double margin = (kDotPx + kMarginPx) * sheet.ui, usual = sheet.scale;
  for (const Lesson::Corner& corner : lesson_->corners) {
    for (const Vector3d& w : corner.ring) {
      const QPointF d = sheet.at(w) - sheet.centre;
      const double xShare = (sheet.centre.x() - margin) / std::abs(d.x());
      const double yShare = (sheet.centre.y() - margin) / std::abs(d.y());
      sheet.scale *= std::min({xShare, yShare, 1.0});  // an infinite share is none
    }
  }
  sheet.scale = std::max(sheet.scale, kLeastShare * usual);
}

void TriangleView::paintRing(QPainter& painter, const Sheet& sheet) const {
  for (const Lesson::Corner& corner : lesson_->corners) {
    const QPointF p = sheet.at(corner.at);
    for (const Vector3d& w : corner.ring) {
      painter.setPen(QPen(sheet.faint, 1.0 * sheet.ui, Qt::DotLine));
      painter.drawLine(p, sheet.at(w));
      painter.setPen(QPen(sheet.text, 1.0 * sheet.ui));
      painter.setBrush(sheet.ground);
      painter.drawEllipse(sheet.at(w), kDotPx * sheet.ui, kDotPx * sheet.ui);
    }
  }
}

void TriangleView::paintDirections(QPainter& painter, const Sheet& sheet) const {
  for (const Lesson::Corner& corner : lesson_->corners) {
    const QPointF p = sheet.at(corner.at);
    if (corner.flipped) {
      QPen dashed(sheet.line, 1.5 * sheet.ui, Qt::DashLine);
      paintArrow(painter, p, p + sheet.along(corner.tangent), dashed, sheet.ui);
    }
    if (!corner.growing.isZero()) {
      paintArrow(painter, p, p + sheet.along(corner.growing), QPen(sheet.line, 2.5 * sheet.ui),
                 sheet.ui);
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(sheet.text);
    painter.drawEllipse(p, kDotPx * sheet.ui, kDotPx * sheet.ui);
  }
}

void TriangleView::paintCrossing(QPainter& painter, const Sheet& sheet) const {
  for (const Lesson::Piece& piece : lesson_->pieces) {
    painter.setPen(QPen(sheet.text, (piece.drawn ? 4.0 : 2.0) * sheet.ui,
                        piece.drawn ? Qt::SolidLine : Qt::DashLine));
    painter.drawLine(sheet.at(piece.a), sheet.at(piece.b));
  }
  for (const Lesson::Crossing& crossing : lesson_->crossings) {
    const QPointF p = sheet.at(crossing.at);
    painter.setPen(QPen(sheet.text, 1.5 * sheet.ui));
    painter.setBrush(sheet.ground);
    painter.drawRect(QRectF(p.x() - kDotPx, p.y() - kDotPx, 2.0 * kDotPx, 2.0 * kDotPx));
    // Where the thesis would put it: a cross.
    const auto k = static_cast<std::size_t>(crossing.corner);
    const Vector3d from = lesson_->corners[k].at, to = lesson_->corners[(k + 1) % 3].at;
    const QPointF q = sheet.at(from + crossing.thesisT * (to - from));
    painter.setPen(QPen(sheet.faint, 1.5 * sheet.ui));
    painter.drawLine(q + QPointF(-4, -4), q + QPointF(4, 4));
    painter.drawLine(q + QPointF(-4, 4), q + QPointF(4, -4));
  }
}

void TriangleView::paintPerpendiculars(QPainter& painter, const Sheet& sheet) const {
  for (const Lesson::Piece& piece : lesson_->pieces) {
    for (const Lesson::Piece::Test& test : piece.tests) {
      const Vector3d& corner = lesson_->corners[static_cast<std::size_t>(test.corner)].at;
      const QColor colour = test.passes ? sheet.good : sheet.bad;
      painter.setPen(QPen(colour, 1.5 * sheet.ui, test.passes ? Qt::SolidLine : Qt::DashLine));
      painter.drawLine(sheet.at(corner), sheet.at(test.foot));
    }
  }
}

}  // namespace flatland::ui
