// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reports out of the bulk IN transfers of a Novint Falcon, for the servo loop.
 */
#ifndef FalconStream_h
#define FalconStream_h

#include "Devices/Falcon/FalconProtocol.h"

namespace VolumeHaptics
{

/**
 * Puts packets together that are split across transfers, and finds the next one behind bytes that
 * belong to none. A byte that can't be at its place drops the bytes before the next '<', among
 * those that wait, too: a packet that was cut off never takes the following one with it.
 *
 * A fixed 16 bytes; the work is proportional to what arrives.
 */
class FalconStream
{
public:
  /**
   * A bulk IN transfer with the converter's status bytes. Returns how many reports were completed;
   * the last of them is the report, which stays as it was where there is none.
   */
  int Take(const std::uint8_t* transfer, std::size_t size, FalconReport& report) noexcept;

  /** Forgets what waits, as after a purge, and the counts. */
  void Restart() noexcept { *this = {}; }

  /** How many bytes were dropped since the start; it stops at the largest number. */
  std::uint32_t GetDropped() const noexcept { return this->Dropped; }
  /** Why the last ones were. */
  FalconFlaw GetFlaw() const noexcept { return this->Flaw; }

private:
  bool Put(std::uint8_t byte) noexcept;
  bool IsPlausible() noexcept;
  void DropToNextBegin() noexcept;

  FalconPacket Waiting{};
  std::size_t Count = 0;
  std::uint32_t Dropped = 0;
  FalconFlaw Flaw = FalconFlaw::None;
};

} // namespace VolumeHaptics

#endif
