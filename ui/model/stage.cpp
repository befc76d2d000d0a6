// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/stage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace flatland::ui {

namespace {

// The curves may grow or shrink to these parts of their circle before the circle follows.
constexpr double kGrowth = 1.05;
constexpr double kShrink = 0.6;
/// A viewer farther than this many radii is left out of the fitted view.
constexpr double kFarViewer = 6.0;
/// The viewer comes no nearer to the origin than this part of the radius.
constexpr double kNearestViewer = 0.05;

/// The circle around the curves: the middle of their box and the farthest point from it. Sampled:
/// a circle to stand things on need not be exact. The radius is 0 without points.
struct Extent {
  Vec2 centre = Vec2::Zero();
  double radius = 0.0;
};

std::vector<Vec2> samplesOf(const Scene& scene) {
  constexpr int kPerPiece = 48;
  std::vector<Vec2> samples;
  for (const SceneCurve& curve : scene.curves) {
    const std::vector<Vec2> more = sampledPoints(curve.shape, kPerPiece);
    samples.insert(samples.end(), more.begin(), more.end());
  }
  return samples;
}

/// Distance of the farthest sample from `centre`; 0 without samples.
double reach(const std::vector<Vec2>& samples, const Vec2& centre) {
  double farthest = 0.0;
  for (const Vec2& p : samples) farthest = std::max(farthest, (p - centre).norm());
  return farthest;
}

Extent extentOf(const std::vector<Vec2>& samples) {
  if (samples.empty()) return {};
  Vec2 low = samples.front();
  Vec2 high = samples.front();
  for (const Vec2& p : samples) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec2 centre = 0.5 * (low + high);
  return {centre, reach(samples, centre)};
}

/// `value` rounded so that `reference` keeps about `digits` digits, to the double that prints
/// short.
double roundedLike(double value, double reference, int digits) {
  const double exponent = std::floor(std::log10(reference)) - (digits - 1);
  if (exponent >= 0.0) {
    const double unit = std::pow(10.0, exponent);
    return std::round(value / unit) * unit;
  }
  const double perUnit = std::pow(10.0, -exponent);
  return std::round(value * perUnit) / perUnit;
}

}  // namespace

Stage::Stage(const Document& document, QObject* parent) : QObject(parent), document_(document) {
  connect(&document, &Document::changed, this, &Stage::follow);
  renew();
}

Vec2 Stage::pivot() const { return document_.scene().view.distance ? Vec2(Vec2::Zero()) : centre_; }

Vec2 Stage::handle() const {
  const ViewFrame frame = frameOf(document_.scene().view);
  return frame.distance ? frame.eye() : Vec2(centre_ + ringRadius() * frame.towards);
}

double Stage::screenOffset() const {
  const ViewFrame frame = frameOf(document_.scene().view);
  const double middle = centre_.dot(frame.towards);
  const double wanted = middle + kScreen * radius_;
  if (!frame.distance) return wanted;
  const double front = middle + radius_;
  const double viewer = *frame.distance;
  if (viewer <= front) return 0.5 * viewer;  // among the curves: no place is clear of them
  return std::min(wanted, 0.5 * (front + viewer));
}

View Stage::viewWithHandleAt(const Vec2& world, bool snap, bool keepDistance) const {
  View view = document_.scene().view;
  const Vec2 arm = world - pivot();
  const double length = arm.norm();
  if (length > 0.0) {
    const double deg = std::atan2(arm.y(), arm.x()) * (180.0 / std::numbers::pi);
    view.angleDeg =
        normalizedDeg(snap ? 15.0 * std::round(deg / 15.0) : std::round(deg * 10.0) / 10.0);
  }
  if (view.distance && !keepDistance) {
    view.distance = roundedLike(std::max(length, kNearestViewer * radius_), radius_, 3);
  }
  return view;
}

