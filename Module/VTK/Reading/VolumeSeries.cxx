// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/VolumeSeries.h"

#include "VTK/Base/NameOrder.h"
#include "VTK/Reading/Dicom/DicomSeries.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/LargeLoader.h"
#include "VTK/Reading/MaskFolder.h"
#include "VTK/Reading/MessageCapture.h"
#include "VTK/Reading/SliceGeometry.h"
#include "VTK/Reading/VolumeChecks.h"
#include "VTK/Reading/VolumeOrientation.h"
#include "VTK/Reading/WholeFile.h"

#include "vtkDataArray.h"
#include "vtkImageExtractComponents.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUtilities.h"

#include <vtksys/Directory.hxx>
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

/// Time steps per second for files that state no times.
constexpr double FRAMES_PER_SECOND = 10.0;

struct TimeStepPath
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

std::vector<TimeStepPath> MakeTimeSteps(const std::vector<std::string>& paths)
{
  std::vector<TimeStepPath> timeSteps;
  for (const std::string& path : paths)
  {
    timeSteps.push_back({ path, static_cast<double>(timeSteps.size()) / FRAMES_PER_SECOND });
  }
  return timeSteps;
}

/// Lists the volumes in a folder: its files, or, in a folder without files, its subfolders if they
/// contain the slices of phases and no series is chosen. Returns none if there are fewer than two.
std::vector<TimeStepPath> ListFolder(const std::string& folder, int series)
{
  vtksys::Directory directory;
  directory.Load(folder);
  std::vector<std::string> folders;
  bool hasFiles = false;
  for (unsigned long i = 0; i < directory.GetNumberOfFiles(); ++i)
  {
    const std::string path = folder + "/" + directory.GetFile(i);
    if (directory.GetFile(i)[0] == '.')
    {
      continue;
    }
    if (Files::FileIsDirectory(path))
    {
      folders.push_back(path);
    }
    else
    {
      hasFiles = true;
    }
  }
  std::sort(folders.begin(), folders.end(), VolumeHaptics::IsNamedBefore);
  const std::vector<std::string> found = hasFiles ? Explore::ListVolumeFiles(folder) : folders;
  const bool areTimeSteps =
    found.size() > 1 && (hasFiles || (series == 0 && Explore::ArePhases(found)));
  return areTimeSteps ? MakeTimeSteps(found) : std::vector<TimeStepPath>();
}

/// Reads the files and their times from a ParaView collection (.pvd).
std::vector<TimeStepPath> ReadCollection(const std::string& path)
{
  const Explore::MessageCapture capture;
  const auto root =
    vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(path.c_str()));
  vtkXMLDataElement* const collection =
    root ? root->FindNestedElementWithName("Collection") : nullptr;
  std::vector<TimeStepPath> timeSteps;
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
    timeSteps.push_back({ whole, time });
  }
  if (timeSteps.empty())
  {
    throw InputError(path, "is not a ParaView collection (.pvd) of files",
      "choose the files themselves, or their folder");
  }
  std::stable_sort(timeSteps.begin(), timeSteps.end(),
    [](const TimeStepPath& a, const TimeStepPath& b) { return a.Time < b.Time; });
  const auto same = std::adjacent_find(timeSteps.begin(), timeSteps.end(),
    [](const TimeStepPath& a, const TimeStepPath& b) { return a.Time == b.Time; });
  if (same != timeSteps.end())
  {
    throw InputError(path, "has several files for one time", "give it one image (.vti) for each");
  }
  return timeSteps;
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

double MeasureBytes(vtkImageData* image)
{
  return 1024.0 * static_cast<double>(image->GetActualMemorySize());
}

bool HasSamplesOf(vtkImageData* image, vtkImageData* other)
{
  vtkDataArray* const a = image->GetPointData()->GetScalars();
  vtkDataArray* const b = other->GetPointData()->GetScalars();
  return a->GetDataType() == b->GetDataType() && a->GetNumberOfValues() == b->GetNumberOfValues() &&
    std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
      static_cast<std::size_t>(a->GetNumberOfValues()) * a->GetDataTypeSize()) == 0;
}

void AddTimeStep(Volume& volume, const std::string& path, vtkImageData* image, double time)
{
  if (!HasGeometryOf(image, volume.Image))
  {
    const int* const n = image->GetDimensions();
    std::ostringstream fault;
    fault << "is a frame with another geometry (" << n[0] << " x " << n[1] << " x " << n[2]
          << " voxels) than the first one";
    throw InputError(path, fault.str(),
      "resample all frames to one extent, spacing and origin, or choose one volume");
  }
  volume.TimeSteps->AddTimeStep(image, time);
}

