// SPDX-License-Identifier: MIT
#include "core3d/draw/sight.h"

#include <embree3/rtcore.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core3d/mesh/crease_angles.h"
#include "core3d/mesh/pieces.h"
#include "core3d/mesh/triangle_cross.h"

namespace flatland {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

// Shares of the mesh's size (2): below a tenth of a pixel of a large picture, and far above the
// rounding of a ray that grazes. See Sight.
constexpr float kTouching = 2e-4f;
constexpr float kTouchingNeighbour = 2e-3f;
const float kFoldCosine = static_cast<float>(cosineOfDeg(kFoldDeg));
// The smooth surface counts as facing away below this n.w: the interpolated normal of a contour
// point is only nearly across the view.
constexpr double kFacingAway = -0.1;
// Where the normals of the vertices turn from the triangle's by more, they are means over a crease.
const double kCreasedCosine = cosineOfDeg(kCreaseDeg);
// One plus the cosine between the normals of two sheets. Down to it, which is at 151 degrees, a
// place as far from both is at most four times as far from the line where they meet.
constexpr double kLeastOpening = 0.125;
// Of the offset: half a px is what a dense mesh's roughness is allowed, but where both triangles
// are known on whose outside a line lies it may be exact.
constexpr double kShareOffBoth = 0.2;
// Far outside of every mesh, whose coordinates lie in [-1, 1].
constexpr double kFarOutside = 8.0;

bool shareVertex(const TriangleMesh& mesh, std::uint32_t s, std::uint32_t t) {
  for (const std::uint32_t v : mesh.triangles[s]) {
    for (const std::uint32_t w : mesh.triangles[t]) {
      if (v == w) return true;
    }
  }
  return false;
}

// Of so many triangles round one vertex normals are looked at that stand for all of them, no more
// than a few degrees off: messy meshes have fans of thousands, and rays pass hundreds of them.
constexpr std::uint32_t kLargeFan = 64;

// Which triangles lead smoothly to one another.
class Folds {
 public:
  explicit Folds(const TriangleMesh& mesh) : mesh_(mesh), normals_(mesh.triangleCount()) {
    for (std::uint32_t t = 0; t < normals_.size(); ++t) {
      normals_[t] = crossOf(mesh, t).stableNormalized().cast<float>();
    }
    for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
      if (fanOf(v).size() > kLargeFan) addLargeFan(v);
    }
  }

  // True if a triangle that touches both (it may be one of them) leads from one to the other
  // without being bent like an edge against either. In large fans it has to touch both at the same
  // vertex, or one of them at a vertex with a smaller fan.
  bool areOne(std::uint32_t s, std::uint32_t t) const {
    return leadsOver(s, t) || (!largeFans_.empty() && (leadsOver(t, s) || leadsOverLarge(s, t)));
  }

 private:
  std::span<const std::uint32_t> fanOf(std::uint32_t v) const {
    return std::span(mesh_.cornersAt)
        .subspan(mesh_.cornerStart[v], mesh_.cornerStart[v + 1] - mesh_.cornerStart[v]);
  }

  bool bentLess(std::uint32_t s, std::uint32_t t) const {
    return normals_[s].dot(normals_[t]) > kFoldCosine;
  }

  bool leadsOver(std::uint32_t s, std::uint32_t t) const {
    for (const std::uint32_t v : mesh_.triangles[t]) {
      const auto fan = fanOf(v);
      if (fan.size() > kLargeFan) continue;
      for (const std::uint32_t corner : fan) {
        const std::uint32_t between = corner / 3;
        if (bentLess(t, between) && bentLess(between, s) && shareVertex(mesh_, s, between))
          return true;
      }
    }
    return false;
  }

  bool leadsOverLarge(std::uint32_t s, std::uint32_t t) const {
    for (const std::uint32_t v : mesh_.triangles[t]) {
      const auto& other = mesh_.triangles[s];
      const auto fan = std::find(other.begin(), other.end(), v) == other.end() ? largeFans_.end()
                                                                               : largeFans_.find(v);
      if (fan == largeFans_.end()) continue;
      if (bentLess(s, t)) return true;
      for (const Vector3f& between : fan->second) {
        if (normals_[s].dot(between) > kFoldCosine && normals_[t].dot(between) > kFoldCosine)
          return true;
      }
    }
    return false;
  }

