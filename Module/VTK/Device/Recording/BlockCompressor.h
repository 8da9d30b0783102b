// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Compresses bytes in the format of VTK's XML files.
 */
#ifndef BlockCompressor_h
#define BlockCompressor_h

#include <cstddef>
#include <string>

namespace VolumeHaptics
{

class BlockCompressor
{
public:
  BlockCompressor();
  ~BlockCompressor();
  BlockCompressor(const BlockCompressor&) = delete;
  BlockCompressor& operator=(const BlockCompressor&) = delete;

  /** Appends the compressed bytes; returns their number. */
  std::size_t Compress(const void* data, std::size_t size, std::string& to);
  /** False if the block does not expand to this size. */
  bool Expand(const std::string& block, void* data, std::size_t size);

private:
  struct Library;
  Library* const Used;
};

} // namespace VolumeHaptics

#endif
