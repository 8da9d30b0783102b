// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Volumes/CarvedCopy.h"

#include "VTK/Base/ArrayMemory.h"

#include "vtkDataSetAttributes.h"
#include "vtkHapticRemoval.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkPointData.h"

#include <cstring>

namespace VolumeHaptics
{
namespace
{

vtkImageData* FindImage(vtkVolumeMapper* mapper, int port)
{
  return mapper->GetNumberOfInputConnections(port) > 0
    ? vtkImageData::SafeDownCast(mapper->GetInputDataObject(port, 0))
    : nullptr;
}

/** What a mapper shows of the image on a port. */
vtkDataArray* GetShown(vtkVolumeMapper* mapper, int port)
{
  vtkImageData* const image = FindImage(mapper, port);
  int isCells = 0;
  return image
    ? vtkAbstractMapper::GetScalars(image, mapper->GetScalarMode(), mapper->GetArrayAccessMode(),
        mapper->GetArrayId(), mapper->GetArrayName(), isCells)
    : nullptr;
}

bool IsShownInstead(vtkDataArray* shown, vtkDataArray* touched)
{
  return shown->HasInformation() &&
    shown->GetInformation()->Get(vtkHapticRemoval::TOUCHED_ARRAY()) == touched &&
    shown->GetNumberOfTuples() == touched->GetNumberOfTuples() &&
    shown->GetNumberOfComponents() == touched->GetNumberOfComponents();
}

} // namespace

int FindShownPort(vtkVolumeMapper* mapper, vtkDataArray* array)
{
  for (int port = 0; mapper && port < mapper->GetNumberOfInputPorts(); ++port)
  {
    if (GetShown(mapper, port) == array)
    {
      return port;
    }
  }
  return -1;
}

vtkDataArray* FindShownArray(vtkVolumeMapper* mapper, vtkDataArray* touched)
{
  for (int port = 0; mapper && port < mapper->GetNumberOfInputPorts(); ++port)
  {
    vtkDataArray* const shown = GetShown(mapper, port);
    if (shown && (shown == touched || IsShownInstead(shown, touched)))
    {
      return shown;
    }
  }
  return nullptr;
}

bool CarvedCopy::Replace()
{
  vtkVolumeMapper* const mapper = this->Mapper;
  const int port = FindShownPort(mapper, this->Carved.Array);
  if (port < 0)
  {
    return false;
  }
  this->Image = FindImage(mapper, port);
  this->Copy.TakeReference(this->Image->NewInstance());
  this->CopyImage();
  this->Input.Put(mapper, port, this->Copy);
  return true;
}

void CarvedCopy::CopyImage()
{
  this->ImageTime = this->Image->GetMTime();
  this->Left = CopyArray(this->Carved.Array);
  if (this->Left->HasInformation())
  {
    // The copy belongs to this picture.
    this->Left->GetInformation()->Remove(vtkHapticRemoval::TOUCHED_ARRAY());
  }
  this->Copy->ShallowCopy(this->Image);
  // Arrays keep their indices, because a mapper may select an array by index.
  vtkPointData* const from = this->Image->GetPointData();
  vtkPointData* const to = this->Copy->GetPointData();
  to->Initialize();
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = from->GetAbstractArray(i);
    to->AddArray(array == this->Carved.Array ? this->Left.Get() : array);
  }
  int attributes[vtkDataSetAttributes::NUM_ATTRIBUTES];
  from->GetAttributeIndices(attributes);
  for (int kind = 0; kind < vtkDataSetAttributes::NUM_ATTRIBUTES; ++kind)
  {
    if (attributes[kind] >= 0)
    {
      to->SetActiveAttribute(attributes[kind], kind);
    }
  }
  this->Bricks.TakeAll([this](std::uint32_t brick) { this->WriteBrick(brick); });
}

bool CarvedCopy::Update()
{
  if (!this->Input.IsShown())
  {
    return this->Replace();
  }
  if (this->Input.UpdateReplaced() != this->Image)
  {
    this->Input.GiveBack();
    return this->Replace();
  }
  if (this->Image->GetMTime() != this->ImageTime)
  {
    this->CopyImage();
    return true;
  }
  bool isNew = false;
  this->Bricks.Take(
    [this, &isNew](std::uint32_t brick)
    {
      this->WriteBrick(brick);
      isNew = true;
    });
  if (isNew)
  {
    this->Left->Modified();
    this->Copy->Modified();
  }
  return isNew;
}

void CarvedCopy::WriteBrick(std::uint32_t brick)
{
  ArrayBox box;
  if (!FindBrickBox(this->Carved, brick, box))
  {
    return;
  }
  CopyBrick(this->Carved, brick, BrickContent::Left, box, this->Buffer);
  const auto tuple = static_cast<std::int64_t>(
    this->Buffer.size() / static_cast<std::size_t>(box.Samples())); // bytes
  auto* const values = static_cast<unsigned char*>(this->Left->GetVoidPointer(0));
  const unsigned char* from = this->Buffer.data();
  for (std::int64_t k = box.Low[2]; k < box.Low[2] + box.Size[2]; ++k)
  {
    for (std::int64_t j = box.Low[1]; j < box.Low[1] + box.Size[1]; ++j)
    {
      const std::int64_t at =
        box.Low[0] + this->Carved.Dimensions[0] * (j + this->Carved.Dimensions[1] * k);
      const std::int64_t row = tuple * box.Size[0];
      std::memcpy(values + tuple * at, from, static_cast<std::size_t>(row));
      from += row;
    }
  }
}

} // namespace VolumeHaptics
