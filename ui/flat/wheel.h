// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointingDevice>
#include <QWheelEvent>

#include "ui/model/display.h"

namespace flatland::ui {

/// Two fingers on a trackpad, or a ball: not the notches of a wheel. Told by the device where the
/// platform names it, else by what only such devices send.
inline bool scrollsByFingers(const QWheelEvent& event) {
  if (event.device()->type() == QInputDevice::DeviceType::TouchPad) return true;
  return event.phase() != Qt::NoScrollPhase;
}

/// Whether the event zooms, on the canvas as on the plots: with Ctrl always, else a wheel if the
/// person wants that. What does not zoom moves.
inline bool wheelZoomsHere(const QWheelEvent& event, const Display& display) {
  return event.modifiers().testFlag(Qt::ControlModifier) ||
         (!scrollsByFingers(event) && display.wheelZooms());
}

}  // namespace flatland::ui
