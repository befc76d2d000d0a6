// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

namespace flatland::ui {

/// Which handle of the cutting plane is under the pointer or held, and whether keys move the plane.
class PlaneGrip : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// 0: the middle, 1 to 4: PlaneHandles::rim.
  const std::optional<int>& handle() const { return handle_; }
  void setHandle(const std::optional<int>& handle) {
    if (handle == handle_) return;
    handle_ = handle;
    emit changed();
  }

  bool hasKeys() const { return hasKeys_; }
  void setHasKeys(bool has) {
    if (has == hasKeys_) return;
    hasKeys_ = has;
    emit changed();
  }

 signals:
  void changed();

 private:
  std::optional<int> handle_;
  bool hasKeys_ = false;
};

}  // namespace flatland::ui
