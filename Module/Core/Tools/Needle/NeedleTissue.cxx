// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/Needle/NeedleTissue.h"

#include "Core/Law/MaterialLaw.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

///@{
/** Channels of MaterialTable. All except the last one are also channels of labels. */
constexpr int StiffnessChannel = 0;
constexpr int StrengthChannel = 2;
constexpr int DragChannel = 3;
constexpr int VisibilityChannel = 4;
///@}

constexpr double StepFraction = 0.25; // in voxels

} // namespace

NeedleTissueReader::NeedleTissueReader(
  const HapticModel& model, double dataTime, LabelMemory& memory) noexcept
  : Model(model)
  , Needle(GetNeedle(model))
  , Labels(model.Baked->Labels.get())
  , Field(model.Baked->At(dataTime))
  , Memory(memory)
  , HasSurfaces(model.Baked->Materials.GetRange(StrengthChannel).High > 0.0 &&
      model.Baked->Distinctness.GetRange(0).High > 0.0)
{
}

NeedleTissue NeedleTissueReader::At(const Vector3& place) const noexcept
{
  NeedleTissue tissue;
  const BakedVolume& baked = *this->Model.Baked;
  const Vector3 index = this->Model.DeviceToIndex(place);
  // The condition is true for NaN, too.
  if (!this->Field.IsInside(index))
  {
    return tissue;
  }
  tissue.Value = this->Field.Value(index);
  const double kept = baked.KeptFraction(index);
  const MaterialTable::Values material = baked.Materials(tissue.Value);
  const PiecewiseTable<2>::Values own = this->Needle.Forces(tissue.Value);
  tissue.Shaft = own[0];
  tissue.Cutting = this->Needle.Description.HasCuttingForce
    ? own[1]
    : material[DragChannel] * material[VisibilityChannel];
  tissue.Label = this->Model.LabelAtDevice(place);
  if (const LabelMaterial* const label = this->FindLabel(tissue.Label))
  {
    tissue.Cutting = label->IsSet[DragChannel] ? label->Value[DragChannel] : tissue.Cutting;
    tissue.Shaft = label->HasShaftFriction ? label->ShaftFriction : tissue.Shaft;
    tissue.HasPuncture = label->IsSet[StrengthChannel];
    tissue.Puncture = tissue.HasPuncture ? label->Value[StrengthChannel] : 0.0;
  }
  // The comparisons are false for NaN, which a volume may contain.
  tissue.Cutting = tissue.Cutting > 0.0 ? kept * tissue.Cutting : 0.0;
  tissue.Shaft = tissue.Shaft > 0.0 ? kept * tissue.Shaft : 0.0;
  tissue.Puncture = tissue.Puncture > 0.0 ? kept * tissue.Puncture : 0.0;
  return tissue;
}

double NeedleTissueReader::SurfaceStrength(const Vector3& place, const Vector3& axis) const noexcept
{
  if (!this->HasSurfaces)
  {
    return 0.0;
  }
  const Vector3 index = this->Model.DeviceToIndex(place);
  Surface surface = Law::ComputeSurface(this->Model, this->Field, index, this->Memory);
  Law::Orient(this->Model, axis, surface);
  if (!(Dot(surface.Normal, axis) > 0.0) || surface.IsForbidden)
  {
    return 0.0;
  }
  if (this->Labels)
  {
    const Vector3 behind = this->Model.IndexToLabel(index + surface.Reach);
    const LabelMaterial* const label = this->FindLabel(this->Labels->View.Nearest(behind));
    if (label && label->IsSet[StrengthChannel])
    {
      return 0.0;
    }
  }
  MaterialPoint point;
  Law::ReadMaterials(this->Model, this->Field, index, surface, this->Memory, point);
  return point.SurfaceStrength > 0.0 ? point.SurfaceStrength : 0.0;
}

double NeedleTissueReader::Stiffness(const Vector3& place) const noexcept
{
  const double value = this->Field.Value(this->Model.DeviceToIndex(place));
  double stiffness = this->Model.Baked->Materials(value)[StiffnessChannel];
  const LabelMaterial* const material = this->FindLabel(this->Model.LabelAtDevice(place));
  const bool isOfLabel = material && material->IsSet[StiffnessChannel];
  stiffness = isOfLabel ? material->Value[StiffnessChannel] : stiffness;
  return Law::Capped(stiffness, this->Model.Caps.Stiffness);
}

bool NeedleTissueReader::IsForbidden(const Vector3& place) const noexcept
{
  const ForbiddenZone* const zone = this->Model.Baked->GetZone();
  if (!zone)
  {
    return false;
  }
  const ForbiddenPlace at = this->Labels->ComputeForbidden(this->Model.DeviceToLabel(place));
  return at.IsNear && at.Distance < zone->GetStandOff();
}

double NeedleTissueReader::ComputeStep(const Vector3& axis) const noexcept
{
  double steps = Norm(this->Model.DeviceToIndex.Linear * axis);
  if (this->Labels)
  {
    steps = std::max(steps, Norm(this->Model.DeviceToLabel.Linear * axis));
  }
  return StepFraction / steps;
}

} // namespace VolumeHaptics
