// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests work in the background. Its owner waits for it only on request, and never receives a result
 * for outdated data.
 */

#include "Core/Realtime/BackgroundWork.h"

#include "Rigs/Eventually.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <string>
#include <thread>

#if defined(__unix__)
#include <sys/wait.h>
#include <unistd.h>
#endif

using namespace VolumeHaptics;
using devicetest::Eventually;

namespace
{
using Work = KeyedWork<int, std::string>;

/// Makes tasks that run until the gate is opened or the work is cancelled. Copies share their
/// state, because a task may outlive a test's gate.
class Gate
{
  struct Passage
  {
    std::atomic<bool> IsOpen{ false };
    std::atomic<int> Entered{ 0 };
    std::atomic<int> Left{ 0 };
  };
  std::shared_ptr<Passage> Shared = std::make_shared<Passage>();

public:
  std::optional<std::string> Pass(WorkMonitor& monitor, const std::string& result) const
  {
    ++this->Entered;
    while (!this->IsOpen && !monitor.IsCancelled())
    {
      std::this_thread::yield();
    }
    ++this->Left;
    return monitor.IsCancelled() ? std::nullopt : std::optional<std::string>(result);
  }
  Work::Maker Make(const std::string& result) const
  {
    return [gate = *this, result](WorkMonitor& monitor) { return gate.Pass(monitor, result); };
  }

  std::atomic<bool>& IsOpen = this->Shared->IsOpen;
  std::atomic<int>& Entered = this->Shared->Entered;
  std::atomic<int>& Left = this->Shared->Left;
};
} // namespace

TEST(BackgroundWork, GivesAResultWhenItIsKnownAndMakesItOnce)
{
  Gate gate;
  Work work;
  EXPECT_FALSE(work.IsUnderWay());
  EXPECT_EQ(work.Poll(1, gate.Make("one")), nullptr);
  EXPECT_TRUE(work.IsUnderWay());
  ASSERT_TRUE(Eventually([&] { return gate.Entered == 1; }));
  EXPECT_EQ(work.Poll(1, gate.Make("another")), nullptr);
  gate.IsOpen = true;
  ASSERT_TRUE(work.WaitFor(60.0));
  for (int i = 0; i < 3; ++i)
  {
    const std::string* const result = work.Poll(1, gate.Make("another"));
    ASSERT_NE(result, nullptr);
    EXPECT_EQ(*result, "one");
  }
  EXPECT_FALSE(work.IsUnderWay());
  EXPECT_EQ(gate.Entered, 1);
}

TEST(BackgroundWork, OfDataThatChangeBeginsAgain)
{
  Gate old;
  Gate gate;
  Work work;
  work.Poll(1, old.Make("old"));
  ASSERT_TRUE(Eventually([&] { return old.Entered == 1; }));
  const Work::Maker make = [old, gate](WorkMonitor& monitor)
  {
    EXPECT_EQ(old.Left, 1) << "the old work has ended before the new one begins";
    return gate.Pass(monitor, "new");
  };
  EXPECT_EQ(work.Poll(2, make), nullptr);
  gate.IsOpen = true;
  const std::string* result = nullptr;
  ASSERT_TRUE(Eventually([&] { return (result = work.Poll(2, gate.Make("new"))) != nullptr; }));
  EXPECT_EQ(*result, "new");
  // The key changes after the work has returned, and before its owner polls. The result of the old
  // key must be discarded.
  Work other;
  other.Poll(1, gate.Make("old"));
  ASSERT_TRUE(other.WaitFor(60.0));
  const std::string* const none = other.Poll(2, gate.Make("new"));
  EXPECT_TRUE(!none || *none == "new");
  ASSERT_TRUE(Eventually([&] { return (result = other.Poll(2, gate.Make("new"))) != nullptr; }));
  EXPECT_EQ(*result, "new");
}

TEST(BackgroundWork, IsCancelledByItsOwner)
{
  Gate gate;
  Work work;
  work.Poll(1, gate.Make("one"));
  ASSERT_TRUE(Eventually([&] { return gate.Entered == 1; }));
  work.Forget();
  EXPECT_FALSE(work.IsUnderWay());
  EXPECT_TRUE(Eventually([&] { return gate.Left == 1; }));
  {
    Work gone;
    gone.Poll(1, gate.Make("one"));
    ASSERT_TRUE(Eventually([&] { return gate.Entered == 2; }));
  }
  EXPECT_TRUE(Eventually([&] { return gate.Left == 2; }));
  // After a cancellation, new work must be able to start.
  gate.IsOpen = true;
  ASSERT_TRUE(Eventually([&] { return work.Poll(1, gate.Make("one")) != nullptr; }));
}

