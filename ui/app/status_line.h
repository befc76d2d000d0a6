// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "ui/model/document.h"

class QLabel;
class QMenu;
class QStatusBar;
class QToolButton;

namespace flatland::ui {

/// The line at the bottom: what a drag would do now, where the pointer is, the view angle, whether
/// all marks are certified, and how long they took. Says when ridges and valleys exchange names.
class StatusLine : public QObject {
  Q_OBJECT

 public:
  StatusLine(QStatusBar& bar, const Document& document);

  void showHint(const QString& text);
  /// A sentence that stays for some seconds, over the hint.
  void say(const QString& text);
  void showPointer(const std::optional<Vec2>& world, double scale);

  /// With few fields there is room for the hint in large type.
  void setFewFields(bool few);

 signals:
  /// A place where marks could not be decided was picked from the list.
  void placePicked(const flatland::Vec2& place);

 private:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changed(const Change& change);
  void showScene();
  void showFields();
  void listPlaces();
  void watchSides(bool onlyTheViewTurned);
  void fitFields();
  QLabel* addField(const char* id, const QString& tip);

  QStatusBar& bar_;
  const Document& document_;
  QLabel* hint_;
  QLabel* pointer_;
  QLabel* view_;
  QToolButton* marks_;
  QMenu* places_;
  QLabel* time_;
  bool few_ = false;
  std::vector<int> sides_;  ///< normalSide() of each curve
};

}  // namespace flatland::ui
