// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Volumes/CarvedPicture.h"

#include "VTK/Scene/Base/SmartMapperParts.h"

#include <utility>

namespace VolumeHaptics
{
namespace
{

/** Whether a mapper now draws in a way that uses no texture of its image. */
bool DrawsOtherwise(vtkVolumeMapper* mapper)
{
  auto* const smart = vtkSmartVolumeMapper::SafeDownCast(mapper);
  if (!smart)
  {
    return false;
  }
  const int mode = smart->GetLastUsedRenderMode();
  return mode == vtkSmartVolumeMapper::GPURenderMode
    ? SmartMapperParts::DrawsFewerVoxels(smart)
    : mode != vtkSmartVolumeMapper::UndefinedRenderMode;
}

CarvedArray WithArray(const CarvedArray& touched, vtkDataArray* shown)
{
  CarvedArray carved = touched;
  carved.Array = shown ? shown : touched.Array.Get();
  return carved;
}

vtkOpenGLGPUVolumeRayCastMapper* FindTextureMapper(vtkVolumeMapper* mapper)
{
  auto* const smart = vtkSmartVolumeMapper::SafeDownCast(mapper);
  return vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(
    smart ? static_cast<vtkVolumeMapper*>(SmartMapperParts::FindGPUMapper(smart)) : mapper);
}

} // namespace

CarvedPicture::CarvedPicture(vtkVolumeMapper* mapper, CarvedArray touched, vtkDataArray* shown)
  : Mapper(mapper)
  , Touched(std::move(touched))
  , Carved(WithArray(this->Touched, shown))
  , Bricks(Carved.Removal)
{
  if (vtkOpenGLGPUVolumeRayCastMapper* const drawing = FindTextureMapper(mapper))
  {
    this->Texture = std::make_unique<CarvedTexture>(drawing, this->Carved, this->Bricks);
  }
}

CarvedPicture::~CarvedPicture()
{
  if (this->Texture)
  {
    this->Texture->Restore();
  }
}

bool CarvedPicture::Update()
{
  const bool isNew = this->Bricks.Follow();
  vtkVolumeMapper* const mapper = this->Mapper;
  if (!mapper || this->Carved.Removal->Bricks.IsEmpty())
  {
    return false;
  }
  if (this->Copy)
  {
    return this->Copy->Update();
  }
  if (FindShownPort(mapper, this->Carved.Array) < 0)
  {
    if (this->Texture)
    {
      this->Texture->Forget();
    }
    return false;
  }
  if (this->Texture && !this->Texture->IsImpossible() && !DrawsOtherwise(mapper))
  {
    const bool isDue = this->Texture->TakeFrameDue();
    return isNew || isDue;
  }
  if (this->Texture)
  {
    this->Texture->Restore();
    this->Texture = nullptr;
  }
  this->Copy = std::make_unique<CarvedCopy>(mapper, this->Carved, this->Bricks);
  return this->Copy->Update();
}

} // namespace VolumeHaptics
