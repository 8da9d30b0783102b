// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the contents of an HDF5 file through HDF5's library, and locates the samples of its arrays.
 */
#ifndef Hdf5File_h
#define Hdf5File_h

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace VolumeHaptics
{

/** Position of a chunk's bytes in the file. */
struct Hdf5Chunk
{
  std::uint64_t Address = 0;
  std::uint64_t Size = 0;    ///< number of bytes
  std::uint64_t Skipped = 0; ///< bit mask of the filters that were not applied
};

struct Hdf5Filter
{
  static constexpr int Deflate = 1;
  static constexpr int Shuffle = 2;
  static constexpr int Checksum = 3;

  int Id = 0;
  std::size_t SampleSize = 0; ///< bytes per sample; used only for Shuffle
};

/** An array with at least three dimensions, the last three of which are z, y and x. */
struct Hdf5Array
{
  int ScalarType = 0;         ///< VTK type; 0 if VTK has no such type
  std::size_t SampleSize = 0; ///< bytes per sample
  bool IsBig = false;         ///< whether samples are big-endian
  std::vector<std::uint64_t> Shape;
  std::vector<char> FillValue;           ///< bytes of a sample that was never written
  bool IsContiguous = false;             ///< whether the samples are stored in one piece instead of
                                         ///< chunks
  std::uint64_t Address = 0;             ///< offset (bytes) of that piece in the file
  std::vector<Hdf5Filter> Filters;       ///< filters of chunks, in the order in which they were
                                         ///< applied
  std::vector<std::uint64_t> ChunkShape; ///< samples along each dimension; empty without chunks
};

/**
 * An open HDF5 file. HDF5's library is not thread-safe: use this object on the owner's thread only,
 * and read chunks by their positions. Suppresses the library's messages and takes no lock on the
 * file. Throws std::runtime_error, with the cure, for every fault.
 */
class Hdf5File
{
public:
  explicit Hdf5File(const std::string& name);
  ~Hdf5File();
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  [[noreturn]] static void ThrowDamaged();

  /** Returns whether a group or an array exists at a path, such as "VTKHDF/PointData". */
  bool Has(const std::string& path) const;
  /** Returns whether there is an array at a path. */
  bool HasArray(const std::string& path) const;
  /** Returns the names of the members of a group, in alphabetical order. */
  std::vector<std::string> ListMembers(const std::string& group) const;
  /** Returns a text attribute of fixed length; empty if it is missing or of another type. */
  std::string ReadText(const std::string& group, const std::string& attribute) const;
  /**
   * Returns the numbers of an attribute; empty if it is missing or if VTK does not have its type.
   */
  std::vector<double> ReadNumbers(const std::string& group, const std::string& attribute) const;
  Hdf5Array ReadArray(const std::string& path) const;
  /**
   * Locates the chunks of an array along its last three dimensions z, y and x; along all other
   * dimensions, locates only the first chunk. The key of a chunk is its index among `counts` chunks
   * along x, y and z, x fastest. Omits chunks that were never written.
   */
  std::unordered_map<std::uint64_t, Hdf5Chunk> LocateChunks(const std::string& path,
    const Hdf5Array& array, const std::array<std::uint64_t, 3>& counts) const;

private:
  struct Opened;
  std::unique_ptr<Opened> Open;
};

} // namespace VolumeHaptics

#endif