  // Of the normals that point through the same cell of a cube the first stands for the others.
  void addLargeFan(std::uint32_t v) {
    constexpr float kCells = 8.0f;  // along an edge
    std::set<std::array<int, 3>> taken;
    for (const std::uint32_t corner : fanOf(v)) {
      const Vector3f& n = normals_[corner / 3];
      const float most = n.cwiseAbs().maxCoeff();
      if (!(most > 0.0f)) continue;
      const Eigen::Array3i cell = ((n.array() / most + 1.0f) * (kCells / 2.0f)).floor().cast<int>();
      if (taken.insert({cell.x(), cell.y(), cell.z()}).second) largeFans_[v].push_back(n);
    }
  }

  const TriangleMesh& mesh_;
  std::vector<Vector3f> normals_;  // of the triangles, unit or 0
  std::unordered_map<std::uint32_t, std::vector<Vector3f>> largeFans_;  // by vertex
};

// The place on the viewer's side of both triangles, `offset` from each. Where they meet so sharply
// that this is far off, nearer.
Vector3d outsideBoth(const TriangleMesh& mesh, const SightPoint& point, const Vector3d& w,
                     double offset) {
  const auto towards = [&](std::uint32_t t) {
    const Vector3d flat = crossOf(mesh, t).stableNormalized();
    return Vector3d(flat.dot(w) < 0.0 ? -flat : flat);
  };
  const Vector3d a = towards(point.triangle), b = towards(point.other);
  return point.at + offset / std::max(1.0 + a.dot(b), kLeastOpening) * (a + b);
}

// A ray with what its filter has to know.
struct Context {
  RTCIntersectContext embree;
  const TriangleMesh* mesh;
  const Folds* folds;
  std::uint32_t own, other;  // kNone: no other
  float touchingNeighbour;   // a hit on a neighbour does not count below this distance ...
  float foldReach;           // ... or this one, if the neighbour belongs to the same fold
};

void ignoreOwn(const RTCFilterFunctionNArguments* arguments) {
  const auto& context = *reinterpret_cast<const Context*>(arguments->context);
  const auto hit = rtcGetHitFromHitN(arguments->hit, arguments->N, 0);
  const float distance = RTCRayN_tfar(arguments->ray, arguments->N, 0);
  const std::uint32_t t = hit.primID;
  bool ignored = t == context.own || t == context.other;
  if (!ignored && distance < context.touchingNeighbour) {
    ignored =
        shareVertex(*context.mesh, t, context.own) ||
        (context.other != TriangleMesh::kNone && shareVertex(*context.mesh, t, context.other));
  }
  if (!ignored && distance < context.foldReach) {
    ignored = context.folds->areOne(context.own, t);
  }
  if (ignored) arguments->valid[0] = 0;
}

}  // namespace

struct Sight::State {
  const TriangleMesh* mesh;
  const SurfaceFields* fields;
  Folds folds;
  Sheets sheets;
  std::optional<MeshPlaces> own;  // unless it is lent
  RTCScene scene;

  // True if the viewer sees the side that the normal at a point does not point to: see outwardAt.
  bool isBack(const SightPoint& point, const Vector3d& normal, const SurfaceView& view) const {
    if (!sheets.has(point.triangle) || fields->vertexCount() == 0) return false;
    const Vector3d towards = view.towardsViewer(point.at);
    if (!point.contour) return normal.dot(towards) < 0.0;
    const Eigen::Vector3f w = towards.cast<float>();
    float bending = 0.0f;  // K(w_T, w_T)
    for (const std::uint32_t v : mesh->triangles[point.triangle]) {
      const float w1 = fields->e1(v).dot(w), w2 = fields->e2(v).dot(w);
      bending += fields->k1[v] * w1 * w1 + fields->k2[v] * w2 * w2;
    }
    return bending < 0.0f;
  }

  // True if a counting hit lies on the ray between near and far.
  bool hits(const Vector3d& origin, const Vector3d& direction, float near, float far,
            Context& context) const {
    rtcInitIntersectContext(&context.embree);
    context.embree.filter = ignoreOwn;
    RTCRay ray{};
    const Eigen::Vector3f o = origin.cast<float>(), d = direction.cast<float>();
    ray.org_x = o.x();
    ray.org_y = o.y();
    ray.org_z = o.z();
    ray.dir_x = d.x();
    ray.dir_y = d.y();
    ray.dir_z = d.z();
    ray.tnear = near;
    ray.tfar = far;
    ray.mask = 0xffffffff;
    rtcOccluded1(scene, &context.embree, &ray);
    return ray.tfar < 0.0f;
  }
};

Sight::Sight(const TriangleMesh& mesh, const SurfaceFields& fields)
    : state_(new State{&mesh, &fields, Folds(mesh), Sheets(mesh), MeshPlaces(mesh), {}}) {
  state_->scene = state_->own->scene();
}

