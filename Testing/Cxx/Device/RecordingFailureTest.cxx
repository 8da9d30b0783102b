// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Disks that are full, folders that may not be written and programs that die while they record: every one is told at
 * once, and what was written can be read.
 */

#include "FullDisk.h"
#include "RecordingRig.h"

#include <fstream>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vtksys/SystemTools.hxx>

using namespace devicetest;

namespace
{

/// As long as this lives, permissions count for this process even if it is root's.
class NobodysRights
{
public:
  NobodysRights()
    : WasRoot(geteuid() == 0)
  {
    constexpr uid_t nobody = 65534;
    this->IsGood = !this->WasRoot || seteuid(nobody) == 0;
  }
  ~NobodysRights()
  {
    if (this->WasRoot)
    {
      (void)!seteuid(0);
    }
  }
  NobodysRights(const NobodysRights&) = delete;
  NobodysRights& operator=(const NobodysRights&) = delete;
  bool IsGood;

private:
  const bool WasRoot;
};

bool Exists(const std::string& file)
{
  return access(file.c_str(), F_OK) == 0;
}

std::string Load(const std::string& file)
{
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

class RecordingFailure : public Recording
{
protected:
  RecordingFailure()
  {
    vtksys::SystemTools::RemoveADirectory(this->Folder);
    vtksys::SystemTools::MakeDirectory(this->Folder);
  }
  ~RecordingFailure() override
  {
    chmod(this->Folder.c_str(), 0755);
    vtksys::SystemTools::RemoveADirectory(this->Folder);
  }
  std::string In(const char* name) const { return this->Folder + "/" + name; }
  void ExpectNoStart(const std::string& file, const char* words)
  {
    EXPECT_FALSE(this->Device->StartRecording(file.c_str())) << file;
    ASSERT_EQ(this->Log.Errors.size(), 1U) << file;
    EXPECT_NE(this->Log.Errors[0].find(file), std::string::npos) << this->Log.Errors[0];
    this->ExpectError(words);
    EXPECT_FALSE(Exists(file + ".part"));
  }
  /// Records until a disk of so many bytes is full, and expects to be told.
  void FillTheDisk(const std::string& file, rlim_t bytes)
  {
    this->Begin();
    ASSERT_TRUE(this->Device->StartRecording(file.c_str()));
    const FullDisk full(bytes);
    // A tip that rests takes few bytes.
    for (int i = 0; i < 1000 && this->Log.Errors.empty(); ++i)
    {
      this->Wander(5);
    }
    ASSERT_EQ(this->Log.Errors.size(), 1U);
    EXPECT_NE(this->Log.Errors[0].find(file), std::string::npos);
    this->ExpectError("Make room");
    EXPECT_NE(this->Device->GetStatusText().find("Make room"), std::string::npos);
    EXPECT_TRUE(this->WaitTicks(10)) << "the servo goes on";
    EXPECT_TRUE(this->Log.Errors.empty()) << "it is told once";
    EXPECT_FALSE(this->Device->StopRecording());
    this->ExpectError(".part");
    EXPECT_EQ(this->Device->GetStatusText().find("Make room"), std::string::npos);
  }
  /// What the file holds is what the filter makes of it.
  void ExpectReplays(const std::string& file, vtkIdType leastTicks)
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    ASSERT_GE(reader->GetOutput()->GetNumberOfPoints(), leastTicks);
    this->Filter->SetInputData(1, reader->GetOutput());
    this->Filter->Update();
    ASSERT_EQ(
      this->Filter->GetOutput()->GetNumberOfPoints(), reader->GetOutput()->GetNumberOfPoints());
    vtkDataArray* const here = this->Filter->GetOutput()->GetPointData()->GetArray("Force");
    vtkDataArray* const there = reader->GetOutput()->GetPointData()->GetArray("Force");
    for (vtkIdType i = 0; i < here->GetNumberOfTuples(); ++i)
    {
      ASSERT_EQ(std::memcmp(here->GetTuple(i), there->GetTuple(i), 3 * sizeof(double)), 0) << i;
    }
  }

  const std::string Folder = testing::TempDir() + "VolumeHapticsFailure" + std::to_string(getpid());
};

} // namespace

