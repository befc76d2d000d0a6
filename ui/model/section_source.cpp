// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/section_source.h"

#include <algorithm>
#include <cmath>

#include "core3d/study/line_distances.h"
#include "ui/model/cutting_plane.h"

namespace flatland::ui {

namespace {

/// How far before a place, in coordinates of the mesh, a surface hides it: marks lie on the fitted
/// curve, near the surface and not in it.
constexpr double kBefore = 0.01;

/// Of the mean edge: a curve that follows the facets has a mark on each of them.
constexpr double kFacetShare = 0.1;

/// Of the fit, in the unit of the file; a share of 0 is one that suits the mesh.
double toleranceFor(const TriangleMesh& mesh, double share) {
  const double longest = 2.0 * mesh.unit;
  if (share > 0.0) return share * longest;
  return std::max(SectionSource::kUsualTolerance * longest, kFacetShare * meanEdge(mesh));
}

std::vector<LineVertex> linesOf(const Slice& slice, const TriangleMesh& mesh) {
  std::vector<LineVertex> lines;
  const auto add = [&](const Eigen::Vector3d& inFile) {
    const Eigen::Vector3f p = ((inFile - mesh.origin) / mesh.unit).cast<float>();
    lines.push_back({p.x(), p.y(), p.z(), 1.0f});
  };
  for (const SliceLine& line : slice.lines) {
    const std::size_t count = line.points.size();
    for (std::size_t i = 0; i + (line.closed ? 0 : 1) < count; ++i) {
      add(line.points[i].at);
      add(line.points[(i + 1) % count].at);
    }
  }
  return lines;
}

std::vector<SectionPair> pairsOf(const SectionMarks& marks, const LoadedSurface& surface) {
  std::vector<SectionPair> pairs;
  std::vector<bool> met(marks.marks.size(), false);
  for (std::size_t i = 0; i < marks.ridges.size(); ++i) {
    const CrossedRidge& ridge = marks.ridges[i];
    SectionPair pair{i, {}, ridge.toMark, ridge.offPlaneDeg, ridge.strength};
    double least = 0.0;
    for (std::size_t k = 0; k < marks.marks.size(); ++k) {
      if (marks.marks[k].mark.kind != MarkKind::ApparentRidge) continue;
      const double distance = (marks.marks[k].mark.point - ridge.inPlane).norm();
      if (pair.mark && distance >= least) continue;
      pair.mark = k;
      least = distance;
    }
    if (pair.mark) {
      met[*pair.mark] = true;
      pair.strength = std::max(pair.strength, strengthOf(marks.marks[*pair.mark], surface));
    }
    pairs.push_back(pair);
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const SectionPair& a, const SectionPair& b) {
    return a.distance && (!b.distance || *a.distance < *b.distance);
  });
  for (std::size_t k = 0; k < marks.marks.size(); ++k) {
    if (met[k] || marks.marks[k].mark.kind != MarkKind::ApparentRidge) continue;
    const SectionMark& mark = marks.marks[k];
    pairs.push_back({{}, k, {}, mark.offPlaneDeg, strengthOf(mark, surface)});
  }
  return pairs;
}

void addMarks(SectionView& view) {
  const LoadedSurface& surface = *view.surface;
  const SurfaceView& from = view.seen->view;
  const PlaneView flat = planeViewOf(view.section.plane, from);
  if (!flat.view) {
    view.whyNoMarks = flat.whyNot;
    return;
  }
  view.marks = compareSection(view.section, *surface.mesh, *surface.fields, from,
                              view.seen->compared.get()->of(LineFamily::ApparentRidges));
  for (const SectionMark& mark : view.marks.marks) {
    view.seenMarks.push_back(isSeen(surface, from, mark.at));
  }
  for (const CrossedRidge& ridge : view.marks.ridges) {
    view.seenRidges.push_back(isSeen(surface, from, ridge.at));
  }
  view.pairs = pairsOf(view.marks, surface);
}

/// The section of `view`, or that of `last` where it is the same but for the view.
void cut(SectionView& view, const std::shared_ptr<const SectionView>& last, const View& flat) {
  const TriangleMesh& mesh = *view.surface->mesh;
  const bool same = last && last->surface->mesh == view.surface->mesh &&
                    last->plane == view.plane && last->tolerance == view.tolerance;
  if (same) {
    view.section = last->section;
    view.lines = last->lines;
  } else {
    view.section = sectionOf(mesh, cutPlaneOf(view.plane, mesh), view.tolerance);
    view.lines = linesOf(view.section.slice, mesh);
  }
  setView(view.section, flat);
}

}  // namespace

