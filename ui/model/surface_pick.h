// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "core3d/lines/vertex_terms.h"
#include "ui/model/surface_source.h"

namespace flatland::ui {

/// The place of the surface that a person picked, by a click on its picture or by number: what the
/// derivation, the triangle and the cutting plane are about. It stays where it is on the surface
/// while the camera moves and the fields are estimated anew, and goes with its mesh. Where a swept
/// surface is meshed anew it stays as near as the other mesh comes to it.
class SurfacePick : public QObject {
  Q_OBJECT

 public:
  explicit SurfacePick(const SurfaceSource& source, QObject* parent = nullptr);

  /// Triangle, weights of its corners and the place, in coordinates of the mesh; empty: none.
  const std::optional<SurfaceHit>& hit() const { return hit_; }

  /// The surface it lies on, null if there is none; fields may not be there yet. Only with hit().
  const std::shared_ptr<const LoadedSurface>& surface() const { return source_.surface(); }

  /// The corner of the triangle nearest to the place. Precondition: hit().
  std::uint32_t vertex() const { return hit_->nearestVertex(*surface()->mesh); }

  /// Picks a place of the surface there is; nullopt: none.
  void pick(const std::optional<SurfaceHit>& hit);

  /// Picks a vertex, as a corner of its first triangle, or the middle of a triangle. Out of range,
  /// or without a surface: nothing happens.
  void pickVertex(std::uint32_t vertex);
  void pickTriangle(std::uint32_t triangle);

  /// The same as soon as a surface is there that has been read; of a swept one, on the mesh that is
  /// asked for: numbers of a coarser one say nothing.
  void pickWhenRead(bool isTriangle, std::uint32_t number);

 signals:
  /// Another place, none any more, or the same one with other fields.
  void changed();

 private:
  void follow();

  const SurfaceSource& source_;
  std::shared_ptr<const LoadedSurface> seen_;  ///< that hit_ is about, last told
  std::optional<SurfaceHit> hit_;
  struct Wish {
    bool isTriangle;
    std::uint32_t number;
  };
  std::optional<Wish> wish_;  ///< for the surface that is being read
};

}  // namespace flatland::ui
