// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists the input devices for which Linux has a driver (evdev), from their description in sysfs.
 */
#ifndef EvdevNode_h
#define EvdevNode_h

#include <linux/input.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/**
 * Returns whether a bit is set in a bit mask from sysfs, such as "107030000 0 0": words of the
 * kernel's type long in hexadecimal, the highest word first. Returns false for other texts.
 */
bool HasEvdevBit(const std::string& words, unsigned bit);

using EvdevEvents = std::array<input_event, 64>;

struct EvdevNode
{
  std::string Path; ///< such as /dev/input/event5
  std::string Name; ///< the product's name
  std::uint16_t Vendor = 0;
  std::uint16_t Product = 0;
  std::string Serial; ///< serial number; empty if the driver reports none

  /**
   * Returns whether the driver supports an event. `kind` is "abs" for axes, "key" for buttons, or
   * "ff" for force feedback.
   */
  bool Has(const char* kind, unsigned code) const;
  /** Returns whether the device's own descriptor includes force feedback (HID-PID). */
  bool IsPid() const;
  /**
   * Opens the node, and grabs it so that no other program receives its events. On failure, returns
   * a negative number and sets errno.
   */
  int Open() const noexcept;
  /** Returns "available", "in use", or the obstacle and its cure. */
  std::string GetState() const;
  /** Returns the obstacle and its cure for an errno value of Open(). */
  static std::string Explain(int fault);
  /** Releases and closes an open node. */
  static void Close(int node) noexcept;
  /**
   * Sends a force-feedback event: a gain, a spring, or the start or end of an effect. Returns false
   * if the driver refuses it.
   */
  static bool SendForce(int node, int code, int value) noexcept;
  /**
   * Waits at most `pause` (ms) for events of an open node or for a wake signal, and reads the
   * events. `wake` is a descriptor, or negative. Returns the number of events, or -1 if the node is
   * gone.
   */
  static int Receive(int node, int wake, int pause, EvdevEvents& events) noexcept;

private:
  std::string GetFolder() const;
};

/** Lists all input devices in the order of their numbers. */
std::vector<EvdevNode> ListEvdevNodes();

} // namespace VolumeHaptics

#endif
