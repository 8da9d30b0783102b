// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StickModel.h"

#include <algorithm>
#include <cerrno>
#include <cmath>

namespace emulated
{
namespace
{
/** As the descriptor numbers them. */
enum ReportId : std::uint8_t
{
  Place = 1,
  SetEffect = 2,
  SetConstant = 5,
  EffectOperation = 10,
  DeviceControl = 12,
  DeviceGain = 13,
  CreateEffect = 17,
  BlockLoad = 18,
  Pool = 19
};
constexpr int MostEffects = 4;
constexpr int PollsUntilLoaded = 3;

int Word(const std::uint8_t* bytes)
{
  return static_cast<std::int16_t>(bytes[0] | bytes[1] << 8);
}
} // namespace

std::vector<std::uint8_t> StickModel::GetReportDescriptor() const
{
  // A wheel has its pedal in the place of a stick's y, and no motor there.
  const bool isStick = this->Axes > 1;
  const std::uint8_t second = isStick ? 0x31 : 0x32;
  // Two bits that are constant take the place of the two that would enable the axes.
  const std::vector<std::uint8_t> axes = isStick && !this->HasAxisBits
    ? std::vector<std::uint8_t>{ 0x25, 0x01, 0x75, 0x01, 0x95, 0x02, 0x91, 0x03, 0xC0, 0x05, 0x0F,
        0x09, 0x56, 0x95, 0x01, 0x91, 0x02, 0x95, 0x05, 0x91, 0x03 }
    : isStick
    ? std::vector<std::uint8_t>{ 0x09, 0x30, 0x09, 0x31, 0x25, 0x01, 0x75, 0x01, 0x95, 0x02, 0x91,
        0x02, 0xC0, 0x05, 0x0F, 0x09, 0x56, 0x95, 0x01, 0x91, 0x02, 0x95, 0x05, 0x91, 0x03 }
    : std::vector<std::uint8_t>{ 0x09, 0x30, 0x25, 0x01, 0x75, 0x01, 0x95, 0x01, 0x91, 0x02, 0xC0,
        0x05, 0x0F, 0x09, 0x56, 0x95, 0x01, 0x91, 0x02, 0x95, 0x06, 0x91, 0x03 };
  std::vector<std::uint8_t> all{ 0x05, 0x01, 0x09, 0x04, 0xA1, 0x01, // a joystick
    // 1: eight buttons; x, y of -32767 to 32767
    0x85, 0x01, 0x05, 0x09, 0x19, 0x01, 0x29, 0x08, 0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x08,
    0x81, 0x02, 0x05, 0x01, 0x09, 0x30, 0x09, second, 0x16, 0x01, 0x80, 0x26, 0xFF, 0x7F, 0x75,
    0x10, 0x95, 0x02, 0x81, 0x02,
    // 2, Set Effect: the block of 40; constant, ramp or spring; ms; gain; x, y, direction; two
    // angles
    0x05, 0x0F, 0x09, 0x21, 0xA1, 0x02, 0x85, 0x02, 0x09, 0x22, 0x15, 0x01, 0x25, 0x28, 0x75, 0x08,
    0x95, 0x01, 0x91, 0x02, 0x09, 0x25, 0xA1, 0x02, 0x09, 0x26, 0x09, 0x27, 0x09, 0x40, 0x15, 0x01,
    0x25, 0x03, 0x91, 0x00, 0xC0, 0x09, 0x50, 0x15, 0x00, 0x26, 0xFF, 0x7F, 0x35, 0x00, 0x46, 0xFF,
    0x7F, 0x66, 0x01, 0x10, 0x55, 0x0D, 0x75, 0x10, 0x91, 0x02, 0x45, 0x00, 0x65, 0x00, 0x55, 0x00,
    0x09, 0x52, 0x26, 0xFF, 0x00, 0x75, 0x08, 0x91, 0x02, 0x09, 0x55, 0xA1, 0x02, 0x05, 0x01 };
  all.insert(all.end(), axes.begin(), axes.end());
  const std::vector<std::uint8_t> others{ 0x09, 0x57, 0xA1, 0x02, 0x0B, 0x01, 0x00, 0x0A, 0x00,
    0x0B, 0x02, 0x00, 0x0A, 0x00, 0x26, 0xFF, 0x00, 0x75, 0x08, 0x95, 0x02, 0x91, 0x02, 0xC0, 0xC0,
    // 5, Set Constant Force: the block; -10000 to 10000
    0x09, 0x73, 0xA1, 0x02, 0x85, 0x05, 0x09, 0x22, 0x15, 0x01, 0x25, 0x28, 0x95, 0x01, 0x91, 0x02,
    0x09, 0x70, 0x16, 0xF0, 0xD8, 0x26, 0x10, 0x27, 0x75, 0x10, 0x91, 0x02, 0xC0,
    // 10, Effect Operation: the block; start, start alone or stop; how often
    0x09, 0x77, 0xA1, 0x02, 0x85, 0x0A, 0x09, 0x22, 0x15, 0x01, 0x25, 0x28, 0x75, 0x08, 0x91, 0x02,
    0x09, 0x78, 0xA1, 0x02, 0x09, 0x79, 0x09, 0x7A, 0x09, 0x7B, 0x25, 0x03, 0x91, 0x00, 0xC0, 0x09,
    0x7C, 0x15, 0x00, 0x26, 0xFF, 0x00, 0x91, 0x02, 0xC0,
    // 12, Device Control: enable, disable, stop all, reset, pause, go on
    0x09, 0x95, 0xA1, 0x02, 0x85, 0x0C, 0x09, 0x96, 0xA1, 0x02, 0x09, 0x97, 0x09, 0x98, 0x09, 0x99,
    0x09, 0x9A, 0x09, 0x9B, 0x09, 0x9C, 0x15, 0x01, 0x25, 0x06, 0x91, 0x00, 0xC0, 0xC0,
    // 13, Device Gain
    0x09, 0x7D, 0xA1, 0x02, 0x85, 0x0D, 0x09, 0x7E, 0x15, 0x00, 0x26, 0xFF, 0x00, 0x91, 0x02, 0xC0,
    // 17, Create New Effect: the type; bytes more
    0x09, 0xAB, 0xA1, 0x02, 0x85, 0x11, 0x09, 0x25, 0xA1, 0x02, 0x09, 0x26, 0x09, 0x27, 0x09, 0x40,
    0x15, 0x01, 0x25, 0x03, 0xB1, 0x00, 0xC0, 0x05, 0x01, 0x09, 0x3B, 0x15, 0x00, 0x26, 0xFF, 0x01,
    0x75, 0x10, 0xB1, 0x02, 0xC0,
    // 18, Block Load: the block; success, full or error; bytes left
    0x05, 0x0F, 0x09, 0x89, 0xA1, 0x02, 0x85, 0x12, 0x09, 0x22, 0x15, 0x01, 0x25, 0x28, 0x75, 0x08,
    0xB1, 0x02, 0x09, 0x8B, 0xA1, 0x02, 0x09, 0x8C, 0x09, 0x8D, 0x09, 0x8E, 0x25, 0x03, 0xB1, 0x00,
    0xC0, 0x09, 0xAC, 0x15, 0x00, 0x27, 0xFF, 0xFF, 0x00, 0x00, 0x75, 0x10, 0xB1, 0x02, 0xC0,
    // 19, Pool: bytes; effects that play at a time
    0x09, 0x7F, 0xA1, 0x02, 0x85, 0x13, 0x09, 0x80, 0xB1, 0x02, 0x09, 0x83, 0x26, 0xFF, 0x00, 0x75,
    0x08, 0xB1, 0x02, 0xC0, 0xC0 };
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

int StickModel::Output(const std::uint8_t* report, int size)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  if (this->Fault == StickFault::WriteError)
  {
    return -EIO;
  }
  this->Last[report[0]].assign(report, report + size);
  const auto effect = this->Effects.find(report[1]);
  const bool isThere = effect != this->Effects.end();
  if (report[0] == SetEffect && size == 9 && isThere && report[2] == 1)
  {
    effect->second.Duration = Word(report + 3);
    const auto degrees = [report](int angle) { return report[7 + angle] * 360.0 / 255.0; };
    const double direction = degrees(0) * 3.141592653589793 / 180.0;
    double(&shares)[2] = effect->second.Shares;
    if ((report[6] >> this->Axes & 1) != 0) // Direction Enable
    {
      shares[0] = std::sin(direction);
      shares[1] = -std::cos(direction);
    }
    else
    {
      shares[0] = (report[6] & 1) != 0 ? (degrees(0) - 180.0) / 180.0 : 0.0;
      shares[1] = this->Axes > 1 && (report[6] & 2) != 0 ? -(degrees(1) - 180.0) / 180.0 : 0.0;
    }
  }
  else if (report[0] == SetConstant && size == 4 && isThere)
  {
    effect->second.Magnitude = Word(report + 2);
  }
  else if (report[0] == EffectOperation && size == 4 && isThere)
  {
    effect->second.Left = report[2] == 1 ? effect->second.Duration * report[3] : 0;
  }
  else if (report[0] == DeviceGain && size == 2)
  {
    this->Gain = report[1];
  }
  else if (report[0] == DeviceControl && size == 2)
  {
    this->IsEnabled = report[1] == 1 || (this->IsEnabled && report[1] != 2 && report[1] != 4);
    for (auto& playing : this->Effects)
    {
      playing.second.Left = report[1] == 3 ? 0 : playing.second.Left;
    }
    if (report[1] == 4)
    {
      ++this->Resets;
      this->Effects.clear();
    }
  }
  else
  {
    return -EPIPE;
  }
  return size;
}

int StickModel::SetFeature(const std::uint8_t* report, int size)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  if (report[0] != CreateEffect || size != 4 || report[1] != 1)
  {
    return -EPIPE;
  }
  this->Polls = 0;
  this->Loaded = 0;
  for (int block = 1; block <= MostEffects && this->Loaded == 0; ++block)
  {
    this->Loaded = this->Effects.count(block) == 0 ? block : 0;
  }
  if (this->Fault == StickFault::FullPool)
  {
    this->Loaded = 0;
  }
  if (this->Loaded > 0)
  {
    this->Effects[this->Loaded] = {};
  }
  return size;
}

