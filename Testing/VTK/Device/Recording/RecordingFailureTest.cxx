// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests full disks and read-only folders. Each must be reported at once, and the ticks written
 * until then must be readable.
 */

#include "Rigs/RecordingFailureRig.h"

#include <filesystem>

using namespace devicetest;

namespace
{

/// Enforces file permissions even for a root process during the object's lifetime. Meanwhile the
/// current folder is `folder`, because the process might not be allowed to enter the earlier one
/// again.
class UnprivilegedUser
{
public:
  explicit UnprivilegedUser(const std::string& folder)
    : Before(std::filesystem::current_path())
    , WasRoot(geteuid() == 0)
  {
    std::filesystem::current_path(folder);
    constexpr uid_t nobody = 65534;
    this->IsGood = !this->WasRoot || seteuid(nobody) == 0;
  }
  ~UnprivilegedUser()
  {
    if (this->WasRoot)
    {
      (void)!seteuid(0);
    }
    std::filesystem::current_path(this->Before);
  }
  UnprivilegedUser(const UnprivilegedUser&) = delete;
  UnprivilegedUser& operator=(const UnprivilegedUser&) = delete;
  bool IsGood;

private:
  const std::filesystem::path Before;
  const bool WasRoot;
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
  vtksys::SystemTools::MakeDirectory(this->In("fields.csv.json"));
  this->ExpectNoStart(this->In("fields.csv"), "is a folder");
  {
    const FullDisk full(0);
    this->ExpectNoStart(this->In("full.vtp"), "Make room");
  }
  std::ofstream(this->In("mine.vtp")) << "good";
  chmod(this->In("mine.vtp").c_str(), 0444);
  {
    chmod(this->Folder.c_str(), 0777);
    const UnprivilegedUser rights(this->Folder);
    ASSERT_TRUE(rights.IsGood);
    this->ExpectNoStart("mine.vtp", "permissions");
  }
  chmod(this->Folder.c_str(), 0555);
  {
    const UnprivilegedUser rights(this->Folder);
    this->ExpectNoStart("new.vtp", "Choose another one");
  }
  EXPECT_EQ(Load(this->In("mine.vtp")), "good");
  chmod(this->Folder.c_str(), 0755);
  EXPECT_TRUE(this->Device->GetRecorder()->Start(this->In("a.vtp").c_str()));
  EXPECT_TRUE(this->Device->GetRecorder()->Stop());
  EXPECT_FALSE(Exists(this->In("a.vtp.part")));
}

TEST_F(RecordingFailure, OfTheDiskIsToldAtOnceAndKeepsWhatThereIs)
{
  const std::string file = this->In("full.vtp");
  std::ofstream(file) << "good";
  this->FillTheDisk(file);
  EXPECT_EQ(Load(file), "good") << "a file that is there is replaced by a whole one only";
  const std::string elsewhere = this->In("elsewhere.vtp");
  EXPECT_FALSE(
    this->Device->GetRecorder()->Recover((file + ".part").c_str(), this->In("no/a.vtp").c_str()));
  this->ExpectError("no folder");
  ASSERT_TRUE(this->Device->GetRecorder()->Recover((file + ".part").c_str(), elsewhere.c_str()));
  EXPECT_FALSE(Exists(file + ".part"));
  this->ExpectReplays(elsewhere, 256);
}

TEST_F(RecordingFailure, OfATableKeepsWhatThereIs)
{
  const std::string file = this->In("full.csv");
  this->FillTheDisk(file);
  EXPECT_FALSE(Exists(file));
  EXPECT_FALSE(Exists(file + ".json"));
  ASSERT_TRUE(this->Device->GetRecorder()->Recover((file + ".part").c_str(), file.c_str()));
  EXPECT_TRUE(Exists(file + ".json"));
  EXPECT_TRUE(this->Device->Open(("replay:" + file).c_str()));
}

TEST_F(RecordingFailure, OfTheLastStepKeepsWhatThereIs)
{
  const std::string file = this->In("last.vtp");
  this->Begin();
  ASSERT_TRUE(this->Device->GetRecorder()->Start(file.c_str()));
  this->WanderForTwoGroups(file);
  {
    // The disk is full. The written ticks must be preserved, and no ticks may be added.
    const FullDisk full(1);
    this->Device->Close();
  }
  this->ExpectError("vtkHapticRecorder::Recover");
  EXPECT_FALSE(Exists(file));
  ASSERT_TRUE(this->Device->GetRecorder()->Recover((file + ".part").c_str(), file.c_str()));
  this->ExpectReplays(file, 512);
}

TEST_F(RecordingFailure, IsNoneOfTwoThatHaveOneName)
{
  const std::string file = this->In("twice.vtp");
  this->Begin();
  ASSERT_TRUE(this->Device->GetRecorder()->Start(file.c_str()));
  vtkNew<vtkHapticDevice> other;
  MessageLog log(other);
  ASSERT_TRUE(other->Open("virtual"));
  other->SetVolumeHaptics(this->Filter);
  ASSERT_TRUE(other->Start());
  EXPECT_FALSE(other->GetRecorder()->Start(file.c_str()));
  ASSERT_EQ(log.Errors.size(), 1U);
  EXPECT_NE(log.Errors[0].find("recorded already"), std::string::npos) << log.Errors[0];
  ASSERT_TRUE(this->WaitTicks(5));
  EXPECT_TRUE(this->Device->GetRecorder()->Stop());
  this->ExpectReplays(file, 5);
}

TEST_F(RecordingFailure, NamesFilesOfAnyBytes)
{
  // Bytes that are not UTF-8 must be printed in hexadecimal, because Python discards messages with
  // such bytes.
  this->Begin();
  EXPECT_FALSE(this->Device->GetRecorder()->Start(this->In("no/\xE4\xFF.vtp").c_str()));
  this->ExpectError("\\xE4\\xFF.vtp");
  EXPECT_FALSE(this->Device->GetRecorder()->Start(this->In("\xE4.txt").c_str()));
  this->ExpectError("\\xE4.txt");
  EXPECT_FALSE(this->Device->GetRecorder()->Recover(this->In("\xE4.part").c_str(), "a.vtp"));
  this->ExpectError("\\xE4.part does not exist");
  const std::string file = this->In("\xE4.vtp");
  ASSERT_TRUE(this->Device->GetRecorder()->Start(file.c_str()));
  ASSERT_TRUE(this->WaitTicks(5));
  ASSERT_TRUE(this->Device->GetRecorder()->Stop());
  this->ExpectReplays(file, 5);
}

TEST_F(RecordingFailure, RecoversNothingElse)
{
  for (const char* const part : std::initializer_list<const char*>{ "", ".part", nullptr })
  {
    EXPECT_FALSE(this->Device->GetRecorder()->Recover(part, this->In("a.vtp").c_str()));
    this->ExpectError("FILE.part");
  }
  std::ofstream(this->In("foreign.part")) << "no recording at all, but long enough to be one";
  EXPECT_FALSE(this->Device->GetRecorder()->Recover(
    this->In("foreign.part").c_str(), this->In("a.vtp").c_str()));
  this->ExpectError("is not the unfinished recording");
  EXPECT_FALSE(this->Device->GetRecorder()->Recover(this->In("foreign.part").c_str(), nullptr));
  this->ExpectError(".vtp or .csv");
  EXPECT_FALSE(Exists(this->In("a.vtp")));
}
