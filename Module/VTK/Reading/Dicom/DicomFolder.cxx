// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/Dicom/DicomFolder.h"

#include "VTK/Reading/Dicom/DicomPixels.h"
#include "VTK/Reading/Dicom/DicomSegmentation.h"
#include "VTK/Reading/Dicom/DicomSeries.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/SliceGeometry.h"
#include "VTK/Reading/VolumeChecks.h"
#include "VTK/Reading/VolumeOrientation.h"
#include "VTK/Reading/WholeFile.h"

#include "vtkImageData.h"
#include "vtkMath.h"

#include <vtksys/Directory.hxx>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
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

/// Returns a list of the series for messages, one per line.
std::string ListSeries(const std::vector<DicomSeries>& all)
{
  std::string list;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    list += "\n    " + all[i].Describe(i + 1);
  }
  return list;
}

void CheckSlices(
  const std::string& path, const std::vector<DicomHeader>& slices, bool isPlacedByLocation)
{
  for (const DicomHeader& slice : slices)
  {
    if (!slice.IsWhole)
    {
      throw InputError(path, "holds a damaged or truncated slice (" + NameOf(slice) + ")",
        "copy or export the series again, or remove that file");
    }
    if (slice.ImageType.find("MOSAIC") != std::string::npos && slice.Frames == 1)
    {
      throw InputError(path,
        "holds mosaics, which have all slices of a Siemens MR volume in one picture (" +
          NameOf(slice) + ")",
        "convert them to NIfTI with dcm2niix");
    }
    if (slice.Modality == "RTDOSE" && !slice.DoseScale)
    {
      throw InputError(path, "has a dose without its scale (DoseGridScaling) in " + NameOf(slice),
        "export it again from the planning system");
    }
    if (slice.IsPalette && !slice.IsSegmentation()) // a palette is an error, except for labels,
                                                    // whose colours do not matter
    {
      throw InputError(path,
        "has palette colours (PALETTE COLOR) instead of values in " + NameOf(slice),
        "export it again as grey values");
    }
    if (slice.HasValueTable)
    {
      throw InputError(path,
        "maps its values by a table (ModalityLUTSequence), which is not supported, "
        "in " +
          NameOf(slice),
        "apply it, e.g. with pydicom.pixels.apply_modality_lut, and write it with RescaleSlope");
    }
    if (!slice.HasPlaces)
    {
      throw InputError(path,
        "holds a DICOM file with " + std::to_string(slice.Frames) + " frames (" + NameOf(slice) +
          "), whose positions are not given: is it a film?",
        "convert it to NIfTI, e.g. with dcm2niix (package dcm2niix)");
    }
    if (!(slice.Spacing[0] > 0.0) || !(slice.Spacing[1] > 0.0))
    {
      throw InputError(path, "has no pixel spacing (PixelSpacing) in " + NameOf(slice),
        "export it again from its source, with its PixelSpacing");
    }
    if (!slice.HasPosition && slice.Frames == 1 && slices.size() > 1 && !isPlacedByLocation)
    {
      throw InputError(path,
        "has no slice positions (ImagePositionPatient, or SliceLocation) in " + NameOf(slice),
        "export it again from its source, with positions");
    }
  }
}

/// Returns the median distance (mm) between neighbouring slices.
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

/// Drops slices that are far from the others, such as a topogram that belongs to the series.
/// Returns the remaining slices.
std::vector<DicomHeader> LeaveOutFar(const std::vector<DicomHeader>& slices, Volume& volume)
{
  if (slices.size() < 3)
  {
    return slices;
  }
  constexpr double farSteps = 8.0;
  // Smallest number of slices that count as a volume.
  constexpr std::size_t fewest = 5;
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
    "put the slices of one volume into a folder of their own; of a moving volume, the slices of "
    "each phase");
}

