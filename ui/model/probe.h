// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "flatland/features/terms.h"
#include "flatland/study/profile_lines.h"
#include "ui/model/document.h"

namespace flatland::ui {

/// The one place on a curve that canvas, plots, lesson and numbers all look at. Follows the curve
/// when points move, stays in place when points are inserted or removed, goes home()
/// when its curve leaves, and begins at home() in another scene.
class Probe : public QObject {
  Q_OBJECT

 public:
  struct Place {
    std::size_t curve;
    double t;  ///< chain parameter, in [0, pieceCount]

    bool operator==(const Place&) const = default;
  };

  /// What is known there. No value where the curve has no tangent (a cusp).
  struct Reading {
    Jet jet;
    Frame frame;  ///< with the side of normalSide()
    int side;
    Terms terms;
    double size;  ///< of the curve, a length to judge others by
  };

  /// At any place of a scene, which must exist; nullopt where the curve has no tangent.
  static std::optional<Reading> readingAt(const Scene& scene, const Place& place);

  /// One of the quantities of the plots; nullopt where it is infinite or undefined.
  static std::optional<double> valueOf(const Reading& reading, ProfileQuantity quantity);

  explicit Probe(const Document& document, QObject* parent = nullptr);

  const std::optional<Place>& place() const { return place_; }

  /// t is clamped to the curve's domain; a curve that does not exist clears the probe.
  void setPlace(std::optional<Place> place);

  /// Moves by `share` of the curve's parameter domain; around on a closed curve, to the end on an
  /// open one. Starts in the middle of the first curve if there was no place.
  void moveBy(double share);

  /// Where the probe is put on a curve just added or, the first one, in a scene just opened: off
  /// the marks; nullopt if there is no such curve.
  std::optional<Place> home(std::size_t curve = 0) const;

  /// Computed anew at each call; cheap.
  std::optional<Reading> reading() const;

 signals:
  /// The place, or what is read there, is another.
  void changed();

 private:
  void follow(const Change& change);
  void remember();
  std::optional<Place> valid(std::optional<Place> place) const;

  const Document& document_;
  std::optional<Place> place_;
  Vec2 point_ = Vec2::Zero();  ///< where it is in the plane
};

}  // namespace flatland::ui
