// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Single requests to a Novint Falcon and their answers, before run packets are exchanged.
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
   * Reads the first bytes that come within a time (ms), without the converter's status bytes.
   * Returns the number of bytes. It is 0 if none came, and negative if the transfer failed.
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
  Stopped, ///< the exchange must stop, or already has the reason of the failure
  Failed,
  Gone
};

/** Number of trials. The loader is known to be unreliable, and libnifalcon also tries ten times. */
constexpr int FalconLoadingTries = 10;

/**
 * Loads the firmware. Called on the device's thread. This takes seconds: the function reports its
 * progress to the exchange, and waits for the firmware to run. After a failure it closes the
 * device, opens it and tries again. If the last trial fails, `trouble` receives the reason.
 */
FalconLoading LoadFalcon(FalconSerial& serial, const std::vector<std::uint8_t>& image,
  HardwareExchange& exchange, std::string& trouble);

} // namespace VolumeHaptics

#endif
