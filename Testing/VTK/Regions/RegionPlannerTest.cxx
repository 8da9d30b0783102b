// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests which region is fetched, and when, for hands that rest, tremble and move. */

#include "VTK/Regions/RegionPlanner.h"
#include "Rigs/ApiRig.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace apitest;

namespace
{
class Planner : public testing::Test
{
protected:
  Planner()
  {
    this->SetWhole({ 0, 999, 0, 999, 0, 999 });
    this->Plan.AddLatency(0.1); // latency (s) in which a hand of 0.5 m/s moves 50 world units
    this->Plan.SetMaximumVoxels(1 << 24);
  }
  void SetWhole(const std::array<int, 6>& extent, double spacing = 1.0)
  {
    const double origin[3] = { 0.0, 0.0, 0.0 };
    const double steps[3] = { spacing, 1.0, 1.0 };
    const double direction[9] = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
    this->Plan.SetWhole(extent.data(), origin, steps, direction);
  }
  bool Wants(double x, double vx = 0.0)
  {
    const double tip[3] = { x, 500.0, 500.0 };
    const double velocity[3] = { vx, 0.0, 0.0 };
    return this->Plan.Plan(tip, velocity, this->Resident, this->Wanted);
  }
  void Forget() { this->Resident[1] = this->Resident[0] - 1; }
  void Take() { std::copy(this->Wanted, this->Wanted + 6, this->Resident); }

  VolumeHaptics::RegionPlanner Plan;
  int Resident[6] = { 0, -1, 0, -1, 0, -1 };
  int Wanted[6] = {};
};
} // namespace

TEST_F(Planner, TellsTheRoomThatARegionGivesATip)
{
  // The room is the distance to the border, less T_N/k, reach and band (4 + 8 + 4 world units).
  const double tip[3] = { 520.0, 300.0, 5.0 };
  const int around[6] = { 480, 600, 200, 400, 0, 70 };
  EXPECT_DOUBLE_EQ(this->Plan.ComputeRoom(tip, around), 40.0 - 16.0) << "the volume's end is none";
  const int beside[6] = { 510, 600, 200, 400, 0, 70 };
  EXPECT_DOUBLE_EQ(this->Plan.ComputeRoom(tip, beside), 10.0 - 16.0);
  const int none[6] = { 0, -1, 0, -1, 0, -1 };
  EXPECT_LT(this->Plan.ComputeRoom(tip, none), 0.0);
}

TEST_F(Planner, TakesWhatCanBeReachedUntilTheNextOneComes)
{
  EXPECT_DOUBLE_EQ(this->Plan.GetHalfWidth(), 500.0 * 0.1 + 4.0 + 8.0 + 4.0);
  EXPECT_TRUE(this->Wants(500.0)) << "there is none yet";
  EXPECT_EQ(this->Wanted[0], 500 - 66);
  EXPECT_EQ(this->Wanted[1], 500 + 66);
  this->Wants(500.0, 300.0);
  EXPECT_EQ(this->Wanted[0], 530 - 66) << "ahead of the tip";
  this->Wants(500.0, 1e6);
  EXPECT_EQ(this->Wanted[0], 550 - 66) << "no faster than a hand";
  this->SetWhole({ 0, 999, 0, 999, 0, 999 }, 0.5);
  this->Wants(250.0);
  EXPECT_EQ(this->Wanted[0], 500 - 132);
  this->Wants(2.0);
  EXPECT_EQ(this->Wanted[0], 0) << "clipped";
  this->SetWhole({ 10, 130, -5, 120, 0, 110 }, 0.5);
  this->Wants(40.0);
  EXPECT_TRUE(std::equal(this->Wanted, this->Wanted + 6, this->Plan.GetWhole().Extent))
    << "the whole fits";
}

TEST_F(Planner, FetchesNothingForAHandThatRestsOrTrembles)
{
  for (const vtkIdType most : { vtkIdType{ 1 } << 24, vtkIdType{ 4096 }, vtkIdType{ 100000 } })
  {
    this->Plan.SetMaximumVoxels(most);
    this->Forget();
    EXPECT_TRUE(this->Wants(500.0));
    this->Take();
    for (int i = 0; i < 100; ++i)
    {
      EXPECT_FALSE(this->Wants(500.0 + 1.5 * std::sin(0.3 * i))) << most;
    }
  }
}

TEST_F(Planner, IsInTimeAtEverySteadySpeed)
{
  for (const double speed : { 10.0, 100.0, 300.0, 500.0 }) // speed in world units per second
  {
    double x = 200.0;
    EXPECT_TRUE(this->Wants(x, speed));
    this->Take();
    int here[6];
    std::copy(this->Resident, this->Resident + 6, here);
    int fetches = 0;
    double comes = -1.0;
    for (double time = 0.0; x < 800.0; time += 1e-3, x += 1e-3 * speed)
    {
      if (comes >= 0.0 && time >= comes)
      {
        std::copy(this->Resident, this->Resident + 6, here);
        comes = -1.0;
      }
      // The resident region must include the spring, the reach and the band around the tip: 16
      // world units in total.
      ASSERT_GE(x - 16.0, here[0]) << speed << " at " << time;
      ASSERT_LE(x + 16.0, here[1]) << speed << " at " << time;
      if (comes < 0.0 && this->Wants(x, speed))
      {
        this->Take();
        comes = time + 0.1;
        ++fetches;
      }
    }
    EXPECT_GT(fetches, 5);
    EXPECT_LT(fetches, 40);
    this->Forget();
  }
}
