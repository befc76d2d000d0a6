// SPDX-License-Identifier: MIT
#include "flatland/io/svg_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "flatland/io/input_error.h"
#include "flatland/io/svg_scanner.h"

namespace flatland {

namespace {

constexpr double kMostDegPerConic = 90.0;

bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }
char toUpper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// Reads one path. Coordinates of relative commands are added up as the text says.
class PathReader {
 public:
  PathReader(std::string_view text, const std::string& source, const std::string& place)
      : scan_(text, source, place) {}

  std::vector<Subpath> read() {
    scan_.skipSpace();
    while (!scan_.atEnd()) {
      readCommand();
      scan_.skipSpace();
    }
    finish();
    return std::move(done_);
  }

 private:
  void readCommand() {
    const char letter = scan_.peek();
    const char kind = toUpper(letter);
    if (std::string_view("MLHVCSQTAZ").find(kind) == std::string_view::npos) {
      scan_.fail("expected a path command, found " + scan_.found());
    }
    if (!begun_ && kind != 'M') scan_.fail("a path begins with M or m, found " + scan_.found());
    scan_.advance();
    relative_ = !isUpper(letter);
    if (kind == 'Z') {
      close();
      previous_ = 'Z';
      return;
    }
    // The arguments may be repeated; further pairs after M are those of L.
    char now = kind;
    do {
      scan_.skipSpace();
      readArguments(now);
      previous_ = now;
      if (now == 'M') now = 'L';
    } while (scan_.skipToNextArgument());
  }

  void readArguments(char kind) {
    const Vec2 origin = relative_ ? at_ : Vec2::Zero();
    switch (kind) {
      case 'M':
        moveTo(origin + scan_.pair());
        break;
      case 'L':
        add({{at_, origin + scan_.pair()}});
        break;
      case 'H':
        add({{at_, Vec2(origin.x() + scan_.number(), at_.y())}});
        break;
      case 'V':
        add({{at_, Vec2(at_.x(), origin.y() + scan_.number())}});
        break;
      case 'C':
      case 'S': {
        const Vec2 first = kind == 'C' ? Vec2(origin + nextPair()) : reflected("CS");
        const Vec2 second = origin + nextPair();
        handle_ = second;
        add({{at_, first, second, origin + scan_.pair()}});
        break;
      }
      case 'Q':
      case 'T': {
        const Vec2 middle = kind == 'Q' ? Vec2(origin + nextPair()) : reflected("QT");
        handle_ = middle;
        add({{at_, middle, origin + scan_.pair()}});
        break;
      }
      case 'A':
        readArc(origin);
        break;
      default:
        break;
    }
  }

  /// A pair that is followed by more of the same command.
  Vec2 nextPair() {
    const Vec2 pair = scan_.pair();
    scan_.skipCommaSpace();
    return pair;
  }

  /// The handle of the segment before, mirrored at the current point; the point itself after
  /// another kind of segment.
  Vec2 reflected(std::string_view kinds) const {
    return kinds.find(previous_) == std::string_view::npos ? at_ : Vec2(2.0 * at_ - handle_);
  }

  void readArc(const Vec2& origin) {
    SvgArc arc;
    arc.radii = nextPair();
    arc.rotationDeg = scan_.number();
    scan_.skipCommaSpace();
    arc.large = scan_.flag();
    scan_.skipCommaSpace();
    arc.sweep = scan_.flag();
    scan_.skipCommaSpace();
    const Vec2 end = origin + scan_.pair();
    if (end == at_) {
      add({{at_, end}});  // of zero length, counted as such
      return;
    }
    for (PathSegment& conic : conicsOfArc(at_, end, arc)) add(std::move(conic));
  }

  void moveTo(const Vec2& point) {
    finish();
    begun_ = true;
    at_ = open_.start = point;
    hasOpen_ = true;
  }

  void add(PathSegment segment) {
    if (!hasOpen_) {  // after Z without M: another subpath from the same start
      open_.start = at_;
      hasOpen_ = true;
    }
    if (++segments_ > kMostSvgSegments) {
      scan_.fail("more than " + std::to_string(kMostSvgSegments) + " segments, too many");
    }
    at_ = segment.points.back();
    open_.segments.push_back(std::move(segment));
  }

  void close() {
    open_.closed = true;
    at_ = open_.start;
    finish();
  }

  void finish() {
    if (hasOpen_) done_.push_back(std::move(open_));
    const Vec2 start = open_.start;
    open_ = {};
    open_.start = start;
    hasOpen_ = false;
  }

