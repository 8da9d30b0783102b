// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A sphere, a rod, an arrow, a ring or a stylus in the scene, which shines faintly through objects
 * in front of it.
 */
#ifndef SceneMarker_h
#define SceneMarker_h

#include "Core/Math/Quaternion.h"
#include "Core/Math/Vector3.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkTransform.h"

class vtkBoundingBox;

namespace VolumeHaptics
{

/** The opacity of what is behind other objects. */
constexpr double HiddenOpacity = 0.35;

class SceneMarker
{
public:
  enum Shape
  {
    Sphere,
    Rod,   ///< from one position to another
    Arrow, ///< the same, with a head
    Ring,  ///< around an axis
    Stylus ///< a pen with a button, which points along its -z
  };
  SceneMarker(Shape shape, double red, double green, double blue);

  void SetColor(const double color[3]);
  void PlaceSphere(const Vector3& centre, double radius);
  /** A marker that is shorter than its radius is not shown. */
  void PlaceAlong(const Vector3& from, const Vector3& to, double radius);
  void PlaceRing(const Vector3& centre, const Vector3& axis, double radius);
  /** A stylus: its point, its orientation (DeviceBackend.h), and its length. */
  void PlaceTurned(const Vector3& point, const Quaternion& orientation, double length);
  void Show(bool shown) { this->Shown = shown; }

  void RenderOpaque(vtkViewport* viewport);
  /** Draws the faint copy. */
  void RenderHidden(vtkViewport* viewport);
  void Release(vtkWindow* window);
  /** Grows the box to hold the marker, if it is shown. */
  void AddTo(vtkBoundingBox& box);

private:
  /** Lets z of the shape point along a direction that is not zero. */
  void Aim(const Vector3& from, const Vector3& direction);

  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Solid;
  vtkNew<vtkActor> Ghost;
  vtkNew<vtkTransform> Place;
  bool Shown = false;
};

} // namespace VolumeHaptics

#endif
