// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticRepresentation
 * @brief   draws the hand in the scene: tip, proxy and forces
 *
 * Draws the latest state of a vtkHapticDevice: the tip at the hand, the proxy that the surface
 * holds back, the spring between tip and proxy, and the forces:
 *
 *   representation->SetDevice(device);
 *   renderer->AddViewProp(representation);
 *
 * The state is that of the device's last UpdateState(), which vtkInteractorStyleHaptic calls. The
 * class can also show a trace or a recording as a line, coloured by one of its arrays: see
 * SetTrail.
 *
 * - **The tip** is white.
 * - **The proxy** is grey while it is free, amber while it sticks, green while it slides and
 *   magenta while it is pushed through a surface. In contact, a patch around it has the same
 *   colour; it grows with the force like the contact area of a soft fingertip.
 * - **The spring** is a coil that opens as it is stretched. Its slack part
 *   (vtkHapticState::GetSlack) is a straight wire.
 * - **Forces** are arrows: the whole force on the hand (white) at the tip, the forces of the
 *   surface (blue) and of friction (orange) at the proxy. A text in the lower right corner shows
 *   the length of a newton.
 * - **The stylus** has its point in the proxy, with the orientation that the device measures
 *   (vtkHapticState::GetTipOrientation). If the device measures none, the stylus leans towards the
 *   viewer, as a pen in the right hand.
 *
 * While a virtual device is not armed, the spring, the arrows and a leaning stylus are hidden.
 * After it is disarmed, nothing is shown until its tip moves. Markers behind a surface or inside
 * the volume are drawn faintly.
 *
 * @sa vtkHapticState, vtkInteractorStyleHaptic
 */
#ifndef vtkHapticRepresentation_h
#define vtkHapticRepresentation_h

#include "vtkProp.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkHapticDevice;
class vtkPolyData;
class vtkScalarsToColors;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticRepresentation : public vtkProp
{
public:
  static vtkHapticRepresentation* New();
  vtkTypeMacro(vtkHapticRepresentation, vtkProp);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  void SetDevice(vtkHapticDevice* device);
  vtkHapticDevice* GetDevice();
  ///@}

  ///@{
  /**
   * Radius of the proxy, world units. Default 1.5. The sizes of the other markers are proportional
   * to it.
   */
  vtkSetClampMacro(Radius, double, 1e-9, VTK_DOUBLE_MAX);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /** Newtons per world unit of the arrows. Default 0.1: 1 N is 10 world units long. */
  vtkSetClampMacro(ForceScale, double, 1e-9, VTK_DOUBLE_MAX);
  vtkGetMacro(ForceScale, double);
  ///@}

  ///@{
  /**
   * The longest arrow, world units, 0 or more. Default 0: 30 times Radius. A larger force has an
   * arrow of this length with two heads.
   */
  vtkSetClampMacro(MaximumArrowLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumArrowLength, double);
  ///@}

  ///@{
  /** Name of the world's unit in the text. Default "mm". */
  vtkSetMacro(WorldUnitName, std::string);
  vtkGetMacro(WorldUnitName, std::string);
  ///@}

  ///@{
  /**
   * Whether the hand is the second one of its scene. Default off. The tip, the free proxy, the
   * stylus and the arrow of the whole force are then lilac, and ScaleTextVisibility does not count.
   */
  vtkSetMacro(SecondHand, bool);
  vtkGetMacro(SecondHand, bool);
  vtkBooleanMacro(SecondHand, bool);
  ///@}

  ///@{
  /** Whether the spring between proxy and tip is shown. Default on. */
  vtkSetMacro(SpringVisibility, bool);
  vtkGetMacro(SpringVisibility, bool);
  ///@}

  ///@{
  /** Whether the arrow of the whole force is shown. Default on. */
  vtkSetMacro(ForceVisibility, bool);
  vtkGetMacro(ForceVisibility, bool);
  ///@}

  ///@{
  /** Whether the arrow of the normal force is shown. Default on. */
  vtkSetMacro(NormalForceVisibility, bool);
  vtkGetMacro(NormalForceVisibility, bool);
  ///@}

  ///@{
  /** Whether the arrow of the friction force is shown. Default on. */
  vtkSetMacro(FrictionForceVisibility, bool);
  vtkGetMacro(FrictionForceVisibility, bool);
  ///@}

