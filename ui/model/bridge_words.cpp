// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/bridge_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>

#include "ui/model/core_words.h"

namespace flatland::ui {

namespace {

struct BridgeWords {
  Q_DECLARE_TR_FUNCTIONS(Bridge)
};

/// Below it, t_A counts as in the plane: estimates of t_A are no better.
constexpr double kInPlaneDeg = 3.0;

QString lineWords(const LineAgreement& agreement, const QString& name) {
  std::size_t all = 0;
  for (const std::size_t count : agreement.linesBy) all += count;
  if (all == 0) return BridgeWords::tr("%1: none predicted").arg(name);
  QString text = BridgeWords::tr("%1: %2 of %3 predicted lines can be expected")
                     .arg(name)
                     .arg(agreement.lines)
                     .arg(all);
  if (agreement.lines == 0) return text;
  // Without a line found there is no distance to tell of.
  if (!std::isfinite(agreement.medianEdges)) return text + BridgeWords::tr("; none of them found");
  return text + BridgeWords::tr("; found %1 edges away (median), %2 % covered")
                    .arg(shortWords(agreement.medianEdges), shortWords(100.0 * agreement.coverage));
}

}  // namespace

QString asSentence(const QString& words) {
  if (words.isEmpty()) return words;
  return words.left(1).toUpper() + words.mid(1) + (words.endsWith('.') ? "" : ".");
}

QString shortWords(double value) { return QLocale().toString(value, 'g', 3); }

QStringList agreementWords(const BridgeView& bridge) {
  if (!bridge.prediction.flat().view) return {};
  const BridgeRow& row = bridge.row;
  QStringList lines{
      lineWords(row.ridges, BridgeWords::tr("Apparent ridges")),
      lineWords(row.contours, BridgeWords::tr("Contours")),
      BridgeWords::tr("%1 cells, edges %2 long").arg(row.cells).arg(shortWords(row.edge))};
  for (std::size_t k = 1; k < kBridgeLimitCount; ++k) {
    const std::size_t count = row.ridges.linesBy[k] + row.contours.linesBy[k];
    if (count == 0) continue;
    lines << BridgeWords::tr("%n left out: %1", nullptr, static_cast<int>(count))
                 .arg(coreWords(std::string(reasonOf(static_cast<BridgeLimit>(k)))));
  }
  return lines;
}

QStringList predictedWords(const BridgeView& bridge, std::size_t index) {
  const PredictedLine& line = bridge.prediction.lines()[index];
  const QString name = line.kind == MarkKind::ApparentRidge
                           ? BridgeWords::tr("Predicted apparent ridge")
                           : BridgeWords::tr("Predicted contour");
  QStringList words{BridgeWords::tr("%1, t = %2").arg(name, shortWords(line.t))};
  if (bridge.limits[index] != BridgeLimit::None) {
    words << coreWords(std::string(reasonOf(bridge.limits[index])));
  }
  return words;
}

QString pairWords(const SectionPair& pair) {
  if (!pair.offPlaneDeg) return BridgeWords::tr("There is no t_A here.");
  const QString angle = QLocale().toString(*pair.offPlaneDeg, 'f', 1);
  if (*pair.offPlaneDeg < kInPlaneDeg) {
    return BridgeWords::tr(
               "t_A leaves the plane by %1 degrees only: flatland's equation is nearly "
               "the surface's.")
        .arg(angle);
  }
  if (!pair.ridge) {
    return BridgeWords::tr(
               "t_A leaves the plane by %1 degrees: λ is largest along the section, but "
               "not along t_A.")
        .arg(angle);
  }
  if (!pair.mark) {
    return BridgeWords::tr(
               "t_A leaves the plane by %1 degrees: λ is largest along t_A, but not "
               "along the section.")
        .arg(angle);
  }
  return BridgeWords::tr(
             "t_A leaves the plane by %1 degrees: flatland follows λ along the section, "
             "the surface along t_A.")
      .arg(angle);
}

QStringList sectionWords(const SectionView& section) {
  const std::size_t curves = section.section.scene.curves.size();
  if (curves == 0) return {BridgeWords::tr("The plane does not cut the surface.")};
  QStringList lines{BridgeWords::tr("%n curve(s), at most %1 from the section (unit of the file)",
                                    nullptr, static_cast<int>(curves))
                        .arg(shortWords(section.section.maxDeviation))};
  if (!section.whyNoMarks.empty()) lines << asSentence(coreWords(section.whyNoMarks));
  return lines;
}

}  // namespace flatland::ui
