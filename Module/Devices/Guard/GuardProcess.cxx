// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Guard/GuardProcess.h"

#include "Core/Platform/OwnFile.h"
#include "Core/Realtime/ServoClock.h"

#include <cerrno>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace VolumeHaptics
{
namespace
{

const char* const Variable = "VOLUMEHAPTICS_GUARD";
const char* const ProgramName = "volumehaptics-guard";
/** Longest time (ms) for opening a device. An unresponsive device takes a few seconds. */
constexpr int OpeningTime = 20000;

const char* const GuardCure =
  "Set the environment variable VOLUMEHAPTICS_GUARD to the path of volumehaptics-guard, which is "
  "installed with this library; or set it to \"off\", or call UseGuardOff(), to use the device "
  "without a guard: then it may keep its last force if this program is killed or stopped.";

/** Resets signals and file descriptors to the state that a new program expects. */
class SpawnSettings
{
public:
  SpawnSettings()
  {
    posix_spawn_file_actions_init(&this->Actions);
    posix_spawnattr_init(&this->Attributes);
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&this->Attributes, &signals);
    sigfillset(&signals);
    posix_spawnattr_setsigdefault(&this->Attributes, &signals);
    // The guard gets its own process group, so that Ctrl+C and Ctrl+Z in a terminal reach only the
    // program.
    posix_spawnattr_setpgroup(&this->Attributes, 0);
    posix_spawnattr_setflags(
      &this->Attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    posix_spawn_file_actions_addopen(&this->Actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&this->Actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  }
  ~SpawnSettings()
  {
    posix_spawn_file_actions_destroy(&this->Actions);
    posix_spawnattr_destroy(&this->Attributes);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  /** Passes a descriptor to the new program, with the same number. */
  void Pass(int descriptor)
  {
    posix_spawn_file_actions_adddup2(&this->Actions, descriptor, descriptor);
  }

  posix_spawn_file_actions_t Actions{};
  posix_spawnattr_t Attributes{};
};

} // namespace

std::string FindGuardProgram(std::string& error)
{
  if (const std::string named = ReadSafeVariable(Variable); !named.empty())
  {
    if (access(named.c_str(), X_OK) != 0)
    {
      error = "The guard of the device can't be started: \"" + named + "\" (" +
        std::strerror(errno) + "). " + GuardCure;
      return {};
    }
    return named;
  }
  std::string obstacle;
  std::string program =
    FindProgramOfLibrary(reinterpret_cast<const void*>(&FindGuardProgram), ProgramName, obstacle);
  if (program.empty())
  {
    error = std::string("The guard of the device, the program ") + ProgramName +
      (obstacle.empty()
          ? ", is neither beside this library nor in a folder \"bin\" near it. "
          : ", is not started, as another user could have written it: " + obstacle + " ") +
      GuardCure;
  }
  return program;
}

GuardProcess::~GuardProcess()
{
  std::string ignored;
  this->End(ignored);
}

bool GuardProcess::Start(GuardMemory& memory, const std::vector<std::string>& device,
  DriverFacts& facts, std::string& error)
{
  int links[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, links) != 0)
  {
    error = std::string("The guard of the device can't be started: ") + std::strerror(errno) + ".";
    return false;
  }
  this->Link = links[0];
  const bool isSpawned = this->Spawn(memory, device, links[1], error);
  close(links[1]);
  if (!isSpawned || !this->ReadAnswer(facts, error))
  {
    std::string ignored;
    this->End(ignored);
    return false;
  }
  return true;
}

bool GuardProcess::Spawn(
  GuardMemory& memory, const std::vector<std::string>& device, int itsLink, std::string& error)
{
  std::string program = FindGuardProgram(error);
  if (program.empty())
  {
    return false;
  }
  SpawnSettings settings;
  settings.Pass(memory.GetDescriptor());
  settings.Pass(memory.GetExchange().GetWakeDescriptor());
  settings.Pass(itsLink);
  std::vector<std::string> words = { ProgramName, GuardMemory::GetLayout(),
    std::to_string(memory.GetDescriptor()), std::to_string(itsLink), std::to_string(getpid()),
    std::to_string(ServoClock::Now()) };
  words.insert(words.end(), device.begin(), device.end());
  std::vector<char*> pointers;
  for (std::string& word : words)
  {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  const int result = posix_spawn(&this->Process, program.c_str(), &settings.Actions,
    &settings.Attributes, pointers.data(), environ);
  if (result != 0)
  {
    this->Process = -1;
    error = "The guard of the device, \"" + program + "\", can't be started (" +
      std::strerror(result) + "). " + GuardCure;
  }
  return result == 0;
}

bool GuardProcess::ReadAnswer(DriverFacts& facts, std::string& error)
{
  // The answer is one line: '+', the identity, a tab and the name, or '-' and the fault.
  std::string answer;
  const std::int64_t end = ServoClock::Now() + OpeningTime * ServoClock::Millisecond;
  pollfd watched = { this->Link, POLLIN, 0 };
  while (answer.empty() || answer.back() != '\n')
  {
    const auto left = static_cast<int>((end - ServoClock::Now()) / ServoClock::Millisecond);
    const int ready = left > 0 ? poll(&watched, 1, left) : 0;
    if (ready < 0 && errno == EINTR)
    {
      continue;
    }
    char byte = 0;
    if (ready <= 0 || recv(this->Link, &byte, 1, 0) != 1)
    {
      std::string how = "does not answer";
      if (ready > 0)
      {
        this->End(how);
        how += " before it had the device";
      }
      error = "The guard of the device " + how + ". " + GuardCure;
      return false;
    }
    answer += byte;
  }
  const std::string text = answer.substr(1, answer.size() - 2);
  if (answer.front() != '+')
  {
    error = text;
    return false;
  }
  const std::size_t tab = text.find('\t');
  facts.Identity = text.substr(0, tab);
  facts.Name = text.substr(tab + 1);
  return true;
}

bool GuardProcess::HasEnded(int time) const noexcept
{
  pollfd watched = { this->Link, 0, 0 }; // poll always reports a hangup
  return this->Link < 0 || (poll(&watched, 1, time) > 0 && watched.revents != 0);
}

bool GuardProcess::HasStopped() const noexcept
{
  siginfo_t info{};
  return this->Process > 0 &&
    waitid(P_PID, static_cast<id_t>(this->Process), &info, WSTOPPED | WNOHANG) == 0 &&
    info.si_pid == this->Process;
}

bool GuardProcess::End(std::string& how)
{
  how = "ended";
  bool isWell = true;
  if (this->Process > 0)
  {
    if (!this->HasEnded(0))
    {
      kill(this->Process, SIGKILL);
    }
    int status = 0;
    pid_t result = 0;
    do
    {
      result = waitpid(this->Process, &status, 0);
    } while (result < 0 && errno == EINTR);
    // The program may have told the system to discard the exit status, or may have read it
    // elsewhere.
    isWell = result != this->Process || (WIFEXITED(status) && WEXITSTATUS(status) == 0);
    if (!isWell)
    {
      how = WIFSIGNALED(status)
        ? std::string("was ended by a signal (") + strsignal(WTERMSIG(status)) + ")"
        : "ended with the status " + std::to_string(WEXITSTATUS(status));
    }
    this->Process = -1;
  }
  if (this->Link >= 0)
  {
    close(this->Link);
    this->Link = -1;
  }
  return isWell;
}

void GuardProcess::Abandon() noexcept
{
  this->Process = -1;
}

} // namespace VolumeHaptics
