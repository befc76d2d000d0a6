// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include "ui/model/bridge_source.h"
#include "ui/model/section_source.h"

namespace flatland::ui {

// What the bridges between curves and surfaces have measured, in words for a person.

/// The first letter large, a full stop at the end.
QString asSentence(const QString& words);

/// How prediction and extraction agree, a line each for ridges and contours, and what is left out
/// and why.
QStringList agreementWords(const BridgeView& bridge);

/// A predicted line: what it is, where on the curve, and why it cannot be expected, if so.
QStringList predictedWords(const BridgeView& bridge, std::size_t line);

/// What keeps a pair apart: "t_A leaves the plane by 12.3 degrees: ...".
QString pairWords(const SectionPair& pair);

/// "3 curves, at most 0.001 from the section"; why there are no marks, if so.
QStringList sectionWords(const SectionView& section);

/// A number of 3 digits in the person's way of writing.
QString shortWords(double value);

}  // namespace flatland::ui
