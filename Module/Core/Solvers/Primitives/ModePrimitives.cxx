// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Primitives/ModePrimitives.h"

#include "Core/Law/MaterialLaw.h"
#include "Core/Math/SymmetricEigen.h"
#include "Core/Solvers/Primitives/MaterialPrimitives.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{

/**
 * Adds the primitives of a mode. A primitive that can't be read is added with the strength 0.
 */
class ModeReader
{
public:
  ModeReader(const ModeField& field, const BakedMode& mode, const Vector3& index,
    const Vector3& place, PrimitiveSet& set) noexcept
    : Modes(field)
    , Mode(mode)
    , Index(index)
    , Place(place)
    , Set(set)
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
      case ModeKind::Ridge:
        this->ReadRidge();
        break;
      case ModeKind::Guide:
        this->ReadGuide();
        break;
      case ModeKind::GuideSurface:
        this->ReadGuideSurface();
        break;
      case ModeKind::Surface:
        this->ReadSurface();
        break;
    }
  }

private:
  void ReadVector() noexcept
  {
    this->SetFade(this->Mode.Field.GetSampler().DistanceToBorder(this->Index));
    Vector3 v;
    this->Mode.Field.Read(this->Index, v);
    const auto strengths = this->StrengthsAt(Norm(v));
    if (this->Mode.Kind == ModeKind::VectorFollow)
    {
      this->Add(PrimitiveKind::Line, v, strengths[0]);
      this->Add(PrimitiveKind::Force, v, strengths[1]);
      return;
    }
    this->Add(PrimitiveKind::Plane, v, strengths[0]);
    if (this->Mode.Kind == ModeKind::TwoSidedFront)
    {
      this->Add(PrimitiveKind::Plane, -v, strengths[0]);
    }
  }

  void ReadVortex() noexcept
  {
    this->SetFade(this->Mode.Field.GetSampler().DistanceToBorder(this->Index));
    Vector3 v;
    Matrix3 j;
    this->Mode.Field.Read(this->Index, v, j);
    const Vector3 curl{ j.Row[2].Y - j.Row[1].Z, j.Row[0].Z - j.Row[2].X, j.Row[1].X - j.Row[0].Y };
    const double magnitude = Norm(curl);
    const auto strengths = this->StrengthsAt(magnitude);
    const double strength = strengths[0];
    Vector3 toCore;
    const double atCore = this->ComputeCore(v, j, (1.0 / magnitude) * curl, toCore);
    const Vector3 core = this->Place + this->ToDevice(toCore);
    this->Add(PrimitiveKind::Plane, Cross(curl, v), (1.0 - atCore) * strength);
    this->Add(PrimitiveKind::Line, curl, atCore > 0.0 ? atCore * strength : 0.0, core);
    this->Add(PrimitiveKind::Line, curl, strengths[1]);
  }

  /**
   * Computes the displacement (world) to the core of a vortex. Returns the fraction of the strength
   * with which the core holds, or 0 if it is far away.
   */
  double ComputeCore(
    const Vector3& v, const Matrix3& j, const Vector3& axis, Vector3& toCore) const noexcept
  {
    // Newton's step to the core is at least as long as the component of v across the axis, divided
    // by the norm of the Jacobian. If even this length exceeds CoreSight, the core is too far away.
    constexpr double far = ModeField::CoreSight * ModeField::CoreSight;
    const double along = Dot(v, axis);
    const double slopes =
      Dot(j.Row[0], j.Row[0]) + Dot(j.Row[1], j.Row[1]) + Dot(j.Row[2], j.Row[2]);
    const double reach = far * this->Mode.Field.GetSquaredVoxel() * slopes;
    // The comparison is false for NaN, too.
    if (!(std::abs(Dot(v, v) - along * along) <= reach))
    {
      return 0.0;
    }
    const Vector3 a = UnitAcross(axis);
    const Vector3 b = Cross(axis, a);
    const Vector3 ja = j * a;
    const Vector3 jb = j * b;
    const double aa = Dot(a, ja);
    const double ab = Dot(a, jb);
    const double ba = Dot(b, ja);
    const double bb = Dot(b, jb);
    const double determinant = aa * bb - ab * ba;
    // A flow that is a shear rather than a rotation has no core.
    if (!(determinant > 0.0))
    {
      return 0.0;
    }
    const double va = Dot(a, v);
    const double vb = Dot(b, v);
    toCore = (-(bb * va - ab * vb) / determinant) * a + (-(aa * vb - ba * va) / determinant) * b;
    const double away = this->VoxelsOf(toCore);
    const double fraction = std::clamp(2.0 - away / ModeField::CoreReach, 0.0, 1.0);
    return std::isfinite(away) ? fraction : 0.0;
  }

  void ReadShear() noexcept
  {
    this->SetFade(this->Mode.Field.GetSampler().DistanceToBorder(this->Index));
    Vector3 v;
    Matrix3 j;
    const bool isThere = this->Mode.Field.Read(this->Index, v, j);
    const SymmetricEigen rates = ComputeEigen(SymmetricPart(j));
    // A pure rotation has no direction of stretch, but rounding may produce one.
    const double least = LeastFraction * (Norm(j.Row[0]) + Norm(j.Row[1]) + Norm(j.Row[2]));
    const bool stretches = isThere && rates.Value[0] > least;
    const double strength = stretches ? this->StrengthAt(0, rates.Value[0]) : 0.0;
    this->Add(PrimitiveKind::Line, rates.Direction[0], strength);
  }

  void ReadTensor() noexcept
  {
    this->SetFade(this->Mode.Field.GetSampler().DistanceToBorder(this->Index));
    Matrix3 tensor;
    this->Mode.Field.ReadTensor(this->Index, tensor);
    const SymmetricEigen eigen = ComputeEigen(tensor);
    const double l1 = eigen.Value[0];
    const double l2 = std::max(eigen.Value[1], 0.0);
    const double l3 = std::max(eigen.Value[2], 0.0);
    const double linear = (l1 - l2) / l1;
    const double planar = (l2 - l3) / l1;
    const bool isThere = l1 > 0.0;
    const double fibre = isThere && linear > LeastFraction ? this->StrengthAt(0, linear) : 0.0;
    const double sheet = isThere && planar > LeastFraction ? this->StrengthAt(1, planar) : 0.0;
    this->Add(PrimitiveKind::Line, eigen.Direction[0], fibre);
    this->Add(PrimitiveKind::Plane, eigen.Direction[2], sheet);
    this->Add(PrimitiveKind::Plane, -eigen.Direction[2], sheet);
  }

  void ReadRidge() noexcept
  {
    const FieldSampler& scalars = this->Modes.Model->Baked->Field;
    // The differences need samples one more voxel away.
    this->SetFade(scalars.DistanceToBorder(this->Index) - 1.0);
    Vector3 toRidge;
    Vector3 along{ 1.0, 0.0, 0.0 };
    double strength = 0.0;
    if (this->Fade > 0.0)
    {
      strength = this->ComputeRidge(scalars, along, toRidge);
    }
    this->Add(PrimitiveKind::Line, along, strength, this->Place + this->ToDevice(toRidge));
  }

  /**
   * Computes the direction of the ridge and the displacement (world) to it. Returns its strength
   * (N).
   */
  double ComputeRidge(const FieldSampler& scalars, Vector3& along, Vector3& toRidge) const noexcept
  {
    constexpr double half = 0.5; // in voxels
    const auto slope = [&](double x, double y, double z)
    {
      const Vector3 ahead = scalars.Gradient(this->Index + Vector3{ x, y, z }).Gradient;
      const Vector3 behind = scalars.Gradient(this->Index - Vector3{ x, y, z }).Gradient;
      return (1.0 / (2.0 * half)) * (ahead - behind);
    };
    const double sign = this->Mode.IsDark ? -1.0 : 1.0;
    const Matrix3 worldToIndex = Inverse(this->Modes.Model->Baked->IndexToWorld.Linear);
    const Matrix3 turned = Transpose(worldToIndex);
    const Matrix3 ofIndex =
      Matrix3::FromColumns(slope(half, 0.0, 0.0), slope(0.0, half, 0.0), slope(0.0, 0.0, half));
    const Vector3 gradient = sign * (turned * scalars.Gradient(this->Index).Gradient);
    const SymmetricEigen eigen =
      ComputeEigen(sign * (turned * (SymmetricPart(ofIndex) * worldToIndex)));
    // At a bright line, two eigenvalues are negative, and the third has a smaller magnitude.
    const double h1 = eigen.Value[0];
    const double h2 = eigen.Value[1];
    const double h3 = eigen.Value[2];
    const double measure = -h2 - std::abs(h1);
    if (!(h2 < 0.0 && measure > 0.0) || !IsFinite(gradient))
    {
      return 0.0;
    }
    along = eigen.Direction[0];
    const Vector3& second = eigen.Direction[1];
    const Vector3& third = eigen.Direction[2];
    toRidge = (-Dot(second, gradient) / h2) * second + (-Dot(third, gradient) / h3) * third;
    const double away = this->VoxelsOf(toRidge);
    const double fraction = std::clamp(2.0 - away / this->Mode.SnapDistance, 0.0, 1.0);
    return std::isfinite(away) ? fraction * this->StrengthAt(0, measure) : 0.0;
  }

  void ReadGuide() noexcept
  {
    const Vector3 world = this->Modes.DeviceToWorld(this->Place);
    const GuidePlace found = this->Mode.Guide->Find(world);
    const double strength = this->StrengthAt(0, Norm(world - found.Nearest));
    this->Add(
      PrimitiveKind::Line, found.Direction, strength, this->Modes.WorldToDevice(found.Nearest));
    this->Add(PrimitiveKind::Plane, -found.Outward, found.IsNearEnd ? strength : 0.0,
      this->Modes.WorldToDevice(found.End));
  }

  void ReadGuideSurface() noexcept
  {
    const GuideSurfacePlace found =
      this->Mode.GuideSurface->Find(this->Modes.DeviceToWorld(this->Place));
    const double strength = found.Fraction * this->StrengthAt(0, found.Distance);
    const Vector3 anchor = this->Modes.WorldToDevice(found.Anchor);
    const GuideSide side = this->Mode.Side;
    const bool holdsOut = side != GuideSide::Inside;
    const bool holdsIn = side != GuideSide::Outside;
    this->Add(PrimitiveKind::Plane, found.Normal, holdsOut ? strength : 0.0, anchor);
    this->Add(PrimitiveKind::Plane, -found.Normal, holdsIn ? strength : 0.0, anchor);
  }

  void ReadSurface() noexcept
  {
    const HapticModel& model = *this->Modes.Model;
    const FieldAtTime field(model.Baked->Field);
    const Vector3 lag = this->Modes.Tip - this->Place;
    Surface surface = Law::ComputeSurface(model, field, this->Index, *this->Modes.Memory);
    Law::Orient(model, lag, surface);
    MaterialPoint point;
    Law::ReadMaterials(model, field, this->Index, surface, *this->Modes.Memory, point);
    if (!Law::IsFelt(point))
    {
      point.SurfaceStrength = point.Viscosity = 0.0;
    }
    AddMaterial(point, this->Modes.Stiffness, this->Place, this->Modes.Tip, this->Set);
  }

  /** Eigenvalues whose relative difference is below this limit have no directions. */
  static constexpr double LeastFraction = 1e-9;

  static Matrix3 SymmetricPart(const Matrix3& m) noexcept
  {
    const Matrix3 turned = Transpose(m);
    return { { 0.5 * (m.Row[0] + turned.Row[0]), 0.5 * (m.Row[1] + turned.Row[1]),
      0.5 * (m.Row[2] + turned.Row[2]) } };
  }

  void SetFade(double voxels) noexcept
  {
    const HapticModel* const model = this->Modes.Model;
    this->Fade = std::clamp(voxels / ModeField::FadeDistance, 0.0, 1.0) *
      (model ? model->Baked->KeptFraction(this->Index) : 1.0);
  }

  PiecewiseTable<2>::Values StrengthsAt(double x) const noexcept
  {
    if (!std::isfinite(x))
    {
      return { 0.0, 0.0 };
    }
    const PiecewiseTable<2>::Values whole = this->Mode.Strengths(x);
    return { this->Fade * whole[0], this->Fade * whole[1] };
  }
  double StrengthAt(int channel, double x) const noexcept { return this->StrengthsAt(x)[channel]; }

  Vector3 ToDevice(const Vector3& displacement) const noexcept
  {
    return this->Modes.WorldToDevice.Linear * displacement;
  }
  double VoxelsOf(const Vector3& displacement) const noexcept
  {
    return Norm(this->Modes.DeviceToIndex.Linear * this->ToDevice(displacement));
  }

  ///@{
  /**
   * Adds a primitive with a direction in the world. Its anchor is this place, or `anchor` (device).
   */
  void Add(PrimitiveKind kind, const Vector3& direction, double strength) noexcept
  {
    this->Add(kind, direction, strength, this->Place);
  }
  void Add(
    PrimitiveKind kind, const Vector3& direction, double strength, const Vector3& anchor) noexcept
  {
    this->Set.Add({ kind, this->Modes.Turn * direction, anchor, strength });
  }
  ///@}

  const ModeField& Modes;
  const BakedMode& Mode;
  const Vector3& Index;
  const Vector3& Place;
  PrimitiveSet& Set;
  double Fade = 1.0;
};

