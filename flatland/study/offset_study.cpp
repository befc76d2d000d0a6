// SPDX-License-Identifier: MIT
#include "flatland/study/offset_study.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <condition_variable>
#include <limits>
#include <map>
#include <mutex>
#include <thread>

#include "flatland/curve/arc_length.h"
#include "flatland/features/features.h"
#include "flatland/features/terms.h"

namespace flatland {

namespace {

constexpr std::array<std::string_view, 3> kConventionNames = {"arc-length", "parameter",
                                                              "unnormalised"};
constexpr int kSamples = 512;
constexpr View kStudyView{90.0, std::nullopt};

// SplitMix64 (Steele, Lea and Flood 2014): a good 64-bit mix of a counter, so that curve i can be
// made without making those before it.
std::uint64_t mixed(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

struct Weighted {
  double value, weight;
};

// The value below which `share` of the weight lies. Sorted input.
double quantile(const std::vector<Weighted>& sorted, double total, double share) {
  double sum = 0.0;
  for (const Weighted& w : sorted) {
    sum += w.weight;
    if (sum >= share * total) return w.value;
  }
  return sorted.empty() ? 0.0 : sorted.back().value;
}

double quantile(std::vector<float> values, double share) {
  if (values.empty()) return 0.0;
  const auto middle =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Quartiles quartilesOf(const std::vector<float>& values) {
  return {quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75)};
}

// A bin stands for its middle: within 12 % of every value in it.
Quartiles quartilesOf(const RatioHistogram& histogram) {
  std::vector<Weighted> bins;
  for (std::size_t i = 0; i < histogram.size(); ++i) {
    const double decade = (static_cast<double>(i) + 0.5) / kRatioBinsPerDecade - kRatioDecades;
    bins.push_back({std::pow(10.0, decade), histogram[i]});
  }
  return {quantile(bins, 1.0, 0.25), quantile(bins, 1.0, 0.5), quantile(bins, 1.0, 0.75)};
}

// |offset| / |feature| with the common factor k divided out, so that inflections are no 0 / 0.
double ratioAt(const Terms& terms, double speed, TermConvention convention) {
  const double offset = std::abs(terms.k * terms.k * terms.tw);
  const double feature = std::abs(terms.nw * terms.kPrime);
  switch (convention) {
    case TermConvention::ArcLength:
      return offset / feature;
    case TermConvention::Parameter:
      return offset / (feature * speed);
    case TermConvention::Unnormalised:
      return offset / (feature * speed * speed);
  }
  return 0.0;
}

RatioDistribution distributionOf(std::vector<Weighted> ratios, double total) {
  std::sort(ratios.begin(), ratios.end(),
            [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
  RatioDistribution result{};
  result.percentile5 = quantile(ratios, total, 0.05);
  result.lowerQuartile = quantile(ratios, total, 0.25);
  result.median = quantile(ratios, total, 0.5);
  result.upperQuartile = quantile(ratios, total, 0.75);
  result.percentile95 = quantile(ratios, total, 0.95);
  if (!(total > 0.0)) return result;
  for (const Weighted& w : ratios) {
    result.histogram[ratioBin(w.value)] += static_cast<float>(w.weight / total);
  }
  return result;
}

void measureRatios(CurveOffsets& result, const Bezier& curve) {
  const ViewFrame frame = frameOf(kStudyView);
  std::array<std::vector<Weighted>, kTermConventions> ratios;
  double total = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    const Jet jet = jetAt(curve, (i + 0.5) / kSamples);
    const double speed = jet.d1.norm();
    if (!(speed > 0.0)) continue;
    const Terms terms = termsAt(jet, frame, 1);
    // Both terms exactly zero, under any convention: nothing to compare.
    if (std::isnan(ratioAt(terms, speed, TermConvention::ArcLength))) continue;
    for (std::size_t c = 0; c < ratios.size(); ++c) {
      ratios[c].push_back({ratioAt(terms, speed, static_cast<TermConvention>(c)), speed});
    }
    total += speed;
  }
  for (std::size_t c = 0; c < ratios.size(); ++c) {
    result.ratios[c] = distributionOf(std::move(ratios[c]), total);
  }
}

bool isExtremum(MarkKind kind) { return kind == MarkKind::Ridge || kind == MarkKind::Valley; }

// Nearest mark on the same stretch between inflections and silhouettes for which `wanted` holds.
template <class Wanted>
const Mark* nearestOnStretch(const std::vector<Mark>& marks, const Mark& from, Wanted wanted) {
  const auto at = static_cast<std::ptrdiff_t>(&from - marks.data());
  const auto size = static_cast<std::ptrdiff_t>(marks.size());
  const Mark* best = nullptr;
  for (const int step : {-1, 1}) {
    for (std::ptrdiff_t i = at + step; i >= 0 && i < size; i += step) {
      const Mark& mark = marks[static_cast<std::size_t>(i)];
      if (mark.kind == MarkKind::Inflection || mark.kind == MarkKind::Silhouette ||
          mark.kind == MarkKind::Corner) {
        break;
      }
      if (!wanted(mark.kind)) continue;
      if (!best || std::abs(mark.u - from.u) < std::abs(best->u - from.u)) best = &mark;
      break;
    }
  }
  return best;
}

void pairMarks(CurveOffsets& result, const std::vector<Mark>& marks) {
  const auto isRidgeSeen = [](MarkKind kind) { return kind == MarkKind::ApparentRidge; };
  for (const Mark& mark : marks) {
    if (isExtremum(mark.kind)) ++result.extrema;
    if (!isRidgeSeen(mark.kind)) continue;
    ++result.apparentRidges;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Mark& other : marks) {
      if (isExtremum(other.kind))
        nearest = std::min(nearest, std::abs(*mark.screen - *other.screen));
    }
    if (std::isfinite(nearest)) result.nearest.push_back(nearest / result.length);
    const Mark* partner = nearestOnStretch(marks, mark, isExtremum);
    if (partner && nearestOnStretch(marks, *partner, isRidgeSeen) == &mark) {
      result.displacements.push_back(std::abs(*mark.screen - *partner->screen) / result.length);
    } else {
      ++result.births;
    }
  }
  result.deaths = result.extrema - static_cast<int>(result.displacements.size());
}

}  // namespace

std::string_view nameOf(TermConvention convention) {
  return kConventionNames[static_cast<std::size_t>(convention)];
}

std::optional<TermConvention> termConventionNamed(std::string_view name) {
  const auto found = std::find(kConventionNames.begin(), kConventionNames.end(), name);
  if (found == kConventionNames.end()) return std::nullopt;
  return static_cast<TermConvention>(found - kConventionNames.begin());
}

double scaleFactor(TermConvention convention, double scale) {
  switch (convention) {
    case TermConvention::ArcLength:
      return 1.0;
    case TermConvention::Parameter:
      return 1.0 / scale;
    case TermConvention::Unnormalised:
      return 1.0 / (scale * scale);
  }
  return 1.0;
}

std::size_t ratioBin(double value) {
  if (!(value > 0.0)) return 0;
  const double bin = std::floor((std::log10(value) + kRatioDecades) * kRatioBinsPerDecade);
  return static_cast<std::size_t>(std::clamp(bin, 0.0, kRatioBins - 1.0));
}

double ratioBinStart(std::size_t bin) {
  return std::pow(10.0, static_cast<double>(bin) / kRatioBinsPerDecade - kRatioDecades);
}

std::optional<std::string> OffsetStudyOptions::whyInvalid() const {
  if (curves < 1) return "a study needs at least 1 curve";
  if (points < 3 || points > 9) return "curves of a study have 3 to 9 control points";
  if (!(scale >= 1e-50 && scale <= 1e50)) return "the scale must lie between 1e-50 and 1e50";
  return std::nullopt;
}

Bezier studyCurve(const OffsetStudyOptions& options, std::int64_t index) {
  const std::uint64_t stream = mixed(mixed(options.seed) ^ static_cast<std::uint64_t>(index));
  std::uint64_t counter = 0;
  const auto uniform = [&] {
    return static_cast<double>(mixed(stream + counter++) >> 11) * 0x1p-53;
  };
  Bezier curve;
  for (int i = 0; i < options.points; ++i) {
    const double x = uniform();
    curve.points.push_back(options.scale * Vec2(x, uniform()));
  }
  return curve;
}

CurveOffsets measureOffsets(const OffsetStudyOptions& options, std::int64_t index) {
  const Bezier curve = studyCurve(options, index);
  const FeatureSet features = findFeatures({{{BezierChain(curve)}}, kStudyView});
  CurveOffsets result{};
  result.index = index;
  result.length = arcLength(curve, 0.0, 1.0, 1e-10 * options.scale).value;
  result.complete = features.complete();
  measureRatios(result, curve);
  pairMarks(result, features.marks);
  return result;
}

void OffsetCollector::add(const CurveOffsets& curve) {
  ++totals_.curves;
  totals_.incomplete += curve.complete ? 0 : 1;
  totals_.apparentRidges += curve.apparentRidges;
  totals_.extrema += curve.extrema;
  totals_.births += curve.births;
  totals_.deaths += curve.deaths;
  for (std::size_t c = 0; c < curve.ratios.size(); ++c) {
    medians_[c].push_back(static_cast<float>(curve.ratios[c].median));
    for (std::size_t i = 0; i < kRatioBins; ++i) {
      totals_.ratios[c].histogram[i] += curve.ratios[c].histogram[i];
    }
  }
  const auto& shares = curve.ratio(convention_).histogram;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    OffsetExample& example = totals_.ratioExamples[i];
    if (shares[i] > example.share) example = {curve.index, shares[i]};
  }
  for (const double d : curve.displacements) {
    displacements_.push_back(static_cast<float>(d));
    const std::size_t bin = ratioBin(d);
    totals_.displacement.histogram[bin] += 1.0;
    OffsetExample& example = totals_.displacementExamples[bin];
    if (example.index < 0) example = {curve.index, 0.0};
  }
  for (const double d : curve.nearest) {
    nearest_.push_back(static_cast<float>(d));
    totals_.nearest.histogram[ratioBin(d)] += 1.0;
  }
}

OffsetSummary OffsetCollector::summary() const {
  OffsetSummary result = totals_;
  if (result.curves == 0) return result;
  for (std::size_t c = 0; c < medians_.size(); ++c) {
    PooledRatio& ratio = result.ratios[c];
    ratio.perCurve = quartilesOf(medians_[c]);
    for (double& share : ratio.histogram) share /= static_cast<double>(result.curves);
    ratio.pooled = quartilesOf(ratio.histogram);
  }
  const auto distances = [](PooledDistance& to, const std::vector<float>& values) {
    to.count = static_cast<std::int64_t>(values.size());
    to.quartiles = quartilesOf(values);
    to.percentile90 = quantile(values, 0.9);
    for (double& share : to.histogram) share /= std::max<double>(1.0, double(values.size()));
  };
  distances(result.displacement, displacements_);
  distances(result.nearest, nearest_);
  return result;
}

namespace {

/// Curves are handed to the workers in chunks and come back in order. Workers stay at most a window
/// ahead of the reader, so a slow reader bounds the memory.
class OrderedRun {
 public:
  OrderedRun(const OffsetStudyOptions& options, std::int64_t first)
      : options_(options), next_(first), expected_(first) {}

