// SPDX-License-Identifier: GPL-3.0-or-later
// The colours of the marks as people with the three kinds of colour blindness see them.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "ui/export/line_style.h"
#include "ui/export/mark_style.h"

namespace flatland::ui {
namespace {

using Colour = Eigen::Vector3d;  // linear RGB, or CIE L*a*b*

Colour linear(Rgb c) {
  const auto channel = [](std::uint8_t value) {
    const double v = value / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return {channel(c.r), channel(c.g), channel(c.b)};
}

/// sRGB to XYZ under D65.
const Eigen::Matrix3d kToXyz = (Eigen::Matrix3d() << 0.4124564, 0.3575761, 0.1804375, 0.2126729,
                                0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041)
                                   .finished();

Colour labOf(const Colour& rgb) {
  const Colour white(0.95047, 1.0, 1.08883);
  Colour f = (kToXyz * rgb.cwiseMax(0.0).cwiseMin(1.0)).cwiseQuotient(white);
  for (double& x : f) x = x > 216.0 / 24389.0 ? std::cbrt(x) : (24389.0 / 27.0 * x + 16.0) / 116.0;
  return {116.0 * f.y() - 16.0, 500.0 * (f.x() - f.y()), 200.0 * (f.y() - f.z())};
}

struct Vision {
  const char* name;
  Eigen::Matrix3d seen;  // of linear RGB
};

/// Machado, Oliveira and Fernandes 2009, severity 1.
std::vector<Vision> visions() {
  Eigen::Matrix3d protan, deutan, tritan;
  protan << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116,
      1.051998;
  deutan << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940,
      0.968881;
  tritan << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367,
      0.303900;
  return {{"usual", Eigen::Matrix3d::Identity()},
          {"protan", protan},
          {"deutan", deutan},
          {"tritan", tritan}};
}

double contrast(Rgb a, Rgb b) {
  const double x = (kToXyz * linear(a)).y();
  const double y = (kToXyz * linear(b)).y();
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

struct Ground {
  Palette palette;
  double least;  ///< distance in L*a*b*, of which 2.3 is just noticeable
};
// The nearest pair there is, rounded down; with symbol and letter beside it that is enough, and a
// new colour must not come nearer.
constexpr Ground kGrounds[] = {
    {Palette::Light, 14.0}, {Palette::Dark, 9.0}, {Palette::HighContrast, 7.5}};

TEST(Palettes, FamiliesStayApartInEveryKindOfColourBlindness) {
  for (const Ground& ground : kGrounds) {
    for (const Vision& vision : visions()) {
      for (const MarkKind a : markKindsInLegendOrder()) {
        for (const MarkKind b : markKindsInLegendOrder()) {
          if (a <= b) continue;
          const MarkStyle& first = styleOf(a, ground.palette);
          const MarkStyle& second = styleOf(b, ground.palette);
          EXPECT_NE(first.symbol, second.symbol);  // colour is never the only difference
          EXPECT_NE(first.dash, second.dash) << nameOf(a) << " " << nameOf(b);
          // A maximum and a minimum of the same thing share its colour and differ in filling.
          if (first.colour == second.colour) continue;
          const double distance = (labOf(vision.seen * linear(first.colour)) -
                                   labOf(vision.seen * linear(second.colour)))
                                      .norm();
          EXPECT_GE(distance, ground.least)
              << vision.name << ": " << nameOf(a) << ", " << nameOf(b);
        }
      }
    }
  }
}

// Grounds are white and near black: what is told apart there is told apart in the panel of lines.
TEST(Palettes, LineFamiliesDiffer) {
  constexpr int kLeastSum = 24;  // of differences of red, green and blue
  for (const Ground& ground : kGrounds) {
    for (const LineFamily a : allLineFamilies()) {
      for (const LineFamily b : allLineFamilies()) {
        // Outlines are contours, drawn as such.
        if (a >= b || a == LineFamily::ExteriorSilhouette) continue;
        const Rgb p = lineColour(a, ground.palette), q = lineColour(b, ground.palette);
        EXPECT_GE(std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b), kLeastSum)
            << nameOf(a) << ", " << nameOf(b);
      }
    }
  }
}

TEST(Palettes, StandOutFromTheirBackgrounds) {
  for (const Ground& ground : kGrounds) {
    const SceneColours& scene = sceneColours(ground.palette);
    EXPECT_GE(contrast(scene.text, scene.background), 7.0);
    EXPECT_GE(contrast(scene.curve, scene.background), 7.0);
    EXPECT_GE(contrast(scene.screen, scene.background), 3.0);
    for (const MarkKind kind : markKindsInLegendOrder()) {
      const MarkStyle& style = styleOf(kind, ground.palette);
      EXPECT_GE(contrast(style.letterColour, scene.background), 4.5) << nameOf(kind);
      // The orange of Okabe and Ito stays below 3 : 1 on white; its bars are the largest symbols,
      // its lines the widest, and its letters are dark.
      const bool orangeOnWhite =
          ground.palette == Palette::Light && style.colour == Rgb{0xE6, 0x9F, 0x00};
      EXPECT_GE(contrast(style.colour, scene.background), orangeOnWhite ? 2.2 : 3.0)
          << nameOf(kind);
    }
  }
}

TEST(Palettes, OnBlackASilhouetteIsNoContour) {
  const Rgb silhouette = lineColour(LineFamily::ExteriorSilhouette, Palette::HighContrast);
  const Rgb contour = lineColour(LineFamily::OccludingContours, Palette::HighContrast);
  EXPECT_GT(contrast(silhouette, sceneColours(Palette::HighContrast).background), 7.0);
  EXPECT_GT((labOf(linear(silhouette)) - labOf(linear(contour))).norm(), 20.0);
}

}  // namespace
}  // namespace flatland::ui
