// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that recordings from before orientation and torque, in Testing/Data, still replay bitwise
 * with the defaults of that time: kernel materials and contact alignment. They were made with
 * commit 771f4fd: a virtual device, whose axes are rotated by 90 degrees, presses Data/Ball.vti at
 * 200 Hz, slides, and is moved by 1.5 mm in the first ticks.
 */

#include "ReplayRig.h"

#include <vtkXMLImageDataReader.h>

#include <cstring>

using namespace devicetest;

namespace
{
const std::string Root = VolumeHaptics_SOURCE_DIR;
const std::string Old = Root + "/Testing/Data/Recording0.2";

class OldRecording : public Replay
{
protected:
  OldRecording()
  {
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName((Root + "/Data/Ball.vti").c_str());
    reader->Update();
    this->Filter->SetInputData(reader->GetOutput());
    this->Filter->GetProperty()->GetFriction()->AddPoint(0.0, 0.4);
    this->Filter->GetProperty()->GetSurfaceStrength()->AddPoint(-800.0, 0.0);
    this->Filter->GetProperty()->GetSurfaceStrength()->AddPoint(800.0, 3.0);
  }
};
} // namespace

TEST_F(OldRecording, GivesTheForcesThatItHolds)
{
  const vtkSmartPointer<vtkPolyData> recorded = Read(Old + ".vtp");
  ASSERT_EQ(recorded->GetNumberOfPoints(), 120);
  ASSERT_FALSE(recorded->GetPointData()->GetArray("Orientation"));
  this->Filter->SetPathData(recorded);
  this->Filter->Update();
  vtkPointData* const replayed = this->Filter->GetOutput()->GetPointData();
  EXPECT_EQ(replayed->GetNumberOfArrays(), 19) << "and no orientation";
  for (int a = 0; a < replayed->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* const here = replayed->GetArray(a);
    vtkDataArray* const there = recorded->GetPointData()->GetArray(here->GetName());
    ASSERT_TRUE(there) << here->GetName();
    ASSERT_EQ(here->GetNumberOfValues(), there->GetNumberOfValues());
    EXPECT_EQ(std::memcmp(here->GetVoidPointer(0), there->GetVoidPointer(0),
                static_cast<std::size_t>(here->GetNumberOfValues()) * here->GetDataTypeSize()),
      0)
      << here->GetName();
  }
  EXPECT_GT(recorded->GetPointData()->GetArray("Force")->GetRange(-1)[1], 2.0);
}

TEST_F(OldRecording, PlaysAsADeviceWithoutOrientation)
{
  for (const char* ending : { ".vtp", ".csv" })
  {
    ASSERT_TRUE(this->Device->Open(("replay:" + Old + ending).c_str()));
    ASSERT_TRUE(this->Device->Start());
    ASSERT_TRUE(this->Wait(
      [this] { return this->Device->GetStatusText().find("end") != std::string::npos; }));
    EXPECT_FALSE(this->Device->GetState()->HasTipOrientation());
    this->Device->Close();
  }
}
