// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/plots.h"

#include <algorithm>
#include <cmath>

namespace flatland::ui {

namespace {

/// For the eye; the table on the command line is finer.
constexpr ProfileOptions kSampling{.tolerance = 3.0};

constexpr double kMargin = 0.02;      ///< of the width, beside the curve's ends
constexpr double kNarrowest = 1e-6;   ///< of the whole range
constexpr double kPadding = 0.08;     ///< of an axis, above and below the values
constexpr double kOutliers = 0.003;   ///< share of the length whose values may be cut off
constexpr double kPeak = 3.0;         ///< peaks up to this many times the rest are shown whole
constexpr double kSteepShare = 0.04;  ///< of the length, for logarithmic axes

PlotAxis padded(PlotAxis::Scale scale, double low, double high, double linear = 1.0) {
  const auto to = [&](double y) {
    if (scale == PlotAxis::Scale::Log) return std::log10(y);
    return scale == PlotAxis::Scale::Asinh ? std::asinh(y / linear) : y;
  };
  const auto back = [&](double y) {
    if (scale == PlotAxis::Scale::Log) return std::pow(10.0, y);
    return scale == PlotAxis::Scale::Asinh ? linear * std::sinh(y) : y;
  };
  const double a = to(low), b = to(high);
  const double margin = kPadding * (b - a);
  return {scale, back(a - margin), back(b + margin), linear};
}

}  // namespace

Plots::Plots(const Document& document, Selection& selection, Display& display, Probe& probe)
    : document_(document), selection_(selection), display_(display), probe_(probe) {
  connect(&document_, &Document::changed, this, [this](const Change& change) {
    if (!change.touchesScene()) return;
    if (change.what == Change::What::Scene) range_.reset();
    invalidate();
  });
  connect(&display_, &Display::changed, this, &Plots::changed);
  const auto otherCurve = [this] {
    if (curve() == shownCurve_) return;
    range_.reset();
    invalidate();
  };
  connect(&selection_, &Selection::changed, this, otherCurve);
  connect(&probe_, &Probe::changed, this, [this, otherCurve] {
    otherCurve();
    emit probeMoved();
  });
  shownCurve_ = curve();
}

void Plots::invalidate() {
  profile_.reset();
  shownCurve_ = curve();
  emit changed();
}

std::optional<std::size_t> Plots::curve() const {
  const std::optional<std::size_t> found =
      probe_.place() ? std::optional(probe_.place()->curve) : selection_.currentCurve();
  return found && *found < curveCount() ? found : std::nullopt;
}

void Plots::setCurve(std::size_t curve) {
  if (curve >= curveCount()) return;
  selection_.setCurrentCurve(curve);
  if (probe_.place() && probe_.place()->curve != curve) {
    probe_.setPlace(Probe::Place{curve, 0.5 * pieceCount(document_.scene().curves[curve].shape)});
  }
}

const Profile& Plots::profile() const {
  if (!profile_) {
    const auto shown = curve();
    profile_ = shown ? profileOf(document_.scene(), document_.features(), static_cast<int>(*shown),
                                 kSampling)
                     : Profile{};
    ++computations_;
  }
  return *profile_;
}

std::vector<ProfileQuantity> Plots::quantitiesOf(PlotKind kind) const {
  switch (kind) {
    case PlotKind::Curvature:
      return {ProfileQuantity::Curvature};
    case PlotKind::Lambda:
      return {ProfileQuantity::Lambda};
    case PlotKind::Terms:
      if (isPerspective()) {
        return {ProfileQuantity::Perspective, ProfileQuantity::Feature, ProfileQuantity::Offset,
                ProfileQuantity::Sum};
      }
      return {ProfileQuantity::Feature, ProfileQuantity::Offset, ProfileQuantity::Sum};
    case PlotKind::Ratio:
      break;
  }
  return {ProfileQuantity::Ratio};
}

Plots::Range Plots::wholeRange() const {
  const auto extent = extentOf(profile(), abscissa());
  if (!extent) return {0.0, 1.0};
  double width = extent->second - extent->first;
  // A curve seen end-on has one screen coordinate; an axis needs a width.
  if (!(width > 1e-12 * (std::abs(extent->first) + std::abs(extent->second)))) {
    width = std::max(1.0, std::abs(extent->first));
    return {extent->first - 0.5 * width, extent->first + 0.5 * width};
  }
  return {extent->first - kMargin * width, extent->second + kMargin * width};
}

Plots::Range Plots::range() const {
  const Range whole = wholeRange();
  if (!range_) return whole;
  // The curve may have shrunk since.
  const double width = std::min(range_->width(), whole.width());
  const double low = std::clamp(range_->low, whole.low, whole.high - width);
  return {low, low + width};
}

void Plots::setRange(Range range) {
  const Range whole = wholeRange(), before = this->range();
  if (!(range.width() >= kNarrowest * whole.width()) || !std::isfinite(range.width())) return;
  if (range.width() >= whole.width()) {
    range_.reset();
  } else {
    const double low = std::clamp(range.low, whole.low, whole.high - range.width());
    range_ = Range{low, low + range.width()};
  }
  const Range now = this->range();
  if (now.low != before.low || now.high != before.high) emit rangeChanged();
}

void Plots::zoomAt(double x, double factor) {
  const Range now = range();
  if (!(factor > 0.0)) return;
  setRange({x - (x - now.low) / factor, x + (now.high - x) / factor});
}

void Plots::panBy(double dx) {
  const Range now = range();
  setRange({now.low + dx, now.high + dx});
}

void Plots::resetRange() { setRange(wholeRange()); }

double Plots::termScale() const {
  const Range whole = wholeRange();
  const ProfileSpread sizes(profile(), ProfileQuantity::Feature, abscissa(), whole.low, whole.high,
                            true);
  const double median = sizes.empty() ? 0.0 : sizes.quantile(0.5);
  if (!(median > 0.0)) return 1.0;
  // A power of ten, which stays until the median has left it clearly: an axis that changes at every
  // step of a drag cannot be read.
  constexpr double kStay = 0.8;
  if (std::abs(std::log10(median / termScale_)) > kStay) {
    termScale_ = std::pow(10.0, std::round(std::log10(median)));
  }
  return termScale_;
}

PlotAxis Plots::axisOf(PlotKind kind) const {
  const Range shown = range();
  const bool isLog = kind == PlotKind::Lambda || kind == PlotKind::Ratio;
  double low = isLog ? 1.0 : 0.0, high = low;  // included: the ratio 1, the value 0
  bool any = kind == PlotKind::Ratio;
  const double linear = kind == PlotKind::Terms ? termScale() : 1.0;
  const auto include = [&](double y) {
    low = any || !isLog ? std::min(low, y) : y;
    high = any || !isLog ? std::max(high, y) : y;
    any = true;
  };
  for (const ProfileQuantity quantity : quantitiesOf(kind)) {
    const ProfileSpread spread(profile(), quantity, abscissa(), shown.low, shown.high);
    if (spread.empty()) continue;
    const double cut = isLog ? kSteepShare : kOutliers;
    double a = spread.quantile(cut), b = spread.quantile(1.0 - cut);
    if (!isLog) {
      const double least = spread.quantile(0.0), most = spread.quantile(1.0);
      if (kind == PlotKind::Curvature && most - least <= kPeak * (b - a)) a = least, b = most;
    }
    if (isLog && !(a > 0.0)) a = b;
    if (isLog && !(b > 0.0)) continue;
    include(a);
    include(b);
  }
  if (kind == PlotKind::Lambda) {
    for (const PlotMark& mark : marks()) {  // their peaks are what the plot is about
      const auto y = valueAt(mark, ProfileQuantity::Lambda);
      const bool peak = mark.kind == MarkKind::ApparentRidge;
      if (peak && y && *y > 0.0 && mark.x >= shown.low && mark.x <= shown.high) include(*y);
    }
  }
  if (isLog) {
    constexpr double kMostDecades = 8.0;
    if (!any) low = 0.1, high = 10.0;
    high = std::max(high, 10.0 * low) * 2.0;
    low = std::max(low / 2.0, high * std::pow(10.0, -kMostDecades));
    return padded(PlotAxis::Scale::Log, low, high);
  }
  const bool hasHeight = high > low && std::isfinite(high - low);
  if (kind == PlotKind::Curvature) {
    return padded(PlotAxis::Scale::Linear, hasHeight ? low : -1.0, hasHeight ? high : 1.0);
  }
  return padded(PlotAxis::Scale::Asinh, std::min(low, -linear), std::max(high, linear), linear);
}

std::vector<PlotMark> Plots::marks() const {
  std::vector<PlotMark> result;
  const auto shown = curve();
  const auto& all = document_.features().marks;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Mark& mark = all[i];
    if (!shown || mark.curve != static_cast<int>(*shown) || !display_.shows(mark.kind)) continue;
    if (!mark.visible && !display_.showsHidden()) continue;
    if (abscissa() == Abscissa::Screen && !mark.screen) continue;
    const double x = abscissa() == Abscissa::ArcLength ? mark.u : *mark.screen;
    result.push_back({i, mark.kind, x, mark.visible});
  }
  return result;
}

