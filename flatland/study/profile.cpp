// SPDX-License-Identifier: MIT
#include "flatland/study/profile.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "flatland/curve/arc_length.h"
#include "flatland/features/orientation.h"
#include "flatland/study/probe_geometry.h"

namespace flatland {

namespace {

constexpr int kBaseSteps = 24;          // of a piece, before anything is known of it
constexpr int kMaxHalvings = 16;        // of a base step
constexpr int kMaxSamples = 4000;       // of a piece
constexpr double kShortestStep = 1e-7;  // of the length
constexpr double kLengthAccuracy = 1e-12;
constexpr double kHair = 0x1p-20;  // distance from a cusp, of the step beside it

// n.w and k' (against k^2 + 1/L^2) below which they are rounding and nothing is divided by them; a
// mark says that they are zero, and may be off by what its root is.
constexpr double kZero = 1e-13;
constexpr double kZeroAtMark = 1e-6;

// How many decades from its median lambda and the ratio are followed.
constexpr double kLambdaDecades = 8.0;
constexpr double kRatioDecades = 5.0;

// One-sided values at a joint that differ by less are one value; see kSameCurvature.
constexpr double kSame = 1e-9;
constexpr double kSamePrime = 1e-6;

// Values in which a straight line on the plot is a straight line.
constexpr std::size_t kChannels = 6;
using Channels = std::array<double, kChannels>;

struct Node {
  ProfileSample sample;
  double speed, speed1, speed2;  // |d1| and its derivatives by the parameter
  Channels channels;             // once there are scales
};

constexpr Channels kTolerance{0.002, 0.004, 0.004, 0.004, 0.01, 0.01};

double median(std::vector<double> values, double otherwise) {
  if (values.empty()) return otherwise;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle > 0.0 && std::isfinite(*middle) ? *middle : otherwise;
}

class Profiler {
 public:
  Profiler(const Scene& scene, const FeatureSet& features, int curve, double tolerance)
      : shape_(scene.curves[static_cast<std::size_t>(curve)].shape),
        frame_(frameOf(scene.view)),
        side_(normalSide(scene.curves[static_cast<std::size_t>(curve)], frame_)),
        tolerance_(tolerance) {
    for (const Mark& mark : features.marks) {
      if (mark.curve == curve) marks_.push_back(&mark);
    }
    for (const Degenerate& piece : features.degenerate) {
      if (piece.curve == curve) degenerate_.push_back(&piece);
    }
    profile_.curve = curve;
  }

  Profile run() {
    layOut();
    if (!(size_ > 0.0)) return std::move(profile_);
    for (std::size_t i = 0; i < stretches_.size(); ++i) {
      if (i == 0 || stretches_[i].piece != stretches_[i - 1].piece) budget_ = kMaxSamples;
      append(refined(stretches_[i].nodes));
    }
    profile_.length = u_ + gapTo(pieceCount(shape_));
    return std::move(profile_);
  }

 private:
  // Between two cuts of one piece, with its first samples.
  struct Stretch {
    int piece;
    std::vector<Node> nodes;
  };

