// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that no call on the owner's thread reads more of a large volume than of a small one. The
 * test counts the pages of a sparse file that the kernel has in memory (mincore(2)), while work in
 * the background is blocked.
 */

#include "Benchmarks/SparseVolume.h"
#include "Core/Servo/SampleKeeper.h"
#include "Rigs/DeviceRig.h"
#include "Rigs/GatedArray.h"
#include "Rigs/MappedFile.h"

#include <vtkFloatArray.h>
#include <vtkHapticLabelTable.h>
#include <vtkPointData.h>

using namespace devicetest;

namespace
{
class Scale : public DeviceTest
{
protected:
  /// Returns the number of the file's pages (4 KiB) that are in memory.
  std::size_t CountPages(const benchmarks::SparseVolume& volume)
  {
    return volume.GetResident() / 4096;
  }
};

/// Largest number of pages with samples around the tip that the servo keeps in memory.
constexpr std::size_t MostKept = VolumeHaptics::SampleKeeper::MostBytes / 4096;
/// Largest number of pages that an update reads. The noise estimate reads 512 blocks of 5 x 5 rows,
/// each row in one or two pages. The update also reads several hundred rows around the tip. The
/// smallest volume, with two bytes per sample, has 65536 pages.
constexpr std::size_t MostPages = 512 * 25 + 2000 + MostKept;
/// Largest number of pages that ProposeFromImage() reads. It reads 512 rows, with 5 rows beside
/// each of them in 6 slices, and follows the edges in them.
constexpr std::size_t MostPagesOfAProposal = 512 * 36 + 6000;
} // namespace

TEST_F(Scale, CallsReadNoMoreOfALargerVolume)
{
  for (const int size : { 512, 1024, 1536 })
  {
    vtkNew<GatedArray> samples;
    const benchmarks::SparseVolume volume(size, samples);
    const double middle = volume.GetMiddle();
    this->Filter->SetInputData(0, volume.GetImage());
    this->Filter->SetPathData(
      MakePath({ { middle, middle, middle }, { middle, middle, middle + 1.0 } }));
    this->Filter->Update();
    EXPECT_LT(this->CountPages(volume), MostPages) << "Update() of " << size << "^3";
    const std::size_t once = this->CountPages(volume);
    EXPECT_GT(once, 1000U) << "the noise was estimated";
    this->Filter->Modified();
    this->Filter->Update();

    ASSERT_TRUE(this->Device->Open("virtual"));
    this->Device->GetVirtualHand()->SetPosition(middle, middle, middle);
    ASSERT_TRUE(this->Device->Start());
    this->Device->Arm();
    ASSERT_TRUE(this->WaitTicks(20));
    SetConstant(this->Filter->GetProperty()->GetStiffness(), 300.0 + size);
    ASSERT_TRUE(this->Device->Publish());
    const std::string file = this->File("Scale.vtp");
    ASSERT_TRUE(this->Device->GetRecorder()->Start(file.c_str()));
    ASSERT_TRUE(this->WaitTicks(20));
    EXPECT_LT(this->CountPages(volume), MostPages) << size << "^3";
    EXPECT_LT(this->CountPages(volume), once + 500 + MostKept)
      << "after the first touch, " << size << "^3";
    // Stop() cancels the worker, which can end only once the array is open.
    std::thread opener(
      [&samples]
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        samples->IsOpen = true;
      });
    ASSERT_TRUE(this->Device->GetRecorder()->Stop());
    opener.join();
    EXPECT_LT(this->CountPages(volume), once + 1000 + MostKept)
      << "at the end of a recording, " << size;
    this->Device->Close();
    const std::size_t felt = this->CountPages(volume);
    vtkNew<vtkHapticProperty> proposed;
    const MessageLog refusal(proposed); // the proposal fails if no row crosses the cube
    proposed->ProposeFromImage(volume.GetImage());
    EXPECT_GT(this->CountPages(volume), felt + 3000) << "rows were looked at, " << size;
    EXPECT_LT(this->CountPages(volume), felt + MostPagesOfAProposal) << "a proposal, " << size;
    // Release the image before its memory.
    this->Filter->SetInputData(0, this->Image);
    this->Filter->Update();
  }
}

TEST_F(Scale, TheFirstUpdateReadsThePlacesOfTheNoiseOnly)
{
  // 400^3 is close to the largest volume for which the noise estimate reads 16 x 16 x 16 blocks.
  for (const int size : { 256, 400 })
  {
    const benchmarks::SparseVolume volume(size);
    const double middle = volume.GetMiddle();
    this->Filter->SetInputData(0, volume.GetImage());
    this->Filter->SetPathData(
      MakePath({ { middle, middle, middle }, { middle, middle, middle + 1.0 } }));
    this->Filter->Update();
    // The blocks are in 16 layers of 5 slices, and the rows around the tip in a few more slices.
    const std::size_t slice = sizeof(short) * size * size / 4096 + 1;
    EXPECT_LT(this->CountPages(volume), (16 * 5 + 10) * slice) << size << "^3";
    EXPECT_GT(this->CountPages(volume), 1000U) << "the noise was estimated";
    this->Filter->SetInputData(0, this->Image);
    this->Filter->Update();
  }
}

TEST_F(Scale, LabelsOfFloatingPointAreCheckedInPlaces)
{
  for (const int size : { 512, 640 })
  {
    const auto count = vtkIdType{ size } * size * size;
    servotest::MappedFile file(sizeof(float) * static_cast<std::size_t>(count));
    (void)madvise(file.Begin, file.Size, MADV_RANDOM); // disables read-ahead
    vtkNew<vtkFloatArray> labels;
    labels->SetArray(static_cast<float*>(file.Begin), count, 1);
    vtkNew<vtkImageData> image;
    image->SetDimensions(size, size, size);
    image->GetPointData()->SetScalars(labels);
    vtkNew<vtkHapticLabelTable> table;
    table->SetStiffness(0, 300.0);
    this->Filter->SetLabelTable(table);
    this->Filter->SetLabelData(image);
    ASSERT_NO_FATAL_FAILURE(this->Begin());
    ASSERT_TRUE(this->WaitTicks(20));
    EXPECT_EQ(this->Device->GetState()->GetLabel(), 0);
    const std::size_t pages = file.Resident() / 4096;
    EXPECT_GE(pages, 512U);
    EXPECT_LT(pages, 2 * 512 + 1000 + MostKept) << size;
    this->Device->Close();
    this->Filter->SetLabelData(nullptr);
    this->Filter->Update();
  }
}