TEST(BackgroundWork, ThatIsAbandonedIsNotWaitedForAndHasNoResult)
{
  std::atomic<bool> isOpen{ false };
  std::atomic<int> entered{ 0 };
  const Work::Maker stubborn = [&](WorkMonitor& monitor) -> std::optional<std::string>
  {
    ++entered;
    while (!isOpen) // ignores cancellation
    {
      std::this_thread::yield();
    }
    return monitor.IsCancelled() ? std::nullopt : std::optional<std::string>("made");
  };
  Work work;
  EXPECT_EQ(work.Poll(1, stubborn), nullptr);
  ASSERT_TRUE(Eventually([&] { return entered == 1; }));
  work.Abandon(); // must return at once: the task ends only after isOpen is set
  EXPECT_TRUE(work.IsUnderWay());
  EXPECT_FALSE(work.IsOf(1));
  EXPECT_EQ(work.Find(1), nullptr);
  isOpen = true;
  ASSERT_TRUE(Eventually([&] { return !work.IsUnderWay(); }));
  EXPECT_EQ(work.Find(1), nullptr) << "it was cancelled";
  ASSERT_TRUE(Eventually([&] { return work.Poll(1, stubborn) != nullptr; }));
  EXPECT_EQ(*work.Find(1), "made");
  EXPECT_EQ(entered, 2);
  work.Abandon();
  EXPECT_EQ(work.Find(1), nullptr) << "nothing is kept of work that has ended";
}

TEST(BackgroundWork, LetsItsOwnerReleaseWhatItHolds)
{
  std::thread::id releaser;
  Gate gate;
  Work work;
  {
    const std::shared_ptr<int> held(new int(5),
      [&releaser](int* number)
      {
        releaser = std::this_thread::get_id();
        delete number;
      });
    const auto make = [held, gate](WorkMonitor& monitor)
    { return gate.Pass(monitor, std::to_string(*held)); };
    work.Poll(1, make);
  }
  gate.IsOpen = true;
  ASSERT_TRUE(work.WaitFor(60.0));
  EXPECT_EQ(releaser, std::thread::id()) << "not by the worker";
  const std::string* const result = work.Poll(1, gate.Make("another"));
  ASSERT_NE(result, nullptr);
  EXPECT_EQ(*result, "5");
  EXPECT_EQ(releaser, std::this_thread::get_id());
}

/// The owner must not wait for work that ignores cancellation.
TEST(BackgroundWork, ThatEndsIsNotWaitedFor)
{
  std::atomic<bool> isOpen{ false };
  std::atomic<int> entered{ 0 };
  std::atomic<int> left{ 0 };
  std::atomic<int> most{ 0 };
  std::atomic<int> released{ 0 };
  const std::thread::id owner = std::this_thread::get_id();
  const auto makeStubborn = [&]
  {
    const std::shared_ptr<int> held(new int(7),
      [&released, owner](int* number)
      {
        released += std::this_thread::get_id() == owner ? 1 : 1000;
        delete number;
      });
    return [&, held](WorkMonitor&) -> std::optional<std::string>
    {
      ++entered;
      most = std::max(most.load(), entered - left);
      while (!isOpen)
      {
        std::this_thread::yield();
      }
      ++left;
      return std::to_string(*held);
    };
  };
  Work work;
  EXPECT_EQ(work.Poll(1, makeStubborn()), nullptr);
  ASSERT_TRUE(Eventually([&] { return entered == 1; }));
  work.Forget(); // must return at once: the task ends only after isOpen is set
  EXPECT_EQ(work.Poll(2, makeStubborn()), nullptr);
  EXPECT_EQ(work.Poll(3, makeStubborn()), nullptr);
  {
    Work gone;
    gone.Poll(1, [](WorkMonitor&) { return std::optional<std::string>("gone"); });
  }
  EXPECT_EQ(left, 0);
  EXPECT_EQ(released, 0) << "not while the tasks go on";
  isOpen = true;
  const std::string* result = nullptr;
  ASSERT_TRUE(Eventually([&] { return (result = work.Find(3)) != nullptr; }));
  EXPECT_EQ(*result, "7");
  EXPECT_EQ(entered, 2) << "what is cancelled before it begins is not done";
  EXPECT_EQ(most, 1) << "one after another";
  ASSERT_TRUE(Eventually(
    [&]
    {
      work.IsUnderWay();
      return work.Find(3) && released == 3;
    }))
    << released << ": each by the owner";
}

/// A thread's end waits for the work that the thread owns, so that no work outlives it.
TEST(BackgroundWork, EndsWithTheThreadThatBeganIt)
{
  Gate gate;
  std::thread(
    [&gate]
    {
      Work work;
      work.Poll(1, gate.Make("one"));
      EXPECT_TRUE(Eventually([&] { return gate.Entered == 1; }));
    })
    .join();
  EXPECT_EQ(gate.Entered, 1);
  EXPECT_EQ(gate.Left, 1);
}

