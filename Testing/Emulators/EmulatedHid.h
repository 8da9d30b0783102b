// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A HID device that is plugged into the kernel that umockdev plays.
 */
#ifndef EmulatedHid_h
#define EmulatedHid_h

#include "DeviceModels.h"

#include <mutex>

namespace emulated
{

class EmulatedHid
{
public:
  /**
   * Plugs the device in. Its node gets a new number each time, as the old node may still be open.
   * The serial number stays, if the model has one; 0 requests a number that no other device has.
   * The model has to outlive this object.
   */
  explicit EmulatedHid(HidModel& model, int serialNumber = 0);
  ~EmulatedHid();
  EmulatedHid(const EmulatedHid&) = delete;
  EmulatedHid& operator=(const EmulatedHid&) = delete;

  ///@{
  /**
   * Unplugs the device: every open handle gets EIO from then on, even after it is plugged in again.
   */
  void Unplug();
  void PlugIn();
  ///@}

  /** The node of a plugged-in device, such as /dev/hidraw8. */
  const std::string& GetNode() const;
  int GetSerialNumber() const { return this->SerialNumber; }

  /** Sets the mode of the node, such as 0000, as the kernel would. */
  void SetPermissions(unsigned mode);

  /**
   * The target of the handles on a node, from plugging in to unplugging. Private to this carrier.
   */
  struct Plug;

private:
  HidModel& Model;
  int SerialNumber;
  std::mutex Guard; ///< guards Current, which the models' threads use
  Plug* Current = nullptr;
  std::vector<Plug*> Old; ///< earlier plugs, on which handles may still be open
};

} // namespace emulated

#endif
