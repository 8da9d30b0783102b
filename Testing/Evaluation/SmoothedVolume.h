// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A volume as PRECISE reads it: smoothed by the weights whose derivative yields the normals.
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
  /** The object is invalid after an error of the filter. The image must outlive it. */
  explicit SmoothedVolume(vtkImageData* image);

  /** Returns false after an error of the filter. */
  bool IsValid() const { return this->Model != nullptr; }
  /** Returns the smoothed value at a world position (mm); 0 outside. */
  double Value(const Vector3& world) const;
  /** Returns the gradient per mm, along the world's axes. */
  Vector3 Gradient(const Vector3& world) const;
  /** Returns the unsmoothed value. */
  double RawValue(const Vector3& world) const;

  /**
   * Return the distance (mm) of a position from a level, computed as value difference divided by
   * gradient: from a level of the smoothed volume, or of the raw volume.
   */
  Field Off(double level) const;
  Field RawOff(double level) const;

  /** Returns the isosurface in world coordinates, with normals. */
  vtkSmartPointer<vtkPolyData> ComputeSurface(double level) const;

private:
  vtkImageData* Image;
  std::shared_ptr<const VolumeHaptics::HapticModel> Model;
};

} // namespace evaluation

#endif
