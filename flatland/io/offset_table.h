// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>

#include "flatland/study/offset_study.h"

namespace flatland {

/// The per-curve table of an offset study as a CSV file that grows row by row and can be continued.
/// An existing file is never overwritten. What was written stays if the program is interrupted: at
/// most the rows of the last quarter second, and a row without its end, are missing.
class OffsetTable {
 public:
  enum class Existing {
    Refuse,   ///< a file that exists is an error
    Continue  ///< its complete rows are kept, once they are known to be of this very study
  };

  /// Opens or creates the file. Throws InputError if it exists and must not, cannot be read or
  /// written, or is not a table of this study: its first and last rows must be what the options
  /// give.
  OffsetTable(const std::filesystem::path& file, const OffsetStudyOptions& options,
              Existing existing);

  /// How many rows there are: the index of the curve to go on with.
  std::int64_t rows() const { return rows_; }

  /// Appends the row of curve number rows(). Throws InputError if it cannot be written.
  void add(const CurveOffsets& curve);

  /// Writes to the end what is not on the disk yet. Throws InputError if that fails.
  void close();

 private:
  void readExisting();
  void flush();

  std::filesystem::path path_;
  OffsetStudyOptions options_;
  std::ofstream file_;
  std::int64_t rows_ = 0;
  std::uintmax_t bytes_ = 0;  ///< of complete rows in an existing file
  double flushedAt_ = 0.0;    ///< seconds of a steady clock
};

}  // namespace flatland
