// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OpenFfboardModel.h"

#include <cerrno>

namespace emulated
{
namespace
{
/** Numbers of reports, as in ffb_defs.h. Input and output reports have the same numbers. */
enum ReportId : std::uint8_t
{
  Place = 0x01,
  Status = 0x02,
  SetEffectReport = 0x01,
  Envelope = 0x02,
  Condition = 0x03,
  Periodic = 0x04,
  Constant = 0x05,
  Ramp = 0x06,
  Operation = 0x0A,
  BlockFree = 0x0B,
  DeviceControl = 0x0C,
  DeviceGain = 0x0D,
  CreateEffect = 0x11,
  BlockLoad = 0x12,
  Pool = 0x13,
  Command = 0xA1
};
constexpr int ConstantForce = 1;
constexpr int EffectSize = 152; ///< bytes; no driver depends on this number

void BlockIndex(HidItems& items)
{
  items.Usage(0x22).Logical(1, 40).Bounds(1, 40).Fields(8, 1).Output();
}

void EffectTypes(HidItems& items)
{
  items.Usage(0x25).Open(HidItems::LogicalCollection);
  items.Usages(0x26, 0x27, 0x30, 0x31, 0x32, 0x33, 0x34, 0x40, 0x41, 0x42, 0x43);
  items.Logical(1, 11).Bounds(1, 11).Fields(8, 1);
}

/**
 * Describes the vendor's reports for the board's settings, in both directions. Each contains a
 * value and an address of 64 bits each.
 */
void DescribeCommands(HidItems& items)
{
  items.Page(0xFF00).Usage(0x00).Open(HidItems::ApplicationCollection).Id(Command);
  for (const bool isOutput : { true, false })
  {
    constexpr unsigned sizes[] = { 8, 16, 8, 32, 64, 64 };
    for (unsigned f = 0; f < 6; ++f)
    {
      items.Usage(f + 1).Logical(0, 4).Fields(sizes[f], 1);
      isOutput ? items.Output() : items.Input();
    }
  }
  items.Close();
}
} // namespace

void OpenFfboardModel::DescribeSetEffect(HidItems& items) const
{
  const bool isOne = this->Model == Kind::OneAxisWheel;
  items.Usage(0x21).Open(HidItems::LogicalCollection).Id(SetEffectReport);
  BlockIndex(items);
  EffectTypes(items);
  items.Output(HidItems::Array).Close();
  items.Usages(0x50, 0x54, 0x51, 0xA7).Logical(0, 32767).Bounds(0, 32767);
  items.Unit(0x1003, 0xFD).Fields(16, 4).Output().Unit(0, 0);
  items.Usage(0x52).Logical(0, 255).Bounds(0, 10000).Fields(8, 1).Output();
  items.Usage(0x53).Logical(1, 8).Bounds(1, 8).Fields(8, 1).Output();
  items.Usage(0x55).Open(HidItems::LogicalCollection).Page(0x01).Usage(0x30);
  if (isOne)
  {
    items.Logical(0, 0).Fields(1, 1).Output().Close();
  }
  else
  {
    items.Usage(0x31).Logical(0, 1).Fields(1, 2).Output().Close();
  }
  items.Page(0x0F).Usage(0x56).Fields(1, 1).Output();
  items.Fields(1, isOne ? 6 : 5).Output(HidItems::Padding);
  const auto ordinals = [&items](bool isTwo)
  {
    items.Open(HidItems::LogicalCollection).Usage(0x000A0001);
    if (isTwo)
    {
      items.Usage(0x000A0002);
    }
  };
  items.Usage(0x57);
  ordinals(this->HasTwoDirections());
  items.Unit(0, 0xFE).Logical(0, 36000).Bounds(0, 36000);
  items.Fields(16, this->HasTwoDirections() ? 2 : 1).Output().Unit(0, 0).Close();
  items.Page(0x0F).Usage(0x58);
  ordinals(!isOne);
  items.Logical(0, 32765).Fields(16, isOne ? 1 : 2).Output().Close();
  items.Close();
}

void OpenFfboardModel::DescribeCondition(HidItems& items) const
{
  const unsigned axes = this->Model == Kind::OneAxisWheel ? 1 : 2;
  items.Usage(0x5F).Open(HidItems::LogicalCollection).Id(Condition);
  BlockIndex(items);
  items.Usage(0x23).Logical(0, 3).Bounds(0, 3).Fields(8 - 2 * axes, 1).Output();
  items.Usage(0x58).Open(HidItems::LogicalCollection).Usage(0x000A0001);
  if (axes == 2)
  {
    items.Usage(0x000A0002);
  }
  items.Fields(2, axes).Output().Close();
  items.Logical(-32768, 32767).Bounds(-32768, 32767);
  items.Usages(0x60, 0x61, 0x62).Fields(16, 3).Output();
  items.Logical(0, 32767).Bounds(0, 32767).Usages(0x63, 0x64, 0x65).Output().Close();
}

std::vector<std::uint8_t> OpenFfboardModel::GetReportDescriptor() const
{
  HidItems items;
  items.Page(0x01).Usage(0x04).Open(HidItems::ApplicationCollection);
  items.Open(HidItems::PhysicalCollection).Id(Place).Page(0x09).UsageRange(1, 64);
  items.Logical(0, 1).Fields(1, 64).Input().Page(0x01);
  items.Usages(0x30, 0x31, 0x32, 0x33, 0x34, 0x35, 0x37, 0x36);
  items.Logical(-32767, 32767).Fields(16, 8).Input().Close();
  DescribeCommands(items);

  items.Page(0x0F).Usage(0x92).Open(HidItems::LogicalCollection).Id(Status);
  items.Usages(0x9F, 0xA0, 0xA4, 0xA6, 0x94).Logical(0, 1).Bounds(0, 1).Fields(1, 5).Input();
  items.Fields(1, 3).Input(HidItems::Padding).Close();
  this->DescribeSetEffect(items);

  items.Usage(0x5A).Open(HidItems::LogicalCollection).Id(Envelope);
  BlockIndex(items);
  items.Usages(0x5B, 0x5D).Logical(0, 32767).Bounds(0, 32767).Fields(16, 2).Output();
  items.Usages(0x5C, 0x5E).Unit(0x1003, 0xFD).Fields(32, 2).Output().Unit(0, 0).Close();
  this->DescribeCondition(items);

  items.Usage(0x6E).Open(HidItems::LogicalCollection).Id(Periodic);
  BlockIndex(items);
  items.Usage(0x70).Logical(0, 32767).Bounds(0, 32767).Fields(16, 1).Output();
  items.Usage(0x6F).Logical(-32768, 32767).Bounds(-32768, 32767).Output();
  items.Usage(0x71).Unit(0x14, 0xFE).Logical(0, 35999).Bounds(0, 35999).Output();
  items.Usage(0x72).Logical(1, 32767).Bounds(1, 32767).Unit(0x1003, 0xFD).Fields(32, 1).Output();
  items.Unit(0, 0).Close();

  items.Usage(0x73).Open(HidItems::LogicalCollection).Id(Constant);
  BlockIndex(items);
  items.Usage(0x70).Logical(-32767, 32767).Bounds(-32767, 32767).Fields(16, 1).Output().Close();
  items.Usage(0x74).Open(HidItems::LogicalCollection).Id(Ramp);
  BlockIndex(items);
  items.Usages(0x75, 0x76).Logical(-32768, 32767).Bounds(-32768, 32767).Fields(16, 2).Output();
  items.Close();

  items.Usage(0x77).Open(HidItems::LogicalCollection).Id(Operation);
  BlockIndex(items);
  items.Usage(0x78).Open(HidItems::LogicalCollection).Usages(0x79, 0x7A, 0x7B);
  items.Logical(1, 3).Fields(8, 1).Output(HidItems::Array).Close();
  items.Usage(0x7C).Logical(0, 255).Bounds(0, 255).Output().Close();
  items.Usage(0x90).Open(HidItems::LogicalCollection).Id(BlockFree);
  BlockIndex(items);
  items.Close();

  // Device Control has eight fields of one bit each, with logical values from 1 to 6.
  items.Usage(0x95)
    .Open(HidItems::LogicalCollection)
    .Id(DeviceControl)
    .Usage(0x96)
    .Open(HidItems::LogicalCollection);
  items.Usages(0x97, 0x98, 0x99, 0x9A, 0x9B, 0x9C).Logical(1, 6).Fields(1, 8).Output();
  items.Close().Close();
  items.Usage(0x7D).Open(HidItems::LogicalCollection).Id(DeviceGain);
  items.Usage(0x7E).Logical(0, 255).Bounds(0, 10000).Fields(8, 1).Output().Close();

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
  return items.Close().Get();
}

int OpenFfboardModel::ReceiveOutput(const std::uint8_t* report, int size)
{
  const int index = report[1];
  const bool isEffect = index >= 1 && index <= MaximumEffects;
  Effect* const effect = isEffect ? &this->Effects[index - 1] : nullptr;
  switch (report[0])
  {
    case SetEffectReport:
      if (effect)
      {
        this->SetEffect(report, size);
      }
      break;
    case Constant:
      if (effect)
      {
        effect->Magnitude = Word(report + 2);
      }
      break;
    case Operation:
      if (effect && report[2] == 2)
      {
        for (Effect& other : this->Effects)
        {
          other.IsActive = false;
        }
      }
      if (effect)
      {
        effect->IsActive = report[2] != 3;
        effect->Start = effect->IsActive ? this->GetClock() + effect->Delay : effect->Start;
      }
      break;
    case BlockFree:
      if (effect)
      {
        *effect = {};
      }
      break;
    case DeviceControl:
      this->Control(report[1]);
      break;
    case DeviceGain:
      this->Gain = report[1];
      break;
    default:
      break;
  }
  return size;
}

void OpenFfboardModel::SetEffect(const std::uint8_t* report, int size)
{
  Effect& effect = this->Effects[report[1] - 1];
  effect.Type = report[2];
  effect.Duration = Word(report + 3) == 0 ? Infinite : Word(report + 3) & 0xFFFF;
  effect.Delay = Word(report + 9);
  effect.Gain = report[11];
  int bits = report[13];
  const double x = Word(report + 14) & 0xFFFF;
  const double y = size >= 18 ? Word(report + 16) & 0xFFFF : 0.0;
  const double angle = x / 36000.0 * 6.283185307179586;
  const int directionBit = this->Model == Kind::Joystick ? 1 << 2 : 0x04;
  const bool isNew = this->Release == Version::V1_17_1;
  if (!isNew && this->Model != Kind::Joystick)
  {
    bits = 1;
  }
  const bool hasDirection = (bits & directionBit) != 0;
  const bool isX = (bits & 1) != 0;
  const bool isY = (bits & 2) != 0;
  if (isNew)
  {
    effect.Shares[0] = hasDirection ? std::sin(angle) : isX ? (x - 18000.0) / 18000.0 : 0.0;
    effect.Shares[1] = hasDirection ? -std::cos(angle) : isY ? -(y - 18000.0) / 18000.0 : 0.0;
  }
  else if (this->Model == Kind::Joystick)
  {
    effect.Shares[0] = hasDirection ? std::sin(angle) : isX ? 1.0 : 0.0;
    effect.Shares[1] = hasDirection ? std::cos(angle) : isY ? 1.0 : 0.0;
  }
  else
  {
    effect.Shares[0] = hasDirection || isX ? std::sin(angle) : 0.0;
  }
  this->IsActive = true;
  this->SendStatus();
}

void OpenFfboardModel::Control(int bits)
{
  this->IsActive = this->IsActive || (bits & 0x01) != 0;
  if ((bits & (0x02 | 0x04 | 0x08 | 0x10)) != 0)
  {
    this->IsActive = false;
  }
  if ((bits & 0x08) != 0)
  {
    this->CountReset();
    this->Effects.fill({});
  }
  this->IsActive = this->IsActive || (bits & 0x20) != 0;
}

void OpenFfboardModel::SendStatus()
{
  const std::uint8_t report[2] = { Status,
    static_cast<std::uint8_t>(0x08 | (this->IsActive ? 0x12 : 0x01)) };
  this->Input(report, 2);
}

int OpenFfboardModel::ReceiveFeature(const std::uint8_t* report, int size)
{
  if (report[0] != CreateEffect || size < 4)
  {
    return -EPIPE;
  }
  int free = 0;
  while (free < MaximumEffects && this->Effects[free].Type != 0)
  {
    ++free;
  }
  if (free == MaximumEffects || this->IsFull())
  {
    this->LoadStatus = 2;
    return size;
  }
  this->Effects[free] = {};
  this->Effects[free].Type = report[1];
  this->Loaded = free + 1;
  this->LoadStatus = 1;
  this->SendStatus();
  return size;
}

int OpenFfboardModel::GiveFeature(std::uint8_t* report, int size)
{
  if (size < 5 || (report[0] != BlockLoad && report[0] != Pool))
  {
    return -EPIPE;
  }
  const bool isPool = report[0] == Pool;
  const int used = this->CountAll(false);
  const int bytes = (isPool ? MaximumEffects : MaximumEffects - used) * EffectSize;
  Bytes answer;
  if (isPool)
  {
    Append(answer, bytes);
    answer.push_back(MaximumEffects);
    answer.push_back(1);
  }
  else
  {
    answer = { static_cast<std::uint8_t>(this->Loaded),
      static_cast<std::uint8_t>(this->LoadStatus) };
    Append(answer, bytes);
  }
  std::copy(answer.begin(), answer.end(), report + 1);
  return 5;
}

void OpenFfboardModel::ForgetEffects()
{
  this->Effects.fill({});
  this->IsActive = false;
  this->Gain = 255;
}

bool OpenFfboardModel::IsPlaying(const Effect& effect) const
{
  const int elapsed = this->GetClock() - effect.Start;
  const bool isTimed = effect.Duration != Infinite;
  return effect.IsActive && (!isTimed || (elapsed >= 0 && elapsed <= effect.Duration));
}

int OpenFfboardModel::CountAll(bool onlyPlaying) const
{
  int count = 0;
  for (const Effect& effect : this->Effects)
  {
    count += (onlyPlaying ? this->IsPlaying(effect) : effect.Type != 0) ? 1 : 0;
  }
  return count;
}

std::array<double, 2> OpenFfboardModel::ComputeTorques() const
{
  std::array<int, 2> sums{};
  for (const Effect& effect : this->Effects)
  {
    const bool acts = this->IsActive && this->IsPlaying(effect) && effect.Type == ConstantForce;
    const int force = acts ? effect.Magnitude * effect.Gain / 255 : 0;
    for (int axis = 0; axis < 2; ++axis)
    {
      sums[axis] += static_cast<int>(-force * effect.Shares[axis]) * this->Gain / 255;
    }
  }
  const auto part = [](int sum) { return std::clamp(sum, -0x7FFF, 0x7FFF) / 32767.0; };
  return { part(sums[0]), part(sums[1]) };
}

FfbHandle::Bytes OpenFfboardModel::BuildReport(double x, double y) const
{
  Bytes report{ Place, static_cast<std::uint8_t>(this->Buttons) };
  report.resize(9); // 64 buttons
  const double second = this->Model == Kind::Joystick ? y : this->Pedal.load();
  Append(report, static_cast<int>(std::lround(32767.0 * x)));
  Append(report, static_cast<int>(std::lround(32767.0 * second)));
  report.resize(25); // six more axes
  return report;
}

} // namespace emulated