int StickModel::GetFeature(std::uint8_t* report, int size)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  if (report[0] == Pool && size >= 4)
  {
    report[1] = 0x00;
    report[2] = 0x10;
    report[3] = MostEffects;
    return 4;
  }
  if (report[0] == BlockLoad && size >= 5)
  {
    const bool isDone = ++this->Polls >= PollsUntilLoaded && this->Fault != StickFault::NoBlockLoad;
    report[1] = static_cast<std::uint8_t>(isDone ? this->Loaded : 0);
    report[2] = isDone ? (this->Loaded > 0 ? 1 : 2) : 0;
    report[3] = report[4] = 0;
    return 5;
  }
  return -EPIPE;
}

Triple StickModel::Push() const
{
  Triple push{};
  for (const auto& [block, effect] : this->Effects)
  {
    const bool acts = this->IsEnabled && effect.Left > 0;
    const double newtons = acts ? FullScale * effect.Magnitude / 10000.0 * this->Gain / 255.0 : 0.0;
    push[0] -= newtons * effect.Shares[0];
    // HID's y points to the hand.
    push[1] += this->Axes > 1 ? newtons * effect.Shares[1] : 0.0;
  }
  return push;
}

void StickModel::Step()
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->Hand.Step(1e-3, this->Push());
  for (auto& playing : this->Effects)
  {
    playing.second.Left = std::max(0, playing.second.Left - 1);
  }
  this->Report();
}

