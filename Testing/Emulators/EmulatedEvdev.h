// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A gamepad in umockdev's simulated kernel: its evdev node, and its files in sysfs.
 *
 * umockdev does not report the closing of a file; use PadModel::CloseFiles().
 */
#ifndef EmulatedEvdev_h
#define EmulatedEvdev_h

#include "PadModel.h"

#include <memory>

namespace emulated
{
class FifoNode;

class EmulatedEvdev
{
public:
  /** Plugs the gamepad in, with a new node number. The model must outlive this object. */
  explicit EmulatedEvdev(PadModel& model);
  ~EmulatedEvdev();
  EmulatedEvdev(const EmulatedEvdev&) = delete;
  EmulatedEvdev& operator=(const EmulatedEvdev&) = delete;

  /** Unplugs the gamepad. From then on, calls on open files return ENODEV. */
  void Unplug();

  /** Returns the path of the node, such as /dev/input/event9. */
  const std::string& GetNode() const;
  /** Sets the permissions of the node, such as 0000. */
  void SetPermissions(unsigned mode);

private:
  PadModel& Model;
  const std::unique_ptr<FifoNode> Node;
};

} // namespace emulated

#endif
