// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace flatland::test {

inline std::string contentsOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// How a program is started.
struct ProgramRun {
  std::vector<std::string> arguments;
  std::string input = {};                                              ///< standard input
  std::map<std::string, std::optional<std::string>> environment = {};  ///< set, or removed
  std::optional<std::string> standardOutput = {};    ///< a file to write to instead of catching
  std::optional<std::filesystem::path> folder = {};  ///< current folder
  /// The program is killed (SIGKILL) once this says so; asked every 2 ms.
  std::function<bool()> killWhen = {};
};

/// What came of it.
struct ProgramResult {
  int exitCode;  ///< minus the signal's number if a signal ended it
  std::string out, err;
};

/// Runs a program to its end, without a shell. One that takes longer than a minute is killed and
/// answers -SIGKILL.
inline ProgramResult runProgram(const std::string& program, const ProgramRun& run) {
  const TemporaryFolder folder;
  const std::string inFile = (folder.path() / "in").string();
  const std::string outFile = run.standardOutput.value_or((folder.path() / "out").string());
  const std::string errFile = (folder.path() / "err").string();
  std::ofstream(inFile, std::ios::binary) << run.input;

  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : run.arguments) {
    argv.push_back(const_cast<char*>(argument.c_str()));
  }
  argv.push_back(nullptr);

  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("cannot fork");
  if (child == 0) {
    const auto redirect = [](const std::string& file, int flags, int to) {
      const int from = ::open(file.c_str(), flags, 0600);
      if (from < 0 || ::dup2(from, to) < 0) ::_exit(127);
    };
    redirect(inFile, O_RDONLY, STDIN_FILENO);
    redirect(outFile, O_WRONLY | O_CREAT, STDOUT_FILENO);
    redirect(errFile, O_WRONLY | O_CREAT, STDERR_FILENO);
    if (run.folder && ::chdir(run.folder->c_str()) != 0) ::_exit(127);
    for (const auto& [name, value] : run.environment) {
      if (value) {
        ::setenv(name.c_str(), value->c_str(), 1);
      } else {
        ::unsetenv(name.c_str());
      }
    }
    ::execv(program.c_str(), argv.data());
    ::_exit(127);
  }

  int status = 0;
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > end || (run.killWhen && run.killWhen())) {
      ::kill(child, SIGKILL);
      ::waitpid(child, &status, 0);
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  return {code, run.standardOutput ? std::string() : contentsOf(outFile), contentsOf(errFile)};
}

/// The same without a display, and with a Qt platform that does not exist: whoever asks Qt for one
/// ends. nullopt leaves the choice of the platform to Qt.
inline ProgramResult runWithoutDisplay(const std::string& program,
                                       const std::vector<std::string>& arguments,
                                       const std::string& input = {},
                                       const std::optional<std::string>& platform = "nonsense") {
  return runProgram(program, {.arguments = arguments,
                              .input = input,
                              .environment = {{"DISPLAY", std::nullopt},
                                              {"WAYLAND_DISPLAY", std::nullopt},
                                              {"QT_QPA_PLATFORM", platform}}});
}

}  // namespace flatland::test
