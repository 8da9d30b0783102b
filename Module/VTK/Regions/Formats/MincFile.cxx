// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/LargeFile.h"

#include "Core/Platform/HapticFiles.h"
#include "VTK/Base/ByteOrder.h"
#include "VTK/Base/LengthUnit.h"
#include "VTK/Regions/Formats/FurtherAxes.h"
#include "VTK/Regions/Formats/OpenedFile.h"
#include "VTK/Regions/Formats/RawVolumeFile.h"
#include "VTK/Regions/Formats/WholeSamples.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <vector>

namespace VolumeHaptics
{
namespace Minc
{
namespace
{

/** Number types of NetCDF's classic format. */
enum NetCdfType
{
  Byte = 1,
  Text,
  Short,
  Int,
  Float,
  Double
};

constexpr std::size_t SizeOf(int type)
{
  return type == Short ? 2 : type == Int || type == Float ? 4 : type == Double ? 8 : 1;
}

struct Attribute
{
  std::string Words;
  std::vector<double> Numbers;
};

using Attributes = std::map<std::string, Attribute>;

struct Variable
{
  std::vector<std::size_t> Dimensions; ///< indices of its dimensions, slowest first
  Attributes Facts;
  int Type = 0;
  std::int64_t Place = 0; ///< offset (bytes) of its first number in the file
};

[[noreturn]] void ThrowDamaged()
{
  throw std::runtime_error("its header is damaged or cut off. Check that the copy is complete.");
}

template <typename T>
double ReadBig(const char* at)
{
  char bytes[sizeof(T)];
  std::copy_n(at, sizeof(T), bytes);
  if (IsOtherByteOrder(true))
  {
    std::reverse(bytes, bytes + sizeof(T));
  }
  T number;
  std::memcpy(&number, bytes, sizeof(T));
  return static_cast<double>(number);
}

double ReadNumber(const char* at, int type)
{
  return type == Short ? ReadBig<std::int16_t>(at)
    : type == Int      ? ReadBig<std::int32_t>(at)
    : type == Float    ? ReadBig<float>(at)
    : type == Double   ? ReadBig<double>(at)
                       : ReadBig<std::int8_t>(at);
}

/** Parses the header of a NetCDF file in the classic format, whose numbers are big-endian. */
class NetCdfHead
{
public:
  explicit NetCdfHead(const OpenedFile& file)
  {
    constexpr std::int64_t most = 4 << 20;
    this->Bytes.resize(static_cast<std::size_t>(std::min(file.GetSize(), most)));
    file.Read(this->Bytes.data(), this->Bytes.size(), 0);
    const std::string mark(this->Take(4), 4);
    if (mark == "\x89HDF")
    {
      throw std::runtime_error(
        "it is MINC 2, in HDF5, which is not supported. Turn it into MINC 1: "
        "mincconvert in.mnc out.mnc; or into NIfTI: mnc2nii in.mnc out.nii.");
    }
    this->IsLong = mark == std::string("CDF\2");
    if (!this->IsLong && mark != std::string("CDF\1"))
    {
      throw std::runtime_error("it is no MINC file, whatever its name says. Check what the file "
                               "really is, and that the copy is complete.");
    }
    this->TakeCount(); // skip the number of records
    this->TakeList(
      [&]
      {
        const std::string name = this->TakeName();
        this->Dimensions.emplace_back(name, this->TakeCount());
      });
    this->TakeAttributes();
    this->TakeList([&] { this->TakeVariable(); });
  }

