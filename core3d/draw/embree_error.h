// SPDX-License-Identifier: MIT
#pragma once

namespace flatland {

/// Throws what an error of Embree (its RTCError) means: std::bad_alloc if memory ran out, else
/// std::runtime_error that names it. Does nothing for RTC_ERROR_NONE.
void throwIfFailed(int error);

}  // namespace flatland
