// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <compare>
#include <optional>
#include <set>

#include "ui/model/document.h"

namespace flatland::ui {

/// A control point of the scene.
struct PointRef {
  std::size_t curve;
  std::size_t point;

  auto operator<=>(const PointRef&) const = default;
};

/// A mark by its place among its like, which lasts while points are dragged and t changes: the
/// `ordinal`-th mark of this kind on this curve, from 0.
struct MarkKey {
  MarkKind kind;
  int curve;
  int ordinal;

  bool operator==(const MarkKey&) const = default;
};

/// Key of the mark at `index`. Precondition: index in range.
MarkKey keyOf(const FeatureSet& features, std::size_t index);

/// Index of the mark with this key; nullopt if there is none (any more).
std::optional<std::size_t> indexOf(const FeatureSet& features, const MarkKey& key);

/// What the person has picked: control points, one mark, and the curve the Curve menu works on.
/// Points that vanish from the document leave the selection by themselves; what is picked of a
/// curve stays picked when others leave or come back.
class Selection : public QObject {
  Q_OBJECT

 public:
  explicit Selection(const Document& document, QObject* parent = nullptr);

  const std::set<PointRef>& points() const { return points_; }
  /// The indices of the selected points of one curve.
  std::set<std::size_t> pointsOf(std::size_t curve) const;
  const std::optional<MarkKey>& mark() const { return mark_; }

  /// The curve the Curve menu works on: the one picked last; nullopt only in a scene without
  /// curves.
  std::optional<std::size_t> currentCurve() const;

  /// References out of range are left out.
  void setPoints(std::set<PointRef> points);
  void toggle(const PointRef& point);
  void setMark(std::optional<MarkKey> mark);
  void setCurrentCurve(std::size_t curve);
  void selectAll();
  void clear();

  /// Selects the point after (`step` = 1) or before (-1) the selected one, around the whole scene;
  /// the first or last one if none is selected.
  void step(int step);

 signals:
  void changed();

 private:
  void documentChanged(const Change& change);
  void goAlong(const CurveShift& shift);
  std::set<PointRef> allPoints() const;
  bool exists(const PointRef& point) const;

  const Document& document_;
  std::set<PointRef> points_;
  std::optional<MarkKey> mark_;
  std::size_t currentCurve_ = 0;
};

}  // namespace flatland::ui
