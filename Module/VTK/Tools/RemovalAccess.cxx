// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Tools/RemovalAccess.h"

#include "Core/Carving/TissueImage.h"
#include "Core/Platform/HapticFiles.h"
#include "Core/Tools/PointShell/BakedShell.h"
#include "VTK/Base/ArrayMemory.h"
#include "VTK/Base/XmlFiles.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkHapticRemoval.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLImageDataWriter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/**
 * Number of samples that are examined; small, so that not all of a volume mapped from a file is
 * read.
 */
constexpr vtkIdType MostAirSamples = 4096;
/** Fraction of these samples that may be outliers. */
constexpr double AirQuantile = 0.02;

/**
 * Returns a minimum (or maximum, if isLargest) of some evenly spaced samples that ignores outliers:
 * only a fraction AirQuantile is beyond it. Returns 0 if no sample is finite.
 */
double ComputeAir(vtkDataArray* scalars, int component, bool isLargest)
{
  const vtkIdType n = scalars->GetNumberOfTuples();
  const vtkIdType count = std::min(n, MostAirSamples);
  std::vector<double> values;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto at = static_cast<vtkIdType>(
      static_cast<double>(i) * static_cast<double>(n) / static_cast<double>(count));
    const double value = scalars->GetComponent(at, component);
    if (std::isfinite(value))
    {
      values.push_back(value);
    }
  }
  if (values.empty())
  {
    return 0.0;
  }
  const auto last = static_cast<double>(values.size() - 1);
  const auto place =
    static_cast<std::ptrdiff_t>((isLargest ? 1.0 - AirQuantile : AirQuantile) * last + 0.5);
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

bool IsSameExtent(vtkImageData* image, const int extent[6])
{
  return std::equal(extent, extent + 6, image->GetExtent());
}

/**
 * Computes the index of a volume's first sample in another volume. Returns false if their samples
 * are not at the same positions.
 */
bool DetectShift(vtkImageData* volume, vtkImageData* other, std::int64_t first[3])
{
  constexpr double rounding = 1e-3; // tolerance (voxels) over the whole volume
  const int* const extent = volume->GetExtent();
  const int* const there = other->GetExtent();
  for (int corner = 0; corner < 4; ++corner) // the first sample, then the last one along each axis
  {
    double index[3];
    for (int a = 0; a < 3; ++a)
    {
      index[a] = corner == a + 1 ? std::max(extent[2 * a + 1], extent[2 * a] + 1) : extent[2 * a];
    }
    double world[3];
    double found[3];
    volume->TransformContinuousIndexToPhysicalPoint(index, world);
    other->TransformPhysicalPointToContinuousIndex(world, found);
    for (int a = 0; a < 3; ++a)
    {
      const double at = found[a] - there[2 * a] - (index[a] - extent[2 * a]);
      if (corner == 0)
      {
        first[a] = std::llround(std::clamp(at, -1e9, 1e9));
      }
      // The negated comparison also refuses NaN.
      if (!(std::abs(at - static_cast<double>(first[a])) <= rounding))
      {
        return false;
      }
    }
  }
  return true;
}

std::string DescribeExtent(const int extent[6])
{
  std::ostringstream text;
  text << "extent (" << extent[0] << " to " << extent[1] << ", " << extent[2] << " to " << extent[3]
       << ", " << extent[4] << " to " << extent[5] << ")";
  return text.str();
}

} // namespace

RemovalData& RemovalData::Of(vtkHapticRemoval* removal)
{
  return *removal->Data;
}

bool RemovalData::ServeAll() const
{
  bool hasServed = false;
  while (this->Tissue && this->Tissue->Serve())
  {
    hasServed = true;
  }
  return hasServed;
}

void RemovalData::SetFoundAir(vtkHapticRemoval* removal, double value)
{
  removal->AirValue = value;
  removal->Data->HasAir = true;
}

