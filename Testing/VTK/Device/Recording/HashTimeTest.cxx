// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that a recording starts at once, and adds its hashes when they are available. An array
 * delays the hash for as long as a test wants. The expected hash comes from HashScalars(), which
 * another test compares with Python's MD5.
 */

#include "Rigs/GatedArray.h"
#include "Rigs/RecordingRig.h"

#include <vtkShortArray.h>
#include <vtkStringArray.h>

#include <thread>

using namespace devicetest;

namespace
{
class HashTime : public Recording
{
protected:
  HashTime() { this->Filter->SetInputData(0, this->Give(this->Gated)); }
  ~HashTime() override { this->Gated->IsOpen = true; }

  /// Makes V = 100 z, like the fixture's image.
  vtkSmartPointer<vtkImageData> Give(vtkShortArray* values)
  {
    constexpr int n = 16;
    values->SetNumberOfValues(n * n * n);
    for (vtkIdType i = 0; i < n * n * n; ++i)
    {
      values->SetValue(i, static_cast<short>(100 * (i / (n * n))));
    }
    const auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(n, n, n);
    image->GetPointData()->SetScalars(values);
    return image;
  }
  std::string ReadHash()
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(this->Name.c_str());
    reader->Update();
    auto* const text = vtkStringArray::SafeDownCast(
      reader->GetOutput()->GetFieldData()->GetAbstractArray("VolumeHash"));
    return text && text->GetNumberOfValues() == 1 ? std::string(text->GetValue(0)) : "no array";
  }
  bool IsHashing()
  {
    this->Device->UpdateState();
    return this->Device->GetStatusText().find("the recorded volume is hashed") != std::string::npos;
  }
  bool WaitUntilAsked(int times = 1)
  {
    return this->Wait([this, times] { return this->Gated->Asked >= times; });
  }
  /// Opens the array from another thread after this time (ms), while the owner waits for the hash.
  std::thread OpenSoon(int milliseconds = 50)
  {
    return std::thread(
      [this, milliseconds]
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
        this->Gated->IsOpen = true;
      });
  }

  vtkNew<GatedArray> Gated;
};
} // namespace

TEST_F(HashTime, IsNotThatOfTheStart)
{
  ASSERT_NO_FATAL_FAILURE(this->BeginPressed());
  this->StartRecording();
  EXPECT_TRUE(this->IsHashing()) << this->Device->GetStatusText();
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE);
  ASSERT_TRUE(this->WaitTicks(20));
  this->Gated->IsOpen = true;
  ASSERT_TRUE(this->Wait([this] { return !this->IsHashing(); }));
  ASSERT_TRUE(this->Device->GetRecorder()->Stop());
  EXPECT_EQ(this->ReadHash(), this->Filter->HashScalars());
  EXPECT_TRUE(this->Log.Warnings.empty());
  // Unchanged values must not be hashed again.
  const int asked = this->Gated->Asked;
  this->StartRecording();
  EXPECT_FALSE(this->IsHashing());
  ASSERT_TRUE(this->WaitTicks(20));
  ASSERT_TRUE(this->Device->GetRecorder()->Stop());
  EXPECT_EQ(this->ReadHash(), this->Filter->HashScalars());
  EXPECT_EQ(this->Gated->Asked, asked);
}

TEST_F(HashTime, IsNotWaitedForWhileArmed)
{
  ASSERT_NO_FATAL_FAILURE(this->BeginPressed());
  this->StartRecording();
  ASSERT_TRUE(this->WaitTicks(20));
  // Stop() cancels the worker, which can end only once the array is open.
  std::thread opener = this->OpenSoon(3000);
  ASSERT_TRUE(this->Device->GetRecorder()->Stop());
  opener.join();
  EXPECT_EQ(this->ReadHash(), "");
  ASSERT_EQ(this->Log.Warnings.size(), 1U);
  EXPECT_NE(this->Log.Warnings[0].find("no hash of its volume"), std::string::npos);
  EXPECT_FALSE(this->IsHashing()) << "of a recording that has ended";
}

TEST_F(HashTime, IsWaitedForWithoutForce)
{
  this->Begin();
  this->StartRecording();
  ASSERT_TRUE(this->WaitTicks(20));
  std::thread opener = this->OpenSoon();
  ASSERT_TRUE(this->Device->GetRecorder()->Stop());
  opener.join();
  EXPECT_EQ(this->ReadHash(), this->Filter->HashScalars());
  EXPECT_TRUE(this->Log.Warnings.empty());
}

TEST_F(HashTime, MayEndWithTheDevice)
{
  ASSERT_NO_FATAL_FAILURE(this->BeginPressed());
  this->StartRecording();
  ASSERT_TRUE(this->WaitUntilAsked());
  std::thread opener = this->OpenSoon();
  this->Device->Close();
  opener.join();
  EXPECT_EQ(this->ReadHash(), this->Filter->HashScalars());
}

TEST_F(HashTime, BeginsAgainIfTheValuesChange)
{
  this->Begin();
  this->StartRecording();
  ASSERT_TRUE(this->WaitUntilAsked());
  const std::string before = this->Filter->HashScalars();
  // The worker has not read any value yet, because the array is closed. It must end this hash
  // before it starts again.
  this->Gated->SetValue(7, 5);
  this->Gated->Modified();
  std::thread opener = this->OpenSoon();
  this->Device->UpdateState();
  opener.join();
  ASSERT_TRUE(this->WaitUntilAsked(2));
  ASSERT_TRUE(this->Wait([this] { return !this->IsHashing(); }));
  ASSERT_TRUE(this->Device->GetRecorder()->Stop());
  EXPECT_EQ(this->ReadHash(), this->Filter->HashScalars());
  EXPECT_NE(this->ReadHash(), before);
}

TEST_F(HashTime, BeginsAgainIfTheImageIsReplaced)
{
  this->Begin();
  this->StartRecording();
  ASSERT_TRUE(this->WaitUntilAsked());
  std::thread opener = this->OpenSoon();
  vtkNew<vtkShortArray> values;
  const auto image = this->Give(values);
  values->SetValue(9, 3);
  this->Filter->SetInputData(0, image);
  this->Device->UpdateState(); // releases the image, to which the worker may have a reference
  opener.join();
  ASSERT_TRUE(this->Wait([this] { return !this->IsHashing(); }));
  ASSERT_TRUE(this->Device->GetRecorder()->Stop());
  EXPECT_EQ(this->ReadHash(), this->Filter->HashScalars());
}

TEST_F(HashTime, OfLabelsIsInTheSettings)
{
  vtkNew<GatedArray> labels;
  this->Filter->SetLabelData(this->Give(labels));
  this->Gated->IsOpen = true;
  this->Begin();
  this->StartRecording();
  EXPECT_TRUE(this->IsHashing()) << "of the labels";
  this->Wander(30);
  labels->IsOpen = true;
  ASSERT_TRUE(this->Wait([this] { return !this->IsHashing(); }));
  this->ExpectSame(0.0);
  auto* const settings =
    vtkStringArray::SafeDownCast(this->Recorded->GetFieldData()->GetAbstractArray("Settings"));
  ASSERT_NE(settings, nullptr);
  EXPECT_NE(settings->GetValue(0).find("\nLabelHash: " + this->Filter->HashLabels() + "\n"),
    std::string::npos);
}
