// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Volume/VolumeSeries.h"

#include "Applications/Explorer/Errors/InputError.h"
#include "Applications/Explorer/Volume/DicomSeries.h"
#include "Applications/Explorer/Volume/LargeLoader.h"
#include "Applications/Explorer/Volume/SliceGeometry.h"
#include "Applications/Explorer/Volume/VolumeChecks.h"
#include "Applications/Explorer/Volume/VolumeOrientation.h"
#include "VTK/Base/NameOrder.h"

#include "vtkDataArray.h"
#include "vtkImageExtractComponents.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUtilities.h"

#include <vtksys/Directory.hxx>
#include <vtksys/SystemInformation.hxx>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>

namespace
{
using Explore::InputError;
using Explore::Volume;
using Files = vtksys::SystemTools;

/// For files without times: this many make a second.
constexpr double FRAMES_PER_SECOND = 10.0;

struct FramePath
{
  std::string Path;
  double Time;
};

bool IsVolumeFile(const std::string& path)
{
  const std::string lower = Files::LowerCase(path);
  for (const char* const ending : { ".vti", ".mhd", ".mha", ".nii", ".nii.gz", ".nrrd" })
  {
    if (Files::StringEndsWith(lower, ending))
    {
      return true;
    }
  }
  return false;
}

std::vector<FramePath> MakeFrames(const std::vector<std::string>& paths)
{
  std::vector<FramePath> frames;
  for (const std::string& path : paths)
  {
    frames.push_back({ path, static_cast<double>(frames.size()) / FRAMES_PER_SECOND });
  }
  return frames;
}

/// The volumes in a folder, or the folders in it if it has no files and they hold the slices of
/// phases; none if there are fewer than two.
std::vector<FramePath> ListFolder(const std::string& folder)
{
  vtksys::Directory directory;
  directory.Load(folder);
  std::vector<std::string> volumes;
  std::vector<std::string> folders;
  bool hasFiles = false;
  for (unsigned long i = 0; i < directory.GetNumberOfFiles(); ++i)
  {
    const std::string name = directory.GetFile(i);
    const std::string path = folder + "/" + name;
    if (name[0] == '.')
    {
      continue;
    }
    const bool isFolder = Files::FileIsDirectory(path);
    hasFiles = hasFiles || !isFolder;
    if (isFolder)
    {
      folders.push_back(path);
    }
    else if (IsVolumeFile(path))
    {
      volumes.push_back(path);
    }
  }
  std::vector<std::string>& found = hasFiles ? volumes : folders;
  std::sort(found.begin(), found.end(), VolumeHaptics::IsNamedBefore);
  const bool areFrames = found.size() > 1 && (hasFiles || Explore::ArePhases(found));
  return areFrames ? MakeFrames(found) : std::vector<FramePath>();
}

/// The files and times of ParaView's collections.
std::vector<FramePath> ReadCollection(const std::string& path)
{
  const auto root =
    vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(path.c_str()));
  vtkXMLDataElement* const collection =
    root ? root->FindNestedElementWithName("Collection") : nullptr;
  std::vector<FramePath> frames;
  for (int i = 0; collection && i < collection->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* const entry = collection->GetNestedElement(i);
    const char* const file = entry->GetAttribute("file");
    double time = 0.0;
    if (!file || !entry->GetScalarAttribute("timestep", time) || !std::isfinite(time))
    {
      throw InputError(path, "has an entry without a file or a time",
        "write it again, with <DataSet timestep=\"...\" file=\"...\"/> for each time");
    }
    const std::string whole = Files::CollapseFullPath(file, Files::GetFilenamePath(path));
    frames.push_back({ whole, time });
  }
  if (frames.empty())
  {
    throw InputError(path, "is not a ParaView collection (.pvd) of files",
      "name the files themselves, or their folder");
  }
  std::stable_sort(frames.begin(), frames.end(),
    [](const FramePath& a, const FramePath& b) { return a.Time < b.Time; });
  const auto same = std::adjacent_find(frames.begin(), frames.end(),
    [](const FramePath& a, const FramePath& b) { return a.Time == b.Time; });
  if (same != frames.end())
  {
    throw InputError(path, "has several files for one time", "give it one image (.vti) for each");
  }
  return frames;
}

