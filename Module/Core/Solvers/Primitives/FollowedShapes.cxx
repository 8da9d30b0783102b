// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Primitives/FollowedShapes.h"

#include "Core/Math/SymmetricEigen.h"
#include "Core/Solvers/Primitives/ModePrimitives.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr double StepVoxels = 0.5;
/** More steps than this show nothing that a person could tell apart. */
constexpr int MostLineSteps = 2000;
/** Voxels. A place this near to its anchor is on the line. */
constexpr double OnLine = 1e-4;

/** Reads the primitives of one mode, and follows its line. */
class ShapeFinder
{
public:
  ShapeFinder(const HapticModel& model, const ModeField& modes, int mode)
    : Model(model)
    , Modes(modes)
    , Mode(mode)
    , Kind(model.Baked->Modes[static_cast<std::size_t>(mode)].Kind)
    , Voxel(1.0 / model.MostVoxelsPerMeter)
  {
  }

  void AddTo(std::vector<FollowedShape>& shapes, const Vector3& place, double reach)
  {
    FollowedShape shape;
    shape.Mode = this->Mode;
    Vector3 start = place;
    if (this->Kind == ModeKind::Surface || !this->Read(place))
    {
      return;
    }
    if (const Primitive* const front = this->FindFront())
    {
      shape.Centre = front->Anchor;
      shape.Normal = front->Direction;
      shapes.push_back(shape);
    }
    this->AddTensor(shapes, place);
    if (!this->HasLine() || !this->FindStart(start))
    {
      return;
    }
    const Primitive* const line = this->Read(start) ? this->FindLine() : nullptr;
    if (!line)
    {
      return;
    }
    const Vector3 direction = line->Direction;
    shape.Line.push_back(start);
    shape.IsClosed = this->Trace(start, direction, reach, shape.Line);
    if (!shape.IsClosed)
    {
      std::vector<Vector3> behind;
      this->Trace(start, -direction, reach, behind);
      shape.Line.insert(shape.Line.begin(), behind.rbegin(), behind.rend());
    }
    if (shape.Line.size() > 1)
    {
      shapes.push_back(std::move(shape));
    }
  }

private:
  void AddTensor(std::vector<FollowedShape>& shapes, const Vector3& place) const
  {
    FollowedShape shape;
    shape.Mode = this->Mode;
    shape.Centre = place;
    shape.IsTensor = this->Kind == ModeKind::TensorFollow &&
      this->Model.Baked->Modes[static_cast<std::size_t>(this->Mode)].Field.ReadTensor(
        this->Model.DeviceToIndex(place), shape.Tensor);
    const double first = shape.IsTensor ? FindEigen(shape.Tensor).Value[0] : 0.0;
    if (first > 0.0)
    {
      shape.Tensor = (1.0 / first) * shape.Tensor;
      shapes.push_back(shape);
    }
  }

  bool HasLine() const
  {
    return this->Kind != ModeKind::VectorFront && this->Kind != ModeKind::TwoSidedFront &&
      this->Kind != ModeKind::GuideSurface;
  }

  /** Reads the primitives of the mode; false if none of them holds. */
  bool Read(const Vector3& place)
  {
    this->Set.Clear();
    this->Modes.Read(this->Mode, place, this->Set);
    return this->Set.SumStrengths() > 0.0;
  }

  /** The front among what was read; null if there is none. */
  const Primitive* FindFront() const
  {
    const bool isFront = !this->HasLine() || this->Kind == ModeKind::TensorFollow;
    return isFront ? this->Find(PrimitiveKind::Plane, 0.0) : nullptr;
  }

  /**
   * The line among what was read. That of a vortex is its core, whether the hand is there or not.
   */
  const Primitive* FindLine() const
  {
    return this->Find(PrimitiveKind::Line, this->Kind == ModeKind::VortexTube ? -1.0 : 0.0);
  }

  /** The first primitive of a kind with more than a strength. */
  const Primitive* Find(PrimitiveKind kind, double strength) const
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

