// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>
#include <string>

#include "core3d/mesh/slice.h"
#include "ui/model/document.h"

namespace flatland::ui {

/// Keeps the flat view and the camera of the surface looking from the same side, where the surface
/// and the curves belong together: the curve that it is swept from, or one that was cut out of it.
/// Who turns the surface turns the flat view, which is no step for undo; who turns the flat view
/// turns the surface about the normal of the curve's plane.
class ViewLink : public QObject {
  Q_OBJECT

 public:
  explicit ViewLink(Document& document, QObject* parent = nullptr);

  /// On at first. A scene that opens with views that do not belong together switches it off: what
  /// is opened is shown as it was left.
  bool isOn() const { return on_; }
  /// Switched on, the flat view takes the side of the camera.
  void setOn(bool on);

  /// Called when all have followed another scene, and it is known whose plane is that of its
  /// curves: if its views do not belong together the link is switched off. Where that is known only
  /// after a section was cut, the link waits for it.
  void judgeScene();

  /// The plane of the surface (unit of its file) in which the scene's curves lie; nullopt: the
  /// curves are no section of it.
  void setSectionPlane(const std::optional<CutPlane>& plane);

  /// True if curves and surface belong together, so that there is something to link.
  bool canLink() const;
  /// Why there is no flat view of what the camera sees: English, for coreWords(); empty if there is
  /// one, or nothing to link.
  const std::string& whyNot() const { return whyNot_; }

 signals:
  void changed();

 private:
  void follow(const Change& change);
  std::optional<View> flatView(std::string* whyNot) const;
  bool disagree() const;
  void cameraTurned();
  void viewTurned();
  void showWhyNot();

  Document& document_;
  std::optional<CutPlane> section_;
  bool on_ = true;
  bool judged_ = true;  ///< false: of the scene that was opened it is not known yet
  std::string whyNot_;
};

}  // namespace flatland::ui
