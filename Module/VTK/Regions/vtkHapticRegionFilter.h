// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticRegionFilter
 * @brief   a region of a volume that can be touched as if it were the whole volume
 *
 * Cuts a region out of the image on port 0, and adds the facts that vtkVolumeHapticsFilter needs
 * about the whole volume. If a volume is on a server, or too large for the memory at the hand, an
 * application sends small regions around the tip from time to time:
 *
 *   regions->SetInputConnection(reader->GetOutputPort());  // where the whole volume is
 *   regions->SetRegion(wanted);                            // around the tip
 *   regions->Update();
 *   haptics->SetInputData(regions->GetOutput());           // where the hand is
 *
 * The output has the touched array (SetInputArrayToProcess; default the active scalars). It keeps
 * origin, spacing, direction and the indices that the region has in the whole. It has the field
 * arrays
 *
 *   HapticWholeExtent   6 integers; the extent of the whole volume
 *   HapticNoise         scalar units, one number a component, 0 or more; standard deviation of the
 *                       noise of the whole, which vtkHapticProperty uses for DistinctnessFromNoise
 *   HapticBorderValue   scalar, one number a component; stands in for samples that are NaN or
 *                       infinite: the first finite corner of the whole. If a corner is not finite,
 *                       or has a number for missing values, all such samples are outside, and are
 *                       filled with the least value inside
 *   HapticSolid         optional, four numbers a component for vtkHapticProperty's SolidFromImage
 *                       and ApplyPreset(): the value at which the background of the whole ends, the
 *                       smallest value that is solid (equal to the first one if there is no
 *                       background), and the medians of the background and of what is brighter
 *   HapticShift         optional, a tuple of five numbers a component for vtkHapticProperty's
 *                       ShiftFromImage: what to add to the values for Hounsfield units, the value
 *                       of air, 1 if they can't be Hounsfield units, and the range looked at
 *   HapticWholeTime     optional, a number that changes whenever the whole changes. If regions of
 *                       the same whole have the same number, one replaces the other under a
 *                       pressing hand without a change of the force
 *
 * and, if its samples only stand in for those of the whole, such as samples of a coarser level
 * while the finer ones are late (vtkHapticRegionSource::SetCoarseImage), the array
 *
 *   HapticShare         above 0 and at most 1; the fraction of the force that is felt there
 *
 * and, if samples that are outside or not numbers have not been filled yet,
 *
 *   HapticOutside       four numbers a component: 1 if NaN and infinity are outside, the number for
 *                       missing values or NaN, the value with which both are felt (not for labels),
 *                       and the fraction of the samples that are not numbers, if these are holes
 *
 * vtkVolumeHapticsFilter treats an image with these arrays as a region. At borders inside the
 * whole, the force does not end at a surface but fades (vtkHapticState::GetResidency). The whole
 * force is felt at least 13 voxels away from such borders, with the default settings, and 9 with
 * materials of the kernel (SetMaterialPlacementToKernel): see Documentation/method.md, "Regions of
 * a volume".
 *
 * Collecting the noise needs the whole once; the result is kept until the input changes. A subclass
 * for volumes that lie in pieces on several processes overrides the three protected virtual
 * functions (C++ only), and includes "Core/Field/NoiseSamples.h".
 *
 * A vtkHapticRegionSource plans and fetches regions by itself, also through a function of yours.
 *
 * @sa vtkHapticRegionSource, vtkVolumeHapticsFilter, vtkHapticDevice
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
struct OutsideSamples;
struct BackgroundLevel;
struct StoredShift;
} // namespace VolumeHaptics
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
   * The region (an extent, in the whole's indices); it is clipped to the whole. Default (0, -1, 0,
   * -1, 0, -1): the whole. A region outside the whole is an error.
   */
  vtkSetVector6Macro(Region, int);
  vtkGetVector6Macro(Region, int);
  ///@}

protected:
  vtkHapticRegionFilter();
  ~vtkHapticRegionFilter() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  /** Requests the whole volume. A subclass may request only the piece of this process. */
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

#ifndef __VTK_WRAP__
  using SamplesOfComponents = std::vector<VolumeHaptics::NoiseSamples>;

  /**
   * Returns whether the samples gathered last are still valid for the input. `time` is the input's
   * modification time in this process. All processes must return the same value. Default: true if
   * the samples were gathered at `time`.
   */
  virtual bool IsCurrent(vtkMTimeType time);

  /**
   * Merges the samples of this process's piece (one entry for each component; none if the piece has
   * no array) with those of the other pieces: see NoiseSamples::Merge. Afterwards the entries cover
   * the whole on every process, or at least on every process that uses the output. Default: does
   * nothing, because the piece is the whole.
   */
  virtual void GatherSamples(SamplesOfComponents& samples);

  /**
   * Fills an output, which has the geometry of a region, with the region's part of the array.
   * `piece` is the piece of this process; the array may be null if the piece is empty. Default:
   * copies the region, which must be completely inside the piece. Returns false, with the reason in
   * `error`, if a part of the region is missing.
   */
  virtual bool GatherRegion(vtkImageData* piece, vtkDataArray* array, const int region[6],
    vtkImageData* output, std::string& error);

  /**
   * Copies the samples in both extents from one array to the other. Each array has one tuple per
   * sample of its extent.
   */
  static void CopySamples(
    vtkDataArray* from, const int fromExtent[6], vtkDataArray* to, const int toExtent[6]);

  /**
   * Collects the noise samples of the whole volume that are in a piece, one entry per component.
   */
  static SamplesOfComponents CollectSamples(
    vtkDataArray* array, const int extent[6], const int whole[6]);

private:
  void WriteFacts(const int whole[6], vtkImageData* output);
  bool ClipRegion(const int whole[6], int region[6]) const;

  std::vector<double> Noise; // standard deviation of each component's noise
  std::vector<double> BorderValues;
  std::vector<VolumeHaptics::OutsideSamples> Outside;
  std::vector<VolumeHaptics::BackgroundLevel> Solids;
  std::vector<VolumeHaptics::StoredShift> Shifts;
#endif

  int Region[6] = { 0, -1, 0, -1, 0, -1 };
  vtkMTimeType GatheredTime = 0;

private:
  vtkHapticRegionFilter(const vtkHapticRegionFilter&) = delete;
  void operator=(const vtkHapticRegionFilter&) = delete;
};

#endif