  std::vector<std::pair<std::string, std::size_t>> Dimensions; ///< names, sizes; 0: records
  std::map<std::string, Variable> Variables;

private:
  const char* Take(std::size_t size)
  {
    if (size > this->Bytes.size() - this->At)
    {
      ThrowDamaged();
    }
    this->At += size;
    return this->Bytes.data() + this->At - size;
  }
  std::size_t TakeCount()
  {
    const double count = ReadBig<std::int32_t>(this->Take(4));
    return static_cast<std::size_t>(std::max(count, 0.0)); // -1 stands for an unknown number of
                                                           // records
  }
  /** Returns the next bytes and skips the padding to a multiple of four. */
  const char* TakePadded(std::size_t size)
  {
    const char* const begin = this->Take(size);
    this->Take((4 - size % 4) % 4);
    return begin;
  }
  std::string TakeName()
  {
    const std::size_t size = this->TakeCount();
    return { this->TakePadded(size), size };
  }
  template <typename TakeOne>
  void TakeList(TakeOne&& take)
  {
    this->TakeCount(); // skip the tag of the list
    for (std::size_t left = this->TakeCount(); left > 0; --left)
    {
      take();
    }
  }
  Attributes TakeAttributes()
  {
    Attributes all;
    this->TakeList(
      [&]
      {
        Attribute& one = all[this->TakeName()];
        const auto type = static_cast<int>(this->TakeCount());
        const std::size_t count = this->TakeCount();
        const char* const begin = this->TakePadded(count * SizeOf(type));
        if (type == Text)
        {
          one.Words.assign(begin, count);
          return;
        }
        for (std::size_t i = 0; i < count; ++i)
        {
          one.Numbers.push_back(ReadNumber(begin + i * SizeOf(type), type));
        }
      });
    return all;
  }
  void TakeVariable()
  {
    Variable& one = this->Variables[this->TakeName()];
    one = {};
    for (std::size_t left = this->TakeCount(); left > 0; --left)
    {
      one.Dimensions.push_back(this->TakeCount());
      if (one.Dimensions.back() >= this->Dimensions.size())
      {
        ThrowDamaged();
      }
    }
    one.Facts = this->TakeAttributes();
    one.Type = static_cast<int>(this->TakeCount());
    this->TakeCount(); // skip its size, which follows from the dimensions
    one.Place = static_cast<std::int64_t>(
      this->IsLong ? ReadBig<std::int64_t>(this->Take(8)) : ReadBig<std::int32_t>(this->Take(4)));
  }