bool HasGeometryOf(vtkImageData* image, vtkImageData* other)
{
  const double* const a = image->GetDirectionMatrix()->GetData();
  const double* const b = other->GetDirectionMatrix()->GetData();
  return std::equal(image->GetExtent(), image->GetExtent() + 6, other->GetExtent()) &&
    std::equal(image->GetSpacing(), image->GetSpacing() + 3, other->GetSpacing()) &&
    std::equal(image->GetOrigin(), image->GetOrigin() + 3, other->GetOrigin()) &&
    std::equal(a, a + 9, b);
}

/// Checks before the rest is read.
void CheckMemory(const std::string& path, vtkImageData* first, std::size_t frames)
{
  constexpr double mebibyte = 1024.0;
  const double needed = static_cast<double>(first->GetActualMemorySize()) * frames / mebibyte;
  vtksys::SystemInformation system;
  system.RunMemoryCheck();
  const auto free = static_cast<double>(system.GetAvailablePhysicalMemory());
  if (free > 0.0 && needed > free)
  {
    std::ostringstream fault;
    fault << "has " << frames << " frames, which need " << std::lround(needed)
          << " MiB of memory, and " << std::lround(free) << " MiB are free";
    throw InputError(path, fault.str(), "name fewer frames, or smaller ones");
  }
}

bool HasSamplesOf(vtkImageData* image, vtkImageData* other)
{
  vtkDataArray* const a = image->GetPointData()->GetScalars();
  vtkDataArray* const b = other->GetPointData()->GetScalars();
  return a->GetDataType() == b->GetDataType() && a->GetNumberOfValues() == b->GetNumberOfValues() &&
    std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
      static_cast<std::size_t>(a->GetNumberOfValues()) * a->GetDataTypeSize()) == 0;
}

void AddFrame(Volume& volume, const std::string& path, vtkImageData* image, double time)
{
  if (!HasGeometryOf(image, volume.Image))
  {
    const int* const n = image->GetDimensions();
    std::ostringstream fault;
    fault << "is a frame with another geometry (" << n[0] << " x " << n[1] << " x " << n[2]
          << " voxels) than the first one";
    throw InputError(path, fault.str(),
      "resample all frames to one extent, spacing and origin, or name one volume");
  }
  volume.Frames->AddFrame(image, time);
}

/// Drops a last frame that repeats the first one, and adds notes for the user.
void Finish(Volume& volume)
{
  vtkHapticFrameSource* const frames = volume.Frames;
  const int last = frames->GetNumberOfFrames() - 1;
  std::ostringstream note;
  if (last > 1 && HasSamplesOf(frames->GetFrame(last), frames->GetFrame(0)))
  {
    vtkNew<vtkHapticFrameSource> loop;
    for (int i = 0; i < last; ++i)
    {
      loop->AddFrame(frames->GetFrame(i), frames->GetFrameTime(i));
    }
    volume.Frames = loop;
    volume.Notes.emplace_back("the last frame is the first one again: left out");
  }
  note << volume.Frames->GetNumberOfFrames() << " frames, times " << volume.Frames->GetFrameTime(0)
       << " to " << volume.Frames->GetFrameTime(volume.Frames->GetNumberOfFrames() - 1)
       << " s: the window plays them, the path feels the first one";
  volume.Notes.push_back(note.str());
}

Volume LoadFrames(
  const std::string& path, const std::vector<FramePath>& frames, const std::string& array)
{
  Volume volume = Explore::LoadVolume(frames.front().Path, 0, array);
  CheckMemory(path, volume.Image, frames.size());
  volume.Frames = vtkSmartPointer<vtkHapticFrameSource>::New();
  AddFrame(volume, frames.front().Path, volume.Image, frames.front().Time);
  for (std::size_t i = 1; i < frames.size(); ++i)
  {
    AddFrame(volume, frames[i].Path, Explore::LoadFrame(frames[i].Path, array), frames[i].Time);
  }
  Finish(volume);
  return volume;
}

vtkSmartPointer<vtkImageData> ExtractFrame(vtkImageData* image, int component)
{
  vtkNew<vtkImageExtractComponents> extract;
  extract->SetInputData(image);
  extract->SetComponents(component);
  extract->Update();
  auto frame = vtkSmartPointer<vtkImageData>::New();
  frame->ShallowCopy(extract->GetOutput());
  frame->SetDirectionMatrix(image->GetDirectionMatrix());
  return frame;
}

