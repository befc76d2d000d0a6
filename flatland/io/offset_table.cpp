// SPDX-License-Identifier: MIT
#include "flatland/io/offset_table.h"

#include <cassert>
#include <chrono>

#include "flatland/io/input_error.h"
#include "flatland/io/study_text.h"

namespace flatland {

namespace {

constexpr double kFlushSeconds = 0.25;

double secondsNow() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

OffsetTable::OffsetTable(const std::filesystem::path& file, const OffsetStudyOptions& options,
                         Existing existing)
    : path_(file), options_(options), flushedAt_(secondsNow()) {
  if (std::filesystem::exists(path_)) {
    if (existing == Existing::Refuse) {
      throw InputError(path_.string(), "",
                       "exists already; --resume continues it, or remove it to start over");
    }
    readExisting();
    std::filesystem::resize_file(path_, bytes_);
  }
  file_.open(path_, std::ios::binary | std::ios::app);
  if (!file_) throw InputError(path_.string(), "", "cannot be written");
  if (bytes_ == 0) file_ << offsetCsvHeader();
}

void OffsetTable::readExisting() {
  std::ifstream file(path_, std::ios::binary);
  if (!file) throw InputError(path_.string(), "", "cannot be read, so there is nothing to resume");
  const std::string header = offsetCsvHeader();
  std::string start(header.size(), '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  if (!header.starts_with(start)) {
    throw InputError(path_.string(), "line 1", "is not a table of this study");
  }
  if (start != header) return;  // interrupted within the header
  bytes_ = header.size();
  const auto check = [&](const std::string& line, std::int64_t row) {
    if (row < options_.curves &&
        line == offsetCsvRow(measureOffsets(options_, row), options_.convention)) {
      return;
    }
    throw InputError(path_.string(), "line " + std::to_string(row + 2),
                     "is not of this study: other options, or not a table of flatland");
  };
  std::string line, last;
  // A line without its end was being written when the run was interrupted.
  while (std::getline(file, line) && !file.eof()) {
    line += '\n';
    if (rows_ == 0) check(line, 0);
    bytes_ += line.size();
    ++rows_;
    last = line;
  }
  if (rows_ > 0) check(last, rows_ - 1);
}

void OffsetTable::add(const CurveOffsets& curve) {
  assert(curve.index == rows_);
  file_ << offsetCsvRow(curve, options_.convention);
  ++rows_;
  if (secondsNow() - flushedAt_ > kFlushSeconds) flush();
}

void OffsetTable::flush() {
  file_.flush();
  if (!file_) throw InputError(path_.string(), "", "cannot be written to the end");
  flushedAt_ = secondsNow();
}

void OffsetTable::close() {
  flush();
  file_.close();
}

}  // namespace flatland
