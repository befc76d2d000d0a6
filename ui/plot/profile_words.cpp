// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/profile_words.h"

namespace flatland::ui {

QString titleOf(PlotKind kind) {
  switch (kind) {
    case PlotKind::Curvature:
      return ProfileWords::tr("Curvature k");
    case PlotKind::Lambda:
      return ProfileWords::tr("View-dependent curvature λ");
    case PlotKind::Terms:
      return ProfileWords::tr("Terms");
    case PlotKind::Ratio:
      break;
  }
  return ProfileWords::tr("|offset| / |feature|");
}

QString explanation(PlotKind kind) {
  switch (kind) {
    case PlotKind::Curvature:
      return ProfileWords::tr(
          "Curvature k, with dn/du = k t: positive where the curve bulges to the side of its "
          "normal. Peaks that would flatten the rest are cut off.");
    case PlotKind::Lambda:
      return ProfileWords::tr(
          "λ = |dn/di|² = k² / (n·w)², on a logarithmic axis: how fast the normal turns for a step "
          "on the screen, squared. Infinite at silhouettes, 0 at inflections.");
    case PlotKind::Terms:
      return ProfileWords::tr(
          "The terms of the apparent-ridge equation and their sum, which is (n·w)³/2 times the "
          "derivative of λ. The axis is that of asinh: linear near 0, logarithmic beyond, so that "
          "small and large values are both readable.");
    case PlotKind::Ratio:
      break;
  }
  return ProfileWords::tr(
      "Size of the offset term against the feature term, on a logarithmic axis. Above the line at "
      "1 the offset is the larger one.");
}

QString nameForPeople(ProfileQuantity quantity) {
  switch (quantity) {
    case ProfileQuantity::Curvature:
      return QStringLiteral("k");
    case ProfileQuantity::Lambda:
      return QStringLiteral("λ");
    case ProfileQuantity::Feature:
      return ProfileWords::tr("feature");
    case ProfileQuantity::Offset:
      return ProfileWords::tr("offset");
    case ProfileQuantity::Perspective:
      return ProfileWords::tr("perspective");
    case ProfileQuantity::Sum:
      return ProfileWords::tr("sum");
    case ProfileQuantity::Ratio:
      break;
  }
  return ProfileWords::tr("ratio");
}

}  // namespace flatland::ui
