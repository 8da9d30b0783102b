// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/LargeFile.h"

#include "Core/Platform/HapticFiles.h"
#include "VTK/Base/ByteOrder.h"
#include "VTK/Regions/Formats/ChunkCodecs.h"
#include "VTK/Regions/Formats/FurtherAxes.h"
#include "VTK/Regions/Formats/OpenedFile.h"
#include "VTK/Regions/Formats/RawVolumeFile.h"
#include "VTK/Regions/Formats/WholeSamples.h"

#include "vtkAbstractArray.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <vector>

namespace VolumeHaptics
{
namespace Mgh
{
namespace
{

// Size (bytes) of the header in FreeSurfer's format. The samples follow; all numbers are
// big-endian.
constexpr std::size_t HeadSize = 284;

struct KnownType
{
  int Code;
  int ScalarType;
};
constexpr KnownType Types[] = { { 0, VTK_UNSIGNED_CHAR }, { 1, VTK_INT }, { 3, VTK_FLOAT },
  { 4, VTK_SHORT }, { 10, VTK_UNSIGNED_SHORT } };

template <typename T>
T ReadBig(const std::vector<char>& head, std::size_t at)
{
  char bytes[sizeof(T)];
  std::copy_n(&head[at], sizeof(T), bytes);
  if (IsOtherByteOrder(true))
  {
    std::reverse(std::begin(bytes), std::end(bytes));
  }
  T number;
  std::memcpy(&number, bytes, sizeof(T));
  return number;
}

/** Returns the header, decompressed if necessary; empty if the file is too short. */
std::vector<char> ReadHead(const OpenedFile& file, bool isPacked)
{
  std::vector<char> head;
  if (isPacked)
  {
    InflateFile(file, 0, HeadSize,
      [&](const char* part, std::size_t size) { head.insert(head.end(), part, part + size); });
  }
  else if (file.GetSize() >= static_cast<std::int64_t>(HeadSize))
  {
    head.resize(HeadSize);
    file.Read(head.data(), HeadSize, 0);
  }
  return head.size() == HeadSize ? head : std::vector<char>();
}

/** Sets spacing, axes and origin from the header, whose axes are right-anterior-superior. */
void Place(const std::vector<char>& head, LargeFile& file)
{
  if (ReadBig<std::int16_t>(head, 28) <= 0)
  {
    // Without a position, FreeSurfer assumes coronal slices of 1 mm around the origin.
    file.Direction = { 1, 0, 0, 0, 0, -1, 0, -1, 0 };
    file.Notes.emplace_back("the file has no position: coronal slices of 1 mm are assumed, as by "
                            "FreeSurfer");
  }
  else
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      file.Spacing[c] = ReadBig<float>(head, 30 + 4 * c);
      for (std::size_t row = 0; row < 3; ++row)
      {
        const double part = ReadBig<float>(head, 42 + 12 * c + 4 * row);
        file.Direction[3 * row + c] = row < 2 ? -part : part;
      }
      const double middle = ReadBig<float>(head, 78 + 4 * c);
      file.Origin[c] = c < 2 ? -middle : middle;
    }
    file.Notes.emplace_back("turned from right-anterior-superior to left-posterior-superior");
  }
  for (std::size_t row = 0; row < 3; ++row)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      // The header has the position of the voxel at the centre, whose index is half of the size.
      file.Origin[row] -=
        file.Direction[3 * row + c] * file.Spacing[c] * 0.5 * (file.Extent[2 * c + 1] + 1);
    }
  }
}

} // namespace
} // namespace Mgh

LargeFile OpenMgh(const std::string& name, bool mayBeWhole, int volume)
{
  using namespace Mgh;
  const OpenedFile opened(name);
  char mark[2] = {};
  opened.Read(mark, std::min<std::int64_t>(opened.GetSize(), 2), 0);
  const bool isPacked = mark[0] == '\x1f' && mark[1] == '\x8b';
  const std::vector<char> head = ReadHead(opened, isPacked);
  if (head.empty() || ReadBig<std::int32_t>(head, 0) != 1)
  {
    throw std::runtime_error("it is no file of FreeSurfer, whatever its name says. Check what the "
                             "file really is, and that the copy is complete.");
  }
  if (isPacked && !mayBeWhole)
  {
    throw std::runtime_error("its samples can't be read region by region: they are packed. Unpack "
                             "them into head.mgh: gunzip -c head.mgz > head.mgh; or read the whole "
                             "volume into memory.");
  }
  const auto type = std::find_if(std::begin(Types), std::end(Types),
    [&](const KnownType& one) { return one.Code == ReadBig<std::int32_t>(head, 20); });
  const std::int32_t frames = ReadBig<std::int32_t>(head, 16);
  LargeFile file;
  bool isSized = frames > 0;
  double count = frames;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::int32_t size = ReadBig<std::int32_t>(head, 4 + 4 * axis);
    isSized = isSized && size > 0;
    count *= size;
    file.Extent[2 * axis + 1] = std::max(size, 1) - 1;
  }
  if (type == std::end(Types) || !isSized)
  {
    throw std::runtime_error(
      "its header has a size that is no whole number above 0, or a type that "
      "FreeSurfer does not have. Write it again: mri_convert in.mgz out.mgz.");
  }
  file.ScalarType = type->ScalarType;
  Place(head, file);
  RawVolumeFile samples;
  samples.Name = MakeAbsolute(name);
  samples.Extent = file.Extent;
  samples.SampleSize = static_cast<std::size_t>(vtkAbstractArray::GetDataTypeSize(file.ScalarType));
  samples.IsSwapped = IsOtherByteOrder(true);
  const std::size_t headSamples = HeadSize / samples.SampleSize; // an integer for all sample types
  if (!isPacked &&
    static_cast<double>(opened.GetSize()) <
      static_cast<double>(HeadSize) + count * static_cast<double>(samples.SampleSize))
  {
    throw std::runtime_error(DescribeMissingSamples(name));
  }
  const std::size_t chosen =
    ChooseVolume({ { "frame", static_cast<std::size_t>(frames) } }, volume, file).front();
  const double first = static_cast<double>(chosen) * CountSamples(file.Extent);
  if (!isPacked)
  {
    samples.HeaderSize = HeadSize;
    samples.First = static_cast<std::int64_t>(first);
    file.Read = [samples](const int box[6], void* to)
    {
      samples.Read(box, to);
      return true;
    };
    return file;
  }
  const auto whole = std::make_shared<WholeSamples>();
  whole->Files = { samples.Name };
  whole->Encoding = WholeSamples::Packed;
  whole->ScalarType = file.ScalarType;
  whole->Count = static_cast<double>(headSamples) + count;
  whole->First = headSamples + static_cast<std::size_t>(first);
  std::size_t step = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    whole->Size[axis] = static_cast<std::size_t>(file.Extent[2 * axis + 1]) + 1;
    whole->Steps[axis] = step;
    step *= whole->Size[axis];
  }
  whole->Check();
  file.Read = [whole, samples](const int box[6], void* to)
  {
    samples.ReadWith([&whole](void* part, std::size_t size, std::int64_t from)
      { whole->Copy(part, size, static_cast<std::size_t>(from)); },
      box, to);
    return true;
  };
  return file;
}

} // namespace VolumeHaptics