TEST_F(RecordingFailure, ShowsAtTheStart)
{
  this->Begin();
  this->ExpectNoStart(this->In("a.txt"), ".vtp or .csv");
  this->ExpectNoStart(this->In("missing/a.vtp"), "no folder");
  this->ExpectNoStart(this->In("missing/a.csv"), "no folder");
  vtksys::SystemTools::MakeDirectory(this->In("folder.vtp"));
  this->ExpectNoStart(this->In("folder.vtp"), "is a folder");
  ASSERT_EQ(mkfifo(this->In("pipe.vtp").c_str(), 0644), 0);
  this->ExpectNoStart(this->In("pipe.vtp"), "is a pipe");
  {
    const FullDisk full(0);
    this->ExpectNoStart(this->In("full.vtp"), "Make room");
  }
  std::ofstream(this->In("mine.vtp")) << "good";
  chmod(this->In("mine.vtp").c_str(), 0444);
  {
    chmod(this->Folder.c_str(), 0777);
    const NobodysRights rights;
    ASSERT_TRUE(rights.IsGood);
    this->ExpectNoStart(this->In("mine.vtp"), "permissions");
  }
  chmod(this->Folder.c_str(), 0555);
  {
    const NobodysRights rights;
    this->ExpectNoStart(this->In("new.vtp"), "Choose another one");
  }
  EXPECT_EQ(Load(this->In("mine.vtp")), "good");
  chmod(this->Folder.c_str(), 0755);
  EXPECT_TRUE(this->Device->StartRecording(this->In("a.vtp").c_str()));
  EXPECT_TRUE(this->Device->StopRecording());
  EXPECT_FALSE(Exists(this->In("a.vtp.part")));
}

TEST_F(RecordingFailure, OfTheDiskIsToldAtOnceAndKeepsWhatThereIs)
{
  const std::string file = this->In("full.vtp");
  std::ofstream(file) << "good";
  this->FillTheDisk(file, 70000);
  EXPECT_EQ(Load(file), "good") << "a file that is there is replaced by a whole one only";
  const std::string elsewhere = this->In("elsewhere.vtp");
  EXPECT_FALSE(
    this->Device->RecoverRecording((file + ".part").c_str(), this->In("no/a.vtp").c_str()));
  this->ExpectError("no folder");
  ASSERT_TRUE(this->Device->RecoverRecording((file + ".part").c_str(), elsewhere.c_str()));
  EXPECT_FALSE(Exists(file + ".part"));
  this->ExpectReplays(elsewhere, 256);
}

TEST_F(RecordingFailure, OfATableKeepsWhatThereIs)
{
  const std::string file = this->In("full.csv");
  this->FillTheDisk(file, 70000);
  EXPECT_FALSE(Exists(file));
  EXPECT_FALSE(Exists(file + ".json"));
  ASSERT_TRUE(this->Device->RecoverRecording((file + ".part").c_str(), file.c_str()));
  EXPECT_TRUE(Exists(file + ".json"));
  EXPECT_TRUE(this->Device->Open(("replay:" + file).c_str()));
}

TEST_F(RecordingFailure, OfTheLastStepKeepsWhatThereIs)
{
  const std::string file = this->In("last.vtp");
  this->Begin();
  ASSERT_TRUE(this->Device->StartRecording(file.c_str()));
  ASSERT_TRUE(this->WaitTicks(600));
  {
    // What is on the disk already stays there, and nothing comes to it.
    const FullDisk full(1);
    this->Device->Close();
  }
  this->ExpectError("RecoverRecording");
  EXPECT_FALSE(Exists(file));
  ASSERT_TRUE(this->Device->RecoverRecording((file + ".part").c_str(), file.c_str()));
  this->ExpectReplays(file, 512);
}

