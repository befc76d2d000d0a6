// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/display.h"

#include <QSettings>

namespace flatland::ui {

namespace {

QString familyKey(MarkKind kind) {
  const std::string_view name = nameOf(kind);
  return "display/" + QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size()));
}

}  // namespace

Display::Display(QObject* parent) : QObject(parent) {}

void Display::setShows(MarkKind kind, bool shown) {
  if (shows(kind) == shown) return;
  families_.set(static_cast<std::size_t>(kind), shown);
  emit changed();
}

void Display::setShowsControlPolygon(bool shown) { set(controlPolygon_, shown); }

void Display::setShowsHidden(bool shown) { set(hidden_, shown); }

void Display::set(bool& value, bool shown) {
  if (value == shown) return;
  value = shown;
  emit changed();
}

void Display::restore(const QSettings& settings) {
  for (const MarkKind kind : markKindsInLegendOrder()) {
    setShows(kind, settings.value(familyKey(kind), shows(kind)).toBool());
  }
  setShowsControlPolygon(settings.value("display/control-polygon", controlPolygon_).toBool());
  setShowsHidden(settings.value("display/hidden", hidden_).toBool());
}

void Display::save(QSettings& settings) const {
  for (const MarkKind kind : markKindsInLegendOrder())
    settings.setValue(familyKey(kind), shows(kind));
  settings.setValue("display/control-polygon", controlPolygon_);
  settings.setValue("display/hidden", hidden_);
}

}  // namespace flatland::ui
