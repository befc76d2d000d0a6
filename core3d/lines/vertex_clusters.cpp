// SPDX-License-Identifier: MIT
#include "core3d/lines/vertex_clusters.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core3d/run_on_threads.h"

namespace flatland {

VertexClusters::VertexClusters(const TriangleMesh& mesh, const SurfaceFields& fields,
                               const Sheets& sheets)
    : vertices_(static_cast<std::uint32_t>(mesh.vertexCount())) {
  // The rest of the division goes to the last one, so that none is shorter than a SIMD vector.
  clusters_.resize(std::max(vertices_ / kSize, 1u));
  // Each thread takes the next few clusters; which one does decides nothing.
  constexpr std::uint32_t kBlock = 64;
  const auto count = static_cast<std::uint32_t>(clusters_.size());
  const std::uint32_t blocks = (count + kBlock - 1) / kBlock;
  std::atomic<std::uint32_t> next{0};
  runOnThreads(std::min<std::size_t>(threadsFor(0), blocks), [&] {
    std::vector<std::uint32_t> around;
    for (std::uint32_t block; (block = next++) < blocks;) {
      for (std::uint32_t c = block * kBlock; c < std::min(count, (block + 1) * kBlock); ++c)
        clusters_[c] = clusterOf(mesh, fields, sheets, c, around);
    }
  });
}

VertexClusters::Cluster VertexClusters::clusterOf(const TriangleMesh& mesh,
                                                  const SurfaceFields& fields, const Sheets& sheets,
                                                  std::uint32_t c,
                                                  std::vector<std::uint32_t>& around) const {
  const std::uint32_t begin = c * kSize,
                      end = c + 1 == clusters_.size() ? vertices_ : begin + kSize;
  around.clear();
  Cluster cluster;
  cluster.sheet = false;
  for (std::uint32_t v = begin; v < end; ++v) {
    for (std::uint32_t i = mesh.cornerStart[v]; i < mesh.cornerStart[v + 1]; ++i) {
      const std::uint32_t corner = mesh.cornersAt[i];
      cluster.sheet = cluster.sheet || sheets.has(corner / 3);
      for (const std::uint32_t u : mesh.triangles[corner / 3]) around.push_back(u);
    }
  }
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());

  Eigen::Vector3f axis = Eigen::Vector3f::Zero(), low = mesh.position(around[0]), high = low;
  bool known = true;
  cluster.k1Max = fields.k1[around[0]];
  cluster.k2Min = fields.k2[around[0]];
  for (const std::uint32_t v : around) {
    const Eigen::Vector3f n = fields.normal(v);
    known = known && n.squaredNorm() > kKnownNormalSq && std::isfinite(fields.k1[v] + fields.k2[v]);
    axis += n;
    low = low.cwiseMin(mesh.position(v));
    high = high.cwiseMax(mesh.position(v));
    cluster.k1Max = std::max(cluster.k1Max, fields.k1[v]);
    cluster.k2Min = std::min(cluster.k2Min, fields.k2[v]);
  }
  cluster.centre = 0.5f * (low + high);
  cluster.radius = 0.5f * (high - low).norm();
  cluster.axis = axis.norm() > 0.0f ? Eigen::Vector3f(axis.normalized()) : axis;
  float least = 1.0f;
  for (const std::uint32_t v : around) least = std::min(least, cluster.axis.dot(fields.normal(v)));
  cluster.cosCone = known ? least : -1.0f;
  cluster.sinCone = std::sqrt(std::max(0.0f, 1.0f - least * least));
  return cluster;
}

void VertexClusters::runsFor(const SurfaceView& view, const VertexNeeds& needs,
                             std::vector<VertexRun>& runs) const {
  // For the rounding of the cones and of n.w.
  constexpr float kMargin = 1e-4f;
  // So far below the bound that a walk down from a maximum (contrast.h), once it meets a vertex
  // passed over, has fallen far enough.
  constexpr float kClear = 0.95f;
  runs.clear();
  const auto clusters = static_cast<std::uint32_t>(clusters_.size());
  for (std::uint32_t c = 0; c < clusters; ++c) {
    const Cluster& cluster = clusters_[c];
    const std::uint32_t end = c + 1 == clusters ? vertices_ : (c + 1) * kSize;
    float cosCone = cluster.cosCone, sinCone = cluster.sinCone;
    Eigen::Vector3f w = view.towards.cast<float>();
    bool known = cosCone > 0.0f && !needs.everywhere;
    if (view.eye) {
      w = view.eye->cast<float>() - cluster.centre;
      const float distance = w.norm();
      // Directions to the viewer differ by up to asin(radius / distance) from that of the centre.
      const float sine = distance > 0.0f ? cluster.radius / distance : 2.0f;
      known = known && sine < 0.9f;
      if (known) {
        w /= distance;
        const float cosine = std::sqrt(1.0f - sine * sine);
        const float turned = cosCone * cosine - sinCone * sine;
        sinCone = sinCone * cosine + cosCone * sine;
        cosCone = turned;
        known = cosCone > 0.0f;
      }
    }
    VertexRun run{c * kSize, end, true, needs.ridges, needs.radial};
    if (known) {
      const float cosine = cluster.axis.dot(w);
      const float sine = std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
      const float most = cosine >= cosCone ? 1.0f : cosine * cosCone + sine * sinCone;
      const float least = cosine <= -cosCone ? -1.0f : cosine * cosCone - sine * sinCone;
      const float kMost = std::max(cluster.k1Max, -cluster.k2Min);
      const bool away = most<-kMargin, towards = least> kMargin;
      const bool unseen = away && !cluster.sheet;
      run.nw = needs.facing || !(away || towards);
      // lambda <= max(|k1|, |k2|)^2 / nw^2.
      const float facing = towards ? least : away ? -most : 0.0f;
      run.ridges = needs.ridges && !unseen &&
                   !((towards || away) && kMost < kClear * needs.minRoot * (facing - kMargin));
      run.radial = needs.radial && !unseen && cluster.k1Max >= 0.0f && cluster.k2Min <= 0.0f;
      run.flags = VertexFlag::kKnown | VertexFlag::kSkipped;
      if (towards) run.flags |= VertexFlag::kFront;
      if (needs.radial && cluster.k2Min > 0.0f) run.flags |= VertexFlag::kRadial;
    }
    if (!runs.empty()) {
      VertexRun& last = runs.back();
      // Where something is computed, the run's flags count for the sign of radial curvature, and
      // only where that is not computed too.
      const unsigned counting = run.radial             ? 0u
                                : run.nw || run.ridges ? VertexFlag::kRadial
                                                       : 0xffu;
      if (last.nw == run.nw && last.ridges == run.ridges && last.radial == run.radial &&
          ((last.flags ^ run.flags) & counting) == 0) {
        last.end = end;
        continue;
      }
    }
    runs.push_back(run);
  }
}

}  // namespace flatland
