// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticSignals.h"

#include "HapticSession.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <mutex>
#include <vector>

#if defined(__unix__)
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <thread>
#include <unistd.h>
#endif

namespace VolumeHaptics
{
namespace
{

struct Guarded
{
  std::mutex Mutex;
  std::vector<HapticSession*> Sessions;
};

/** Never destroyed: a signal may come while the process ends. */
Guarded& GetGuarded()
{
  static auto* const guarded = new Guarded;
  return *guarded;
}

#if defined(__unix__)
/** The process whose devices these are; a forked child has a copy of everything but those. */
pid_t Owner = 0;
#endif

void QuenchAll()
{
#if defined(__unix__)
  if (getpid() != Owner)
  {
    return; // in a forked child, the devices are the parent's
  }
#endif
  Guarded& guarded = GetGuarded();
  const std::lock_guard<std::mutex> lock(guarded.Mutex);
  for (HapticSession* session : guarded.Sessions)
  {
    session->Quench();
  }
}

#if defined(__unix__)

// Ctrl+Z stops all threads at once, and a device without a watchdog would keep its last force.
const int Signals[] = { SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP };
constexpr int SignalCount = 5;
struct sigaction Before[SignalCount];
int Pipe[2] = { -1, -1 };

extern "C" void OnSignal(int signal)
{
  const int keep = errno;
  if (getpid() != Owner)
  {
    // A forked child shares the pipe, but the devices and the thread at its other end are the
    // parent's. The signal comes again when this handler returns.
    const auto at = std::find(std::begin(Signals), std::end(Signals), signal);
    sigaction(signal, &Before[at - std::begin(Signals)], nullptr);
    raise(signal);
    errno = keep;
    return;
  }
  const auto byte = static_cast<unsigned char>(signal);
  const ssize_t written = write(Pipe[1], &byte, 1);
  static_cast<void>(written);
  errno = keep;
}

/** Puts our handler in front of whatever is there. */
void Install()
{
  for (int i = 0; i < SignalCount; ++i)
  {
    struct sigaction action = {};
    struct sigaction old = {};
    action.sa_handler = OnSignal;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(Signals[i], &action, &old);
    if (old.sa_handler != OnSignal)
    {
      Before[i] = old;
    }
  }
}

/** Puts back what was there, unless somebody else has put a handler in front of ours meanwhile. */
void Uninstall()
{
  for (int i = 0; i < SignalCount; ++i)
  {
    struct sigaction now = {};
    sigaction(Signals[i], nullptr, &now);
    if (now.sa_handler == OnSignal)
    {
      sigaction(Signals[i], &Before[i], nullptr);
    }
  }
}

void Watch()
{
  // Signals are for the threads that handled them before.
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
  unsigned char signal = 0;
  for (;;)
  {
    const ssize_t got = read(Pipe[0], &signal, 1);
    if (got == 1)
    {
      QuenchAll();
      {
        const std::lock_guard<std::mutex> lock(GetGuarded().Mutex);
        Uninstall();
      }
      kill(getpid(), signal);
    }
    else if (got == 0 || errno != EINTR)
    {
      return;
    }
  }
}

bool StartWatching()
{
  Owner = getpid();
  if (pipe(Pipe) != 0)
  {
    return false;
  }
  fcntl(Pipe[0], F_SETFD, FD_CLOEXEC);
  fcntl(Pipe[1], F_SETFD, FD_CLOEXEC);
  // A handler never blocks: with the pipe full a signal is on its way anyway.
  fcntl(Pipe[1], F_SETFL, O_NONBLOCK);
  std::thread(Watch).detach();
  return true;
}

#else

void Install() {}
void Uninstall() {}
bool StartWatching()
{
  return false;
}

#endif

} // namespace

void GuardSession(HapticSession* session)
{
  static const bool watching = StartWatching();
  static const int atExit = std::atexit(QuenchAll);
  static_cast<void>(atExit);
  Guarded& guarded = GetGuarded();
  const std::lock_guard<std::mutex> lock(guarded.Mutex);
  auto& sessions = guarded.Sessions;
  if (std::find(sessions.begin(), sessions.end(), session) == sessions.end())
  {
    sessions.push_back(session);
  }
  if (watching)
  {
    Install();
  }
}

void ReleaseSession(HapticSession* session)
{
  Guarded& guarded = GetGuarded();
  const std::lock_guard<std::mutex> lock(guarded.Mutex);
  auto& sessions = guarded.Sessions;
  sessions.erase(std::remove(sessions.begin(), sessions.end(), session), sessions.end());
  if (sessions.empty())
  {
    Uninstall();
  }
}

} // namespace VolumeHaptics
