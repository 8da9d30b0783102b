// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The index finger of WEART's TouchDIVER, through WEART's middleware or WeArt app on this computer.
 *
 * A texture vibrates until it is stopped, and the middleware's behaviour when its client dies is
 * not published: on Linux, a guard (Devices/Guard) stops the texture if the program can't. If the
 * middleware is not running yet, it is started, and stopped at the end. Pressure and temperature
 * are not used, because the force at full pressure is not published. Not verified on a device.
 */
#ifndef WeartService_h
#define WeartService_h

#include "Devices/Transport/Local/LineSocket.h"
#include "Devices/Vibration/ServiceMessages.h"
#include "Devices/Vibration/VibrationService.h"

#include <cstdint>

namespace VolumeHaptics
{

/**
 * Requests the middleware's status, within a time (s). On failure, returns false and writes the
 * reason and the cure to `error`.
 */
bool AskWeart(LineSocket& middleware, double seconds, WeartStatus& status, std::string& error);

class WeartService final : public VibrationService
{
public:
  /** @param hand "LEFT" or "RIGHT"; if empty, the first connected hand */
  explicit WeartService(std::string hand);
  ~WeartService() override { this->WeartService::Disconnect(); }

  std::string GetName() const override;
  bool Connect(std::string& error) override;
  State Show(double amplitude) override;
  std::string GetText() const override { return this->Text; }
  void StopAtCrash() noexcept override;
  void Disconnect() noexcept override;

private:
  bool IsConnected() const;
  State Tell(State state, const char* text);

  const std::string Wanted;
  std::string Hand;
  std::string LastWord;
  LineSocket Middleware{ WeartSeparator };
  WeartStatus Status;
  bool IsStarter = false; ///< whether this session has started the middleware
  int Sent = 0;           ///< last volume sent
  std::int64_t SentAt = 0;
  std::int64_t AskedAt = 0; ///< time of the last status request
  std::string Text;
};

} // namespace VolumeHaptics

#endif
