// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Samples that can't be read in boxes, because they are compressed, text, or in several files.
 */
#ifndef WholeSamples_h
#define WholeSamples_h

#include <array>
#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/**
 * Holds a volume of some files, which are read when the first sample is requested. Samples that do
 * not belong to the volume, such as other layers, are left out, because there may be thousands of
 * times more of them.
 */
class WholeSamples
{
public:
  enum EncodingType
  {
    Raw,
    Packed, ///< packed by zlib or gzip
    Text
  };

  std::vector<std::string> Files; ///< names of the files, in the order of their samples
  EncodingType Encoding = Raw;
  std::size_t Offset = 0; ///< number of bytes in each file before its samples; -1: the samples are
                          ///< at the end of the file
  int ScalarType = 0;
  double Count = 0.0;                 ///< number of samples in all files
  std::size_t First = 0;              ///< number of samples before the first one of the volume
  std::array<std::size_t, 3> Size{};  ///< number of the volume's samples along x, y and z
  std::array<std::size_t, 3> Steps{}; ///< distances between neighbours (samples), which increase

  /**
   * Checks that the files can contain this number of samples before memory is allocated for them.
   * Throws std::runtime_error, with the cure.
   */
  void Check() const;

  /**
   * Copies `size` bytes of the volume, x fastest and z slowest, from an offset. Several threads may
   * call it at once. Throws std::runtime_error, with the cure.
   */
  void Copy(void* to, std::size_t size, std::size_t from);

private:
  class Volume;

  void Load();
  /** Reads `size` bytes of samples from one file. */
  void LoadFile(const std::string& name, std::size_t size, Volume& volume) const;

  std::mutex Mutex;
  std::vector<char> Bytes;
};

/** Returns the end of an error for a file that ends before its last voxel, with the cure. */
std::string DescribeMissingSamples(const std::string& file);

} // namespace VolumeHaptics

#endif
