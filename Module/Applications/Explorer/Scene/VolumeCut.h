// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_VolumeCut_h
#define Explore_VolumeCut_h

#include "Applications/Explorer/Bar/CommandTable.h"

#include "vtkBoxWidget2.h"
#include "vtkCallbackCommand.h"
#include "vtkImplicitPlaneWidget2.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkVolumeHapticsFilter.h"

class vtkBoxRepresentation;

namespace Explore
{
class PlaneHandles;

enum class CutKind
{
  None,
  Plane, // removes everything in front of it
  Box    // removes a box from the volume, along the axes of its voxels
};

/// Cuts a volume open: the removed part is neither seen nor felt. Planes and boxes have handles,
/// which receive mouse events before the scene:
///
///   plane      the ball pushes it, the arrow rotates it
///   box        the balls move its faces, the one in the middle moves it
///
///   x          switches between plane, box and none, in front of the viewer
///   e          removes the other part instead
///   z          switches whether cut faces are solid like the material behind them, or open
class VolumeCut
{
public:
  VolumeCut();
  ~VolumeCut();
  VolumeCut(const VolumeCut&) = delete;
  VolumeCut& operator=(const VolumeCut&) = delete;

  /// Sets the volume to cut. `body` (world bounds) is the part of the volume that is worth opening.
  /// `handles` is a renderer over the volume with the same camera. If hasRegions is false, the box
  /// is not available, because another part of the program crops the mapper.
  void SetScene(vtkVolume* volume, vtkVolumeHapticsFilter* filter, vtkRenderer* handles,
    const double body[6], bool hasRegions);

  /// Adds the commands of the cut. The table must outlive the cut.
  void AddCommands(CommandTable& table);

  /// Sets the interactor whose mouse moves the cut; null for none.
  void SetInteractor(vtkRenderWindowInteractor* interactor);

  /// Removes everything between the viewer and the centre of the body.
  void SetKind(CutKind kind);
  CutKind GetKind() const { return this->Kind; }
  bool HasRegions() const { return this->HasBox; }
  void TurnOver();

private:
  void PlacePlane();
  void PlaceBox();
  void ShowHandles();
  /// Updates the cuts of the volume and of the filter from the handles.
  void Apply();
  void ApplyBox();
  /// Returns the direction of an axis of the voxels (world, unit vector).
  void GetAxis(int axis, double direction[3]) const;

  vtkSmartPointer<vtkVolume> Volume;
  vtkSmartPointer<vtkVolumeHapticsFilter> Filter;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindowInteractor> Interactor;
  double Body[6] = { 0, 1, 0, 1, 0, 1 };
  bool HasBox = true;
  bool IsTurned = false; // whether the inside of the box is kept and the outside is removed
  CutKind Kind = CutKind::None;
  vtkNew<vtkPlane> Plane;
  vtkNew<PlaneHandles> PlaneShape;
  vtkNew<vtkBoxRepresentation> BoxShape;
  vtkNew<vtkImplicitPlaneWidget2> PlaneWidget;
  vtkNew<vtkBoxWidget2> BoxWidget;
  vtkNew<vtkCallbackCommand> DragObserver;
};
} // namespace Explore

#endif