  /** Moves a place to the line that the mode is about; false if there is none. */
  bool FindStart(Vector3& place)
  {
    constexpr int most = 64;
    for (int i = 0; i < most; ++i)
    {
      const Primitive* const line = this->Read(place) ? this->FindLine() : nullptr;
      if (!line)
      {
        return false;
      }
      Vector3 motion = line->Anchor - place;
      motion = motion - Dot(motion, line->Direction) * line->Direction;
      const Primitive* const wall = this->Find(PrimitiveKind::Plane, 0.0);
      // Far from the core of a vortex there is only the way to it.
      if (this->Kind == ModeKind::VortexTube && wall && !(Norm(motion) > 0.0))
      {
        motion = this->Voxel * wall->Direction;
      }
      const double length = Norm(motion);
      if (!(length > OnLine * this->Voxel))
      {
        return std::isfinite(length);
      }
      // A ridge may be some voxels away. A step of a Newton search that is longer is a wrong one.
      const double longest = (this->Kind == ModeKind::VortexTube ? 1.0 : 32.0) * this->Voxel;
      place = place + std::min(1.0, longest / length) * motion;
      if (this->Kind == ModeKind::Guide)
      {
        return true; // the nearest place, to which the next one may not be
      }
    }
    return this->Kind == ModeKind::Ridge;
  }

  /** The direction at a place, turned to another one; false at the end of the line. */
  bool ReadDirection(const Vector3& place, const Vector3& before, Vector3& direction)
  {
    const Primitive* const line = this->Read(place) ? this->FindLine() : nullptr;
    if (!line)
    {
      return false;
    }
    direction = Dot(line->Direction, before) < 0.0 ? -line->Direction : line->Direction;
    return true;
  }

  /** Back to the anchor of the line. */
  bool Return(Vector3& place)
  {
    const Primitive* const line = this->Read(place) ? this->FindLine() : nullptr;
    if (!line)
    {
      return false;
    }
    const Vector3 away = line->Anchor - place;
    const Vector3 across = away - Dot(away, line->Direction) * line->Direction;
    if (this->Kind == ModeKind::Guide)
    {
      const Primitive* const end = this->Find(PrimitiveKind::Plane, 0.0);
      if (end && Dot(place - end->Anchor, end->Direction) < 0.0)
      {
        place = end->Anchor;
        return false;
      }
    }
    if (Norm(across) < this->Voxel)
    {
      place = place + across;
    }
    return true;
  }

  /** Adds places along the line; true if it came back to where it began. */
  bool Trace(const Vector3& start, Vector3 direction, double reach, std::vector<Vector3>& line)
  {
    const double step = StepVoxels * this->Voxel;
    const int most = static_cast<int>(std::min(reach / StepVoxels, double{ MostLineSteps }));
    Vector3 place = start;
    for (int i = 0; i < most; ++i)
    {
      Vector3 k[4] = { direction, {}, {}, {} };
      const bool isThere = this->ReadDirection(place + 0.5 * step * k[0], k[0], k[1]) &&
        this->ReadDirection(place + 0.5 * step * k[1], k[1], k[2]) &&
        this->ReadDirection(place + step * k[2], k[2], k[3]);
      if (!isThere)
      {
        return false;
      }
      place = place + (step / 6.0) * (k[0] + 2.0 * k[1] + 2.0 * k[2] + k[3]);
      const bool goesOn = this->Return(place);
      const double toStart = Norm(place - start);
      if (i > 3 && toStart < 0.6 * step)
      {
        line.push_back(start);
        return true;
      }
      line.push_back(place);
      if (!goesOn || !this->ReadDirection(place, k[3], direction))
      {
        return false;
      }
    }
    return false;
  }

  const HapticModel& Model;
  const ModeField& Modes;
  const int Mode;
  const ModeKind Kind;
  const double Voxel; ///< m
  PrimitiveSet Set;
};

} // namespace

std::vector<FollowedShape> FindFollowedShapes(
  const HapticModel& model, const Vector3& place, double reach)
{
  std::vector<FollowedShape> shapes;
  if (model.Baked->Settings.Method != HapticMethod::Primitives || !IsFinite(place))
  {
    return shapes;
  }
  LabelMemory memory;
  const ModeField modes(model, model.Baked->Settings.CouplingStiffness, place, memory);
  for (int mode = 0; mode < modes.GetCount(); ++mode)
  {
    ShapeFinder(model, modes, mode).AddTo(shapes, place, reach);
  }
  return shapes;
}

} // namespace VolumeHaptics