  std::vector<char> Bytes;
  std::size_t At = 0;
  bool IsLong = false; ///< whether offsets have eight bytes
};

/** Returns the first number of an attribute; `other` if there is none. */
double NumberOr(const Attributes& facts, const char* name, double other)
{
  const auto found = facts.find(name);
  return found != facts.end() && !found->second.Numbers.empty() ? found->second.Numbers.front()
                                                                : other;
}

std::string WordsOf(const Attributes& facts, const char* name)
{
  const auto found = facts.find(name);
  return found != facts.end() ? found->second.Words.c_str() : std::string();
}

/**
 * The image variable of a file, whose dimensions are spatial axes and further axes, such as time.
 */
struct MincImage
{
  const Variable* Image = nullptr;
  std::vector<std::size_t> Sizes; ///< size of each dimension, slowest first
  std::vector<std::size_t> Steps; ///< distance (samples) of neighbours along each dimension
  std::vector<int> Axes;          ///< index axis of each dimension: 0, 1 or 2; -1 if it is not
                                  ///< spatial
  std::vector<FurtherAxis> Further;
};

MincImage FindImage(const NetCdfHead& head)
{
  MincImage image;
  const auto found = head.Variables.find("image");
  const int type = found != head.Variables.end() ? found->second.Type : Text;
  if (type < Byte || type == Text || type > Double)
  {
    throw std::runtime_error("it has no image, and is no MINC file. Give a file of a volume.");
  }
  image.Image = &found->second;
  int axis = 3;
  double step = 1.0;
  const std::vector<std::size_t>& dimensions = image.Image->Dimensions;
  for (const std::size_t dimension : dimensions)
  {
    const auto& [name, size] = head.Dimensions[dimension];
    const bool isOfSpace = name == "xspace" || name == "yspace" || name == "zspace";
    if (size == 0 || size > std::size_t{ std::numeric_limits<int>::max() })
    {
      throw std::runtime_error("its slices are records, whose number is open. Write it with fixed "
                               "dimensions: mincconvert in.mnc out.mnc.");
    }
    image.Sizes.push_back(size);
    image.Axes.push_back(isOfSpace ? --axis : -1);
    if (!isOfSpace)
    {
      image.Further.push_back({ name == "vector_dimension" ? "component" : Printable(name), size });
    }
  }
  image.Steps.assign(image.Sizes.size(), 1);
  for (std::size_t d = image.Sizes.size(); d-- > 0;)
  {
    image.Steps[d] = static_cast<std::size_t>(step);
    step *= static_cast<double>(image.Sizes[d]);
    if (step > 1e15)
    {
      ThrowDamaged();
    }
  }
  const auto times = [&](const char* name)
  {
    return std::count_if(dimensions.begin(), dimensions.end(),
      [&](std::size_t dimension) { return head.Dimensions[dimension].first == name; });
  };
  if (times("xspace") != 1 || times("yspace") != 1 || times("zspace") != 1)
  {
    throw std::runtime_error("its image does not have the dimensions xspace, yspace and zspace. "
                             "Write a volume in space.");
  }
  return image;
}

/** Sets spacing, axes and origin from the header, whose axes are right-anterior-superior. */
void Place(const NetCdfHead& head, const MincImage& image, LargeFile& file)
{
  for (std::size_t d = 0; d < image.Sizes.size(); ++d)
  {
    if (image.Axes[d] < 0)
    {
      continue;
    }
    const std::string& name = head.Dimensions[image.Image->Dimensions[d]].first;
    const auto found = head.Variables.find(name);
    const Attributes facts = found != head.Variables.end() ? found->second.Facts : Attributes();
    if (WordsOf(facts, "spacing").rfind("irregular", 0) == 0)
    {
      throw std::runtime_error("its slices along " + name +
        " are unevenly spaced. Resample it: "
        "mincresample in.mnc out.mnc.");
    }
    const auto axis = static_cast<std::size_t>(image.Axes[d]);
    std::array<double, 3> way{ name == "xspace" ? 1.0 : 0.0, name == "yspace" ? 1.0 : 0.0,
      name == "zspace" ? 1.0 : 0.0 };
    const auto cosines = facts.find("direction_cosines");
    if (cosines != facts.end() && cosines->second.Numbers.size() == 3)
    {
      std::copy_n(cosines->second.Numbers.begin(), 3, way.begin());
    }
    const double unit = MillimetresPerUnit(WordsOf(facts, "units"));
    const double scale = unit > 0.0 ? unit : 1.0;
    const double step = scale * NumberOr(facts, "step", 1.0);
    const double start = scale * NumberOr(facts, "start", 0.0);
    if (facts.count("step") == 0)
    {
      file.Notes.push_back("no step along " + name + ": voxels of 1 mm are assumed");
    }
    if (scale != 1.0)
    {
      file.Notes.push_back("lengths along " + name + " turned from " +
        Printable(WordsOf(facts, "units")) + " into mm");
    }
    file.Extent[2 * axis + 1] = static_cast<int>(image.Sizes[d]) - 1;
    const double length = std::hypot(way[0], way[1], way[2]);
    file.Spacing[axis] = std::abs(step) * length;
    for (std::size_t row = 0; row < 3; ++row)
    {
      const double side = row < 2 ? -1.0 : 1.0; // to left-posterior-superior
      file.Direction[3 * row + axis] = side * (step < 0.0 ? -way[row] : way[row]) / length;
      file.Origin[row] += side * way[row] * start;
    }
  }
  file.Notes.emplace_back("turned from right-anterior-superior to left-posterior-superior");
}

/** Converts stored integers to values: by one slope and intercept, or by one pair per slice. */
struct MincScale
{
  std::vector<std::pair<double, double>> Lines; ///< slope and intercept
  std::array<std::size_t, 3> Steps{};           ///< number of lines to skip per voxel along x, y
                                                ///< and z
  std::size_t First = 0;                        ///< line of the first voxel
  double Range[2] = { 0.0, 0.0 };               ///< smallest and largest valid stored number
};

/** Reads the variable image-min or image-max. */
std::vector<double> ReadLimits(
  const OpenedFile& file, const NetCdfHead& head, const MincImage& image, const char* name)
{
  const auto found = head.Variables.find(name);
  if (found == head.Variables.end())
  {
    throw std::runtime_error(std::string("it has no ") + name +
      ", without which its numbers have no scale. Write it again: mincconvert in.mnc out.mnc.");
  }
  const Variable& limits = found->second;
  const std::vector<std::size_t>& dimensions = image.Image->Dimensions;
  std::size_t count = 1;
  constexpr std::size_t most = 1 << 24;
  for (std::size_t d = 0; d < limits.Dimensions.size(); ++d)
  {
    if (d >= dimensions.size() || limits.Dimensions[d] != dimensions[d] ||
      image.Sizes[d] > most / count)
    {
      throw std::runtime_error(std::string("the dimensions of its ") + name +
        " are not the slowest ones of its image. Write it again: mincconvert in.mnc out.mnc.");
    }
    count *= image.Sizes[d];
  }
  if (count * SizeOf(limits.Type) > static_cast<std::size_t>(file.GetSize()))
  {
    ThrowDamaged();
  }
  std::vector<char> bytes(count * SizeOf(limits.Type));
  file.Read(bytes.data(), bytes.size(), limits.Place);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i)
  {
    numbers.push_back(ReadNumber(&bytes[i * SizeOf(limits.Type)], limits.Type));
  }
  return numbers;
}

MincScale ReadScale(const OpenedFile& file, const NetCdfHead& head, const MincImage& image,
  bool isSigned, const std::vector<std::size_t>& chosen)
{
  MincScale scale;
  const Attributes& facts = image.Image->Facts;
  const double bits = 8.0 * static_cast<double>(SizeOf(image.Image->Type));
  const double lowest = isSigned ? -std::exp2(bits - 1.0) : 0.0;
  const double highest = std::exp2(isSigned ? bits - 1.0 : bits) - 1.0;
  const auto range = facts.find("valid_range");
  const bool isRange = range != facts.end() && range->second.Numbers.size() == 2;
  scale.Range[0] = isRange ? range->second.Numbers[0] : NumberOr(facts, "valid_min", lowest);
  scale.Range[1] = isRange ? range->second.Numbers[1] : NumberOr(facts, "valid_max", highest);
  if (!(scale.Range[0] < scale.Range[1]) || scale.Range[0] < lowest || scale.Range[1] > highest)
  {
    throw std::runtime_error("its valid range is not one of its type of numbers. Write it again: "
                             "mincconvert in.mnc out.mnc.");
  }
  const std::vector<double> low = ReadLimits(file, head, image, "image-min");
  const std::vector<double> high = ReadLimits(file, head, image, "image-max");
  if (low.size() != high.size())
  {
    ThrowDamaged();
  }
  for (std::size_t i = 0; i < low.size(); ++i)
  {
    const double slope = (high[i] - low[i]) / (scale.Range[1] - scale.Range[0]);
    scale.Lines.emplace_back(slope, low[i] - scale.Range[0] * slope);
  }
  std::size_t left = low.size();
  std::size_t further = 0;
  for (std::size_t d = 0; d < image.Sizes.size() && left > 1; ++d)
  {
    left /= image.Sizes[d];
    if (image.Axes[d] >= 0)
    {
      scale.Steps[static_cast<std::size_t>(image.Axes[d])] = left;
    }
    else
    {
      scale.First += left * chosen[further++];
    }
  }
  return scale;
}

template <typename T>
void ScaleBox(const std::vector<char>& stored, const MincScale& scale, const int box[6], float* to)
{
  const char* from = stored.data();
  for (int z = box[4]; z <= box[5]; ++z)
  {
    for (int y = box[2]; y <= box[3]; ++y)
    {
      for (int x = box[0]; x <= box[1]; ++x, from += sizeof(T))
      {
        T number;
        std::memcpy(&number, from, sizeof(T));
        const auto& [slope, intercept] =
          scale.Lines[scale.First + static_cast<std::size_t>(x) * scale.Steps[0] +
            static_cast<std::size_t>(y) * scale.Steps[1] +
            static_cast<std::size_t>(z) * scale.Steps[2]];
        const double valid =
          std::clamp(static_cast<double>(number), scale.Range[0], scale.Range[1]);
        *to++ = static_cast<float>(slope * valid + intercept);
      }
    }
  }
}

} // namespace
} // namespace Minc

