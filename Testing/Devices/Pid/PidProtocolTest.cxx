// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that a force-feedback device's reports are found by their usages and filled in correctly,
 * byte by byte.
 */

#include "Rigs/PidRig.h"

#include <cmath>
#include <limits>

using namespace hardwaretest;

TEST(PidProtocol, FillsReportsToTheByte)
{
  const PidDevice device = Mapped({});
  EXPECT_EQ(device.GetNumberOfAxes(), 2);
  EXPECT_EQ(Wire(device.Control(PidUsage::EnableActuators)), (Bytes{ 0x15, 0x01 }));
  EXPECT_EQ(Wire(device.Control(PidUsage::StopAllEffects)), (Bytes{ 0x15, 0x03 }));
  EXPECT_EQ(Wire(device.Control(PidUsage::DeviceReset)), (Bytes{ 0x15, 0x04 }));
  EXPECT_EQ(Wire(device.FullGain()), (Bytes{ 0x14, 0xFF }));
  EXPECT_EQ(Wire(device.CreateConstant()), (Bytes{ 0x18, 0x01, 0x00, 0x00 }));
  EXPECT_EQ(device.CreateConstant().Kind, HidReportKind::Feature);
  // Expect these bytes: block 5 (and 6), constant force, 100 ms (and 50 ms), full gain, Direction
  // Enable without the axes' bits, and 90 (and 0) degrees.
  EXPECT_EQ(Wire(device.SetEffect(5, 0, 0.1)),
    (Bytes{ 0x11, 0x05, 0x01, 0x64, 0x00, 0xFF, 0x04, 0x40, 0x00 }));
  EXPECT_EQ(Wire(device.SetEffect(6, 1, 0.05)),
    (Bytes{ 0x11, 0x06, 0x01, 0x32, 0x00, 0xFF, 0x04, 0x00, 0x00 }));
  EXPECT_EQ(Wire(device.Operate(5, PidUsage::EffectStart)), (Bytes{ 0x13, 0x05, 0x01, 0x01 }));
  EXPECT_EQ(Wire(device.Operate(5, PidUsage::EffectStop)), (Bytes{ 0x13, 0x05, 0x03, 0x01 }));
  EXPECT_EQ(Wire(device.AskPool()), (Bytes{ 0x16, 0x00, 0x00, 0x00 }));
  EXPECT_EQ(Wire(device.AskBlockLoad()), (Bytes{ 0x17, 0x00, 0x00 }));
}

TEST(PidProtocol, TakesOtherIdsAndControlsInBits)
{
  Stick stick;
  stick.FirstId = 0xA0;
  stick.ControlInBits = true;
  const PidDevice device = Mapped(stick);
  EXPECT_EQ(Wire(device.Control(PidUsage::EnableActuators)), (Bytes{ 0xA4, 0x01 }));
  EXPECT_EQ(Wire(device.Control(PidUsage::StopAllEffects)), (Bytes{ 0xA4, 0x04 }));
  EXPECT_EQ(Wire(device.Control(PidUsage::DeviceReset)), (Bytes{ 0xA4, 0x08 }));
  EXPECT_EQ(Wire(device.FullGain()), (Bytes{ 0xA3, 0xFF }));
}

TEST(PidProtocol, GoesByDirectionsWhereAxesCannotBeEnabled)
{
  Stick stick;
  stick.HasAxesEnable = false;
  const PidDevice device = Mapped(stick);
  EXPECT_EQ(device.GetNumberOfAxes(), 2);
  EXPECT_EQ(Wire(device.SetEffect(5, 1, 0.1)),
    (Bytes{ 0x11, 0x05, 0x01, 0x64, 0x00, 0xFF, 0x04, 0x00, 0x00 }));
}

TEST(PidProtocol, OfSharesItTakesTheWholeAxis)
{
  PidDevice device = Mapped({});
  device.UseShares();
  // Expect the bit of x without Direction Enable, and the largest value of the direction's range.
  EXPECT_EQ(Wire(device.SetEffect(5, 0, 0.1)),
    (Bytes{ 0x11, 0x05, 0x01, 0x64, 0x00, 0xFF, 0x01, 0xFF, 0x00 }));
}

