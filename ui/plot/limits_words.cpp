// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/limits_words.h"

#include <QCoreApplication>

namespace flatland::ui {

namespace {

struct LimitsWords {
  Q_DECLARE_TR_FUNCTIONS(LimitsWords)
};

}  // namespace

QString nameForPeople(LimitQuantity quantity) {
  switch (quantity) {
    case LimitQuantity::Lambda:
      return LimitsWords::tr("λ");
    case LimitQuantity::Feature:
      return LimitsWords::tr("|feature|");
    case LimitQuantity::Offset:
      return LimitsWords::tr("|offset|");
    case LimitQuantity::Ratio:
      return LimitsWords::tr("|offset| / |feature|");
    case LimitQuantity::RidgeDistance:
      return LimitsWords::tr("apparent ridge to the merging");
    case LimitQuantity::SilhouetteDistance:
      break;
  }
  return LimitsWords::tr("silhouette to the merging");
}

QString xNameForPeople(LimitExperiment experiment) {
  switch (experiment) {
    case LimitExperiment::Turn:
      return LimitsWords::tr("|n·w|");
    case LimitExperiment::Walk:
      return LimitsWords::tr("arc length to the silhouette");
    case LimitExperiment::Slide:
      break;
  }
  return LimitsWords::tr("angle to the merging, radians");
}

QString explanationOf(LimitCase limitCase) {
  switch (limitCase) {
    case LimitCase::FixedPoint:
      return LimitsWords::tr(
          "λ = k²/(n·w)²: slope −2. The feature term falls with n·w, the offset term stays. "
          "At n·w = 0 the equation is singular and says nothing, but λ grows without bound "
          "towards it: its supremum lies there, and the silhouette is drawn as such.");
    case LimitCase::OrdinarySilhouette:
      return LimitsWords::tr(
          "n·w falls as k s, and k cancels: λ = 1/s², whatever the curvature. The feature "
          "term vanishes with s, the offset term does not: near a silhouette there is no "
          "apparent ridge.");
    case LimitCase::SilhouetteAtInflection:
      return LimitsWords::tr(
          "k and n·w vanish together: k as s, n·w as s². λ = 4/s², four times as fast as at "
          "an ordinary silhouette, and the offset term is twice the feature term.");
    case LimitCase::HigherContact:
      return LimitsWords::tr(
          "k vanishes as a power m of s, n·w as the power m + 1: λ = (m + 1)²/s².");
    case LimitCase::CuspSeenAcross:
      return LimitsWords::tr(
          "At a cusp k grows as 1/√s while n·w does not vanish: λ grows as 1/s only.");
    case LimitCase::CuspSeenAlong:
      return LimitsWords::tr(
          "At a cusp that points along the line of sight k grows as 1/√s and n·w falls as "
          "√s: λ = 1/(4 s²).");
    case LimitCase::Merging:
      break;
  }
  return LimitsWords::tr(
      "Seen along the tangent of an inflection, two apparent ridges meet and leave as two "
      "silhouettes. On both sides their distance is √(2 angle / |k′|): slope 1/2.");
}

}  // namespace flatland::ui
