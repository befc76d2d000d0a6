// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/flat/scene_summary.h"

#include <QCoreApplication>
#include <QStringList>
#include <array>

#include "ui/export/mark_style.h"
#include "ui/model/mark_words.h"

namespace flatland::ui {

namespace {

struct SceneSummaryWords {
  Q_DECLARE_TR_FUNCTIONS(SceneSummary)
};

}  // namespace

QString sceneSummary(const Document& document) {
  const Scene& scene = document.scene();
  std::size_t points = 0;
  for (const SceneCurve& curve : scene.curves) points += controlPoints(curve.shape).size();
  QString text =
      SceneSummaryWords::tr("%n curves", nullptr, static_cast<int>(scene.curves.size())) + ", " +
      SceneSummaryWords::tr("%n control points", nullptr, static_cast<int>(points)) + ". ";
  text += SceneSummaryWords::tr("Seen from %1°.").arg(scene.view.angleDeg, 0, 'f', 1);
  std::array<int, kMarkKindCount> counts{};
  int hidden = 0;
  for (const Mark& mark : document.features().marks) {
    ++counts[static_cast<std::size_t>(mark.kind)];
    if (!mark.visible) ++hidden;
  }
  QStringList parts;
  for (const MarkKind kind : markKindsInLegendOrder()) {
    const int count = counts[static_cast<std::size_t>(kind)];
    if (count > 0) parts << QStringLiteral("%1: %2").arg(pluralForPeople(kind)).arg(count);
  }
  if (!parts.isEmpty()) text += " " + parts.join("; ") + ".";
  if (hidden > 0) text += " " + SceneSummaryWords::tr("%n marks are hidden.", nullptr, hidden);
  return text;
}

}  // namespace flatland::ui