ModeField::ModeField(const Affine3& indexToWorld, const Affine3& deviceToWorld) noexcept
  : DeviceToIndex(Compose(Inverse(indexToWorld), deviceToWorld))
  , DeviceToWorld(deviceToWorld)
  , WorldToDevice(Inverse(deviceToWorld))
  , Turn(Transpose(RotationOf(deviceToWorld)))
{
}

ModeField::ModeField(
  const HapticModel& model, double k, const Vector3& tip, LabelMemory& memory) noexcept
  : DeviceToIndex(model.DeviceToIndex)
  , DeviceToWorld(model.DeviceToWorld)
  , WorldToDevice(model.WorldToDevice)
  , Turn(Transpose(model.DeviceToWorldRotation))
  , Model(&model)
  , Memory(&memory)
  , Stiffness(k)
  , Tip(tip)
{
  for (const BakedMode& mode : model.Baked->Modes)
  {
    this->Add(mode);
  }
}

bool ModeField::Add(const BakedMode& mode) noexcept
{
  if (this->Count >= Most)
  {
    return false;
  }
  const ModeFacts facts = FactsOf(mode.Kind);
  const bool readsScalars = facts.Input == ModeInput::Scalars;
  const int first = this->First[this->Count];
  const int count = facts.Primitives;
  const bool fits =
    mode.IsValid() && (this->Model || !readsScalars) && first + count <= PrimitiveSet::Most;
  const bool isFelt = fits && mode.IsActive;
  this->Modes[this->Count++] = isFelt ? &mode : nullptr;
  this->First[this->Count] = first + (isFelt ? count : 0);
  return fits || !mode.IsActive;
}

Vector3 ModeField::ForceOf(int mode, const PrimitiveForces& forces) const noexcept
{
  Vector3 sum;
  for (int i = this->First[mode]; i < this->First[mode + 1]; ++i)
  {
    sum += forces[i];
  }
  return sum;
}

void ModeField::Read(int mode, const Vector3& place, PrimitiveSet& set) const noexcept
{
  if (this->Modes[mode])
  {
    const Vector3 index = this->DeviceToIndex(place);
    ModeReader(*this, *this->Modes[mode], index, place, set).Read();
  }
}

void ModeField::Collect(const void* context, const Vector3& place, PrimitiveSet& set) noexcept
{
  const auto& field = *static_cast<const ModeField*>(context);
  const Vector3 index = field.DeviceToIndex(place);
  for (int i = 0; i < field.Count; ++i)
  {
    if (field.Modes[i])
    {
      ModeReader(field, *field.Modes[i], index, place, set).Read();
    }
  }
}

} // namespace VolumeHaptics
