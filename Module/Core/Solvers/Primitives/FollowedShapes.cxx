// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Primitives/FollowedShapes.h"

#include "Core/Math/SymmetricEigen.h"
#include "Core/Model/HapticModel.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/** Within this distance (voxels) from its anchor, a place counts as on the line. */
constexpr double OnLine = 1e-4;

} // namespace

FollowedShapes::FollowedShapes(const HapticModel& model)
  : Model(model)
  , Voxel(1.0 / model.MostVoxelsPerMeter)
  , Modes(model, model.Baked->Settings.CouplingStiffness, Vector3{}, this->Memory)
{
}

std::vector<FollowedShape> FollowedShapes::Collect(const Vector3& place)
{
  std::vector<FollowedShape> shapes;
  if (this->Model.Baked->Settings.Method == HapticMethod::Primitives && IsFinite(place))
  {
    for (int mode = 0; mode < this->Modes.GetCount(); ++mode)
    {
      this->CollectOf(mode, place, shapes);
    }
  }
  return shapes;
}

void FollowedShapes::CollectOf(int mode, const Vector3& place, std::vector<FollowedShape>& shapes)
{
  const ModeKind kind = this->KindOf(mode);
  const ModeFacts facts = FactsOf(kind);
  if (!(facts.HasLine || facts.HasFront) || !this->Read(mode, place))
  {
    return;
  }
  if (const Primitive* const front = this->FindFront(kind))
  {
    shapes.push_back({ FollowedForm::Front, mode, front->Anchor, front->Direction, {} });
  }
  this->AddTensor(mode, place, shapes);
  Vector3 start = place;
  if (facts.HasLine && this->FindStart(mode, start) && this->Read(mode, start))
  {
    if (const Primitive* const line = this->FindLine(kind))
    {
      shapes.push_back({ FollowedForm::Line, mode, start, line->Direction, {} });
    }
  }
}

void FollowedShapes::AddTensor(
  int mode, const Vector3& place, std::vector<FollowedShape>& shapes) const
{
  Matrix3 tensor;
  const bool isTensor = this->KindOf(mode) == ModeKind::TensorFollow &&
    this->Model.Baked->Modes[static_cast<std::size_t>(mode)].Field.ReadTensor(
      this->Model.DeviceToIndex(place), tensor);
  const double first = isTensor ? ComputeEigen(tensor).Value[0] : 0.0;
  if (first > 0.0)
  {
    shapes.push_back({ FollowedForm::Tensor, mode, place, {}, (1.0 / first) * tensor });
  }
}

ModeKind FollowedShapes::KindOf(int mode) const
{
  return this->Model.Baked->Modes[static_cast<std::size_t>(mode)].Kind;
}

bool FollowedShapes::Read(int mode, const Vector3& place)
{
  this->Set.Clear();
  this->Modes.Read(mode, place, this->Set);
  return this->Set.SumStrengths() > 0.0;
}

const Primitive* FollowedShapes::FindFront(ModeKind kind) const
{
  return FactsOf(kind).HasFront ? this->FindPrimitive(PrimitiveKind::Plane, 0.0) : nullptr;
}

const Primitive* FollowedShapes::FindLine(ModeKind kind) const
{
  return this->FindPrimitive(PrimitiveKind::Line, kind == ModeKind::VortexTube ? -1.0 : 0.0);
}

const Primitive* FollowedShapes::FindPrimitive(PrimitiveKind kind, double strength) const
{
  for (const Primitive& found : this->Set)
  {
    if (found.Kind == kind && found.Strength > strength && IsFinite(found.Direction))
    {
      return &found;
    }
  }
  return nullptr;
}

bool FollowedShapes::FindStart(int mode, Vector3& place)
{
  constexpr int most = 256;
  const ModeKind kind = this->KindOf(mode);
  for (int i = 0; i < most; ++i)
  {
    const Primitive* const line = this->Read(mode, place) ? this->FindLine(kind) : nullptr;
    if (!line)
    {
      return false;
    }
    Vector3 motion = line->Anchor - place;
    motion = motion - Dot(motion, line->Direction) * line->Direction;
    const Primitive* const wall = this->FindPrimitive(PrimitiveKind::Plane, 0.0);
    // Far from the core of a vortex, only the direction to the core is known.
    if (kind == ModeKind::VortexTube && wall && !(Norm(motion) > 0.0))
    {
      motion = this->Voxel * wall->Direction;
    }
    const double length = Norm(motion);
    if (!(length > OnLine * this->Voxel))
    {
      return std::isfinite(length);
    }
    // A ridge may be some voxels away. A longer step of Newton's method is wrong.
    const double longest = (kind == ModeKind::VortexTube ? 1.0 : 32.0) * this->Voxel;
    place = place + std::min(1.0, longest / length) * motion;
    if (kind == ModeKind::Guide)
    {
      return true; // already the nearest place; another step might leave it
    }
  }
  return kind == ModeKind::Ridge;
}

bool FollowedShapes::Turn(int mode, const Vector3& place, Vector3& direction)
{
  const Primitive* const line =
    this->Read(mode, place) ? this->FindLine(this->KindOf(mode)) : nullptr;
  if (line)
  {
    direction = Dot(line->Direction, direction) < 0.0 ? -line->Direction : line->Direction;
  }
  return line;
}

bool FollowedShapes::Return(int mode, Vector3& place)
{
  const ModeKind kind = this->KindOf(mode);
  const Primitive* const line = this->Read(mode, place) ? this->FindLine(kind) : nullptr;
  if (!line)
  {
    return false;
  }
  const Primitive* const end =
    kind == ModeKind::Guide ? this->FindPrimitive(PrimitiveKind::Plane, 0.0) : nullptr;
  if (end && Dot(place - end->Anchor, end->Direction) < 0.0)
  {
    place = end->Anchor;
    return false;
  }
  const Vector3 away = line->Anchor - place;
  const Vector3 across = away - Dot(away, line->Direction) * line->Direction;
  if (Norm(across) < this->Voxel)
  {
    place = place + across;
  }
  return true;
}

} // namespace VolumeHaptics
