// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/Labels/NrrdFile.h"

#include "VTK/Material/Labels/GzipFile.h"
#include "VTK/Material/Labels/LabelFiles.h"

#include <algorithm>
#include <cstddef>
#include <sys/stat.h>

namespace VolumeHaptics
{
namespace
{

/** Largest compression ratio of deflate, reached with zeros (zlib's technical details). */
constexpr double LargestCompression = 1032.0;
constexpr std::size_t MostAtOnce = 1 << 24; // bytes per call of zlib, which counts with 32 bits

} // namespace

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
  struct stat status;
  const double size = stat(name.c_str(), &status) == 0 ? static_cast<double>(status.st_size) : 0.0;
  // Check the size first, because the memory is allocated before the samples are read.
  if (static_cast<double>(file.Image.CountBytes()) > size * LargestCompression)
  {
    error = "it has fewer samples than its header says. Check that the file is complete.";
    return false;
  }
  return true;
}

bool ReadNrrdFile(const NrrdFile& file, int* labels, std::string& error)
{
  // Compressed samples begin after the header; other samples are read together with it.
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
  // Read on behind compressed samples: zlib then checks their checksum.
  char rest = 0;
  int number = Z_OK;
  if (file.Image.IsCompressed && gzread(opened.get(), &rest, 1) <= 0)
  {
    (void)gzerror(opened.get(), &number);
  }
  if (number != Z_OK && number != Z_STREAM_END)
  {
    error = "its samples are damaged, or cut off. Check that the file is complete.";
    return false;
  }
  return true;
}

} // namespace VolumeHaptics
