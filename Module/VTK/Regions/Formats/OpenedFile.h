// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A regular file that is open to be read.
 */
#ifndef OpenedFile_h
#define OpenedFile_h

#include <cstddef>
#include <cstdint>
#include <string>

namespace VolumeHaptics
{

/** Several threads may read at once. What fails throws std::runtime_error, with the cure. */
class OpenedFile
{
public:
  explicit OpenedFile(const std::string& name);
  ~OpenedFile();
  OpenedFile(const OpenedFile&) = delete;
  OpenedFile& operator=(const OpenedFile&) = delete;

  /** All bytes, or an exception. */
  void Read(void* to, std::size_t size, std::int64_t from) const;
  /** In bytes. */
  std::int64_t GetSize() const;

private:
  const int Descriptor;
};

} // namespace VolumeHaptics

#endif