/// One of the volumes along the fourth axis of a NIfTI file, or all of them as frames. `chosen` is
/// the number of the one, from 1 on; 0 for all.
Volume LoadNiftiSeries(const std::string& path, const Explore::NiftiTimes& times, int chosen)
{
  Volume volume = Explore::ReadVolume(path, true);
  const vtkSmartPointer<vtkImageData> all = volume.Image;
  // Each time has all of its values, such as colours, of which the first is felt.
  const int count = times.Count;
  const int step = std::max(1, all->GetNumberOfScalarComponents() / count);
  if (chosen > count)
  {
    throw InputError(path,
      "has " + std::to_string(count) + " volumes along its fourth axis, and none with the number " +
        std::to_string(chosen),
      "take --series 1 to " + std::to_string(count));
  }
  CheckMemory(path, all, 1);
  volume.Image = ExtractFrame(all, std::max(0, chosen - 1) * step);
  Explore::CheckVolume(path, volume);
  Explore::AlignVolume(volume);
  if (chosen > 0)
  {
    volume.Notes.push_back("volume " + std::to_string(chosen) + " of " + std::to_string(count) +
      " along the fourth axis");
    return volume;
  }
  volume.Frames = vtkSmartPointer<vtkHapticFrameSource>::New();
  AddFrame(volume, path, volume.Image, 0.0);
  for (int i = 1; i < count; ++i)
  {
    vtkSmartPointer<vtkImageData> frame = ExtractFrame(all, i * step);
    Explore::StraightenIfSheared(frame, false);
    AddFrame(volume, path, Explore::AlignToAxes(frame), i * times.Spacing);
  }
  Finish(volume);
  volume.Notes.emplace_back(
    "the volumes along the fourth axis are taken for times; if they are channels, --series N takes "
    "one of them");
  return volume;
}
} // namespace

namespace Explore
{
Volume LoadVolumes(
  const std::vector<std::string>& paths, bool isLarge, int dicomSeries, const std::string& array)
{
  const std::string& path = paths.front();
  if (paths.size() > 1)
  {
    return LoadFrames(path, MakeFrames(paths), array);
  }
  if (IsLargeVolume(path, isLarge))
  {
    if (!array.empty())
    {
      throw InputError("--array " + array, "is for volumes in memory", "leave it out");
    }
    return LoadLargeVolume(path);
  }
  if (Files::FileIsDirectory(path))
  {
    const auto frames = dicomSeries > 0 ? std::vector<FramePath>() : ListFolder(path);
    return frames.empty() ? LoadVolume(path, dicomSeries, array) : LoadFrames(path, frames, array);
  }
  const bool isThere = Files::FileExists(path, true);
  if (isThere && Files::StringEndsWith(Files::LowerCase(path), ".pvd"))
  {
    const std::vector<FramePath> frames = ReadCollection(path);
    return frames.size() > 1 ? LoadFrames(path, frames, array)
                             : LoadVolume(frames.front().Path, 0, array);
  }
  const NiftiTimes times = isThere ? ReadNiftiTimes(path, 1.0 / FRAMES_PER_SECOND) : NiftiTimes();
  return times.Count > 1 ? LoadNiftiSeries(path, times, dicomSeries)
                         : LoadVolume(path, dicomSeries, array);
}

void UseDisplacements(Volume& volume, const std::string& array)
{
  const std::string option = "--displacements " + array;
  if (!volume.Frames)
  {
    throw InputError(
      option, "is for a volume that moves, and this one does not", "name all of its frames");
  }
  for (int i = 0; i < volume.Frames->GetNumberOfFrames(); ++i)
  {
    vtkDataArray* const found = volume.Frames->GetFrame(i)->GetPointData()->GetArray(array.c_str());
    if (!found || found->GetNumberOfComponents() != 3)
    {
      std::ostringstream fault;
      fault << "is no point array of vectors in the frame at " << volume.Frames->GetFrameTime(i)
            << " s";
      throw InputError(option, fault.str(),
        "name the array with the displacements to the next frame, which all frames have; the last "
        "one has those to the first");
    }
  }
  volume.Displacements = array;
}
} // namespace Explore
