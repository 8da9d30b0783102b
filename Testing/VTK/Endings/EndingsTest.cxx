// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that every end of a process that can still run code leaves the device without force. The
 * process must end as it would without a device.
 */

#include "EndingsRig.h"

#include <cstdlib>
#include <exception>
#include <pthread.h>
#include <stdexcept>
#include <sys/time.h>

using namespace devicetest;

namespace
{
/// Raises a signal, and waits until it ends the process.
void Raise(int signal)
{
  std::raise(signal);
  Eventually([] { return false; });
}

/// Overflows the stack.
int Recurse(int depth)
{
  volatile char room[4096];
  room[0] = static_cast<char>(depth);
  return depth < 0 ? 0 : Recurse(depth + 1) + room[0];
}

/// Divides by zero in a way that compilers can't detect.
#if defined(__GNUC__)
__attribute__((no_sanitize("undefined")))
#endif
int DivideByZero()
{
  volatile int zero = 0;
  volatile int seven = 7;
  return seven / zero;
}

void OnFatal(int, siginfo_t* info, void*)
{
  Lasting->Handle();
  Lasting->Address = info->si_addr;
  _exit(42);
}

void Handle(int signal, void (*handler)(int, siginfo_t*, void*))
{
  struct sigaction action = {};
  action.sa_sigaction = handler;
  action.sa_flags = SA_SIGINFO;
  sigaction(signal, &action, nullptr);
}

/// Acts like a crash reporter: reports the crash, restores the earlier action, and raises the
/// signal again.
struct sigaction BeforeReporter;
void Report(int signal)
{
  Lasting->Handle();
  sigaction(signal, &BeforeReporter, nullptr);
  std::raise(signal);
}
void AddReporter(int signal)
{
  struct sigaction action = {};
  action.sa_handler = Report;
  action.sa_flags = SA_NODEFER;
  sigaction(signal, &action, &BeforeReporter);
}
} // namespace

TEST_F(Endings, ByASignalWithoutAHandler)
{
  for (const int signal : { SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS, SIGPIPE,
         SIGALRM, SIGVTALRM, SIGPROF, SIGUSR1, SIGUSR2, SIGXCPU, SIGXFSZ, SIGIO, SIGPWR, SIGSTKFLT,
         SIGTERM, SIGINT, SIGHUP, SIGQUIT })
  {
    EXPECT_EQ(this->End([&] { Raise(signal); }), -signal) << strsignal(signal);
  }
  for (const int signal : { SIGSEGV, SIGUSR1 })
  {
    const auto kills = [&]
    {
      kill(getpid(), signal);
      Eventually([] { return false; });
    };
    EXPECT_EQ(this->End(kills), -signal) << strsignal(signal) << " from elsewhere";
  }
}

TEST_F(Endings, ByACrash)
{
  EXPECT_EQ(this->End([] { WriteToNowhere(); }), -SIGSEGV);
  EXPECT_EQ(this->End([] { Recurse(1); }), -SIGSEGV) << "the stack is full";
  EXPECT_EQ(this->End([] { std::abort(); }), -SIGABRT);
#if defined(__x86_64__)
  EXPECT_EQ(this->End([] { DivideByZero(); }), -SIGFPE);
#endif
  EXPECT_EQ(this->End([] { std::thread(WriteToNowhere).join(); }), -SIGSEGV) << "in a thread";
  EXPECT_EQ(this->End(
              []
              {
                int ends[2];
                [[maybe_unused]] int done = pipe(ends);
                close(ends[0]);
                [[maybe_unused]] const ssize_t size = write(ends[1], "", 1);
                std::_Exit(5); // not reached after a write to a closed pipe
              }),
    -SIGPIPE);
}

TEST_F(Endings, ByACrashInTheServoItself)
{
  EXPECT_EQ(this->End(
              []
              {
                Lasting->CrashesInRead = true;
                Eventually([] { return false; });
              }),
    -SIGSEGV);
}

TEST_F(Endings, ByACrashWhileItIsStopped)
{
  EXPECT_EQ(this->End(
              [this]
              {
                // after this time (ms), only a guard can have ended the force
                Lasting->TimeToCrash = 20;
                Lasting->CrashesInRead = true;
                Eventually([] { return Lasting->IsCrashing.load(); });
                this->Device->Stop(); // returns only after the servo's end
              }),
    -SIGSEGV);
}

