// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_PlaneHandles_h
#define Explore_PlaneHandles_h

#include "vtkImplicitPlaneRepresentation.h"

namespace Explore
{
/// A plane on which only the handles use the mouse: the ball pushes it along its normal, the arrow
/// turns it. Elsewhere the mouse belongs to the scene.
class PlaneHandles : public vtkImplicitPlaneRepresentation
{
public:
  static PlaneHandles* New();
  vtkTypeMacro(PlaneHandles, vtkImplicitPlaneRepresentation);

  int ComputeInteractionState(int x, int y, int modify = 0) override;

protected:
  PlaneHandles();
  ~PlaneHandles() override = default;

private:
  PlaneHandles(const PlaneHandles&) = delete;
  void operator=(const PlaneHandles&) = delete;
};
} // namespace Explore

#endif
