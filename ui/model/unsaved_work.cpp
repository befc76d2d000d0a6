// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/unsaved_work.h"

#include <QCoreApplication>
#include <QStringList>

#include "ui/model/loaded_surface.h"
#include "ui/model/surface_look.h"

namespace flatland::ui {

namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(UnsavedWork)
};

bool sameLines(const SurfaceSetting& a, const SurfaceSetting& b) {
  for (std::size_t i = 0; i < kLineFamilyCount; ++i) {
    SurfaceFamily one = familyOf(a, static_cast<LineFamily>(i));
    const SurfaceFamily other = familyOf(b, static_cast<LineFamily>(i));
    one.on = other.on;
    if (!(one == other)) return false;
  }
  return true;
}

}  // namespace

UnsavedWork unsavedWork(const Scene& now, const Scene& saved) {
  UnsavedWork work;
  work.curves = now.curves != saved.curves;
  work.view = !(now.view == saved.view);
  if (!now.surface) {
    // What was made of a curve is gone; any other surface can be opened again.
    work.swept = saved.surface && saved.surface->swept;
    return work;
  }
  const SurfaceSetting before = saved.surface.value_or(SurfaceSetting{});
  work.swept = now.surface->swept != before.swept;
  // Its thresholds come with being swept.
  work.lines = !work.swept && !sameLines(*now.surface, before);
  work.cameras = now.surface->savedCameras != before.savedCameras;
  return work;
}

QString unsavedWorkForPeople(const Scene& now, const Scene& saved) {
  const UnsavedWork work = unsavedWork(now, saved);
  const QString mesh = now.surface && !now.surface->swept
                           ? QString::fromStdString(surfaceName(now.surface->mesh))
                           : QString();
  QStringList parts;
  if (work.curves) parts << Words::tr("the curves as you changed them");
  if (work.view) parts << Words::tr("from where the curves are seen");
  if (work.swept) parts << Words::tr("the surface made of a curve");
  if (work.lines && mesh.isEmpty()) parts << Words::tr("how its lines are set");
  if (work.lines && !mesh.isEmpty()) {
    parts << Words::tr("thresholds, colours and widths of the lines of %1").arg(mesh);
  }
  if (work.cameras) parts << Words::tr("the cameras you kept");
  if (parts.isEmpty()) {
    parts << (mesh.isEmpty() ? Words::tr("how it is shown")
                             : Words::tr("how %1 is shown").arg(mesh));
  }
  return parts.join(", ");
}

}  // namespace flatland::ui
