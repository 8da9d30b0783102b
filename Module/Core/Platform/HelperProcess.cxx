// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#if !defined(_WIN32)
#include "Core/Platform/HelperProcess.h"

#include "Core/Platform/OwnFile.h"

#include <cerrno>
#include <csignal>

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__APPLE__) // whose unistd.h does not declare it
extern char** environ;
#endif

namespace VolumeHaptics
{
namespace
{

/** Makes two sockets that are closed on exec and raise no signal. */
bool MakeLinks(int links[2])
{
#if defined(SOCK_CLOEXEC)
  return socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, links) == 0;
#else // macOS
  const bool areMade = socketpair(AF_UNIX, SOCK_STREAM, 0, links) == 0;
  for (int i = 0; areMade && i < 2; ++i)
  {
    constexpr int yes = 1;
    fcntl(links[i], F_SETFD, FD_CLOEXEC);
    setsockopt(links[i], SOL_SOCKET, SO_NOSIGPIPE, &yes, sizeof(yes));
  }
  return areMade;
#endif
}

} // namespace

bool HelperProcess::Start(
  const char* program, const void* code, std::string& obstacle, const std::string& argument)
{
  if (this->Link >= 0 && this->Owner == getpid())
  {
    return true;
  }
  this->End();
  std::string path = FindProgramOfLibrary(code, program, obstacle);
  int links[2];
  if (path.empty() || !MakeLinks(links))
  {
    return false;
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, links[1], STDIN_FILENO);
  // Hide the messages that libraries print about damaged files.
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t signals;
  sigemptyset(&signals);
  posix_spawnattr_setsigmask(&attributes, &signals);
  sigfillset(&signals);
  posix_spawnattr_setsigdefault(&attributes, &signals);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  std::string word = argument;
  char* words[] = { path.data(), word.empty() ? nullptr : word.data(), nullptr };
  const int result =
    posix_spawn(&this->Process, path.c_str(), &actions, &attributes, words, environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  close(links[1]);
  if (result != 0)
  {
    close(links[0]);
    this->Process = -1;
    return false;
  }
  this->Link = links[0];
  this->Owner = getpid();
  return true;
}

void HelperProcess::End()
{
  if (this->Link < 0)
  {
    return;
  }
  close(this->Link);
  this->Link = -1;
  // In a forked child, leave the process running, because it still works for the parent.
  if (this->Owner == getpid())
  {
    kill(this->Process, SIGKILL);
    while (waitpid(this->Process, nullptr, 0) < 0 && errno == EINTR)
    {
    }
  }
  this->Process = -1;
}

} // namespace VolumeHaptics
#endif
