// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/Labels/SegmentationFile.h"

#include "Core/Platform/Files.h"
#include "Core/Platform/HapticFiles.h"
#include "VTK/Base/ArrayMemory.h"
#include "VTK/Material/Labels/LabelFiles.h"
#include "VTK/Material/Labels/NrrdLabels.h"

#include "vtkHapticLabelTable.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <new>
#include <string>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/** Largest compression ratio of deflate, reached for zeros (zlib's technical details). */
constexpr double LargestCompression = 1032.0;
constexpr std::size_t MostAtOnce = 1 << 24; // bytes per call of zlib, whose counts have 32 bits

struct NrrdFile
{
  std::string Name;
  SegmentationHeader Header;
  NrrdImage Image;
};

/** Reads the header. On failure, returns false, with the reason and the cure in `error`. */
bool OpenNrrdFile(const std::string& name, NrrdFile& file, std::string& error)
{
  file.Name = name;
  std::string bytes;
  if (!ReadLabelBytes(name, bytes, error))
  {
    return false;
  }
  if (!IsNrrd(bytes))
  {
    error = "it is no NRRD file. Give a .seg.nrrd of 3D Slicer; VTK reads other label images, and "
            "vtkHapticLabelTable their names.";
    return false;
  }
  if (!ReadSegmentationHeader(bytes, file.Header, error) ||
    !ReadNrrdImage(file.Header, file.Image, error))
  {
    return false;
  }
  Files::Status status;
  const double size = Files::GetStatus(name, status) ? static_cast<double>(status.st_size) : 0.0;
  // Check the file's size first, because the memory is allocated before the samples are read.
  if (static_cast<double>(file.Image.CountBytes()) > size * LargestCompression)
  {
    error = "it has fewer samples than its header says. Check that the file is complete.";
    return false;
  }
  return true;
}

/**
 * Reads one label per voxel into memory that is filled with zeros. On failure, returns false, with
 * the reason and the cure in `error`.
 */
bool ReadNrrdFile(const NrrdFile& file, int* labels, std::string& error)
{
  // Decompress from the end of the header; uncompressed samples are read together with it.
  const std::size_t begin = file.Image.IsCompressed ? file.Header.Size : 0;
  const GzipFile opened = OpenGzipFile(file.Name, begin, error);
  if (!opened)
  {
    return false;
  }
  const auto read = [&opened](char* to, std::size_t size)
  {
    std::size_t had = 0;
    while (had < size)
    {
      const auto part = static_cast<unsigned>(std::min(size - had, MostAtOnce));
      const int got = gzread(opened.get(), to + had, part);
      if (got <= 0)
      {
        break;
      }
      had += static_cast<std::size_t>(got);
    }
    return had;
  };
  std::string header(file.Header.Size - begin, '\0');
  if (read(header.data(), header.size()) != header.size())
  {
    error = "it changed while it was read. Read it again.";
    return false;
  }
  if (!ReadNrrdSamples(file.Header, file.Image, read, labels, error))
  {
    return false;
  }
  // Read past the end of compressed samples, which makes zlib verify their checksum.
  char rest = 0;
  int number = Z_OK;
  if (file.Image.IsCompressed && gzread(opened.get(), &rest, 1) <= 0)
  {
    (void)gzerror(opened.get(), &number);
  }
  if (number != Z_OK && number != Z_STREAM_END)
  {
    error = "its samples are damaged or truncated. Check that the file is complete.";
    return false;
  }
  return true;
}

bool ReadLabelImage(const NrrdFile& file, vtkImageData* image, std::string& error)
{
  const NrrdImage& read = file.Image;
  vtkNew<vtkIntArray> labels;
  labels->SetName("Labels");
  error = "there is not enough memory for its voxels. Crop it, or free some memory.";
  const std::size_t voxels = read.CountVoxels();
  if (voxels == 0 || voxels > std::size_t{ std::numeric_limits<int>::max() } * 1000)
  {
    return false;
  }
  try
  {
    AllocateTuples(labels, static_cast<vtkIdType>(voxels));
    labels->Fill(0.0);
    if (!ReadNrrdFile(file, labels->GetPointer(0), error))
    {
      return false;
    }
  }
  catch (const std::bad_alloc&)
  {
    return false;
  }
  image->SetDimensions(
    static_cast<int>(read.Size[0]), static_cast<int>(read.Size[1]), static_cast<int>(read.Size[2]));
  image->SetSpacing(read.Spacing.data());
  image->SetOrigin(read.Origin.data());
  image->SetDirectionMatrix(read.Directions.data());
  image->GetPointData()->SetScalars(labels);
  return true;
}

/**
 * Moves a segment to the end of the list, so that its voxels belong to it wherever segments
 * overlap. On failure, returns false, with the reason and the cure in `error`.
 */
bool PutLast(int segment, NrrdFile& file, std::string& error)
{
  std::vector<NrrdSegment>& segments = file.Header.Segments;
  const auto count = static_cast<int>(segments.size());
  if (segment < 0 || segment > count)
  {
    error = "it has " + std::to_string(count) + " segments, and none with the number " +
      std::to_string(segment) + ". " +
      (count > 0 ? "Take Series = 1 to Series = " + std::to_string(count) : "Leave Series out") +
      ".";
    return false;
  }
  if (segment > 0)
  {
    std::vector<NrrdSegment> ordered = segments;
    std::stable_sort(ordered.begin(), ordered.end(),
      [](const NrrdSegment& a, const NrrdSegment& b) { return a.Label < b.Label; });
    const int label = ordered[static_cast<std::size_t>(segment - 1)].Label;
    std::stable_partition(segments.begin(), segments.end(),
      [label](const NrrdSegment& one) { return one.Label != label; });
  }
  return true;
}

void KeepLabel(int label, vtkImageData* image)
{
  auto* const labels = vtkIntArray::SafeDownCast(image->GetPointData()->GetScalars());
  std::replace_if(
    labels->Begin(), labels->End(), [label](int one) { return one != label; }, 0);
}

} // namespace

std::string ReadSegmentation(
  const std::string& fileName, vtkImageData* image, vtkHapticLabelTable* table, int segment)
{
  image->Initialize();
  NrrdFile file;
  std::string error;
  const bool isRead = OpenNrrdFile(fileName, file, error) && PutLast(segment, file, error) &&
    ReadLabelImage(file, image, error);
  if (!isRead)
  {
    return "No segmentation can be read from \"" + Printable(fileName) + "\": " + error;
  }
  if (segment > 0)
  {
    KeepLabel(file.Header.Segments.back().Label, image);
  }
  for (const NrrdSegment& segment : file.Header.Segments)
  {
    if (segment.Entry.Name)
    {
      table->SetLabelName(segment.Label, *segment.Entry.Name);
    }
    if (segment.Entry.Color)
    {
      table->SetColor(segment.Label, segment.Entry.Color->data());
    }
  }
  return {};
}

} // namespace VolumeHaptics
