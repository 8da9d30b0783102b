// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A device that communicates through a plug-in for its vendor's library (VendorPlugin.h).
 *
 * Each round reads the pose and writes the force. A round begins when the servo has a force, or a
 * millisecond after the last round. If a call of the plug-in does not return, the servo's force
 * becomes zero after 30 ms without positions, but the device does not receive this zero: only the
 * vendor's watchdog then ends the force.
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
 * A loaded plug-in for a vendor's library, with a list of its devices.
 *
 * Plug-ins stay loaded until the program ends, because vendors' libraries have threads of their
 * own, which must not outlive their code.
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
   * Returns the plug-in with a name, and loads it if necessary. On failure, returns null and writes
   * the reason and the cure to `error`.
   */
  static std::shared_ptr<VendorLibrary> Load(
    const std::string& plugin, const std::string& path, std::string& error);
  /** Loads a file that VendorFolder has found. May be called from any thread. */
  static std::shared_ptr<VendorLibrary> LoadFile(const std::string& path, std::string& error);

  /**
   * Lists the devices. While a device is open, returns the previous list without calling the
   * plug-in. If the plug-in can't list them, returns false and writes the reason to `error`.
   */
  bool Describe(std::vector<Description>& devices, std::string& error);

  ///@{
  /** Open and close a device. Open() returns null and writes the reason to `error` if it fails. */
  void* Open(int number, std::string& error);
  void Close(void* device, int number) noexcept;
  ///@}

  const VolumeHapticsVendorPlugin& Functions() const noexcept { return *this->Table; }
  /**
   * Returns the plug-in's text about a device, or about the plug-in if the device is null. The text
   * is never empty.
   */
  std::string LastError(void* device) const;

  /** Returns the identity of a device, as used in the user's device file. */
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
   * Longest duration of a call (s). A longer call is a fault, because the device was not observed
   * meanwhile.
   */
  static constexpr double LongestCall = 0.5;

  /** @param path folders, in the format of VendorFolder::Split() */
  VendorDriver(std::string plugin, int number, std::string path);
  ~VendorDriver() override;

  std::string GetName() const override { return this->Label; }
  DeviceLimits GetLimits() const override { return this->Limits; }
  std::string GetIdentity() const override { return this->Identity; }
  bool KeepsIdentity() const override { return this->HasSerial; }
  bool Connect(std::string& error) override;
  bool Reconnect(const std::string& identity, const std::function<bool()>& mustStop,
    std::string& error) override;
  void Serve(HardwareExchange& exchange) override;
  void Disconnect() noexcept override;

private:
  /** Connects to the device with this number, and sets Place. */
  bool Take(int number, std::string& error);
  bool ReadLimits(std::string& error);
  void Round(HardwareExchange& exchange);
  void ReceivePose(HardwareExchange& exchange, const VolumeHapticsVendorPose& pose, bool isNew);
  void Home(HardwareExchange& exchange);
  void Lose(HardwareExchange& exchange, const std::string& text);
  void Report(HardwareExchange& exchange, DeviceStage stage, const std::string& text) const;
  int Write(const Vector3& force, const Vector3& torque) noexcept;
  /**
   * Returns the largest force (N) that is allowed now: the peak force, which fades to the
   * continuous force if a larger force is requested for longer than PeakTime, and recovers in the
   * same time.
   */
  double ComputeMostForce(double wanted) noexcept;
  void TellOfFading(HardwareExchange& exchange, double wanted);

  const std::string Plugin;
  const int Number;
  int Place = 0; ///< current number of the connected device, which may have changed since Connect()
  /**
   * For each device in the plug-in's list, whether Reconnect() has opened it and found a different
   * device. Such a device is not opened again, because another program may need it.
   */
  std::vector<bool> Others;
  const std::string Path;
  std::string Label;
  std::string Identity;
  /**
   * Whether the device has a serial number; without serial numbers, the devices of a plug-in may
   * swap their numbers.
   */
  bool HasSerial = false;
  DeviceLimits Limits;
  std::shared_ptr<VendorLibrary> Library;
  void* Device = nullptr;
  bool Lost = false;
  bool Gone = false;
  bool IsReady = false;
  double PeakTime = 0.0;      // s
  double Spent = 0.0;         // time (s) above the continuous force, minus the time below
  std::int64_t WrittenAt = 0; // ns
  bool IsFading = false;      // whether the fading of the force was reported to the user
  // reason why a ready device had to wait; empty once it has a force again
  std::string Interruption;
};

} // namespace VolumeHaptics

#endif
