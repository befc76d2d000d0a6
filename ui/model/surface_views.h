// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "ui/model/seen_surface.h"

namespace flatland::ui {

/// What is found for each of the views of the document's surface, and which of them a person works
/// with.
class SurfaceViews : public QObject {
  Q_OBJECT

 public:
  SurfaceViews(const Document& document, const SurfaceSource& source, QObject* parent = nullptr);

  const InkSource& ink() const { return ink_; }

  /// There are 1 + kMostPanes of them, whatever the document shows.
  SeenSource& seen(std::size_t pane) { return *seen_[pane]; }

  /// How a view is drawn, with the thresholds that its ink needs. Precondition: there is a surface,
  /// and such a view.
  PaneSetting setting(std::size_t pane) const {
    return ink_.withInk(paneSetting(*document_.scene().surface, pane), pane);
  }

  /// True while one of them is of another camera or other settings.
  bool isStale() const;

  std::size_t count() const;  ///< of the views that the document has; 1 if it has no surface

  /// The view that panels are about. The first one when the view goes.
  std::size_t active() const { return active_; }
  void setActive(std::size_t pane);

 signals:
  void activeChanged();
  void failed(const QString& reason);

 private:
  const Document& document_;
  InkSource ink_;
  std::vector<std::unique_ptr<SeenSource>> seen_;
  std::size_t active_ = 0;
};

}  // namespace flatland::ui
