// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A mode is a way to feel the vectors or tensors of a volume, its scalars, or a guide.
 *
 * v is the vector, J its Jacobian, omega its curl, and l_1 >= l_2 >= l_3 are the eigenvalues of a
 * tensor, where negative ones count as 0:
 *
 * | kind          | feel                                        | first strength | second     |
 * | ------------- | ------------------------------------------- | -------------- | ---------- |
 * | VectorFollow  | free along v, held across it; pushed        | hold, of |v|   | push, same |
 * | VectorFront   | a wall across v, free to where v points     | wall, of |v|   |            |
 * | TwoSidedFront | held along v, free across it                | hold, of |v|   |            |
 * | VortexTube    | held in around a vortex; and along its axis | tube, of omega | axis, same |
 * | Shear         | free in the direction that stretches most   | hold, of rate  |            |
 * | TensorFollow  | free along fibres; or within sheets         | fibre, of c_l  | sheet, c_p |
 * | Ridge         | drawn to the middle of a vessel, free along | hold, of d     |            |
 * | Guide         | drawn to a line, free along it              | hold, of dist. |            |
 * | GuideSurface  | held on a surface, or on one side of it     | hold, of dist. |            |
 * | Surface       | the surfaces of the scalars                 |                |            |
 *
 * c_l = (l_1 - l_2)/l_1 and c_p = (l_2 - l_3)/l_1. Strengths are in newtons. d is the second
 * smallest magnitude of the eigenvalues of the scalars' Hessian minus the smallest one, where the
 * scalars fall to all sides; dist. is the distance from the line or surface, in world units.
 */
#ifndef BakedMode_h
#define BakedMode_h

#include "Core/Field/VectorField.h"
#include "Core/Math/PiecewiseTable.h"
#include "Core/Model/GuidePath.h"
#include "Core/Model/GuideSurface.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace VolumeHaptics
{

enum class ModeKind : std::uint8_t
{
  VectorFollow,
  VectorFront,
  TwoSidedFront,
  VortexTube,
  Shear,
  TensorFollow,
  Ridge,
  Guide,
  GuideSurface,
  Surface
};

/** The data that a kind of mode reads. */
enum class ModeInput : std::uint8_t
{
  Vectors,
  Tensors,
  Scalars, ///< the scalars of the model's volume
  Line,    ///< ModeDescription::Guide
  Surface  ///< ModeDescription::GuideSurface
};

/** Properties of a kind of mode. ModePrimitives.cxx computes its primitives. */
struct ModeFacts
{
  ModeInput Input;
  int Primitives; ///< number of primitives that an active mode adds to a tick
  bool HasLine;   ///< whether the hand can move freely along a line
  bool HasFront;  ///< whether the hand can move freely on a surface
};

constexpr ModeFacts FactsOf(ModeKind kind) noexcept
{
  constexpr ModeFacts facts[] = {
    { ModeInput::Vectors, 2, true, false },  // VectorFollow
    { ModeInput::Vectors, 1, false, true },  // VectorFront
    { ModeInput::Vectors, 2, false, true },  // TwoSidedFront
    { ModeInput::Vectors, 3, true, false },  // VortexTube
    { ModeInput::Vectors, 1, true, false },  // Shear
    { ModeInput::Tensors, 3, true, true },   // TensorFollow
    { ModeInput::Scalars, 1, true, false },  // Ridge
    { ModeInput::Line, 2, true, false },     // Guide
    { ModeInput::Surface, 2, false, true },  // GuideSurface
    { ModeInput::Scalars, 3, false, false }, // Surface
  };
  return facts[static_cast<std::size_t>(kind)];
}

/** The side of a GuideSurface on which it holds the hand. */
enum class GuideSide : std::uint8_t
{
  Surface, ///< on the surface
  Outside, ///< on the side to which the normals point, or on the surface itself
  Inside
};

/** Everything that a mode is baked from. */
struct ModeDescription
{
  ModeKind Kind = ModeKind::VectorFollow;
  VectorView View;
  std::shared_ptr<const void> Samples; ///< keeps View.Volume.Data alive
  VectorAxes Axes = VectorAxes::World;
  Polyline First = ConstantPolyline(2.0);  ///< first strength (N); see the table above
  Polyline Second = ConstantPolyline(0.0); ///< second strength (N)
  bool IsActive = true; ///< whether the mode adds primitives; an inactive mode keeps its number
  bool IsDark = false;  ///< for Ridge: whether vessels are darker than their surroundings
  /** For Ridge: largest distance (voxels) at which the mode holds with its full strength. */
  double SnapDistance = 3.0;
  std::shared_ptr<const GuidePath> Guide; ///< for Guide: the line; not null
  ///@{
  /** For GuideSurface: the surface; not null. */
  std::shared_ptr<const VolumeHaptics::GuideSurface> GuideSurface;
  GuideSide Side = GuideSide::Surface;
  ///@}
};

/** A mode as a tick reads it. Immutable. */
struct BakedMode
{
  BakedMode(const ModeDescription& description, const Affine3& indexToWorld)
    : Kind(description.Kind)
    , Field(description.View, indexToWorld, description.Axes)
    , Strengths({ description.First, description.Second })
    , Samples(description.Samples)
    , IsActive(description.IsActive)
    , IsDark(description.IsDark)
    , SnapDistance(description.SnapDistance)
    , Guide(description.Guide)
    , GuideSurface(description.GuideSurface)
    , Side(description.Side)
  {
  }

  /** Returns whether the data that this kind of mode reads are there. */
  bool IsValid() const noexcept
  {
    switch (FactsOf(this->Kind).Input)
    {
      case ModeInput::Vectors:
        return this->Field.HasVectors();
      case ModeInput::Tensors:
        return this->Field.HasTensors();
      case ModeInput::Scalars:
        break;
      case ModeInput::Line:
        return this->Guide != nullptr;
      case ModeInput::Surface:
        return this->GuideSurface != nullptr;
    }
    return true;
  }

  const ModeKind Kind;
  const VectorField Field;
  const PiecewiseTable<2> Strengths;
  const std::shared_ptr<const void> Samples; ///< keeps the memory of Field alive
  const bool IsActive;
  const bool IsDark;
  const double SnapDistance; ///< see ModeDescription (voxels)
  const std::shared_ptr<const GuidePath> Guide;
  const std::shared_ptr<const VolumeHaptics::GuideSurface> GuideSurface;
  const GuideSide Side;
};

} // namespace VolumeHaptics

#endif
