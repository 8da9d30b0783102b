// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A regular file, open for reading.
 */
#ifndef OpenedFile_h
#define OpenedFile_h

#include <cstddef>
#include <cstdint>
#include <string>

namespace VolumeHaptics
{

/**
 * Opens and reads a file, on several threads at once. Throws std::runtime_error, with the cure, on
 * failure.
 */
class OpenedFile
{
public:
  explicit OpenedFile(const std::string& name);
  ~OpenedFile();
  OpenedFile(const OpenedFile&) = delete;
  OpenedFile& operator=(const OpenedFile&) = delete;

  /** Reads `size` bytes at an offset. Throws if the file has fewer. */
  void Read(void* to, std::size_t size, std::int64_t from) const;
  /** Returns the size of the file (bytes). */
  std::int64_t GetSize() const;

private:
  const int Descriptor;
};

} // namespace VolumeHaptics

#endif