/// Removes the last time step if it repeats the first one, and adds notes for the user.
void Finish(Volume& volume)
{
  vtkHapticTimeStepSource* const timeSteps = volume.TimeSteps;
  const int last = timeSteps->GetNumberOfTimeSteps() - 1;
  std::ostringstream note;
  if (last > 1 && HasSamplesOf(timeSteps->GetTimeStepImage(last), timeSteps->GetTimeStepImage(0)))
  {
    vtkNew<vtkHapticTimeStepSource> loop;
    for (int i = 0; i < last; ++i)
    {
      loop->AddTimeStep(timeSteps->GetTimeStepImage(i), timeSteps->GetTimeStepValue(i));
    }
    volume.TimeSteps = loop;
    volume.Notes.emplace_back("the last frame repeats the first one: left out");
  }
  note << volume.TimeSteps->GetNumberOfTimeSteps() << " frames, times "
       << volume.TimeSteps->GetTimeStepValue(0) << " to "
       << volume.TimeSteps->GetTimeStepValue(volume.TimeSteps->GetNumberOfTimeSteps() - 1)
       << " s: the window plays them, the path feels the first one";
  volume.Notes.push_back(note.str());
}

vtkSmartPointer<vtkImageData> ExtractTimeStep(vtkImageData* image, int component)
{
  vtkNew<vtkImageExtractComponents> extract;
  extract->SetInputData(image);
  extract->SetComponents(component);
  extract->Update();
  auto timeStep = vtkSmartPointer<vtkImageData>::New();
  timeStep->ShallowCopy(extract->GetOutput());
  timeStep->SetDirectionMatrix(image->GetDirectionMatrix());
  return timeStep;
}

/// Loads one of the volumes along the fourth axis of a NIfTI file, or all of them as time steps.
/// `chosen` is the number of the volume, counted from 1; 0 stands for all.
Volume LoadNiftiSeries(
  const std::string& path, const Explore::NiftiTimes& times, int chosen, const std::string& array)
{
  if (!array.empty())
  {
    throw InputError("ArrayName = " + array, "is for files with arrays, not for " + path,
      "leave it out, or use Series = 1 to Series = " + std::to_string(times.Count));
  }
  Volume volume = Explore::ReadVolume(path, true);
  const vtkSmartPointer<vtkImageData> all = volume.Image;
  // Each time may have several components, such as colours; the first one is felt.
  const int count = times.Count;
  const int step = std::max(1, all->GetNumberOfScalarComponents() / count);
  if (chosen > count)
  {
    throw InputError(path,
      "has " + std::to_string(count) + " volumes along its fourth axis, and none with the number " +
        std::to_string(chosen),
      "use Series = 1 to Series = " + std::to_string(count));
  }
  Explore::CheckMemory(path, MeasureBytes(all), 1);
  volume.Image = ExtractTimeStep(all, std::max(0, chosen - 1) * step);
  Explore::CheckVolume(path, volume);
  Explore::AlignVolume(volume);
  volume.Series = { "0 all volumes along the fourth axis, as times" };
  for (int i = 1; i <= count; ++i)
  {
    volume.Series.push_back(std::to_string(i) + " of " + std::to_string(count) +
      " volumes along the fourth axis, such as a channel");
  }
  volume.SeriesNumber = chosen;
  if (chosen > 0)
  {
    volume.Notes.push_back("volume " + std::to_string(chosen) + " of " + std::to_string(count) +
      " along the fourth axis");
    return volume;
  }
  volume.TimeSteps = vtkSmartPointer<vtkHapticTimeStepSource>::New();
  AddTimeStep(volume, path, volume.Image, 0.0);
  for (int i = 1; i < count; ++i)
  {
    Volume timeStep;
    timeStep.Image = ExtractTimeStep(all, i * step);
    Explore::ShiftValues(timeStep, volume.Shift);
    Explore::StraightenIfSheared(timeStep.Image, false);
    AddTimeStep(volume, path, Explore::AlignToAxes(timeStep.Image), i * times.Spacing);
  }
  Finish(volume);
  volume.Notes.push_back(
    "the volumes along the fourth axis are taken for times; if they are channels, Series = "
    "1 to Series = " +
    std::to_string(count) + " choose one of them");
  return volume;
}
/// Loads one of the files of a moving volume.
Volume LoadFrame(const std::string& path, int series, const std::string& array)
{
  const Explore::NiftiTimes times = Explore::ReadNiftiTimes(path, 1.0);
  if (times.Count > 1 && series == 0)
  {
    throw InputError(path,
      "is one of several files, and has " + std::to_string(times.Count) +
        " volumes along its fourth axis",
      "open it alone, or use Series = 1 to Series = " + std::to_string(times.Count) +
        " of each file");
  }
  Volume frame = times.Count > 1 ? LoadNiftiSeries(path, times, series, array)
                                 : Explore::LoadVolume(path, series, array);
  if (!frame.Phases.empty())
  {
    throw InputError(
      path, "is one of several files, and is a moving volume itself", "open it alone");
  }
  return frame;
}