void RemovalData::ApplyContent(std::unique_ptr<RemovalContent> content)
{
  this->Replace(content->Fractions, content->Geometry);
  this->Read = std::move(content);
  this->ReadChanges = this->Tissue->Bricks.GetChanges();
}

bool RemovalData::IsAsRead() const
{
  return this->Read && this->Tissue && this->Tissue->Bricks.GetChanges() == this->ReadChanges;
}

bool RemovalData::IsOtherPart(vtkImageData* geometry, const int extent[6]) const
{
  // If the extents are equal, the volume may have been moved as a whole.
  if (!this->IsAsRead() || IsSameExtent(this->Read->Geometry, extent))
  {
    return false;
  }
  vtkNew<vtkImageData> volume;
  CopyGeometry(geometry, extent, volume);
  std::int64_t first[3];
  return DetectShift(volume, this->Read->Geometry, first) &&
    !std::equal(first, first + 3, this->ReadFirst);
}

bool RemovalData::FitRead(vtkImageData* geometry, const int extent[6])
{
  vtkNew<vtkImageData> volume;
  CopyGeometry(geometry, extent, volume);
  TissueBox box{};
  if (!DetectShift(volume, this->Read->Geometry, box.First))
  {
    return false;
  }
  for (int a = 0; a < 3; ++a)
  {
    box.Size[a] = std::int64_t{ extent[2 * a + 1] } - extent[2 * a] + 1;
  }
  std::unique_ptr<RemovalContent> content = std::move(this->Read);
  const bool isDone = this->Replace(MoveTissue(content->Fractions, box), volume);
  this->Read = std::move(content);
  std::copy(box.First, box.First + 3, this->ReadFirst);
  this->ReadChanges = isDone ? this->Tissue->Bricks.GetChanges() : this->ReadChanges;
  return isDone;
}

bool RemovalData::Replace(const std::vector<BrickTissue>& fractions, vtkImageData* geometry)
{
  auto tissue = std::make_shared<TissueRemoval>();
  if (!WriteBricks(fractions, tissue->Bricks))
  {
    return false;
  }
  this->Tissue = std::move(tissue);
  this->Read = nullptr;
  if (geometry != this->Geometry)
  {
    CopyGeometry(geometry, geometry->GetExtent(), this->Geometry);
  }
  return true;
}

std::shared_ptr<TissueRemoval> GetTissueRemoval(vtkHapticRemoval* removal)
{
  return removal ? RemovalData::Of(removal).Tissue : nullptr;
}

bool HoldRemoval(vtkHapticRemoval* removal, const void* holder)
{
  RemovalData& data = RemovalData::Of(removal);
  if (data.Holder && data.Holder != holder)
  {
    return false;
  }
  data.Holder = holder;
  return true;
}

void LetRemovalGo(vtkHapticRemoval* removal, const void* holder)
{
  RemovalData& data = RemovalData::Of(removal);
  if (data.Holder == holder)
  {
    data.Holder = nullptr;
    if (data.ServeAll())
    {
      removal->Modified();
    }
  }
}