TEST_F(Endings, ByASignalWhileItIsArmed)
{
  // Interrupt Arm(), which may hold a lock. The handler must not wait for this lock.
  for (const int signal : { SIGUSR1, SIGABRT })
  {
    const auto kills = [&]
    {
      const pthread_t owner = pthread_self();
      std::thread(
        [=]
        {
          poll(nullptr, 0, 20);
          pthread_kill(owner, signal);
        })
        .detach();
      Eventually(
        [this]
        {
          for (int i = 0; i < 1000; ++i)
          {
            this->Device->Arm();
          }
          return false;
        });
    };
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_EQ(this->End(kills), -signal) << strsignal(signal);
    }
  }
}

TEST_F(Endings, AreGuardedOrTheServoDoesNotStart)
{
  const auto starts = [this]
  {
    const int unused = dup(STDIN_FILENO);
    close(unused);
    rlimit files{};
    getrlimit(RLIMIT_NOFILE, &files);
    const rlimit few{ static_cast<rlim_t>(unused), files.rlim_max };
    setrlimit(RLIMIT_NOFILE, &few);
    EXPECT_TRUE(this->Device->Open("lasting:0"));
    EXPECT_FALSE(this->Device->Start());
    this->ExpectError("ulimit -n");
    EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::READY);
    setrlimit(RLIMIT_NOFILE, &files);
    this->Feel();
    return HasFailure() ? 1 : 77;
  };
  EXPECT_EQ(InChild(
              [&]
              {
                const int result = starts();
                result == 77 ? WriteToNowhere() : void();
                return result;
              }),
    -SIGSEGV);
  EXPECT_TRUE(Lasting->HadForce);
  EXPECT_EQ(Lasting->GetForce(), 0.0);
}

TEST_F(Endings, ByACrashInWhatEndsTheForce)
{
  // The device itself crashes when its force should end. This force can't be ended, but the process
  // must end.
  const auto endBy = [this](void (*how)())
  {
    return InChild(
      [&]
      {
        this->Feel();
        Lasting->CrashesInQuench = true;
        how();
        return 77;
      });
  };
  EXPECT_EQ(endBy(WriteToNowhere), -SIGSEGV);
  EXPECT_EQ(endBy([] { Raise(SIGTERM); }), -SIGSEGV);
}

TEST_F(Endings, ByManyThreadsThatCrashAtOnce)
{
  const auto crash = []
  {
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i)
    {
      threads.emplace_back(WriteToNowhere);
    }
    threads.front().join();
  };
  EXPECT_EQ(this->End(crash), -SIGSEGV);
  Handle(SIGSEGV,
    [](int number, siginfo_t* info, void* context)
    {
      poll(nullptr, 0, 50); // a report takes some time
      OnFatal(number, info, context);
    });
  EXPECT_EQ(this->End(crash), 42) << "none of them passes a handler by";
  std::signal(SIGSEGV, SIG_DFL);
}

TEST_F(Endings, ByAnException)
{
  const auto throws = [] { throw std::runtime_error("for a test"); };
  const auto isUncaught = [&]() noexcept { throws(); };
  EXPECT_EQ(this->End(isUncaught), -SIGABRT);
  EXPECT_EQ(this->End([&] { std::thread(throws).join(); }), -SIGABRT);
  std::set_terminate(
    []
    {
      Lasting->Handle();
      _exit(43);
    });
  EXPECT_EQ(this->End(isUncaught), 43);
  EXPECT_EQ(Lasting->Handled, 1);
  EXPECT_EQ(Lasting->ForceWhenHandled, 0.0);
}

TEST_F(Endings, ByExiting)
{
  EXPECT_EQ(this->End([] { std::exit(3); }), 3);
  EXPECT_EQ(this->End([] { std::quick_exit(4); }), 4);
}

