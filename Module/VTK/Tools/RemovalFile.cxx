// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Tools/RemovalFile.h"

#include "Core/Carving/TissueImage.h"
#include "VTK/Base/ArrayMemory.h"
#include "VTK/Base/HapticFiles.h"
#include "VTK/Base/XmlFiles.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLImageDataWriter.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr const char* TissueName = "RemainingShares";
constexpr const char* ExtentName = "VolumeExtent";
constexpr const char* AirName = "AirValue";
constexpr const char* WriteCure = " Give a file that vtkHapticRemoval::WriteFile() has written.";

/** Converts an extent to a box of samples that counts from the volume's first sample. */
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
 * Returns the extent, within the volume, of all bricks with missing tissue; one sample if there is
 * no such brick.
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
