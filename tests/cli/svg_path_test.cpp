// SPDX-License-Identifier: GPL-3.0-or-later
// The grammar of SVG path data, arcs, and how a subpath becomes a chain.
#include "flatland/io/svg_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "flatland/curve/arc_length.h"
#include "flatland/io/input_error.h"
#include "tests/support/seed.h"

namespace flatland {
namespace {

// Of the radius: rounding, which a long thin ellipse of random ends magnifies.
constexpr double kArcError = 1e-10;

std::vector<Subpath> read(const std::string& text) { return subpathsFromSvg(text, "a.svg", "d"); }

/// A path spelled out: every subpath's segments with all their control points.
std::string spelled(const std::vector<Subpath>& subpaths) {
  std::string text;
  const auto number = [](double x) {
    std::string digits = std::to_string(std::round(x * 1e9) / 1e9 + 0.0);
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.back() == '.') digits.pop_back();
    return digits == "-0" ? std::string("0") : digits;
  };
  for (const Subpath& subpath : subpaths) {
    text += "[";
    for (const PathSegment& segment : subpath.segments) {
      for (const Vec2& p : segment.points) text += number(p.x()) + "," + number(p.y()) + " ";
      text.back() = ';';
    }
    text += subpath.closed ? "z]" : "]";
  }
  return text;
}

TEST(SvgPath, EveryCommand) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", ""},
      {" \n ", ""},
      {"M1 2", "[]"},
      {"M1 2L3 4", "[1,2 3,4;]"},
      {"m1 2l3 4", "[1,2 4,6;]"},
      {"M1 2H5V7", "[1,2 5,2;5,2 5,7;]"},
      {"M1 2h5v7", "[1,2 6,2;6,2 6,9;]"},
      {"M1 2h5 6", "[1,2 6,2;6,2 12,2;]"},
      {"M1 2C3 4 5 6 7 8", "[1,2 3,4 5,6 7,8;]"},
      {"M1 2c3 4 5 6 7 8", "[1,2 4,6 6,8 8,10;]"},
      {"M1 2Q3 4 5 6", "[1,2 3,4 5,6;]"},
      {"M1 2q3 4 5 6", "[1,2 4,6 6,8;]"},
      // S and T mirror the handle of their own kind only; after another the point itself.
      {"M0 0C1 1 2 3 4 4S6 7 8 8", "[0,0 1,1 2,3 4,4;4,4 6,5 6,7 8,8;]"},
      {"M0 0c1 1 2 3 4 4s2 3 4 4", "[0,0 1,1 2,3 4,4;4,4 6,5 6,7 8,8;]"},
      {"M0 0S6 7 8 8", "[0,0 0,0 6,7 8,8;]"},
      {"M0 0Q1 2 3 4S6 7 8 8", "[0,0 1,2 3,4;3,4 3,4 6,7 8,8;]"},
      {"M0 0S6 7 8 8S1 1 2 2", "[0,0 0,0 6,7 8,8;8,8 10,9 1,1 2,2;]"},
      {"M0 0Q1 2 3 4T8 8", "[0,0 1,2 3,4;3,4 5,6 8,8;]"},
      {"M0 0q1 2 3 4t5 4t1 1", "[0,0 1,2 3,4;3,4 5,6 8,8;8,8 11,10 9,9;]"},
      {"M0 0T8 8T9 9", "[0,0 0,0 8,8;8,8 16,16 9,9;]"},
      {"M0 0C1 1 2 3 4 4T8 8", "[0,0 1,1 2,3 4,4;4,4 4,4 8,8;]"},
      // Pairs after M are lines, absolute or relative as the M.
      {"M1 2 3 4 5 6", "[1,2 3,4;3,4 5,6;]"},
      {"m1 2 3 4 5 6", "[1,2 4,6;4,6 9,12;]"},
      {"M1 2L3 4M5 6L7 8", "[1,2 3,4;][5,6 7,8;]"},
      {"M1 2L3 4m5 6l7 8", "[1,2 3,4;][8,10 15,18;]"},
      // After Z the point is the start again, with or without M.
      {"M1 2L3 4L5 0Z", "[1,2 3,4;3,4 5,0;z]"},
      {"M1 2L3 4Zl1 1", "[1,2 3,4;z][1,2 2,3;]"},
      {"M1 2l2 2zm1 1l1 1z", "[1,2 3,4;z][2,3 3,4;z]"},
      {"M1 2zz", "[z]"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(spelled(read(text)), expected) << text;
}

TEST(SvgPath, NumbersRunTogether) {
  const std::vector<std::pair<std::string, std::string>> same{
      {"M1-2.5.5e-3-4", "M 1 -2.5 L .0005 -4"},
      {"M.5.5.25.75", "M 0.5,0.5 L 0.25,0.75"},
      {"M+1+2-3-4", "M 1 2 L -3 -4"},
      {"M1.,2.l3.-4.", "M 1 2 L 4 -2"},
      {"M1e1,1E+1L1e-1-1", "M 10 10 L 0.1 -1"},
      {"M1,2,3,4", "M 1 2 L 3 4"},
      {"M\t1\n,\r2\f3 ,4", "M 1 2 L 3 4"},
      {"M1 2l1e-400 0", "M1 2l0 0"},
      {"M0 0a1 1 0 0110 1", "M 0 0 a 1 1 0 0 1 10 1"},
      {"M0 0a1 1 0 01.5.5", "M 0 0 a 1 1 0 0 1 0.5 0.5"},
      {"M0 0a1,1,0,1,1-1-1", "M 0 0 a 1 1 0 1 1 -1 -1"},
      {"M0 0a2 1 30 00-1 1 2 1 30 112 2", "M0 0a2 1 30 0 0 -1 1 a 2 1 30 1 1 2 2"},
  };
  for (const auto& [compact, spaced] : same) {
    EXPECT_EQ(spelled(read(compact)), spelled(read(spaced))) << compact;
    EXPECT_NE(spelled(read(compact)), "") << compact;
  }
}

TEST(SvgPath, ErrorsSayCharacterAndReason) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"L1 2", "character 1: a path begins with M or m, found 'L'"},
      {"Z", "character 1: a path begins with M or m, found 'Z'"},
      {"M1", "character 3: expected a number, found the end"},
      {"M1 2L", "character 6: expected a number, found the end"},
      {"M1 2L3", "character 7: expected a number, found the end"},
      {"M1 2x", "character 5: expected a path command, found 'x'"},
      {"M1 2L3 4,", "character 10: expected a number after the comma, found the end"},
      {"M1 2L3 4,Z", "character 10: expected a number after the comma, found 'Z'"},
      {"M1,,2", "character 4: expected a number, found ','"},
      {"M,1 2", "character 2: expected a number, found ','"},
      {"M1 2C1 2 3 4 5", "character 15: expected a number, found the end"},
      {"M1 2C1 2 3 4", "character 13: expected a number, found the end"},
      {"M1 2h-", "character 6: expected a number, found '-'"},
      {"M1 2h.", "character 6: expected a number, found '.'"},
      {"M1 2h1e999", "character 6: the number 1e999 is too large"},
      {"M1 2hinf", "character 6: expected a number, found 'i'"},
      {"M0 0a1 1 0 2 1 3 3", "character 12: expected a flag, 0 or 1, found '2'"},
      {"M0 0a1 1 0 1", "character 13: expected a flag, 0 or 1, found the end"},
      {"M0 0 \xc3\xa9", "character 6: expected a path command, found '\xc3\xa9'"},
      {"M0 0 \xff", "character 6: expected a path command, found the byte 255"},
      {"M0 0Z1 2", "character 6: expected a path command, found '1'"},
  };
  for (const auto& [text, expected] : cases) {
    try {
      read(text);
      ADD_FAILURE() << text << " was read";
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()), "a.svg: d, " + expected) << text;
    }
  }
}