namespace
{
/// Owns work and is destroyed after everything else of its thread, like a static object.
struct LateOwner
{
  ~LateOwner()
  {
    this->HeldWork.reset();
    if (this->Left)
    {
      this->AreEnded = *this->Left == 1;
    }
  }
  std::unique_ptr<Work> HeldWork;
  std::atomic<int>* Left = nullptr;
  static std::atomic<bool> AreEnded;
};
std::atomic<bool> LateOwner::AreEnded{ false };
} // namespace

TEST(BackgroundWork, EndsWithAnOwnerThatOutlivesItsThread)
{
  std::atomic<int> left{ 0 };
  std::atomic<bool> isEntered{ false };
  std::thread(
    [&]
    {
      thread_local LateOwner owner; // constructed first, so that it is destroyed last
      owner.Left = &left;
      owner.HeldWork = std::make_unique<Work>();
      owner.HeldWork->Poll(1,
        [&](WorkMonitor& monitor) -> std::optional<std::string>
        {
          isEntered = true;
          while (monitor.GoesOn(0.0))
          {
            std::this_thread::yield();
          }
          ++left;
          return std::nullopt;
        });
      EXPECT_TRUE(Eventually([&] { return isEntered.load(); }));
    })
    .join();
  EXPECT_TRUE(LateOwner::AreEnded);
  EXPECT_EQ(left, 1);
}

TEST(BackgroundWork, TellsItsProgress)
{
  Gate gate;
  Work work;
  EXPECT_EQ(work.GetProgress(), 0.0);
  work.Poll(1,
    [gate](WorkMonitor& monitor)
    {
      monitor.SetProgress(0.25);
      return gate.Pass(monitor, "");
    });
  ASSERT_TRUE(Eventually([&] { return gate.Entered == 1; }));
  EXPECT_EQ(work.GetProgress(), 0.25);
  EXPECT_FALSE(work.WaitFor(0.01)) << "its owner does not wait longer than it says";
}

TEST(BackgroundWork, WithoutMemoryHasNoResult)
{
  Work work;
  const Work::Maker make = [](WorkMonitor&) -> std::optional<std::string>
  { throw std::bad_alloc(); };
  EXPECT_EQ(work.Poll(1, make), nullptr);
  ASSERT_TRUE(work.WaitFor(60.0));
  EXPECT_EQ(work.Poll(1, make), nullptr);
  EXPECT_FALSE(work.IsUnderWay());
}

// The thread sanitizer can't trace a fork of a multithreaded program.
#if defined(__unix__) && !defined(__SANITIZE_THREAD__)
TEST(BackgroundWork, OfAParentIsNotWaitedForInAForkedChild)
{
  Gate gate;
  auto work = std::make_unique<Work>();
  work->Poll(1, gate.Make("one"));
  ASSERT_TRUE(Eventually([&] { return gate.Entered == 1; }));
  const pid_t child = fork();
  if (child == 0)
  {
    alarm(30);
    const bool isQuiet =
      !work->IsUnderWay() && !work->WaitFor(0.01) && !work->Poll(1, gate.Make("one"));
    work.reset();
    Work own;
    gate.IsOpen = true;
    own.Poll(2, gate.Make("two"));
    const bool isDone = own.WaitFor(20.0) && own.Poll(2, gate.Make("two"));
    _exit(isQuiet && isDone ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
}

/// A forked child must wait neither for the parent's work nor for its task, which still runs after
/// the parent has ended the work.
TEST(BackgroundWork, OfAParentThatHasEndedItDoesNotHoldBackThatOfAChild)
{
  Gate gate;
  Work work;
  // The task shares these flags, because it may outlive the test.
  const auto mayLeave = std::make_shared<std::atomic<bool>>(false);
  const auto isEntered = std::make_shared<std::atomic<bool>>(false);
  work.Poll(1,
    [mayLeave, isEntered](WorkMonitor&) -> std::optional<std::string>
    {
      *isEntered = true;
      while (!*mayLeave)
      {
        std::this_thread::yield();
      }
      return std::nullopt;
    });
  ASSERT_TRUE(Eventually([&] { return isEntered->load(); }));
  work.Forget();
  const pid_t child = fork();
  if (child == 0)
  {
    alarm(30);
    gate.IsOpen = true;
    work.Poll(2, gate.Make("two"));
    const bool isDone = work.WaitFor(20.0) && work.Poll(2, gate.Make("two"));
    _exit(isDone ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  *mayLeave = true;
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
}
#endif
