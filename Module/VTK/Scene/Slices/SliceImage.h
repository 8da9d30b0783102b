// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The image whose slices are shown: what a device feels, as it is felt now.
 */
#ifndef SliceImage_h
#define SliceImage_h

#include "VTK/Scene/Slices/SliceAxes.h"
#include "VTK/Scene/Volumes/CarvedImage.h"
#include "VTK/Scene/Volumes/FilterCarving.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <string>

class vtkHapticDevice;

namespace VolumeHaptics
{

class SliceImage
{
public:
  /**
   * Takes the image that the application has chosen; or without one, that of the device's filter:
   * its frame at the data time, or the coarse level of a volume that is larger than memory. Returns
   * whether the samples or their geometry have changed. Does not copy samples.
   */
  bool Follow(vtkHapticDevice* device, vtkImageData* chosen);

  /**
   * Looks for tissue that a tool of the device's filter has removed from what is shown. Returns
   * whether there is more or less of it than before.
   */
  bool FollowRemoval(vtkHapticDevice* device);

  /** Whether there is something to show. */
  bool HasSamples() const { return this->Samples != nullptr; }

  /**
   * The image along its own axes, with its origin in index (0, 0, 0) and without its direction, so
   * that a slice of it is a rectangle: VTK 9.1's mappers of slices ignore directions.
   */
  vtkImageData* GetPlain() const { return this->Plain; }

  /**
   * An image that has a slice across an axis of it: the plain one, or if tissue was removed, one of
   * that slice alone, with what is left.
   */
  vtkImageData* GetLayer(int axis, int number);

  /** See FindSliceAxes. */
  std::array<SliceAxes, 3> FindAxes(bool anatomical) const
  {
    return FindSliceAxes(this->Image, anatomical);
  }

  ///@{
  /** From the world to continuous indices, within the image, and back. */
  std::array<double, 3> FindIndex(const double world[3]) const;
  void FindWorld(const std::array<double, 3>& index, double world[3]) const;
  ///@}
  std::array<double, 3> Clamp(std::array<double, 3> index) const;
  std::array<double, 3> GetCentre() const;

  /**
   * What is left of the nearest sample: its component, or of several the magnitude, as
   * UsesMagnitude tells.
   */
  double GetValue(const std::array<double, 3>& index) const;
  /** "magnitude " or "component 1 of 3: " in front of a value; else empty. */
  std::string DescribeComponents() const;
  bool UsesMagnitude() const { return this->IsMagnitude; }
  int GetComponent() const { return this->Component; }

  /** Where 1 % of some values are below, and where 0.5 % are above, with all tissue. */
  std::array<double, 2> FindUsualValues() const;

private:
  /** A slice of what is left. */
  struct Layer
  {
    vtkSmartPointer<vtkImageData> Image;
    int Number = 0;
  };

  bool IsCarved() const { return this->Removed.Removal != nullptr; }
  void CopyLeftPart(const int part[6], vtkDataArray* left) const;
  double GetValueOf(vtkDataArray* samples, vtkIdType id) const;

  vtkSmartPointer<vtkImageData> Image; ///< in the world
  vtkSmartPointer<vtkDataArray> Samples;
  vtkNew<vtkImageData> Plain;
  RemovedTissue Removed;
  CarvedCover Cover = CarvedCover::Nearest;
  std::array<Layer, 3> Layers; ///< by axis
  vtkMTimeType Time = 0;       ///< of image and samples, when they were taken
  int Component = 0;
  bool IsMagnitude = false;
};

} // namespace VolumeHaptics

#endif
