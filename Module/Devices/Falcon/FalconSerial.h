// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One request, one answer at a time with a Novint Falcon: before its run packets flow.
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
/** The endpoints of its serial converter. */
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

  /** Closes the device and opens it again. False, with GetError. */
  bool Reopen() noexcept;
  bool IsOpen() const noexcept { return this->Usb.IsOpen(); }

  ///@{
  /** False where it did not go through; GetError says why. */
  bool Request(const FtdiRequest& request) noexcept;
  bool Write(const std::uint8_t* bytes, std::size_t size) noexcept;
  ///@}
  /**
   * The first bytes that come within a time (ms), without the converter's status. Their number, 0
   * for none; below zero where the transfer did not go through.
   */
  int Read(std::array<std::uint8_t, FtdiPacketSize>& bytes, unsigned int time) noexcept;
  /** The last error of libusb. */
  int GetError() const noexcept { return this->Error; }

  /**
   * Whether the firmware runs: sends FalconRunRequests and packets of zero, at most so many, 50 ms
   * each. False at once where a transfer does not go through.
   */
  bool Runs(int packets) noexcept;

private:
  UsbInterface& Usb;
  int Error = 0;
};

enum class FalconLoading : std::uint8_t
{
  Loaded,
  Stopped, ///< the exchange must stop, or is told already
  Failed,
  Gone
};

/** How often loading is tried. The loader is known to be flaky: libnifalcon, too, tries ten times. */
constexpr int FalconLoadingTries = 10;

/**
 * Loads the firmware, on the device's thread: takes seconds, tells the exchange how far it is, and
 * waits for the firmware to run. After a failure the device is closed, opened and loaded again. If
 * the last try fails, the text says why it did.
 */
FalconLoading LoadFalcon(FalconSerial& serial, const std::vector<std::uint8_t>& image,
  HardwareExchange& exchange, std::string& trouble);

} // namespace VolumeHaptics

#endif
