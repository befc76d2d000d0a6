// SPDX-License-Identifier: MIT
#include "flatland/io/read_text.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "flatland/io/input_error.h"

namespace flatland {

namespace {

[[noreturn]] void failToRead(const std::string& source, int error) {
  throw InputError(source, "", "cannot be read: " + std::generic_category().message(error));
}

std::string readAll(int descriptor, const std::string& source, std::size_t mostBytes) {
  std::string text;
  std::string block(std::size_t{1} << 16U, '\0');
  while (text.size() <= mostBytes) {
    const ssize_t count = ::read(descriptor, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) failToRead(source, errno);
    if (count == 0) break;
    text.append(block, 0, static_cast<std::size_t>(count));
  }
  return text;
}

/// Closes at the end of the block, also when reading throws.
struct InputFile {
  int descriptor;
  ~InputFile() { ::close(descriptor); }
};

}  // namespace

std::string readFile(const std::filesystem::path& file, std::size_t mostBytes) {
  const std::string source = file.string();
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) failToRead(source, errno);
  const InputFile input{descriptor};
  return readAll(input.descriptor, source, mostBytes);
}

std::string readStandardInput(std::size_t mostBytes) {
  return readAll(STDIN_FILENO, "standard input", mostBytes);
}

}  // namespace flatland
