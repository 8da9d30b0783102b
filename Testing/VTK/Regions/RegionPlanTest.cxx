// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests plans of RegionPlanner, including extreme numbers. */

#include "Rigs/ApiRig.h"
#include "VTK/Filter/PlannerSettings.h"
#include "VTK/Regions/RegionPlanner.h"

#include <vtkHapticRegionFilter.h>

#include <cmath>
#include <random>
#include <string>

using namespace apitest;

namespace
{
class Plan : public testing::Test
{
protected:
  Plan() { this->Planner.AddLatency(0.1); }
  void SetWhole(const int extent[6])
  {
    const double origin[3] = { 0.0, 0.0, 0.0 };
    const double spacing[3] = { 1.0, 1.0, 1.0 };
    const double direction[9] = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
    this->Planner.SetWhole(extent, origin, spacing, direction);
  }

  VolumeHaptics::RegionPlanner Planner;
  int Wanted[6] = {};
};
} // namespace

TEST_F(Plan, AlwaysGivesARegionOfTheWhole)
{
  std::mt19937 random(11);
  const double odd[] = { 0.0, 1.0, -1.0, NAN, HUGE_VAL, -HUGE_VAL, 1e300, -1e300, 1e-300, 123.4 };
  const auto any = [&]
  { return random() % 3 ? odd[random() % 10] : 1e-3 * double(random() % 1000000); };
  for (int i = 0; i < 100000; ++i)
  {
    int whole[6];
    double voxels = 1.0;
    for (int a = 0; a < 6; a += 2)
    {
      whole[a] = random() % 50 == 0 ? -2147483647 : static_cast<int>(random() % 2000) - 1000;
      const std::int64_t last = whole[a] + static_cast<std::int64_t>(random() % 300);
      whole[a + 1] = random() % 50 == 0 ? 2147483647 : static_cast<int>(last);
      voxels *= double(whole[a + 1]) - whole[a] + 1.0;
    }
    const double origin[3] = { any(), any(), any() };
    const double spacing[3] = { any(), any(), any() };
    const double direction[9] = { any(), any(), any(), any(), any(), any(), any(), any(), any() };
    this->Planner.SetWhole(whole, origin, spacing, direction);
    this->Planner.Reach = any();
    this->Planner.MaximumSpeed = any();
    this->Planner.AddLatency(any());
    this->Planner.SetMaximumVoxels(random() % 2 ? 4096 : 200000);
    const double tip[3] = { any(), any(), any() };
    const double velocity[3] = { any(), any(), any() };
    const int resident[6] = { int(random()), int(random()), 0, 5, int(random() % 9), 7 };
    this->Planner.Plan(tip, velocity, resident, this->Wanted);
    double taken = 1.0;
    for (int a = 0; a < 6; a += 2)
    {
      ASSERT_LE(whole[a], this->Wanted[a]);
      ASSERT_LE(this->Wanted[a], this->Wanted[a + 1]);
      ASSERT_LE(this->Wanted[a + 1], whole[a + 1]);
      taken *= double(this->Wanted[a + 1]) - this->Wanted[a] + 1.0;
    }
    const double most = double(this->Planner.GetMaximumVoxels());
    ASSERT_LE(taken, most);
    ASSERT_TRUE(voxels > most || taken == voxels);
    ASSERT_TRUE(
      std::isfinite(this->Planner.GetHalfWidth()) && std::isfinite(this->Planner.GetLatency()));
  }
}

TEST_F(Plan, LeavesAHandThatStopsItsData)
{
  const int whole[6] = { 0, 999, 0, 999, 0, 999 };
  this->SetWhole(whole);
  this->Planner.SetMaximumVoxels(44 * 44 * 44);
  const double needed = 13.0; // world units around the tip; a region reaches 22 to each side
  this->Planner.SpringLength = 4.0;
  this->Planner.Reach = 5.0;
  this->Planner.Band = 4.0;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(100.0, 900.0);
  std::uniform_real_distribution<double> speed(-500.0, 500.0);
  for (int i = 0; i < 1000; ++i)
  {
    this->Planner.ResetLatency();
    this->Planner.AddLatency(1e-3 * double(random() % 500));
    const double tip[3] = { place(random), place(random), place(random) };
    const double velocity[3] = { speed(random), speed(random), speed(random) };
    const int none[6] = { 0, -1, 0, -1, 0, -1 };
    this->Planner.Plan(tip, velocity, none, this->Wanted);
    for (int a = 0; a < 3; ++a)
    {
      ASSERT_LE(this->Wanted[2 * a], tip[a] - needed);
      ASSERT_GE(this->Wanted[2 * a + 1], tip[a] + needed);
    }
  }
}

