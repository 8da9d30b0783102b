// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Reads the contents of an HDF5 file through HDF5's library, and where the samples of its
 * arrays are.
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
  std::uint64_t Skipped = 0; ///< has a bit for each filter that was not applied
};

struct Hdf5Filter
{
  static constexpr int Deflate = 1;
  static constexpr int Shuffle = 2;
  static constexpr int Checksum = 3;

  int Id = 0;
  std::size_t SampleSize = 0; ///< size of a sample (bytes); set for Shuffle only
};

/** An array of at least three dimensions; the last three are z, y and x. */
struct Hdf5Array
{
  int ScalarType = 0;         ///< VTK's type; 0 if VTK has no such type
  std::size_t SampleSize = 0; ///< size of a sample (bytes)
  bool IsBig = false;         ///< whether the most significant byte comes first
  std::vector<std::uint64_t> Shape;
  std::vector<char> FillValue;           ///< bytes of a sample that was never written
  bool IsContiguous = false;             ///< whether the samples are in one piece
  std::uint64_t Address = 0;             ///< position of that piece in the file (bytes)
  std::vector<Hdf5Filter> Filters;       ///< filters of chunks, in the order that they were applied
  std::vector<std::uint64_t> ChunkShape; ///< samples along each dimension; empty if not in chunks
};

/**
 * An open file. HDF5's library is not thread-safe: use this object on the owner's thread only, and
 * read chunks by their positions. It prints no message, and takes no lock on the file. Every fault
 * is a std::runtime_error with its cure.
 */
class Hdf5File
{
public:
  explicit Hdf5File(const std::string& name);
  ~Hdf5File();
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  [[noreturn]] static void ThrowDamaged();

  /** Returns whether there is a group or an array at a path, such as "VTKHDF/PointData". */
  bool Has(const std::string& path) const;
  /** Returns whether there is an array at a path. */
  bool HasArray(const std::string& path) const;
  /** Returns the names of the members of a group, in alphabetical order. */
  std::vector<std::string> ListMembers(const std::string& group) const;
  /**
   * Returns an attribute that is a text of fixed length; empty if it is missing or of another type.
   */
  std::string ReadText(const std::string& group, const std::string& attribute) const;
  /**
   * Returns the numbers of an attribute; empty if there is none, or if VTK has no such type of
   * numbers.
   */
  std::vector<double> ReadNumbers(const std::string& group, const std::string& attribute) const;
  Hdf5Array ReadArray(const std::string& path) const;
  /**
   * Locates the chunks of an array. x, y and z are its last three dimensions, x the last; along all
   * other dimensions, only the first chunk is located. The key of a chunk is its number among
   * `counts` chunks along x, y and z, x fastest. Chunks that were never written are left out.
   */
  std::unordered_map<std::uint64_t, Hdf5Chunk> LocateChunks(const std::string& path,
    const Hdf5Array& array, const std::array<std::uint64_t, 3>& counts) const;

private:
  struct Opened;
  std::unique_ptr<Opened> Open;
};

} // namespace VolumeHaptics

#endif
