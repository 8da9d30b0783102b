// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests which part of a volume a cut keeps, and how far away its faces are. The expected values
 * follow from the definitions of planes and of VTK's 27 cropping regions. The image is oblique and
 * has three different spacings.
 */

#include "Core/Model/CutAway.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

using namespace VolumeHaptics;

namespace
{
/// Returns the placement of an image that is rotated by 30 degrees about z and by 40 degrees about
/// the new x. Its spacings are 0.5, 1 and 2 world units.
Affine3 ObliqueImage()
{
  const double a = std::acos(-1.0) / 6.0;
  const double b = std::acos(-1.0) / 4.5;
  const Vector3 x{ std::cos(a), std::sin(a), 0.0 };
  const Vector3 y{ -std::sin(a) * std::cos(b), std::cos(a) * std::cos(b), std::sin(b) };
  return { Matrix3::FromColumns(0.5 * x, y, 2.0 * Cross(x, y)), { 3.0, -7.0, 11.0 } };
}

class CutAwayPlaces : public testing::Test
{
protected:
  double Draw(double low, double high)
  {
    return low + (high - low) * static_cast<double>(this->Engine() >> 11) * 0x1p-53;
  }
  Vector3 DrawIndex() { return { this->Draw(-5, 25), this->Draw(-5, 25), this->Draw(-5, 25) }; }

  std::mt19937_64 Engine{ 5 };
  const Affine3 Image = ObliqueImage();
};
} // namespace

TEST_F(CutAwayPlaces, APlaneIsAsFarAsItsEquationSays)
{
  const Vector3 normal = (1.0 / 3.0) * Vector3{ 1.0, -2.0, 2.0 };
  const CutAway cut({ { normal, 4.0 } }, {}, this->Image, false);
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 index = this->DrawIndex();
    const CutPlace place = cut.Compute(index);
    EXPECT_NEAR(place.Depth, Dot(normal, this->Image(index)) - 4.0, 1e-12);
    EXPECT_EQ(Norm(place.Normal - normal), 0.0);
    const Vector3 voxel = Inverse(this->Image.Linear) * (place.Voxel * normal);
    EXPECT_NEAR(Norm(voxel), 1.0, 1e-12);
    EXPECT_NEAR(place.Fraction(), std::fmin(1.0, std::fmax(0.0, place.Depth / place.Voxel)), 1e-12);
  }
}

// The face of the cut is halfway between the voxels 4 and 5 of the first axis, whose spacing is
// 0.5. The region's first voxel is (2, 1, 0) of the whole volume.
TEST_F(CutAwayPlaces, AHiddenVoxelEndsHalfwayToTheNextOne)
{
  constexpr std::int64_t size[3] = { 8, 6, 4 };
  std::vector<std::uint8_t> flags(static_cast<std::size_t>(size[0] * size[1] * size[2]));
  for (std::size_t at = 0; at < flags.size(); ++at)
  {
    flags[at] = 2 + at % 8 <= 4 ? 6 : 4;
  }
  HiddenVoxels hidden;
  hidden.Flags = flags.data();
  hidden.Hidden = 2;
  std::copy(size, size + 3, hidden.Dimensions);
  hidden.First[0] = 2;
  hidden.First[1] = 1;
  const CutAway cut({}, {}, this->Image, true, hidden);
  const Vector3 normal = this->Image.Linear * Vector3{ 2.0, 0.0, 0.0 };
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 index{ this->Draw(4.001, 4.999), this->Draw(0.0, 8.0), this->Draw(-1.0, 5.0) };
    const CutPlace place = cut.Compute(index);
    EXPECT_NEAR(place.Depth, 0.5 * (index.X - 4.5), 1e-12);
    EXPECT_NEAR(Norm(place.Normal - normal), 0.0, 1e-12);
    EXPECT_NEAR(place.Fraction(), std::clamp(2.0 * (index.X - 4.5), 0.0, 1.0), 1e-12);
  }
  for (const double x : { -3.0, 2.0, 3.9, 4.0 })
  {
    EXPECT_EQ(cut.Compute({ x, 3.3, 2.1 }).Depth, -HUGE_VAL) << x;
  }
  for (const double x : { 5.0, 6.5, 9.0, 30.0 })
  {
    EXPECT_EQ(cut.Compute({ x, 3.3, 2.1 }).Depth, HUGE_VAL) << x;
  }
}

TEST_F(CutAwayPlaces, SeveralPlanesKeepWhatIsInFrontOfAll)
{
  const std::vector<CutPlane> planes = { { { 1.0, 0.0, 0.0 }, 1.0 }, { { 0.0, 0.0, -1.0 }, -20.0 },
    { { 0.0, 0.6, 0.8 }, 2.0 } };
  const CutAway cut(planes, {}, this->Image, false);
  int kept = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 index = this->DrawIndex();
    const Vector3 x = this->Image(index);
    const bool isKept = x.X > 1.0 && x.Z < 20.0 && 0.6 * x.Y + 0.8 * x.Z > 2.0;
    EXPECT_EQ(cut.Compute(index).Depth > 0.0, isKept);
    kept += isKept ? 1 : 0;
  }
  EXPECT_GT(kept, 50);
}

TEST_F(CutAwayPlaces, RegionsKeepWhatTheirFlagsSay)
{
  const Affine3 toIndex = Inverse(this->Image);
  int faces = 0;
  for (int trial = 0; trial < 200; ++trial)
  {
    CutRegions regions;
    for (int axis = 0; axis < 3; ++axis)
    {
      regions.Low[axis] = this->Draw(0.0, 10.0);
      regions.High[axis] = this->Draw(10.0, 20.0);
    }
    regions.Kept = static_cast<std::uint32_t>(this->Engine()) & (CutRegions::All >> 1);
    const CutAway cut({}, regions, this->Image, false);
    // Compute the region's number as vtkVolumeMapper::SetCroppingRegionFlags() does, with the first
    // axis fastest.
    const auto isKept = [&](const Vector3& i)
    {
      const double c[3] = { i.X, i.Y, i.Z };
      int bit = 0;
      for (int axis = 2; axis >= 0; --axis)
      {
        bit = 3 * bit + (c[axis] < regions.Low[axis] ? 0 : (c[axis] > regions.High[axis] ? 2 : 1));
      }
      return (regions.Kept & (1U << bit)) != 0;
    };
    for (int i = 0; i < 50; ++i)
    {
      const Vector3 index = this->DrawIndex();
      const CutPlace place = cut.Compute(index);
      ASSERT_EQ(place.Depth > 0.0, isKept(index));
      if (!std::isfinite(place.Depth))
      {
        continue;
      }
      // Up to the reported depth, the region is the position's own. Just behind it, the region on
      // the other side of the face begins.
      ++faces;
      EXPECT_NEAR(Norm(place.Normal), 1.0, 1e-12);
      const auto at = [&](double fraction)
      { return toIndex(this->Image(index) - (fraction * place.Depth) * place.Normal); };
      EXPECT_EQ(isKept(at(1.0 - 1e-9)), isKept(index));
      EXPECT_NE(isKept(at(1.0 + 1e-9)), isKept(index));
    }
  }
  EXPECT_GT(faces, 5000);
}

TEST_F(CutAwayPlaces, WithoutACutAllIsKept)
{
  const CutAway cut({}, {}, this->Image, true);
  EXPECT_EQ(cut.Compute({ 1.0, 2.0, 3.0 }).Depth, HUGE_VAL);
  EXPECT_EQ(cut.Compute({ 1.0, 2.0, 3.0 }).Fraction(), 1.0);
}
