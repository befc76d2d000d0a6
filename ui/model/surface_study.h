// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "core3d/draw/camera.h"
#include "core3d/study/surface_derivation.h"
#include "core3d/study/triangle_lesson.h"
#include "ui/jobs/latest_job.h"
#include "ui/model/document.h"
#include "ui/model/surface_pick.h"
#include "ui/model/surface_views.h"

namespace flatland::ui {

/// What chapters 4 and 5 say of the picked point, as the camera sees it: the place at the vertex
/// nearest to it, at once, and what becomes of its triangle, found beside the window's thread.
class SurfaceStudy : public QObject {
  Q_OBJECT

 public:
  SurfaceStudy(const Document& document, SurfacePick& pick, const SurfaceViews& views,
               QObject* parent = nullptr);
  ~SurfaceStudy() override;

  /// The pick; to choose another vertex or triangle.
  SurfacePick& pick() { return pick_; }
  /// Empty without a pick or fields, and where the normal is unknown.
  const std::optional<SurfacePlace>& place() const { return place_; }
  /// Null until it is found. Of the last camera, threshold or triangle until that of the next is
  /// there, and as it was left while nobody wants triangles.
  const std::shared_ptr<const TriangleLesson>& lesson() const { return lesson_; }
  /// True while lesson() is of another camera.
  bool isStale() const { return job_.isStale(); }

  /// The surface as it is drawn: all that is told is told of its first view.
  const std::optional<SurfaceSetting>& setting() const { return document_.scene().surface; }

  /// How the camera sees the surface; the picture is of this size. Precondition: a pick.
  Projection projection(double width, double height) const;

  /// Whether triangles are looked at: nobody needs it while nobody sees it.
  void setTriangleWanted(bool wanted);

 signals:
  void changed();        ///< pick or place
  void lessonChanged();  ///< or there is none any more
  void failed(const QString& reason);

 private:
  struct Worker;
  void refresh();
  void search();
  void begin();

  const Document& document_;
  SurfacePick& pick_;
  const SurfaceViews& views_;
  LatestJob job_;
  std::shared_ptr<Worker> worker_;
  std::optional<SurfacePlace> place_;
  std::shared_ptr<const TriangleLesson> lesson_;
  bool wanted_ = false;
};

}  // namespace flatland::ui
