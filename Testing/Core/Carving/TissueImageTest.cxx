// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * B4: writes removed tissue to an image and reads it back. Both must be equal to the bit.
 */

#include "Core/Carving/TissueImage.h"
#include "Rigs/CarvingRig.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{
constexpr std::int64_t Lengths[3] = { 37, 29, 21 };
constexpr TissueBox WholeBox{ { 0, 0, 0 }, { 37, 29, 21 } };

void RemoveSome(CarvedBricks& bricks, std::uint64_t seed, int samples)
{
  std::mt19937_64 engine(seed);
  for (int n = 0; n < samples; ++n)
  {
    const auto along = [&engine](std::int64_t length)
    { return static_cast<std::int64_t>(engine() % static_cast<std::uint64_t>(length)); };
    const std::int64_t i = along(30); // bricks beyond i = 30 stay whole
    const std::int64_t j = along(Lengths[1]);
    SetFraction(bricks, i, j, along(Lengths[2]), static_cast<std::uint8_t>(engine()));
  }
}

std::vector<std::uint8_t> Write(const CarvedBricks& bricks, const TissueBox& box)
{
  std::vector<std::uint8_t> image(
    static_cast<std::size_t>(box.Size[0] * box.Size[1] * box.Size[2]), 7);
  WriteTissue(bricks, box, image.data());
  return image;
}
} // namespace

TEST(TissueImage, HasTheTissueOfEachSample)
{
  CarvedBricks bricks(100);
  EXPECT_EQ(Write(bricks, WholeBox), std::vector<std::uint8_t>(37 * 29 * 21, 255));
  RemoveSome(bricks, 1, 3000);
  EXPECT_EQ(Write(bricks, WholeBox), CopyTissue(bricks, Lengths));
  // Write a box inside the volume, and a box beyond all bricks, where the tissue is whole.
  const TissueBox part{ { 5, 8, 3 }, { 20, 13, 16 } };
  const std::vector<std::uint8_t> image = Write(bricks, part);
  for (std::int64_t at = 0; at < 20 * 13 * 16; ++at)
  {
    ASSERT_EQ(image[static_cast<std::size_t>(at)],
      bricks.GetFraction(5 + at % 20, 8 + at / 20 % 13, 3 + at / 260));
  }
  EXPECT_EQ(Write(bricks, { { 500, 0, 0 }, { 3, 3, 3 } }), std::vector<std::uint8_t>(27, 255));
}

TEST(TissueImage, IsReadToTheBit)
{
  CarvedBricks bricks(100);
  RemoveSome(bricks, 2, 3000);
  const std::vector<std::uint8_t> image = Write(bricks, WholeBox);
  CarvedBricks copy(100);
  ASSERT_TRUE(ReadTissue(copy, WholeBox, image.data()));
  EXPECT_EQ(CopyTissue(copy, Lengths), CopyTissue(bricks, Lengths));
  EXPECT_EQ(copy.GetCount(), bricks.GetCount()) << "whole bricks need no memory";
  // Read the image into bricks that contain another removal. Nothing of that removal may remain.
  CarvedBricks other(100);
  RemoveSome(other, 3, 500);
  SetFraction(other, 90, 0, 0, 3);
  const int follower = other.AddFollower();
  ASSERT_TRUE(ReadTissue(other, WholeBox, image.data()));
  EXPECT_EQ(CopyTissue(other, Lengths), CopyTissue(bricks, Lengths));
  EXPECT_EQ(other.GetFraction(90, 0, 0), CarvedBricks::Whole);
  std::size_t changed = 0;
  other.DrainChanged(follower, [&changed](std::uint32_t) { ++changed; });
  EXPECT_EQ(changed, other.GetCount());
}

TEST(TissueImage, ThatHasNoRoomChangesNothing)
{
  CarvedBricks bricks(100);
  RemoveSome(bricks, 4, 3000);
  const std::vector<std::uint8_t> image = Write(bricks, WholeBox);
  CarvedBricks few(bricks.GetCount() - 1);
  SetFraction(few, 3, 3, 3, 11);
  const std::vector<std::uint8_t> before = CopyTissue(few, Lengths);
  EXPECT_FALSE(ReadTissue(few, WholeBox, image.data()));
  EXPECT_EQ(CopyTissue(few, Lengths), before);
  EXPECT_EQ(few.GetCount(), 1u);
  for (const TissueBox& bad :
    { TissueBox{ { -1, 0, 0 }, { 37, 29, 21 } }, TissueBox{ { 0, 0, 0 }, { 37, 0, 21 } },
      TissueBox{ { 0, 0, 1LL << 24 }, { 37, 29, 21 } } })
  {
    EXPECT_FALSE(ReadTissue(bricks, bad, image.data()));
  }
}

/// A reader that writes only the changed bricks must get the complete image.
TEST(TissueImage, IsFollowedBrickByBrick)
{
  CarvedBricks bricks(100);
  const TissueBox box{ { 2, 3, 1 }, { 30, 25, 19 } };
  std::vector<std::uint8_t> image = Write(bricks, box);
  const int follower = bricks.AddFollower();
  for (std::uint64_t round = 0; round < 20; ++round)
  {
    RemoveSome(bricks, 10 + round, 40);
    bricks.DrainChanged(
      follower, [&](std::uint32_t brick) { WriteBrick(bricks, brick, box, image.data()); });
    ASSERT_EQ(image, Write(bricks, box));
  }
}
