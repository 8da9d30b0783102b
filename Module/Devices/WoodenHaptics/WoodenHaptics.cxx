// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/WoodenHaptics/WoodenHaptics.h"

#include "Core/Safety/SafetyStage.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{
constexpr double TwoPi = 6.283185307179586;
constexpr std::int16_t SendCurrents = 0;
constexpr std::int16_t PresetEncoders = 1;
constexpr std::int16_t Calibrate = 1;

std::int16_t WordAt(const std::uint8_t* bytes) noexcept
{
  return static_cast<std::int16_t>(bytes[0] | bytes[1] << 8);
}

// Encodes a packet of seven words: a, b, c, the command, and three attributes.
WoodenHaptics::Packet Encode(const std::array<std::int16_t, 7>& words) noexcept
{
  WoodenHaptics::Packet packet{};
  for (std::size_t w = 0; w < words.size(); ++w)
  {
    const auto word = static_cast<std::uint16_t>(words[w]);
    packet[1 + 2 * w] = static_cast<std::uint8_t>(word & 0xFF);
    packet[2 + 2 * w] = static_cast<std::uint8_t>(word >> 8);
  }
  return packet;
}
} // namespace

const char* WoodenHaptics::Decode(
  const std::uint8_t* bytes, std::size_t size, Input& input) noexcept
{
  if (size != PacketSize)
  {
    return size < PacketSize ? "a packet of less than 14 bytes" : "a packet of more than 14 bytes";
  }
  for (std::size_t e = 0; e < input.Counts.size(); ++e)
  {
    input.Counts[e] = WordAt(bytes + 2 * e);
  }
  input.WantsCalibration = WordAt(bytes + 12) == Calibrate;
  return nullptr;
}

WoodenHaptics::Packet WoodenHaptics::EncodeCurrents(const Currents& milliamperes) noexcept
{
  return Encode({ milliamperes[0], milliamperes[1], milliamperes[2], SendCurrents, 0, 0, 0 });
}

WoodenHaptics::Packet WoodenHaptics::EncodeCalibration() const noexcept
{
  const std::array<std::int16_t, 3>& rest = this->Geometry.RestCounts;
  return Encode({ 0, 0, 0, PresetEncoders, rest[0], rest[1], rest[2] });
}

std::array<double, 3> WoodenHaptics::ComputeAngles(
  const std::array<std::int16_t, 6>& counts) const noexcept
{
  const WoodenHapticsGeometry& g = this->Geometry;
  std::array<double, 3> angles{};
  for (int j = 0; j < 3; ++j)
  {
    angles[j] = g.Signs[j] * g.Transmission[j] * TwoPi * counts[j] / g.CountsPerTurn;
  }
  return angles;
}

Vector3 WoodenHaptics::ComputeTip(const std::array<double, 3>& angles) const noexcept
{
  const WoodenHapticsGeometry& g = this->Geometry;
  const double reach = g.UpperArm * std::sin(angles[1]) + g.Forearm * std::sin(angles[2]);
  const double height = g.Base + g.UpperArm * std::cos(angles[1]) - g.Forearm * std::cos(angles[2]);
  return Vector3{ reach * std::cos(angles[0]), reach * std::sin(angles[0]), height } - g.Origin;
}

Matrix3 WoodenHaptics::ComputeJacobian(const std::array<double, 3>& angles) const noexcept
{
  const WoodenHapticsGeometry& g = this->Geometry;
  const double sinA = std::sin(angles[0]);
  const double cosA = std::cos(angles[0]);
  const double reach = g.UpperArm * std::sin(angles[1]) + g.Forearm * std::sin(angles[2]);
  const double reachB = g.UpperArm * std::cos(angles[1]);
  const double reachC = g.Forearm * std::cos(angles[2]);
  return Matrix3::FromColumns({ -sinA * reach, cosA * reach, 0.0 },
    { cosA * reachB, sinA * reachB, -g.UpperArm * std::sin(angles[1]) },
    { cosA * reachC, sinA * reachC, g.Forearm * std::sin(angles[2]) });
}

WoodenHaptics::Currents WoodenHaptics::ComputeCurrents(
  const std::array<double, 3>& angles, const Vector3& force) const noexcept
{
  const WoodenHapticsGeometry& g = this->Geometry;
  const Vector3 torque = Transpose(this->ComputeJacobian(angles)) * force;
  std::array<double, 3> milliamperes{ torque.X, torque.Y, torque.Z };
  for (int j = 0; j < 3; ++j)
  {
    milliamperes[j] *= 1000.0 * g.Signs[j] * g.Transmission[j] / g.TorqueConstant;
  }
  // The range of a word in the packet also limits the currents, whatever the geometry says.
  constexpr double wire = 32767.0;
  SaturateTogether(milliamperes.data(), 3, std::min(wire, 1000.0 * g.MaximumCurrent));
  Currents currents{};
  for (int j = 0; j < 3; ++j)
  {
    currents[j] = static_cast<std::int16_t>(std::lround(milliamperes[j]));
  }
  return currents;
}

} // namespace VolumeHaptics