  void work() {
    for (;;) {
      std::int64_t from;
      {
        std::unique_lock lock(mutex_);
        room_.wait(lock, [&] { return stop_ || next_ < expected_ + kWindow; });
        if (stop_ || next_ >= options_.curves) return;
        from = next_;
        next_ = std::min(next_ + kChunk, options_.curves);
      }
      std::vector<CurveOffsets> chunk;
      const std::int64_t to = std::min(from + kChunk, options_.curves);
      for (std::int64_t i = from; i < to; ++i) chunk.push_back(measureOffsets(options_, i));
      const std::scoped_lock lock(mutex_);
      done_.emplace(from, std::move(chunk));
      ready_.notify_one();
    }
  }

  std::int64_t deliver(const std::function<bool(const CurveOffsets&)>& row) {
    std::int64_t delivered = 0;
    while (expected_ < options_.curves) {
      std::vector<CurveOffsets> chunk;
      {
        std::unique_lock lock(mutex_);
        ready_.wait(lock, [&] { return done_.contains(expected_); });
        chunk = std::move(done_.extract(expected_).mapped());
        expected_ += static_cast<std::int64_t>(chunk.size());
      }
      room_.notify_all();
      for (const CurveOffsets& curve : chunk) {
        ++delivered;
        if (!row(curve)) return delivered;
      }
    }
    return delivered;
  }

  void stop() {
    const std::scoped_lock lock(mutex_);
    stop_ = true;
    room_.notify_all();
  }

 private:
  static constexpr std::int64_t kChunk = 64;
  static constexpr std::int64_t kWindow = 64 * kChunk;

  const OffsetStudyOptions& options_;
  std::mutex mutex_;
  std::condition_variable room_, ready_;
  std::map<std::int64_t, std::vector<CurveOffsets>> done_;
  std::int64_t next_, expected_;
  bool stop_ = false;
};

}  // namespace

std::int64_t runOffsetStudy(const OffsetStudyOptions& options, std::int64_t first, int threads,
                            const std::function<bool(const CurveOffsets&)>& row) {
  assert(!options.whyInvalid() && threads >= 1);
  OrderedRun run(options, first);
  std::vector<std::jthread> workers;
  // Stops the workers before they are joined, also when `row` throws.
  struct Stopper {
    OrderedRun& run;
    ~Stopper() { run.stop(); }
  } stopper{run};
  for (int i = 0; i < threads; ++i) workers.emplace_back([&run] { run.work(); });
  const std::int64_t delivered = run.deliver(row);
  run.stop();
  return delivered;
}

}  // namespace flatland
