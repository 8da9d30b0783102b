// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticGuideMode
 * @brief   a path or a surface that guides the hand
 *
 * Guides the hand along a path or a surface (a virtual fixture). The guide draws the hand to the
 * nearest point with the Strength (N), a function of the distance (world units), and leaves it free
 * along the path:
 *
 *   guide->SetPath(line);         // a vtkPolyData, such as a trace or a stream line; or
 *   guide->SetSurface(plan);      // a vtkPolyData; the hand moves freely on it
 *   guide->SetSideToOutside();    // or is only kept outside of it
 *   guide->SetDistance(2.0);      // or held 2 world units away from it
 *
 * Instead of a path or a surface, the guide may be a level of a distance field. It is read as a
 * cubic B-spline of its samples, which lies higher than the samples by a sixth of their second
 * derivatives: on a sphere of r voxels by 1 / (3 r) voxels.
 *
 * At corners, the direction of the force is rounded over a voxel, so that a hand outside of a
 * corner rests at the corner. Lines with many small corners feel rough: smooth them, for example
 * with vtkSplineFilter. Edges of a surface are rounded in the same way; its polygons should all
 * turn the same way, as vtkPolyDataNormals makes them. Beyond the border of an open surface, its
 * last plane continues.
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
   * their order as one line. If there are several lines, the nearest one guides the hand. A line
   * that ends at its first point is closed; an open line holds the hand at its ends.
   */
  void SetPath(vtkPolyData* path);
  vtkPolyData* GetPath();
  ///@}

  ///@{
  /**
   * A surface in world units: the polygons and strips of a polydata. The normals of the polygons
   * point to the outside: seen from there, their corners are in counterclockwise order.
   */
  void SetSurface(vtkPolyData* surface);
  vtkPolyData* GetSurface();
  ///@}

  ///@{
  /**
   * A distance field: an image whose active scalars are distances from a surface (world units),
   * negative inside of it. It may have any origin and spacing; outside the image, nothing holds the
   * hand. The guide needs exactly one of path, surface and distance field.
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
   * Where a surface or a distance field holds the hand: on the SURFACE (default), or on one side of
   * it, OUTSIDE or INSIDE, where the hand moves freely.
   */
  vtkSetClampMacro(Side, int, SURFACE, INSIDE);
  vtkGetMacro(Side, int);
  void SetSideToSurface() { this->SetSide(SURFACE); }
  void SetSideToOutside() { this->SetSide(OUTSIDE); }
  void SetSideToInside() { this->SetSide(INSIDE); }
  ///@}

  ///@{
  /**
   * The distance (world units) from the surface, or level of the distance field, at which the hand
   * is held; negative is inside. Default 0: on the surface itself.
   */
  vtkSetMacro(Distance, double);
  vtkGetMacro(Distance, double);
  ///@}

  /** Returns the latest modification time of this mode, its path, surface and distance field. */
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