Sight::Sight(const MeshPlaces& places, const SurfaceFields& fields)
    : state_(new State{&places.mesh(),
                       &fields,
                       Folds(places.mesh()),
                       Sheets(places.mesh()),
                       {},
                       places.scene()}) {}

Sight::~Sight() = default;
Sight::Sight(Sight&&) noexcept = default;
Sight& Sight::operator=(Sight&&) noexcept = default;

Vector3d Sight::normalAt(const SightPoint& point) const {
  const TriangleMesh& mesh = *state_->mesh;
  const SurfaceFields& fields = *state_->fields;
  const auto& corners = mesh.triangles[point.triangle];
  const Vector3d across = crossOf(mesh, point.triangle);
  Vector3d normal = Vector3d::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    // The weight of a corner: the area of the triangle that the point forms with the other two.
    const Vector3d p = mesh.position(corners[(k + 1) % 3]).cast<double>() - point.at;
    const Vector3d q = mesh.position(corners[(k + 2) % 3]).cast<double>() - point.at;
    const double weight = std::max(p.cross(q).dot(across), 0.0);
    if (fields.vertexCount() != 0) normal += weight * fields.normal(corners[k]).cast<double>();
  }
  if (!(normal.norm() > 0.0)) normal = across;
  return normal.stableNormalized();
}

Vector3d Sight::outwardAt(const SightPoint& point, const SurfaceView& view) const {
  const Vector3d normal = normalAt(point);
  return state_->isBack(point, normal, view) ? Vector3d(-normal) : normal;
}

Vector3d Sight::middleOf(std::uint32_t triangle) const {
  const auto& [a, b, c] = state_->mesh->triangles[triangle];
  const TriangleMesh& mesh = *state_->mesh;
  return ((mesh.position(a) + mesh.position(b) + mesh.position(c)) / 3.0f).cast<double>();
}

bool Sight::hidden(const SightPoint& point, const SurfaceView& view, double offset) const {
  const TriangleMesh& mesh = *state_->mesh;
  const Vector3d w = view.towardsViewer(point.at);
  if (point.interpolated && point.other != TriangleMesh::kNone) {
    // Facets of a coarse mesh stick out over such edges as over the rest of the line.
    const double first = crossOf(mesh, point.triangle).stableNormalized().dot(w),
                 second = crossOf(mesh, point.other).stableNormalized().dot(w);
    const std::uint32_t front = first >= second ? point.triangle : point.other;
    const SightPoint smooth{point.at, front, true, TriangleMesh::kNone, point.contour};
    if (std::max(first, second) > 0.0 && !hidden(smooth, view, offset)) return false;
  }
  Context context{};
  context.mesh = &mesh;
  context.folds = &state_->folds;
  context.own = point.triangle;
  context.other = point.other;
  context.touchingNeighbour = kTouchingNeighbour;
  Vector3d origin;
  if (point.other != TriangleMesh::kNone) {
    origin = outsideBoth(mesh, point, w, kShareOffBoth * offset);
  } else {
    Vector3d normal = normalAt(point);
    const double side = state_->isBack(point, normal, view) ? -1.0 : 1.0;
    normal *= side;
    const Vector3d cross = crossOf(mesh, point.triangle), flat = side * cross.stableNormalized();
    if (normal.dot(flat) < kCreasedCosine && flat.dot(w) > 0.0) normal = flat;
    const double facing = normal.dot(w);
    const bool fold = point.interpolated && facing > kFacingAway;
    // What faces away but is no fold lies on the back of a sheet: the viewer's side is the other.
    const bool otherSide = !fold && facing < 0.0;
    origin = point.at + (otherSide ? -offset : offset) * normal;
    if (fold) context.foldReach = static_cast<float>(2.0 * std::sqrt(cross.norm()));
  }
  const auto far =
      static_cast<float>(view.distanceTo(origin).value_or(std::numeric_limits<double>::infinity()));
  return state_->hits(origin, view.towardsViewer(origin), kTouching, far, context);
}

bool Sight::empty(const SightPoint& point, const Vector3d& beside, const SurfaceView& view) const {
  const Vector3d direction = -view.towardsViewer(beside);
  const Vector3d origin = view.eye ? *view.eye : Vector3d(beside - kFarOutside * direction);
  Context context{};
  context.mesh = state_->mesh;
  context.folds = &state_->folds;
  context.own = point.triangle;
  context.other = point.other;
  context.foldReach = std::numeric_limits<float>::infinity();
  return !state_->hits(origin, direction, 0.0f, std::numeric_limits<float>::infinity(), context);
}

}  // namespace flatland