  // The marks' parameters on a piece with its ends, in order, each once.
  std::vector<double> cutsOf(int piece) const {
    std::vector<double> cuts{0.0, 1.0};
    for (const Mark* mark : marks_) {
      const double local = mark->t - piece;
      if (local > 0.0 && local < 1.0) cuts.push_back(local);
    }
    for (const Degenerate* known : degenerate_) {
      if (known->what != Degenerate::What::Point) continue;
      for (const double local : {known->tLow - piece, known->tHigh - piece}) {
        if (local > 0.0 && local < 1.0) cuts.push_back(local);
      }
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    return cuts;
  }

  bool isMark(double t, bool (*isKind)(MarkKind)) const {
    return std::any_of(marks_.begin(), marks_.end(),
                       [&](const Mark* mark) { return mark->t == t && isKind(mark->kind); });
  }
  const Degenerate* degenerateAt(double t) const {
    for (const Degenerate* piece : degenerate_) {
      if (t >= piece->tLow && t <= piece->tHigh) return piece;
    }
    return nullptr;
  }

  // First samples everywhere, and from them the size of the curve and of its quantities.
  void layOut() {
    std::vector<double> ks, terms, lambdas;
    for (int piece = 0; piece < pieceCount(shape_); ++piece) {
      const std::vector<double> cuts = cutsOf(piece);
      for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const Degenerate* known = degenerateAt(piece + 0.5 * (cuts[i] + cuts[i + 1]));
        if (known && known->what == Degenerate::What::Point) continue;
        Stretch stretch{piece, {}};
        const double from = inside(piece, cuts[i], cuts[i + 1]);
        const double to = inside(piece, cuts[i + 1], cuts[i]);
        const int steps = std::max(2, static_cast<int>(std::ceil(kBaseSteps * (to - from))));
        for (int j = 0; j <= steps; ++j) {
          const double t = j == steps ? to : from + (to - from) * j / steps;
          stretch.nodes.push_back(nodeAt(piece, t));
          const ProfileSample& s = stretch.nodes.back().sample;
          if (j > 0) {
            size_ += (s.point - stretch.nodes[stretch.nodes.size() - 2].sample.point).norm();
          }
          if (j == 0 || j == steps) continue;  // there they are 0 or infinite
          ks.push_back(std::abs(s.k));
          terms.push_back(std::max(std::abs(s.feature), std::abs(s.offset)));
          if (s.lambda) lambdas.push_back(*s.lambda);
        }
        stretches_.push_back(std::move(stretch));
      }
    }
    if (!(size_ > 0.0)) return;
    kScale_ = median(std::move(ks), 1.0 / size_);
    termScale_ = median(std::move(terms), 1.0 / (size_ * size_ * size_));
    lambdaScale_ = median(std::move(lambdas), 1.0 / (size_ * size_));
    scaled_ = true;
    // Now that there is a size, what is zero against it can be told.
    for (Stretch& stretch : stretches_) {
      for (Node& node : stretch.nodes) {
        withoutRounding(node.sample);
        node.channels = channelsOf(node.sample);
      }
    }
  }

  // `end`, or a hair towards `other` where the curve has no tangent.
  double inside(int piece, double end, double other) const {
    const double step = (other - end) / kBaseSteps;
    const double speed = jetAt(shape_, piece, end).d1.norm();
    const double beside = jetAt(shape_, piece, end + step).d1.norm();
    return speed > kSame * beside ? end : end + kHair * step;
  }

  Node nodeAt(int piece, double local) const {
    Jet jet = jetAt(shape_, piece, local);
    if (!(jet.d1.squaredNorm() > 0.0)) {
      // A cusp that no mark tells of: a neighbour stands in for it.
      jet = jetAt(shape_, piece, local + (local < 0.5 ? kHair : -kHair));
    }
    const double s = jet.d1.norm();
    const double along = jet.d1.dot(jet.d2);
    Node node{{}, s, along / s, 0.0, {}};
    node.speed2 = (jet.d2.squaredNorm() + jet.d1.dot(jet.d3)) / s - along * along / (s * s * s);
    const Terms terms = termsAt(jet, frame_, side_);
    ProfileSample& sample = node.sample;
    sample.t = piece + local;
    sample.u = 0.0;
    sample.point = jet.p;
    sample.screen = screenCoordinate(frame_, jet.p);
    sample.nw = terms.nw;
    sample.tw = terms.tw;
    sample.k = terms.k;
    sample.kPrime = terms.kPrime;
    sample.lambda = terms.lambda;
    sample.feature = terms.feature;
    sample.offset = terms.offset;
    sample.perspective = terms.perspective;
    if (size_ > 0.0) withoutRounding(sample);
    if (scaled_) node.channels = channelsOf(sample);
    return node;
  }

