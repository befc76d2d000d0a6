// SPDX-License-Identifier: MIT
#include "core3d/lines/line_finder.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include "core3d/lines/families.h"
#include "core3d/lines/sharp_edges.h"
#include "core3d/lines/vertex_clusters.h"

namespace flatland {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// Lines of the mesh alone, before the threshold, with what they were found for.
struct FixedLines {
  bool unfiltered = false;
  double fromThreshold = 0.0;
  int levels = 0;
  Eigen::Vector3d up = Eigen::Vector3d::Zero();
  Segments segments;
};

// Lines at which curvatures of vertices are interpolated: nonsense where the surface is creased.
bool needsCurvature(LineFamily family) {
  return family == LineFamily::Ridges || family == LineFamily::Valleys ||
         family == LineFamily::Parabolic || family == LineFamily::ZeroMeanCurvature;
}

}  // namespace

struct LineFinder::State {
  const TriangleMesh& mesh;
  const SurfaceFields& fields;
  Sheets sheets;
  VertexClusters clusters;
  SharpEdges sharp;
  bool cull;
  std::vector<VertexRun> runs;
  SeenVertices seen, highlights;
  ContrastMemory memory;
  std::array<std::optional<FixedLines>, kLineFamilyCount> fixed;
  Times times;

  State(const TriangleMesh& m, const SurfaceFields& f, bool passOver)
      : mesh(m), fields(f), sheets(m), clusters(m, f, sheets), sharp(m, f), cull(passOver) {}
  void addFixed(LineFamily family, const LineOptions& options, Segments& out);
  Segments findFixed(LineFamily family, const LineOptions& options) const;
  void walk(const SeenMesh& sight, FeatureLines& lines);
  void addSharpEdges(const SeenMesh& sight, FeatureLines& lines) const;
};

LineFinder::LineFinder(const TriangleMesh& mesh, const SurfaceFields& fields, bool cull)
    : state_(new State(mesh, fields, cull)) {}
LineFinder::~LineFinder() = default;
LineFinder::LineFinder(LineFinder&&) noexcept = default;
LineFinder& LineFinder::operator=(LineFinder&&) noexcept = default;

const LineFinder::Times& LineFinder::times() const { return state_->times; }

Segments LineFinder::State::findFixed(LineFamily family, const LineOptions& options) const {
  switch (family) {
    case LineFamily::Ridges:
      return findRidges(mesh, fields, false, options.unfiltered);
    case LineFamily::Valleys:
      return findRidges(mesh, fields, true, options.unfiltered);
    case LineFamily::Parabolic:
      return findParabolic(mesh, fields);
    case LineFamily::ZeroMeanCurvature:
      return findZeroMeanCurvature(mesh, fields);
    case LineFamily::Creases:
      return findCreases(mesh, options.unfiltered ? 0.0 : options.thresholdOf(family));
    case LineFamily::Boundaries:
      return findBoundaries(mesh);
    case LineFamily::SelfIntersections:
      return findSelfIntersections(mesh);
    default:
      return findTopographic(mesh, options.topographicUp, options.topographicLevels);
  }
}

void LineFinder::State::addFixed(LineFamily family, const LineOptions& options, Segments& out) {
  auto& kept = fixed[static_cast<std::size_t>(family)];
  const bool topographic = family == LineFamily::Topographic;
  const bool creases = family == LineFamily::Creases;
  const double from = options.unfiltered ? 0.0 : options.thresholdOf(family);
  if (!kept || kept->unfiltered != options.unfiltered ||
      (topographic &&
       (kept->levels != options.topographicLevels || kept->up != options.topographicUp)) ||
      (creases && kept->fromThreshold > from)) {
    const auto start = Clock::now();
    kept = FixedLines{options.unfiltered, from, options.topographicLevels, options.topographicUp,
                      findFixed(family, options)};
    if (needsCurvature(family) && !options.unfiltered) {
      std::erase_if(kept->segments, [&](const LineSegment& s) { return sharp.splits(s.triangle); });
    }
    times.fixedMs += millisecondsSince(start);
  }
  if (options.unfiltered) {
    out = kept->segments;
    return;
  }
  const auto least = static_cast<float>(options.thresholdOf(family));
  for (const LineSegment& segment : kept->segments) {
    if (!segment.standsOut && !options.flatToo) continue;
    if (std::max(segment.a.strength, segment.b.strength) >= least) out.push_back(segment);
  }
}

// What becomes of lines of curvature at sharp edges. Where creases are drawn they are there
// already.
void LineFinder::State::addSharpEdges(const SeenMesh& sight, FeatureLines& lines) const {
  const LineOptions& options = sight.options;
  if (options[LineFamily::Creases] || options.unfiltered) return;
  const auto wanted = [&options](LineFamily family) {
    return options[family] && options.thresholdOf(family) <= kSharpStrength;
  };
  if (wanted(LineFamily::ApparentRidges))
    addSeenEdges(sight, sharp, lines.of(LineFamily::ApparentRidges));
  for (const auto& [family, convex] :
       {std::pair(LineFamily::Ridges, true), std::pair(LineFamily::Valleys, false)}) {
    if (!wanted(family)) continue;
    const Segments edges = findSharpEdges(mesh, sharp, convex);
    lines.of(family).insert(lines.of(family).end(), edges.begin(), edges.end());
  }
}

