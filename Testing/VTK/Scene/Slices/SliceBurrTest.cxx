// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that slices show the remaining tissue after a burr's removal. They must equal the slices of
 * an image from which a loop has removed the tissue.
 */

#include "Rigs/RemovalRig.h"
#include "VTK/Scene/Interaction/StyleRig.h"

#include <vtkHapticBurr.h>
#include <vtkHapticRegionSource.h>
#include <vtkHapticRemoval.h>
#include <vtkHapticSliceView.h>
#include <vtkUnsignedCharArray.h>

using namespace scenetest;
using namespace removaltest;

namespace
{
using Picture = std::vector<unsigned char>;

constexpr double SliceAir = -2500.0;

int MostSliceDifference(const Picture& a, const Picture& b)
{
  int most = a.size() == b.size() && !a.empty() ? 0 : 256;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    most = std::max(most, std::abs(int{ a[i] } - int{ b[i] }));
  }
  return most;
}

class SliceBurr : public StyleTest
{
protected:
  SliceBurr()
  {
    this->Window->SetSize(400, 900);
    this->View->SetDevice(this->Device);
    this->View->SetShare(0.8);
    this->View->SetColorWindow(6000.0);
    this->View->SetRenderWindow(this->Window);
    this->Style->SetSliceView(this->View);
  }
  /// Draws the three slices through a position.
  Picture Draw(const double at[3])
  {
    this->View->SetPosition(at);
    this->Window->Render();
    Picture all;
    for (int slice = 0; slice < 3; ++slice)
    {
      const int* const origin = this->View->GetRenderer(slice)->GetOrigin();
      const int* const size = this->View->GetRenderer(slice)->GetSize();
      vtkNew<vtkUnsignedCharArray> pixels;
      this->Window->GetPixelData(
        origin[0], origin[1], origin[0] + size[0] - 1, origin[1] + size[1] - 1, 0, pixels);
      all.insert(
        all.end(), pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
    }
    return all;
  }
  /// Expects that the view of the touched image equals the view of `left`, which the application
  /// sets, and that both display the same value.
  void ExpectAlike(vtkImageData* left, const double at[3])
  {
    const Picture shown = this->Draw(at);
    const std::string text = this->View->GetText(0);
    this->View->SetImage(left);
    const Picture wanted = this->Draw(at);
    EXPECT_EQ(MostSliceDifference(shown, wanted), 0);
    EXPECT_EQ(text, this->View->GetText(0));
    this->View->SetImage(nullptr);
  }

  vtkNew<vtkHapticSliceView> View;
};
} // namespace

TEST_F(SliceBurr, ShowWhatIsLeft)
{
  for (const int type : { VTK_FLOAT, VTK_SHORT })
  {
    SCOPED_TRACE(type);
    vtkNew<vtkImageData> ball;
    ball->SetExtent(-3, 93, 7, 103, 0, 96);
    ball->SetOrigin(-45.0, -55.0, -48.0);
    ball->AllocateScalars(type, 1);
    for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
    {
      ball->GetPointData()->GetScalars()->SetTuple1(
        i, this->Ball->GetPointData()->GetScalars()->GetTuple1(i));
    }
    this->Filter->SetInputData(ball);
    this->Filter->SetRemoval(nullptr);
    const double at[3] = { 2.3, -3.8, 5.2 };
    const Picture whole = this->Draw(at);
    const Hole hole{ { 50.3, 52.1, 55.4 }, 11.5 };
    vtkHapticRemoval* const removal = this->Filter->GetRemoval();
    ASSERT_TRUE(LoadHole(removal, ball, hole, SliceAir));
    EXPECT_TRUE(this->View->Update());
    EXPECT_FALSE(this->View->Update());
    EXPECT_GT(MostSliceDifference(this->Draw(at), whole), 50);
    const auto left = MakeLeft(ball, 0, hole, SliceAir);
    this->ExpectAlike(left, at);
    // These positions are at the edge of the hole, and beside the hole.
    const double edge[3] = { 11.4, -3.8, 5.2 };
    this->ExpectAlike(left, edge);
    const double beside[3] = { 30.0, 30.0, 30.0 };
    this->ExpectAlike(left, beside);
    ASSERT_TRUE(removal->Reset());
    EXPECT_TRUE(this->View->Update());
    EXPECT_EQ(MostSliceDifference(this->Draw(at), whole), 0);
  }
}

/// Removes tissue from the touched component. The other component must remain whole.
TEST_F(SliceBurr, ShowWhatIsLeftOfOneComponent)
{
  vtkNew<vtkImageData> two;
  two->CopyStructure(this->Ball);
  two->AllocateScalars(VTK_FLOAT, 2);
  for (vtkIdType i = 0; i < two->GetNumberOfPoints(); ++i)
  {
    const double value = this->Ball->GetPointData()->GetScalars()->GetTuple1(i);
    two->GetPointData()->GetScalars()->SetTuple2(i, -value, value);
  }
  this->Filter->SetInputData(two);
  this->Filter->GetProperty()->SetComponent(1);
  const Hole hole{ { 48.0, 48.0, 48.0 }, 9.0 };
  ASSERT_TRUE(LoadHole(this->Filter->GetRemoval(), two, hole, SliceAir));
  const double at[3] = { 0.0, 0.0, 0.0 };
  this->ExpectAlike(MakeLeft(two, 1, hole, SliceAir), at);
}

/// The source represents a volume larger than memory. Each sample of its coarse image must be the
/// mean of the fine samples that it covers, after the removal.
TEST_F(SliceBurr, ShowWhatIsLeftOfACoarseLevel)
{
  vtkNew<vtkHapticRegionSource> source;
  source->SetWholeExtent(0, 95, 0, 95, 0, 95);
  source->SetScalarType(VTK_FLOAT);
  source->SetOrigin(-48.0, -48.0, -48.0);
  source->SetReader(
    [](const int extent[6], void* samples)
    {
      auto* sample = static_cast<float*>(samples);
      for (int k = extent[4]; k <= extent[5]; ++k)
      {
        for (int j = extent[2]; j <= extent[3]; ++j)
        {
          for (int i = extent[0]; i <= extent[1]; ++i)
          {
            const double from[3] = { i - 48.0, j - 48.0, k - 48.0 };
            *sample++ = static_cast<float>(100.0 * (30.0 - Length(from)));
          }
        }
      }
      return true;
    });
  ASSERT_TRUE(source->MakeCoarseImage(32 * 32 * 32));
  vtkImageData* const coarse = source->GetCoarseImage();
  ASSERT_EQ(coarse->GetDimensions()[0], 32);
  this->Filter->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkImageData> volume;
  volume->SetExtent(0, 95, 0, 95, 0, 95);
  volume->SetOrigin(-48.0, -48.0, -48.0);
  const Hole hole{ { 50.3, 52.1, 55.4 }, 11.5 };
  const double at[3] = { 2.3, 4.1, 7.4 };
  const Picture whole = this->Draw(at);
  ASSERT_TRUE(LoadHole(this->Filter->GetRemoval(), volume, hole, SliceAir));
  EXPECT_GT(MostSliceDifference(this->Draw(at), whole), 50);
  this->ExpectAlike(MakeLeft(coarse, 0, hole, SliceAir, 3), at);
}
