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
   * Plugs it in, as a node of a new number each time: the old one may still be open. The model has
   * to outlive this.
   */
  explicit EmulatedHid(HidModel& model);
  ~EmulatedHid();
  EmulatedHid(const EmulatedHid&) = delete;
  EmulatedHid& operator=(const EmulatedHid&) = delete;

  ///@{
  /** Every open handle gets EIO from then on, even after the device was plugged in again. */
  void Unplug();
  void PlugIn();
  ///@}

  /** Its node if it is plugged in, such as /dev/hidraw8. */
  const std::string& GetNode() const;

  /** On the kernel's behalf: what its node may be used for, such as 0000. */
  void SetPermissions(unsigned mode);

  /** The target of a handle on the node: one plug. For this carrier alone. */
  struct Plug;

private:
  HidModel& Model;
  std::mutex Guard; ///< of Current, which models send to from threads of their own
  Plug* Current = nullptr;
  std::vector<Plug*> Old; ///< handles on them may still be open
};

} // namespace emulated

#endif
