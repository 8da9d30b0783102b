// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Runs the sources on the input ports of a vtkVolumeHapticsFilter outside the filter's own update.
 */
#ifndef FilterSources_h
#define FilterSources_h

#include <new>
#include <string>

class vtkAlgorithm;
class vtkImageData;

namespace VolumeHaptics
{

/** Thrown if memory ran out in the source of an input port, whose number is Port. */
struct SourceLacksMemory : std::bad_alloc
{
  explicit SourceLacksMemory(int port)
    : Port(port)
  {
  }
  const int Port;
};

/**
 * Runs the sources of the image, the surface and the labels. Returns false if one of them failed.
 * Throws SourceLacksMemory.
 */
bool UpdateSources(vtkAlgorithm* filter);

/** Text that is appended to a bake's error after UpdateSources() returned false. */
inline constexpr char FailedSource[] =
  // VTK's executive considers a source that threw to be still running, so it can't run again.
  " A source of this filter failed: see its errors. If memory ran out in it before, VTK can't run "
  "it again: connect a new source.";

/**
 * Returns the error, with the cure, for a lack of memory while an image is baked. `image` is null
 * if it is unknown.
 */
std::string DescribeLackOfMemory(vtkImageData* image);

} // namespace VolumeHaptics

#endif
