// SPDX-License-Identifier: MIT
#include "flatland/io/input_error.h"

namespace flatland {

namespace {

std::string sentence(const std::string& source, const std::string& place,
                     const std::string& reason) {
  std::string text;
  for (const std::string* part : {&source, &place}) {
    if (!part->empty()) text += *part + ": ";
  }
  return text + reason;
}

}  // namespace

InputError::InputError(const std::string& source, const std::string& place,
                       const std::string& reason)
    : std::runtime_error(sentence(source, place, reason)), place_(place), reason_(reason) {}

}  // namespace flatland
