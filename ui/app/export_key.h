// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QObject>

class QWidget;

namespace flatland::ui {

class Document;

/// Gives the key of exports to the action of the view that a person worked with last: the curves,
/// which have it at first and while there is no surface, or the surface.
class ExportKey : public QObject {
  Q_OBJECT

 public:
  /// All of it outlives this one, which belongs to the window.
  ExportKey(const Document& document, QWidget& curves, QWidget& surface, QAction& exportCurves,
            QAction& exportSurface, QObject* window);

 private:
  void follow(const QWidget* focus);
  void show();

  const Document& document_;
  QWidget &curves_, &surface_;
  QAction &exportCurves_, &exportSurface_;
  bool isSurface_ = false;
};

}  // namespace flatland::ui
