// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <mutex>

#include "core3d/diff/estimate_fields.h"
#include "core3d/run_on_threads.h"

namespace flatland {

/// Runs work(begin, end) over [0, count) in blocks, on as many threads as the options ask for.
/// makeWorker() is called once for each thread, so that a worker can own buffers. Results depend
/// neither on the blocks nor on the threads as long as an element is written from its own index
/// alone. Progress is reported from `from` to `to`. False if stopped before the end. Throws what a
/// worker throws, when all have ended.
template <typename MakeWorker>
bool overBlocks(std::size_t count, const FieldOptions& options, double from, double to,
                const MakeWorker& makeWorker) {
  // Long enough to hide the counter, short enough to stop within a few milliseconds.
  constexpr std::size_t kBlock = 1024;
  const std::size_t blocks = (count + kBlock - 1) / kBlock;
  std::atomic<std::size_t> next{0}, done{0};
  std::mutex reporting;
  const auto run = [&] {
    auto work = makeWorker();
    for (std::size_t block; !options.stop.stop_requested() && (block = next++) < blocks;) {
      work(block * kBlock, std::min(count, (block + 1) * kBlock));
      ++done;
      if (options.progress) {
        // Read under the lock, so that the share never falls.
        const std::scoped_lock lock(reporting);
        options.progress(from +
                         (to - from) * static_cast<double>(done) / static_cast<double>(blocks));
      }
    }
  };
  runOnThreads(std::min(threadsFor(options.threads), blocks), run);
  return done == blocks;
}

}  // namespace flatland
