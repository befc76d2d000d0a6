// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/display.h"

#include <QSettings>
#include <algorithm>
#include <cmath>
#include <utility>

namespace flatland::ui {

namespace {

QString familyKey(MarkKind kind) {
  const std::string_view name = nameOf(kind);
  return "display/" + QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size()));
}

constexpr std::pair<Display::Theme, const char*> kThemes[] = {
    {Display::Theme::System, "system"},
    {Display::Theme::Light, "light"},
    {Display::Theme::Dark, "dark"},
    {Display::Theme::HighContrast, "high-contrast"}};
constexpr const char* kOverlayKeys[] = {"display/probe-vectors", "display/osculating-circle",
                                        "display/curvature-comb", "display/screen-turn"};
constexpr const char* kPlotKeys[] = {"plots/curvature", "plots/lambda", "plots/terms",
                                     "plots/ratio"};

}  // namespace

std::optional<Display::Theme> Display::themeNamed(std::string_view name) {
  for (const auto& [theme, known] : kThemes) {
    if (name == known) return theme;
  }
  return std::nullopt;
}

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

void Display::setShows(Overlay overlay, bool shown) {
  if (shows(overlay) == shown) return;
  overlays_.set(static_cast<std::size_t>(overlay), shown);
  emit changed();
}

void Display::setCombScale(double scale) {
  if (!std::isfinite(scale)) return;
  const double clamped = std::clamp(scale, 1.0 / kLongestComb, kLongestComb);
  if (combScale_ == clamped) return;
  combScale_ = clamped;
  emit changed();
}

void Display::setShows(PlotKind kind, bool shown) {
  if (shows(kind) == shown) return;
  plots_.set(static_cast<std::size_t>(kind), shown);
  emit changed();
}

void Display::setPlotAbscissa(Abscissa abscissa) {
  if (abscissa_ == abscissa) return;
  abscissa_ = abscissa;
  emit changed();
}

void Display::setUiScale(double scale) {
  if (!std::isfinite(scale)) return;
  double& mine = projector_ ? projectorScale_ : workScale_;
  const double clamped = std::clamp(scale, 1.0, kLargestScale);
  if (mine == clamped) return;
  mine = clamped;
  emit changed();
}

void Display::setProjector(bool on) { set(projector_, on); }

void Display::setTheme(Theme theme) {
  if (theme_ == theme) return;
  theme_ = theme;
  emit changed();
}

void Display::setWheelZooms(bool zooms) { set(wheelZooms_, zooms); }

void Display::restore(const QSettings& settings) {
  for (const MarkKind kind : markKindsInLegendOrder()) {
    setShows(kind, settings.value(familyKey(kind), shows(kind)).toBool());
  }
  setShowsControlPolygon(settings.value("display/control-polygon", controlPolygon_).toBool());
  setShowsHidden(settings.value("display/hidden", hidden_).toBool());
  for (std::size_t i = 0; i < kOverlayCount; ++i) {
    overlays_[i] = settings.value(kOverlayKeys[i], overlays_.test(i)).toBool();
  }
  for (std::size_t i = 0; i < kPlotKindCount; ++i) {
    plots_[i] = settings.value(kPlotKeys[i], plots_.test(i)).toBool();
  }
  const bool onScreen = settings.value("plots/against").toString() == "screen";
  abscissa_ = onScreen ? Abscissa::Screen : Abscissa::ArcLength;
  const double comb = settings.value("display/comb-scale", combScale_).toDouble();
  if (comb > 0.0) setCombScale(comb);
  const auto scale = [&settings](const char* key, double usual) {
    bool isNumber = false;
    const double saved = settings.value(key, usual).toDouble(&isNumber);
    return isNumber && std::isfinite(saved) ? std::clamp(saved, 1.0, kLargestScale) : usual;
  };
  workScale_ = scale("display/scale", workScale_);
  projectorScale_ = scale("display/projector-scale", projectorScale_);
  for (const auto& [theme, name] : kThemes) {
    if (settings.value("display/theme").toString() == QLatin1String(name)) theme_ = theme;
  }
  wheelZooms_ = settings.value("display/wheel-zooms", wheelZooms_).toBool();
  emit changed();
}

void Display::save(QSettings& settings) const {
  for (const MarkKind kind : markKindsInLegendOrder())
    settings.setValue(familyKey(kind), shows(kind));
  settings.setValue("display/control-polygon", controlPolygon_);
  settings.setValue("display/hidden", hidden_);
  for (std::size_t i = 0; i < kOverlayCount; ++i) {
    settings.setValue(kOverlayKeys[i], overlays_.test(i));
  }
  for (std::size_t i = 0; i < kPlotKindCount; ++i) {
    settings.setValue(kPlotKeys[i], plots_.test(i));
  }
  settings.setValue("plots/against", abscissa_ == Abscissa::Screen ? "screen" : "arc-length");
  settings.setValue("display/comb-scale", combScale_);
  settings.setValue("display/scale", workScale_);
  settings.setValue("display/projector-scale", projectorScale_);
  for (const auto& [theme, name] : kThemes) {
    if (theme == theme_) settings.setValue("display/theme", QLatin1String(name));
  }
  settings.setValue("display/wheel-zooms", wheelZooms_);
}

}  // namespace flatland::ui
