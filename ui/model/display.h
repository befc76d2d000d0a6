// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>
#include <string_view>

#include "flatland/study/profile_lines.h"
#include "ui/export/mark_style.h"

class QSettings;

namespace flatland::ui {

/// The plots along the curve.
enum class PlotKind { Curvature, Lambda, Terms, Ratio };
inline constexpr int kPlotKindCount = 4;

/// What is drawn around the probe and its curve on the canvas.
enum class Overlay {
  Vectors,     ///< n, t and the curvature vector at the probe
  Circle,      ///< osculating circle
  Comb,        ///< curvature comb of the probe's curve
  ScreenTurn,  ///< dn/di on the screen
};
inline constexpr int kOverlayCount = 4;

/// What the person wants to see of the scene: no part of the document, so not undone or saved with
/// it, but remembered between sessions.
class Display : public QObject {
  Q_OBJECT

 public:
  explicit Display(QObject* parent = nullptr);

  /// The families shown: all but flat points and apparent minima, unless changed.
  const MarkKinds& families() const { return families_; }
  bool shows(MarkKind kind) const { return contains(families_, kind); }
  void setShows(MarkKind kind, bool shown);

  bool showsControlPolygon() const { return controlPolygon_; }
  void setShowsControlPolygon(bool shown);

  /// Hidden marks and parts of the curve: shown paler, or not at all.
  bool showsHidden() const { return hidden_; }
  void setShowsHidden(bool shown);

  /// All but the comb, unless changed.
  bool shows(Overlay overlay) const { return overlays_.test(static_cast<std::size_t>(overlay)); }
  void setShows(Overlay overlay, bool shown);
  /// How many times as long as usual the comb's teeth are: between 1 and kLongestComb either way.
  double combScale() const { return combScale_; }
  void setCombScale(double scale);
  static constexpr double kLongestComb = 64.0;

  /// All, unless changed.
  bool shows(PlotKind kind) const { return plots_.test(static_cast<std::size_t>(kind)); }
  void setShows(PlotKind kind, bool shown);
  /// What the plots are drawn against.
  Abscissa plotAbscissa() const { return abscissa_; }
  void setPlotAbscissa(Abscissa abscissa);

  /// The roots of (3.13) as the thesis misprints it; a matter of the lesson, not remembered.
  bool showsPrintedRoots() const { return printedRoots_; }
  void setShowsPrintedRoots(bool shown) { set(printedRoots_, shown); }

  /// How much larger than usual everything is drawn, text, marks and lines alike, on canvas,
  /// plots and lesson: between 1 and kLargestScale. Projector mode has a scale of its own.
  double uiScale() const { return projector_ ? projectorScale_ : workScale_; }
  /// Sets the scale of the mode there is now; clamped.
  void setUiScale(double scale);

  /// Few widgets, large type: for a room that looks on.
  bool isProjector() const { return projector_; }
  void setProjector(bool on);

  static constexpr double kLargestScale = 2.5;
  static constexpr double kProjectorScale = 1.6;  ///< until the person chooses another

  /// The colours of the window; those of figures follow, see themePalette().
  enum class Theme { System, Light, Dark, HighContrast };
  /// "system", "light", "dark", "high-contrast"
  static std::optional<Theme> themeNamed(std::string_view name);
  Theme theme() const { return theme_; }
  void setTheme(Theme theme);

  /// What turning a mouse wheel over the canvas does; two fingers on a trackpad always move the
  /// picture, and with Ctrl every wheel zooms.
  bool wheelZooms() const { return wheelZooms_; }
  void setWheelZooms(bool zooms);

  void restore(const QSettings& settings);
  void save(QSettings& settings) const;

 signals:
  void changed();

 private:
  void set(bool& value, bool shown);

  MarkKinds families_ = defaultMarkKinds();
  bool controlPolygon_ = true;
  bool hidden_ = true;
  std::bitset<kOverlayCount> overlays_{0b1011};
  double combScale_ = 1.0;
  std::bitset<kPlotKindCount> plots_{0b1111};
  Abscissa abscissa_ = Abscissa::ArcLength;
  bool printedRoots_ = false;
  bool projector_ = false;
  Theme theme_ = Theme::System;
  bool wheelZooms_ = true;
  double workScale_ = 1.0;
  double projectorScale_ = kProjectorScale;
};

}  // namespace flatland::ui
