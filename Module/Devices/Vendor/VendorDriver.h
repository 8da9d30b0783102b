// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A device behind a plug-in for its vendor's library (VendorPlugin.h).
 *
 * In each round it reads the pose and writes the force; a round follows each force of the servo, or
 * the last round by a millisecond. If a call of the plug-in does not return, the servo's force is
 * zero after 30 ms, as there are no positions, but the device does not get it: then only the
 * vendor's watchdog ends the force.
 */
#ifndef VendorDriver_h
#define VendorDriver_h

#include "Devices/Common/HardwareDevice.h"
#include "Devices/Vendor/VendorPlugin.h"

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/**
 * A loaded plug-in for a vendor's library, with the facts about its devices.
 *
 * Plug-ins stay loaded until the program ends: vendors' libraries have threads of their own, which
 * may not outlive their code.
 */
class VendorLibrary
{
public:
  struct Description
  {
    std::string Name;
    std::string Serial;
    bool IsOpen = false; ///< whether this program has the device open
  };

  /**
   * Returns the plug-in of this name, and loads it if it is not loaded yet. If this fails, returns
   * null and writes the reason and the cure to `error`.
   */
  static std::shared_ptr<VendorLibrary> Load(
    const std::string& plugin, const std::string& path, std::string& error);
  /** Loads a file that VendorFolder found. Any thread. */
  static std::shared_ptr<VendorLibrary> LoadFile(const std::string& path, std::string& error);

  /**
   * Lists the devices. While a device is open, returns the last list without calling the plug-in.
   * If the plug-in can't list them, returns false and writes the reason to `error`.
   */
  bool Describe(std::vector<Description>& devices, std::string& error);

  ///@{
  /** Open and close a device. If Open fails, it returns null and writes the reason to `error`. */
  void* Open(int number, std::string& error);
  void Close(void* device, int number) noexcept;
  ///@}

  const VolumeHapticsVendorPlugin& Functions() const noexcept { return *this->Table; }
  /** Returns the plug-in's text about a device, or about itself; never empty. */
  std::string LastError(void* device) const;

  /** Makes the identity of a device for the user's file of devices. */
  static std::string MakeIdentity(const std::string& plugin, int number, const std::string& serial);

private:
  explicit VendorLibrary(const VolumeHapticsVendorPlugin* table)
    : Table(table)
  {
  }
  bool Look(std::string& error);

  const VolumeHapticsVendorPlugin* const Table;
  std::mutex Mutex;
  int OpenCount = 0;
  std::vector<Description> Known;
};

class VendorDriver final : public HardwareDriver
{
public:
  /**
   * The longest call (s); a longer one is a fault, because the device was not observed meanwhile.
   */
  static constexpr double LongestCall = 0.5;

  /** `path` is a search path as in VendorFolder::Split. */
  VendorDriver(std::string plugin, int number, std::string path);
  ~VendorDriver() override;

  std::string GetName() const override { return this->Label; }
  DeviceLimits GetLimits() const override { return this->Limits; }
  std::string GetIdentity() const override { return this->Identity; }
  bool KeepsIdentity() const override { return this->HasSerial; }
  bool Connect(std::string& error) override;
  void Serve(HardwareExchange& exchange) override;
  void Disconnect() noexcept override;

private:
  bool ReadLimits(std::string& error);
  void Round(HardwareExchange& exchange);
  void ReceivePose(HardwareExchange& exchange, const VolumeHapticsVendorPose& pose, bool isNew);
  void Home(HardwareExchange& exchange);
  void Lose(HardwareExchange& exchange, const std::string& text);
  void Report(HardwareExchange& exchange, DeviceStage stage, const std::string& text) const;
  int Write(const Vector3& force, const Vector3& torque) noexcept;

  const std::string Plugin;
  const int Number;
  const std::string Path;
  std::string Label;
  std::string Identity;
  bool HasSerial = false; ///< whether the device has a serial number; without one, a plug-in's
                          ///< devices may change their numbers
  DeviceLimits Limits;
  std::shared_ptr<VendorLibrary> Library;
  void* Device = nullptr;
  bool Lost = false;
  bool IsReady = false;
};

} // namespace VolumeHaptics

#endif