// All triangles once. Flags of the corners decide nearly always that there is nothing.
void LineFinder::State::walk(const SeenMesh& sight, FeatureLines& lines) {
  memory.clear();
  const LineOptions& options = sight.options;
  const bool all = options.unfiltered;
  const auto wanted = [&](LineFamily family) -> Segments* {
    return options[family] ? &lines.of(family) : nullptr;
  };
  Segments* const contours =
      options[LineFamily::OccludingContours] || options[LineFamily::ExteriorSilhouette]
          ? &lines.of(LineFamily::OccludingContours)
          : nullptr;
  Segments* const apparent = wanted(LineFamily::ApparentRidges);
  Segments* const suggestive = wanted(LineFamily::SuggestiveContours);
  Segments* const highlight = wanted(LineFamily::SuggestiveHighlights);
  Segments* const isophotes = wanted(LineFamily::Isophotes);
  Segments* const principal = wanted(LineFamily::PrincipalHighlights);

  constexpr unsigned kOctant = VertexFlag::kOctant, kFront = VertexFlag::kFront,
                     kStrong = VertexFlag::kStrong, kRadial = VertexFlag::kRadial,
                     kKnown = VertexFlag::kKnown;
  const unsigned differing = (contours ? kFront : 0u) | (apparent ? kOctant : 0u) |
                             (suggestive || highlight ? kRadial : 0u);
  const std::uint8_t* const flags = seen.flags.data();
  const auto count = static_cast<std::uint32_t>(mesh.triangleCount());
  for (std::uint32_t t = 0; t < count && differing != 0; ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const unsigned some = flags[a] | flags[b] | flags[c], every = flags[a] & flags[b] & flags[c];
    const unsigned differ = (some ^ every) & differing;
    if (differ == 0 || !(every & kKnown)) continue;
    if (sharp.splits(t) && !all) continue;
    if ((differ & kFront) && !sharp.splits(t)) addContour(sight, t, *contours);
    if ((differ & kOctant) &&
        (all || ((some & kStrong) && sight.shows(t, every & kFront, some & kFront))))
      addApparentRidge(sight, t, memory, *apparent);
    if ((differ & kRadial) && (all || (some & kFront) || sheets.has(t)))
      addSuggestive(sight, t, suggestive, highlight);
  }
  if (contours) addSplitContours(sight, sharp, *contours);
  for (std::uint32_t t = 0; t < count && isophotes; ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    if ((flags[a] & flags[b] & flags[c] & kKnown) && !sharp.splits(t))
      addIsophotes(sight, t, *isophotes);
  }
  if (isophotes) addSplitIsophotes(sight, sharp, *isophotes);
  for (std::uint32_t t = 0; t < count && principal; ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const std::uint8_t* const f = highlights.flags.data();
    const unsigned some = f[a] | f[b] | f[c], every = f[a] & f[b] & f[c];
    if ((some ^ every) & kOctant && !((some ^ every) & kRadial) && (every & kKnown) &&
        (all || (sight.shows(t, every & kFront, some & kFront) && !sharp.splits(t))))
      addPrincipalHighlight(sight, highlights, t, *principal);
  }
}

FeatureLines LineFinder::find(const SurfaceView& view, const LineOptions& options) {
  State& s = *state_;
  s.times = {};
  FeatureLines lines;
  const bool oneRing = options.derivative == RidgeDerivative::OneRing;
  VertexNeeds needs;
  needs.ridges = options[LineFamily::ApparentRidges];
  needs.radial =
      options[LineFamily::SuggestiveContours] || options[LineFamily::SuggestiveHighlights];
  needs.facing = options[LineFamily::Isophotes];
  needs.everywhere = !s.cull || options.unfiltered || (needs.ridges && oneRing);
  needs.minRoot =
      options.unfiltered
          ? -1.0f
          : static_cast<float>(options.thresholdOf(LineFamily::ApparentRidges) / s.fields.size);
  const bool ofView = std::any_of(options.on.begin(), options.on.begin() + kViewFamilies,
                                  [](bool on) { return on; });
  const SeenMesh sight{s.mesh, s.fields, view, options, s.seen, s.sheets};
  if (ofView) {
    auto start = Clock::now();
    s.seen.resize(s.mesh.vertexCount(), needs);
    s.clusters.runsFor(view, needs, s.runs);
    seeVertices(s.mesh, s.fields, view, needs.minRoot, s.runs, s.seen);
    if (needs.ridges && oneRing) takeOneRingDerivative(s.mesh, s.fields, s.seen);
    if (options[LineFamily::PrincipalHighlights])
      seeHighlights(s.mesh, s.fields, view, s.highlights);
    s.times.vertexMs = millisecondsSince(start);
    start = Clock::now();
    s.walk(sight, lines);
    s.times.segmentMs = millisecondsSince(start);
  }
  for (const LineFamily family : allLineFamilies()) {
    if (!dependsOnView(family) && options[family]) s.addFixed(family, options, lines.of(family));
  }
  s.addSharpEdges(sight, lines);
  if (options[LineFamily::ExteriorSilhouette]) {
    lines.of(LineFamily::ExteriorSilhouette) = lines.of(LineFamily::OccludingContours);
    if (!options[LineFamily::OccludingContours]) lines.of(LineFamily::OccludingContours).clear();
  }
  return lines;
}

}  // namespace flatland
