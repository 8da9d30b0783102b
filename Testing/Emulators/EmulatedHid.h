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
   * Plugs the device in, as a node of a new number each time: the old node may still be open. The
   * serial number stays, if the model tells one; 0 stands for one that no other device has. The
   * model has to outlive this.
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

  /** The target of a handle on the node, for one plug. For this carrier alone. */
  struct Plug;

private:
  HidModel& Model;
  int SerialNumber;
  std::mutex Guard; ///< guards Current; models send to it from their own threads
  Plug* Current = nullptr;
  std::vector<Plug*> Old; ///< kept, because handles on them may still be open
};

} // namespace emulated

#endif
