// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Runs a private D-Bus for the test, with a simulated RealtimeKit service (played_rtkit.py). */
#ifndef PlayedRealtimeKit_h
#define PlayedRealtimeKit_h

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <csignal>
#include <fcntl.h>
#include <linux/capability.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace servotest
{

/// Runs a program and reads its output line by line. The destructor kills the program.
class WrittenProgram
{
public:
  explicit WrittenProgram(std::vector<std::string> words)
  {
    int output[2];
    if (pipe2(output, O_CLOEXEC) != 0)
    {
      return;
    }
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, output[1], STDOUT_FILENO);
    std::vector<char*> arguments;
    for (std::string& word : words)
    {
      arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    if (posix_spawnp(&this->Process, arguments[0], &actions, nullptr, arguments.data(), environ) !=
      0)
    {
      this->Process = -1;
    }
    posix_spawn_file_actions_destroy(&actions);
    close(output[1]);
    this->Output = fdopen(output[0], "r");
  }
  ~WrittenProgram()
  {
    this->Kill();
    std::fclose(this->Output);
  }
  WrittenProgram(const WrittenProgram&) = delete;
  WrittenProgram& operator=(const WrittenProgram&) = delete;

  void Kill()
  {
    if (this->Process > 0)
    {
      kill(this->Process, SIGKILL);
      waitpid(this->Process, nullptr, 0);
      this->Process = -1;
    }
  }
  /// Waits for a line of output. Returns an empty text at the end of the output.
  std::string ReadLine()
  {
    std::string line;
    for (int c = std::fgetc(this->Output); c != EOF && c != '\n'; c = std::fgetc(this->Output))
    {
      line += static_cast<char>(c);
    }
    return line;
  }
  /// Ends the program. Returns the lines that ReadLine() has not returned yet.
  std::vector<std::string> ReadAll()
  {
    this->Kill();
    std::vector<std::string> lines;
    for (std::string line = this->ReadLine(); !line.empty(); line = this->ReadLine())
    {
      lines.push_back(line);
    }
    return lines;
  }

private:
  pid_t Process = -1;
  std::FILE* Output = nullptr;
};

/// Starts a bus, which becomes the system bus of this process and the session bus of its child
/// processes.
class PlayedBus
{
public:
  PlayedBus()
  {
    setenv("DBUS_SYSTEM_BUS_ADDRESS", this->Address.c_str(), 1);
    setenv("DBUS_SESSION_BUS_ADDRESS", this->Address.c_str(), 1);
  }
  void Kill() { this->Daemon.Kill(); }
  /// Returns what the test needs but the system lacks, or null if nothing is missing.
  const char* DetectMissing() const
  {
    return this->Address.empty() ? "dbus-daemon is missing (on Debian: dbus)"
      : system("/usr/bin/python3 -c 'from gi.repository import Gio'") != 0
      ? "Gio is missing (on Debian: python3-gi)"
      : nullptr;
  }

private:
  WrittenProgram Daemon{ { "dbus-daemon", "--session", "--nofork", "--nopidfile",
    "--print-address" } };
  const std::string Address{ this->Daemon.ReadLine() };
};

/// Runs a simulated RealtimeKit. The constructor waits until the service is on the bus.
class PlayedRealtimeKit
{
public:
  explicit PlayedRealtimeKit(const std::vector<std::string>& options = {})
    : Service(MakeWords(options))
    , Ready(this->Service.ReadLine() == "ready")
  {
  }
  bool IsThere() const { return this->Ready; }
  std::string ReadCall() { return this->Service.ReadLine(); }
  std::vector<std::string> ReadCalls() { return this->Service.ReadAll(); }

private:
  static std::vector<std::string> MakeWords(const std::vector<std::string>& options)
  {
    std::vector<std::string> words{ "/usr/bin/python3", VOLUME_HAPTICS_PLAYED_RTKIT };
    words.insert(words.end(), options.begin(), options.end());
    return words;
  }

  WrittenProgram Service;
  const bool Ready;
};

inline std::int64_t ThisThread()
{
  return syscall(SYS_gettid);
}

/// Removes root's capabilities from the calling thread.
inline void DropPrivileges()
{
  __user_cap_header_struct header{ _LINUX_CAPABILITY_VERSION_3, 0 };
  __user_cap_data_struct data[2] = {};
  ASSERT_EQ(syscall(SYS_capset, &header, data), 0);
}

inline bool AllowPriority(rlim_t highest)
{
  const rlimit limit{ highest, highest };
  return setrlimit(RLIMIT_RTPRIO, &limit) == 0;
}

} // namespace servotest

#endif
