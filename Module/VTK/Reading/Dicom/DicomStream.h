// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DicomStream_h
#define Explore_DicomStream_h

#include <cstddef>
#include <cstdint>
#include <istream>
#include <memory>
#include <string>

namespace Explore
{
constexpr std::uint32_t UNKNOWN_LENGTH = 0xffffffff;
constexpr std::uint32_t ITEM = 0xfffee000;
constexpr std::uint32_t ITEM_END = 0xfffee00d;
constexpr std::uint32_t SEQUENCE_END = 0xfffee0dd;
constexpr int DEEPEST = 16; // nesting of sequences

/// Unpacks the part of a file that deflate packed (PS3.5, section A.5), from a byte on, and keeps
/// the first `most` bytes. Returns how many bytes there are; 0 if they are damaged or cut off.
/// Takes no more memory than `most`, whatever the file promises.
std::uint64_t InflateDicom(
  const std::string& path, std::uint64_t from, std::uint64_t most, std::string& kept);

/// The elements of a DICOM file in order: tag, type of the value, length and value.
class DicomStream
{
public:
  explicit DicomStream(const std::string& path);

  /// Unpacks what follows, which deflate packed, and continues there; places then count from its
  /// beginning. Returns false if it is damaged.
  bool Inflate();

  bool IsExplicit = true;
  bool IsBig = false;

  struct Element
  {
    std::uint32_t Tag = 0;
    std::uint32_t Length = 0;
    bool IsSequence = false;
  };

  std::uint64_t Place() { return static_cast<std::uint64_t>(this->File->tellg()); }
  std::uint64_t Left();
  void GoTo(std::uint64_t place);
  std::string Read(std::size_t count);
  std::uint32_t Number(const std::string& bytes, std::size_t first, std::size_t count) const;
  /// Reads a floating-point number of 4 or 8 bytes; 0 for any other size.
  double Real(const std::string& bytes) const;
  bool Next(Element& element);
  /// Skips the value of an element, whose items may have any length.
  bool Skip(const Element& element, int depth = 0);
  /// Skips the items of compressed pixels; some writers omit the end. Returns false if an item is
  /// not complete.
  bool SkipItems();

private:
  std::string Path;
  std::unique_ptr<std::istream> File;
  std::uint64_t Length;
};
} // namespace Explore

#endif
