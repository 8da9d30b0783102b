// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A volume as PRECISE sees it: smoothed by the weights whose derivative gives its normals.
 */
#ifndef Evaluation_SmoothedVolume_h
#define Evaluation_SmoothedVolume_h

#include "Field.h"

#include "vtkSmartPointer.h"

class vtkImageData;
class vtkPolyData;

namespace evaluation
{

class SmoothedVolume
{
public:
  /** The object is not valid after an error of the filter. The image must outlive it. */
  explicit SmoothedVolume(vtkImageData* image);

  /** Returns whether the volume can be read. */
  bool IsValid() const { return this->Model != nullptr; }
  /** Returns the value at a position in the world (mm); 0 outside. */
  double Value(const Vector3& world) const;
  /** Returns the gradient per mm, along the axes of the world. */
  Vector3 Gradient(const Vector3& world) const;
  /** Returns the unsmoothed value. */
  double RawValue(const Vector3& world) const;

  /**
   * Return the distance (mm) between a position and a level, by value and gradient: a level of the
   * smoothed volume, or of the raw volume.
   */
  Field Off(double level) const;
  Field RawOff(double level) const;

  /** Returns the isosurface in the world, with normals. */
  vtkSmartPointer<vtkPolyData> ComputeSurface(double level) const;

private:
  vtkImageData* Image;
  std::shared_ptr<const VolumeHaptics::HapticModel> Model;
};

} // namespace evaluation

#endif
