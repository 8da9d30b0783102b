// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Volume/DicomFolder.h"

#include "Applications/Explorer/Errors/InputError.h"
#include "Applications/Explorer/Volume/DicomPixels.h"
#include "Applications/Explorer/Volume/DicomSeries.h"
#include "Applications/Explorer/Volume/DicomUnpacking.h"
#include "Applications/Explorer/Volume/SliceGeometry.h"
#include "Applications/Explorer/Volume/VolumeOrientation.h"
#include "VTK/Base/ArrayMemory.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPointData.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>
#include <vector>

namespace
{
using Explore::DicomHeader;
using Explore::DicomSeries;
using Explore::InputError;
using Explore::Volume;

std::string NameOf(const DicomHeader& slice)
{
  return vtksys::SystemTools::GetFilenameName(slice.File);
}

/// One line per series.
std::string ListSeries(const std::vector<DicomSeries>& all)
{
  std::string list;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    list += "\n    " + all[i].Describe(i + 1);
  }
  return list;
}

void CheckSlices(const std::string& path, const std::vector<DicomHeader>& slices)
{
  for (const DicomHeader& slice : slices)
  {
    // A slice that is deflated as a whole has no readable size.
    if (!slice.IsPlain() && (!Explore::CanUnpackDicom() || slice.Width == 0))
    {
      throw InputError(path,
        "holds compressed DICOM slices (" + NameOf(slice) + "), which this build can't unpack",
        "build it with GDCM (package libgdcm-dev), or unpack them, e.g. with gdcmconv --raw "
        "(package libgdcm-tools) or dcmdjpeg (dcmtk)");
    }
    if (!slice.HasPlaces)
    {
      throw InputError(path,
        "holds a DICOM file with " + std::to_string(slice.Frames) + " frames (" + NameOf(slice) +
          "), and does not tell where they are: is it a film?",
        "turn it into NIfTI, e.g. with dcm2niix (package dcm2niix)");
    }
    if (!(slice.Spacing[0] > 0.0) || !(slice.Spacing[1] > 0.0))
    {
      throw InputError(path, "gives no distance of its pixels (PixelSpacing) in " + NameOf(slice),
        "export it again from where it was made, with its PixelSpacing");
    }
    if (!slice.IsWhole)
    {
      throw InputError(path, "holds a damaged or cut-off slice (" + NameOf(slice) + ")",
        "copy or export the series again, or take that file away");
    }
  }
}

