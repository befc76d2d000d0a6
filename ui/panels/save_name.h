// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace flatland::ui {

/// True if there is no such file, or the person says it may be replaced.
bool mayReplace(QWidget* parent, const QString& name);

/// Asks for the name of a file to write; empty if the person thought better of it. A name without
/// a suffix gets the first one of the chosen filter, "SVG picture (*.svg)"; what is in the way of
/// the name so completed is asked about. Precondition: `filters` is not empty.
QString askSaveName(QWidget* parent, const QString& title, const QString& suggested,
                    const QStringList& filters);

}  // namespace flatland::ui