  SvgScanner scan_;
  std::vector<Subpath> done_;
  Subpath open_;
  bool hasOpen_ = false;
  bool begun_ = false;
  bool relative_ = false;
  char previous_ = 'M';
  Vec2 at_ = Vec2::Zero();
  Vec2 handle_ = Vec2::Zero();
  std::size_t segments_ = 0;
};

double sizeOf(const std::vector<PathSegment>& segments) {
  Vec2 low = segments.front().points.front(), high = low;
  for (const Bezier& segment : segments) {
    for (const Vec2& p : segment.points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  return (high - low).norm();
}

/// The segment with as many control points as `degree` asks for.
RationalBezier raised(PathSegment segment, int degree) {
  if (segment.weight == 1.0) {
    Bezier bezier = std::move(segment);
    while (bezier.degree() < degree) bezier = elevated(bezier);
    std::vector<double> ones(bezier.points.size(), 1.0);
    return RationalBezier(degree, false, std::move(bezier.points), std::move(ones));
  }
  RationalBezier conic(2, false, std::move(segment.points), {1.0, segment.weight, 1.0});
  while (conic.degree() < degree) conic = elevated(conic);
  return conic;
}

bool isPoint(const Bezier& segment) {
  return std::all_of(segment.points.begin(), segment.points.end(),
                     [&](const Vec2& p) { return p == segment.points.front(); });
}

}  // namespace

std::vector<Subpath> subpathsFromSvg(std::string_view text, const std::string& source,
                                     const std::string& place) {
  return PathReader(text, source, place).read();
}

std::vector<PathSegment> conicsOfArc(const Vec2& from, const Vec2& to, const SvgArc& arc) {
  if (from == to) return {};
  double rx = std::abs(arc.radii.x()), ry = std::abs(arc.radii.y());
  if (rx == 0.0 || ry == 0.0) return {PathSegment({from, to})};
  const double phi = std::fmod(arc.rotationDeg, 360.0) * std::numbers::pi / 180.0;
  const Vec2 along(std::cos(phi), std::sin(phi));
  const Vec2 across = rotateCcw(along);

  // In the frame that makes the ellipse a unit circle, half the chord.
  const Vec2 half = 0.5 * (from - to);
  Vec2 h(half.dot(along) / rx, half.dot(across) / ry);
  const double reach = h.norm();
  if (reach > 1.0) {
    rx *= reach;
    ry *= reach;
    h /= reach;
  }
  // The centre lies on the perpendicular of the chord, on the side the flags say.
  const double chordSq = h.squaredNorm();
  double aside = chordSq >= 1.0 ? 0.0 : std::sqrt((1.0 - chordSq) / chordSq);
  if (arc.large == arc.sweep) aside = -aside;
  const Vec2 c = aside * Vec2(h.y(), -h.x());
  const Vec2 first = h - c, last = -h - c;  // unit vectors from the centre
  double turn = std::atan2(cross(first, last), first.dot(last));
  if (arc.sweep && turn < 0.0) turn += 2.0 * std::numbers::pi;
  if (!arc.sweep && turn > 0.0) turn -= 2.0 * std::numbers::pi;

  const auto place = [&](const Vec2& unit) -> Vec2 {
    return unit.x() * rx * along + unit.y() * ry * across;
  };
  const Vec2 centre = 0.5 * (from + to) + place(c);
  const double most = kMostDegPerConic * std::numbers::pi / 180.0;
  // A little room, so that a quarter is one segment whatever its rounding.
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / most - 1e-9)));
  const double step = turn / count;
  const double begin = std::atan2(first.y(), first.x());

  std::vector<PathSegment> conics;
  Vec2 a = first;
  Vec2 start = from;
  for (int i = 1; i <= count; ++i) {
    const double angle = begin + i * step;
    const Vec2 b = i == count ? last : Vec2(std::cos(angle), std::sin(angle));
    const Vec2 end = i == count ? to : Vec2(centre + place(b));
    // Where the tangents at the ends meet.
    const Vec2 middle = centre + place((a + b) / (1.0 + std::cos(step)));
    conics.push_back({{start, middle, end}, std::cos(0.5 * step)});
    a = b;
    start = end;
  }
  return conics;
}

std::optional<Curve> chainOf(const Subpath& subpath, ChainNotes& notes) {
  std::vector<PathSegment> segments = subpath.segments;
  notes.zeroLengthSegments += static_cast<int>(std::erase_if(segments, isPoint));
  if (segments.empty()) {
    ++notes.emptySubpaths;
    return std::nullopt;
  }
  const Vec2 start = segments.front().points.front();
  Vec2& end = segments.back().points.back();
  // A lone line that ends near its start is short, not closed.
  const bool mayMeet = segments.size() > 1 || segments.front().degree() > 1;
  bool closed = end == start;
  if (!closed && mayMeet && (end - start).norm() <= kSameEnd * sizeOf(segments)) {
    end = start;
    closed = true;
    ++notes.joinedEnds;
    if (isPoint(segments.back())) segments.pop_back();
  }
  if (subpath.closed && !closed) {
    const Vec2 last = segments.back().points.back();
    segments.push_back(PathSegment({last, start}));
    closed = true;
  }

  int degree = 1;
  bool hasArcs = false;
  for (const PathSegment& segment : segments) {
    degree = std::max(degree, segment.degree());
    hasArcs = hasArcs || segment.weight != 1.0;
  }
  std::vector<Vec2> points;
  std::vector<double> weights;
  for (const PathSegment& segment : segments) {
    const RationalBezier piece = raised(segment, degree);
    points.insert(points.end(), piece.points().begin(), piece.points().end() - 1);
    weights.insert(weights.end(), piece.weights().begin(), piece.weights().end() - 1);
  }
  if (BezierChain::whyInvalid(degree, true, points.size())) closed = false;
  if (!closed) {
    points.push_back(segments.back().points.back());
    weights.push_back(1.0);
  }
  if (hasArcs) return RationalBezier(degree, closed, std::move(points), std::move(weights));
  return BezierChain(degree, closed, std::move(points));
}

}  // namespace flatland