double strengthOf(const SectionMark& mark, const LoadedSurface& surface) {
  if (!mark.mark.lambda || !surface.fields) return 0.0;
  return std::sqrt(*mark.mark.lambda) * surface.mesh->unit * surface.fields->size;
}

bool isSeen(const LoadedSurface& surface, const SurfaceView& view, const Eigen::Vector3d& inFile) {
  const TriangleMesh& mesh = *surface.mesh;
  const Eigen::Vector3d at = (inFile - mesh.origin) / mesh.unit;
  const Eigen::Vector3d w = view.towardsViewer(at);
  return !surface.places->firstHit(at + kBefore * w, w, false);
}

SectionSource::SectionSource(const Document& document, const SurfaceSource& source,
                             const SeenSource& seen, QObject* parent)
    : QObject(parent), document_(document), source_(source), seen_(seen), job_([this] {
        cutNewest();
      }) {
  connect(&document_, &Document::changed, this, &SectionSource::follow);
  connect(&source_, &SurfaceSource::changed, this, &SectionSource::update);
  connect(&seen_, &SeenSource::changed, this, &SectionSource::update);
  connect(&job_, &LatestJob::failed, this, &SectionSource::failed);
}

void SectionSource::setTolerance(double share) {
  if (share == tolerance_) return;
  tolerance_ = share;
  update();
}

void SectionSource::choose(const std::optional<std::size_t>& pair) {
  if (pair == chosen_) return;
  chosen_ = pair;
  emit chosenChanged();
}

void SectionSource::follow(const Change& change) {
  if (change.touchesSurface()) update();
}

void SectionSource::update() {
  const std::optional<SurfaceSetting>& setting = document_.scene().surface;
  if (!setting || !setting->plane || !source_.surface()) {
    job_.cancel();
    if (!view_) return;
    view_.reset();
    chosen_.reset();
    emit changed();
    return;
  }
  job_.wish();
}

void SectionSource::cutNewest() {
  const std::shared_ptr<const LoadedSurface>& surface = source_.surface();
  // Lines of another surface tell nothing of this one.
  const bool ofThis = seen_.seen() && seen_.seen()->surface == surface;
  SectionView next{surface,
                   *document_.scene().surface->plane,
                   toleranceFor(*surface->mesh, tolerance_),
                   {},
                   {},
                   ofThis ? seen_.seen() : nullptr,
                   {},
                   {},
                   {},
                   {},
                   {}};
  using Data = std::shared_ptr<const SectionView>;
  job_.start<Data>(
      [next = std::move(next), last = view_](const JobControl&) -> std::optional<Data> {
        SectionView view = next;
        const CutPlane plane = cutPlaneOf(view.plane, *view.surface->mesh);
        const SurfaceView from = view.seen ? view.seen->view : SurfaceView{};
        cut(view, last,
            planeViewOf(plane, from).view.value_or(View{.angleDeg = 90.0, .distance = {}}));
        if (view.seen) addMarks(view);
        return std::make_shared<const SectionView>(std::move(view));
      },
      [this](const Data& view) {
        view_ = view;
        chosen_.reset();
        emit changed();
      });
}

bool SectionSource::isInFlatland() const {
  if (!view_) return false;
  const std::vector<SceneCurve>& mine = view_->section.scene.curves;
  const std::vector<SceneCurve>& theirs = document_.scene().curves;
  return !mine.empty() &&
         std::equal(mine.begin(), mine.end(), theirs.begin(), theirs.end(),
                    [](const SceneCurve& a, const SceneCurve& b) { return a.shape == b.shape; });
}

}  // namespace flatland::ui
