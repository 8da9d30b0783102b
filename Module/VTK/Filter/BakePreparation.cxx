// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Filter/BakePreparation.h"

#include "VTK/Base/HapticVolume.h"
#include "VTK/Base/vtkVolumeHapticsCompat.h"
#include "VTK/Filter/FilterSources.h"
#include "VTK/Filter/HapticBaker.h"
#include "vtkVolumeHapticsFilter.h"

#include "vtkDataArray.h"
#include "vtkHapticPointShell.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <new>

namespace VolumeHaptics
{

//------------------------------------------------------------------------------
const char* BakePreparation::Prepare(bool isMoving)
{
  vtkVolumeHapticsFilter* const filter = this->Filter;
  const bool hasLabels = (filter->GetLabelTable() && filter->GetInputDataObject(3, 0)) ||
    (filter->GetProperty()->GetScalarsAreLabels() && !isMoving);
  const bool hasMesh = filter->GetMethod() == vtkVolumeHapticsFilter::SURFACE_PROXY && !isMoving;
  if (!hasLabels)
  {
    this->Labels.EndPreparing();
  }
  if (!hasMesh)
  {
    this->Surfaces.EndPreparing();
  }
  if (hasLabels || hasMesh)
  {
    try
    {
      UpdateSources(filter);
    }
    catch (const std::bad_alloc&)
    {
      return nullptr; // Bake() reports the error
    }
  }
  const char* const labels = hasLabels ? this->PrepareLabels() : nullptr;
  const bool isMeshReady = !hasMesh || this->PrepareSurface();
  const bool isToolReady = this->PrepareTool();
  return labels    ? labels
    : !isMeshReady ? MeshingWork
    : !isToolReady ? "the points of the tool are spread"
                   : nullptr;
}

//------------------------------------------------------------------------------
void BakePreparation::EndPreparing()
{
  this->Labels.EndPreparing();
  this->Surfaces.EndPreparing();
  this->Shells.EndPreparing();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> BakePreparation::FillOutside(
  vtkImageData* image, vtkDataArray* scalars, int component, bool areTimeSteps)
{
  const bool areScalars = areTimeSteps || AreScalars(scalars->GetNumberOfComponents());
  if (this->Filter->GetProperty()->GetScalarsAreLabels() || !areScalars)
  {
    this->Outside = OutsideFiller{};
    return scalars;
  }
  return this->Outside.Fill(image, scalars, component);
}

//------------------------------------------------------------------------------
bool BakePreparation::PrepareTool()
{
  auto* const shell = vtkHapticPointShell::SafeDownCast(this->Filter->GetTool());
  if (!shell)
  {
    this->Shells.EndPreparing();
  }
  return !shell || this->Shells.Prepare(shell->GetMesh(), shell->GetNumberOfPoints());
}

//------------------------------------------------------------------------------
const char* BakePreparation::PrepareLabels()
{
  HapticBaker& baker = this->Filter->GetBaker();
  const std::array<TouchedArray, 2> touched = baker.GetTouched();
  vtkImageData* const image = vtkImageData::SafeDownCast(this->Filter->GetInputDataObject(3, 0));
  if (image && touched[1].Array && this->Filter->GetLabelTable())
  {
    return this->Labels.Prepare(
      image, touched[1].Array, this->Filter->GetLabelTable(), baker.HasLabelWalls());
  }
  vtkImageData* const scalars = this->Filter->GetTouchedImage();
  if (scalars && touched[0].Array && baker.AreLabels(scalars))
  {
    return this->Labels.PrepareScalars(scalars, touched[0].Array, this->Filter->GetProperty());
  }
  this->Labels.EndPreparing();
  return nullptr;
}

//------------------------------------------------------------------------------
bool BakePreparation::PrepareSurface()
{
  vtkImageData* const image = this->Filter->GetTouchedImage();
  const vtkSmartPointer<vtkDataArray> scalars = this->Filter->GetBaker().GetFilled().Array;
  const int component = this->Filter->GetProperty()->GetComponent();
  HapticVolume volume;
  std::string error;
  if (!scalars ||
    !ReadVolume(image, scalars, component, this->Filter->GetKernelRadius(), volume, error))
  {
    return true; // Bake() reports an image that can't be read
  }
  const std::int64_t* const first = volume.View.First;
  return this->Surfaces.Prepare(vtkPolyData::SafeDownCast(this->Filter->GetInputDataObject(2, 0)),
    { image, scalars, component, this->Filter->GetIsoValue(),
      { static_cast<int>(first[0]), static_cast<int>(first[1]), static_cast<int>(first[2]) },
      volume.Whole.IsThere },
    volume.IndexToWorld);
}

//------------------------------------------------------------------------------
bool BakePreparation::IsSurfaceAtHand()
{
  return this->Filter->GetMethod() != vtkVolumeHapticsFilter::SURFACE_PROXY ||
    this->PrepareSurface();
}

//------------------------------------------------------------------------------
bool BakePreparation::AwaitSurface()
{
  constexpr double piece = 0.02; // s
  while (!this->IsSurfaceAtHand())
  {
    if (!this->Surfaces.WaitFor(piece))
    {
      this->Filter->UpdateProgress(0.0);
    }
    if (MustAbort(this->Filter))
    {
      this->Surfaces.EndPreparing();
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
double BakePreparation::EstimateTime()
{
  if (this->Filter->GetMethod() != vtkVolumeHapticsFilter::SURFACE_PROXY)
  {
    return 0.0;
  }
  try
  {
    UpdateSources(this->Filter);
  }
  catch (const std::bad_alloc&)
  {
    return 0.0; // Bake() reports the error
  }
  vtkImageData* const image = this->Filter->GetTouchedImage();
  const vtkSmartPointer<vtkDataArray> scalars = this->Filter->GetBaker().GetFilled().Array;
  if (!scalars)
  {
    return 0.0; // Bake() reports the error
  }
  return this->Surfaces.EstimateTime(
    vtkPolyData::SafeDownCast(this->Filter->GetInputDataObject(2, 0)),
    { image, scalars, this->Filter->GetProperty()->GetComponent(), this->Filter->GetIsoValue() });
}

} // namespace VolumeHaptics