/// A region of 20^3 extends 10 world units to each side, but a tick needs 60. The next region must
/// be requested when half of the 10 units is left.
TEST_F(Plan, OrdersTheNextCutRegionBeforeTheTipLeavesThisOne)
{
  const int whole[6] = { 0, 999, 0, 999, 0, 999 };
  this->SetWhole(whole);
  this->Planner.SetMaximumVoxels(21 * 21 * 21);
  this->Planner.SpringLength = 40.0;
  this->Planner.Reach = 10.0;
  this->Planner.Band = 10.0;
  const double atRest[3] = { 0.0, 0.0, 0.0 };
  const int none[6] = { 0, -1, 0, -1, 0, -1 };
  int resident[6];
  const double first[3] = { 500.0, 500.0, 500.0 };
  ASSERT_TRUE(this->Planner.Plan(first, atRest, none, resident));
  ASSERT_EQ(resident[1] - resident[0], 20);
  double ordered = 0.0;
  for (double x = 500.0; ordered == 0.0 && x < 520.0; x += 0.25)
  {
    const double tip[3] = { x, 500.0, 500.0 };
    ordered = this->Planner.Plan(tip, atRest, resident, this->Wanted) ? x : 0.0;
  }
  EXPECT_NEAR(ordered, 505.0, 0.5);
}

TEST_F(Plan, SmoothsLatenciesAndKnowsWholesFromRegions)
{
  EXPECT_EQ(this->Planner.GetLatency(), 0.1) << "the first counts whole";
  this->Planner.AddLatency(0.3);
  EXPECT_DOUBLE_EQ(this->Planner.GetLatency(), 0.2) << "rises soon";
  this->Planner.AddLatency(0.1);
  EXPECT_DOUBLE_EQ(this->Planner.GetLatency(), 0.19) << "falls slowly";
  this->Planner.AddLatency(NAN);
  this->Planner.AddLatency(-1.0);
  EXPECT_DOUBLE_EQ(this->Planner.GetLatency(), 0.19);
  vtkNew<vtkHapticRegionFilter> crop;
  crop->SetInputData(MakeRamp());
  crop->SetRegion(2, 12, 3, 13, 0, 15);
  crop->Update();
  std::string error;
  EXPECT_TRUE(this->Planner.SetWhole(crop->GetOutput(), error)) << error;
  EXPECT_EQ(this->Planner.GetWhole().Extent[1], 15);
  vtkNew<vtkVolumeHapticsFilter> touch; // filter with 500 N/m, 2 N, and a kernel of 2 voxels
  VolumeHaptics::ConfigurePlanner(this->Planner, touch);
  EXPECT_DOUBLE_EQ(this->Planner.SpringLength, 4.0);
  EXPECT_DOUBLE_EQ(this->Planner.Reach, 9.0) << "as far as the walk to the far side goes";
  EXPECT_DOUBLE_EQ(this->Planner.Band, 4.0);
  touch->SetMaterialPlacementToKernel();
  VolumeHaptics::ConfigurePlanner(this->Planner, touch);
  EXPECT_DOUBLE_EQ(this->Planner.Reach, 5.0);
}

TEST_F(Plan, HasRoomForWallsOfCoarseLabels)
{
  vtkNew<vtkImageData> labels;
  labels->SetDimensions(4, 4, 4);
  labels->SetSpacing(5.0, 4.0, 6.0);
  labels->AllocateScalars(VTK_INT, 1);
  vtkNew<vtkVolumeHapticsFilter> touch;
  touch->SetLabelData(labels);
  VolumeHaptics::ConfigurePlanner(this->Planner, touch);
  EXPECT_DOUBLE_EQ(this->Planner.Reach, 2.0 * 6.0 + 3.0) << "x_s, and three voxels to spare";
  labels->SetSpacing(0.5, 0.5, 0.5);
  VolumeHaptics::ConfigurePlanner(this->Planner, touch);
  EXPECT_DOUBLE_EQ(this->Planner.Reach, 9.0);
  labels->SetSpacing(5.0, 4.0, 6.0);
  touch->SetMethodToForceField();
  VolumeHaptics::ConfigurePlanner(this->Planner, touch);
  EXPECT_DOUBLE_EQ(this->Planner.Reach, 5.0) << "which has no labels";
}
