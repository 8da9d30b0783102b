// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/LargeLoader.h"

#include "VTK/Reading/InputError.h"
#include "VTK/Reading/MessageCapture.h"
#include "VTK/Reading/VolumeChecks.h"
#include "VTK/Reading/VolumeOrientation.h"

#include "vtkAbstractArray.h"
#include "vtkNew.h"

#include <vtksys/SystemTools.hxx>

#include <sstream>

namespace
{
using Explore::InputError;
using Files = vtksys::SystemTools;

constexpr vtkIdType MOST_COARSE_VOXELS = 1 << 22;

/// Removes the trailing slash that shells append to folder names.
std::string PlainName(const std::string& path)
{
  std::string name = path;
  Files::ConvertToUnixSlashes(name);
  return name;
}

std::string FormatOf(const std::string& path)
{
  return vtkHapticRegionSource::GetFileFormat(PlainName(path).c_str());
}

/// Returns whether files of a format are always read region by region, even if they fit into
/// memory.
bool IsLargeFormat(const std::string& format)
{
  return format == "VTKHDF" || format == "Zarr";
}

void OpenItself(const std::string& path, int series, vtkHapticRegionSource* source)
{
  std::string error;
  if (!source->OpenFile(PlainName(path).c_str(), error, series))
  {
    throw InputError(path, "can't be opened (" + error + ")",
      !IsLargeFormat(FormatOf(path)) ? "see the reason in brackets, or leave out --large"
                                     : "see the reason in brackets; volumehaptics.open_large() in "
                                       "Python opens what zarr and h5py "
                                       "read");
  }
}

void MakeCoarse(const std::string& path, vtkHapticRegionSource* source)
{
  const Explore::MessageCapture capture;
  if (!source->MakeCoarseImage(MOST_COARSE_VOXELS))
  {
    throw InputError(path, "can't be read (" + capture.FirstError() + ")",
      "copy it again, and check that the copy is complete");
  }
}
} // namespace

namespace Explore
{
double ComputeRegionsSize(const std::string& path)
{
  vtkNew<vtkHapticRegionSource> source;
  std::string error; // ignored: the reader of the whole file reports the error
  if (!source->OpenFile(PlainName(path).c_str(), error))
  {
    return 0.0;
  }
  const int* const whole = source->GetWholeExtent();
  double size = vtkAbstractArray::GetDataTypeSize(source->GetScalarType());
  for (int a = 0; a < 6; a += 2)
  {
    size *= whole[a + 1] - whole[a] + 1.0;
  }
  return size;
}

bool IsLargeVolume(const std::string& path, bool isWanted)
{
  const std::string format = FormatOf(path);
  if (IsLargeFormat(format))
  {
    return true;
  }
  if (format.empty() || !Files::PathExists(PlainName(path)))
  {
    return false;
  }
  if (isWanted)
  {
    return true;
  }
  return ComputeRegionsSize(path) > 0.5 * GetFreeMemory();
}

Volume LoadLargeVolume(const std::string& path, int series)
{
  if (!Files::PathExists(path))
  {
    throw InputError(path, "there is no such file or folder", "check the spelling");
  }
  Volume volume;
  volume.Name = Files::GetFilenameName(PlainName(path));
  volume.Large = vtkSmartPointer<vtkHapticRegionSource>::New();
  OpenItself(path, series, volume.Large);
  volume.Format = FormatOf(path);
  volume.Axes = FindFormatAxes(volume.Format);
  AddFileNotes(volume.Large, volume);
  if (volume.Format == "NRRD")
  {
    const VolumeHaptics::NrrdHeader header = VolumeHaptics::ReadNrrdHeader(path);
    volume.Axes = FindNrrdAxes(header);
    const std::string turn = DescribeNrrdTurn(header);
    volume.Notes.insert(volume.Notes.end(), turn.empty() ? 0 : 1, turn);
  }
  else if (volume.Format == "MetaImage")
  {
    volume.Axes = ReadMetaImageAxes(path);
  }
  if (!volume.Large->GetCoarseImage())
  {
    MakeCoarse(path, volume.Large);
    volume.Notes.emplace_back(
      "it has no coarse level: one was computed from the whole volume, for the picture");
  }
  volume.Image = volume.Large->GetCoarseImage();
  CheckVolume(path, volume);
  volume.Image = AlignToAxes(volume.Image);
  const int* const whole = volume.Large->GetWholeExtent();
  const double* const spacing = volume.Large->GetSpacing();
  std::ostringstream note;
  note << "a coarse level, which the picture shows; felt are " << whole[1] - whole[0] + 1 << " x "
       << whole[3] - whole[2] + 1 << " x " << whole[5] - whole[4] + 1 << " voxels of " << spacing[0]
       << " x " << spacing[1] << " x " << spacing[2] << ", read from the file where the hand is";
  volume.Notes.push_back(note.str());
  return volume;
}
} // namespace Explore