LargeFile OpenMinc(const std::string& name, bool, int volume)
{
  using namespace Minc;
  const OpenedFile opened(name);
  const NetCdfHead head(opened);
  const MincImage image = FindImage(head);
  const int type = image.Image->Type;
  const std::string sign = WordsOf(image.Image->Facts, "signtype");
  const bool isSigned = sign.empty() ? type != Byte : sign.rfind("unsigned", 0) != 0;
  LargeFile file;
  Place(head, image, file);
  RawVolumeFile samples;
  samples.Name = MakeAbsolute(name);
  samples.Extent = file.Extent;
  samples.SampleSize = SizeOf(type);
  samples.HeaderSize = image.Image->Place;
  samples.IsSwapped = IsOtherByteOrder(true);
  const std::vector<std::size_t> chosen = ChooseVolume(image.Further, volume, file);
  std::size_t further = 0;
  for (std::size_t d = 0; d < image.Sizes.size(); ++d)
  {
    const auto step = static_cast<std::int64_t>(image.Steps[d]);
    if (image.Axes[d] >= 0)
    {
      samples.Steps[static_cast<std::size_t>(image.Axes[d])] = step;
    }
    else
    {
      samples.First += step * static_cast<std::int64_t>(chosen[further++]);
    }
  }
  const double count =
    static_cast<double>(image.Steps.front()) * static_cast<double>(image.Sizes.front());
  if (image.Image->Place < 0 ||
    static_cast<double>(opened.GetSize()) <
      static_cast<double>(image.Image->Place) + count * static_cast<double>(samples.SampleSize))
  {
    throw std::runtime_error(DescribeMissingSamples(name));
  }
  if (type == Float || type == Double)
  {
    file.ScalarType = type == Float ? VTK_FLOAT : VTK_DOUBLE;
    file.Read = [samples](const int box[6], void* to)
    {
      samples.Read(box, to);
      return true;
    };
    return file;
  }
  const auto scale =
    std::make_shared<const MincScale>(ReadScale(opened, head, image, isSigned, chosen));
  file.ScalarType = VTK_FLOAT;
  file.Read = [samples, scale, isSigned](const int box[6], void* to)
  {
    std::size_t size = samples.SampleSize;
    for (int a = 0; a < 6; a += 2)
    {
      size *= static_cast<std::size_t>(box[a + 1] - box[a] + 1);
    }
    std::vector<char> stored(size);
    samples.Read(box, stored.data());
    auto* const values = static_cast<float*>(to);
    switch (samples.SampleSize)
    {
      case 1:
        isSigned ? ScaleBox<std::int8_t>(stored, *scale, box, values)
                 : ScaleBox<std::uint8_t>(stored, *scale, box, values);
        break;
      case 2:
        isSigned ? ScaleBox<std::int16_t>(stored, *scale, box, values)
                 : ScaleBox<std::uint16_t>(stored, *scale, box, values);
        break;
      default:
        isSigned ? ScaleBox<std::int32_t>(stored, *scale, box, values)
                 : ScaleBox<std::uint32_t>(stored, *scale, box, values);
        break;
    }
    return true;
  };
  return file;
}

} // namespace VolumeHaptics
