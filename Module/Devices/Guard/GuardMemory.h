// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The memory that a program and its guard share. It contains only an exchange.
 *
 * The memory has no name in the file system. The guard inherits it as a file descriptor, and the
 * system frees it when both processes have ended.
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
   * Makes new memory with an unused exchange, in the program. It replaces the old memory at the
   * same address, so that an earlier guard can no longer access it. On failure, returns false and
   * writes the reason to `error`.
   */
  bool Renew(std::string& error);
  /**
   * Maps the memory of an inherited file descriptor, in the guard. On failure, returns false and
   * writes the reason to `error`.
   */
  bool Adopt(int descriptor, std::string& error);

  /** Returns the file descriptor, or a negative number if there is no memory. */
  int GetDescriptor() const noexcept { return this->Descriptor; }
  HardwareExchange& GetExchange() noexcept { return *this->Exchange; }

  /**
   * Returns a text that describes the memory layout of this build. A guard with another layout does
   * not start.
   */
  static std::string GetLayout();

private:
  bool Map(int descriptor, std::string& error);
  void End() noexcept;

  int Descriptor = -1;
  void* Address = nullptr;
  HardwareExchange* Exchange = nullptr;
  bool IsOwner = false; ///< whether this is the program's process, which created the exchange
};

} // namespace VolumeHaptics

#endif
