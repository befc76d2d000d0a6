// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/export_key.h"

#include <QApplication>
#include <QWidget>

#include "ui/model/document.h"

namespace flatland::ui {

ExportKey::ExportKey(const Document& document, QWidget& curves, QWidget& surface,
                     QAction& exportCurves, QAction& exportSurface, QObject* window)
    : QObject(window),
      document_(document),
      curves_(curves),
      surface_(surface),
      exportCurves_(exportCurves),
      exportSurface_(exportSurface) {
  connect(qApp, &QApplication::focusChanged, this,
          [this](const QWidget*, const QWidget* now) { follow(now); });
  connect(&document_, &Document::changed, this, &ExportKey::show);
  show();
}

void ExportKey::follow(const QWidget* focus) {
  // Panels and menus are about either; the view before them counts.
  if (focus == nullptr) return;
  if (focus == &curves_ || curves_.isAncestorOf(focus)) isSurface_ = false;
  if (focus == &surface_ || surface_.isAncestorOf(focus)) isSurface_ = true;
  show();
}

void ExportKey::show() {
  const bool toSurface = isSurface_ && document_.scene().surface.has_value();
  const QKeySequence key(Qt::CTRL | Qt::Key_E);
  // Never both at once: a key of two actions does nothing.
  (toSurface ? exportCurves_ : exportSurface_).setShortcut({});
  (toSurface ? exportSurface_ : exportCurves_).setShortcut(key);
}

}  // namespace flatland::ui
