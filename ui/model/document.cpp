// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/document.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "flatland/io/scene_json.h"
#include "ui/model/unsaved_work.h"

namespace flatland::ui {

std::optional<std::size_t> CurveShift::after(std::size_t before) const {
  std::size_t index = before;
  if (!removed) {
    for (const std::size_t curve : curves) {
      if (curve <= index) ++index;
    }
    return index;
  }
  for (const std::size_t curve : curves) {
    if (curve == before) return std::nullopt;
    if (curve < before) --index;
  }
  return index;
}

Document::Document(Scene scene, const QString& originName, QObject* parent)
    : QObject(parent),
      scene_(std::move(scene)),
      origin_(scene_),
      saved_(scene_),
      originName_(originName) {}

const FeatureSet& Document::features() const {
  if (!features_) {
    const auto start = std::chrono::steady_clock::now();
    features_ = findFeatures(scene_);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    featureMilliseconds_ = took.count();
    ++featureComputations_;
  }
  return *features_;
}

const PrintedRoots& Document::printedRoots() const {
  if (!printedRoots_) printedRoots_ = findPrintedRoots(scene_, features());
  return *printedRoots_;
}

const Visibility& Document::visibility() const {
  if (!visibility_) visibility_.emplace(scene_);
  return *visibility_;
}

void Document::start(Scene scene, const QString& originName) {
  replace(std::move(scene), originName, {});
}

void Document::open(const std::filesystem::path& file) {
  Scene scene = loadScene(file);  // throws before anything is touched
  replace(std::move(scene), {}, file);
}

void Document::save(const std::filesystem::path& file) {
  saveScene(scene_, file);
  saved_ = scene_;
  undoStack_.setClean();
  if (file_ == file) return;
  file_ = file;
  emit changed({Change::What::File});
}

void Document::replace(Scene scene, const QString& originName, std::filesystem::path file) {
  scene_ = std::move(scene);
  origin_ = saved_ = scene_;
  originName_ = originName;
  file_ = std::move(file);
  undoStack_.clear();
  sceneChanged({Change::What::Scene});
}

void Document::sceneChanged(const Change& change) {
  features_.reset();
  printedRoots_.reset();
  visibility_.reset();
  emit changed(change);
}

void Document::push(std::unique_ptr<QUndoCommand> command) {
  if (!command->isObsolete()) undoStack_.push(command.release());
}

bool Document::isUnsaved(const Scene& scene, int undoIndex) const {
  if (undoIndex == undoStack_.cleanIndex()) return false;
  return !file_.empty() || unsavedWork(scene, saved_).any() ||
         workTakenOut(undoStack_, undoIndex, scene, saved_).any();
}

void Document::swapCurves(std::vector<SceneCurve>& curves) {
  const bool samePoints = std::equal(
      curves.begin(), curves.end(), scene_.curves.begin(), scene_.curves.end(),
      [](const SceneCurve& a, const SceneCurve& b) { return sameTopology(a.shape, b.shape); });
  std::swap(scene_.curves, curves);
  sceneChanged({samePoints ? Change::What::Points : Change::What::Topology});
}

void Document::swapCurves(std::vector<SceneCurve>& curves, const CurveShift& shift,
                          std::optional<SurfaceSetting>& swept) {
  std::swap(scene_.curves, curves);
  Change change{Change::What::Topology, shift};
  if (swept) {
    change.surfaceToo = true;
    scene_.surface = std::exchange(swept, std::nullopt);
  } else if (scene_.surface && scene_.surface->swept) {
    std::size_t& index = scene_.surface->swept->curve;
    if (const std::optional<std::size_t> after = shift.after(index)) {
      index = *after;
    } else {
      change.surfaceToo = true;
      swept = std::exchange(scene_.surface, std::nullopt);
    }
  }
  sceneChanged(change);
}

void Document::setView(const View& view) {
  if (view == scene_.view) return;
  scene_.view = view;
  sceneChanged({Change::What::View});
}

void Document::swapScene(Scene& scene) {
  std::swap(scene_, scene);
  sceneChanged({Change::What::Scene});
}

void Document::swapSurface(std::optional<SurfaceSetting>& surface) {
  const std::optional<SurfaceSetting>& old = scene_.surface;
  const auto kind = [](const SurfaceSetting& s) { return s.swept ? s.swept->kind : std::string(); };
  // A revolution is looked at along its axis: no view of an extrusion.
  if (surface && old && surface->mesh == old->mesh && surface->upAxis == old->upAxis &&
      kind(*surface) == kind(*old)) {
    surface->camera = scene_.surface->camera;
    const std::size_t both = std::min(surface->panes.size(), scene_.surface->panes.size());
    for (std::size_t i = 0; i < both; ++i) {
      std::optional<SurfaceCamera>& other = surface->panes[i].camera;
      const std::optional<SurfaceCamera>& now = scene_.surface->panes[i].camera;
      if (other && now) other = now;
    }
  }
  std::swap(scene_.surface, surface);
  emit changed({Change::What::Surface});
}

void Document::setCamera(const SurfaceCamera& camera, std::size_t pane) {
  const bool own = pane > 0 && scene_.surface->panes[pane - 1].camera;
  SurfaceCamera& its = own ? *scene_.surface->panes[pane - 1].camera : scene_.surface->camera;
  if (its == camera) return;
  its = camera;
  emit changed({Change::What::Camera});
}

}  // namespace flatland::ui