bool DescribeRemoval(vtkHapticRemoval* removal, vtkImageData* geometry, const int extent[6],
  vtkDataArray* scalars, int component, bool isRegion, HapticModelDescription& d,
  std::string& error)
{
  RemovalData& data = RemovalData::Of(removal);
  const bool removes = d.Tool && d.Tool->RemovesTissue();
  const bool isOther =
    data.Tissue && (!IsSameExtent(data.Geometry, extent) || data.IsOtherPart(geometry, extent));
  const bool isFitted = isOther && data.IsAsRead() && data.FitRead(geometry, extent);
  const bool isUsed = data.Tissue &&
    (!data.Tissue->Bricks.IsWhole() || (data.IsAsRead() && !data.Read->Fractions.empty()));
  if (isOther && !isFitted)
  {
    if (isUsed)
    {
      std::ostringstream text;
      text
        << "The removed tissue is of a volume of " << DescribeExtent(data.Geometry->GetExtent())
        << ", and the image on input port 0 has " << DescribeExtent(extent)
        << ". Its file is felt on any part of its volume. Keep it with WriteFile() of the filter's "
           "GetRemoval(), and go on with all tissue after SetRemoval(nullptr).";
      error = text.str();
      return false;
    }
    data.Tissue = nullptr;
    data.Read = nullptr;
    data.HasAir = false;
  }
  if (!d.TimeSteps.empty() || (!removes && !isUsed))
  {
    return true;
  }
  if (!data.Tissue)
  {
    data.Tissue = std::make_shared<TissueRemoval>();
  }
  // Keep an air value that is in use: all regions of a volume, and the tissue that was already
  // removed, must have the same one.
  if (removal->GetAutoAirValue() && (!data.HasAir || (removes && !isRegion && !isUsed)))
  {
    const auto* const shaped = dynamic_cast<const ShapedTool*>(d.Tool.get());
    const bool isBelow = removes && shaped && shaped->Description.Touch.IsBelow;
    RemovalData::SetFoundAir(removal, ComputeAir(scalars, component, isBelow));
  }
  CopyGeometry(geometry, extent, data.Geometry);
  d.Removal = data.Tissue;
  d.AirValue = removal->GetAirValue();
  return true;
}

//------------------------------------------------------------------------------
namespace
{

constexpr const char* TissueName = "RemainingShares";
constexpr const char* ExtentName = "VolumeExtent";
constexpr const char* AirName = "AirValue";
constexpr const char* WriteCure = " Give a file that vtkHapticRemoval::WriteFile() has written.";

/** Converts an extent to a box of sample indices relative to the volume's first sample. */
TissueBox BoxOf(const int extent[6], const int volume[6])
{
  TissueBox box{};
  for (int axis = 0; axis < 3; ++axis)
  {
    box.First[axis] = std::int64_t{ extent[2 * axis] } - volume[2 * axis];
    box.Size[axis] = std::int64_t{ extent[2 * axis + 1] } - extent[2 * axis] + 1;
  }
  return box;
}

/**
 * Returns the extent, within the volume, of all bricks with missing tissue; one sample if there are
 * none.
 */
std::array<int, 6> ComputeUsedExtent(const std::vector<BrickTissue>& bricks, const int volume[6])
{
  std::array<int, 6> used{ volume[0], volume[0], volume[2], volume[2], volume[4], volume[4] };
  bool isFirst = true;
  for (const BrickTissue& brick : bricks)
  {
    const BrickPlace place = CarvedBricks::PlaceOf(brick.Key);
    const std::int64_t places[] = { place.X, place.Y, place.Z };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::int64_t first = volume[2 * axis] + places[axis] * CarvedBricks::Side;
      const std::int64_t last =
        std::min<std::int64_t>(first + CarvedBricks::Side - 1, volume[2 * axis + 1]);
      int& low = used[2 * axis];
      int& high = used[2 * axis + 1];
      low = isFirst ? static_cast<int>(first) : std::min(low, static_cast<int>(first));
      high = isFirst ? static_cast<int>(last) : std::max(high, static_cast<int>(last));
    }
    isFirst = false;
  }
  return used;
}

bool IsWithin(const int extent[6], const int volume[6])
{
  bool isGood = true;
  for (int axis = 0; axis < 6; axis += 2)
  {
    isGood = isGood && extent[axis] <= extent[axis + 1] && extent[axis] >= volume[axis] &&
      extent[axis + 1] <= volume[axis + 1] &&
      std::int64_t{ extent[axis] } - volume[axis] < CarvedBricks::PlaceLimit;
  }
  return isGood;
}

