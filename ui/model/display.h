// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/export/mark_style.h"

class QSettings;

namespace flatland::ui {

/// What the person wants to see of the scene: no part of the document, so not undone or saved with
/// it, but remembered between sessions.
class Display : public QObject {
  Q_OBJECT

 public:
  explicit Display(QObject* parent = nullptr);

  /// The families shown: all but flat points and apparent minima, unless changed.
  const MarkKinds& families() const { return families_; }
  bool shows(MarkKind kind) const { return contains(families_, kind); }
  void setShows(MarkKind kind, bool shown);

  bool showsControlPolygon() const { return controlPolygon_; }
  void setShowsControlPolygon(bool shown);

  /// Hidden marks and parts of the curve: shown paler, or not at all.
  bool showsHidden() const { return hidden_; }
  void setShowsHidden(bool shown);

  void restore(const QSettings& settings);
  void save(QSettings& settings) const;

 signals:
  void changed();

 private:
  void set(bool& value, bool shown);

  MarkKinds families_ = defaultMarkKinds();
  bool controlPolygon_ = true;
  bool hidden_ = true;
};

}  // namespace flatland::ui
