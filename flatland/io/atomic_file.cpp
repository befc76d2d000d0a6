// SPDX-License-Identifier: MIT
#include "flatland/io/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <system_error>

#include "flatland/io/input_error.h"

namespace flatland {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, const std::string& what, int error) {
  throw InputError(file.string(), "", what + ": " + std::generic_category().message(error));
}

/// A file descriptor that is closed, and a temporary that is removed, whatever happens.
class OpenFile {
 public:
  explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  int descriptor() const { return descriptor_; }
  void removeAtEnd(const fs::path& temporary) { temporary_ = temporary; }
  void keep() { temporary_.clear(); }

  /// 0, or the error of close(), which on some file systems is where a write fails.
  int close() {
    const int result = ::close(descriptor_);
    descriptor_ = -1;
    return result == 0 ? 0 : errno;
  }

 private:
  int descriptor_;
  fs::path temporary_;
};

/// 0 or the system's error.
int writeAll(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      return errno;
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

/// The file a chain of symbolic links ends at, also if that file does not exist yet.
fs::path linkTarget(fs::path file) {
  constexpr int kMostLinks = 40;  // as the kernel
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(fs::symlink_status(file, error)); ++i) {
    const fs::path target = fs::read_symlink(file, error);
    if (error) break;
    file = target.is_absolute() ? target : file.parent_path() / target;
  }
  return file;
}

fs::path folderOf(const fs::path& file) {
  return file.parent_path().empty() ? fs::path(".") : file.parent_path();
}

/// A new file beside `file`, made with the permissions the process gives to new files; -1 and errno
/// if that fails.
int createBeside(const fs::path& file, fs::path& temporary) {
  static std::atomic<unsigned> counter{0};
  constexpr int kAttempts = 1000;
  for (int i = 0; i < kAttempts; ++i) {
    temporary = folderOf(file) / (".flatland-" + std::to_string(::getpid()) + "-" +
                                  std::to_string(counter++) + ".tmp");
    const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
  return -1;
}

void writeDirectly(const fs::path& file, std::string_view bytes) {
  OpenFile out(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  if (out.descriptor() < 0) fail(file, "cannot be written", errno);
  if (const int error = writeAll(out.descriptor(), bytes)) fail(file, "cannot be written", error);
}

}  // namespace

void writeFileAtomically(const fs::path& file, std::string_view bytes) {
  struct stat existing {};
  const bool exists = ::stat(file.c_str(), &existing) == 0;
  if (exists && S_ISDIR(existing.st_mode)) fail(file, "cannot be written", EISDIR);
  // A device or a pipe cannot be replaced, only written to.
  if (exists && !S_ISREG(existing.st_mode)) return writeDirectly(file, bytes);
  // Renaming would get round a write protection; respect it.
  if (exists && ::access(file.c_str(), W_OK) != 0) fail(file, "cannot be written", errno);

  const fs::path target = linkTarget(file);
  fs::path temporary;
  OpenFile out(createBeside(target, temporary));
  if (out.descriptor() < 0) fail(file, "cannot be written", errno);
  out.removeAtEnd(temporary);
  if (exists) {
    // The owner can be kept only by root; the permissions must be.
    if (::fchown(out.descriptor(), existing.st_uid, existing.st_gid) != 0 && errno != EPERM) {
      fail(file, "cannot keep its owner", errno);
    }
    if (::fchmod(out.descriptor(), existing.st_mode & 07777U) != 0) {
      fail(file, "cannot keep its permissions", errno);
    }
  }
  int error = writeAll(out.descriptor(), bytes);
  if (error == 0 && ::fsync(out.descriptor()) != 0) error = errno;
  const int closed = out.close();
  if (error == 0) error = closed;
  if (error != 0) fail(file, "cannot be written", error);
  if (::rename(temporary.c_str(), target.c_str()) != 0) fail(file, "cannot be replaced", errno);
  out.keep();

  // Makes the new name last through a power cut. The file is in place already, and not every file
  // system can do this, so its failure is no failure of the save.
  const OpenFile folder(::open(folderOf(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.descriptor() >= 0) ::fsync(folder.descriptor());
}

}  // namespace flatland
