// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Draws the spring between proxy and tip as a coil that is stretched with the spring.
 */
#ifndef SpringCoil_h
#define SpringCoil_h

#include "VTK/Scene/Hand/SceneMarker.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTubeFilter.h"

namespace VolumeHaptics
{

/**
 * Draws a wire from the proxy to the tip. The slack part of the distance is straight. The stretched
 * part is a coil of a wire of constant length, whose windings open and become narrower as it is
 * stretched. If the wire is too short for a coil, it is straight.
 */
class SpringCoil
{
public:
  SpringCoil();

  /**
   * Sets the ends of the spring. `slack` is the part of the distance that causes no force. `radius`
   * is that of the proxy.
   */
  void Place(const Vector3& proxy, const Vector3& tip, double slack, double radius);
  void Show(bool shown) { this->Marker.Show(shown); }

  /** Returns the centre line of the wire, for tests. */
  vtkPolyData* GetWire() { return this->Wire; }

  void RenderOpaque(vtkViewport* viewport) { this->Marker.RenderOpaque(viewport); }
  void RenderHidden(vtkViewport* viewport) { this->Marker.RenderHidden(viewport); }
  void Release(vtkWindow* window) { this->Marker.Release(window); }
  void AddTo(vtkBoundingBox& box) { this->Marker.AddTo(box); }

private:
  vtkNew<vtkPolyData> Wire;
  vtkNew<vtkTubeFilter> Tube;
  SceneMarker Marker;
  ///@{
  /** Arguments of the last Place(). */
  Vector3 Proxy;
  Vector3 Tip;
  double Slack = 0.0;
  double Radius = 0.0;
  ///@}
};

} // namespace VolumeHaptics

#endif
