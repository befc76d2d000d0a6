// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "flatland/study/profile_lines.h"
#include "ui/model/display.h"
#include "ui/model/document.h"
#include "ui/model/probe.h"
#include "ui/model/selection.h"

namespace flatland::ui {

/// The y axis a plot should have: values, not pixels; never empty.
struct PlotAxis {
  enum class Scale { Linear, Log, Asinh };
  Scale scale;
  double low, high;
  double linear;  ///< Asinh: within +- this the axis is nearly linear, beyond it logarithmic
};

/// A mark as the plots show it.
struct PlotMark {
  std::size_t index;  ///< in the document's features
  MarkKind kind;
  double x;  ///< in the abscissa
  bool visible;
};

/// A root of (3.13) as printed, as the plots show it.
struct PlotPrintedRoot {
  std::size_t index;  ///< in the document's printed roots
  double x;           ///< in the abscissa
};

/// What all plots share: the curve they show, its profile, what it is drawn against, the range of
/// that, and the probe in it. The curve is that of the probe, without a probe the current one.
class Plots : public QObject {
  Q_OBJECT

 public:
  struct Range {
    double low, high;
    double width() const { return high - low; }
  };

  Plots(const Document& document, Selection& selection, Display& display, Probe& probe);

  /// nullopt only in a scene without curves.
  std::optional<std::size_t> curve() const;
  std::size_t curveCount() const { return document_.scene().curves.size(); }
  /// Takes the probe along if there is one.
  void setCurve(std::size_t curve);

  /// Computed at the first call after a change; empty without a curve.
  const Profile& profile() const;
  int profileComputations() const { return computations_; }

  Abscissa abscissa() const { return display_.plotAbscissa(); }
  const Display& display() const { return display_; }
  bool isPerspective() const { return document_.scene().view.distance.has_value(); }

  /// The quantities of a plot, the most important last, so that it lies on top.
  std::vector<ProfileQuantity> quantitiesOf(PlotKind kind) const;

  /// What the plots show now, and the whole of it; both have a width.
  Range range() const;
  Range wholeRange() const;
  /// Kept inside the whole; one that is too narrow to be told apart changes nothing.
  void setRange(Range range);
  void zoomAt(double x, double factor);
  void panBy(double dx);
  void resetRange();

  /// Fits the values inside the range, so that no infinite peak flattens the rest, and includes
  /// what the plot is about: 0, or the ratio 1.
  PlotAxis axisOf(PlotKind kind) const;

  /// The marks of the curve whose families are shown; without those that have no place (behind the
  /// viewer).
  std::vector<PlotMark> marks() const;
  /// The quantity at a mark; nullopt where it is infinite or undefined.
  std::optional<double> valueAt(const PlotMark& mark, ProfileQuantity quantity) const;

  /// The roots of (3.13) as printed on the curve, while the display shows them: on the plots of
  /// lambda and the terms, where it can be seen that they miss; on the others none.
  std::vector<PlotPrintedRoot> printedRoots(PlotKind kind) const;
  std::optional<double> valueAt(const PlotPrintedRoot& root, ProfileQuantity quantity) const;

  std::optional<double> probeX() const;
  std::optional<double> probeValue(ProfileQuantity quantity) const;
  /// Puts the probe where the abscissa is `x`: of several places the one nearest to where it was,
  /// else the first. Clamped to the curve.
  void setProbeAt(double x);
  /// Along the curve, by a share of the arc length.
  void moveProbe(double share);
  void moveProbeToEnd(bool last);
  /// To the next (1) or previous (-1) shown mark of the curve, exactly; after the last the first.
  void stepToMark(int step);

 signals:
  /// Other lines or marks.
  void changed();
  void rangeChanged();
  void probeMoved();

 private:
  void invalidate();
  const Curve& shape() const { return document_.scene().curves[*curve()].shape; }
  double termScale() const;

  const Document& document_;
  Selection& selection_;
  Display& display_;
  Probe& probe_;
  mutable std::optional<Profile> profile_;
  mutable int computations_ = 0;
  mutable double termScale_ = 1.0;
  std::optional<Range> range_;  ///< empty: the whole
  std::optional<std::size_t> shownCurve_;
};

}  // namespace flatland::ui
