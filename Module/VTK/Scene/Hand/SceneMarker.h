// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Draws a sphere, an arrow, a ring, a disc, a stylus or a given shape, and a faint copy over
 * objects that hide it.
 */
#ifndef SceneMarker_h
#define SceneMarker_h

#include "Core/Math/Quaternion.h"
#include "Core/Math/Vector3.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkTransform.h"

class vtkAlgorithmOutput;
class vtkBoundingBox;

namespace VolumeHaptics
{

/** Opacity of the copy over objects that hide a marker. */
constexpr double HiddenOpacity = 0.35;

class SceneMarker
{
public:
  enum Shape
  {
    Sphere,
    Arrow, ///< from one position to another
    Ring,  ///< around an axis
    Disc,  ///< like the ring, but filled
    Stylus ///< a pen with a button, pointing along its -z
  };
  SceneMarker(Shape shape, double red, double green, double blue);
  /** Makes a marker of a given shape in world coordinates. */
  SceneMarker(vtkAlgorithmOutput* shape, double red, double green, double blue);

  void SetColor(const double color[3]);
  /**
   * Whether a shape with its own colours, such as the stylus, shows these instead of the marker's
   * colour.
   */
  void SetPainted(bool painted) { this->Mapper->SetScalarVisibility(painted); }
  void PlaceSphere(const Vector3& centre, double radius);
  /** Sets the ends of an arrow. An arrow shorter than its radius is hidden. */
  void PlaceAlong(const Vector3& from, const Vector3& to, double radius);
  /** Sets the position and size of a ring or a disc. */
  void PlaceRing(const Vector3& centre, const Vector3& axis, double radius);
  /**
   * Sets the position of a stylus's point, the stylus's orientation (see DeviceBackend.h), and its
   * length.
   */
  void PlaceTurned(const Vector3& point, const Quaternion& orientation, double length);
  void Show(bool shown) { this->Shown = shown; }

  void RenderOpaque(vtkViewport* viewport);
  /** Draws a faint copy of the marker over objects that hide it. */
  void RenderHidden(vtkViewport* viewport);
  void Release(vtkWindow* window);
  /** Extends the box to include the marker, if it is shown. */
  void AddTo(vtkBoundingBox& box);

private:
  /** Sets the colour and the lighting of a new marker. */
  void Finish(double red, double green, double blue);
  /** Moves the shape to `from`, and turns its z axis to a non-zero direction. */
  void Aim(const Vector3& from, const Vector3& direction);

  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Solid;
  vtkNew<vtkActor> Ghost;
  vtkNew<vtkTransform> Place;
  bool Shown = false;
};

} // namespace VolumeHaptics

#endif
