// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace flatland::ui {

/// Says on standard error how far a long run is: on a terminal at most twice a second, on one line
/// that is wiped at the end; elsewhere a line every ten seconds, so that a short run says nothing.
/// For any thread.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// "curvature: 40 %", "3 of 36 views".
  void say(const std::string& text);

 private:
  std::mutex once_;
  bool onTerminal_, printed_ = false;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace flatland::ui
