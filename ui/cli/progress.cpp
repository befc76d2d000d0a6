// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/progress.h"

#include <unistd.h>

#include <cstdio>

namespace flatland::ui {

namespace {

constexpr std::chrono::milliseconds kOnTerminal(500), kElsewhere(10000);

}  // namespace

Progress::Progress()
    : onTerminal_(isatty(STDERR_FILENO) != 0), last_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
  if (printed_ && onTerminal_) std::fputs("\r\033[K", stderr);
}

void Progress::say(const std::string& text) {
  const std::lock_guard lock(once_);
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < (onTerminal_ ? kOnTerminal : kElsewhere)) return;
  last_ = now;
  printed_ = true;
  std::fprintf(stderr, onTerminal_ ? "\r\033[K%s" : "flatland: %s\n", text.c_str());
  std::fflush(stderr);
}

}  // namespace flatland::ui
