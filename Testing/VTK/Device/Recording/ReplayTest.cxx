// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that the device replay:FILE repeats the tips of the recording.
 */

#include "ReplayRig.h"

using namespace devicetest;

TEST_F(Replay, PlaysTheTipsOfBothKindsOfFile)
{
  for (const char* name : { "Replay.vtp", "Replay.csv" })
  {
    const std::string file = this->File(name);
    this->Record(file);
    const std::string again = this->File("Again.vtp");
    const std::string vtp = this->File("Replay.vtp");
    const auto was = Read(vtp);
    // On a busy machine, the replay may end before its own recording begins, so retry.
    vtkSmartPointer<vtkPolyData> is;
    vtkIdType skipped = was->GetNumberOfPoints();
    for (int i = 0; i < 20 && skipped >= was->GetNumberOfPoints(); ++i)
    {
      ASSERT_TRUE(this->Device->Open(("replay:" + file).c_str()));
      ASSERT_TRUE(this->Device->Start());
      ASSERT_TRUE(this->Device->GetRecorder()->Start(again.c_str()));
      this->Device->Arm();
      ASSERT_TRUE(this->Wait(
        [this] { return this->Device->GetStatusText().find("end") != std::string::npos; }));
      EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[2], 6.0, 1e-5);
      ASSERT_TRUE(this->Device->GetRecorder()->Stop());
      this->Device->Close();
      EXPECT_TRUE(this->Log.Errors.empty());
      is = Read(again);
      skipped = is->GetNumberOfPoints() > 0
        ? static_cast<vtkIdType>(is->GetPointData()->GetArray("Tick")->GetComponent(0, 0))
        : was->GetNumberOfPoints();
    }
    ASSERT_LT(skipped, was->GetNumberOfPoints());

    // The replay started before its recording: from the first recorded tick onwards, the tips must
    // be bitwise identical.
    if (file == vtp)
    {
      vtkDataArray* const a = was->GetPointData()->GetArray("DeviceTip");
      vtkDataArray* const b = is->GetPointData()->GetArray("DeviceTip");
      for (vtkIdType i = skipped; i < a->GetNumberOfTuples(); ++i)
      {
        for (int c = 0; c < 3; ++c)
        {
          ASSERT_EQ(a->GetComponent(i, c), b->GetComponent(i - skipped, c)) << i;
        }
      }
    }
  }
}

TEST_F(Replay, ATableHasWhatIsNotOfATickBesideIt)
{
  const std::string file = this->File("Fields.csv");
  this->Record(file);
  const std::string fields = Load(file + ".json");
  EXPECT_NE(fields.find("\"DeviceId\" : \"virtual\""), std::string::npos) << fields;
  EXPECT_NE(fields.find("DeviceTip: m"), std::string::npos) << "units";
  EXPECT_NE(fields.find("MetersPerWorldUnit: 0.001"), std::string::npos) << "settings";
  const std::string hash = this->Filter->HashScalars();
  ASSERT_FALSE(hash.empty());
  EXPECT_NE(fields.find("\"VolumeHash\" : \"" + hash), std::string::npos);
}
