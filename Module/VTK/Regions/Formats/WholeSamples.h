// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads samples that can't be read in boxes: compressed samples, text, or several files.
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
 * Contains a volume from one or several files, which are read when the first sample is requested.
 * Only samples of the volume are kept, not for example those of other layers, because there may be
 * thousands of times more of them.
 */
class WholeSamples
{
public:
  enum EncodingType
  {
    Raw,
    Packed, ///< compressed by zlib or gzip
    Text
  };

  std::vector<std::string> Files; ///< files in the order of their samples
  EncodingType Encoding = Raw;
  std::size_t Offset = 0; ///< bytes in each file before its samples; -1: the samples are at the end
                          ///< of the file
  int ScalarType = 0;
  double Count = 0.0;                 ///< number of samples in all files
  std::size_t First = 0;              ///< samples before the first one of the volume
  std::array<std::size_t, 3> Size{};  ///< samples of the volume along x, y and z
  std::array<std::size_t, 3> Steps{}; ///< ascending distances (samples) between neighbours along x,
                                      ///< y and z

  /**
   * Checks, before memory is allocated, that the files can contain this number of samples. Throws
   * std::runtime_error, with the cure, otherwise.
   */
  void Check() const;

  /**
   * Copies `size` bytes of the volume (x fastest, z slowest) from an offset. Safe on several
   * threads at once. Throws std::runtime_error, with the cure.
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

/** Returns the end of an error text, with the cure, for a file that ends before its last voxel. */
std::string DescribeMissingSamples(const std::string& file);

} // namespace VolumeHaptics

#endif
