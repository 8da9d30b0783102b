// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that a region of a volume has the same force as the whole volume, to the bit, even while
 * regions change under a hand that presses.
 */

#include "RegionRig.h"

#include <cmath>

using namespace servotest;

namespace
{
class Region : public testing::TestWithParam<MethodCase>
{
protected:
  /// Compares ticks in the whole volume with ticks in a region that reaches `half` voxels to each
  /// side, and is replaced every `period` ticks.
  void Compare(int period, std::int64_t half)
  {
    const HapticModel whole(this->Whole);
    std::shared_ptr<const HapticModel> region;
    ServoState state;
    ServoState regionState;
    ResidentServo servo;
    ForceGate gate;
    TickRecord record;
    TickRecord felt;
    int contacts[4] = {};
    for (int i = 0; i < 1500; ++i)
    {
      const Vector3 tip = TipOf(i);
      if (i % period == 0)
      {
        // Vary the region's position relative to the tip. Samples outside the region do not exist.
        const Vector3 off = 1e-3 * Vector3{ double(i % 3), double(i % 2), -double(i % 3) };
        HapticModelDescription d = CropAround(this->Whole, tip + off, half);
        d.Number = region ? region->Baked->Number : 0;
        auto next = std::make_shared<const HapticModel>(d);
        ASSERT_FALSE(next->Resident.IsWhole());
        if (region)
        {
          CarryState(*region, *next, regionState);
        }
        region = next;
      }
      Tick(whole, state, tip, record);
      servo.Tick(*region, regionState, tip, 1e-3, felt, LocalSurfaceResult::Simulated(), gate);
      ASSERT_EQ(gate.GetOpening(), 1.0) << i;
      ASSERT_FALSE(servo.IsAwaiting());
      ASSERT_TRUE(IsSame(felt.Force, record.Force)) << i << ": " << Norm(felt.Force - record.Force);
      ASSERT_TRUE(IsSame(felt.Proxy, record.Proxy)) << i;
      ++contacts[static_cast<int>(record.Contact)];
    }
    const bool isHeld = this->GetParam().Method != HapticMethod::ForceField;
    EXPECT_GT(contacts[static_cast<int>(ContactState::Sliding)], isHeld ? 200 : -1);
    EXPECT_GT(contacts[static_cast<int>(ContactState::Penetrating)],
      this->GetParam().Method == HapticMethod::Proxy ? 50 : -1);
  }

  HapticModelDescription Whole =
    DescribeBall(this->GetParam().Method, this->GetParam().Solver, this->GetParam().Placement);
};
} // namespace

TEST_P(Region, IsFeltAsTheWhole)
{
  this->Compare(150, 34);
}

TEST_P(Region, TakesThePlaceOfAnotherWithoutATrace)
{
  this->Compare(20, 27);
}

TEST_P(Region, EndsWhereTheVolumeEndsAsTheWholeDoes)
{
  this->Whole.KernelRadius = 3;
  const HapticModel whole(this->Whole);
  // The region contains the lowest planes along x, so one of its ends is the volume's border, and
  // the other end is only the region's.
  const HapticModel region(Crop(this->Whole, { 0, 0, 0 }, { 44, Samples, Samples }));
  EXPECT_TRUE(
    HapticModel(Crop(this->Whole, { 0, 0, 0 }, { Samples, Samples, Samples })).Resident.IsWhole());
  ServoState state;
  ServoState regionState;
  ResidentServo servo;
  ForceGate gate;
  TickRecord record;
  TickRecord felt;
  for (int i = 0; i < 900; ++i)
  {
    // Move from 5 mm outside to 20 mm inside and back.
    const double x = -40.0 + 25.0 * std::sin(0.0035 * i);
    const Vector3 tip = 1e-3 * Vector3{ x, 3.0 * std::sin(0.01 * i), 0.02 * i };
    Tick(whole, state, tip, record);
    servo.Tick(region, regionState, tip, 1e-3, felt, LocalSurfaceResult::Simulated(), gate);
    ASSERT_EQ(gate.GetOpening(), 1.0) << i;
    ASSERT_TRUE(IsSame(felt.Force, record.Force)) << i;
    const Vector3 at = whole.DeviceToIndex(tip);
    ASSERT_EQ(region.BorderFade(at), whole.BorderFade(at));
    ASSERT_EQ(region.Baked->Field.IsInside(at), whole.Baked->Field.IsInside(at));
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Region, testing::ValuesIn(MethodCases), NameOf);