TEST_F(Endings, OfAHandlerThatWasThereBefore)
{
  Handle(SIGSEGV, OnFatal);
  Lasting->Address = &Lasting->Address;
  EXPECT_EQ(this->End(WriteToNowhere), 42);
  EXPECT_EQ(Lasting->Handled, 1);
  EXPECT_EQ(Lasting->ForceWhenHandled, 0.0);
  EXPECT_EQ(Lasting->Address, nullptr) << "it gets the address";
  Handle(SIGABRT, OnFatal);
  EXPECT_EQ(this->End([] { std::abort(); }), 42);
  EXPECT_EQ(Lasting->ForceWhenHandled, 0.0);
  std::signal(SIGSEGV, SIG_DFL);
  std::signal(SIGABRT, SIG_DFL);
}

TEST_F(Endings, OfACrashReporterBeforeAndAfter)
{
  for (const int signal : { SIGSEGV, SIGABRT })
  {
    EXPECT_EQ(this->End(
                [&]
                {
                  AddReporter(signal);
                  Raise(signal);
                }),
      -signal)
      << "added to an armed device";
    EXPECT_EQ(Lasting->Handled, 1);
    this->Forget();
    AddReporter(signal);
    EXPECT_EQ(this->End([&] { Raise(signal); }), -signal);
    EXPECT_EQ(Lasting->Handled, 1);
    EXPECT_EQ(Lasting->ForceWhenHandled, 0.0);
    std::signal(signal, SIG_DFL);
    this->Forget();
    EXPECT_EQ(this->End(
                [&]
                {
                  AddReporter(signal);
                  this->Device->Arm();
                  Raise(signal);
                }),
      -signal)
      << "armed again with it";
    EXPECT_EQ(Lasting->Handled, 1);
    EXPECT_EQ(Lasting->ForceWhenHandled, 0.0);
    this->Forget();
  }
}

TEST_F(Endings, AreNotSignalsThatTheApplicationHandles)
{
  EXPECT_EQ(InChild(
              [this]
              {
                for (const int signal : { SIGUSR1, SIGALRM, SIGPIPE, SIGPROF })
                {
                  std::signal(signal, [](int) { Lasting->Handle(); });
                }
                std::signal(SIGUSR2, SIG_IGN);
                this->Feel();
                itimerval soon{};
                soon.it_value.tv_usec = 1000;
                setitimer(ITIMER_REAL, &soon, nullptr);
                for (const int signal : { SIGUSR1, SIGPIPE, SIGPROF, SIGUSR2 })
                {
                  std::raise(signal);
                }
                const bool handled = Eventually([] { return Lasting->Handled == 4; });
                this->Device->UpdateState();
                return handled && Lasting->ForceWhenHandled > 0.0 && Lasting->GetForce() > 0.0 ? 0
                                                                                               : 1;
              }),
    0);
}

TEST_F(Endings, OfAChildProcessAreItsOwn)
{
  EXPECT_EQ(InChild(
              [this]
              {
                this->Feel();
                const pid_t child = fork();
                if (child == 0)
                {
                  WriteToNowhere();
                }
                return Wait(child) == -SIGSEGV && Lasting->GetForce() > 0.0 ? 0 : 1;
              }),
    0);
  // A process whose parent has closed its device must be able to open its own device.
  EXPECT_EQ(InChild(
              [this]
              {
                this->Feel();
                this->Device->Close();
                return this->End([] { WriteToNowhere(); }) == -SIGSEGV && !HasFailure() ? 0 : 1;
              }),
    0);
}

TEST_F(Endings, AreStopsToo)
{
  for (const int signal : { SIGTSTP, SIGTTIN, SIGTTOU })
  {
    const pid_t child = fork();
    if (child == 0)
    {
      // Make a separate process group, because the kernel does not stop processes of an orphaned
      // group.
      setpgid(0, 0);
      this->Feel();
      std::raise(signal);
      Eventually([] { return false; });
      _exit(77);
    }
    int status = 0;
    EXPECT_TRUE(Eventually([&] { return waitpid(child, &status, WNOHANG | WUNTRACED) == child; }));
    EXPECT_TRUE(WIFSTOPPED(status)) << strsignal(signal);
    EXPECT_TRUE(Lasting->HadForce);
    EXPECT_EQ(Lasting->GetForce(), 0.0) << strsignal(signal);
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
  }
}