std::optional<double> Plots::valueAt(const PlotMark& mark, ProfileQuantity quantity) const {
  const double t = document_.features().marks[mark.index].t;
  for (const ProfileSegment& segment : profile().segments) {
    if (segment.samples.back().t < t) continue;
    const auto at = std::lower_bound(segment.samples.begin(), segment.samples.end(), t,
                                     [](const ProfileSample& s, double x) { return s.t < x; });
    if (at == segment.samples.end() || at->t != t) return std::nullopt;
    return valueOf(*at, quantity);
  }
  return std::nullopt;
}

std::vector<PlotPrintedRoot> Plots::printedRoots(PlotKind kind) const {
  std::vector<PlotPrintedRoot> result;
  const auto shown = curve();
  const bool tells = kind == PlotKind::Lambda || kind == PlotKind::Terms;
  if (!shown || !tells || !display_.showsPrintedRoots()) return result;
  const auto& all = document_.printedRoots().roots;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].curve != static_cast<int>(*shown)) continue;
    if (abscissa() == Abscissa::ArcLength) {
      result.push_back({i, all[i].u});
    } else if (all[i].screen) {
      result.push_back({i, *all[i].screen});
    }
  }
  return result;
}

std::optional<double> Plots::valueAt(const PlotPrintedRoot& root, ProfileQuantity quantity) const {
  const PrintedRoot& found = document_.printedRoots().roots[root.index];
  const auto reading =
      Probe::readingAt(document_.scene(), {static_cast<std::size_t>(found.curve), found.t});
  return reading ? Probe::valueOf(*reading, quantity) : std::nullopt;
}

