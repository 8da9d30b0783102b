// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The image whose slices are shown: the data that a device feels now.
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
   * Updates the image: the application's choice, or else the image of the device's filter, which is
   * the frame at the data time, or the coarse level of a volume larger than memory. Returns whether
   * the samples or their geometry have changed. Does not copy samples.
   */
  bool Follow(vtkHapticDevice* device, vtkImageData* chosen);

  /**
   * Checks how much tissue a tool of the device's filter has removed from the shown image. Returns
   * whether this has changed.
   */
  bool FollowRemoval(vtkHapticDevice* device);

  /** Whether there is an image to show. */
  bool HasSamples() const { return this->Samples != nullptr; }

  /**
   * The image along its own axes, with its origin in index (0, 0, 0) and without its direction, so
   * that a slice of it is a rectangle: VTK 9.1's mappers of slices ignore directions.
   */
  vtkImageData* GetPlain() const { return this->Plain; }

  /**
   * An image with a slice across one of its axes: the plain image, or if tissue was removed, an
   * image of that slice alone, with the remaining tissue.
   */
  vtkImageData* GetLayer(int axis, int number);

  /** See FindSliceAxes. */
  std::array<SliceAxes, 3> FindAxes(bool anatomical) const
  {
    return FindSliceAxes(this->Image, anatomical);
  }

  ///@{
  /** Convert from the world to continuous indices, within the image, and back. */
  std::array<double, 3> FindIndex(const double world[3]) const;
  void FindWorld(const std::array<double, 3>& index, double world[3]) const;
  ///@}
  std::array<double, 3> Clamp(std::array<double, 3> index) const;
  std::array<double, 3> GetCentre() const;

  /**
   * Returns the value of the nearest sample after tissue was removed: the chosen component, or the
   * magnitude of all components if UsesMagnitude is true.
   */
  double GetValue(const std::array<double, 3>& index) const;
  /** "magnitude " or "component 1 of 3: " in front of a value; empty for plain scalars. */
  std::string DescribeComponents() const;
  bool UsesMagnitude() const { return this->IsMagnitude; }
  int GetComponent() const { return this->Component; }

  /** The values below which 1 %, and above which 0.5 % of some samples are, with all tissue. */
  std::array<double, 2> FindUsualValues() const;

private:
  /** A slice of the remaining tissue. */
  struct Layer
  {
    vtkSmartPointer<vtkImageData> Image;
    int Number = 0;
  };

  bool IsCarved() const { return this->Removed.Removal != nullptr; }
  void CopyLeftPart(const int part[6], vtkDataArray* left) const;
  double GetValueOf(vtkDataArray* samples, vtkIdType id) const;

  vtkSmartPointer<vtkImageData> Image; ///< placed in the world
  vtkSmartPointer<vtkDataArray> Samples;
  vtkNew<vtkImageData> Plain;
  RemovedTissue Removed;
  CarvedCover Cover = CarvedCover::Nearest;
  std::array<Layer, 3> Layers; ///< one per axis
  vtkMTimeType Time = 0;       ///< time of image and samples when they were fetched
  int Component = 0;
  bool IsMagnitude = false;
};

} // namespace VolumeHaptics

#endif