  // Takes out what is zero but for rounding, and what would be divided by it.
  void withoutRounding(ProfileSample& s) const {
    if (const Degenerate* known = degenerateAt(s.t)) {
      // A joint belongs to what it is an end of only if that is straight from both sides.
      const bool inner = s.t > known->tLow && s.t < known->tHigh;
      if (known->what == Degenerate::What::ConstantCurvature) {
        s.kPrime = s.feature = 0.0;
      } else if (inner || std::abs(s.k) * size_ < kZero) {
        s.k = s.kPrime = s.feature = s.offset = s.perspective = 0.0;
        s.lambda = 0.0;
        if (known->what == Degenerate::What::StraightEndOn) s.lambda.reset();
      }
    }
    Terms terms{};
    terms.k = s.k;
    terms.kPrime = s.kPrime;
    terms.nw = s.nw;
    terms.tw = s.tw;
    s.ratio = termRatioAt(terms, size_);
    const bool silhouette = isMark(s.t, [](MarkKind kind) { return kind == MarkKind::Silhouette; });
    if (std::abs(s.nw) <= (silhouette ? kZeroAtMark : kZero)) {
      s.lambda.reset();
      s.ratio.reset();
    }
    const bool extremum = isMark(s.t, [](MarkKind kind) {
      return kind == MarkKind::Ridge || kind == MarkKind::Valley || kind == MarkKind::Flat;
    });
    const double natural = s.k * s.k + 1.0 / (size_ * size_);
    if (extremum && std::abs(s.kPrime) <= kZeroAtMark * natural) s.ratio.reset();
  }

  Channels channelsOf(const ProfileSample& s) const {
    const auto decades = [](const std::optional<double>& value, double scale, double most) {
      if (!value)
        return std::log(10.0) * most;  // lambda and the ratio have no value where infinite
      return std::log(10.0) * std::clamp(std::log10(*value / scale), -most, most);
    };
    return {std::asinh(s.k / kScale_),
            std::asinh(s.feature / termScale_),
            std::asinh(s.offset / termScale_),
            std::asinh(s.sum() / termScale_),
            decades(s.lambda, lambdaScale_, kLambdaDecades),
            decades(s.ratio, 1.0, kRatioDecades)};
  }

  bool isFlat(const Node& a, const Node& m, const Node& b) const {
    const double low = (m.sample.point - a.sample.point).norm();
    const double high = (b.sample.point - m.sample.point).norm();
    if (low + high <= kShortestStep * size_) return true;
    const double share = low / (low + high);
    const Channels &ya = a.channels, &ym = m.channels, &yb = b.channels;
    for (std::size_t i = 0; i < kChannels; ++i) {
      const double line = ya[i] + share * (yb[i] - ya[i]);
      if (!(std::abs(ym[i] - line) <= tolerance_ * kTolerance[i])) return false;
    }
    return true;
  }

  void refine(int piece, const Node& a, const Node& b, int halvings, std::vector<Node>& to) {
    const double middle = 0.5 * (a.sample.t + b.sample.t) - piece;
    const Node m = nodeAt(piece, middle);
    const bool done = halvings == 0 || budget_ <= 0 || isFlat(a, m, b);
    --budget_;
    if (!done) refine(piece, a, m, halvings - 1, to);
    to.push_back(m);
    if (!done) refine(piece, m, b, halvings - 1, to);
  }

  std::vector<Node> refined(const std::vector<Node>& nodes) {
    std::vector<Node> fine{nodes.front()};
    const int piece = static_cast<int>(std::floor(nodes[1].sample.t));
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      refine(piece, nodes[i - 1], nodes[i], kMaxHalvings, fine);
      fine.push_back(nodes[i]);
    }
    return fine;
  }

  // Length from where the profile has come to, to t: nothing, or a cusp's two hairs.
  double gapTo(double t) const {
    return t > tEnd_ ? arcLength(shape_, tEnd_, t, kLengthAccuracy * size_).value : 0.0;
  }

  // The integral of the speed between two samples, from its values and derivatives there (two-point
  // Hermite rule of order 6). Where that of order 4 does not agree, by quadrature.
  double step(const Node& a, const Node& b) const {
    constexpr double kAgreement = 1e-8;  // the order 6 is better by far than the order 4
    constexpr double kStepAccuracy = 1e-11;
    const double h = b.sample.t - a.sample.t;
    const double trapezoid = 0.5 * h * (a.speed + b.speed);
    const double order4 = trapezoid + h * h / 12.0 * (a.speed1 - b.speed1);
    const double order6 = trapezoid + h * h / 10.0 * (a.speed1 - b.speed1) +
                          h * h * h / 120.0 * (a.speed2 + b.speed2);
    if (std::abs(order6 - order4) <= kAgreement * size_) return order6;
    return arcLength(shape_, a.sample.t, b.sample.t, kStepAccuracy * size_).value;
  }

