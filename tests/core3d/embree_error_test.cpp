// SPDX-License-Identifier: GPL-3.0-or-later
// What is said when rays cannot be cast, by errors that Embree is led into.
#include "core3d/draw/embree_error.h"

#include <embree3/rtcore.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <new>
#include <stdexcept>
#include <string>

namespace flatland::test {
namespace {

class EmbreeError : public testing::Test {
 protected:
  ~EmbreeError() override { rtcReleaseDevice(device_); }

  RTCDevice device_ = rtcNewDevice(nullptr);
};

TEST_F(EmbreeError, NothingIsThrownWhereNothingFailed) {
  EXPECT_NO_THROW(throwIfFailed(rtcGetDeviceError(device_)));
}

TEST_F(EmbreeError, MemoryThatRanOutIsBadAlloc) {
  rtcSetDeviceMemoryMonitorFunction(
      device_, [](void*, ssize_t bytes, bool) { return bytes <= 0; }, nullptr);
  const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                          1000);
  rtcReleaseGeometry(geometry);
  EXPECT_THROW(throwIfFailed(rtcGetDeviceError(device_)), std::bad_alloc);
}

TEST_F(EmbreeError, AnythingElseIsNamed) {
  const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetGeometryTimeStepCount(geometry, 100'000);
  rtcReleaseGeometry(geometry);
  try {
    throwIfFailed(rtcGetDeviceError(device_));
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("Embree"), std::string::npos);
  }
  for (const RTCError error : {RTC_ERROR_UNSUPPORTED_CPU, RTC_ERROR_CANCELLED, RTC_ERROR_UNKNOWN})
    EXPECT_THROW(throwIfFailed(error), std::runtime_error);
}

}  // namespace
}  // namespace flatland::test
