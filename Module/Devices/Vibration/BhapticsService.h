// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A glove, sleeve or vest of bHaptics, through bHaptics' Player on this computer.
 *
 * The Player listens at a WebSocket of this computer. A frame vibrates for 150 ms and is renewed
 * after 50 ms, so the vibration ends by itself if this program hangs or is killed. Not verified on
 * a device.
 */
#ifndef BhapticsService_h
#define BhapticsService_h

#include "Devices/Transport/WebSocket/WebSocketClient.h"
#include "Devices/Vibration/VibrationService.h"

#include <cstdint>
#include <vector>

namespace VolumeHaptics
{

/**
 * Returns the Player's port, which VOLUMEHAPTICS_BHAPTICS may set. If that is not a valid port,
 * returns 0 and writes the fault to `error`.
 */
std::uint16_t FindBhapticsPort(std::string& error);

/**
 * Requests the places of the connected devices from the Player, within a time (s). On failure,
 * returns false and writes the reason and the cure to `error`.
 */
bool AskBhaptics(
  WebSocketClient& player, double seconds, std::vector<std::string>& places, std::string& error);

class BhapticsService final : public VibrationService
{
public:
  /** @param place one of BhapticsPlaces; if empty, the first place with a connected device */
  explicit BhapticsService(std::string place);

  std::string GetName() const override;
  bool Connect(std::string& error) override;
  State Show(double amplitude) override;
  std::string GetText() const override { return this->Text; }
  void StopAtCrash() noexcept override { this->Player.WriteLastWord(); }
  void Disconnect() noexcept override;

private:
  bool IsConnected(const std::vector<std::string>& places) const;
  State Lose(const char* text);

  const std::string Wanted;
  std::string Place; ///< place of the device that vibrates
  WebSocketClient Player;
  int Sent = 0; ///< last intensity sent
  std::int64_t SentAt = 0;
  std::string Text;
};

} // namespace VolumeHaptics

#endif
