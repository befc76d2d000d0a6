// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lesson_words.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <vector>

namespace flatland::ui {

namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(LessonWords)
};

constexpr int kDigits = 6;
constexpr int kMatrixDigits = 3;  ///< so that four numbers stand on one line of the strip
constexpr int kMissDigits = 2;
constexpr double kLeastPercent = 0.1;  ///< with one digit behind the point
constexpr qsizetype kMostLines = 12;
constexpr double kAgreement = 1e-12;  ///< residuals of rounding lie far below, misprints far above

QString plain(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())).toHtmlEscaped();
}

/// A side as it is shown, and what the shown digits say: who calculates with them must find the
/// difference that stands below.
struct ShownValue {
  QString text;
  std::vector<double> entries;
};

/// `noise`: entries below it are rounding, and have no digits to show.
ShownValue shownValue(const StepValue& value, double noise) {
  ShownValue shown;
  QStringList rows;
  for (int r = 0; r < value.rows; ++r) {
    QStringList row;
    for (int c = 0; c < value.columns; ++c) {
      const double entry = value.entries[static_cast<std::size_t>(r * value.columns + c)];
      const int digits = std::abs(entry) < noise ? 1 : value.columns > 1 ? kMatrixDigits : kDigits;
      shown.entries.push_back(QString::number(entry, 'g', digits).toDouble());
      row << numberForPeople(entry, digits);
    }
    rows << row.join("&nbsp;&nbsp;");
  }
  shown.text = rows.size() == 1 ? rows.front() : "(" + rows.join("; ") + ")";
  return shown;
}

struct ShownSides {
  ShownValue left, right;
  double size = 0.0;        ///< of the products both sides are sums of; 0 where unknown
  double exact = 0.0;       ///< left - right; of several entries the largest |left - right|
  double difference = 0.0;  ///< the same from the shown digits
  double reach = 0.0;       ///< the largest |left| + |right| of them
};

ShownSides shownSides(const StepSides& sides) {
  ShownSides shown;
  const bool isNumber = sides.left.count() == 1;
  for (std::size_t i = 0; i < static_cast<std::size_t>(sides.left.count()); ++i) {
    const double apart = sides.left.entries[i] - sides.right.entries[i];
    shown.exact = isNumber ? apart : std::max(shown.exact, std::abs(apart));
  }
  if (sides.residual > 0.0) shown.size = std::abs(shown.exact) / sides.residual;
  shown.left = shownValue(sides.left, kAgreement * shown.size);
  shown.right = shownValue(sides.right, kAgreement * shown.size);
  for (std::size_t i = 0; i < shown.left.entries.size(); ++i) {
    const double left = shown.left.entries[i], right = shown.right.entries[i];
    shown.difference = isNumber ? left - right : std::max(shown.difference, std::abs(left - right));
    shown.reach = std::max(shown.reach, std::abs(left) + std::abs(right));
  }
  return shown;
}

QString differenceText(const StepSides& sides, const ShownSides& shown) {
  if (sides.residual < kAgreement) {
    return Words::tr("%1: rounding, both sides agree").arg(numberForPeople(shown.exact, 1));
  }
  // Where digits that are not shown make the difference, the exact one.
  const bool isSeen = shown.difference != 0.0;
  const double share = isSeen ? std::abs(shown.difference) / shown.reach : sides.apart;
  const double hundredths = 100.0 * share;
  const QString percent = hundredths < kLeastPercent ? numberForPeople(hundredths, 2)
                                                     : QString::number(hundredths, 'f', 1);
  const bool isNumber = sides.left.count() == 1;
  const QString number = numberForPeople(isSeen ? shown.difference : shown.exact,
                                         isNumber ? kDigits : kMatrixDigits + 1);
  QString sum = Words::tr("|left| + |right|");
  constexpr QChar kWordJoiner(0x2060);
  sum.replace('|', kWordJoiner + QStringLiteral("|") + kWordJoiner).replace(' ', QChar(0xa0));
  return (isNumber ? Words::tr("%1: <b>%2 % of %3</b>")
                   : Words::tr("%1: <b>%2 % of the largest %3</b>"))
      .arg(number, percent, sum);
}

QString whyNot(StepAnswer answer) {
  switch (answer) {
    case StepAnswer::NoTangent:
      return Words::tr(
          "A cusp: the curve has no tangent here, so there is no normal. Move the probe.");
    case StepAnswer::Silhouette:
      return Words::tr(
          "A silhouette: n·j = 0. Nothing can be differentiated by the screen coordinate here; λ "
          "has "
          "no finite value.");
    case StepAnswer::NoNormal:
      return Words::tr("The normal is unknown here.");
    case StepAnswer::NoDirection:
      return Words::tr(
          "Seen from here the surface bends alike in all directions, or not at all: there is no "
          "t_A.");
    case StepAnswer::Evaluated:
      break;
  }
  return {};
}

QString missText(const PrintedRoot& root) {
  return Words::tr("%1 (%2 % of the curve)")
      .arg(numberForPeople(*root.alongToApparentRidge, kMissDigits),
           numberForPeople(100.0 * *root.shareToApparentRidge, kMissDigits));
}

}  // namespace

QString missesForPeople(const PrintedRoots& printed) {
  if (printed.roots.empty()) return Words::tr("(3.13) as printed has no roots here");
  const QString count = Words::tr("Printed roots at a maximum of λ: %1 of %2")
                            .arg(printed.maxima())
                            .arg(printed.roots.size());
  const PrintedRoot* nearest = printed.nearest();
  if (!nearest) return count + Words::tr("; no apparent ridge on their curve");
  const PrintedRoot* farthest = printed.farthest();
  if (printed.roots.size() == 1) {
    return count + Words::tr("; off the nearest apparent ridge by %1").arg(missText(*nearest));
  }
  return count + Words::tr("; off the nearest apparent ridge by %1 at best, %2 at worst")
                     .arg(missText(*nearest), missText(*farthest));
}

QString eachMissForPeople(const PrintedRoots& printed) {
  QStringList lines;
  for (const PrintedRoot& root : printed.roots) {
    if (lines.size() == kMostLines) return lines.join('\n') + QStringLiteral("\n…");
    lines << (root.alongToApparentRidge
                  ? Words::tr("at arc length %1: off the nearest apparent ridge by %2")
                        .arg(numberForPeople(root.u, kDigits), missText(root))
                  : Words::tr("at arc length %1: no apparent ridge on the curve")
                        .arg(numberForPeople(root.u, kDigits)));
  }
  return lines.join('\n');
}

QString numberForPeople(double value, int digits) {
  return QString::number(value, 'g', digits).replace('-', QChar(0x2212));
}

QString valuesForPeople(const DerivationStepText& text, const std::optional<StepReading>& reading,
                        bool printed) {
  if (!reading) return Words::tr("Point at the curve to see the values there.");
  const auto& sides = printed ? reading->printed : reading->corrected;
  if (!sides) return whyNot(reading->answer);
  const ShownSides shown = shownSides(*sides);
  const auto row = [](const QString& name, const QString& value) {
    return QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td>=&nbsp;%2</td></tr>").arg(name, value);
  };
  return "<table cellspacing='0'>" +
         row(plain(printed ? text.printedLeft : text.left), shown.left.text) +
         row(plain(printed ? text.printedRight : text.right), shown.right.text) +
         row(sides->left.count() == 1 ? Words::tr("left − right")
                                      : Words::tr("largest |left − right|"),
             differenceText(*sides, shown)) +
         "</table>";
}

}  // namespace flatland::ui