TEST(SvgPath, TooManySegmentsAreRefused) {
  std::string text = "M0 0L";
  for (std::size_t i = 0; i <= kMostSvgSegments; ++i) text += "1 1 ";
  EXPECT_THROW(read(text), InputError);
}

struct Ellipse {
  Vec2 centre, radii;
  double rotation;

  Vec2 toUnit(const Vec2& p) const {
    const Vec2 d = p - centre;
    const double c = std::cos(rotation), s = std::sin(rotation);
    return {(d.x() * c + d.y() * s) / radii.x(), (-d.x() * s + d.y() * c) / radii.y()};
  }
  Vec2 at(double angle) const {
    const double c = std::cos(rotation), s = std::sin(rotation);
    const double x = radii.x() * std::cos(angle), y = radii.y() * std::sin(angle);
    return centre + Vec2(c * x - s * y, s * x + c * y);
  }
};

Vec2 pointOn(const PathSegment& conic, double t) {
  const double a = (1 - t) * (1 - t), b = 2 * t * (1 - t) * conic.weight, c = t * t;
  return (a * conic.points.at(0) + b * conic.points.at(1) + c * conic.points.at(2)) / (a + b + c);
}

// Builds the arc from its ellipse, so the answer is known before the question: the inverse of what
// the program computes.
TEST(SvgPath, ArcsLieOnTheirEllipse) {
  test::Random random(test::announcedSeed("svg arcs", 7));
  for (int i = 0; i < 500; ++i) {
    const Ellipse ellipse{{test::uniform(random, -50, 50), test::uniform(random, -50, 50)},
                          {test::uniform(random, 0.1, 20), test::uniform(random, 0.1, 20)},
                          test::uniform(random, -7, 7)};
    const double from = test::uniform(random, -3, 3);
    double turn = test::uniform(random, 0.05, 6.2);
    if (i % 2) turn = -turn;
    const SvgArc arc{(i % 3 ? 1.0 : -1.0) * ellipse.radii,
                     ellipse.rotation * 180 / std::numbers::pi, std::abs(turn) > std::numbers::pi,
                     turn > 0};
    const Vec2 start = ellipse.at(from), end = ellipse.at(from + turn);
    const std::vector<PathSegment> conics = conicsOfArc(start, end, arc);
    ASSERT_FALSE(conics.empty());
    EXPECT_EQ(conics.size(), std::ceil(std::abs(turn) * 2 / std::numbers::pi)) << i;
    EXPECT_EQ(conics.front().points.front(), start);
    EXPECT_EQ(conics.back().points.back(), end);
    double walked = 0.0, last = from;
    for (std::size_t c = 0; c < conics.size(); ++c) {
      if (c > 0) {
        EXPECT_EQ(conics[c].points.front(), conics[c - 1].points.back());
      }
      for (int k = 0; k <= 8; ++k) {
        const Vec2 unit = ellipse.toUnit(pointOn(conics[c], k / 8.0));
        EXPECT_NEAR(unit.norm(), 1.0, kArcError) << i;
        const double angle = std::atan2(unit.y(), unit.x());
        const double step = std::remainder(angle - last, 2 * std::numbers::pi);
        EXPECT_GE(step * (turn > 0 ? 1 : -1), -1e-9) << i;
        walked += step;
        last = angle;
      }
    }
    // From the start to the end the right way round: the sweep and the large flag were obeyed.
    EXPECT_NEAR(walked, turn, 1e-8) << i;
  }
}

