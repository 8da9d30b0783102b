// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests journals under faults: unreadable disks, file systems without locks, interrupting signals,
 * other programs that rename and remove files, and machines without a free thread or disk space.
 * The test replaces flock(2), fsync(2) and pread(2) by versions that fail as their manual pages
 * describe.
 */

#include "RecorderRig.h"

#include "Rigs/FullDisk.h"

#include "VTK/Device/Recording/HapticJournal.h"

#include <cerrno>
#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <sys/syscall.h>

namespace
{
bool HasLocks = true;
long BadFrom = -1; // first byte that pread() fails to read; none if negative
int Interruptions = 0;
std::string Watched; // name of a journal, which must exist when its folder is synced
bool WasThere = false;
int FolderSyncs = 0;
} // namespace

extern "C" int flock(int descriptor, int operation) noexcept
{
  if (!HasLocks)
  {
    errno = ENOLCK;
    return -1;
  }
  return static_cast<int>(syscall(SYS_flock, descriptor, operation));
}

extern "C" ssize_t pread(int descriptor, void* data, size_t size, off_t position)
{
  if (BadFrom >= 0 && position + static_cast<off_t>(size) > BadFrom)
  {
    errno = EIO;
    return -1;
  }
  return syscall(SYS_pread64, descriptor, data, size, position);
}

extern "C" int fsync(int descriptor)
{
  if (Interruptions > 0)
  {
    --Interruptions;
    errno = EINTR;
    return -1;
  }
  struct stat status;
  if (fstat(descriptor, &status) == 0 && S_ISDIR(status.st_mode))
  {
    ++FolderSyncs;
    WasThere = recordertest::Exists(Watched);
  }
  return static_cast<int>(syscall(SYS_fsync, descriptor));
}

using namespace recordertest;

