// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/mark_words.h"

#include <QCoreApplication>

namespace flatland::ui {

namespace {

struct Words {
  const char* name;
  const char* plural;
  const char* explanation;
};

Words wordsOf(MarkKind kind) {
  switch (kind) {
    case MarkKind::Silhouette:
      return {QT_TRANSLATE_NOOP("MarkWords", "Silhouette"),
              QT_TRANSLATE_NOOP("MarkWords", "Silhouettes"),
              QT_TRANSLATE_NOOP("MarkWords", "The line of sight touches the curve.")};
    case MarkKind::Inflection:
      return {QT_TRANSLATE_NOOP("MarkWords", "Inflection"),
              QT_TRANSLATE_NOOP("MarkWords", "Inflections"),
              QT_TRANSLATE_NOOP("MarkWords", "The curvature changes sign.")};
    case MarkKind::Ridge:
      return {QT_TRANSLATE_NOOP("MarkWords", "Ridge"), QT_TRANSLATE_NOOP("MarkWords", "Ridges"),
              QT_TRANSLATE_NOOP("MarkWords",
                                "The curve bulges most to the side of its normal: a positive "
                                "maximum of curvature.")};
    case MarkKind::Valley:
      return {QT_TRANSLATE_NOOP("MarkWords", "Valley"), QT_TRANSLATE_NOOP("MarkWords", "Valleys"),
              QT_TRANSLATE_NOOP("MarkWords",
                                "The curve bulges most away from its normal: a negative minimum "
                                "of curvature.")};
    case MarkKind::Flat:
      return {
          QT_TRANSLATE_NOOP("MarkWords", "Flat point"),
          QT_TRANSLATE_NOOP("MarkWords", "Flat points"),
          QT_TRANSLATE_NOOP("MarkWords", "The curve is least curved here without being straight.")};
    case MarkKind::Corner:
      return {QT_TRANSLATE_NOOP("MarkWords", "Corner"), QT_TRANSLATE_NOOP("MarkWords", "Corners"),
              QT_TRANSLATE_NOOP("MarkWords", "The tangent jumps: a kink or a cusp.")};
    case MarkKind::ApparentRidge:
      return {QT_TRANSLATE_NOOP("MarkWords", "Apparent ridge"),
              QT_TRANSLATE_NOOP("MarkWords", "Apparent ridges"),
              QT_TRANSLATE_NOOP("MarkWords",
                                "The curvature as seen on the screen, \u03bb, has a maximum.")};
    case MarkKind::ApparentMinimum:
      break;
  }
  return {QT_TRANSLATE_NOOP("MarkWords", "Apparent minimum"),
          QT_TRANSLATE_NOOP("MarkWords", "Apparent minima"),
          QT_TRANSLATE_NOOP("MarkWords",
                            "The curvature as seen on the screen, \u03bb, has a minimum.")};
}

QString translated(const char* text) { return QCoreApplication::translate("MarkWords", text); }

}  // namespace

QString nameForPeople(MarkKind kind) { return translated(wordsOf(kind).name); }

QString pluralForPeople(MarkKind kind) { return translated(wordsOf(kind).plural); }

QString explanation(MarkKind kind) { return translated(wordsOf(kind).explanation); }

}  // namespace flatland::ui
