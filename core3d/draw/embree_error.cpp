// SPDX-License-Identifier: MIT
#include "core3d/draw/embree_error.h"

#include <embree3/rtcore.h>

#include <new>
#include <stdexcept>
#include <string>

namespace flatland {
namespace {

const char* textOf(int error) {
  switch (error) {
    case RTC_ERROR_INVALID_ARGUMENT:
      return "invalid argument";
    case RTC_ERROR_INVALID_OPERATION:
      return "invalid operation";
    case RTC_ERROR_UNSUPPORTED_CPU:
      return "this processor is not supported";
    case RTC_ERROR_CANCELLED:
      return "cancelled";
    default:
      return "unknown error";
  }
}

}  // namespace

void throwIfFailed(int error) {
  if (error == RTC_ERROR_NONE) return;
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  throw std::runtime_error(std::string("Embree, which casts rays: ") + textOf(error));
}

}  // namespace flatland
