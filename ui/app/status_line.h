// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "ui/model/document.h"

class QLabel;
class QStatusBar;

namespace flatland::ui {

/// The line at the bottom: what a drag would do now, where the pointer is, the view angle, whether
/// all marks are certified, and how long they took.
class StatusLine : public QObject {
  Q_OBJECT

 public:
  StatusLine(QStatusBar& bar, const Document& document);

  void showHint(const QString& text);
  /// A sentence that stays for some seconds, over the hint.
  void say(const QString& text);
  void showPointer(const std::optional<Vec2>& world, double scale);

 private:
  void showScene();
  QLabel* addField(const char* id, const QString& widest, const QString& tip);

  QStatusBar& bar_;
  const Document& document_;
  QLabel* hint_;
  QLabel* pointer_;
  QLabel* view_;
  QLabel* marks_;
  QLabel* time_;
};

}  // namespace flatland::ui