void StickModel::Report()
{
  const StickFault fault = this->Fault;
  const auto counts = [](double part)
  { return static_cast<int>(std::lround(32767.0 * std::clamp(part / Travel, -1.0, 1.0))); };
  int x = counts(this->Hand.Tip[0]);
  int y = -counts(this->Hand.Tip[1]);
  if (fault == StickFault::Garbage)
  {
    this->Noise = this->Noise * 1664525U + 1013904223U;
    x = static_cast<std::int16_t>(this->Noise >> 8);
    y = static_cast<std::int16_t>(this->Noise >> 16);
  }
  const auto byte = [](int word) { return static_cast<std::uint8_t>(word & 0xFF); };
  const std::vector<std::uint8_t> report{ Place, byte(this->Buttons), byte(x), byte(x >> 8),
    byte(y), byte(y >> 8) };
  if (fault == StickFault::ShortReport)
  {
    this->Input(report.data(), 3);
  }
  else if (fault != StickFault::Silence && (this->Streams || report != this->Sent))
  {
    this->Input(report.data(), static_cast<int>(report.size()));
    this->Sent = report;
  }
}

void StickModel::PowerUp()
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->Effects.clear();
  this->IsEnabled = false;
  this->Hand.Place({});
  this->Fault = StickFault::None;
}

void StickModel::SetGoal(double right, double away)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->Hand.Goal = { right, away, 0.0 };
}

Triple StickModel::GetTip() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Hand.Tip;
}

Triple StickModel::GetForce() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Push();
}

int StickModel::CountPlaying() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return static_cast<int>(std::count_if(this->Effects.begin(), this->Effects.end(),
    [](const auto& effect) { return effect.second.Left > 0; }));
}

int StickModel::CountEffects() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return static_cast<int>(this->Effects.size());
}

std::vector<std::uint8_t> StickModel::GetLast(std::uint8_t id) const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  const auto last = this->Last.find(id);
  return last == this->Last.end() ? std::vector<std::uint8_t>() : last->second;
}

} // namespace emulated
