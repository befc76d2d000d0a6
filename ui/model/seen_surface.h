// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <array>
#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "core3d/lines/line_finder.h"
#include "ui/jobs/latest_job.h"
#include "ui/model/ink_source.h"
#include "ui/model/surface_colours.h"
#include "ui/model/surface_panes.h"
#include "ui/model/surface_source.h"

namespace flatland::ui {

/// An end of a line segment; two in a row are a segment.
struct LineVertex {
  float x, y, z;
  float strength;
};

/// How the lines of a view differ from those of the first view (core3d/draw/line_difference.h).
struct SeenDifference {
  enum Part { Common, Added, Missing };
  static constexpr std::size_t kParts = 3;
  std::array<std::vector<LineSegment>, kParts> pieces;
  std::array<std::vector<LineVertex>, kParts> lines;  ///< the same to be drawn
  double addedShare = 0.0;                            ///< of the length of the view's lines
  double missingShare = 0.0;                          ///< of the length of the first view's lines
  double tolerance = 0.0;                             ///< coordinates of the mesh: its mean edge
};

/// What was found on the surface for one view of it.
struct SeenSurface {
  std::shared_ptr<const LoadedSurface> surface;
  SurfaceView view;
  std::shared_ptr<const FeatureLines> found;  ///< pieces of line that `lines` are made from
  /// The strokes that `flatland lines` draws in a picture of this shape, the hidden ones too; every
  /// piece of line that was found if the look is unfiltered.
  std::array<std::vector<LineVertex>, kLineFamilyCount> lines;
  /// How many ends of each family's, from the first on, are not hidden. Empty: that is not known.
  std::optional<std::array<std::size_t, kLineFamilyCount>> visibleEnds;
  std::optional<SeenDifference> difference;  ///< if the view shows that
  std::optional<VertexColours> colours;      ///< of the quantity asked for
  double lineMs = 0.0;                       ///< looking for the lines and judging strokes
  double colourMs = 0.0;

  /// Contours and all apparent ridges, however weak and whatever the look shows: what flatland's
  /// marks, which know no threshold, are compared with. Looked for once, by who first asks for
  /// them, in any thread; at once there if the look shows just these.
  std::shared_future<std::shared_ptr<const FeatureLines>> compared;

  /// True if what is hidden is known, and about the same from there: within 3 degrees, so that
  /// lines of a moving camera are not told to be hidden in two ways by turns.
  bool knowsHidden(const SurfaceView& from) const;
};

/// The lines of one view of the document's surface as its camera sees it, found beside the window's
/// thread. A change starts the search; while one is under way only the newest wish is kept, so
/// lines follow a moving camera as fast as they can be found and never pile up. The last ones stay
/// until the next are there, also those of a swept surface whose curve is being dragged.
class SeenSource : public QObject {
  Q_OBJECT

 public:
  /// For the view of this number. `first`, the source of view 0, outlives this one: where both look
  /// for the same lines they are found once.
  SeenSource(const Document& document, const SurfaceSource& source, std::size_t pane = 0,
             const SeenSource* first = nullptr, const InkSource* ink = nullptr,
             QObject* parent = nullptr);
  ~SeenSource() override;

  /// Null if there is no such view, or no surface with fields yet.
  const std::shared_ptr<const SeenSurface>& seen() const { return seen_; }

  /// True while seen() is of another view or other settings.
  bool isStale() const { return job_.isStale() || (borrows_ && first_->isStale()); }
  int searches() const { return searches_; }  ///< of its own, ended so far
  /// How often they had to go through the surface there is; what is drawn otherwise, or was found
  /// just before, needs not.
  int findings() const;

  /// Of the picture, width over height (> 0): strokes are as long as they are in it.
  void setAspect(double aspect);

 signals:
  void changed();
  void failed(const QString& reason);

 private:
  struct Worker;
  /// Lines of a view, with the factor on its thresholds that ink needs.
  struct Lines {
    PaneSetting pane;
    double factor = 1.0;

    bool operator==(const Lines&) const = default;
  };
  /// What a search is asked for: the view, and the first one where it is compared with that.
  struct Wanted {
    Lines lines;
    std::optional<Lines> first;
    double aspect = 1.0;
    bool sight = true;  ///< what is hidden is to be found, else left to whoever draws

    bool operator==(const Wanted&) const = default;
  };
  void follow(const Change& change);
  void surfaceChanged();
  void search();
  void begin();
  bool isReady() const;
  Wanted wanted() const;
  Lines linesOf(std::size_t pane) const;
  void borrow();
  void drop();

  const Document& document_;
  const SurfaceSource& source_;
  const std::size_t pane_;
  const SeenSource* first_;
  const InkSource* ink_;  ///< null: thresholds as given
  LatestJob job_;
  std::shared_ptr<Worker> worker_;  ///< of the surface there is, shared with its jobs
  std::shared_ptr<const SeenSurface> seen_;
  std::optional<Wanted> asked_;  ///< of the last search
  bool borrows_ = false;         ///< what the first view found
  double aspect_ = 4.0 / 3.0;
  int searches_ = 0;
};

}  // namespace flatland::ui
