// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A bulk transfer that is allocated once and submitted repeatedly.
 */
#ifndef UsbTransfer_h
#define UsbTransfer_h

#include "Devices/Transport/Usb/UsbInterface.h"

#include <array>

namespace VolumeHaptics
{

/** The result of a transfer. */
enum class UsbOutcome : std::uint8_t
{
  Done,
  Cancelled,
  Stalled,
  Failed,
  Gone ///< the device was unplugged
};

class UsbTransfer;

/**
 * The owner of transfers, whose function is called on the thread that handles the context's events.
 */
class UsbTransferOwner
{
public:
  virtual void TransferEnded(UsbTransfer& transfer, UsbOutcome outcome) noexcept = 0;

protected:
  ~UsbTransferOwner() = default;
};

/** A bulk transfer. It must not be destroyed while it is submitted. */
class UsbTransfer
{
public:
  /** Number of bytes: the largest packet of a full-speed bulk endpoint. */
  static constexpr std::size_t Capacity = 64;

  UsbTransfer(UsbInterface& usb, std::uint8_t endpoint, UsbTransferOwner& owner);
  ~UsbTransfer();
  UsbTransfer(const UsbTransfer&) = delete;
  UsbTransfer& operator=(const UsbTransfer&) = delete;

  /** Returns the bytes to send, or the received bytes. */
  std::uint8_t* GetBytes() noexcept { return this->Bytes.data(); }
  /** Returns the number of bytes that the last transfer has sent or received. */
  std::size_t GetSize() const noexcept;
  std::uint8_t GetEndpoint() const noexcept;

  /**
   * Submits the transfer, without a time limit; Cancel() ends it. Returns Done if it was submitted.
   */
  UsbOutcome Submit(std::size_t size) noexcept;
  /** Cancels the transfer. The owner is called once it has ended. */
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
