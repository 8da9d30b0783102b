// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticRegionFilter
 * @brief   a part of a volume that can be touched as if the whole were there
 *
 * Crops the image on port 0 to Region, with the array that is touched (SetInputArrayToProcess;
 * default the active scalars), and writes down what vtkVolumeHapticsFilter has to know of the
 * whole. Where a volume is too large to be where the hand is (on a server, out of core), a small
 * region around the tip is sent from time to time; vtkHapticRegionPlanner says which and when.
 *
 * The output keeps origin, spacing, direction and the indices that the region has in the whole, and
 * has the field arrays
 *
 *   HapticWholeExtent   6 integers; the extent of the whole volume
 *   HapticNoise         scalar units, one number a component, 0 or more; standard deviation of the
 *                       noise of the whole, from which vtkHapticProperty takes
 *                       DistinctnessFromNoise
 *   HapticBorderValue   scalar, one number a component; stands in for samples that are NaN or
 *                       infinite: the first finite corner of the whole
 *   HapticWholeTime     optional, a number; another one whenever the whole has changed. Regions of
 *                       the same whole with the same number take each other's place under a hand
 *                       that presses, without a trace
 *
 * vtkVolumeHapticsFilter takes an image with these for a region. At borders that are
 * not the whole's own, the force then does not end at a surface but fades
 * (vtkHapticDevice::GetResidency).
 *
 * Collecting the noise needs the whole once; it is kept until the input changes. A subclass for
 * volumes that lie in pieces on several processes overrides the three protected virtual functions
 * (C++ only), and includes "Core/Field/NoiseSamples.h".
 *
 * @sa vtkHapticRegionPlanner, vtkVolumeHapticsFilter, vtkHapticDevice
 */
#ifndef vtkHapticRegionFilter_h
#define vtkHapticRegionFilter_h

#include "vtkImageAlgorithm.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#ifndef __VTK_WRAP__
#include <string> // for std::string
#include <vector> // for std::vector

namespace VolumeHaptics
{
struct NoiseSamples;
}
#endif

class vtkDataArray;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticRegionFilter : public vtkImageAlgorithm
{
public:
  static vtkHapticRegionFilter* New();
  vtkTypeMacro(vtkHapticRegionFilter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Which part (an extent, in the whole's indices), clipped to the whole. Default (0, -1, 0, -1, 0,
   * -1): the whole. One that has no part of the whole in it is an error.
   */
  vtkSetVector6Macro(Region, int);
  vtkGetVector6Macro(Region, int);
  ///@}

  ///@{
  /** The names of the field arrays, as above. */
  static const char* GetWholeExtentName() { return "HapticWholeExtent"; }
  static const char* GetNoiseName() { return "HapticNoise"; }
  static const char* GetBorderValueName() { return "HapticBorderValue"; }
  static const char* GetWholeTimeName() { return "HapticWholeTime"; }
  ///@}

protected:
  vtkHapticRegionFilter();
  ~vtkHapticRegionFilter() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  /** Asks for the whole. A subclass may ask for this process' piece. */
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

#ifndef __VTK_WRAP__
  using SamplesOfComponents = std::vector<VolumeHaptics::NoiseSamples>;

  /**
   * Whether the samples that were gathered last still hold, for an input that is as it was at a
   * time (here). Every process has to say the same. Default: whether it is the time of the last
   * ones.
   */
  virtual bool IsCurrent(vtkMTimeType time);

  /**
   * Completes what the piece that is here gave (one entry a component; none where it has no array)
   * with what the other pieces give: see NoiseSamples::Merge. Afterwards, the entries of all
   * processes, or at least of those that use the output, are those of the whole. Default: nothing,
   * since the piece is the whole.
   */
  virtual void GatherSamples(SamplesOfComponents& samples);

  /**
   * Writes the array of a region of the whole, of which `piece` holds the part here, into an output
   * that has its geometry; the array may be null where the piece is empty. Default: a copy, which
   * needs all of it in the piece. False, with the reason in `error`, where parts are missing.
   */
  virtual bool GatherRegion(vtkImageData* piece, vtkDataArray* array, const int region[6],
    vtkImageData* output, std::string& error);

  /**
   * Copies the samples that both extents have from one array to the other; both have a tuple for
   * every sample.
   */
  static void CopySamples(
    vtkDataArray* from, const int fromExtent[6], vtkDataArray* to, const int toExtent[6]);

  /** The samples of its whole that a piece holds, one entry a component. */
  static SamplesOfComponents CollectSamples(
    vtkDataArray* array, const int extent[6], const int whole[6]);

private:
  void WriteFacts(const int whole[6], vtkImageData* output);
  bool ClipRegion(const int whole[6], int region[6]) const;

  std::vector<double> Noise; // a component each
  std::vector<double> BorderValues;
#endif

  int Region[6] = { 0, -1, 0, -1, 0, -1 };
  vtkMTimeType GatheredTime = 0;

private:
  vtkHapticRegionFilter(const vtkHapticRegionFilter&) = delete;
  void operator=(const vtkHapticRegionFilter&) = delete;
};

#endif