Volume LoadTimeSteps(const std::string& path, const std::vector<TimeStepPath>& timeSteps,
  int series, const std::string& array)
{
  Volume volume = LoadFrame(timeSteps.front().Path, series, array);
  Explore::CheckMemory(path, MeasureBytes(volume.Image), timeSteps.size());
  volume.TimeSteps = vtkSmartPointer<vtkHapticTimeStepSource>::New();
  AddTimeStep(volume, timeSteps.front().Path, volume.Image, timeSteps.front().Time);
  for (std::size_t i = 1; i < timeSteps.size(); ++i)
  {
    Volume frame = LoadFrame(timeSteps[i].Path, series, array);
    Explore::ShiftValues(frame, volume.Shift - frame.Shift); // use the shift of the first time step
                                                             // for all
    AddTimeStep(volume, timeSteps[i].Path, frame.Image, timeSteps[i].Time);
  }
  Finish(volume);
  return volume;
}

/// Loads a volume from a file or folder that may contain several phases.
Volume LoadPhases(const std::string& path, int series, const std::string& array)
{
  Volume volume = Explore::LoadVolume(path, series, array);
  if (volume.Phases.empty())
  {
    return volume;
  }
  volume.TimeSteps = vtkSmartPointer<vtkHapticTimeStepSource>::New();
  AddTimeStep(volume, path, volume.Image, 0.0);
  for (const Volume::Phase& phase : volume.Phases)
  {
    AddTimeStep(volume, path, phase.Image, phase.Time);
  }
  volume.Phases.clear();
  Finish(volume);
  return volume;
}

} // namespace

namespace Explore
{
Volume LoadVolumes(
  const std::vector<std::string>& paths, bool isLarge, int series, const std::string& array)
{
  if (paths.size() == 1 && IsLargeVolume(paths.front(), isLarge))
  {
    if (!array.empty())
    {
      throw InputError("ArrayName = " + array, "is for volumes in memory", "leave it out");
    }
    return LoadLargeVolume(paths.front(), series);
  }
  return LoadIntoMemory(paths, series, array);
}

Volume LoadIntoMemory(const std::vector<std::string>& paths, int series, const std::string& array)
{
  const std::string& path = paths.front();
  if (paths.size() > 1)
  {
    return LoadTimeSteps(path, MakeTimeSteps(paths), series, array);
  }
  CheckMemory(path, ComputeRegionsSize(path), 1);
  if (Files::FileIsDirectory(path))
  {
    const std::vector<TimeStepPath> timeSteps =
      ListMasks(path).empty() ? ListFolder(path, series) : std::vector<TimeStepPath>();
    return timeSteps.empty() ? LoadPhases(path, series, array)
                             : LoadTimeSteps(path, timeSteps, series, array);
  }
  const bool isThere = Files::FileExists(path, true) && DetectDevice(path).empty();
  if (isThere && Files::StringEndsWith(Files::LowerCase(path), ".pvd"))
  {
    const std::vector<TimeStepPath> timeSteps = ReadCollection(path);
    return timeSteps.size() > 1 ? LoadTimeSteps(path, timeSteps, series, array)
                                : LoadVolume(timeSteps.front().Path, series, array);
  }
  const NiftiTimes times = isThere ? ReadNiftiTimes(path, 1.0 / FRAMES_PER_SECOND) : NiftiTimes();
  return times.Count > 1 ? LoadNiftiSeries(path, times, series, array)
                         : LoadPhases(path, series, array);
}

std::vector<std::string> ListVolumeFiles(const std::string& folder)
{
  vtksys::Directory directory;
  directory.Load(folder);
  std::vector<std::string> files;
  for (unsigned long i = 0; i < directory.GetNumberOfFiles(); ++i)
  {
    const std::string path = folder + "/" + directory.GetFile(i);
    if (directory.GetFile(i)[0] != '.' && !Files::FileIsDirectory(path) && IsVolumeFile(path))
    {
      files.push_back(path);
    }
  }
  std::sort(files.begin(), files.end(), VolumeHaptics::IsNamedBefore);
  return files;
}

void UseDisplacements(Volume& volume, const std::string& array)
{
  const std::string option = "--displacements " + array;
  if (!volume.TimeSteps)
  {
    throw InputError(
      option, "is for a volume that moves, and this one does not", "give all of its frames");
  }
  for (int i = 0; i < volume.TimeSteps->GetNumberOfTimeSteps(); ++i)
  {
    vtkDataArray* const found =
      volume.TimeSteps->GetTimeStepImage(i)->GetPointData()->GetArray(array.c_str());
    if (!found || found->GetNumberOfComponents() != 3)
    {
      std::ostringstream fault;
      fault << "is no point array of vectors in the frame at "
            << volume.TimeSteps->GetTimeStepValue(i) << " s";
      throw InputError(option, fault.str(),
        "choose the array with the displacements to the next frame, which all frames have; the "
        "last "
        "one has those to the first");
    }
  }
  volume.Displacements = array;
}
} // namespace Explore
