// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/HapticSignals.h"

#include "Core/Realtime/CrashGuard.h"
#include "Core/Realtime/PerProcess.h"
#include "VTK/Device/ServoThreads.h"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <vector>

#if defined(_WIN32)
#include "Core/Platform/WindowsApi.h"

#include <atomic>
#include <csignal>
#include <thread>
#else
#include "VTK/Device/GuardedSignal.h"

#include <cerrno>
#include <fcntl.h>
#include <poll.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#endif

namespace VolumeHaptics
{
namespace
{

/**
 * Longest time (ms) that an ending process waits for its devices. A servo whose loop hangs takes 40
 * ms; the rest allows for a machine so busy that the watcher thread does not run.
 */
constexpr int LongestWait = 2000;

struct Guarded
{
  std::mutex Mutex;
  std::vector<ServoThreads*> Servos;
};

PerProcess<Guarded> GuardedOfProcess;

/**
 * Id of the process that owns the devices and the running watcher thread. A forked child inherits
 * copies of everything else, but has neither devices nor a watcher. Set last.
 */
std::atomic<std::int64_t> Owner{ 0 };

bool IsOwner() noexcept
{
  return ServoClock::GetProcess() == Owner.load();
}

#if defined(_WIN32)

class SignalsBlocked
{
};

#else

/**
 * Blocks signals on the calling thread for its lifetime. Without it, a handler on this thread would
 * wait for the watcher, which waits for this thread's mutex. Signals of a crash are not blocked, so
 * they always reach the earlier handlers.
 */
class SignalsBlocked
{
public:
  SignalsBlocked() noexcept
  {
    sigset_t sent;
    sigfillset(&sent);
    for (const int crash : { SIGSEGV, SIGBUS, SIGFPE, SIGILL })
    {
      sigdelset(&sent, crash);
    }
    pthread_sigmask(SIG_BLOCK, &sent, &this->Before);
  }
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &this->Before, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

private:
  sigset_t Before = {};
};

#endif

void QuenchAll() noexcept
{
  if (!IsOwner())
  {
    return; // forked child: the devices belong to the parent
  }
  [[maybe_unused]] const SignalsBlocked blocked{};
  Guarded& guarded = GuardedOfProcess.Get();
  for (int i = 0; i < LongestWait; ++i)
  {
    const std::unique_lock<std::mutex> lock(guarded.Mutex, std::try_to_lock);
    if (lock)
    {
      ServoThreads::Quench(guarded.Servos);
      return;
    }
    // Wait only for a limited time: the lock's owner may be the thread that ends the process.
    ServoClock::SleepUntil(ServoClock::Now() + ServoClock::Millisecond);
  }
}

#if defined(_WIN32)

HANDLE Asked = nullptr; ///< event that asks the watcher to end the force
std::atomic<DWORD> Watcher{ 0 };
std::atomic<unsigned> Answers{ 0 };
LPTOP_LEVEL_EXCEPTION_FILTER BeforeCrash = nullptr;
using AbortHandler = void (*)(int);
AbortHandler BeforeAbort = SIG_DFL;
bool IsInstalled = false;

/**
 * Asks the watcher to end the force, on its own stack and without this thread's locks. Safe on a
 * thread that crashes.
 */
void QuenchByWatcher() noexcept
{
  if (Watcher.load() == 0 || Watcher.load() == GetCurrentThreadId())
  {
    return; // the watcher itself crashed while it ended the force: nothing more can be done
  }
  const unsigned before = Answers.load();
  SetEvent(Asked);
  for (int i = 0; i < LongestWait && Answers.load() == before; ++i)
  {
    Sleep(1);
  }
}

/** Handles Ctrl+C, the closing of the console and the log-off, on a thread that Windows creates. */
BOOL WINAPI OnConsole(DWORD)
{
  QuenchAll();
  return FALSE; // lets the earlier handlers run next
}

LONG WINAPI OnCrash(EXCEPTION_POINTERS* what)
{
  QuenchByWatcher();
  return BeforeCrash ? BeforeCrash(what) : EXCEPTION_CONTINUE_SEARCH;
}

extern "C" void OnAbort(int number)
{
  QuenchByWatcher();
  std::signal(number, BeforeAbort);
  std::raise(number);
}

void Install()
{
  if (!IsInstalled)
  {
    IsInstalled = true;
    SetConsoleCtrlHandler(OnConsole, TRUE);
    BeforeCrash = SetUnhandledExceptionFilter(OnCrash);
    BeforeAbort = std::signal(SIGABRT, OnAbort);
  }
}

void Uninstall()
{
  if (!IsInstalled)
  {
    return;
  }
  IsInstalled = false;
  SetConsoleCtrlHandler(OnConsole, FALSE);
  // Leave handlers that were installed later in front: they call the handlers of this library.
  const LPTOP_LEVEL_EXCEPTION_FILTER filter = SetUnhandledExceptionFilter(BeforeCrash);
  if (filter != OnCrash)
  {
    SetUnhandledExceptionFilter(filter);
  }
  const AbortHandler handler = std::signal(SIGABRT, BeforeAbort);
  if (handler != OnAbort)
  {
    std::signal(SIGABRT, handler);
  }
}

void StartWatching()
{
  Asked = CreateEventW(nullptr, FALSE, FALSE, nullptr);
  std::thread(
    []
    {
      Watcher = GetCurrentThreadId();
      while (WaitForSingleObject(Asked, INFINITE) == WAIT_OBJECT_0)
      {
        QuenchAll();
        Answers.fetch_add(1);
      }
    })
    .detach();
}

/** Reserves stack space for the handler of a stack overflow. */
void PrepareThread()
{
  ULONG kept = 1 << 16;
  SetThreadStackGuarantee(&kept);
}

#else

GuardedSignal Signals[] = {
  // Signals that programs handle and continue after. Ctrl+Z stops all threads at once.
  { SIGINT, SignalManner::Deliver },
  { SIGTERM, SignalManner::Deliver },
  { SIGHUP, SignalManner::Deliver },
  { SIGQUIT, SignalManner::Deliver },
  { SIGTSTP, SignalManner::Deliver },
  // Signals of a crash, which other handlers may want to report.
  { SIGSEGV, SignalManner::Crash },
  { SIGBUS, SignalManner::Crash },
  { SIGFPE, SignalManner::Crash },
  { SIGILL, SignalManner::Crash },
  { SIGABRT, SignalManner::Crash },
  // Other signals whose default action ends or stops a process.
  { SIGALRM, SignalManner::CrashIfDefault },
  { SIGIO, SignalManner::CrashIfDefault },
  { SIGPIPE, SignalManner::CrashIfDefault },
  { SIGPROF, SignalManner::CrashIfDefault },
  { SIGSYS, SignalManner::CrashIfDefault },
  { SIGTRAP, SignalManner::CrashIfDefault },
  { SIGTTIN, SignalManner::CrashIfDefault },
  { SIGTTOU, SignalManner::CrashIfDefault },
  { SIGUSR1, SignalManner::CrashIfDefault },
  { SIGUSR2, SignalManner::CrashIfDefault },
  { SIGVTALRM, SignalManner::CrashIfDefault },
  { SIGXCPU, SignalManner::CrashIfDefault },
  { SIGXFSZ, SignalManner::CrashIfDefault },
#if defined(__linux__)
  { SIGPWR, SignalManner::CrashIfDefault },
  { SIGSTKFLT, SignalManner::CrashIfDefault },
#endif
};

GuardedSignal& FindSignal(int number) noexcept
{
  const auto at = std::find_if(std::begin(Signals), std::end(Signals),
    [number](const GuardedSignal& signal) { return signal.GetNumber() == number; });
  return *at;
}

int Pipe[2] = { -1, -1 };
pthread_t Watcher;
std::atomic<unsigned> Answers{ 0 };
/** Byte that only requests an answer; all other bytes are numbers of signals to deliver. */
constexpr unsigned char NoSignal = 0;

void Ask(unsigned char byte) noexcept
{
  const ssize_t written = write(Pipe[1], &byte, 1);
  static_cast<void>(written); // a write fails only if the pipe is full of requests
}

/**
 * Asks the watcher to end the force, on its own stack and without this thread's locks. Safe in a
 * signal handler.
 */
void QuenchByWatcher() noexcept
{
  if (!IsOwner() || pthread_equal(pthread_self(), Watcher))
  {
    return; // the watcher itself crashed while it ended the force: nothing more can be done
  }
  const unsigned before = Answers.load();
  Ask(NoSignal);
  for (int i = 0; i < LongestWait && Answers.load() == before; ++i)
  {
    poll(nullptr, 0, 1);
  }
}

/**
 * Handles signals whose default action is left to the watcher: it sends them again for the earlier
 * handlers.
 */
extern "C" void OnDelivered(int number)
{
  const int keep = errno;
  if (IsOwner())
  {
    Ask(static_cast<unsigned char>(number));
  }
  else
  {
    // A forked child shares the pipe, but the devices and the thread at its other end belong to the
    // parent. Raise the signal again here for the earlier handlers.
    GuardedSignal& signal = FindSignal(number);
    signal.PutBack(signal.CountBefore());
    raise(number);
  }
  errno = keep;
}

/**
 * Makes the crashed thread wait until the devices are safe, and then crash again without this
 * handler.
 */
extern "C" void OnCrash(int number, siginfo_t* info, void*)
{
  const int keep = errno;
  GuardedSignal& signal = FindSignal(number);
  const int count = signal.CountBefore();
  CrashGuard::RunAct(); // run this first, because a device's thread does not answer the watcher any
                        // more
  QuenchByWatcher();
  signal.PutBack(count);
  if (!ComesAgain(number, *info))
  {
    raise(number);
  }
  errno = keep;
}

void Install()
{
  for (GuardedSignal& signal : Signals)
  {
    signal.Install(OnDelivered, OnCrash);
  }
}

void Uninstall()
{
  for (GuardedSignal& signal : Signals)
  {
    signal.PutBack(signal.CountBefore());
  }
}

void Watch(int end)
{
  const SignalsBlocked blocked{}; // the threads that handled the signals before shall keep doing so
  unsigned char byte = NoSignal;
  for (;;)
  {
    const ssize_t got = read(end, &byte, 1);
    if (got == 1)
    {
      QuenchAll();
      Answers.fetch_add(1);
      if (byte != NoSignal)
      {
        {
          const std::lock_guard<std::mutex> lock(GuardedOfProcess.Get().Mutex);
          Uninstall();
        }
        kill(getpid(), byte);
      }
    }
    else if (got == 0 || errno != EINTR)
    {
      return;
    }
  }
}

/**
 * Starts the watcher. Throws std::system_error and cleans up if the process can get no pipe or no
 * thread.
 */
void StartWatching()
{
  if (pipe(Pipe) != 0)
  {
    throw std::system_error(errno, std::generic_category());
  }
  fcntl(Pipe[0], F_SETFD, FD_CLOEXEC);
  fcntl(Pipe[1], F_SETFD, FD_CLOEXEC);
  // A handler must never block. If the pipe is full, a signal is already on its way.
  fcntl(Pipe[1], F_SETFL, O_NONBLOCK);
  try
  {
    std::thread thread(Watch, Pipe[0]);
    Watcher = thread.native_handle();
    thread.detach();
  }
  catch (...)
  {
    close(Pipe[0]);
    close(Pipe[1]);
    throw;
  }
}

void PrepareThread()
{
  static thread_local const CrashGuard guard;
  static_cast<void>(guard);
}

#endif

std::terminate_handler BeforeTerminate = nullptr;

[[noreturn]] void OnTerminate() noexcept
{
  CrashGuard::RunAct();
  QuenchByWatcher();
  if (BeforeTerminate)
  {
    BeforeTerminate();
  }
  std::abort();
}

} // namespace

void GuardServo(ServoThreads* servo)
{
  static const bool hooked = []
  {
    BeforeTerminate = std::set_terminate(OnTerminate);
#if !defined(__APPLE__) && !defined(__MINGW32__) // macOS and MinGW lack quick_exit
    std::at_quick_exit(QuenchAll);
#endif
    return std::atexit(QuenchAll) == 0;
  }();
  static_cast<void>(hooked);
  PrepareThread();
  [[maybe_unused]] const SignalsBlocked blocked{};
  Guarded& guarded = GuardedOfProcess.Get();
  const std::lock_guard<std::mutex> lock(guarded.Mutex);
  auto& servos = guarded.Servos;
  if (!IsOwner())
  {
    // A forked child has inherited neither its parent's devices nor the watcher thread.
    StartWatching();
    Owner = ServoClock::GetProcess();
  }
  if (std::find(servos.begin(), servos.end(), servo) == servos.end())
  {
    servos.push_back(servo);
  }
  Install();
}

void ReleaseServo(ServoThreads* servo)
{
  [[maybe_unused]] const SignalsBlocked blocked{};
  Guarded& guarded = GuardedOfProcess.Get();
  const std::lock_guard<std::mutex> lock(guarded.Mutex);
  auto& servos = guarded.Servos;
  servos.erase(std::remove(servos.begin(), servos.end(), servo), servos.end());
  if (servos.empty() && IsOwner())
  {
    Uninstall();
  }
}

} // namespace VolumeHaptics
