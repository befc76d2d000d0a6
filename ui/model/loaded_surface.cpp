// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/loaded_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <mutex>

#include "core3d/diff/estimate_fields.h"
#include "core3d/draw/camera.h"
#include "core3d/io/named_mesh.h"
#include "flatland/scene/surface_setting.h"

namespace flatland::ui {

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

std::vector<Eigen::Vector3f> vertexNormals(const TriangleMesh& mesh) {
  std::vector<Eigen::Vector3f> normals(mesh.vertexCount(), Eigen::Vector3f::Zero());
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3f a = mesh.position(t[0]);
    const Eigen::Vector3f area = (mesh.position(t[1]) - a).cross(mesh.position(t[2]) - a);
    for (const std::uint32_t v : t) normals[v] += area;
  }
  for (Eigen::Vector3f& n : normals) n.normalize();
  return normals;
}

/// What a place is looked for by, with the mesh that it needs.
std::shared_ptr<const MeshPlaces> placesOf(const std::shared_ptr<const TriangleMesh>& mesh) {
  struct Kept {
    std::shared_ptr<const TriangleMesh> mesh;
    MeshPlaces places;
  };
  const auto kept = std::make_shared<const Kept>(Kept{mesh, MeshPlaces(*mesh)});
  return {kept, &kept->places};
}

LoadedSurface readyToShow(const std::string& reference, BuiltMesh built, Clock::time_point start) {
  LoadedSurface surface;
  surface.reference = reference;
  surface.normals = vertexNormals(built.mesh);
  surface.ballRadius = ballRadiusOf(built.mesh);
  surface.report = std::move(built.report);
  surface.mesh = std::make_shared<const TriangleMesh>(std::move(built.mesh));
  surface.places = placesOf(surface.mesh);
  surface.loadMs = millisecondsSince(start);
  return surface;
}

}  // namespace

LoadedSurface loadSurface(const std::string& reference) {
  const auto start = Clock::now();
  return readyToShow(reference, loadNamedMesh(reference), start);
}

LoadedSurface loadSwept(const SweptSurface& surface, int cells) {
  const auto start = Clock::now();
  SweptMesh mesh = sweptMesh(surface, cells);
  LoadedSurface loaded = readyToShow(kSweptMesh, buildMesh(mesh.soup, "surface"), start);
  loaded.swept = std::make_shared<const SweptOrigin>(SweptOrigin{surface, std::move(mesh), cells});
  return loaded;
}

std::shared_ptr<const LoadedSurface> withFields(const LoadedSurface& surface, double fitScale,
                                                const std::function<bool(double)>& progress) {
  const auto start = Clock::now();
  std::stop_source stop;
  std::mutex once;  // any thread of the estimate tells its progress
  FieldOptions options;
  options.scale = fitScale;
  options.stop = stop.get_token();
  options.progress = [&](double share) {
    const std::lock_guard lock(once);
    if (!progress(share)) stop.request_stop();
  };
  auto fields = std::make_shared<const SurfaceFields>(estimateFields(*surface.mesh, options));
  if (stop.stop_requested() || fields->vertexCount() == 0) return nullptr;
  auto whole = std::make_shared<LoadedSurface>(surface);
  whole->fields = std::move(fields);
  whole->fitScale = fitScale;
  whole->fieldMs = millisecondsSince(start);
  return whole;
}

std::string surfaceName(const std::string& reference) {
  if (reference == kSweptMesh) return "swept curve";
  if (namesSolid(reference)) return reference.substr(std::string(kSolidPrefix).size());
  return std::filesystem::path(reference).filename().string();
}

}  // namespace flatland::ui
