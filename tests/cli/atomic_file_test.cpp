// SPDX-License-Identifier: GPL-3.0-or-later
#include "flatland/io/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "flatland/io/input_error.h"
#include "tests/support/run_program.h"

namespace flatland {
namespace {

namespace fs = std::filesystem;
using test::contentsOf;
using test::TemporaryFolder;

void put(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

mode_t modeOf(const fs::path& file) {
  struct stat status {};
  EXPECT_EQ(::stat(file.c_str(), &status), 0);
  return status.st_mode & 07777U;
}

/// The message of the failure to write; empty if it did not fail.
std::string failure(const fs::path& file, std::string_view bytes) {
  try {
    writeFileAtomically(file, bytes);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

/// Runs `check` in a process of its own, which may give up rights; true if it returns true.
template <class Check>
bool inOwnProcess(const Check& check) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(check() ? 0 : 1);
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST(AtomicFile, WritesNewAndOverOld) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.txt";
  writeFileAtomically(file, "first");
  EXPECT_EQ(contentsOf(file), "first");
  const std::string binary("\0\xFF\n", 3);
  writeFileAtomically(file, binary);
  EXPECT_EQ(contentsOf(file), binary);
  EXPECT_EQ(folder.count(), 1U);
}

TEST(AtomicFile, NeverChangesTheOldFileInPlace) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.txt";
  put(file, "old");
  const fs::path witness = folder.path() / "witness";
  fs::create_hard_link(file, witness);  // the old contents, by another name
  writeFileAtomically(file, "new");
  EXPECT_EQ(contentsOf(file), "new");
  EXPECT_EQ(contentsOf(witness), "old");
}

TEST(AtomicFile, KeepsPermissions) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.txt";
  put(file, "old");
  for (const mode_t mode : {0640U, 0606U, 0755U}) {
    ASSERT_EQ(::chmod(file.c_str(), mode), 0);
    writeFileAtomically(file, "new");
    EXPECT_EQ(modeOf(file), mode);
  }
}

TEST(AtomicFile, NewFilesGetTheUsualPermissions) {
  const TemporaryFolder folder;
  for (const mode_t mask : {0022U, 0077U}) {
    const fs::path file = folder.path() / std::to_string(mask);
    const mode_t before = ::umask(mask);
    writeFileAtomically(file, "new");
    ::umask(before);
    EXPECT_EQ(modeOf(file), 0666U & ~mask);
  }
}

TEST(AtomicFile, FollowsLinks) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "sub");
  const fs::path file = folder.path() / "sub" / "real.txt";
  put(file, "old");
  const fs::path link = folder.path() / "link.txt";
  const fs::path linkToLink = folder.path() / "link2.txt";
  fs::create_symlink("sub/real.txt", link);
  fs::create_symlink("link.txt", linkToLink);
  writeFileAtomically(linkToLink, "new");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_TRUE(fs::is_symlink(linkToLink));
  EXPECT_EQ(contentsOf(file), "new");

  const fs::path dangling = folder.path() / "dangling.txt";
  fs::create_symlink("sub/later.txt", dangling);
  writeFileAtomically(dangling, "there");
  EXPECT_TRUE(fs::is_symlink(dangling));
  EXPECT_EQ(contentsOf(folder.path() / "sub" / "later.txt"), "there");
}

TEST(AtomicFile, AFullDiskLeavesTheOldFile) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.txt";
  put(file, "old");
  // A limit on the size of files makes a write fail half way, as a full disk does.
  struct rlimit before {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto oldAction = std::signal(SIGXFSZ, SIG_IGN);
  struct rlimit small = before;
  small.rlim_cur = 1000;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message = failure(file, std::string(5000, 'x'));
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, oldAction);

  EXPECT_EQ(message, file.string() + ": cannot be written: File too large");
  EXPECT_EQ(contentsOf(file), "old");
  EXPECT_EQ(folder.count(), 1U) << "a temporary stayed behind";
}

TEST(AtomicFile, SaysWhyItCannotWrite) {
  const TemporaryFolder folder;
  const fs::path missing = folder.path() / "none" / "a.txt";
  EXPECT_EQ(failure(missing, "x"),
            missing.string() + ": cannot be written: No such file or directory");
  EXPECT_EQ(failure(folder.path(), "x"),
            folder.path().string() + ": cannot be written: Is a directory");
  const fs::path file = folder.path() / "file";
  put(file, "old");
  EXPECT_EQ(failure(file / "a.txt", "x"),
            (file / "a.txt").string() + ": cannot be written: Not a directory");
  EXPECT_EQ(folder.count(), 1U);
}

TEST(AtomicFile, WritesToDevicesDirectly) {
  EXPECT_EQ(failure("/dev/null", "x"), "");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(failure("/dev/full", "x"), "/dev/full: cannot be written: No space left on device");
}

TEST(AtomicFile, RespectsAWriteProtectedFileAndFolder) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.txt";
  put(file, "old");
  const std::string denied = ": cannot be written: Permission denied";
  ASSERT_EQ(::chmod(folder.path().c_str(), 0777), 0);
  ASSERT_EQ(::chmod(file.c_str(), 0444), 0);
  const auto refuses = [&](const fs::path& target) {
    return inOwnProcess([&] {
      constexpr uid_t kNobody = 65534;
      if (::geteuid() == 0 && ::setuid(kNobody) != 0) return false;  // root may write anything
      return failure(target, "new") == target.string() + denied;
    });
  };
  EXPECT_TRUE(refuses(file));
  ASSERT_EQ(::chmod(folder.path().c_str(), 0555), 0);
  EXPECT_TRUE(refuses(folder.path() / "b.txt"));
  ASSERT_EQ(::chmod(folder.path().c_str(), 0755), 0);
  EXPECT_EQ(contentsOf(file), "old");
  EXPECT_EQ(folder.count(), 1U);
}

}  // namespace
}  // namespace flatland
