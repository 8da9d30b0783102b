// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Sends single requests to a Novint Falcon and reads the answers, before run packets are exchanged.
 */
#ifndef FalconSerial_h
#define FalconSerial_h

#include "Devices/Common/HardwareExchange.h"
#include "Devices/Falcon/FalconProtocol.h"
#include "Devices/Transport/Usb/FtdiSerial.h"
#include "Devices/Transport/Usb/UsbInterface.h"

namespace VolumeHaptics
{

///@{
/** The endpoints of the Falcon's serial converter. */
constexpr std::uint8_t FalconOut = 0x02;
constexpr std::uint8_t FalconIn = 0x81;
///@}

class FalconSerial
{
public:
  explicit FalconSerial(UsbInterface& usb) noexcept
    : Usb(usb)
  {
  }

  /**
   * Closes the device and opens it again. Returns false if this fails; GetError() returns the
   * reason.
   */
  bool Reopen() noexcept;
  bool IsOpen() const noexcept { return this->Usb.IsOpen(); }

  ///@{
  /** Sends a request. Returns false if the transfer fails; GetError() returns the reason. */
  bool Request(const FtdiRequest& request) noexcept;
  bool Write(const std::uint8_t* bytes, std::size_t size) noexcept;
  ///@}
  /**
   * Reads the first bytes that arrive within a time (ms), without the converter's status bytes.
   * Returns the number of bytes: 0 if none arrived, negative if the transfer failed.
   */
  int Read(std::array<std::uint8_t, FtdiPacketSize>& bytes, unsigned int time) noexcept;
  /** Returns the last error of libusb. */
  int GetError() const noexcept { return this->Error; }

  /**
   * Returns whether the firmware runs. Sends FalconRunRequests and at most `packets` packets of
   * zero, 50 ms each. Returns false at once if a transfer fails.
   */
  bool Runs(int packets) noexcept;

private:
  UsbInterface& Usb;
  int Error = 0;
};

enum class FalconLoading : std::uint8_t
{
  Loaded,
  Stopped, ///< the exchange must stop, or the reason of the failure was already reported
  Failed,
  Gone
};

/**
 * Number of attempts. The device's loader is known to be unreliable; libnifalcon also tries ten
 * times.
 */
constexpr int FalconLoadingTries = 10;

/**
 * Loads the firmware. Called on the device's thread. This takes seconds: the function reports its
 * progress to the exchange, and waits until the firmware runs. After a failure, reopens the device
 * and tries again. If the last attempt fails, writes the reason to `trouble`.
 */
FalconLoading LoadFalcon(FalconSerial& serial, const std::vector<std::uint8_t>& image,
  HardwareExchange& exchange, std::string& trouble);

} // namespace VolumeHaptics

#endif