  void append(std::vector<Node> nodes) {
    u_ += gapTo(nodes.front().sample.t);
    nodes.front().sample.u = u_;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      u_ += step(nodes[i - 1], nodes[i]);
      nodes[i].sample.u = u_;
    }
    tEnd_ = nodes.back().sample.t;
    auto& segments = profile_.segments;
    const bool goesOn =
        !segments.empty() && isSmooth(segments.back().samples.back(), nodes.front().sample);
    if (!goesOn) segments.emplace_back();
    auto& samples = segments.back().samples;
    for (std::size_t i = goesOn ? 1 : 0; i < nodes.size(); ++i) samples.push_back(nodes[i].sample);
  }

  // Whether nothing breaks between the end of one stretch and the start of the next.
  bool isSmooth(const ProfileSample& a, const ProfileSample& b) const {
    const auto same = [](double x, double y, double natural, double accuracy) {
      return std::abs(x - y) <= accuracy * (std::abs(x) + std::abs(y) + natural);
    };
    return a.t == b.t && a.lambda && b.lambda && a.ratio.has_value() == b.ratio.has_value() &&
           (a.ratio || (a.k == 0.0 && b.k == 0.0)) && same(a.nw, b.nw, 1.0, kSame) &&
           same(a.tw, b.tw, 1.0, kSame) && same(a.k, b.k, 1.0 / size_, kSame) &&
           same(a.kPrime, b.kPrime, a.k * a.k + 1.0 / (size_ * size_), kSamePrime);
  }

  const Curve& shape_;
  ViewFrame frame_;
  int side_;
  double tolerance_;
  std::vector<const Mark*> marks_;
  std::vector<const Degenerate*> degenerate_;
  std::vector<Stretch> stretches_;
  double size_ = 0.0;  // the length, roughly
  bool scaled_ = false;
  double kScale_ = 1.0, termScale_ = 1.0, lambdaScale_ = 1.0;
  int budget_ = 0;
  double u_ = 0.0, tEnd_ = 0.0;
  Profile profile_;
};

// The sample at or before `t`, at or after it for the first ones. Precondition: segments.
const ProfileSample& sampleBefore(const Profile& profile, double t) {
  const ProfileSample* best = &profile.segments.front().samples.front();
  for (const ProfileSegment& segment : profile.segments) {
    if (segment.samples.front().t > t) break;
    const auto after = std::upper_bound(segment.samples.begin(), segment.samples.end(), t,
                                        [](double x, const ProfileSample& s) { return x < s.t; });
    best = &*std::prev(after);
  }
  return *best;
}

}  // namespace

std::size_t Profile::sampleCount() const {
  std::size_t count = 0;
  for (const ProfileSegment& segment : segments) count += segment.samples.size();
  return count;
}

Profile profileOf(const Scene& scene, const FeatureSet& features, int curve,
                  const ProfileOptions& options) {
  assert(curve >= 0 && static_cast<std::size_t>(curve) < scene.curves.size());
  return Profiler(scene, features, curve, options.tolerance).run();
}

double lengthAt(const Curve& curve, const Profile& profile, double t) {
  if (profile.segments.empty()) return 0.0;
  const ProfileSample& from = sampleBefore(profile, t);
  return from.u + arcLength(curve, from.t, t, kLengthAccuracy * profile.length).value;
}

double parameterAtLength(const Curve& curve, const Profile& profile, double u) {
  if (profile.segments.empty() || !(u > 0.0)) return 0.0;
  const double end = pieceCount(curve);
  if (u >= profile.length) return end;
  // The samples around u, then bisection helped by Newton: the length grows with t.
  double low = 0.0, high = end;
  for (const ProfileSegment& segment : profile.segments) {
    for (const ProfileSample& sample : segment.samples) {
      if (sample.u <= u) low = std::max(low, sample.t);
      if (sample.u >= u) high = std::min(high, sample.t);
    }
  }
  double t = 0.5 * (low + high);
  for (int i = 0; i < 60 && high > low; ++i) {
    const double error = lengthAt(curve, profile, t) - u;
    (error > 0.0 ? high : low) = t;
    if (std::abs(error) <= kLengthAccuracy * profile.length) break;
    const double newton = t - error / jetAt(curve, t).d1.norm();
    const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (next == t) break;
    t = next;
  }
  return t;
}

}  // namespace flatland
