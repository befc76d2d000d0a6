// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/plane_marks.h"

#include <QPainter>
#include <QPainterPath>

#include "ui/export/figure_qt.h"
#include "ui/model/bridges.h"
#include "ui/model/cutting_plane.h"
#include "ui/model/surface_look.h"
#include "ui/model/theme.h"
#include "ui/panels/mark_painting.h"
#include "ui/view3d/mark_lines.h"

namespace flatland::ui {

namespace {

constexpr double kHandlePx = 5.5, kHotPx = 8.0;  ///< radii

QPointF pointOf(const Eigen::Vector2d& p) { return {p.x(), p.y()}; }

void paintHandles(QPainter& painter, const SurfaceModels& models, const SurfacePlane& plane,
                  const Projection& projection) {
  const double radius = models.source.surface()->ballRadius, scale = models.display.uiScale();
  const QColor colour = toQColor(sectionColour(themePalette()));
  const QColor ground = painter.background().color();
  QPainterPath rim;
  for (const Eigen::Vector3d& p : rimOf(plane, radius)) {
    const auto at = projection.toScreen(p);
    if (!at) continue;
    if (rim.elementCount() == 0) {
      rim.moveTo(pointOf(*at));
    } else {
      rim.lineTo(pointOf(*at));
    }
  }
  rim.closeSubpath();
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colour, 1.2 * scale, Qt::DashLine));
  painter.drawPath(rim);
  const PlaneHandles handles = handlesOf(plane, radius);
  const PlaneGrip& grip = models.bridges.grip;
  const auto paint = [&](const Eigen::Vector3d& p, int number) {
    const auto at = projection.toScreen(p);
    if (!at) return;
    const bool hot = grip.handle() == number;
    const bool filled = hot || (number == 0 && grip.hasKeys());
    painter.setPen(QPen(colour, 2.0 * scale));
    painter.setBrush(filled ? colour : ground);
    const double size = scale * (hot ? kHotPx : kHandlePx);
    if (number == 0) {
      painter.drawRect(QRectF(at->x() - size, at->y() - size, 2.0 * size, 2.0 * size));
    } else {
      painter.drawEllipse(pointOf(*at), size, size);
    }
  };
  // The way the middle moves.
  const auto from = projection.toScreen(plane.point - 0.25 * handles.radius * plane.normal),
             to = projection.toScreen(plane.point + 0.25 * handles.radius * plane.normal);
  if (from && to) {
    painter.setPen(QPen(colour, 1.6 * scale));
    painter.drawLine(pointOf(*from), pointOf(*to));
  }
  for (int i = 0; i < 4; ++i) paint(handles.rim[static_cast<std::size_t>(i)], i + 1);
  paint(handles.centre, 0);
}

}  // namespace

std::vector<bool> seenSpots(const SectionView& section) {
  std::vector<bool> seen = section.seenMarks;
  seen.insert(seen.end(), section.seenRidges.begin(), section.seenRidges.end());
  return seen;
}

std::vector<bool> seenSpots(const SectionView& section, const SurfaceView& view) {
  const LoadedSurface& surface = *section.surface;
  std::vector<bool> seen;
  for (const SectionMark& mark : section.marks.marks)
    seen.push_back(isSeen(surface, view, mark.at));
  for (const CrossedRidge& ridge : section.marks.ridges) {
    seen.push_back(isSeen(surface, view, ridge.at));
  }
  return seen;
}

std::vector<SectionSpot> sectionSpots(const SectionView& section, const std::vector<bool>& seen,
                                      const Projection& projection, const SurfaceSetting& setting,
                                      MarkKinds kinds, Palette palette, double scale) {
  const TriangleMesh& mesh = *section.surface->mesh;
  const auto onScreen = [&](const Eigen::Vector3d& inFile) {
    return projection.toScreen((inFile - mesh.origin) / mesh.unit);
  };
  const bool leavesHiddenOut = hiddenOf(setting) == HiddenLines::Off;
  std::vector<SectionSpot> spots;
  const std::vector<SectionMark>& marks = section.marks.marks;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const MarkKind kind = marks[i].mark.kind;
    const auto at = onScreen(marks[i].at);
    if (!at || !contains(kinds, kind)) continue;
    const bool hidden = !seen[i];
    if (hidden && leavesHiddenOut) continue;
    spots.push_back(
        {markSymbol(kind, *at, scale * kSymbolSizePx, 0.0, palette, hidden), 0, *at, hidden});
  }
  for (std::size_t k = 0; k < section.pairs.size(); ++k) {
    const auto& ridge = section.pairs[k].ridge;
    if (!ridge) continue;
    const bool hidden = !seen[marks.size() + *ridge];
    const auto at = onScreen(section.marks.ridges[*ridge].at);
    if (!at || (hidden && leavesHiddenOut)) continue;
    spots.push_back({{}, static_cast<int>(k) + 1, *at, hidden});
  }
  return spots;
}

std::vector<Eigen::Vector2d> chosenSpots(const SectionSource& source,
                                         const Projection& projection) {
  std::vector<Eigen::Vector2d> spots;
  if (!source.view() || !source.chosen()) return spots;
  const SectionView& section = *source.view();
  const TriangleMesh& mesh = *section.surface->mesh;
  const SectionPair& pair = section.pairs.at(*source.chosen());
  const auto add = [&](const Eigen::Vector3d& inFile) {
    if (const auto at = projection.toScreen((inFile - mesh.origin) / mesh.unit))
      spots.push_back(*at);
  };
  if (pair.ridge) add(section.marks.ridges[*pair.ridge].at);
  if (pair.mark) add(section.marks.marks[*pair.mark].at);
  return spots;
}

void paintPlane(QPainter& painter, const SurfaceModels& models, const Projection& projection) {
  const auto& setting = models.document.scene().surface;
  if (!setting || !setting->plane || !models.source.surface()) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const auto& section = models.bridges.section.view();
  if (section && section->surface->mesh == models.source.surface()->mesh) {
    const double scale = models.display.uiScale();
    for (const SectionSpot& spot : sectionSpots(*section, seenSpots(*section), projection, *setting,
                                                models.display.families(), themePalette(), scale)) {
      if (spot.crossing > 0) {
        paintCrossing(painter, pointOf(spot.at), spot.crossing, scale, spot.hidden);
      } else {
        paintShape(painter, spot.symbol);
      }
    }
    for (const Eigen::Vector2d& at : chosenSpots(models.bridges.section, projection)) {
      paintChosen(painter, pointOf(at), scale);
    }
  }
  paintHandles(painter, models, *setting->plane, projection);
  painter.restore();
}

}  // namespace flatland::ui
