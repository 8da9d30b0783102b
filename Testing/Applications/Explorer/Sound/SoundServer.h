// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Runs a PulseAudio server without a loudspeaker, which records the sound. The server uses neither
 * the system's nor the user's configuration, and ends with the test.
 */
#ifndef SoundServer_h
#define SoundServer_h

#include "Rigs/TemporaryFolder.h"

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace soundtest
{

/** A program that runs in parallel with the test and writes its output to a file. */
class Program
{
public:
  Program(std::vector<std::string> words, const std::string& output)
    : Id(fork())
  {
    if (this->Id == 0)
    {
      std::vector<char*> arguments;
      for (std::string& word : words)
      {
        arguments.push_back(word.data());
      }
      arguments.push_back(nullptr);
      const int file = open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
      const int nothing = open("/dev/null", O_WRONLY);
      dup2(file, STDOUT_FILENO);
      dup2(nothing, STDERR_FILENO);
      execvp(arguments[0], arguments.data());
      _exit(127);
    }
  }
  ~Program() { this->End(SIGKILL); }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void Signal(int signal) { kill(this->Id, signal); }
  void End(int signal)
  {
    if (this->Id > 0)
    {
      this->Signal(signal);
      this->Wait();
    }
  }
  /** Waits until the program ends by itself. Returns its exit status. */
  int Wait()
  {
    int status = -1;
    waitpid(this->Id, &status, 0);
    this->Id = -1;
    return status;
  }

private:
  pid_t Id;
};

inline bool HasSoundServer()
{
  return Program({ "pulseaudio", "--version" }, "/dev/null").Wait() == 0 &&
    Program({ "parec", "--version" }, "/dev/null").Wait() == 0;
}

class SoundServer
{
public:
  SoundServer()
    : Folder(MakeNewFolder("/tmp/VolumeHaptics").string())
    , Server(MakeWords(this->Folder), "/dev/null")
  {
    while (Program({ "pactl", "info" }, "/dev/null").Wait() != 0)
    {
      usleep(20000);
    }
  }

  ~SoundServer()
  {
    this->Server.End(SIGKILL);
    std::error_code ignored;
    std::filesystem::remove_all(this->Folder, ignored);
  }
  SoundServer(const SoundServer&) = delete;
  SoundServer& operator=(const SoundServer&) = delete;

  /** Lists the streams that are playing, one line each. */
  static std::string ListStreams()
  {
    const std::string file = TemporaryPath("streams");
    Program({ "pactl", "list", "short", "sink-inputs" }, file).Wait();
    std::ifstream stream(file);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  }

  static std::vector<std::string> RecorderWords()
  {
    return { "parec", "--device=ear.monitor", "--raw", "--rate=48000", "--channels=1",
      "--format=float32le", "--latency-msec=20" };
  }

private:
  /**
   * The server's folder. It is outside the build folder, since a socket's path may have at most 107
   * characters.
   */
  const std::string Folder;

public:
  Program Server;

private:
  static std::vector<std::string> MakeWords(const std::string& folder)
  {
    const std::string socket = folder + "/socket";
    for (const char* variable : { "HOME", "XDG_CONFIG_HOME", "XDG_RUNTIME_DIR" })
    {
      setenv(variable, folder.c_str(), 1);
    }
    setenv("PULSE_SERVER", ("unix:" + socket).c_str(), 1);
    for (const char* variable : { "PULSE_RUNTIME_PATH", "PULSE_SINK", "DBUS_SESSION_BUS_ADDRESS" })
    {
      unsetenv(variable);
    }
    return { "pulseaudio", "-n", "--daemonize=no", "--use-pid-file=no", "--exit-idle-time=-1", "-L",
      "module-null-sink sink_name=ear rate=48000 channels=1 format=float32le", "-L",
      "module-native-protocol-unix auth-anonymous=1 socket=" + socket };
  }
};

} // namespace soundtest

#endif
