// SPDX-License-Identifier: MIT
#pragma once

#include <embree3/rtcore.h>

namespace flatland {

/// Throws what an error of Embree means: std::bad_alloc if memory ran out, else std::runtime_error
/// that names it. Does nothing for RTC_ERROR_NONE.
void throwIfFailed(RTCError error);

}  // namespace flatland
