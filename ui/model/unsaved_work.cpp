// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/unsaved_work.h"

#include <QCoreApplication>
#include <QStringList>
#include <QUndoStack>
#include <algorithm>
#include <vector>

#include "ui/commands/command_ids.h"
#include "ui/commands/scene_commands.h"
#include "ui/model/loaded_surface.h"
#include "ui/model/surface_look.h"
#include "ui/model/swept_surface.h"

namespace flatland::ui {

namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(UnsavedWork)
};

using Surface = std::optional<SurfaceSetting>;

bool sameLines(const SurfaceSetting& a, const SurfaceSetting& b) {
  for (std::size_t i = 0; i < kLineFamilyCount; ++i) {
    SurfaceFamily one = familyOf(a, static_cast<LineFamily>(i));
    const SurfaceFamily other = familyOf(b, static_cast<LineFamily>(i));
    one.on = other.on;
    if (!(one == other)) return false;
  }
  return true;
}

/// Apart from what being swept does to them.
bool sameOwnLines(const SurfaceSetting& a, const SurfaceSetting& b) {
  return sameLines(withUsualRidges(a), withUsualRidges(b));
}

/// True if it has a kept camera that neither of the others has.
bool hasMoreCameras(const SurfaceSetting& a, const Surface& b, const Surface& c) {
  const auto has = [](const Surface& s, const SavedCamera& camera) {
    return s && std::find(s->savedCameras.begin(), s->savedCameras.end(), camera) !=
                    s->savedCameras.end();
  };
  return std::any_of(a.savedCameras.begin(), a.savedCameras.end(),
                     [&](const SavedCamera& kept) { return !has(b, kept) && !has(c, kept); });
}

/// True if one is the other, drawn otherwise: kept cameras stay.
bool isSameSurface(const SurfaceSetting& a, const Surface& b) {
  return b && a.mesh == b->mesh && (!a.swept || !b->swept || kindOf(*a.swept) == kindOf(*b->swept));
}

/// The surfaces before the steps that set one, in their order.
class Walk {
 public:
  void follow(const QUndoCommand& command) {
    for (int i = 0; i < command.childCount(); ++i) follow(*command.child(i));
    if (command.id() == kLessonCommandId) {
      inLesson_ = true;
    } else if (dynamic_cast<const ReplaceScene*>(&command)) {
      // The lesson is left; else what was there is given up as a whole.
      if (!inLesson_) surfaces_.clear();
      inLesson_ = false;
    } else if (const auto* set = dynamic_cast<const SetSurface*>(&command)) {
      if (!inLesson_) surfaces_.push_back(&set->before());
    }
  }
  std::vector<const Surface*> endingWith(const Surface& now) && {
    surfaces_.push_back(&now);
    return std::move(surfaces_);
  }

 private:
  std::vector<const Surface*> surfaces_;
  bool inLesson_ = false;
};

QString nameForPeople(const SurfaceSetting& surface) {
  if (surface.mesh == kSweptMesh) return Words::tr("the surface made of a curve");
  return QString::fromStdString(surfaceName(surface.mesh));
}

}  // namespace

UnsavedWork unsavedWork(const Scene& now, const Scene& saved) {
  UnsavedWork work;
  work.curves = now.curves != saved.curves;
  work.view = !(now.view == saved.view);
  if (!now.surface) return work;
  const SurfaceSetting before = saved.surface.value_or(SurfaceSetting{});
  work.swept = now.surface->swept && now.surface->swept != before.swept;
  // Its thresholds come with being swept, and go with it.
  work.lines = now.surface->swept == before.swept ? !sameLines(*now.surface, before)
                                                  : !sameOwnLines(*now.surface, before);
  work.cameras = isSameSurface(*now.surface, saved.surface)
                     ? now.surface->savedCameras != before.savedCameras
                     : hasMoreCameras(*now.surface, saved.surface, {});
  return work;
}

UnsavedWork workTakenOut(const QUndoStack& stack, int undoIndex, const Scene& now,
                         const Scene& saved) {
  Walk walk;
  for (int i = std::max(stack.cleanIndex(), 0); i < undoIndex; ++i) walk.follow(*stack.command(i));
  const std::vector<const Surface*> surfaces = std::move(walk).endingWith(now.surface);
  const SurfaceSetting start = saved.surface.value_or(SurfaceSetting{});
  UnsavedWork gone;
  for (auto it = surfaces.begin(); it + 1 != surfaces.end(); ++it) {
    if (!**it || isSameSurface(***it, **(it + 1))) continue;
    const SurfaceSetting& old = ***it;
    gone.cameras = gone.cameras || hasMoreCameras(old, saved.surface, now.surface);
    gone.swept = gone.swept ||
                 (old.swept && old.swept != start.swept && !(now.surface && now.surface->swept));
    // A surface that is closed lends its lines to the next one.
    const auto next = std::find_if(it + 1, surfaces.end(), [](const Surface* s) { return *s; });
    gone.lines = gone.lines || (!sameOwnLines(old, start) &&
                                (next == surfaces.end() || !sameOwnLines(old, ***next)));
  }
  return gone;
}

QString workForPeople(const UnsavedWork& work, const Scene& scene) {
  QStringList parts;
  if (work.curves) parts << Words::tr("the curves as you changed them");
  if (work.view) parts << Words::tr("from where the curves are seen");
  if (work.swept) parts << Words::tr("the surface made of a curve");
  if (work.lines && scene.surface && !isSwept(scene)) {
    parts << Words::tr("thresholds, colours and widths of the lines of %1")
                 .arg(nameForPeople(*scene.surface));
  } else if (work.lines) {
    parts << Words::tr("thresholds, colours and widths of lines");
  }
  if (work.cameras) parts << Words::tr("the cameras you kept");
  return parts.join(", ");
}

QString changesForPeople(const Scene& now, const Scene& saved) {
  const UnsavedWork work = unsavedWork(now, saved);
  QStringList parts;
  if (work.any()) parts << workForPeople(work, now);
  const Surface &there = now.surface, &before = saved.surface;
  if (there && !isSwept(now) && !before) {
    parts << Words::tr("%1 beside the curves", "a mesh").arg(nameForPeople(*there));
  } else if (there && !isSwept(now) && there->mesh != before->mesh) {
    parts << Words::tr("%1 in the place of: %2", "a mesh, a surface")
                 .arg(nameForPeople(*there), nameForPeople(*before));
  } else if (!there && before) {
    parts << Words::tr("that a surface was closed (%1)").arg(nameForPeople(*before));
  }
  const auto planeOf = [](const Surface& s) { return s ? s->plane : std::nullopt; };
  if (planeOf(there) && planeOf(there) != planeOf(before)) {
    parts << Words::tr("the plane that cuts the surface");
  } else if (there && planeOf(before) && !planeOf(there) && isSameSurface(*there, before)) {
    parts << Words::tr("that the plane was removed");
  }
  if (!parts.isEmpty()) return parts.join(", ");
  return there && !isSwept(now) ? Words::tr("how %1 is shown").arg(nameForPeople(*there))
                                : Words::tr("how it is shown");
}

}  // namespace flatland::ui
