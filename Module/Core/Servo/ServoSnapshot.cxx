// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// The seal of what leaves the servo loop.
#include "Core/Servo/ServoLoop.h"

#include <cstring>

namespace VolumeHaptics
{
namespace
{

std::uint64_t Mix(std::uint64_t seal, std::uint64_t word) noexcept
{
  seal = (seal ^ word) * 0x9E3779B97F4A7C15ULL;
  return seal ^ (seal >> 29);
}

std::uint64_t Mix(std::uint64_t seal, double number) noexcept
{
  std::uint64_t word;
  std::memcpy(&word, &number, sizeof(word));
  return Mix(seal, word);
}

std::uint64_t Mix(std::uint64_t seal, const Vector3& v) noexcept
{
  return Mix(Mix(Mix(seal, v.X), v.Y), v.Z);
}

} // namespace

std::uint64_t ComputeSeal(const ServoSnapshot& s) noexcept
{
  std::uint64_t seal = Mix(Mix(s.Tick, s.Time), s.Generation);
  seal = Mix(Mix(Mix(seal, s.Record.Tip), s.Record.Proxy), s.Record.Force);
  seal = Mix(Mix(seal, s.Turn), s.Residency);
  seal = Mix(Mix(seal, s.Record.Normal), s.Command);
  seal = Mix(Mix(seal, s.Record.GradientMagnitude), s.Record.SurfaceValue);
  seal = Mix(Mix(seal, s.Record.Stiffness), s.Record.SurfaceStrength);
  seal = Mix(Mix(seal, s.Record.NormalForce), s.Record.FrictionForce);
  seal = Mix(Mix(Mix(seal, s.Before.Proxy), s.Before.PreviousTip), s.Record.MediumValue);
  seal = Mix(Mix(Mix(seal, s.Before.Local.Position), s.Before.Local.Fading),
    std::uint64_t{ s.Before.Local.Number });
  const std::uint64_t flags = static_cast<std::uint64_t>(s.Armed) << 1 |
    static_cast<std::uint64_t>(s.Stale) << 2 | static_cast<std::uint64_t>(s.Awaiting) << 4 |
    static_cast<std::uint64_t>(s.Before.Enabled) << 3 | static_cast<std::uint64_t>(s.Fault) << 8 |
    static_cast<std::uint64_t>(s.Device) << 16 |
    static_cast<std::uint64_t>(s.Record.Contact) << 24 |
    static_cast<std::uint64_t>(s.Record.IsRenewed) << 28 |
    static_cast<std::uint64_t>(s.Buttons) << 32;
  return Mix(seal, flags);
}

} // namespace VolumeHaptics