/// Returns the positions (mm) of slices along their normal, relative to the first one. Makes the
/// positions exactly even if they differ only by the rounding in files. Throws InputError if two
/// slices are at the same position.
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
    ThrowSeveral(path, "has two slices at the same position");
  }
  const double even = count > 1 ? along.back() / static_cast<double>(count - 1) : 0.0;
  double off = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    off = std::max(off, std::abs(along[i] - static_cast<double>(i) * even));
  }
  // Rounding error (mm) of positions with one decimal, at both ends of the line.
  constexpr double rounding = 0.11;
  constexpr double smallPart = 0.05;
  constexpr double finest = 0.25; // as a fraction of a step
  if (off <= std::max(std::min(rounding, finest * even), smallPart * even))
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      along[i] = static_cast<double>(i) * even;
    }
    return along;
  }
  const double step = ComputeStep(slices);
  constexpr double closest = 0.2; // as a fraction of a step
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
    // The other slices are at multiples of the step, apart from rounding in the files.
    const double length = along.back();
    const double steps = static_cast<double>(count - 1) + missing;
    for (double& place : along)
    {
      place = std::round(place / length * steps) * length / steps;
    }
    note << missing << (missing == 1 ? " slice is" : " slices are") << " missing: gaps of up to "
         << largest << " mm are filled from the neighbouring slices";
  }
  else
  {
    note << "slices are unevenly spaced (" << smallest << " to " << largest
         << " mm): resampled to the smallest distance";
  }
  volume.Notes.push_back(note.str());
  return along;
}

} // namespace

namespace Explore
{
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
      "resample it to straight slices, e.g. with 3D Slicer's acquisition geometry regularization");
  }
}

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
  SetFrame(image, axes, first.Position);
}
} // namespace Explore

