// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/core_words.h"

#include <QCoreApplication>

namespace flatland::ui {

namespace {

// Only for lupdate, which collects the words to translate. A test holds the list against what the
// libraries say.
[[maybe_unused]] constexpr const char* kListed[] = {
    // ui/export/flat_legend.cpp, mark_style.cpp
    QT_TRANSLATE_NOOP("Core", "seen from %1"),
    QT_TRANSLATE_NOOP("Core", "at distance %1"),
    QT_TRANSLATE_NOOP("Core", "paler: hidden"),
    QT_TRANSLATE_NOOP("Core", "Silhouette"),
    QT_TRANSLATE_NOOP("Core", "Inflection"),
    QT_TRANSLATE_NOOP("Core", "Ridge"),
    QT_TRANSLATE_NOOP("Core", "Valley"),
    QT_TRANSLATE_NOOP("Core", "Flat point"),
    QT_TRANSLATE_NOOP("Core", "Corner"),
    QT_TRANSLATE_NOOP("Core", "Apparent ridge"),
    QT_TRANSLATE_NOOP("Core", "Apparent minimum"),
    // flatland/scene/presets.cpp
    QT_TRANSLATE_NOOP("Core", "Thesis figure 3-4"),
    QT_TRANSLATE_NOOP("Core",
                      "Five control points, seen from the right: silhouettes, ridges, a valley, "
                      "inflections and apparent ridges on one curve."),
    QT_TRANSLATE_NOOP("Core", "Almost a circle"),
    QT_TRANSLATE_NOOP("Core",
                      "The four-piece circle of drawing programs: its curvature wavers by three "
                      "per cent, and so it has ridges that a circle has not."),
    QT_TRANSLATE_NOOP("Core", "S-curve"),
    QT_TRANSLATE_NOOP(
        "Core", "A cubic with one inflection; turn the view until the silhouettes meet in it."),
    QT_TRANSLATE_NOOP("Core", "Bump"),
    QT_TRANSLATE_NOOP("Core",
                      "A bump on a plain, seen from straight above: the foot of the bump shows "
                      "where the offset term moves an apparent ridge away from the ridge."),
    QT_TRANSLATE_NOOP("Core", "Cusp"),
    QT_TRANSLATE_NOOP("Core",
                      "A cubic whose speed vanishes at t = 1/2: the tangent turns back, a corner "
                      "of 180 degrees."),
    QT_TRANSLATE_NOOP("Core", "Loop"),
    QT_TRANSLATE_NOOP("Core",
                      "A curve that crosses itself and hides part of itself from the screen."),
};

}  // namespace

QString coreWords(const std::string& english) {
  return QCoreApplication::translate("Core", english.c_str());
}

}  // namespace flatland::ui