std::optional<double> Plots::probeX() const {
  const auto& place = probe_.place();
  if (!place || curve() != place->curve) return std::nullopt;
  if (abscissa() == Abscissa::ArcLength) return lengthAt(shape(), profile(), place->t);
  return screenCoordinate(frameOf(document_.scene().view), pointAt(shape(), place->t));
}

std::optional<double> Plots::probeValue(ProfileQuantity quantity) const {
  const auto reading = probe_.reading();
  if (!reading) return std::nullopt;
  return Probe::valueOf(*reading, quantity);
}

void Plots::setProbeAt(double x) {
  const auto shown = curve();
  if (!shown) return;
  const auto extent = extentOf(profile(), abscissa());
  if (!extent) return;
  if (abscissa() == Abscissa::ArcLength) {
    probe_.setPlace(Probe::Place{*shown, parameterAtLength(shape(), profile(), x)});
    return;
  }
  const std::vector<double> places =
      parametersAt(profile(), abscissa(), std::clamp(x, extent->first, extent->second));
  if (places.empty()) return;
  const auto& before = probe_.place();
  const double t =
      before ? *std::min_element(places.begin(), places.end(),
                                 [&](double a, double b) {
                                   return std::abs(a - before->t) < std::abs(b - before->t);
                                 })
             : places.front();
  probe_.setPlace(Probe::Place{*shown, t});
}

void Plots::moveProbe(double share) {
  const auto shown = curve();
  if (!shown || !(profile().length > 0.0)) return;
  const auto& place = probe_.place();
  if (!place) {
    probe_.setPlace(Probe::Place{*shown, 0.5 * pieceCount(shape())});
    return;
  }
  double u = lengthAt(shape(), profile(), place->t) + share * profile().length;
  if (isClosed(shape())) u -= profile().length * std::floor(u / profile().length);
  probe_.setPlace(Probe::Place{*shown, parameterAtLength(shape(), profile(), u)});
}

void Plots::moveProbeToEnd(bool last) {
  const auto shown = curve();
  if (shown) probe_.setPlace(Probe::Place{*shown, last ? pieceCount(shape()) + 0.0 : 0.0});
}

void Plots::stepToMark(int step) {
  const auto shown = curve();
  if (!shown) return;
  std::vector<double> places;
  for (const PlotMark& mark : marks()) places.push_back(document_.features().marks[mark.index].t);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  if (places.empty()) return;
  double t = step > 0 ? places.front() : places.back();  // around, or where there was no probe
  if (probe_.place()) {
    const double now = probe_.place()->t;
    if (step > 0) {
      const auto next = std::upper_bound(places.begin(), places.end(), now);
      if (next != places.end()) t = *next;
    } else {
      const auto next = std::lower_bound(places.begin(), places.end(), now);
      if (next != places.begin()) t = *std::prev(next);
    }
  }
  probe_.setPlace(Probe::Place{*shown, t});
}

}  // namespace flatland::ui