namespace
{
/// Lists the DICOM files of a folder that are not slices, such as "an RT plan (plan.dcm)", with the
/// cure.
Explore::DicomObject FindObjects(const std::string& folder)
{
  vtksys::Directory directory;
  directory.Load(folder);
  Explore::DicomObject found;
  for (unsigned long i = 0; i < directory.GetNumberOfFiles(); ++i)
  {
    const std::string name = directory.GetFile(i);
    const std::string path = folder + "/" + name;
    const bool isFile = !vtksys::SystemTools::FileIsDirectory(path);
    const auto [kind, cure] = isFile ? Explore::FindDicomObject(path) : Explore::DicomObject();
    if (!kind.empty() && found.Name.find(kind) == std::string::npos)
    {
      found.Name += (found.Name.empty() ? "" : ", ") + kind + " (" + name + ")";
      found.Cure = found.Cure.empty() ? cure : found.Cure;
    }
  }
  return found;
}

/// Returns the index of the wanted series. Throws InputError if there is no such series.
std::size_t ChooseSeries(const std::string& path, const std::vector<DicomSeries>& all, int wanted,
  const Explore::DicomFolderFacts& facts)
{
  const Explore::DicomObject other = all.empty() ? FindObjects(path) : Explore::DicomObject();
  if (!other.Name.empty())
  {
    throw InputError(path, "is a folder without DICOM slices, but has " + other.Name, other.Cure);
  }
  if (all.empty() && !facts.Device.empty())
  {
    throw InputError(path, "is a folder without DICOM slices, but " + facts.Device,
      "put a file in its place, or choose another folder");
  }
  if (all.empty())
  {
    throw InputError(path, "is a folder without DICOM slices",
      facts.HasFolders ? "choose a folder that holds DICOM slices, or folders of them"
                       : "choose a folder of DICOM slices, or a volume file");
  }
  if (wanted > static_cast<int>(all.size()))
  {
    throw InputError(path,
      "has no series " + std::to_string(wanted) + ", but" + ListSeries(all) + "\n    and no other",
      "use Series = 1 to Series = " + std::to_string(all.size()));
  }
  return wanted > 0 ? static_cast<std::size_t>(wanted - 1) : Explore::FindLargest(all);
}

vtkSmartPointer<vtkImageData> ReadPlaced(const std::string& path,
  const std::vector<DicomHeader>& slices, const std::vector<double>& along, Volume& volume)
{
  vtkSmartPointer<vtkImageData> image = Explore::ReadSlices(path, slices, volume.Notes);
  const double even = along.back() / std::max<double>(1.0, static_cast<double>(along.size() - 1));
  bool isEven = true;
  for (std::size_t i = 0; i < along.size(); ++i)
  {
    isEven = isEven && std::abs(along[i] - static_cast<double>(i) * even) <= 1e-9 * along.back();
  }
  if (along.size() > 2 && !isEven)
  {
    image = Explore::SpaceSlicesEvenly(image, along);
  }
  const double* const from = slices.front().Position;
  const double* const to = slices.back().Position;
  Explore::PlaceSlices(slices, std::sqrt(vtkMath::Distance2BetweenPoints(from, to)), image);
  return image;
}

/// Adds notes on assumptions about a series, and on the meaning of its values.
void AddNotes(const DicomSeries& series, Volume& volume)
{
  const DicomHeader& first = series.Slices.front();
  const auto note = [&](const std::string& text) { volume.Notes.push_back(text); };
  if (series.Copies > 0)
  {
    note(std::to_string(series.Copies) + (series.Copies == 1 ? " slice is" : " slices are") +
      " there twice (the same SOPInstanceUID): each is read once");
  }
  if (series.IsPlacedByLocation)
  {
    note("no ImagePositionPatient: slices are placed by SliceLocation, as if axial");
  }
  if (first.IsDetectorSpacing)
  {
    note("no PixelSpacing: ImagerPixelSpacing is used, which is measured at the detector, where "
         "everything appears larger");
  }
  if (first.Modality == "RTDOSE")
  {
    const bool isGray = first.Units == "GY" || first.Units.empty();
    note(isGray ? "values are doses in Gy"
                : "values are relative doses (DoseUnits " + first.Units + ")");
  }
  else if (!first.Units.empty())
  {
    note("values are in " + first.Units + ", as the file says");
  }
  const DicomHeader::RealWorldMap& map = first.RealWorld;
  if (map.Count > 0 || map.Slope)
  {
    const std::string others = map.Count > 1
      ? "; of " + std::to_string(map.Count) + " such maps, it is the first one"
      : std::string();
    note(map.IsUsed
        ? "values are real-world values, by the map that the file has (RealWorldValueMapping)" +
          (map.Unit.empty() || map.Unit == "1" ? std::string() : ", in " + map.Unit) + others
        : map.Slope ? "the file's map to real-world values" +
          (map.Unit.empty() ? std::string() : " in " + map.Unit) +
          " is not used, because it has a rescale"
                    : "the file's map to real-world values is a table, which is not used");
  }
  if (!series.MorePhases.empty())
  {
    note(std::to_string(series.MorePhases.size() + 1) + " phases at the same places, by " +
      series.PhasesBy + (series.HaveTimes ? "" : ", which is not a time: 10 a second are played"));
  }
}

/// Adds a note if stored values are outside the range of the map to real-world values.
void NoteUnmapped(const DicomHeader::RealWorldMap& map, vtkImageData* image, Volume& volume)
{
  if (!map.IsUsed || !(map.Range[0] < map.Range[1]))
  {
    return;
  }
  double range[2];
  image->GetScalarRange(range);
  const double ends[2] = { *map.Slope * map.Range[0] + map.Intercept,
    *map.Slope * map.Range[1] + map.Intercept };
  const double rounding = 1e-5 * std::abs(ends[1] - ends[0]);
  if (range[0] < std::min(ends[0], ends[1]) - rounding ||
    range[1] > std::max(ends[0], ends[1]) + rounding)
  {
    std::ostringstream note;
    note << "the file's map to real-world values is for stored values from " << map.Range[0]
         << " to " << map.Range[1] << ": others are mapped by it, too";
    volume.Notes.push_back(note.str());
  }
}

/// Reads all phases of a moving volume after the first. `along` has the positions of the slices.
void ReadPhases(const std::string& path, const DicomSeries& series,
  const std::vector<std::vector<DicomHeader>>& phases, const std::vector<double>& along,
  Volume& volume)
{
  constexpr double perSecond = 10.0; // phases per second if the files state no times
  const std::vector<std::string> notes = volume.Notes;
  for (std::size_t i = 1; i < phases.size(); ++i)
  {
    const double time = series.Times[i] / (series.HaveTimes ? 1.0 : perSecond);
    volume.Phases.push_back({ time, ReadPlaced(path, phases[i], along, volume) });
  }
  volume.Notes = notes; // keeps the notes once, since each phase would add the same ones
}

/// Returns the angle (degrees) between the planes of two slices or between their rows, whichever is
/// larger.
double MeasureTurn(const DicomHeader& a, const DicomHeader& b)
{
  return vtkMath::DegreesFromRadians(std::max(
    vtkMath::AngleBetweenVectors(a.Normal, b.Normal), vtkMath::AngleBetweenVectors(a.Row, b.Row)));
}

/// Throws InputError if the slices of a series are rotated against each other by more than a pixel
/// at their edge. A series of only a few slices may be part of such a set, for example of a radial
/// scan.
void CheckParallel(
  const std::string& path, const DicomSeries& series, const std::vector<DicomSeries>& all)
{
  constexpr std::size_t fewest = 5; // smallest number of slices that count as a volume
  const DicomHeader& first = series.Slices.front();
  const double edge = std::max(first.Width * first.Spacing[0], first.Height * first.Spacing[1]);
  const double pixel = std::max(first.Spacing[0], first.Spacing[1]);
  double turn = 0.0; // degrees
  for (const DicomHeader& slice : series.Slices)
  {
    turn = std::max(turn, MeasureTurn(first, slice));
  }
  turn = edge * std::sin(vtkMath::RadiansFromDegrees(turn)) > pixel ? turn : 0.0;
  bool areFew = true;
  double parts = 0.0;
  for (const DicomSeries& part : all)
  {
    const bool isPart = part.Slices.front().Series == first.Series;
    areFew = areFew && !(isPart && part.Slices.size() >= fewest);
    parts = isPart ? std::max(parts, MeasureTurn(first, part.Slices.front())) : parts;
  }
  turn = areFew ? std::max(turn, parts) : turn;
  if (turn > 0.0)
  {
    std::ostringstream fault;
    fault << "has slices that are turned against each other, by up to " << turn
          << " degrees, as in a localizer or a radial scan";
    throw InputError(
      path, fault.str(), "choose a series of parallel slices, or resample this one at its source");
  }
}

/// Loads one of several series. For `segment`, see ReadDicomSegmentation().
Volume LoadSeries(const std::string& path, const std::vector<DicomSeries>& all, std::size_t chosen,
  const Explore::DicomFolderFacts& facts = {}, int segment = 0)
{
  Volume volume;
  const DicomSeries& series = all[chosen];
  const DicomHeader& one = series.Slices.front();
  if (one.IsSegmentation())
  {
    CheckSlices(path, series.Slices, false);
    volume = Explore::ReadDicomSegmentation(path, series.Slices, segment);
  }
  else
  {
    volume.Format = "DICOM";
    volume.Axes =
      series.IsPlacedByLocation ? Explore::WorldAxes::Unknown : Explore::WorldAxes::Patient;
    volume.IsField = one.Modality == "RTDOSE";
    volume.Modality = one.Modality;
    const bool isMoving = !series.MorePhases.empty();
    std::vector<std::vector<DicomHeader>> phases{ isMoving ? series.Slices
                                                           : LeaveOutFar(series.Slices, volume) };
    phases.insert(phases.end(), series.MorePhases.begin(), series.MorePhases.end());
    const std::vector<DicomHeader>& slices = phases.front();
    for (const std::vector<DicomHeader>& phase : phases)
    {
      CheckSlices(path, phase, series.IsPlacedByLocation);
    }
    CheckParallel(path, series, all);
    const std::vector<double> along = FindPlaces(path, slices, volume);
    Explore::CheckLine(path, slices);
    AddNotes(series, volume);
    const int size[] = { one.Width, one.Height, static_cast<int>(slices.size()) };
    Explore::CheckSize(path, size); // checked before the pixels are unpacked, because they may be
                                    // unreadable
    Explore::CheckMemory(path, Explore::MeasureSlices(slices), slices.size() * phases.size());
    Explore::CorrectHighBit(path, phases, volume.Notes);
    volume.Image = ReadPlaced(path, slices, along, volume);
    NoteUnmapped(one.RealWorld, volume.Image, volume);
    ReadPhases(path, series, phases, along, volume);
  }
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    volume.Series.push_back(all[i].Describe(i + 1));
  }
  volume.SeriesNumber = static_cast<int>(chosen) + 1;
  if (all.size() > 1)
  {
    volume.Notes.push_back("series " + all[chosen].Describe(chosen + 1) + ", of " +
      std::to_string(all.size()) + " series; Series = N takes another one:" + ListSeries(all));
  }
  if (!facts.Device.empty())
  {
    volume.Notes.push_back(facts.Device + ": left out");
  }
  for (const DicomSeries& other : all)
  {
    const DicomHeader& slice = other.Slices.front();
    if (&other != &series && slice.IsSegmentation())
    {
      volume.Notes.push_back(
        NameOf(slice) + " is a segmentation (SEG), which can be given as labels");
    }
  }
  return volume;
}
} // namespace