/// The median distance (mm) between slices.
double ComputeStep(const std::vector<DicomHeader>& slices)
{
  std::vector<double> steps;
  for (std::size_t i = 1; i < slices.size(); ++i)
  {
    steps.push_back(slices[i].Along - slices[i - 1].Along);
  }
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

/// The slices without those that lie far from most of them, such as a topogram with the number of
/// the series.
std::vector<DicomHeader> LeaveOutFar(const std::vector<DicomHeader>& slices, Volume& volume)
{
  if (slices.size() < 3)
  {
    return slices;
  }
  constexpr double farSteps = 8.0;
  constexpr std::size_t fewest = 5;                                  // slices of a volume
  const double far = std::max(farSteps * ComputeStep(slices), 10.0); // mm
  std::size_t first = 0, best = 0, size = 0;
  for (std::size_t i = 1; i <= slices.size(); ++i)
  {
    if (i == slices.size() || slices[i].Along - slices[i - 1].Along > far)
    {
      if (i - first > size)
      {
        best = first;
        size = i - first;
      }
      first = i;
    }
  }
  const std::size_t others = slices.size() - size;
  if (others == 0 || others >= fewest || size < fewest)
  {
    return slices;
  }
  std::ostringstream note;
  note << others << (others == 1 ? " slice lies" : " slices lie") << " far from the others ("
       << NameOf(slices[best > 0 ? 0 : size]) << "), and " << (others == 1 ? "is" : "are")
       << " left out";
  volume.Notes.push_back(note.str());
  const auto begin = slices.begin() + static_cast<std::ptrdiff_t>(best);
  return { begin, begin + static_cast<std::ptrdiff_t>(size) };
}

[[noreturn]] void ThrowSeveral(const std::string& path, const std::string& fault)
{
  throw InputError(path, fault + ": several volumes in one series",
    "put the slices of one volume into a folder of their own; if it moves, each phase");
}

/// The positions (mm) of slices along their normal, from the first one on: even if they are so
/// within the rounding of files. Throws if two slices are at the same place.
std::vector<double> FindPlaces(
  const std::string& path, const std::vector<DicomHeader>& slices, Volume& volume)
{
  const std::size_t count = slices.size();
  std::vector<double> along;
  double smallest = VTK_DOUBLE_MAX, largest = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    along.push_back(slices[i].Along - slices.front().Along);
    if (i > 0)
    {
      smallest = std::min(smallest, along[i] - along[i - 1]);
      largest = std::max(largest, along[i] - along[i - 1]);
    }
  }
  if (count > 1 && smallest < 1e-4)
  {
    ThrowSeveral(path, "has two slices at the same place");
  }
  const double even = count > 1 ? along.back() / static_cast<double>(count - 1) : 0.0;
  double off = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    off = std::max(off, std::abs(along[i] - static_cast<double>(i) * even));
  }
  constexpr double rounding = 0.11; // mm: positions with one digit, and so the ends of the line
  constexpr double smallPart = 0.05;
  constexpr double finest = 0.25; // of a step
  if (off <= std::max(std::min(rounding, finest * even), smallPart * even))
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      along[i] = static_cast<double>(i) * even;
    }
    return along;
  }
  const double step = ComputeStep(slices);
  constexpr double closest = 0.2; // of a step
  constexpr double mostGap = 20.0;
  if (smallest < closest * step || largest > mostGap * step)
  {
    std::ostringstream fault;
    fault << "has slices " << smallest << " to " << largest << " mm apart";
    ThrowSeveral(path, fault.str());
  }
  int missing = 0;
  double rest = 0.0;
  for (std::size_t i = 1; i < count; ++i)
  {
    const double steps = (along[i] - along[i - 1]) / step;
    missing += static_cast<int>(std::round(steps)) - 1;
    rest = std::max(rest, std::abs(steps - std::round(steps)));
  }
  std::ostringstream note;
  if (missing > 0 && rest < 2.0 * smallPart)
  {
    // Within the rounding of files, the others are at whole steps.
    const double length = along.back();
    const double steps = static_cast<double>(count - 1) + missing;
    for (double& place : along)
    {
      place = std::round(place / length * steps) * length / steps;
    }
    note << missing << (missing == 1 ? " slice is" : " slices are") << " missing: gaps of up to "
         << largest << " mm are filled from the slices beside them";
  }
  else
  {
    note << "slices are unevenly spaced (" << smallest << " to " << largest
         << " mm): resampled to the smallest distance";
  }
  volume.Notes.push_back(note.str());
  return along;
}

/// Throws unless the first pixels of all slices are on one line.
void CheckLine(const std::string& path, const std::vector<DicomHeader>& slices)
{
  const DicomHeader& first = slices.front();
  const DicomHeader& last = slices.back();
  double off = 0.0;
  for (const DicomHeader& slice : slices)
  {
    const double part = (slice.Along - first.Along) / std::max(1e-6, last.Along - first.Along);
    double distance = 0.0;
    for (int row = 0; row < 3; ++row)
    {
      const double there = first.Position[row] + part * (last.Position[row] - first.Position[row]);
      distance += std::pow(slice.Position[row] - there, 2);
    }
    off = std::max(off, std::sqrt(distance));
  }
  const double pixel = std::max(first.Spacing[0], first.Spacing[1]);
  if (off > std::max(std::min(0.2, 2.0 * pixel), 0.5 * pixel))
  {
    std::ostringstream fault;
    fault << "has slices that are shifted against each other in their planes, by up to " << off
          << " mm";
    throw InputError(path, fault.str(),
      "resample it to straight slices, e.g. by 3D Slicer's acquisition geometry regularization");
  }
}