  ///@{
  /**
   * Whether markers are shown at x_s (yellow) and x_v (turquoise), at which the materials are read.
   * Default off.
   */
  vtkSetMacro(MarkerVisibility, bool);
  vtkGetMacro(MarkerVisibility, bool);
  ///@}

  ///@{
  /**
   * Whether a stylus is shown at the proxy. Default on. Some tools are shown instead of the stylus:
   * a vtkHapticNeedle in tissue with its track in the colours of the labels, a vtkHapticPointShell
   * with its mesh, and a vtkHapticBurr with its head, which turns while it spins.
   */
  vtkSetMacro(StylusVisibility, bool);
  vtkGetMacro(StylusVisibility, bool);
  ///@}

  ///@{
  /**
   * Length of the stylus, world units, 0 or more. Default 0: 25 times Radius, but at most a third
   * of the distance to the viewer for a stylus that leans towards the viewer.
   */
  vtkSetClampMacro(StylusLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(StylusLength, double);
  ///@}

  ///@{
  /** Whether a text shows the length of a newton. Default on. */
  vtkSetMacro(ScaleTextVisibility, bool);
  vtkGetMacro(ScaleTextVisibility, bool);
  ///@}

  ///@{
  /** Whether markers behind a surface or inside the volume are drawn faintly. Default on. */
  vtkSetMacro(HiddenVisibility, bool);
  vtkGetMacro(HiddenVisibility, bool);
  ///@}

  ///@{
  /**
   * Whether a ring shows where the tip would first touch if it moved along the line of sight, with
   * a text of the distance. In contact, the ring is the edge of the patch on the touched surface.
   * Default on.
   */
  vtkSetMacro(LandingVisibility, bool);
  vtkGetMacro(LandingVisibility, bool);
  vtkBooleanMacro(LandingVisibility, bool);
  ///@}

  ///@{
  /**
   * Whether the shapes are shown on which the modes of PRIMITIVES hold the hand, each in the colour
   * of its mode: the line of a flow through the proxy, a core line, fibre, vessel or guide; fronts
   * as discs; and a tensor as an ellipsoid, longer than the proxy so that its axes can be seen.
   * Default on. See vtkHapticState::GetFollowed.
   */
  vtkSetMacro(FollowedVisibility, bool);
  vtkGetMacro(FollowedVisibility, bool);
  ///@}

  ///@{
  /**
   * The length of the lines of FollowedVisibility to either side of the proxy (voxels), 1 to 1000.
   * Default 48.
   */
  vtkSetClampMacro(FollowedReach, double, 1.0, 1000.0);
  vtkGetMacro(FollowedReach, double);
  ///@}

  ///@{
  /**
   * A line through the points of a trace (default: none). One of the trace's point arrays (default
   * "Force"; vectors by their length) colours it through a lookup table (default: blue to red over
   * the array's range).
   */
  void SetTrail(vtkPolyData* trace);
  vtkPolyData* GetTrail();
  vtkSetMacro(TrailArrayName, std::string);
  vtkGetMacro(TrailArrayName, std::string);
  void SetTrailLookupTable(vtkScalarsToColors* table);
  ///@}

  ///@{
  /**
   * Compute the bounds of the markers, draw them, and release their graphics resources; called by
   * the renderer.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderOverlay(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  ///@}

protected:
  vtkHapticRepresentation();
  ~vtkHapticRepresentation() override;

  double Radius = 1.5;
  double ForceScale = 0.1;
  double MaximumArrowLength = 0.0;
  std::string WorldUnitName = "mm";
  std::string TrailArrayName = "Force";
  bool SecondHand = false;
  bool SpringVisibility = true;
  bool ForceVisibility = true;
  bool NormalForceVisibility = true;
  bool FrictionForceVisibility = true;
  bool MarkerVisibility = false;
  bool StylusVisibility = true;
  double StylusLength = 0.0;
  bool ScaleTextVisibility = true;
  bool HiddenVisibility = true;
  bool LandingVisibility = true;
  bool FollowedVisibility = true;
  double FollowedReach = 48.0;

private:
  vtkHapticRepresentation(const vtkHapticRepresentation&) = delete;
  void operator=(const vtkHapticRepresentation&) = delete;

  void UpdateMarkers();
  void UpdateStylus();
  void Lean(vtkViewport* viewport);
  double ComputeStylusLength();
  void UpdateTrail();

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
