// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace flatland {

/// How many threads an option stands for: 0 for all cores.
inline std::size_t threadsFor(int asked) {
  return asked > 0 ? static_cast<std::size_t>(asked)
                   : std::max<std::size_t>(1, std::thread::hardware_concurrency());
}

/// Calls work() once on each of `threads` threads, this one among them (at least on this one), and
/// returns when all have ended. Throws what the first of them to fail has thrown, after that; the
/// work says itself how the others learn to stop early.
template <typename Work>
void runOnThreads(std::size_t threads, const Work& work) {
  std::mutex failing;
  std::exception_ptr failure;
  const auto guarded = [&] {
    try {
      work();
    } catch (...) {
      const std::scoped_lock lock(failing);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t k = 1; k < threads; ++k) others.emplace_back(guarded);
    guarded();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace flatland
