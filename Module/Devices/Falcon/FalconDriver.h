// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A Novint Falcon through libusb. Not verified on hardware.
 */
#ifndef FalconDriver_h
#define FalconDriver_h

#include "Devices/Common/DeviceKind.h"
#include "Devices/Common/HardwareDevice.h"
#include "Devices/Transport/Usb/UsbInterface.h"

namespace VolumeHaptics
{

constexpr UsbProduct FalconProduct = { 0x0403, 0xcb48, "Novint Falcon" };

class FalconDriver final : public HardwareDriver
{
public:
  /** @param number number of the device in ListUsbDevices */
  FalconDriver(int number, DeviceOptions options);

  ///@{
  /**
   * Convert the arguments to words of a command line, and back. If the words are not valid,
   * MakeFromWords() returns null and writes the reason to `error`.
   */
  static std::vector<std::string> MakeWords(int number, const DeviceOptions& options);
  static std::unique_ptr<HardwareDriver> MakeFromWords(
    const std::vector<std::string>& words, std::string& error);
  ///@}

  std::string GetName() const override { return this->Name; }
  DeviceLimits GetLimits() const override;
  std::string GetIdentity() const override { return this->Identity; }
  /**
   * Connects to the device. If its firmware does not run, an image is required, which Serve()
   * loads.
   */
  bool Connect(std::string& error) override;
  bool Reconnect(const std::string& identity, const std::function<bool()>& mustStop,
    std::string& error) override;
  void Serve(HardwareExchange& exchange) override;
  void Disconnect() noexcept override;

private:
  /** The outcome of a part of a session. */
  enum class End
  {
    Done,
    Failed, ///< the part failed, but Home() may try it again
    Gone
  };
  /**
   * Connects to the device with this number in ListUsbDevices. If `identity` is not null and the
   * device has a different identity, returns false without an error.
   */
  bool Take(int number, const std::string* identity, std::string& error);
  End Load(HardwareExchange& exchange);
  End Talk(HardwareExchange& exchange);

  const int Number;
  std::string Identity = "falcon"; ///< id of the device that was connected last
  const DeviceOptions Options;
  std::string Name;
  UsbInterface Usb;
  std::vector<std::uint8_t> Firmware; ///< image to load; empty if the firmware already runs
  /** Paths of other Falcons that Reconnect() has found, so that it opens each only once. */
  std::vector<std::vector<int>> Others;
};

} // namespace VolumeHaptics

#endif