TEST(SvgPath, ArcOutOfTheOrdinary) {
  // Too short to reach: scaled up until the ends are opposite each other.
  const std::vector<PathSegment> half = conicsOfArc({0, 0}, {10, 0}, {{1, 1}, 0, false, true});
  for (const PathSegment& conic : half) {
    for (int k = 0; k <= 4; ++k) {
      EXPECT_NEAR((pointOn(conic, k / 4.0) - Vec2(5, 0)).norm(), 5.0, 1e-14);
    }
  }
  // y points down in a drawing: sweep goes from -x over -y to +x.
  EXPECT_LT(half[half.size() / 2].points[0].y(), -4.9);
  EXPECT_EQ(spelled({{Vec2(0, 0), conicsOfArc({0, 0}, {3, 4}, {{0, 5}, 9, true, true}), false}}),
            "[0,0 3,4;]");
  EXPECT_TRUE(conicsOfArc({1, 2}, {1, 2}, {{3, 4}, 0, true, true}).empty());
  EXPECT_EQ(spelled(read("M1 2A3 4 0 1 1 1 2")), "[1,2 1,2;]");
  // Extreme but finite stays finite.
  for (const PathSegment& conic :
       conicsOfArc({0, 0}, {1e-30, 0}, {{1e30, 1e-30}, 1e9, true, false})) {
    for (const Vec2& p : conic.points) EXPECT_TRUE(p.allFinite());
  }
}

BezierChain chain(const std::string& text, ChainNotes& notes) {
  return std::get<BezierChain>(*chainOf(read(text).front(), notes));
}

