// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Runs the fuzzer's target for HID descriptors on random bytes, and on a stick's descriptor with
 * some bytes changed.
 */

#include "Rigs/PidRig.h"
#include "TouchDescriptor.h"

#include <random>

using hardwaretest::Bytes;

namespace
{
Bytes Packet(std::mt19937& random)
{
  Bytes packet{ static_cast<std::uint8_t>(random() % 20) };
  for (int b = packet[0]; b > 0; --b)
  {
    // Draw small bytes often, because the first bytes of an answer are small.
    packet.push_back(static_cast<std::uint8_t>(random() % 2 == 0 ? random() % 4 : random()));
  }
  return packet;
}
void Touch(std::mt19937& random, const Bytes& descriptor)
{
  const Bytes all = hardwaretest::operator+(Packet(random), descriptor);
  TouchDescriptor(all.data(), all.size());
}
} // namespace

TEST(Fuzz, RandomDescriptorsAreTouched)
{
  for (unsigned seed = 0; seed < 2000; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    Bytes descriptor(random() % 300);
    for (std::uint8_t& byte : descriptor)
    {
      byte = static_cast<std::uint8_t>(random());
    }
    Touch(random, descriptor);
  }
}

TEST(Fuzz, SpoiltDescriptorsAreTouched)
{
  const Bytes stick = hardwaretest::Describe({});
  for (unsigned seed = 0; seed < 2000; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    Bytes descriptor = stick;
    for (unsigned changes = random() % 4; changes > 0; --changes)
    {
      descriptor[random() % descriptor.size()] = static_cast<std::uint8_t>(random());
    }
    Touch(random, descriptor);
  }
}