struct ValueRange
{
  double Low = 0.0;
  double High = 0.0;
  bool AreWhole = true;
};

/// The possible values of the samples of all slices.
ValueRange ComputeValues(const std::vector<DicomHeader>& slices)
{
  ValueRange range;
  for (const DicomHeader& slice : slices)
  {
    const double count = std::pow(2.0, slice.Stored);
    for (const double sample :
      { slice.IsSigned ? -0.5 * count : 0.0, (slice.IsSigned ? 0.5 * count : count) - 1.0 })
    {
      const double value = slice.Slope * sample + slice.Intercept;
      range.Low = std::min(range.Low, value);
      range.High = std::max(range.High, value);
    }
    range.AreWhole = range.AreWhole && slice.Slope == std::round(slice.Slope) &&
      slice.Intercept == std::round(slice.Intercept);
  }
  return range;
}

/// The smallest type that holds all values of a range.
int ChooseType(const ValueRange& range)
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT })
  {
    if (range.AreWhole && range.Low >= vtkDataArray::GetDataTypeMin(type) &&
      range.High <= vtkDataArray::GetDataTypeMax(type))
    {
      return type;
    }
  }
  return VTK_FLOAT;
}

/// Sample number `at` of a slice. Bits above the stored ones may belong to an overlay.
double Sample(const std::string& bytes, std::size_t at, const DicomHeader& slice)
{
  const auto size = static_cast<std::size_t>(slice.Bits / 8);
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    const std::size_t byte = at * size + (slice.IsBig ? i : size - 1 - i);
    bits = bits << 8 | static_cast<unsigned char>(bytes[byte]);
  }
  const std::uint64_t count = std::uint64_t{ 1 } << slice.Stored;
  bits &= count - 1;
  const bool isNegative = slice.IsSigned && bits >= count / 2;
  return static_cast<double>(bits) - (isNegative ? static_cast<double>(count) : 0.0);
}

template <typename Value>
void Fill(const std::string& bytes, const DicomHeader& slice, Value* values)
{
  const auto samples = static_cast<std::size_t>(slice.Samples);
  const std::size_t pixels = static_cast<std::size_t>(slice.Width) * slice.Height;
  for (std::size_t i = 0; i < samples * pixels; ++i)
  {
    const std::size_t at = slice.ArePlanes ? i % samples * pixels + i / samples : i;
    values[i] = static_cast<Value>(slice.Slope * Sample(bytes, at, slice) + slice.Intercept);
  }
}

/// The value of pixels that were not measured, if the file gives it. Its two bytes may or may not
/// have a sign, independent of the pixels'.
std::optional<double> ReadPadding(const DicomHeader& slice)
{
  if (!slice.Padding)
  {
    return {};
  }
  const int sign = slice.IsSigned && *slice.Padding >= 0x8000 ? 0x10000 : 0;
  return slice.Slope * (*slice.Padding - sign) + slice.Intercept;
}

/// Sets pixels that were not measured to the least value of the others. Returns their number.
template <typename Value>
vtkIdType ReplacePadding(const std::vector<DicomHeader>& slices, vtkIdType count, Value* values)
{
  Value least = std::numeric_limits<Value>::max();
  vtkIdType replaced = 0;
  for (const bool isSearch : { true, false })
  {
    for (std::size_t k = 0; k < slices.size(); ++k)
    {
      const std::optional<double> padding = ReadPadding(slices[k]);
      Value* const first = values + static_cast<vtkIdType>(k) * count;
      for (vtkIdType i = 0; i < count; ++i)
      {
        const bool isPadding = padding && static_cast<double>(first[i]) == *padding;
        if (isSearch)
        {
          least = isPadding ? least : std::min(least, first[i]);
        }
        else if (isPadding)
        {
          first[i] = least;
          ++replaced;
        }
      }
    }
    if (least == std::numeric_limits<Value>::max())
    {
      return 0; // nothing was measured
    }
  }
  return replaced;
}

