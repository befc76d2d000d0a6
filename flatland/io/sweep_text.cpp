// SPDX-License-Identifier: MIT
#include "flatland/io/sweep_text.h"

#include <string_view>

#include "flatland/io/number_text.h"

namespace flatland {

namespace {

std::string_view nameOf(SweepEvent::What what) {
  switch (what) {
    case SweepEvent::What::Fold:
      return "fold";
    case SweepEvent::What::MeetsSilhouette:
      return "meets-silhouette";
    case SweepEvent::What::HeadOn:
      return "head-on";
  }
  return "";
}

std::string row(std::string_view what, std::string_view kind, int curve, const std::string& branch,
                const std::string& angle, double t, double u) {
  return std::string(what) + ',' + std::string(kind) + ',' + std::to_string(curve) + ',' + branch +
         ',' + angle + ',' + numberText(t) + ',' + numberText(u) + "\r\n";
}

}  // namespace

std::string sweepToCsv(const Sweep& sweep) {
  std::string text = "what,kind,curve,branch,angleDeg,t,u\r\n";
  for (const SweepLine& line : sweep.lines) {
    text += row("line", flatland::nameOf(line.kind), line.curve, "", "", line.t, line.u);
  }
  for (std::size_t i = 0; i < sweep.branches.size(); ++i) {
    const SweepBranch& branch = sweep.branches[i];
    for (const SweepPoint& point : branch.points) {
      text += row("branch", flatland::nameOf(branch.kind), branch.curve, std::to_string(i),
                  numberText(point.angleDeg), point.t, point.u);
    }
  }
  for (const SweepEvent& event : sweep.events) {
    text +=
        row(nameOf(event.what), "", event.curve, "", numberText(event.angleDeg), event.t, event.u);
  }
  return text;
}

}  // namespace flatland
