// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Gathers samples from the pieces of a volume on several processes.
 */
#ifndef HapticPieceGather_h
#define HapticPieceGather_h

#include "vtkHapticRegionFilter.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkMultiProcessController;

namespace VolumeHapticsLive
{

/**
 * All processes of the controller have to call its functions together, with the same array type,
 * number of components and name.
 */
class HapticPieceGather
{
public:
  /** See vtkHapticRegionFilter::CopySamples. */
  using SampleCopier = void (*)(
    vtkDataArray* from, const int fromExtent[6], vtkDataArray* to, const int toExtent[6]);

  HapticPieceGather(
    vtkMultiProcessController* controller, int arrayType, int components, std::string arrayName);

  /** See vtkHapticRegionFilter::GatherSamples. There is an entry per component. */
  void GatherSamples(const int whole[6], std::vector<VolumeHaptics::NoiseSamples>& samples) const;

  /** See vtkHapticRegionFilter::GatherRegion. On other processes, the output is empty. */
  bool GatherRegion(vtkImageData* piece, vtkDataArray* array, const int region[6],
    SampleCopier copySamples, vtkImageData* output, std::string& error) const;

private:
  void ShareParts(const std::vector<int>& part, std::vector<std::vector<int>>& others) const;

  vtkMultiProcessController* const Controller;
  const int ArrayType;
  const int Components;
  const std::string ArrayName;
};

} // namespace VolumeHapticsLive

#endif