/// Sets what scanners write outside of their field of view, and tell only by its value, to the
/// least value that is measured: one and the same value below all that a CT measures, in more than
/// a thousandth of the voxels. Returns the number of pixels.
template <typename Value>
vtkIdType ReplaceBelowAir(vtkIdType count, Value* values)
{
  constexpr double lowest = -1024.0; // HU
  constexpr vtkIdType fewestPart = 1000;
  Value least = std::numeric_limits<Value>::max();
  const Value outside = *std::min_element(values, values + count);
  vtkIdType replaced = 0;
  bool isOne = static_cast<double>(outside) < lowest;
  for (vtkIdType i = 0; i < count && isOne; ++i)
  {
    replaced += values[i] == outside;
    least = values[i] == outside ? least : std::min(least, values[i]);
  }
  isOne = isOne && replaced > count / fewestPart && static_cast<double>(least) >= lowest;
  if (isOne)
  {
    std::replace(values, values + count, outside, least);
  }
  return isOne ? replaced : 0;
}

/// Rows and slices in the order of their places.
vtkSmartPointer<vtkImageData> ReadSlices(
  const std::string& path, const std::vector<DicomHeader>& slices, Volume& volume)
{
  const DicomHeader& first = slices.front();
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(first.Width, first.Height, static_cast<int>(slices.size()));
  VolumeHaptics::AllocateScalars(image, ChooseType(ComputeValues(slices)), first.Samples);
  image->GetPointData()->GetScalars()->SetName("DICOM");
  Explore::DicomPixels pixels;
  for (std::size_t k = 0; k < slices.size(); ++k)
  {
    DicomHeader slice = slices[k];
    const std::string bytes = pixels.Read(path, slice);
    void* const values = image->GetScalarPointer(0, 0, static_cast<int>(k));
    switch (image->GetScalarType())
    {
      vtkTemplateMacro(Fill(bytes, slice, static_cast<VTK_TT*>(values)));
    }
  }
  const bool isPadded = first.Samples == 1 &&
    std::any_of(slices.begin(), slices.end(),
      [](const DicomHeader& slice) { return slice.Padding.has_value(); });
  vtkIdType replaced = 0;
  void* const values = image->GetScalarPointer();
  switch (isPadded ? image->GetScalarType() : VTK_VOID)
  {
    vtkTemplateMacro(replaced = ReplacePadding(slices, vtkIdType{ first.Width } * first.Height,
                       static_cast<VTK_TT*>(values)));
    default:
      break;
  }
  vtkIdType below = 0;
  switch (first.Modality == "CT" && first.Samples == 1 ? image->GetScalarType() : VTK_VOID)
  {
    vtkTemplateMacro(
      below = ReplaceBelowAir(image->GetNumberOfPoints(), static_cast<VTK_TT*>(values)));
    default:
      break;
  }
  if (below > 0)
  {
    volume.Notes.push_back(std::to_string(below) +
      " pixels have one value below -1024: they are outside of the field of view, and are set to "
      "the "
      "least value");
  }
  if (replaced > 0)
  {
    volume.Notes.push_back(std::to_string(replaced) +
      " pixels were not measured, as the files say: they are outside, with the least value");
  }
  return image;
}

/// Slices may be tilted against the line on which they follow each other.
void PlaceSlices(const std::vector<DicomHeader>& slices, double length, vtkImageData* image)
{
  const DicomHeader& first = slices.front();
  const int count = image->GetDimensions()[2];
  const double spacing = count > 1 ? length / (count - 1) : 0.0;
  const auto known = [](double length) { return length > 0.0 ? length : 1.0; };
  image->SetSpacing(known(first.Spacing[0]), known(first.Spacing[1]), known(spacing));
  double axes[9];
  for (int axis = 0; axis < 3; ++axis)
  {
    axes[3 * axis] = first.Row[axis];
    axes[3 * axis + 1] = first.Column[axis];
    axes[3 * axis + 2] =
      length > 0.0 ? slices.back().Position[axis] - first.Position[axis] : first.Normal[axis];
  }
  Explore::SetFrame(image, axes, first.Position);
}

