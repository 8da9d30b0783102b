// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The memory that a program and its guard share: an exchange only.
 *
 * It has no name in the file system. The guard inherits it as a file descriptor, and it disappears
 * with the last of the two processes.
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
   * Makes new memory with an unused exchange, for the program. The new memory replaces the old one,
   * at the same address, so that an earlier guard no longer reaches it. If this fails, returns
   * false and writes the reason to `error`.
   */
  bool Renew(std::string& error);
  /**
   * Maps the memory behind an inherited file descriptor, for the guard. If this fails, returns
   * false and writes the reason to `error`.
   */
  bool Adopt(int descriptor, std::string& error);

  /** Returns the file descriptor; negative if there is no memory. */
  int GetDescriptor() const noexcept { return this->Descriptor; }
  HardwareExchange& GetExchange() noexcept { return *this->Exchange; }

  /** Returns the layout of the memory in this build. A guard with another layout does not start. */
  static std::string GetLayout();

private:
  bool Map(int descriptor, std::string& error);
  void End() noexcept;

  int Descriptor = -1;
  void* Address = nullptr;
  HardwareExchange* Exchange = nullptr;
  bool IsOwner = false; ///< whether this is the program, which made the exchange
};

} // namespace VolumeHaptics

#endif
