// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Extracts reports from the bulk IN transfers of a Novint Falcon, for the servo loop.
 */
#ifndef FalconStream_h
#define FalconStream_h

#include "Devices/Falcon/FalconProtocol.h"

namespace VolumeHaptics
{

/**
 * Assembles packets that are split over several transfers, and skips bytes outside packets. A byte
 * that is invalid at its index discards all waiting bytes up to the next '<', so that a truncated
 * packet never corrupts the next one. Uses 16 bytes of memory, and time proportional to the number
 * of bytes.
 */
class FalconStream
{
public:
  /**
   * Processes a bulk IN transfer that includes the converter's status bytes. Returns the number of
   * completed reports. `report` receives the last of them, or stays unchanged.
   */
  int Receive(const std::uint8_t* transfer, std::size_t size, FalconReport& report) noexcept;

  /** Discards the waiting bytes and resets the counts, as after a purge. */
  void Restart() noexcept { *this = {}; }

  /** Returns the number of bytes that were dropped since the start. The count saturates. */
  std::uint32_t GetDropped() const noexcept { return this->Dropped; }
  /** Returns why the last bytes were dropped. */
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
