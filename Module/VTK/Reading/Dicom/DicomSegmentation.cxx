// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/Dicom/DicomSegmentation.h"

#include "VTK/Base/ArrayMemory.h"
#include "VTK/Reading/Dicom/DicomFolder.h"
#include "VTK/Reading/Dicom/DicomPixels.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/VolumeChecks.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using Explore::DicomHeader;
using Explore::InputError;
using Explore::Volume;

constexpr double SAME_PLANE = 1e-2; // mm
// Largest deviation of a position from a whole number of steps, as a fraction of a step.
constexpr double OFF = 0.1;
constexpr double MOST_EMPTY = 1000.0;

/// Returns one frame per position, in order. Frames of different segments may have the same
/// position.
std::vector<DicomHeader> FindPlanes(const std::vector<DicomHeader>& frames)
{
  std::vector<DicomHeader> places;
  for (const DicomHeader& frame : frames)
  {
    if (places.empty() || frame.Along - places.back().Along > SAME_PLANE)
    {
      places.push_back(frame);
    }
  }
  return places;
}

/// Returns whether the distances of all positions are multiples of a step. Gaps are allowed,
/// because files omit frames without voxels.
bool IsStep(const std::vector<DicomHeader>& places, double step)
{
  return step > 0.0 &&
    std::all_of(places.begin(), places.end(),
      [&](const DicomHeader& place)
      {
        const double steps = (place.Along - places.front().Along) / step;
        return std::abs(steps - std::round(steps)) < OFF;
      });
}

double FindPlaneStep(const std::string& path, const std::vector<DicomHeader>& places)
{
  double smallest = std::numeric_limits<double>::max();
  for (std::size_t i = 1; i < places.size(); ++i)
  {
    smallest = std::min(smallest, places[i].Along - places[i - 1].Along);
  }
  const DicomHeader& first = places.front();
  const double told = first.Step != 0.0 ? std::abs(first.Step) : first.Thickness;
  if (places.size() < 2)
  {
    return told > 0.0 ? told : 1.0;
  }
  for (const double step : { told, smallest })
  {
    if (IsStep(places, step))
    {
      return step;
    }
  }
  throw InputError(path, "is a segmentation whose slices are unevenly spaced",
    "resample it on the grid of its volume, e.g. in 3D Slicer");
}

void ReadSegmentNames(const std::string& file, vtkHapticLabelTable* table)
{
  for (const Explore::DicomSegment& segment : Explore::ReadDicomSegments(file))
  {
    table->SetLabelName(segment.Number,
      segment.Name.empty() ? "segment " + std::to_string(segment.Number) : segment.Name);
    if (segment.Color.size() == 3)
    {
      table->SetColor(segment.Number, segment.Color.data());
    }
  }
}
} // namespace

namespace Explore
{
Volume ReadDicomSegmentation(
  const std::string& path, const std::vector<DicomHeader>& frames, int segment)
{
  const std::vector<DicomHeader> places = FindPlanes(frames);
  CheckLine(path, places);
  const double step = FindPlaneStep(path, places);
  const double from = places.front().Along, to = places.back().Along;
  if ((to - from) / step > MOST_EMPTY + 8.0 * static_cast<double>(places.size()))
  {
    throw InputError(path, "is a segmentation with slices far from each other",
      "resample it on the grid of its volume, e.g. in 3D Slicer");
  }
  Volume volume;
  volume.Format = "DICOM segmentation";
  volume.Axes = WorldAxes::Patient;
  volume.Modality = frames.front().Modality;
  // Add empty slices on both sides of a single slice, because labels must form a volume.
  const int beside = places.size() > 1 ? 0 : 2;
  const int count = static_cast<int>(std::lround((to - from) / step)) + 1 + 2 * beside;
  const DicomHeader& first = places.front();
  CheckMemory(path, 2.0 * first.Width * first.Height, static_cast<std::size_t>(count));
  volume.Image = vtkSmartPointer<vtkImageData>::New();
  volume.Image->SetDimensions(first.Width, first.Height, count);
  VolumeHaptics::AllocateScalars(volume.Image, VTK_UNSIGNED_SHORT, 1);
  volume.Image->GetPointData()->GetScalars()->SetName("Labels");
  volume.Image->GetPointData()->GetScalars()->Fill(0.0);
  volume.LabelTable = vtkSmartPointer<vtkHapticLabelTable>::New();
  ReadSegmentNames(first.File, volume.LabelTable);
  const vtkIdType named = volume.LabelTable->GetNumberOfLabels();
  if (segment > named)
  {
    throw InputError(path,
      "has " + std::to_string(named) + " segments, and none with the number " +
        std::to_string(segment),
      "use Series = 1 to Series = " + std::to_string(named));
  }
  const int alone = segment > 0 ? volume.LabelTable->GetLabel(segment - 1) : 0;
  std::vector<DicomHeader> ordered = frames;
  std::stable_sort(ordered.begin(), ordered.end(),
    [](const DicomHeader& a, const DicomHeader& b) { return a.Segment < b.Segment; });
  const bool areNumbers = first.SegmentationType == "LABELMAP";
  const bool areParts = first.SegmentationType == "FRACTIONAL";
  DicomPixels pixels;
  vtkIdType shared = 0;
  for (DicomHeader frame : ordered)
  {
    const std::string bytes = pixels.Read(path, frame);
    const int k = static_cast<int>(std::lround((frame.Along - from) / step)) + beside;
    auto* const labels = static_cast<unsigned short*>(volume.Image->GetScalarPointer(0, 0, k));
    const auto size = static_cast<std::size_t>(frame.Bits / 8);
    const double least = areParts ? 0.5 * frame.Whole : 0.5;
    for (std::size_t i = 0; i < bytes.size() / size; ++i)
    {
      unsigned sample = 0;
      for (std::size_t b = 0; b < size; ++b)
      {
        const std::size_t at = i * size + (frame.IsBig ? b : size - 1 - b);
        sample = sample << 8 | static_cast<unsigned char>(bytes[at]);
      }
      const auto label = static_cast<unsigned short>(areNumbers ? sample : frame.Segment);
      if (sample >= least && (alone == 0 || label == alone))
      {
        shared += labels[i] > 0;
        labels[i] = label;
      }
    }
  }
  std::vector<DicomHeader> ends{ places.front(), places.back() };
  for (int axis = 0; axis < 3; ++axis)
  {
    ends[0].Position[axis] -= beside * step * first.Normal[axis];
    ends[1].Position[axis] += beside * step * first.Normal[axis];
  }
  PlaceSlices(ends, std::sqrt(vtkMath::Distance2BetweenPoints(ends[0].Position, ends[1].Position)),
    volume.Image);
  volume.Notes.push_back(
    "a segmentation of " + std::to_string(named) + (named == 1 ? " segment" : " segments"));
  if (areParts)
  {
    volume.Notes.emplace_back(
      "it gives fractions of voxels: a voxel belongs to the segment from one half on");
  }
  if (shared > 0)
  {
    volume.Notes.push_back(std::to_string(shared) +
      " voxels are in several segments: they belong to the one with the highest number; Series = 1 "
      "to "
      "Series = " +
      std::to_string(named) + " read one segment of the file alone");
  }
  if (beside > 0)
  {
    volume.Notes.emplace_back("it has a single slice: empty ones are added on both sides");
  }
  return volume;
}
} // namespace Explore