bool ReadImage(const std::string& file, vtkImageData* image, std::string& error)
{
  if (!CheckRegular(file, error))
  {
    error += ".";
    return false;
  }
  vtkNew<vtkXMLImageDataReader> reader;
  if (!reader->CanReadFile(file.c_str()))
  {
    error = "is no VTK image (.vti), or not all of one." + std::string(WriteCure);
    return false;
  }
  if (!ReadXmlFile(reader, file) || reader->GetErrorCode() != 0)
  {
    error = "is damaged." + std::string(WriteCure);
    return false;
  }
  image->ShallowCopy(reader->GetOutput());
  return true;
}

} // namespace

void CopyGeometry(vtkImageData* from, const int extent[6], vtkImageData* to)
{
  to->SetExtent(const_cast<int*>(extent));
  to->SetOrigin(from->GetOrigin());
  to->SetSpacing(from->GetSpacing());
  to->SetDirectionMatrix(from->GetDirectionMatrix());
}

void MakeTissueImage(
  const CarvedBricks* bricks, vtkImageData* geometry, const int extent[6], vtkImageData* fractions)
{
  fractions->Initialize();
  CopyGeometry(geometry, extent, fractions);
  if (!bricks)
  {
    return;
  }
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(TissueName);
  AllocateTuples(array, fractions->GetNumberOfPoints());
  WriteTissue(*bricks, BoxOf(extent, geometry->GetExtent()), array->GetPointer(0));
  fractions->GetPointData()->SetScalars(array);
}

bool WriteRemovalFile(const CarvedBricks& bricks, double airValue, vtkImageData* geometry,
  const std::string& file, std::string& error)
{
  const int* const volume = geometry->GetExtent();
  vtkNew<vtkImageData> image;
  MakeTissueImage(&bricks, geometry, ComputeUsedExtent(CopyBricks(bricks), volume).data(), image);
  vtkNew<vtkIntArray> extent;
  extent->SetName(ExtentName);
  extent->SetNumberOfComponents(6);
  extent->InsertNextTypedTuple(volume);
  image->GetFieldData()->AddArray(extent);
  vtkNew<vtkDoubleArray> air;
  air->SetName(AirName);
  air->InsertNextValue(airValue);
  image->GetFieldData()->AddArray(air);
  vtkNew<vtkXMLImageDataWriter> writer;
  return WriteXmlFile(writer, image, file, error);
}

bool ReadRemovalFile(const std::string& file, RemovalContent& content, std::string& error)
{
  vtkNew<vtkImageData> image;
  if (!ReadImage(file, image, error))
  {
    return false;
  }
  auto* const array =
    vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetArray(TissueName));
  auto* const extent = vtkIntArray::SafeDownCast(image->GetFieldData()->GetArray(ExtentName));
  vtkDataArray* const air = image->GetFieldData()->GetArray(AirName);
  const bool hasExtent =
    extent && extent->GetNumberOfComponents() * extent->GetNumberOfTuples() == 6;
  const bool hasAir = air && air->GetNumberOfComponents() * air->GetNumberOfTuples() == 1 &&
    std::isfinite(air->GetComponent(0, 0));
  if (!array || !hasExtent || !hasAir || array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != image->GetNumberOfPoints() ||
    !IsWithin(image->GetExtent(), extent->GetPointer(0)))
  {
    error = "has no shares of tissue." + std::string(WriteCure);
    return false;
  }
  const int* const volume = extent->GetPointer(0);
  CarvedBricks bricks;
  if (!ReadTissue(bricks, BoxOf(image->GetExtent(), volume), array->GetPointer(0)))
  {
    error = "has tissue removed in more than " + std::to_string(bricks.GetMost()) +
      " bricks of 8 x 8 x 8 samples, which is all that there is memory for." +
      std::string(WriteCure);
    return false;
  }
  content.Fractions = CopyBricks(bricks);
  content.AirValue = air->GetComponent(0, 0);
  CopyGeometry(image, volume, content.Geometry);
  return true;
}

} // namespace VolumeHaptics
