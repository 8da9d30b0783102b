// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the grip's lights and buttons, bit by bit.
 */

#include "Rigs/FalconRig.h"

using namespace emulated;

namespace
{
class FalconPanel : public FalconTest
{
protected:
  bool Lights(int expected)
  {
    return Eventually([&] { return this->Falcon.GetLights() == expected; });
  }
  std::uint32_t Buttons()
  {
    DeviceSample sample;
    EXPECT_TRUE(Eventually(
      [&] { return this->Device->Read(0.001, sample) == DeviceState::Running && sample.Fresh; }));
    return sample.Buttons;
  }
};
} // namespace

TEST_F(FalconPanel, LightsShowTheConditionOrWhatIsWanted)
{
  ASSERT_TRUE(this->Open()) << this->Error;
  EXPECT_TRUE(this->Lights(0x09)) << "homing, which every packet asks for, and red";
  this->LeadTo({ 0.0, 0.0, 0.1735 });
  this->LeadTo({ 0.0, 0.0, 0.08 });
  EXPECT_TRUE(this->Lights(0x05)) << "blue: pull it out";
  this->LeadTo(Rest);
  EXPECT_TRUE(this->Lights(0x03)) << "green: ready";
  EXPECT_TRUE(this->Push({ 0.0, 0.0, 1.0 }, [&] { return this->Falcon.GetLights() == 0x05; }));
  EXPECT_TRUE(this->Push({}, [&] { return this->Falcon.GetLights() == 0x03; }));
  for (const int lights : { 0, 1, 2, 4, 7 })
  {
    this->Device->SetLights(lights);
    EXPECT_TRUE(this->Lights(2 * lights + 1)) << lights;
  }
  this->Device->SetLights(-1);
  EXPECT_TRUE(this->Lights(0x03));
}

TEST_F(FalconPanel, ButtonsAreInTheirOrder)
{
  this->MakeReady();
  // Pairs of button bits: of the device (plus, forward, centre, minus), and of the driver (centre,
  // plus, minus, forward).
  const int pairs[][2] = { { 0, 0 }, { 4, 1 }, { 1, 2 }, { 8, 4 }, { 2, 8 }, { 15, 15 } };
  for (const auto& pair : pairs)
  {
    this->Falcon.SetButtons(pair[0]);
    EXPECT_TRUE(Eventually([&] { return this->Buttons() == static_cast<std::uint32_t>(pair[1]); }))
      << pair[0];
  }
}
