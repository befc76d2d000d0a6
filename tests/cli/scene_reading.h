// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "flatland/io/input_error.h"
#include "flatland/io/scene_json.h"

namespace flatland::test {

inline constexpr const char* kSmallScene =
    R"({"flatland": 1, "curves": [{"bezier": [[0, 1], [2.5, -3]]}]})";

inline Scene read(const std::string& text) { return sceneFromJson(text, "a.json"); }

/// The text is refused, at that place and for a reason that holds these words.
inline void expectRefused(const std::string& text, const std::string& place,
                          const std::string& reason) {
  try {
    read(text);
    ADD_FAILURE() << "read " << text;
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), place) << text;
    EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
  }
}

}  // namespace flatland::test
