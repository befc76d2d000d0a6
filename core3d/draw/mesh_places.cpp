// SPDX-License-Identifier: MIT
#include "core3d/draw/mesh_places.h"

#include <embree3/rtcore.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>

#include "core3d/draw/embree_error.h"

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace flatland {
namespace {

using Eigen::Vector3d;

// Coordinates of a mesh lie in [-1, 1]: what is so far from 0 is outside.
constexpr double kOutside = 2.0;
// Embree looks for boxes by floats; a few of their last places, so that no triangle is missed.
constexpr double kFloatRounding = 1e-6;

struct DeviceCloser {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct SceneCloser {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};

/// Weights of the corners at the foot of the perpendicular; nullopt if it is not within the
/// triangle, or this has no area.
std::optional<std::array<double, 3>> footWithin(const std::array<Vector3d, 3>& corners,
                                                const Vector3d& p) {
  const Vector3d a = corners[1] - corners[0], b = corners[2] - corners[0], c = p - corners[0];
  const double aa = a.dot(a), ab = a.dot(b), bb = b.dot(b), ac = a.dot(c), bc = b.dot(c);
  const double det = aa * bb - ab * ab;
  if (!(det > 0.0)) return std::nullopt;
  const double u = (bb * ac - ab * bc) / det, v = (aa * bc - ab * ac) / det;
  if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0)) return std::nullopt;
  return std::array<double, 3>{1.0 - u - v, u, v};
}

/// Weights at the nearest place of the side that is opposite to a corner.
std::array<double, 3> onSide(const std::array<Vector3d, 3>& corners, std::size_t opposite,
                             const Vector3d& p) {
  const std::size_t i = (opposite + 1) % 3, j = (opposite + 2) % 3;
  const Vector3d side = corners[j] - corners[i];
  const double squared = side.squaredNorm();
  const double share =
      squared > 0.0 ? std::clamp(side.dot(p - corners[i]) / squared, 0.0, 1.0) : 0.0;
  std::array<double, 3> weights{};
  weights[i] = 1.0 - share;
  weights[j] = share;
  return weights;
}

/// Weights of the corners where a line goes through the triangle, if it does.
std::optional<std::array<double, 3>> crossing(const std::array<Vector3d, 3>& corners,
                                              const Vector3d& from, const Vector3d& along) {
  // from + s along = a + u ab + v ac, by Cramer's rule.
  const Vector3d ab = corners[1] - corners[0], ac = corners[2] - corners[0];
  const Vector3d across = along.cross(ac), away = from - corners[0];
  const double volume = ab.dot(across);
  if (volume == 0.0) return std::nullopt;
  const double u = away.dot(across) / volume, v = along.dot(away.cross(ab)) / volume;
  if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0)) return std::nullopt;
  return std::array<double, 3>{1.0 - u - v, u, v};
}

std::array<Vector3d, 3> cornersOf(const TriangleMesh& mesh, std::uint32_t triangle) {
  std::array<Vector3d, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] = mesh.position(mesh.triangles[triangle][k]).cast<double>();
  }
  return corners;
}

Vector3d placeAt(const std::array<Vector3d, 3>& corners, const std::array<double, 3>& weights) {
  return weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
}

/// What a search for the nearest place has found so far.
struct Search {
  const TriangleMesh* mesh;
  Vector3d p;
  std::optional<SurfaceHit> nearest;
  double leastSq = std::numeric_limits<double>::infinity();
};

bool considerTriangle(RTCPointQueryFunctionArguments* arguments) {
  Search& search = *static_cast<Search*>(arguments->userPtr);
  const SurfaceHit place = nearestInTriangle(*search.mesh, arguments->primID, search.p);
  const double distanceSq = (place.at - search.p).squaredNorm();
  if (!(distanceSq <= search.leastSq)) return false;
  // Triangles come in any order.
  if (distanceSq == search.leastSq && place.triangle > search.nearest->triangle) return false;
  search.leastSq = distanceSq;
  search.nearest = place;
  const double slack = kFloatRounding * (1.0 + search.p.norm());
  arguments->query->radius = static_cast<float>(std::sqrt(distanceSq) + slack);
  return true;
}

}  // namespace

struct MeshPlaces::State {
  const TriangleMesh* mesh;
  std::unique_ptr<RTCDeviceTy, DeviceCloser> device;
  std::unique_ptr<RTCSceneTy, SceneCloser> scene;
};