TEST_F(RecordingFailure, OfTheProgramKeepsWhatThereIs)
{
  const std::string file = this->In("killed.vtp");
  const pid_t child = fork();
  if (child == 0)
  {
    this->Begin();
    this->Device->StartRecording(file.c_str());
    this->Wander(150);
    this->WaitTicks(100);
    kill(getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_FALSE(Exists(file));

  // The next recording of that name neither fails nor takes it away.
  this->Begin();
  ASSERT_TRUE(this->Device->StartRecording(file.c_str()));
  ASSERT_EQ(this->Log.Warnings.size(), 1U);
  EXPECT_NE(this->Log.Warnings[0].find(file + ".part.1"), std::string::npos)
    << this->Log.Warnings[0];
  EXPECT_FALSE(this->Device->RecoverRecording((file + ".part").c_str(), this->In("b.vtp").c_str()));
  this->ExpectError("under way");
  ASSERT_TRUE(this->Device->StopRecording());
  this->Device->Close();
  ASSERT_TRUE(this->Device->RecoverRecording((file + ".part.1").c_str(), file.c_str()));
  this->ExpectReplays(file, 512);
}

TEST_F(RecordingFailure, DoesNotComeFromAForkedChild)
{
  const std::string file = this->In("forked.vtp");
  this->Begin();
  this->Wander(5);
  ASSERT_TRUE(this->Device->StartRecording(file.c_str()));
  ASSERT_TRUE(this->WaitTicks(300));
  const pid_t child = fork();
  if (child == 0)
  {
    // It neither waits for threads that it does not have, nor ends the recording.
    this->Device->Close();
    _exit(this->Log.Errors.empty() ? 0 : 1);
  }
  ASSERT_TRUE(this->WaitTicks(300));
  ASSERT_TRUE(this->Device->StopRecording());
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

TEST_F(RecordingFailure, IsNoneOfTwoThatHaveOneName)
{
  const std::string file = this->In("twice.vtp");
  this->Begin();
  ASSERT_TRUE(this->Device->StartRecording(file.c_str()));
  vtkNew<vtkHapticDevice> other;
  MessageLog log(other);
  ASSERT_TRUE(other->Open("virtual"));
  other->SetVolumeHaptics(this->Filter);
  ASSERT_TRUE(other->Start());
  EXPECT_FALSE(other->StartRecording(file.c_str()));
  ASSERT_EQ(log.Errors.size(), 1U);
  EXPECT_NE(log.Errors[0].find("recorded already"), std::string::npos) << log.Errors[0];
  ASSERT_TRUE(this->WaitTicks(5));
  EXPECT_TRUE(this->Device->StopRecording());
  this->ExpectReplays(file, 5);
}

TEST_F(RecordingFailure, NamesFilesOfAnyBytes)
{
  // Python drops a message that is not UTF-8.
  this->Begin();
  EXPECT_FALSE(this->Device->StartRecording(this->In("no/\xE4\xFF.vtp").c_str()));
  this->ExpectError("\\xE4\\xFF.vtp");
  EXPECT_FALSE(this->Device->StartRecording(this->In("\xE4.txt").c_str()));
  this->ExpectError("\\xE4.txt");
  EXPECT_FALSE(this->Device->RecoverRecording(this->In("\xE4.part").c_str(), "a.vtp"));
  this->ExpectError("\\xE4.part does not exist");
  const std::string file = this->In("\xE4.vtp");
  ASSERT_TRUE(this->Device->StartRecording(file.c_str()));
  ASSERT_TRUE(this->WaitTicks(5));
  ASSERT_TRUE(this->Device->StopRecording());
  this->ExpectReplays(file, 5);
}

TEST_F(RecordingFailure, RecoversNothingElse)
{
  for (const char* const part : std::initializer_list<const char*>{ "", ".part", nullptr })
  {
    EXPECT_FALSE(this->Device->RecoverRecording(part, this->In("a.vtp").c_str()));
    this->ExpectError("FILE.part");
  }
  std::ofstream(this->In("foreign.part")) << "no recording at all, but long enough to be one";
  EXPECT_FALSE(
    this->Device->RecoverRecording(this->In("foreign.part").c_str(), this->In("a.vtp").c_str()));
  this->ExpectError("is not the unfinished recording");
  EXPECT_FALSE(this->Device->RecoverRecording(this->In("foreign.part").c_str(), nullptr));
  this->ExpectError(".vtp or .csv");
  EXPECT_FALSE(Exists(this->In("a.vtp")));
}
