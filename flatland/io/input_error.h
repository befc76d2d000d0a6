// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace flatland {

/// Bad input from outside the program: the one exception family of the libraries. what() is one
/// sentence for a person: file (if any), place (line and column, or JSON path), reason.
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& source, const std::string& place, const std::string& reason);

  const std::string& place() const {
    return place_;
  }  ///< "line 3, column 7" or "curves[0].bezier[2]"
  const std::string& reason() const { return reason_; }  ///< why, without the place

 private:
  std::string place_;
  std::string reason_;
};

}  // namespace flatland
