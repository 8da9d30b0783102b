// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Time steps of a moving volume as images, and as meshes for SURFACE_PROXY.
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

/** The time step of a moving volume that is shown to the user, as an image. */
class TimeStepImage
{
public:
  /**
   * Makes an image of a time step's array, with the geometry of `shape`. The samples are copied
   * only if the time steps are components of one array with several components. Returns the last
   * image again if the time step is unchanged.
   */
  vtkImageData* Show(const ImageTimeStep& timeStep, bool isComponent, vtkImageData* shape);
  void Clear();
  /** Returns the shown array; null without a time step. */
  vtkDataArray* GetArray() const { return this->Array; }

private:
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkDataArray> Array; ///< array that is shown
  vtkMTimeType Changed = 0;            ///< modification time of Array
  int Component = 0;
};

/** Meshes time steps in the background. Call it from the owner's thread. */
class TimeStepMesher
{
public:
  /**
   * Adds the missing meshes to all time steps but the last one. A single time step gets a mesh that
   * does not move. Call this often: it returns false until all have their meshes.
   * @param components components of the time steps' arrays, one for each time step
   * @param value value of the isosurface
   */
  bool Poll(std::vector<VolumeTimeStep>& timeSteps, const std::vector<int>& components,
    double value, const Affine3& indexToWorld);
  /** Ends the work that is under way, without waiting for it. */
  void End() { this->Meshing.Abandon(); }
  /**
   * Returns whether no worker holds time steps any more. Call it when no time steps wait for their
   * meshes.
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
   * Identifies a mesh: samples of its time step and of the next one, and the component of the
   * first.
   */
  using Key = std::tuple<const void*, const void*, int>;

  KeyedWork<Key, std::shared_ptr<const SurfaceMesh>> Meshing;
};

} // namespace VolumeHaptics

#endif
