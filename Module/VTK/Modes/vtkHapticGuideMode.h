// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticGuideMode
 * @brief   a path or a surface that guides the hand
 *
 * Guides the hand along a path or a surface (a virtual fixture): the hand is drawn to the nearest
 * point of a polyline, and held there, with the Strength (N), a function of the distance from it
 * (world units). It moves freely along the line. A trace of vtkVolumeHapticsFilter, or a stream
 * line of vtkStreamTracer, may be such a path.
 *
 * Instead of a path, the guide may be a surface, or a level of a distance field:
 *
 *   guide->SetSurface(plan);      // a vtkPolyData; the hand moves freely on it
 *   guide->SetSideToOutside();    // or is only kept outside of it
 *   guide->SetDistance(2.0);      // or held 2 world units away from it
 *
 * Directions, not positions, are rounded over a voxel at corners, so that a hand outside of a
 * corner rests at it. Lines with many small corners feel rough: smooth them, for example with
 * vtkSplineFilter. Edges of a surface are rounded in the same way; its polygons should all turn the
 * same way, as vtkPolyDataNormals makes them. Beyond the border of an open surface, its last plane
 * continues.
 *
 * A distance field is read as a cubic B-spline of its samples, which lies higher than the samples
 * by a sixth of their second derivatives: on a sphere of r voxels by 1 / (3 r) voxels.
 *
 * @sa vtkHapticMode
 */
#ifndef vtkHapticGuideMode_h
#define vtkHapticGuideMode_h

#include "vtkHapticMode.h"
#include "vtkSmartPointer.h"        // for ivars
#include "vtkVolumeHapticsModule.h" // for export macro

class vtkImageData;
class vtkPolyData;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticGuideMode : public vtkHapticMode
{
public:
  static vtkHapticGuideMode* New();
  vtkTypeMacro(vtkHapticGuideMode, vtkHapticMode);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The polylines, in world units: the lines of a polydata or, if it has none, all its points in
   * their order as one line. Of several lines, the nearest one guides. A line that ends at its
   * first point is closed; others hold the hand at their ends.
   */
  void SetPath(vtkPolyData* path);
  vtkPolyData* GetPath();
  ///@}

  ///@{
  /**
   * A surface in world units: the polygons and strips of a polydata. The outside is the side that
   * their normals point to, from which they turn counterclockwise.
   */
  void SetSurface(vtkPolyData* surface);
  vtkPolyData* GetSurface();
  ///@}

  ///@{
  /**
   * A distance field: an image whose active scalars are distances from a surface (world units),
   * negative inside of it. It may have any origin and spacing; outside of it nothing holds the
   * hand. The guide needs one of path, surface and distance field.
   */
  void SetDistanceField(vtkImageData* field);
  vtkImageData* GetDistanceField();
  ///@}

  enum SideType
  {
    SURFACE = 0,
    OUTSIDE = 1,
    INSIDE = 2
  };

  ///@{
  /**
   * Where a surface or a distance field holds the hand: on its SURFACE (default), or so that it
   * stays OUTSIDE or INSIDE of it, and is free there.
   */
  vtkSetClampMacro(Side, int, SURFACE, INSIDE);
  vtkGetMacro(Side, int);
  void SetSideToSurface() { this->SetSide(SURFACE); }
  void SetSideToOutside() { this->SetSide(OUTSIDE); }
  void SetSideToInside() { this->SetSide(INSIDE); }
  ///@}

  ///@{
  /**
   * The distance from the surface, or in the distance field, at which the hand is held (world
   * units). It is negative on the inside. Default 0: on the surface itself.
   */
  vtkSetMacro(Distance, double);
  vtkGetMacro(Distance, double);
  ///@}

  /** Includes the change times of the path, the surface and the distance field. */
  vtkMTimeType GetMTime() override;

protected:
  vtkHapticGuideMode();
  ~vtkHapticGuideMode() override;

  vtkSmartPointer<vtkPolyData> Path;
  vtkSmartPointer<vtkPolyData> Surface;
  vtkSmartPointer<vtkImageData> DistanceField;
  int Side = SURFACE;
  double Distance = 0.0;

private:
  vtkHapticGuideMode(const vtkHapticGuideMode&) = delete;
  void operator=(const vtkHapticGuideMode&) = delete;
};

#endif