/// Throws if there is no such series.
std::size_t ChooseSeries(
  const std::string& path, const std::vector<DicomSeries>& all, int wanted, bool hasFolders)
{
  if (all.empty())
  {
    throw InputError(path, "is a folder without a single DICOM slice",
      hasFolders ? "name a folder that holds DICOM slices, or folders of them"
                 : "name a folder of DICOM slices, or a volume file");
  }
  if (wanted > static_cast<int>(all.size()))
  {
    throw InputError(path,
      "has no series " + std::to_string(wanted) + ", but" + ListSeries(all) + "\n    and no other",
      "take --series 1 to " + std::to_string(all.size()));
  }
  return wanted > 0 ? static_cast<std::size_t>(wanted - 1) : Explore::FindLargest(all);
}

Volume LoadSeries(const std::string& path, const std::vector<DicomSeries>& all, std::size_t chosen)
{
  Volume volume;
  volume.Format = "DICOM";
  volume.Axes = Explore::WorldAxes::Patient;
  const std::vector<DicomHeader> slices = LeaveOutFar(all[chosen].Slices, volume);
  CheckSlices(path, slices);
  const std::vector<double> along = FindPlaces(path, slices, volume);
  CheckLine(path, slices);
  volume.Image = ReadSlices(path, slices, volume);
  const double even = along.back() / std::max<double>(1.0, static_cast<double>(along.size() - 1));
  bool isEven = true;
  for (std::size_t i = 0; i < along.size(); ++i)
  {
    isEven = isEven && std::abs(along[i] - static_cast<double>(i) * even) <= 1e-9 * along.back();
  }
  if (along.size() > 2 && !isEven)
  {
    volume.Image = Explore::SpaceSlicesEvenly(volume.Image, along);
  }
  const double* const from = slices.front().Position;
  const double* const to = slices.back().Position;
  PlaceSlices(slices, std::sqrt(vtkMath::Distance2BetweenPoints(from, to)), volume.Image);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    volume.Series.push_back(all[i].Describe(i + 1));
  }
  volume.SeriesNumber = static_cast<int>(chosen) + 1;
  if (all.size() == 1)
  {
    volume.Notes.push_back(std::to_string(slices.size()) + " slices, sorted by position");
  }
  else
  {
    volume.Notes.push_back("series " + all[chosen].Describe(chosen + 1) + ", of " +
      std::to_string(all.size()) + " series; --series N takes another one:" + ListSeries(all));
  }
  return volume;
}
} // namespace

namespace Explore
{
Volume ReadDicomFolder(const std::string& path, int series)
{
  bool hasFolders = false;
  const std::vector<DicomSeries> all = ListDicomSeries(path, hasFolders);
  return LoadSeries(path, all, ChooseSeries(path, all, series, hasFolders));
}

Volume ReadDicomFile(const std::string& path, int series)
{
  const std::string whole = vtksys::SystemTools::CollapseFullPath(path);
  const std::string folder = vtksys::SystemTools::GetFilenamePath(whole);
  DicomHeader header;
  if (series > 0 || !ReadDicomHeader(whole, header))
  {
    return ReadDicomFolder(folder, series);
  }
  bool hasFolders = false;
  const std::vector<DicomSeries> all = ListDicomSeries(folder, hasFolders);
  const auto holds = [&](const DicomSeries& one)
  {
    return std::any_of(one.Slices.begin(), one.Slices.end(),
      [&](const DicomHeader& slice) { return slice.File == whole; });
  };
  const auto found = std::find_if(all.begin(), all.end(), holds);
  if (found == all.end())
  {
    throw InputError(path, "is not there any more", "name the folder of its series");
  }
  return LoadSeries(path, all, static_cast<std::size_t>(found - all.begin()));
}

bool IsDicomFile(const std::string& path)
{
  DicomHeader header;
  return vtksys::SystemTools::UpperCase(vtksys::SystemTools::GetFilenameName(path)) == "DICOMDIR" ||
    ReadDicomHeader(path, header);
}
} // namespace Explore
