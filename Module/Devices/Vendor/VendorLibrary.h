// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A loaded plug-in for a vendor's library, and what is known of its devices.
 *
 * Plug-ins stay loaded until the program ends: vendors' libraries have threads of their own, which
 * may not outlive their code.
 */
#ifndef VendorLibrary_h
#define VendorLibrary_h

#include "Devices/Vendor/VendorPlugin.h"

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace VolumeHaptics
{

class VendorLibrary
{
public:
  struct Description
  {
    std::string Name;
    std::string Serial;
    bool IsOpen = false; ///< by this program
  };

  /** Loads the plug-in of this name, or finds it loaded. Null, with the reason and the cure. */
  static std::shared_ptr<VendorLibrary> Load(
    const std::string& plugin, const std::string& path, std::string& error);
  /** Loads a file that VendorFolder found. Any thread. */
  static std::shared_ptr<VendorLibrary> LoadFile(const std::string& path, std::string& error);

  /**
   * The devices. While one is open, as they were before: the plug-in is then not asked. False, with
   * the reason, if the plug-in can't tell.
   */
  bool Describe(std::vector<Description>& devices, std::string& error);

  ///@{
  /** Opens a device (null, with the reason) and closes it. */
  void* Open(int number, std::string& error);
  void Close(void* device, int number) noexcept;
  ///@}

  const VolumeHapticsVendorPlugin& Functions() const noexcept { return *this->Table; }
  /** The plug-in's text for a device, or for itself; never empty. */
  std::string LastError(void* device) const;

  /** The identity of a device for the user's file of devices. */
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

} // namespace VolumeHaptics

#endif
