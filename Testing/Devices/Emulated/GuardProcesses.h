// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Finds and runs the processes for the guard's tests: the guard itself, and an application that
 * ends while its device exerts a force.
 */
#ifndef GuardProcesses_h
#define GuardProcesses_h

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

#include <fcntl.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace emulated
{

/** Returns the guard process that this process has started for the device, or 0. */
inline pid_t FindGuard()
{
  for (const auto& process : std::filesystem::directory_iterator("/proc"))
  {
    // Parse "PID (NAME) STATE PARENT". The kernel truncates the name to 15 characters.
    std::string text;
    std::getline(std::ifstream(process.path() / "stat"), text);
    const std::size_t end = text.find(") ");
    if (text.find("(volumehaptics-") != std::string::npos && end != std::string::npos &&
      text[end + 2] != 'Z' && std::stoi(text.substr(end + 4)) == getpid())
    {
      return std::stoi(text);
    }
  }
  return 0;
}

/** Runs GuardedApplication.cxx as a separate process. */
class GuardedProgram
{
public:
  explicit GuardedProgram(const std::string& way, const std::string& device = "falcon")
  {
    prctl(PR_SET_CHILD_SUBREAPER, 1); // makes the guard a child of this process when the
                                      // application ends
    int input[2];
    if (pipe2(input, O_CLOEXEC) != 0)
    {
      return;
    }
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input[0], STDIN_FILENO);
    std::string words[] = { "application", way, device };
    char* const arguments[] = { words[0].data(), words[1].data(), words[2].data(), nullptr };
    pid_t process = 0;
    if (posix_spawn(
          &process, VOLUME_HAPTICS_GUARDED_APPLICATION, &actions, nullptr, arguments, environ) == 0)
    {
      this->Process = process;
    }
    posix_spawn_file_actions_destroy(&actions);
    close(input[0]);
    this->Input = input[1];
  }
  ~GuardedProgram()
  {
    this->Signal(SIGKILL);
    this->Wait();
    close(this->Input);
    // Wait until the guard has ended: umockdev aborts if a process that listens to it ends while
    // the device is being unplugged.
    while (const pid_t guard = FindGuard())
    {
      waitpid(guard, nullptr, 0);
    }
  }
  void Tell() const { EXPECT_EQ(write(this->Input, "x", 1), 1); }
  void Signal(int number) const
  {
    if (this->Process > 0)
    {
      kill(this->Process, number);
    }
  }
  /**
   * Waits until the program ends. Returns its exit status, or minus the number of the signal that
   * ended it.
   */
  int Wait()
  {
    if (this->Process > 0)
    {
      int status = 0;
      waitpid(this->Process, &status, 0);
      this->How = WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
      this->Process = -1;
    }
    return this->How;
  }
  std::string GetProgram() const
  {
    std::string name;
    std::getline(std::ifstream("/proc/" + std::to_string(this->Process) + "/comm"), name);
    return name;
  }

private:
  pid_t Process = -1;
  int Input = -1;
  int How = 0;
};

} // namespace emulated

#endif
