// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ArduinoFfbModel.h"

#include "HidItems.h"

#include <cerrno>

namespace emulated
{
namespace
{
enum ReportId : std::uint8_t
{
  Place = 1,
  Status = 2,
  SetEffect = 1,
  Envelope = 2,
  Condition = 3,
  Periodic = 4,
  Constant = 5,
  Ramp = 6,
  CustomData = 7,
  Sample = 8,
  Operation = 10,
  BlockFree = 11,
  DeviceControl = 12,
  DeviceGain = 13,
  Custom = 14,
  CreateEffect = 5,
  BlockLoad = 6,
  Pool = 7
};
constexpr int ConstantForce = 1;
constexpr int Infinite = 0x7FFF;     ///< ms
constexpr int DirectionEnable = 4;   ///< value of the Direction Enable bit in Set Effect
constexpr int FullGain = 100;        ///< per cent, set by the sketch
constexpr int FullForce = 250;       ///< largest force that is passed to the sketch
constexpr int FullMagnitude = 10000; ///< largest magnitude in a report

void BlockIndex(HidItems& items)
{
  items.Usage(0x22).Logical(1, 40).Bounds(1, 40).Fields(8, 1).Output();
}

void EffectTypes(HidItems& items)
{
  items.Usage(0x25).Open(HidItems::LogicalCollection);
  items.Usages(0x26, 0x27, 0x30, 0x31, 0x32, 0x33, 0x34, 0x40, 0x41, 0x42, 0x43, 0x28);
  items.Logical(1, 12).Bounds(1, 12).Fields(8, 1);
}

void Ordinals(HidItems& items)
{
  items.Open(HidItems::LogicalCollection).Usages(0x000A0001, 0x000A0002);
}

/** Divides like the board's processor: a division by 0 yields a quotient with all bits set. */
int Divide(int a, int b)
{
  return b == 0 ? -1 : a / b;
}

void DescribeSetEffect(HidItems& items)
{
  items.Usage(0x21).Open(HidItems::LogicalCollection).Id(SetEffect);
  BlockIndex(items);
  EffectTypes(items);
  items.Output(HidItems::Array).Close();
  items.Usages(0x50, 0x54, 0x51).Logical(0, 32767).Bounds(0, 32767);
  items.Unit(0x1003, 0xFD).Fields(16, 3).Output().Unit(0, 0);
  items.Usage(0x52).Logical(0, 255).Bounds(0, 10000).Fields(8, 1).Output();
  items.Usage(0x53).Logical(1, 8).Bounds(1, 8).Output();
  items.Usage(0x55).Open(HidItems::LogicalCollection).Page(0x01).Usages(0x30, 0x31);
  items.Logical(0, 1).Fields(1, 2).Output().Close();
  items.Page(0x0F).Usage(0x56).Fields(1, 1).Output().Fields(1, 5).Output(HidItems::Padding);
  items.Usage(0x57);
  Ordinals(items);
  items.Unit(0, 0xFE).Logical(0, 255).Bounds(0, 36000).Fields(8, 2).Output().Unit(0, 0).Close();
  items.Page(0x0F).Usage(0x58);
  Ordinals(items);
  items.Logical(0, 32765).Fields(16, 2).Output().Close().Close();
}

void DescribeOtherEffects(HidItems& items)
{
  items.Usage(0x5A).Open(HidItems::LogicalCollection).Id(Envelope);
  BlockIndex(items);
  items.Usages(0x5B, 0x5D).Logical(0, 10000).Bounds(0, 10000).Fields(16, 2).Output();
  items.Usages(0x5C, 0x5E).Unit(0x1003, 0xFD).Logical(0, 32767).Bounds(0, 32767);
  items.Fields(32, 2).Output().Unit(0, 0).Close();

  items.Usage(0x5F).Open(HidItems::LogicalCollection).Id(Condition);
  BlockIndex(items);
  items.Usage(0x23).Logical(0, 3).Bounds(0, 3).Fields(4, 1).Output().Usage(0x58);
  Ordinals(items);
  items.Fields(2, 2).Output().Close();
  items.Logical(-10000, 10000).Bounds(-10000, 10000).Usages(0x60, 0x61, 0x62);
  items.Fields(16, 3).Output();
  items.Logical(0, 10000).Bounds(0, 10000).Usages(0x63, 0x64, 0x65).Output().Close();

  items.Usage(0x6E).Open(HidItems::LogicalCollection).Id(Periodic);
  BlockIndex(items);
  items.Usage(0x70).Logical(0, 10000).Bounds(0, 10000).Fields(16, 1).Output();
  items.Usage(0x6F).Logical(-10000, 10000).Bounds(-10000, 10000).Output();
  items.Usage(0x71).Unit(0x14, 0xFE).Logical(0, 35999).Bounds(0, 35999).Output();
  items.Usage(0x72).Unit(0x1003, 0xFD).Logical(0, 32767).Bounds(0, 32767).Fields(32, 1).Output();
  items.Unit(0, 0).Close();

  items.Usage(0x73).Open(HidItems::LogicalCollection).Id(Constant);
  BlockIndex(items);
  items.Usage(0x70).Logical(-10000, 10000).Bounds(-10000, 10000).Fields(16, 1).Output().Close();
  items.Usage(0x74).Open(HidItems::LogicalCollection).Id(Ramp);
  BlockIndex(items);
  items.Usages(0x75, 0x76).Logical(-10000, 10000).Bounds(-10000, 10000).Fields(16, 2).Output();
  items.Close();

  items.Usage(0x68).Open(HidItems::LogicalCollection).Id(CustomData);
  BlockIndex(items);
  items.Usage(0x6C).Logical(0, 10000).Bounds(0, 10000).Fields(16, 1).Output();
  items.Usage(0x69).Logical(-127, 127).Bounds(0, 255).Fields(8, 12).Output().Close();
  items.Usage(0x66).Open(HidItems::LogicalCollection).Id(Sample).Page(0x01).Usages(0x30, 0x31);
  items.Logical(-127, 127).Bounds(0, 255).Fields(8, 1).Output().Close();
}

void DescribeFeatures(HidItems& items)
{
  items.Usage(0xAB).Open(HidItems::LogicalCollection).Id(CreateEffect);
  EffectTypes(items);
  items.Feature(HidItems::Array).Close();
  items.Page(0x01).Usage(0x3B).Logical(0, 511).Bounds(0, 511).Fields(10, 1).Feature();
  items.Fields(6, 1).Feature(HidItems::Padding).Close();
  items.Page(0x0F).Usage(0x89).Open(HidItems::LogicalCollection).Id(BlockLoad);
  items.Usage(0x22).Logical(1, 40).Bounds(1, 40).Fields(8, 1).Feature();
  items.Usage(0x8B).Open(HidItems::LogicalCollection).Usages(0x8C, 0x8D, 0x8E);
  items.Logical(1, 3).Bounds(1, 3).Feature(HidItems::Array).Close();
  items.Usage(0xAC).Logical(0, 65535).Bounds(0, 65535).Fields(16, 1).Feature(HidItems::Array);
  items.Close();
  items.Usage(0x7F).Open(HidItems::LogicalCollection).Id(Pool);
  items.Usage(0x80).Fields(16, 1).Feature();
  items.Usage(0x83).Logical(0, 255).Bounds(0, 255).Fields(8, 1).Feature();
  items.Usages(0xA9, 0xAA).Logical(0, 1).Bounds(0, 1).Fields(1, 2).Feature();
  items.Fields(6, 1).Feature(HidItems::Padding).Close();
}
} // namespace

std::vector<std::uint8_t> ArduinoFfbModel::GetReportDescriptor() const
{
  // The sketch's joystick has four buttons and the axes X, Y and Z. Its collection also contains
  // the force feedback reports.
  HidItems items;
  items.Page(0x01).Usage(0x08).Open(HidItems::ApplicationCollection).Usage(0x01).Id(Place);
  items.Open(HidItems::PhysicalCollection).Page(0x09).UsageRange(1, 4).Logical(0, 1).Fields(1, 4);
  items.Unit(0, 0).Input().Fields(1, 4).Input(HidItems::Padding);
  items.Page(0x01)
    .Usage(0x01)
    .Logical(-32767, 32767)
    .Fields(16, 3)
    .Open(HidItems::PhysicalCollection);
  items.Usages(0x30, 0x31, 0x32).Input().Close().Close();

  items.Page(0x0F).Usage(0x92).Open(HidItems::LogicalCollection).Id(Status);
  items.Usages(0x9F, 0xA0, 0xA4, 0xA5, 0xA6).Logical(0, 1).Bounds(0, 1).Fields(1, 5).Input();
  items.Fields(1, 3).Input(HidItems::Padding).Usage(0x94).Fields(1, 1).Input();
  items.Usage(0x22).Logical(1, 40).Bounds(1, 40).Fields(7, 1).Input().Close();
  DescribeSetEffect(items);
  DescribeOtherEffects(items);

  items.Page(0x0F).Usage(0x77).Open(HidItems::LogicalCollection).Id(Operation);
  BlockIndex(items);
  items.Usage(0x78).Open(HidItems::LogicalCollection).Usages(0x79, 0x7A, 0x7B);
  items.Logical(1, 3).Output(HidItems::Array).Close();
  items.Usage(0x7C).Logical(0, 255).Bounds(0, 255).Output().Close();
  items.Usage(0x90).Open(HidItems::LogicalCollection).Id(BlockFree);
  BlockIndex(items);
  items.Close();
  items.Usage(0x96).Open(HidItems::LogicalCollection).Id(DeviceControl);
  items.Usages(0x97, 0x98, 0x99, 0x9A, 0x9B, 0x9C).Logical(1, 6).Output(HidItems::Array).Close();
  items.Usage(0x7D).Open(HidItems::LogicalCollection).Id(DeviceGain);
  items.Usage(0x7E).Logical(0, 255).Bounds(0, 10000).Output().Close();
  items.Usage(0x6B).Open(HidItems::LogicalCollection).Id(Custom);
  BlockIndex(items);
  items.Usage(0x6D).Logical(0, 255).Bounds(0, 255).Output();
  items.Usage(0x51).Unit(0x1003, 0xFD).Logical(0, 32767).Bounds(0, 32767).Fields(16, 1).Output();
  items.Unit(0, 0).Close();
  DescribeFeatures(items);
  return items.Close().Get();
}

int ArduinoFfbModel::ReceiveOutput(const std::uint8_t* report, int size)
{
  if (report[0] == DeviceControl)
  {
    const int command = report[1];
    for (Effect& effect : this->Effects)
    {
      effect.IsPlaying = effect.IsPlaying && command != 3;
    }
    if (command == 4)
    {
      this->CountReset();
      this->Effects.fill({});
      this->NextFree = 1;
    }
    this->IsPaused = command == 5 || (this->IsPaused && command != 6);
    return size;
  }
  const int block = report[1];
  if (block < 1 || block > MaximumEffects)
  {
    return size; // refuses the block, because the board would write outside its array
  }
  Effect& effect = this->Effects[block];
  if (report[0] == SetEffect)
  {
    effect.Type = report[2];
    effect.Duration = Word(report + 3);
    effect.Gain = report[9];
    effect.Bits = report[11];
    effect.Directions[0] = report[12];
    effect.Directions[1] = report[13];
  }
  else if (report[0] == Constant)
  {
    effect.Magnitude = Word(report + 2);
  }
  else if (report[0] == Operation && report[2] == 3)
  {
    effect.IsPlaying = false;
  }
  else if (report[0] == Operation)
  {
    for (Effect& other : this->Effects)
    {
      other.IsPlaying = other.IsPlaying && report[2] != 2;
    }
    if (report[2] == 1)
    {
      effect.Duration = report[3] > 0 ? effect.Duration * report[3] & 0xFFFF : effect.Duration;
      effect.Duration = report[3] == 0xFF ? Infinite : effect.Duration;
    }
    // Change the state from Allocated to Playing, so that the block is freed when the effect stops.
    effect.IsPlaying = true;
    effect.IsAllocated = false;
    effect.Start = this->GetClock();
  }
  else if (report[0] == BlockFree)
  {
    effect = {};
    this->NextFree = std::min(this->NextFree, block);
  }
  return size;
}

int ArduinoFfbModel::ClaimFreeBlock()
{
  if (this->NextFree == MaximumEffects || this->IsFull())
  {
    return 0;
  }
  const int block = this->NextFree++;
  const auto isTaken = [this](const Effect& effect)
  { return effect.IsAllocated || effect.IsPlaying; };
  while (isTaken(this->Effects[this->NextFree]) && this->NextFree < MaximumEffects)
  {
    ++this->NextFree;
  }
  return block;
}

int ArduinoFfbModel::ReceiveFeature(const std::uint8_t* report, int size)
{
  if (report[0] != CreateEffect || size < 4)
  {
    return -EPIPE;
  }
  this->LoadId = BlockLoad;
  this->Loaded = this->ClaimFreeBlock();
  this->LoadStatus = this->Loaded == 0 ? 2 : 1;
  if (this->Loaded > 0)
  {
    this->Effects[this->Loaded] = {};
    this->Effects[this->Loaded].IsAllocated = true;
  }
  return size;
}

int ArduinoFfbModel::GiveFeature(std::uint8_t* report, int size)
{
  if (size < 5 || (report[0] != BlockLoad && report[0] != Pool))
  {
    return -EPIPE;
  }
  Bytes answer;
  if (report[0] == BlockLoad)
  {
    answer = { static_cast<std::uint8_t>(this->LoadId), static_cast<std::uint8_t>(this->Loaded),
      static_cast<std::uint8_t>(this->LoadStatus), 0xFF, 0x03 };
    this->LoadId = 0;
  }
  else
  {
    answer = { Pool, 0xFF, 0xFF, MaximumEffects, 3 };
  }
  std::copy(answer.begin(), answer.end(), report);
  return 5;
}

void ArduinoFfbModel::ForgetEffects()
{
  this->Effects.fill({});
  this->NextFree = 1;
  this->IsPaused = false;
}

bool ArduinoFfbModel::Acts(const Effect& effect) const
{
  const bool isOver =
    effect.Duration != Infinite && this->GetClock() - effect.Start > effect.Duration;
  return effect.IsPlaying && !isOver && !this->IsPaused;
}

int ArduinoFfbModel::CountAll(bool onlyPlaying) const
{
  int count = 0;
  for (const Effect& effect : this->Effects)
  {
    count += (onlyPlaying ? this->Acts(effect) : effect.IsAllocated || effect.IsPlaying) ? 1 : 0;
  }
  return count;
}

std::array<double, 2> ArduinoFfbModel::ComputeTorques() const
{
  std::array<double, 2> parts{};
  for (int axis = 0; axis < 2; ++axis)
  {
    int sum = 0;
    for (int block = 0; block < MaximumEffects; ++block)
    {
      const Effect& effect = this->Effects[block];
      if (this->Acts(effect) && effect.Type == ConstantForce)
      {
        const int direction = effect.Directions[effect.Bits == DirectionEnable ? 0 : axis];
        const double angle = direction * 360.0 / 255.0 * 3.14159265359 / 180.0;
        const double share = axis == 0 ? std::sin(angle) : -std::cos(angle);
        const int scaled = effect.Magnitude * effect.Gain / 255;
        const int force = Divide(scaled * effect.Magnitude, scaled);
        sum += static_cast<int>(force * FullGain * share);
      }
    }
    const int force = static_cast<int>(static_cast<float>(sum) * FullGain / 10000.0F);
    const int mapped = (force + FullMagnitude) * (2 * FullForce) / (2 * FullMagnitude) - FullForce;
    parts[axis] = static_cast<double>(mapped) / FullForce;
  }
  return parts;
}

FfbHandle::Bytes ArduinoFfbModel::BuildReport(double x, double y) const
{
  Bytes report{ Place, static_cast<std::uint8_t>(this->Buttons & 0x0F) };
  Append(report, static_cast<int>(std::lround(32767.0 * x)));
  Append(report, static_cast<int>(std::lround(32767.0 * y)));
  Append(report, 0);
  return report;
}

} // namespace emulated
