// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** A HID device that is plugged into umockdev's simulated kernel. */
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
   * Plugs the device in. Its node gets a new number each time, because the old node may still be
   * open. The serial number stays the same, if the model has one. A serial number of 0 requests a
   * unique number. The model must outlive this object.
   */
  explicit EmulatedHid(HidModel& model, int serialNumber = 0);
  ~EmulatedHid();
  EmulatedHid(const EmulatedHid&) = delete;
  EmulatedHid& operator=(const EmulatedHid&) = delete;

  ///@{
  /**
   * Unplugs the device. From then on, open handles return EIO, even after the device has been
   * plugged in again.
   */
  void Unplug();
  void PlugIn();
  ///@}

  /** Returns the node of the plugged-in device, such as /dev/hidraw8. */
  const std::string& GetNode() const;
  int GetSerialNumber() const { return this->SerialNumber; }

  /** Sets the permissions of the node, such as 0000. */
  void SetPermissions(unsigned mode);

  /**
   * The object behind the handles of a node, from plugging in to unplugging. Private to this
   * carrier.
   */
  struct Plug;

private:
  HidModel& Model;
  int SerialNumber;
  std::mutex Guard; ///< guards Current, which the models' threads use
  Plug* Current = nullptr;
  std::vector<Plug*> Old; ///< earlier plugs, whose handles may still be open
};

} // namespace emulated

#endif
