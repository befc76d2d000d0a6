// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core3d/study/section.h"
#include "ui/jobs/latest_job.h"
#include "ui/model/seen_surface.h"

namespace flatland::ui {

/// A pair of places that should be one: where an apparent ridge of the surface goes through the
/// plane, and the nearest apparent ridge of the section. Either may have no partner.
struct SectionPair {
  std::optional<std::size_t> ridge;   ///< index into SectionMarks::ridges
  std::optional<std::size_t> mark;    ///< index into SectionMarks::marks
  std::optional<double> distance;     ///< between them, in the unit of the file
  std::optional<double> offPlaneDeg;  ///< angle of t_A to the plane, at the ridge or at the mark
  double strength = 0.0;  ///< of the stronger, to be held against the threshold of apparent ridges
};

/// The section of the document's surface by its plane, and its marks in one view.
struct SectionView {
  std::shared_ptr<const LoadedSurface> surface;
  SurfacePlane plane;
  double tolerance;  ///< of the fit, in the unit of the file
  Section section;   ///< its scene is seen from where the camera is, as far as the plane allows
  std::vector<LineVertex> lines;  ///< exactly cut, in coordinates of the mesh

  std::shared_ptr<const SeenSurface> seen;  ///< null before lines were looked for
  std::string whyNoMarks;                   ///< in English; empty if there are marks
  SectionMarks marks;
  std::vector<bool> seenMarks, seenRidges;  ///< nothing of the surface is before them
  std::vector<SectionPair> pairs;           ///< by distance, those without partner last
};

/// What LineEnd::strength would be at a mark of the section. 0 without lambda.
double strengthOf(const SectionMark& mark, const LoadedSurface& surface);

/// True if nothing of the surface stands before a place of it, in the unit of the file.
bool isSeen(const LoadedSurface& surface, const SurfaceView& view, const Eigen::Vector3d& inFile);

/// Cuts and fits beside the window's thread whenever plane, surface or view change, the newest
/// there are, so that the section follows the hand.
class SectionSource : public QObject {
  Q_OBJECT

 public:
  static constexpr double kUsualTolerance = 1e-3;  ///< of the longest side of the surface

  SectionSource(const Document& document, const SurfaceSource& source, const SeenSource& seen,
                QObject* parent = nullptr);

  /// Null if there is no plane or nothing to cut yet.
  const std::shared_ptr<const SectionView>& view() const { return view_; }
  bool isStale() const { return job_.isStale(); }

  /// How far the fitted curves may be from the section, as a share of the surface's longest side;
  /// 0: kUsualTolerance, and at least a tenth of an edge.
  double tolerance() const { return tolerance_; }
  void setTolerance(double share);

  /// True if the scene's curves are those of the section: marks and ridges can be shown on them.
  bool isInFlatland() const;

  /// The pair that is talked about, ringed in both pictures: an index into view()->pairs. None
  /// after another cut, whose pairs are others.
  const std::optional<std::size_t>& chosen() const { return chosen_; }
  void choose(const std::optional<std::size_t>& pair);

 signals:
  void changed();
  void chosenChanged();
  void failed(const QString& reason);

 private:
  void follow(const Change& change);
  void update();
  void cutNewest();

  const Document& document_;
  const SurfaceSource& source_;
  const SeenSource& seen_;
  LatestJob job_;
  std::shared_ptr<const SectionView> view_;
  std::optional<std::size_t> chosen_;
  double tolerance_ = 0.0;
};

}  // namespace flatland::ui
