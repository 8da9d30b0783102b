// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Primitives/ModePrimitives.h"

#include "Core/Math/SymmetricEigen.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/** Adds the primitives of a mode. What it cannot read has the strength 0, but keeps its place. */
class ModeReader
{
public:
  ModeReader(const BakedMode& mode, const Vector3& index, const Matrix3& worldToDevice,
    const Vector3& place, PrimitiveSet& set) noexcept
    : Mode(mode)
    , Index(index)
    , WorldToDevice(worldToDevice)
    , Place(place)
    , Set(set)
    , Fade(std::clamp(
        mode.Field.GetSampler().DistanceToBorder(index) / ModeField::FadeDistance, 0.0, 1.0))
  {
  }

  void Read() noexcept
  {
    switch (this->Mode.Kind)
    {
      case ModeKind::VectorFollow:
      case ModeKind::VectorFront:
      case ModeKind::TwoSidedFront:
        this->ReadVector();
        break;
      case ModeKind::VortexTube:
        this->ReadVortex();
        break;
      case ModeKind::Shear:
        this->ReadShear();
        break;
      case ModeKind::TensorFollow:
        this->ReadTensor();
        break;
    }
  }

private:
  void ReadVector() noexcept
  {
    Vector3 v;
    this->Mode.Field.Read(this->Index, v);
    const double magnitude = Norm(v);
    const double strength = this->StrengthAt(0, magnitude);
    if (this->Mode.Kind == ModeKind::VectorFollow)
    {
      this->Add(PrimitiveKind::Line, v, strength);
      this->Add(PrimitiveKind::Force, v, this->StrengthAt(1, magnitude));
      return;
    }
    this->Add(PrimitiveKind::Plane, v, strength);
    if (this->Mode.Kind == ModeKind::TwoSidedFront)
    {
      this->Add(PrimitiveKind::Plane, -v, strength);
    }
  }

  void ReadVortex() noexcept
  {
    Vector3 v;
    Matrix3 j;
    this->Mode.Field.Read(this->Index, v, j);
    const Vector3 curl{ j.Row[2].Y - j.Row[1].Z, j.Row[0].Z - j.Row[2].X, j.Row[1].X - j.Row[0].Y };
    const double magnitude = Norm(curl);
    this->Add(PrimitiveKind::Plane, Cross(curl, v), this->StrengthAt(0, magnitude));
    this->Add(PrimitiveKind::Line, curl, this->StrengthAt(1, magnitude));
  }

  void ReadShear() noexcept
  {
    Vector3 v;
    Matrix3 j;
    const bool isThere = this->Mode.Field.Read(this->Index, v, j);
    const Matrix3 turned = Transpose(j);
    const SymmetricEigen rates = FindEigen({ { 0.5 * (j.Row[0] + turned.Row[0]),
      0.5 * (j.Row[1] + turned.Row[1]), 0.5 * (j.Row[2] + turned.Row[2]) } });
    const double strength = isThere ? this->StrengthAt(0, rates.Value[0]) : 0.0;
    this->Add(PrimitiveKind::Line, rates.Direction[0], strength);
  }

  void ReadTensor() noexcept
  {
    Matrix3 tensor;
    this->Mode.Field.ReadTensor(this->Index, tensor);
    const SymmetricEigen eigen = FindEigen(tensor);
    const double l1 = eigen.Value[0];
    const double l2 = std::max(eigen.Value[1], 0.0);
    const double l3 = std::max(eigen.Value[2], 0.0);
    const bool isThere = l1 > 0.0;
    const double fibre = isThere ? this->StrengthAt(0, (l1 - l2) / l1) : 0.0;
    const double sheet = isThere ? this->StrengthAt(1, (l2 - l3) / l1) : 0.0;
    this->Add(PrimitiveKind::Line, eigen.Direction[0], fibre);
    this->Add(PrimitiveKind::Plane, eigen.Direction[2], sheet);
    this->Add(PrimitiveKind::Plane, -eigen.Direction[2], sheet);
  }

  double StrengthAt(int channel, double x) const noexcept
  {
    return std::isfinite(x) ? this->Fade * this->Mode.Strengths(x)[channel] : 0.0;
  }

  /** A direction in the world. */
  void Add(PrimitiveKind kind, const Vector3& direction, double strength) noexcept
  {
    this->Set.Add({ kind, this->WorldToDevice * direction, this->Place, strength });
  }

  const BakedMode& Mode;
  const Vector3& Index;
  const Matrix3& WorldToDevice;
  const Vector3& Place;
  PrimitiveSet& Set;
  const double Fade;
};

} // namespace

int CountPrimitives(ModeKind kind) noexcept
{
  switch (kind)
  {
    case ModeKind::VectorFront:
    case ModeKind::Shear:
      return 1;
    case ModeKind::TensorFollow:
      return 3;
    case ModeKind::VectorFollow:
    case ModeKind::TwoSidedFront:
    case ModeKind::VortexTube:
      break;
  }
  return 2;
}

ModeField::ModeField(const Affine3& indexToWorld, const Affine3& deviceToWorld) noexcept
  : DeviceToIndex(Compose(Inverse(indexToWorld), deviceToWorld))
  , WorldToDevice(Transpose(RotationOf(deviceToWorld)))
{
}

bool ModeField::Add(const BakedMode& mode) noexcept
{
  const int count = CountPrimitives(mode.Kind);
  if (!mode.IsValid() || this->Count >= Most || this->Primitives + count > PrimitiveSet::Most)
  {
    return false;
  }
  this->Modes[this->Count++] = &mode;
  this->Primitives += count;
  return true;
}

Vector3 ModeField::ForceOf(int mode, const PrimitiveForces& forces) const noexcept
{
  int first = 0;
  for (int i = 0; i < mode; ++i)
  {
    first += CountPrimitives(this->Modes[i]->Kind);
  }
  Vector3 sum;
  for (int i = 0; i < CountPrimitives(this->Modes[mode]->Kind); ++i)
  {
    sum += forces[first + i];
  }
  return sum;
}

void ModeField::Find(const void* context, const Vector3& place, PrimitiveSet& set) noexcept
{
  const auto& field = *static_cast<const ModeField*>(context);
  const Vector3 index = field.DeviceToIndex(place);
  for (int i = 0; i < field.Count; ++i)
  {
    ModeReader(*field.Modes[i], index, field.WorldToDevice, place, set).Read();
  }
}

} // namespace VolumeHaptics
