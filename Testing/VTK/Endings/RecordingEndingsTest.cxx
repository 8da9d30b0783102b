// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests programs that crash or exit while they record, and children that are forked during a
 * recording.
 */

#include "Rigs/RecordingFailureRig.h"

#include <csignal>
#include <cstdlib>
#include <sys/wait.h>

using namespace devicetest;

namespace
{
struct EventCount
{
  void Add(vtkObject*, unsigned long, void*) { ++this->Count; }
  int Count = 0;
};

/// Closes a device at process exit, after the destructors of all objects in main().
struct LastOwner
{
  ~LastOwner()
  {
    if (this->Device)
    {
      this->Device->Close();
    }
  }
  vtkHapticDevice* Device = nullptr;
};
LastOwner Owner;
} // namespace

TEST_F(RecordingFailure, OfTheProgramKeepsWhatThereIs)
{
  const std::string file = this->In("killed.vtp");
  const pid_t child = fork();
  if (child == 0)
  {
    this->Begin();
    this->Device->GetRecorder()->Start(file.c_str());
    this->WanderForTwoGroups(file);
    kill(getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_FALSE(Exists(file));

  // A new recording with the same name must neither fail nor remove the journal.
  this->Begin();
  ASSERT_TRUE(this->Device->GetRecorder()->Start(file.c_str()));
  ASSERT_EQ(this->Log.Warnings.size(), 1U);
  EXPECT_NE(this->Log.Warnings[0].find(file + ".part.1"), std::string::npos)
    << this->Log.Warnings[0];
  EXPECT_FALSE(
    this->Device->GetRecorder()->Recover((file + ".part").c_str(), this->In("b.vtp").c_str()));
  this->ExpectError("under way");
  ASSERT_TRUE(this->Device->GetRecorder()->Stop());
  this->Device->Close();
  // Writing two groups takes 512 lines of 20 us each, which is long work for the shortest attention
  // time of 0.05 s.
  EventCount begins;
  this->Device->AddObserver(vtkCommand::StartEvent, &begins, &EventCount::Add);
  this->Device->SetAttentionTime(0.05);
  const std::string copy = this->In("copy.part");
  vtksys::SystemTools::CopyAFile(file + ".part.1", copy);
  ASSERT_TRUE(this->Device->GetRecorder()->Recover(copy.c_str(), this->In("copy.csv").c_str()));
  EXPECT_EQ(begins.Count, 1);
  ASSERT_TRUE(this->Device->GetRecorder()->Recover((file + ".part.1").c_str(), file.c_str()));
  this->ExpectReplays(file, 512);
}

TEST_F(RecordingFailure, IsNotThatTheProgramExits)
{
  const std::string file = this->In("exited.vtp");
  const pid_t child = fork();
  if (child == 0)
  {
    this->Begin();
    this->Device->GetRecorder()->Start(file.c_str());
    this->WanderForTwoGroups(file);
    Owner.Device = this->Device;
    std::exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  EXPECT_FALSE(Exists(file + ".part"));
  this->ExpectReplays(file, 512);
}

TEST_F(RecordingFailure, DoesNotComeFromAForkedChild)
{
  const std::string file = this->In("forked.vtp");
  this->Begin();
  this->Wander(5);
  ASSERT_TRUE(this->Device->GetRecorder()->Start(file.c_str()));
  ASSERT_TRUE(this->WaitTicks(300));
  const pid_t child = fork();
  if (child == 0)
  {
    // The child must neither wait for threads that it does not have, nor end the parent's
    // recording.
    this->Device->Close();
    _exit(this->Log.Errors.empty() ? 0 : 1);
  }
  ASSERT_TRUE(this->WaitTicks(300));
  ASSERT_TRUE(this->Device->GetRecorder()->Stop());
  int status = 0;
  const bool ended = Eventually([&] { return waitpid(child, &status, WNOHANG) == child; });
  if (!ended)
  {
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
  }
  EXPECT_TRUE(ended && WIFEXITED(status) && WEXITSTATUS(status) == 0);
  this->ExpectReplays(file, 600);
}
