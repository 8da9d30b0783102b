// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Shows the depth of a hand in the scene: where it would touch first, how far away that is, and
 * what it touches.
 */
#ifndef LandingRing_h
#define LandingRing_h

#include "VTK/Scene/Hand/SceneMarker.h"

#include "vtkNew.h"
#include "vtkTextActor.h"

#include <algorithm>
#include <cmath>
#include <string>

class vtkBoundingBox;
class vtkHapticDevice;
class vtkRenderer;

namespace VolumeHaptics
{

///@{
/** Radii of rings, in radii of the proxy: when contact begins, and at most. */
constexpr double ClosedRing = 1.8;
constexpr double OpenRing = 5.0;
///@}

/**
 * Returns the radius of the patch for a tip pressed in by `depth`, with a proxy of this `radius`.
 * The area of the patch grows by pi R d with the depth d, like the contact of a soft ball of radius
 * R on a plane (Hertz), up to the widest ring.
 */
inline double ComputePatchRadius(double depth, double radius)
{
  constexpr double fingertip = 5.0; // R in radii of the proxy
  const double begin = ClosedRing * radius;
  const double grown = fingertip * radius * std::max(0.0, depth);
  return std::min(std::sqrt(begin * begin + grown), OpenRing * radius);
}

/**
 * In free space, shows a ring on the first surface that the tip would touch along the line of
 * sight, with the distance as a text beside the ring. The ring closes as the tip approaches. In
 * contact, shows the patch that a soft fingertip would touch, in the plane of the surface and the
 * colour of the contact, with the ring around it.
 */
class LandingRing
{
public:
  LandingRing();

  /** Shows the latest state of a device; null hides the ring. `radius` is that of the proxy. */
  void Update(
    vtkRenderer* renderer, vtkHapticDevice* device, double radius, const std::string& unit);
  void SetColor(const double contact[3]) { this->Patch.SetColor(contact); }

  void RenderOpaque(vtkViewport* viewport) { this->Ring.RenderOpaque(viewport); }
  /** Draws a faint copy of the ring over objects that hide it. */
  void RenderHidden(vtkViewport* viewport) { this->Ring.RenderHidden(viewport); }
  /** Draws translucent parts. Enable blending in the viewport before. */
  void RenderPatch(vtkViewport* viewport) { this->Patch.RenderHidden(viewport); }
  void RenderText(vtkViewport* viewport);
  void Release(vtkWindow* window);
  void AddTo(vtkBoundingBox& box)
  {
    this->Ring.AddTo(box);
  } // the patch is inside the ring, so the
    // ring suffices

private:
  SceneMarker Ring{ SceneMarker::Ring, 0.97, 0.97, 0.97 };
  SceneMarker Patch{ SceneMarker::Disc, 1.0, 1.0, 1.0 };
  vtkNew<vtkTextActor> Distance;
};

} // namespace VolumeHaptics

#endif