namespace Explore
{
Volume ReadDicomFolder(const std::string& path, int series)
{
  DicomFolderFacts facts;
  const std::vector<DicomSeries> all = ListDicomSeries(path, facts);
  return LoadSeries(path, all, ChooseSeries(path, all, series, facts), facts);
}

Volume ReadDicomFile(const std::string& path, int series)
{
  const std::string whole = vtksys::SystemTools::CollapseFullPath(path);
  const std::string folder = vtksys::SystemTools::GetFilenamePath(whole);
  DicomHeader header;
  if (!ReadDicomHeader(whole, header))
  {
    return ReadDicomFolder(folder, series);
  }
  if (header.Frames > 1 || header.IsSegmentation())
  {
    // A file with a complete volume is read alone, whatever other files are in its folder.
    const std::vector<DicomSeries> own = SortDicomSlices(ReadDicomSlices(whole));
    if (header.IsSegmentation() && own.size() == 1)
    {
      Volume segments = LoadSeries(path, own, 0, {}, series);
      ListSegments(segments, series);
      return segments;
    }
    Volume volume = LoadSeries(path, own, ChooseSeries(path, own, series, {}));
    // Number of directory entries: the file, the folder itself and its parent.
    constexpr unsigned long alone = 3;
    if (vtksys::Directory::GetNumberOfFilesInDirectory(folder) > alone && !header.IsSegmentation())
    {
      volume.Notes.emplace_back("only this file is read, not the files beside it");
    }
    return volume;
  }
  if (series > 0)
  {
    return ReadDicomFolder(folder, series);
  }
  DicomFolderFacts facts;
  const std::vector<DicomSeries> all = ListDicomSeries(folder, facts, whole);
  const auto found =
    std::find_if(all.begin(), all.end(), [&](const DicomSeries& one) { return one.Holds(whole); });
  if (found == all.end())
  {
    throw InputError(path, "no longer exists", "choose the folder of its series");
  }
  return LoadSeries(path, all, static_cast<std::size_t>(found - all.begin()), facts);
}

bool IsDicomFile(const std::string& path)
{
  DicomHeader header;
  return vtksys::SystemTools::UpperCase(vtksys::SystemTools::GetFilenameName(path)) == "DICOMDIR" ||
    ReadDicomHeader(path, header);
}
} // namespace Explore
