// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_SurfaceMap_h
#define Explore_SurfaceMap_h

#include "Applications/Explorer/Analysis/VolumeAnalysis.h"
#include "Applications/Explorer/View/ViewFrame.h"

#include "vtkImageData.h"

#include <vector>

namespace Explore
{
class ValueProbe;

/// Maps two surfaces, as distances from the centre over the directions around the camera: the outer
/// surface (skin), and the next rise to dense values beneath it (skull). The distances are measured
/// by rays from outside, cleaned of outliers, and smoothed, so that a hand can follow a path on the
/// surfaces.
class SurfaceMap
{
public:
  static constexpr double RIGHT_LIMIT = 64.0; // degrees to either side of the camera
  static constexpr double UP_LIMIT = 60.0;    // degrees above and below the camera

  SurfaceMap(vtkImageData* image, const Analysis& analysis, const ViewFrame& view);

  /// Return the distance of a surface from the centre (world units) in a direction given by angles
  /// to the right and up (degrees). The distance is smooth in both angles.
  double Outer(double right, double up) const;
  double Deep(double right, double up) const;

  /// Returns how reliable the surfaces are in a direction: 1 if every ray around it hit both
  /// surfaces inside the volume, 0 if none did.
  double Quality(double right, double up) const;

  /// Returns whether no ray hit the body.
  bool IsEmpty() const { return this->Hits == 0; }

private:
  struct Ray
  {
    double Outer = -1.0;
    double Deep = -1.0;
    // whether the ray entered the body from the outside instead of through a face at which the scan
    // is truncated
    bool Clean = false;
    bool Solid = false; // whether the deep structure is thick enough to be pressed on
  };

  Ray Cast(vtkImageData* image, const Analysis& analysis, const vtkVector3d& direction) const;
  bool IsSolid(const ValueProbe& probe, double threshold, double distance, int steps,
    const vtkVector3d& direction) const;
  double Interpolate(const std::vector<double>& map, double right, double up) const;

  vtkVector3d Centre;
  double Start = 0.0; // distance at which rays start, and their step (world units)
  double Step = 1.0;
  int Hits = 0;
  std::vector<double> OuterMap, DeepMap, QualityMap;
};
} // namespace Explore

#endif
