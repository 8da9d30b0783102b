// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Pid/PidDialogue.h"

#include <algorithm>
#include <utility>

namespace VolumeHaptics
{
namespace
{
// Limit the time for which a device continues without its host to 50 to 100 ms, whatever the
// setting is.
PidSettings Bounded(PidSettings settings)
{
  constexpr double shortest = 0.05;
  constexpr double longest = 0.1;
  settings.Duration = std::min(longest, std::max(shortest, settings.Duration));
  return settings;
}
} // namespace

PidDialogue::PidDialogue(const PidDevice& device, const PidSettings& settings)
  : Device(device)
  , Settings(Bounded(settings))
{
}

PidStep PidDialogue::GetStep(HidReport& report) const
{
  const std::int64_t block = this->Blocks[this->Effect];
  switch (this->Now)
  {
    case Stage::FirstReset:
    case Stage::SecondReset:
      report = this->Device.Control(PidUsage::DeviceReset);
      return PidStep::Send;
    case Stage::StopAll:
      report = this->Device.Control(PidUsage::StopAllEffects);
      return PidStep::Send;
    case Stage::Enable:
      report = this->Device.Control(PidUsage::EnableActuators);
      return PidStep::Send;
    case Stage::Pool:
      report = this->Device.AskPool();
      return PidStep::Fetch;
    case Stage::Gain:
      report = this->Device.FullGain();
      return PidStep::Send;
    case Stage::Create:
      report = this->Device.CreateConstant();
      return PidStep::Send;
    case Stage::BlockLoad:
      report = this->Device.AskBlockLoad();
      return PidStep::Fetch;
    case Stage::CentreOff:
      report = this->Device.Operate(this->Device.GetFirstBlock(), PidUsage::EffectStop);
      return PidStep::Send;
    case Stage::SetEffect:
      report = this->Device.SetEffect(block, this->Effect, this->Settings.Duration);
      return PidStep::Send;
    case Stage::NoForce:
      report = this->Device.SetConstant(block, this->Effect, 0.0, 1.0);
      return PidStep::Send;
    case Stage::Start:
      report = this->Device.Operate(block, PidUsage::EffectStart);
      return PidStep::Send;
    case Stage::Ready:
      return PidStep::Ready;
    default:
      return PidStep::Failed;
  }
}

void PidDialogue::Sent(bool went)
{
  if (this->Now >= Stage::Ready || this->Now == Stage::Pool || this->Now == Stage::BlockLoad)
  {
    return;
  }
  if (!went)
  {
    this->Fail("The device does not accept force-feedback reports");
    return;
  }
  this->Advance();
}

void PidDialogue::Fetched(const std::uint8_t* payload, std::size_t size)
{
  if (this->Now == Stage::Pool)
  {
    const int effects = this->Device.ReadPool(payload, size);
    if (effects < this->Device.GetNumberOfEffects() && this->Device.HasPoolSize() &&
      ++this->Polls < PidDialogue::MaximumPoolPolls)
    {
      return;
    }
    this->Polls = 0;
    if (effects > 0 && effects < this->Device.GetNumberOfEffects())
    {
      this->Fail("The device plays fewer effects at a time than its axes need");
      return;
    }
    this->Advance();
    return;
  }
  if (this->Now != Stage::BlockLoad)
  {
    return;
  }
  switch (this->Device.ReadBlockLoad(payload, size, this->Blocks[this->Effect]))
  {
    case BlockLoadStatus::Success:
      this->Advance();
      return;
    case BlockLoadStatus::Full:
      this->Fail("The device has no room for another effect");
      return;
    case BlockLoadStatus::Error:
      this->Fail("The device can't make a constant force");
      return;
    default:
      if (++this->Polls >= PidDialogue::MaximumPolls)
      {
        this->Fail("The device does not say whether it has made the effect");
      }
  }
}

void PidDialogue::Advance()
{
  if (this->Now == Stage::Start && this->Effect + 1 < this->Device.GetNumberOfEffects())
  {
    ++this->Effect;
    this->Polls = 0;
    this->Now = Stage::Create;
    return;
  }
  this->Now = static_cast<Stage>(static_cast<int>(this->Now) + 1);
  // The second effect can't reveal a centring spring: its block follows the block of the first
  // effect.
  const bool hasCentre = this->Effect == 0 && this->Blocks[0] == this->Device.GetFirstBlock() + 1;
  if (this->Now == Stage::CentreOff && !hasCentre)
  {
    this->Now = Stage::SetEffect;
  }
  if (this->Now == Stage::Pool && !this->Device.HasPool())
  {
    this->Now = Stage::Gain;
  }
  if (this->Now == Stage::Gain && !this->Device.HasDeviceGain())
  {
    this->Now = Stage::Create;
  }
}

void PidDialogue::Fail(std::string error)
{
  this->Now = Stage::Failed;
  this->Error = std::move(error);
}

PidStream::PidStream(
  const PidDevice& device, const PidSettings& settings, const PidDialogue& dialogue)
  : Device(device)
  , Settings(Bounded(settings))
  , Blocks(dialogue.GetBlocks())
{
  for (int effect = 0; effect < PidDevice::MostEffects; ++effect)
  {
    this->Last[effect] = device.SetConstant(this->Blocks[effect], effect, 0.0, 1.0).Bytes;
  }
}

bool PidStream::Next(double elapsed, const std::array<double, 2>& force, HidReport& report) noexcept
{
  const int effects = this->Device.GetNumberOfEffects();
  for (double& age : this->Ages)
  {
    age += elapsed;
  }
  this->Silence += elapsed;
  const bool isSignDue = this->Silence >= SignTime;
  // Restart the effect twice within its duration, so that one report may be late.
  const double due = 0.5 * this->Settings.Duration;
  for (int effect = 0; effect < effects; ++effect)
  {
    if (this->Ages[effect] >= due)
    {
      this->Ages[effect] = this->Silence = 0.0;
      report = this->Device.Operate(this->Blocks[effect], PidUsage::EffectStart);
      return true;
    }
  }
  for (int i = 0; i < effects; ++i)
  {
    const int effect = (this->Turn + i) % effects;
    const int axis = this->Device.GetAxis(effect);
    const HidReport magnitude = this->Device.SetConstant(
      this->Blocks[effect], effect, force[axis], this->Settings.NewtonsPerFullScale[axis]);
    if (magnitude.Bytes != this->Last[effect] || isSignDue)
    {
      this->Silence = 0.0;
      this->Last[effect] = magnitude.Bytes;
      this->Turn = (effect + 1) % effects;
      report = magnitude;
      return true;
    }
  }
  return false;
}

} // namespace VolumeHaptics