TEST(SvgPath, ArcsAmongOthersStayExact) {
  ChainNotes notes;
  // A cubic, three quarters of a circle of radius 2 around (4, 2), a line.
  const auto curve = std::get<RationalBezier>(
      *chainOf(read("M0 0C1 2 3 -2 4 0A2 2 0 1 1 2 2L0 5z").front(), notes));
  EXPECT_EQ(curve.degree(), 3);
  ASSERT_EQ(curve.pieceCount(), 6);
  const Bezier cubic{{{0, 0}, {1, 2}, {3, -2}, {4, 0}}};
  for (int k = 0; k <= 10; ++k) {
    const double t = k / 10.0;
    EXPECT_LT((derivativesAt(curve, 0, t)[0] - pointAt(cubic, t)).norm(), 1e-15);
    for (int piece = 1; piece <= 3; ++piece) {
      const auto d = derivativesAt(curve, piece, t);
      EXPECT_NEAR((d[0] - Vec2(4, 2)).norm(), 2.0, 1e-14);
      EXPECT_NEAR(cross(d[1], d[2]) / std::pow(d[1].norm(), 3), 0.5, 1e-13);
    }
    EXPECT_LT((derivativesAt(curve, 4, t)[0] - Vec2(2 - 2 * t, 2 + 3 * t)).norm(), 1e-14);
  }
}

TEST(SvgPath, ChainsOfTheLowestDegree) {
  ChainNotes notes;
  const BezierChain triangle = chain("M0 0L4 0L0 3Z", notes);
  EXPECT_EQ(triangle, BezierChain(1, true, {{0, 0}, {4, 0}, {0, 3}}));
  // The start repeated before Z is the same triangle, not one with a side of no length.
  EXPECT_EQ(chain("M0 0L4 0L0 3L0 0Z", notes), triangle);
  EXPECT_EQ(chain("M0 0L4 0L0 3L0 0", notes), triangle);
  EXPECT_EQ(notes.zeroLengthSegments + notes.joinedEnds + notes.emptySubpaths, 0);
  EXPECT_EQ(chain("M0 0L4 0L0 3", notes), BezierChain(1, false, {{0, 0}, {4, 0}, {0, 3}}));
  EXPECT_EQ(chain("M0 0L4 0Q4 4 0 4", notes).degree(), 2);
  EXPECT_EQ(chain("M0 0Q4 4 0 4C1 2 3 4 5 6", notes).degree(), 3);
  // A line there and back encloses nothing, but is closed: two pieces.
  EXPECT_EQ(chain("M0 0L4 0Z", notes), BezierChain(1, true, {{0, 0}, {4, 0}}));
}

TEST(SvgPath, RaisedSegmentsKeepTheirPoints) {
  ChainNotes notes;
  const Subpath subpath = read("M0 0L4 1Q6 4 2 5C1 4 3 9 -2 7").front();
  const auto raised = std::get<BezierChain>(*chainOf(subpath, notes));
  ASSERT_EQ(raised.pieceCount(), 3);
  for (int piece = 0; piece < 3; ++piece) {
    for (int k = 0; k <= 10; ++k) {
      const Vec2 expected = pointAt(subpath.segments[static_cast<std::size_t>(piece)], k / 10.0);
      EXPECT_LT((pointAt(raised.piece(piece), k / 10.0) - expected).norm(), 1e-14);
    }
  }
}

TEST(SvgPath, NothingIsDroppedInSilence) {
  ChainNotes notes;
  EXPECT_EQ(chain("M0 0L0 0L4 0C4 0 4 0 4 0L0 3", notes),
            BezierChain(1, false, {{0, 0}, {4, 0}, {0, 3}}));
  EXPECT_EQ(notes.zeroLengthSegments, 2);
  EXPECT_FALSE(chainOf(read("M3 3").front(), notes));
  EXPECT_FALSE(chainOf(read("M3 3L3 3Z").front(), notes));
  EXPECT_EQ(notes.emptySubpaths, 2);
  EXPECT_EQ(notes.zeroLengthSegments, 3);
}

TEST(SvgPath, EndsThatMissByRoundingMeet) {
  ChainNotes notes;
  // Six digits: the sum of the steps misses the start by 1e-6 of a drawing 10 units across.
  const BezierChain met = chain("m0 0 10 0 0 7 -9.999999 -7", notes);
  EXPECT_EQ(met, BezierChain(1, true, {{0, 0}, {10, 0}, {10, 7}}));
  EXPECT_EQ(notes.joinedEnds, 1);
  // A visible gap stays a gap; Z closes it by a line.
  EXPECT_FALSE(chain("M0 0L10 0L10 7L0.01 0", notes).closed());
  EXPECT_EQ(chain("M0 0L10 0L10 7L0.01 0Z", notes).pieceCount(), 4);
  EXPECT_EQ(notes.joinedEnds, 1);
  // Short is not closed.
  EXPECT_FALSE(chain("M1000000 0L1000000.001 0", notes).closed());
}

}  // namespace
}  // namespace flatland
