// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts time steps of a moving volume to images, and to meshes for SURFACE_PROXY.
 */
#ifndef TimeStepMesher_h
#define TimeStepMesher_h

#include "Core/Model/HapticModelDescription.h"
#include "Core/Realtime/BackgroundWork.h"
#include "VTK/Baking/ImageTimeSteps.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <tuple>
#include <vector>

namespace VolumeHaptics
{

/** Image of the time step that is shown to the user. */
class TimeStepImage
{
public:
  /**
   * Makes an image of a time step's array, with the geometry of `shape`. Copies the samples only if
   * the time steps are components of one array. Returns the previous image if the time step is
   * unchanged.
   */
  vtkImageData* Show(const ImageTimeStep& timeStep, bool isComponent, vtkImageData* shape);
  void Clear();
  /** Returns the shown array; null without a time step. */
  vtkDataArray* GetArray() const { return this->Array; }

private:
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkDataArray> Array; ///< array of the shown time step
  vtkMTimeType Changed = 0;            ///< modification time of Array when Image was made
  int Component = 0;
};

/** Meshes time steps on a worker thread. Call it from the owner's thread. */
class TimeStepMesher
{
public:
  /**
   * Adds the missing meshes to all time steps except the last one. A single time step gets a mesh
   * without motion. Call this often: it returns false until all meshes are made.
   * @param components components of the time steps' arrays, one for each time step
   * @param value value of the isosurface
   */
  bool Poll(std::vector<VolumeTimeStep>& timeSteps, const std::vector<int>& components,
    double value, const Affine3& indexToWorld);
  /** Cancels the meshing in progress without waiting for it. */
  void End() { this->Meshing.Abandon(); }
  /**
   * Returns whether the worker has no time steps in memory. Call this only when no time steps wait
   * for their meshes.
   */
  bool IsIdle()
  {
    if (this->Meshing.IsUnderWay())
    {
      return false;
    }
    this->Meshing.Forget();
    return true;
  }

private:
  /**
   * Key of a mesh: the samples of its time step and of the next one, and the component of the
   * first.
   */
  using Key = std::tuple<const void*, const void*, int>;

  KeyedWork<Key, std::shared_ptr<const SurfaceMesh>> Meshing;
};

} // namespace VolumeHaptics

#endif