TEST(PidProtocol, HasTheAxesThatItUses)
{
  for (const bool hasAxesEnable : { true, false })
  {
    Stick stick;
    stick.HasAxesEnable = hasAxesEnable;
    PidDevice device = Mapped(stick);
    EXPECT_EQ(device.GetNumberOfAxes(), 2);
    device.UseOneAxis();
    EXPECT_EQ(device.GetNumberOfAxes(), 1);
  }
}

TEST(PidProtocol, NewtonsBecomeMagnitudesOfAnyRange)
{
  struct Case
  {
    std::int16_t Range;
    double Newtons;
    Bytes Expected;
  };
  // The full scale is 4 N: 1 N is a quarter of the range, and 10 N is limited to the full scale.
  const Case cases[] = { { 10000, 1.0, { 0x12, 0x02, 0xC4, 0x09 } },
    { 10000, -1.0, { 0x12, 0x02, 0x3C, 0xF6 } }, { 10000, 10.0, { 0x12, 0x02, 0x10, 0x27 } },
    { 10000, -10.0, { 0x12, 0x02, 0xF0, 0xD8 } }, { 32767, 1.0, { 0x12, 0x02, 0x00, 0x20 } },
    { 32767, 1e300, { 0x12, 0x02, 0xFF, 0x7F } }, { 32767, -1e300, { 0x12, 0x02, 0x01, 0x80 } },
    { 255, 1.0, { 0x12, 0x02, 0x40, 0x00 } }, { 255, -10.0, { 0x12, 0x02, 0x01, 0xFF } } };
  for (const Case& c : cases)
  {
    SCOPED_TRACE(testing::Message() << c.Newtons << " N, range " << c.Range);
    Stick stick;
    stick.Magnitude = c.Range;
    EXPECT_EQ(Wire(Mapped(stick).SetConstant(2, 0, c.Newtons, 4.0)), c.Expected);
  }
  const PidDevice device = Mapped({});
  const Bytes nothing{ 0x12, 0x02, 0x00, 0x00 };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Wire(device.SetConstant(2, 0, nan, 4.0)), nothing);
  EXPECT_EQ(Wire(device.SetConstant(2, 0, HUGE_VAL, 4.0)), nothing);
  EXPECT_EQ(Wire(device.SetConstant(2, 0, 1.0, nan)), nothing);
  EXPECT_EQ(Wire(device.SetConstant(2, 0, 1.0, 0.0)), nothing);
  EXPECT_EQ(Wire(device.SetConstant(2, 0, 1.0, -4.0)), (Bytes{ 0x12, 0x02, 0x3C, 0xF6 }));
}

TEST(PidProtocol, ReadsWhatTheDeviceSays)
{
  const PidDevice device = Mapped({});
  std::int64_t block = -1;
  const auto read = [&](const Bytes& payload)
  { return device.ReadBlockLoad(payload.data(), payload.size(), block); };
  EXPECT_EQ(read({ 0x03, 0x01 }), BlockLoadStatus::Success);
  EXPECT_EQ(block, 3);
  EXPECT_EQ(read({ 0x03, 0x02 }), BlockLoadStatus::Full);
  EXPECT_EQ(read({ 0x03, 0x03 }), BlockLoadStatus::Error);
  EXPECT_EQ(read({ 0x03, 0x00 }), BlockLoadStatus::Waiting);
  EXPECT_EQ(read({ 0x00, 0x01 }), BlockLoadStatus::Waiting) << "no block 0";
  EXPECT_EQ(read({ 0x29, 0x01 }), BlockLoadStatus::Waiting) << "no block 41";
  EXPECT_EQ(read({ 0x03 }), BlockLoadStatus::Waiting);
  EXPECT_EQ(read({}), BlockLoadStatus::Waiting);
  const Bytes pool{ 0x00, 0x10, 0x0A };
  EXPECT_EQ(device.ReadPool(pool.data(), 3), 10);
  EXPECT_EQ(device.ReadPool(pool.data(), 2), 0);
}
