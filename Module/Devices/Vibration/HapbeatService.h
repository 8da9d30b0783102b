// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Streams a sine of 100 Hz to a Hapbeat over UDP, scaled by the amplitude.
 *
 * Packets are sent only to the address that the user names, without the protocol's broadcast. The
 * device buffers about 50 ms of the sine, so it becomes silent by itself if this program hangs or
 * is killed, or if the network fails. Not verified on a device.
 */
#ifndef HapbeatService_h
#define HapbeatService_h

#include "Devices/Transport/Local/LineSocket.h"
#include "Devices/Vibration/ServiceMessages.h"
#include "Devices/Vibration/VibrationService.h"

#include <cstdint>

namespace VolumeHaptics
{

class HapbeatService final : public VibrationService
{
public:
  static constexpr double Frequency = 100.0; ///< Hz
  static constexpr int Chunk = 256;          ///< samples in a packet, 16 ms
  static constexpr int Lead = 3 * Chunk;     ///< samples that are buffered in the device
  /**
   * Time (s) between pings, and time (s) without an answer after which the device counts as gone.
   */
  static constexpr double PingPeriod = 0.5;
  static constexpr double LongestSilence = 3.0;
  /**
   * Time (s) of silence after which the stream ends; a weak level thus does not interrupt it
   * repeatedly.
   */
  static constexpr double QuietTime = 0.05;

  HapbeatService(std::string address, std::uint16_t port);
  ~HapbeatService() override { this->HapbeatService::Disconnect(); }

  std::string GetName() const override;
  bool Connect(std::string& error) override;
  State Show(double amplitude) override;
  std::string GetText() const override;
  void Disconnect() noexcept override;

private:
  bool SendOften(const HapbeatPacket& packet);
  bool SendChunk(double amplitude);
  bool Ping();
  /** Reads answers. Returns false if the system reports that no program has the port open. */
  bool Listen();
  bool Stream(double amplitude);
  bool End();

  const std::string Address;
  const std::uint16_t Port;
  std::string Device; ///< name that the device reports
  PacketSocket Socket;
  std::uint16_t Number = 0; ///< number of the last packet
  bool IsStreaming = false;
  std::int64_t Begun = 0; ///< time at which the stream began
  std::int64_t Samples = 0;
  double Amplitude = 0.0;      ///< amplitude at the end of the last packet
  std::int64_t QuietSince = 0; ///< time at which the level fell below Vibration::Least, or 0
  std::int64_t PingedAt = 0;
  std::int64_t HeardAt = 0;
};

} // namespace VolumeHaptics

#endif
