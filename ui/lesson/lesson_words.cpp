// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lesson_words.h"

#include <QCoreApplication>
#include <QStringList>

namespace flatland::ui {

namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(LessonWords)
};

constexpr int kDigits = 6;
constexpr int kMatrixDigits = 3;  ///< so that four numbers stand on one line of the strip
constexpr int kMissDigits = 2;
constexpr qsizetype kMostLines = 12;
constexpr double kAgreement = 1e-12;  ///< residuals of rounding lie far below, misprints far above

QString plain(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())).toHtmlEscaped();
}

QString valueText(const StepValue& value) {
  QStringList rows;
  for (int r = 0; r < value.rows; ++r) {
    QStringList row;
    for (int c = 0; c < value.columns; ++c) {
      row << numberForPeople(value.entries[static_cast<std::size_t>(r * value.columns + c)],
                             value.columns > 1 ? kMatrixDigits : kDigits);
    }
    rows << row.join("&nbsp;&nbsp;");
  }
  return rows.size() == 1 ? rows.front() : "(" + rows.join("; ") + ")";
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
  const QString left = plain(printed ? text.printedLeft : text.left);
  const QString right = plain(printed ? text.printedRight : text.right);
  const bool agree = sides->residual < kAgreement;
  const QString verdict = agree
                              ? Words::tr("both sides agree")
                              : Words::tr("<b>%1 % apart</b>").arg(100.0 * sides->apart, 0, 'f', 1);
  return QStringLiteral(
             "<table cellspacing='0' style='white-space: "
             "nowrap'><tr><td>%1&nbsp;</td><td>=&nbsp;%2</td></tr>"
             "<tr><td>%3&nbsp;</td><td>=&nbsp;%4</td></tr>"
             "<tr><td>%5&nbsp;</td><td>%6</td></tr></table>")
      .arg(left, valueText(sides->left), right, valueText(sides->right),
           Words::tr("residual %1").arg(QString::number(sides->residual, 'e', 1)), verdict);
}

}  // namespace flatland::ui
