// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The sources on the input ports of a vtkVolumeHapticsFilter, run outside its own update.
 */
#ifndef FilterSources_h
#define FilterSources_h

#include <new>
#include <string>

class vtkAlgorithm;
class vtkImageData;

namespace VolumeHaptics
{

/** Memory ran out in the source of an input port. */
struct SourceLacksMemory : std::bad_alloc
{
  explicit SourceLacksMemory(int port)
    : Port(port)
  {
  }
  const int Port;
};

/**
 * Runs the sources of the image, the surface and the labels; false if one of them failed. Throws
 * SourceLacksMemory.
 */
bool UpdateSources(vtkAlgorithm* filter);

/** Follows the error of a bake after UpdateSources() returned false. */
inline constexpr char FailedSource[] =
  // If a source threw, VTK's executive thinks that it still runs.
  " A source of this filter failed: see its errors. If memory ran out in it before, VTK can't run "
  "it again: connect a new source.";

/** The error if there is no memory to bake an image (null if it is unknown), with the cure. */
std::string DescribeLackOfMemory(vtkImageData* image);

} // namespace VolumeHaptics

#endif