namespace
{

class Journal : public Recorder
{
protected:
  ~Journal() override
  {
    HasLocks = true;
    BadFrom = -1;
    Interruptions = 0;
  }
  void Push(HapticRecording& recording, int ticks)
  {
    for (int i = 0; i < ticks; ++i)
    {
      this->Recorder::Push(recording, this->Source.Next());
    }
  }
  /// Leaves behind a journal with this many ticks, like a program that ended before it finished the
  /// recording.
  void Leave(int ticks)
  {
    HapticRecording recording;
    this->Start(recording, this->File);
    this->Push(recording, ticks);
  }
  static void WaitFor(HapticRecording& recording, std::uint64_t ticks)
  {
    while (recording.GetNumberOfTicks() < ticks)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  bool FinishFails(HapticRecording& recording, const std::string& words)
  {
    std::string error;
    const bool failed = !recording.Finish(error);
    EXPECT_NE(error.find(words), std::string::npos) << error;
    return failed;
  }

  const std::string Part = this->File + ".part";
};

} // namespace

TEST_F(Journal, IsNotWrittenOverItself)
{
  this->Leave(600);
  // Each target is the journal itself: a hard link, a symbolic link, and a hard link whose name is
  // that of a table's fields.
  for (const char* const name : { "/b.vtp", "/c.vtp", "/d.csv.json" })
  {
    const std::string file = this->Folder + name;
    ASSERT_EQ(std::string(name) == "/c.vtp" ? symlink(this->Part.c_str(), file.c_str())
                                            : link(this->Part.c_str(), file.c_str()),
      0);
  }
  const std::string whole = Load(this->Part);
  std::string error;
  EXPECT_FALSE(WriteRecording(this->Folder + "/b.vtp", this->Folder + "/b.vtp", error));
  EXPECT_NE(error.find("over itself"), std::string::npos) << error;
  EXPECT_FALSE(WriteRecording(this->Part, this->Folder + "/c.vtp", error));
  EXPECT_FALSE(WriteRecording(this->Part, this->Folder + "/d.csv", error));
  EXPECT_EQ(Load(this->Part), whole);
  EXPECT_EQ(Load(this->Folder + "/b.vtp"), whole);
  EXPECT_TRUE(WriteRecording(this->Part, this->File, error)) << error;
  EXPECT_EQ(Read(this->File)->GetNumberOfPoints(), 600);
}

/// Appends a megabyte in which a chunk's head starts every 24 bytes. Computing 44,000 checksums of
/// up to a megabyte each once took five minutes. The error reports that bytes have changed.
TEST_F(Journal, OfManyFalseHeadsIsReadSoon)
{
  this->Leave(600);
  std::string whole = Load(this->Part);
  const std::uint64_t size = 1 << 20;
  std::string heads;
  Put(heads, TicksChunk);
  Put(heads, std::uint32_t{ 0 });
  Put(heads, std::uint64_t{ 4 * size }); // length of the chunk, beyond the end of the file
  Put(heads, std::uint64_t{ 0 });
  for (std::uint64_t left = size - HeadSize; left > HeadSize; left -= HeadSize)
  {
    Put(heads, TicksChunk);
    Put(heads, std::uint32_t{ 0 });
    Put(heads, left - HeadSize);
    Put(heads, std::uint64_t{ 0 });
  }
  heads.append(4 * HeadSize, 'x');
  std::ofstream(this->Part, std::ios::binary) << whole << heads;
  std::string error;
  EXPECT_FALSE(WriteRecording(this->Part, this->File, error));
  EXPECT_NE(error.find("bytes there have changed"), std::string::npos) << error;
  EXPECT_EQ(Read(this->File)->GetNumberOfPoints(), 600);
}

TEST_F(Journal, OnADiskThatCannotBeReadStays)
{
  HapticRecording recording;
  this->Start(recording, this->File);
  this->Push(recording, 1024);
  WaitFor(recording, 1024);
  const std::string whole = Load(this->Part);
  BadFrom = static_cast<long>(whole.size() / 2);
  EXPECT_TRUE(this->FinishFails(recording, "can't be read beyond byte"));
  EXPECT_EQ(Load(this->Part), whole);
  const vtkIdType ticks = Read(this->File)->GetNumberOfPoints();
  EXPECT_GT(ticks, 0);
  EXPECT_LT(ticks, 1024);
  std::string error;
  EXPECT_FALSE(WriteRecording(this->Part, this->File, error));
  EXPECT_NE(error.find("nput/output error"), std::string::npos) << error;
  EXPECT_EQ(Read(this->File)->GetNumberOfPoints(), ticks);
  EXPECT_EQ(Load(this->Part), whole);
  BadFrom = -1;
  EXPECT_TRUE(WriteRecording(this->Part, this->File, error)) << error;
  EXPECT_EQ(Read(this->File)->GetNumberOfPoints(), 1024);
}

TEST_F(Journal, ThatAnotherProgramCutsOffIsNoWholeRecording)
{
  HapticRecording recording;
  this->Start(recording, this->File);
  this->Push(recording, 512);
  WaitFor(recording, 512);
  ASSERT_EQ(truncate(this->Part.c_str(), static_cast<off_t>(Load(this->Part).size() - 9)), 0);
  EXPECT_TRUE(this->FinishFails(recording, "256 of 512 ticks"));
  EXPECT_TRUE(Exists(this->Part));
}

TEST_F(Journal, DoesNotReplaceAGoodFileAfterAFullDisk)
{
  std::ofstream(this->File) << "good";
  HapticRecording recording;
  this->Start(recording, this->File);
  {
    const devicetest::FullDisk full(Load(this->Part).size() + 60000);
    while (recording.GetTrouble().empty())
    {
      this->Push(recording, 1);
    }
  }
  EXPECT_TRUE(this->FinishFails(recording, this->Part));
  EXPECT_EQ(Load(this->File), "good");
  ASSERT_TRUE(Exists(this->Part));
  std::string error;
  EXPECT_TRUE(WriteRecording(this->Part, this->File, error)) << error;
  EXPECT_GE(Read(this->File)->GetNumberOfPoints(), 256);
}

TEST_F(Journal, KeepsNoModelsThatNoTickNeeds)
{
  const auto isFreed = [&](HapticRecording& recording, std::uint64_t generation)
  {
    auto model = MakeModel();
    const std::weak_ptr<const HapticModel> watch = model;
    recording.AddModel(generation, std::move(model));
    ServoSnapshot tick = this->Source.Next();
    tick.Generation = generation + 1;
    recording.AddModel(generation + 1, MakeModel());
    recording.Append(tick);
    recording.AddModel(generation + 2, MakeModel());
    return watch.expired();
  };
  {
    HapticRecording recording; // without a writer, ticks are not drained
    recording.AddModel(1, this->Model);
    while (recording.Append(this->Source.Next()))
    {
    }
    EXPECT_TRUE(isFreed(recording, 2)) << "though ticks are lost";
  }
  HapticRecording recording;
  this->Start(recording, this->File);
  const devicetest::FullDisk full(Load(this->Part).size() + 100);
  while (recording.GetTrouble().empty())
  {
    this->Push(recording, 1);
  }
  EXPECT_TRUE(isFreed(recording, 2)) << "though the disk is full";
}

TEST_F(Journal, NeedsAThread)
{
  // A stack of this size does not fit into any address space (pthread_create(3): EAGAIN).
  pthread_attr_t before;
  pthread_attr_t huge;
  ASSERT_EQ(pthread_getattr_default_np(&before), 0);
  ASSERT_EQ(pthread_attr_init(&huge), 0);
  ASSERT_EQ(pthread_attr_setstacksize(&huge, std::size_t{ 1 } << 56), 0);
  ASSERT_EQ(pthread_setattr_default_np(&huge), 0);
  HapticRecording recording;
  std::string error;
  std::string warning;
  EXPECT_FALSE(recording.Start(this->File, {}, error, warning));
  ASSERT_EQ(pthread_setattr_default_np(&before), 0);
  EXPECT_NE(error.find("no thread"), std::string::npos) << error;
  EXPECT_FALSE(Exists(this->Part));
}

TEST_F(Journal, WithoutLocksIsNotTaken)
{
  HasLocks = false;
  HapticRecording first;
  this->Start(first, this->File);
  this->Push(first, 512);
  WaitFor(first, 512);
  std::string error;
  EXPECT_TRUE(WriteRecording(this->Part, this->Folder + "/now.vtp", error)) << error;
  EXPECT_TRUE(Exists(this->Part)) << "a recording may be under way in it";
  HapticRecording second;
  std::string warning;
  ASSERT_TRUE(second.Start(this->File, {}, error, warning)) << error;
  EXPECT_NE(warning.find(this->Part + ".1"), std::string::npos) << warning;
  this->Push(first, 100);
  this->Finish(first);
  EXPECT_EQ(Read(this->File)->GetNumberOfPoints(), 612);
  EXPECT_FALSE(Exists(this->Part));
  this->Finish(second);
  EXPECT_EQ(Read(this->File)->GetNumberOfPoints(), 0);
  EXPECT_FALSE(Exists(this->Part + ".1"));
}

TEST_F(Journal, ThatIsRenamedIsStillRead)
{
  HapticRecording recording;
  this->Start(recording, this->File);
  this->Push(recording, 300);
  ASSERT_EQ(rename(this->Part.c_str(), (this->Folder + "/x").c_str()), 0);
  std::ofstream(this->Part) << "another one's";
  this->Finish(recording);
  EXPECT_EQ(Read(this->File)->GetNumberOfPoints(), 300);
  EXPECT_EQ(Load(this->Part), "another one's");
}

TEST_F(Journal, ThatIsGoneIsNotSaidToBeThere)
{
  HapticRecording recording;
  this->Start(recording, this->File);
  this->Push(recording, 300);
  unlink(this->Part.c_str());
  vtksys::SystemTools::MakeDirectory(this->File);
  std::string error;
  EXPECT_FALSE(recording.Finish(error));
  EXPECT_EQ(error.find("is kept in"), std::string::npos) << error;
  EXPECT_NE(error.find("removed or replaced"), std::string::npos) << error;
}

TEST_F(Journal, IsRemovedWhenTheFolderIsOnTheDisk)
{
  this->Leave(300);
  Watched = this->Part;
  FolderSyncs = 0;
  Interruptions = 3; // number of signals that interrupt fsync()
  std::string error;
  EXPECT_TRUE(WriteRecording(this->Part, this->File, error)) << error;
  EXPECT_EQ(FolderSyncs, 1);
  EXPECT_TRUE(WasThere);
  EXPECT_FALSE(Exists(this->Part));
}

TEST_F(Journal, IsAsPrivateAsTheFile)
{
  std::ofstream(this->File) << "mine";
  ASSERT_EQ(chmod(this->File.c_str(), 0600), 0);
  HapticRecording recording;
  this->Start(recording, this->File);
  struct stat status;
  ASSERT_EQ(stat(this->Part.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777, 0600U);
  this->Finish(recording);
  ASSERT_EQ(stat(this->File.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777, 0600U);
}

TEST_F(Journal, NeedsItsNameAndThatOfTheFields)
{
  const auto refuses = [](const std::string& file, const char* words)
  {
    HapticRecording recording;
    std::string error;
    std::string warning;
    EXPECT_FALSE(recording.Start(file, {}, error, warning)) << file;
    EXPECT_NE(error.find(words), std::string::npos) << error;
  };
  vtksys::SystemTools::MakeDirectory(this->Part);
  refuses(this->File, "is a folder");
  vtksys::SystemTools::MakeDirectory(this->Folder + "/b.csv.json");
  refuses(this->Folder + "/b.csv", "is a folder");
  EXPECT_FALSE(Exists(this->Folder + "/b.csv.part"));
  // The longest name to which ".part" can be added (NAME_MAX is 255 bytes).
  const std::string longest = this->Folder + "/" + std::string(246, 'x') + ".vtp";
  HapticRecording recording;
  this->Start(recording, longest);
  this->Finish(recording);
  EXPECT_TRUE(Exists(longest));
  refuses(this->Folder + "/" + std::string(247, 'x') + ".vtp", "name");
}
