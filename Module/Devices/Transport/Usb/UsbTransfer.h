// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A bulk transfer that is made once and submitted many times.
 */
#ifndef UsbTransfer_h
#define UsbTransfer_h

#include "Devices/Transport/Usb/UsbInterface.h"

#include <array>

namespace VolumeHaptics
{

/** The end of a transfer. */
enum class UsbOutcome : std::uint8_t
{
  Done,
  Cancelled,
  Stalled,
  Failed,
  Gone ///< the device is unplugged
};

class UsbTransfer;

/** Whoever waits for transfers: called while the context's events are handled, on that thread. */
class UsbTransferOwner
{
public:
  virtual void TransferEnded(UsbTransfer& transfer, UsbOutcome outcome) noexcept = 0;

protected:
  ~UsbTransferOwner() = default;
};

/** Not to be destroyed while it flies. */
class UsbTransfer
{
public:
  static constexpr std::size_t Capacity = 64; ///< bytes: one packet of a full-speed bulk endpoint

  UsbTransfer(UsbInterface& usb, std::uint8_t endpoint, UsbTransferOwner& owner);
  ~UsbTransfer();
  UsbTransfer(const UsbTransfer&) = delete;
  UsbTransfer& operator=(const UsbTransfer&) = delete;

  /** To send or to fill. */
  std::uint8_t* GetBytes() noexcept { return this->Bytes.data(); }
  /** How many bytes the last one moved. */
  std::size_t GetSize() const noexcept;
  std::uint8_t GetEndpoint() const noexcept;

  /**
   * Hands it to the system; it has no time limit of its own: Cancel it. Done where it flies now.
   */
  UsbOutcome Submit(std::size_t size) noexcept;
  /** The owner is told when it has ended. */
  void Cancel() noexcept;
  bool IsFlying() const noexcept { return this->Flying; }

private:
  static void LIBUSB_CALL Ended(libusb_transfer* transfer) noexcept;

  UsbTransferOwner& Owner;
  libusb_transfer* const Transfer;
  std::array<std::uint8_t, Capacity> Bytes{};
  bool Flying = false;
};

} // namespace VolumeHaptics

#endif
