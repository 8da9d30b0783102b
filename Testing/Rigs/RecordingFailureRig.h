// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Records into a separate folder until a failure occurs. */
#ifndef RecordingFailureRig_h
#define RecordingFailureRig_h

#include "FullDisk.h"
#include "RecordingRig.h"

#include <fstream>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>
#include <vtksys/SystemTools.hxx>

namespace devicetest
{

inline bool Exists(const std::string& file)
{
  return access(file.c_str(), F_OK) == 0;
}

inline std::string Load(const std::string& file)
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
    EXPECT_FALSE(this->Device->GetRecorder()->Start(file.c_str())) << file;
    ASSERT_EQ(this->Log.Errors.size(), 1U) << file;
    EXPECT_NE(this->Log.Errors[0].find(file), std::string::npos) << this->Log.Errors[0];
    this->ExpectError(words);
    EXPECT_FALSE(Exists(file + ".part"));
  }
  static rlim_t SizeOf(const std::string& file)
  {
    return static_cast<rlim_t>(vtksys::SystemTools::FileLength(file));
  }
  /// Moves the tip at random until two groups of 256 ticks are on the disk. A group has 20 kB to 45
  /// kB.
  void WanderForTwoGroups(const std::string& file)
  {
    const rlim_t enough = SizeOf(file + ".part") + 50000;
    for (int i = 0; i < 1000 && SizeOf(file + ".part") < enough; ++i)
    {
      this->Wander(5);
    }
    ASSERT_GE(SizeOf(file + ".part"), enough);
  }
  /// Records until the disk is full, and expects an error. The disk has room for one or two groups
  /// of ticks.
  void FillTheDisk(const std::string& file)
  {
    this->Begin();
    ASSERT_TRUE(this->Device->GetRecorder()->Start(file.c_str()));
    const FullDisk full(SizeOf(file + ".part") + 60000);
    // Keep the tip moving, because a resting tip takes few bytes.
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
    EXPECT_FALSE(this->Device->GetRecorder()->Stop());
    this->ExpectError(".part");
    EXPECT_EQ(this->Device->GetStatusText().find("Make room"), std::string::npos);
  }
  /// Expects the same forces from the filter's replay of the file.
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

  const std::string Folder = this->File("Failure");
};

} // namespace devicetest

#endif
