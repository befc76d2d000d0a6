// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core3d/lines/line_finder.h"
#include "ui/jobs/job.h"
#include "ui/model/surface_colours.h"
#include "ui/model/surface_source.h"

namespace flatland::ui {

/// An end of a line segment; two in a row are a segment.
struct LineVertex {
  float x, y, z;
  float strength;
};

/// What was found on the surface for one view of it.
struct SeenSurface {
  std::shared_ptr<const LoadedSurface> surface;
  SurfaceView view;
  std::array<std::vector<LineVertex>, kLineFamilyCount> lines;
  std::optional<VertexColours> colours;  ///< of the quantity asked for
  double lineMs = 0.0;                   ///< looking for the lines
  double colourMs = 0.0;
};

/// The lines of the document's surface as its camera sees it, found beside the window's thread. A
/// change starts the search; while one is under way only the newest wish is kept, so lines follow a
/// moving camera as fast as they can be found and never pile up. The last ones stay until the next
/// are there.
class SeenSource : public QObject {
  Q_OBJECT

 public:
  SeenSource(const Document& document, const SurfaceSource& source, QObject* parent = nullptr);
  ~SeenSource() override;

  /// Null if there is no surface with fields yet.
  const std::shared_ptr<const SeenSurface>& seen() const { return seen_; }

  /// True while seen() is of another view or other settings.
  bool isStale() const { return job_.isRunning() || again_; }
  int searches() const { return searches_; }  ///< ended so far

 signals:
  void changed();
  void failed(const QString& reason);

 private:
  struct Worker;
  void follow(const Change& change);
  void surfaceChanged();
  void search();

  const Document& document_;
  const SurfaceSource& source_;
  Job job_;
  std::shared_ptr<Worker> worker_;  ///< of the surface there is, shared with its jobs
  std::shared_ptr<const SeenSurface> seen_;
  bool again_ = false;
  int searches_ = 0;
};

}  // namespace flatland::ui
