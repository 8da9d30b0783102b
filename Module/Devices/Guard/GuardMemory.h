// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The memory that a program and its guard share. It contains only an exchange.
 *
 * It has no name in the file system. The guard inherits it as a file descriptor. It disappears when
 * the last one of the two processes ends.
 */
#ifndef GuardMemory_h
#define GuardMemory_h

#include "Devices/Common/HardwareExchange.h"

namespace VolumeHaptics
{

class GuardMemory
{
public:
  GuardMemory() = default;
  ~GuardMemory();
  GuardMemory(const GuardMemory&) = delete;
  GuardMemory& operator=(const GuardMemory&) = delete;

  /**
   * Makes new memory with an unused exchange, for the program. It replaces the old memory at the
   * same address, so that an earlier guard can no longer reach it. Returns false and writes the
   * reason to `error` if this fails.
   */
  bool Renew(std::string& error);
  /**
   * Maps the memory of an inherited file descriptor, for the guard. Returns false and writes the
   * reason to `error` if this fails.
   */
  bool Adopt(int descriptor, std::string& error);

  /** Returns the file descriptor, or a negative number if there is no memory. */
  int GetDescriptor() const noexcept { return this->Descriptor; }
  HardwareExchange& GetExchange() noexcept { return *this->Exchange; }

  /**
   * Returns a text that describes the layout of the memory in this build. A guard with another
   * layout does not start.
   */
  static std::string GetLayout();

private:
  bool Map(int descriptor, std::string& error);
  void End() noexcept;

  int Descriptor = -1;
  void* Address = nullptr;
  HardwareExchange* Exchange = nullptr;
  bool IsOwner = false; ///< whether this is the program's process, which has made the exchange
};

} // namespace VolumeHaptics

#endif
