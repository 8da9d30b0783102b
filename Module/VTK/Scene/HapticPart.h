// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A sphere, a rod or an arrow in the scene, and its shine through what hides it.
 */
#ifndef HapticPart_h
#define HapticPart_h

#include "Core/Math/Vector3.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkTransform.h"

class vtkBoundingBox;

namespace VolumeHaptics
{

class HapticPart
{
public:
  enum Shape
  {
    Sphere,
    Rod,  ///< from one place to another
    Arrow ///< the same, with a head
  };
  HapticPart(Shape shape, double red, double green, double blue);

  void SetColor(const double color[3]);
  void PlaceSphere(const Vector3& centre, double radius);
  /** Not shown where it would be shorter than it is thin. */
  void PlaceAlong(const Vector3& from, const Vector3& to, double radius);
  void Show(bool shown) { this->Shown = shown; }

  void RenderOpaque(vtkViewport* viewport);
  void RenderHidden(vtkViewport* viewport);
  void Release(vtkWindow* window);
  /** Grows bounds to hold the part. */
  void AddTo(vtkBoundingBox& box);

private:
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Solid;
  vtkNew<vtkActor> Ghost;
  vtkNew<vtkTransform> Place;
  bool Shown = false;
};

} // namespace VolumeHaptics

#endif
