// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Shows where a hand is in depth: where it would land, how far away that is, and what it touches.
 */
#ifndef LandingRing_h
#define LandingRing_h

#include "VTK/Scene/SceneMarker.h"

#include "vtkNew.h"
#include "vtkTextActor.h"

#include <string>

class vtkBoundingBox;
class vtkHapticDevice;
class vtkRenderer;

namespace VolumeHaptics
{

/**
 * In free space: a ring on the first surface that the tip would touch on its way along the line of
 * sight, and the distance as a text beside the tip. The ring closes as the tip comes near. In
 * contact: a ring around the proxy, in the plane of the touched surface.
 */
class LandingRing
{
public:
  LandingRing();

  /** `radius` is that of the proxy. A null device hides it. */
  void Update(
    vtkRenderer* renderer, vtkHapticDevice* device, double radius, const std::string& unit);

  void RenderOpaque(vtkViewport* viewport) { this->Ring.RenderOpaque(viewport); }
  void RenderHidden(vtkViewport* viewport) { this->Ring.RenderHidden(viewport); }
  void RenderText(vtkViewport* viewport);
  void Release(vtkWindow* window);
  void AddTo(vtkBoundingBox& box) { this->Ring.AddTo(box); }

private:
  SceneMarker Ring{ SceneMarker::Ring, 0.97, 0.97, 0.97 };
  vtkNew<vtkTextActor> Distance;
};

} // namespace VolumeHaptics

#endif
