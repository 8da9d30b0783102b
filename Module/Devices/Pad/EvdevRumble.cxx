// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Pad/EvdevRumble.h"

#include "Core/Realtime/ServoClock.h"
#include "Devices/Transport/Evdev/EvdevNode.h"

#include <linux/input.h>

#include <cerrno>

#include <sys/ioctl.h>

namespace VolumeHaptics
{

bool EvdevRumble::Begin(int node) noexcept
{
  *this = {};
  this->Node = node;
  int slots = 0;
  // The last program may have changed the gain. Drivers without a gain ignore this event.
  return ioctl(node, EVIOCGEFFECTS, &slots) >= 0 && slots > 0 &&
    EvdevNode::SendForce(node, FF_GAIN, 0xFFFF);
}

bool EvdevRumble::Upload(const Pair& pair) noexcept
{
  ff_effect effect{};
  effect.type = FF_RUMBLE;
  effect.id = static_cast<__s16>(this->Id);
  effect.replay.length = ReplayLength;
  effect.u.rumble.strong_magnitude = static_cast<__u16>(pair.Strong * 0xFFFF / Steps);
  effect.u.rumble.weak_magnitude = static_cast<__u16>(pair.Weak * 0xFFFF / Steps);
  int result = ioctl(this->Node, EVIOCSFF, &effect);
  if (result < 0 && this->Id >= 0 && (errno == EINVAL || errno == EACCES))
  {
    // Create the effect again: before Linux 5.7, a child process that closes its copy of the node
    // erases the effects.
    effect.id = -1;
    result = ioctl(this->Node, EVIOCSFF, &effect);
  }
  this->Id = result < 0 ? -1 : effect.id;
  return result >= 0;
}

bool EvdevRumble::Play(bool isOn) const noexcept
{
  return EvdevNode::SendForce(this->Node, this->Id, isOn ? 1 : 0);
}

bool EvdevRumble::Send(const Pair& pair) noexcept
{
  const bool isSilent = pair.Strong == 0 && pair.Weak == 0;
  this->Sent = pair;
  this->SentAt = ServoClock::Now();
  return isSilent ? this->Id < 0 || this->Play(false) : this->Upload(pair) && this->Play(true);
}

bool EvdevRumble::Show(const VibrationLevels& levels) noexcept
{
  const Pair pair{ Vibration::Quantize(levels.Strong, Steps),
    Vibration::Quantize(levels.Weak, Steps) };
  const bool isSilent = pair.Strong == 0 && pair.Weak == 0;
  const bool isSame = pair.Strong == this->Sent.Strong && pair.Weak == this->Sent.Weak;
  const double age = ServoClock::SecondsSince(this->SentAt);
  return !Vibration::IsDue(isSame, isSilent, age) || this->Send(pair);
}

bool EvdevRumble::Silence() noexcept
{
  return this->Send({});
}

void EvdevRumble::End() noexcept
{
  this->Silence();
  if (this->Id >= 0)
  {
    ioctl(this->Node, EVIOCRMFF, this->Id);
  }
  this->Id = -1;
}

} // namespace VolumeHaptics
