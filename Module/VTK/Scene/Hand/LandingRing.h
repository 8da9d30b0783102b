// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Shows how deep a hand is in the scene: where it would land, how far away that is, and what it
 * touches.
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
/** Radii of rings, in radii of the proxy: the ring when contact begins, and the widest ring. */
constexpr double ClosedRing = 1.8;
constexpr double OpenRing = 5.0;
///@}

/**
 * Returns the radius of the patch if the tip is pressed in by `depth` and the proxy has this
 * `radius`. The area of the patch grows by pi R d for a depth d, like the contact of a soft ball of
 * radius R on a plane (Hertz), up to the widest ring.
 */
inline double ComputePatchRadius(double depth, double radius)
{
  constexpr double fingertip = 5.0; // R in radii of the proxy
  const double begin = ClosedRing * radius;
  const double grown = fingertip * radius * std::max(0.0, depth);
  return std::min(std::sqrt(begin * begin + grown), OpenRing * radius);
}

/**
 * In free space, shows a ring on the first surface that the tip would touch if it moved along the
 * line of sight, and the distance as a text beside the ring. The ring closes as the tip comes near.
 * In contact, shows the patch that a soft fingertip would touch, in the plane of the surface and in
 * the colour of the contact, with the ring around it.
 */
class LandingRing
{
public:
  LandingRing();

  /** `radius` is the proxy's radius. A null device hides the ring. */
  void Update(
    vtkRenderer* renderer, vtkHapticDevice* device, double radius, const std::string& unit);
  void SetColor(const double contact[3]) { this->Patch.SetColor(contact); }

  void RenderOpaque(vtkViewport* viewport) { this->Ring.RenderOpaque(viewport); }
  /** Draws a faint copy of the parts behind other objects. */
  void RenderHidden(vtkViewport* viewport) { this->Ring.RenderHidden(viewport); }
  /** Draws translucent parts. Blending has to be enabled in the viewport. */
  void RenderPatch(vtkViewport* viewport) { this->Patch.RenderHidden(viewport); }
  void RenderText(vtkViewport* viewport);
  void Release(vtkWindow* window);
  void AddTo(vtkBoundingBox& box) { this->Ring.AddTo(box); } // the patch is inside the ring

private:
  SceneMarker Ring{ SceneMarker::Ring, 0.97, 0.97, 0.97 };
  SceneMarker Patch{ SceneMarker::Disc, 1.0, 1.0, 1.0 };
  vtkNew<vtkTextActor> Distance;
};

} // namespace VolumeHaptics

#endif
