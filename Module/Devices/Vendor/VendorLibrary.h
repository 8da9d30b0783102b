// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A loaded plug-in for a vendor's library, with the facts about its devices.
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

  /**
   * Loads the plug-in of this name, or returns the loaded one. Null, with the reason and the cure.
   */
  static std::shared_ptr<VendorLibrary> Load(
    const std::string& plugin, const std::string& path, std::string& error);
  /** Loads a file that VendorFolder found. Any thread. */
  static std::shared_ptr<VendorLibrary> LoadFile(const std::string& path, std::string& error);

  /**
   * The devices. While one is open, returns the last list without asking the plug-in. False, with
   * the reason, if the plug-in can't list them.
   */
  bool Describe(std::vector<Description>& devices, std::string& error);

  ///@{
  /** Opens a device (null, with the reason) and closes it. */
  void* Open(int number, std::string& error);
  void Close(void* device, int number) noexcept;
  ///@}

  const VolumeHapticsVendorPlugin& Functions() const noexcept { return *this->Table; }
  /** The plug-in's text about a device, or about itself; never empty. */
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
