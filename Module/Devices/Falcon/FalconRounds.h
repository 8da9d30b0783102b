// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The exchange of run packets with a Novint Falcon, at the servo's pace.
 *
 * A packet is sent as soon as the servo gives a force, but only when it is the host's turn
 * (FalconTurns.h). Without a force, one is sent every 2 ms, so that homing goes on and zero is
 * renewed. Receiving transfers are always posted. Everything is allocated before the first round.
 */
#ifndef FalconRounds_h
#define FalconRounds_h

#include "Devices/Common/HardwareExchange.h"
#include "Devices/Falcon/FalconStream.h"
#include "Devices/Falcon/FalconTurns.h"
#include "Devices/Transport/Usb/UsbEvents.h"
#include "Devices/Transport/Usb/UsbTransfer.h"

namespace VolumeHaptics
{

class FalconRounds final : public UsbTransferOwner
{
public:
  /** The longest time (ns) without a packet. */
  static constexpr std::int64_t IdleTime = 2000000;

  /** Both must outlive this object. */
  FalconRounds(UsbInterface& usb, HardwareExchange& exchange);
  /**
   * If the device is connected, sends zero commands and waits until they are sent, for a fraction
   * of a second at most.
   */
  ~FalconRounds();

  /** Waits until something has happened or is due. */
  void Wait() noexcept;

  ///@{
  /** The event that ended the last Wait. */
  bool HasReport() const noexcept { return this->Reported; }
  const FalconReport& GetReport() const noexcept { return this->Report; }
  /** Whether a packet was not answered in time; GetGarbage says why, or is nullptr. */
  bool HasMissed() const noexcept { return this->Missed; }
  const char* GetGarbage() const noexcept;
  /**
   * The worst result of a transfer during the last Wait, or of submitting one since the Wait
   * before.
   */
  UsbOutcome GetTrouble() const noexcept { return this->Trouble; }
  ///@}

  /** Whether a packet should be sent now. */
  bool IsDue() noexcept;
  void Send(const FalconOrder& order) noexcept;

private:
  struct Transfers
  {
    Transfers(UsbInterface& usb, UsbTransferOwner& owner);
    bool AreFlying() const noexcept;

    UsbTransfer Out;
    UsbTransfer First;
    UsbTransfer Second;
  };

  void TransferEnded(UsbTransfer& transfer, UsbOutcome outcome) noexcept override;
  bool Submit(UsbTransfer& transfer, std::size_t size) noexcept;
  void PostReceivers() noexcept;
  void Note(UsbOutcome outcome) noexcept;
  bool IsPending() noexcept;
  template <typename F>
  void WaitWhile(F&& holds, std::int64_t time) noexcept;
  void Finish() noexcept;

  UsbInterface& Usb;
  HardwareExchange& Exchange;
  UsbEvents Events;
  std::unique_ptr<Transfers> Flight;
  FalconStream Stream;
  FalconReport Report;
  std::uint32_t DroppedBefore = 0; ///< GetDropped at the last report
  FalconTurns Turns;
  std::int64_t SentAt = 0;
  bool Woken = false;
  bool Reported = false;
  bool Missed = false;
  UsbOutcome TroubleSoFar = UsbOutcome::Done;
  UsbOutcome Trouble = UsbOutcome::Done;
  bool OutStalled = false;
  bool InStalled = false;
};

} // namespace VolumeHaptics

#endif