double Stage::suggestedDistance() const {
  const double distance = centre_.norm() + 2.5 * radius_;
  return roundedLike(distance, distance, 2);
}

int Stage::distanceDecimals() const {
  // Clamped before the cast, for any radius a scene may have.
  return static_cast<int>(std::clamp(3.0 - std::floor(std::log10(radius_)), 0.0, 15.0));
}

Bounds Stage::fitBox() const {
  const Vec2 extent = Vec2::Constant(ringRadius());
  Bounds box{centre_ - extent, centre_ + extent};
  for (const SceneCurve& curve : document_.scene().curves) {
    for (const Vec2& p : controlPoints(curve.shape)) {
      box.low = box.low.cwiseMin(p);
      box.high = box.high.cwiseMax(p);
    }
  }
  const std::optional<double>& distance = document_.scene().view.distance;
  if (distance && *distance <= kFarViewer * radius_ + centre_.norm()) {
    box.low = box.low.cwiseMin(handle());
    box.high = box.high.cwiseMax(handle());
  }
  return box;
}

SceneCurve Stage::newCurve(const Vec2& centre) const {
  std::vector<Vec2> points;
  for (const Vec2& p :
       {Vec2(0.1, -0.6), Vec2(-0.6, -0.3), Vec2(0.5, 0.0), Vec2(-0.6, 0.3), Vec2(0.1, 0.6)}) {
    const Vec2 place = centre + 0.7 * radius_ * p;
    points.emplace_back(roundedLike(place.x(), radius_, 3), roundedLike(place.y(), radius_, 3));
  }
  return {.shape = BezierChain(Bezier{std::move(points)})};
}

Vec2 Stage::besideTheOthers(const Curve& curve) const {
  constexpr double kGap = 0.2;  // of the radius of the scene
  const auto& curves = document_.scene().curves;
  if (curves.empty()) return Vec2::Zero();
  const Bounds others = boundsOf(document_.scene()), own = boundsOf(curve);
  const bool clear = (own.low.array() > others.high.array()).any() ||
                     (own.high.array() < others.low.array()).any();
  if (clear) return Vec2::Zero();
  // Along the screen, on the side that is nearer, until one of the axes keeps the boxes apart.
  const Vec2 axis = frameOf(document_.scene().view).axis;
  const Vec2 away = axis.dot(own.centre() - others.centre()) < 0.0 ? Vec2(-axis) : axis;
  double least = std::numeric_limits<double>::infinity();
  for (const int k : {0, 1}) {
    const double gap = kGap * radius_;
    if (away[k] > 0.0) least = std::min(least, (others.high[k] + gap - own.low[k]) / away[k]);
    if (away[k] < 0.0) least = std::min(least, (others.low[k] - gap - own.high[k]) / away[k]);
  }
  const Vec2 delta = least * away;
  return {roundedLike(delta.x(), radius_, 3), roundedLike(delta.y(), radius_, 3)};
}

void Stage::renew() {
  if (holds_ > 0) return;
  const Extent extent = extentOf(samplesOf(document_.scene()));
  set(extent.centre, extent.radius > 0.0 ? extent.radius : 1.0);
}

void Stage::release() {
  if (--holds_ == 0) follow({Change::What::Points});
}

void Stage::follow(const Change& change) {
  if (holds_ > 0 || !change.touchesScene() || change.what == Change::What::View) return;
  const std::vector<Vec2> samples = samplesOf(document_.scene());
  const Extent extent = extentOf(samples);
  const bool outgrown = reach(samples, centre_) > radius_ * kGrowth;
  const bool shrunk = extent.radius < kShrink * radius_;
  if (change.what == Change::What::Scene || (extent.radius > 0.0 && (outgrown || shrunk))) renew();
}

void Stage::set(const Vec2& centre, double radius) {
  if (centre == centre_ && radius == radius_) return;
  centre_ = centre;
  radius_ = radius;
  emit changed();
}

}  // namespace flatland::ui