MeshPlaces::MeshPlaces(const TriangleMesh& mesh) : state_(std::make_unique<State>()) {
  state_->mesh = &mesh;
  state_->device.reset(rtcNewDevice(nullptr));
  if (!state_->device) {
    throwIfFailed(rtcGetDeviceError(nullptr));
    throw std::runtime_error("Embree, which casts rays, does not start");
  }
  const RTCDevice device = state_->device.get();
  state_->scene.reset(rtcNewScene(device));
  const RTCScene scene = state_->scene.get();
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
  if (mesh.triangleCount() != 0) {
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), mesh.vertexCount()));
    if (positions == nullptr) {
      rtcReleaseGeometry(geometry);
      throwIfFailed(rtcGetDeviceError(device));
      throw std::bad_alloc();
    }
    for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
      positions[3 * v] = mesh.x[v];
      positions[3 * v + 1] = mesh.y[v];
      positions[3 * v + 2] = mesh.z[v];
    }
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               mesh.triangles.data(), 0, sizeof(mesh.triangles[0]),
                               mesh.triangleCount());
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(scene);
  throwIfFailed(rtcGetDeviceError(device));
}

MeshPlaces::~MeshPlaces() = default;
MeshPlaces::MeshPlaces(MeshPlaces&&) noexcept = default;
MeshPlaces& MeshPlaces::operator=(MeshPlaces&&) noexcept = default;

const TriangleMesh& MeshPlaces::mesh() const { return *state_->mesh; }
RTCSceneTy* MeshPlaces::scene() const { return state_->scene.get(); }

std::optional<SurfaceHit> MeshPlaces::firstHit(const Vector3d& from, const Vector3d& along,
                                               bool wholeLine) const {
  const FlushDenormals flush;
  // From just outside of the mesh: floats are coarser far away.
  const double ahead = -from.dot(along) - kOutside;
  const Vector3d origin = from + (wholeLine ? ahead : std::max(ahead, 0.0)) * along;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit ray{};
  ray.ray.org_x = static_cast<float>(origin.x());
  ray.ray.org_y = static_cast<float>(origin.y());
  ray.ray.org_z = static_cast<float>(origin.z());
  ray.ray.dir_x = static_cast<float>(along.x());
  ray.ray.dir_y = static_cast<float>(along.y());
  ray.ray.dir_z = static_cast<float>(along.z());
  ray.ray.tfar = std::numeric_limits<float>::infinity();
  ray.ray.mask = 0xffffffff;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(state_->scene.get(), &context, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const std::array<Vector3d, 3> corners = cornersOf(*state_->mesh, ray.hit.primID);
  if (const auto weights = crossing(corners, from, along)) {
    return SurfaceHit{ray.hit.primID, *weights, placeAt(corners, *weights)};
  }
  // Past the rim by a rounding.
  const double u = std::clamp(static_cast<double>(ray.hit.u), 0.0, 1.0);
  const double v = std::clamp(static_cast<double>(ray.hit.v), 0.0, 1.0 - u);
  const std::array<double, 3> weights{1.0 - u - v, u, v};
  return SurfaceHit{ray.hit.primID, weights, placeAt(corners, weights)};
}

std::optional<SurfaceHit> MeshPlaces::nearest(const Vector3d& p) const {
  const FlushDenormals flush;
  Search search{state_->mesh, p, {}};
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  RTCPointQuery query{};
  query.x = static_cast<float>(p.x());
  query.y = static_cast<float>(p.y());
  query.z = static_cast<float>(p.z());
  query.radius = std::numeric_limits<float>::infinity();
  rtcPointQuery(state_->scene.get(), &query, &context, considerTriangle, &search);
  return search.nearest;
}

SurfaceHit nearestInTriangle(const TriangleMesh& mesh, std::uint32_t triangle, const Vector3d& p) {
  const std::array<Vector3d, 3> corners = cornersOf(mesh, triangle);
  if (const auto foot = footWithin(corners, p)) return {triangle, *foot, placeAt(corners, *foot)};
  SurfaceHit nearest{};
  double leastSq = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const std::array<double, 3> weights = onSide(corners, k, p);
    const Vector3d at = placeAt(corners, weights);
    const double distanceSq = (at - p).squaredNorm();
    if (!(distanceSq < leastSq)) continue;
    leastSq = distanceSq;
    nearest = {triangle, weights, at};
  }
  return nearest;
}

#if defined(__SSE__)
FlushDenormals::FlushDenormals() : before_(_mm_getcsr()) {
  constexpr unsigned kFlushToZero = 0x8000, kDenormalsAreZero = 0x0040;
  _mm_setcsr(before_ | kFlushToZero | kDenormalsAreZero);
}
FlushDenormals::~FlushDenormals() { _mm_setcsr(before_); }
#else
FlushDenormals::FlushDenormals() = default;
FlushDenormals::~FlushDenormals() = default;
#endif

}  // namespace flatland
