// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A volume with its material and settings, baked for the servo tick.
 */
#ifndef BakedVolume_h
#define BakedVolume_h

#include "Core/Field/FieldAtTime.h"
#include "Core/Field/FieldStep.h"
#include "Core/Math/PiecewiseTable.h"
#include "Core/Model/BakedLabels.h"
#include "Core/Model/BakedMode.h"
#include "Core/Model/BakedTool.h"
#include "Core/Model/CutAway.h"
#include "Core/Model/HapticModelDescription.h"
#include "Core/Model/LabelWalls.h"
#include "Core/Model/TimeStepSeries.h"

#include <memory>
#include <optional>
#include <vector>

namespace VolumeHaptics
{

/** One time step of a volume that moves. */
struct FieldTimeStep
{
  double Time;     ///< data time, in the units of the data
  double Interval; ///< data time from this time step to the next one; 0 if there is no next one
  bool BlendsNext; ///< whether FieldSampler::BlendsSamples() holds for this and the next time step
  FieldSampler Field;
  std::shared_ptr<const void> Samples; ///< keeps the memory of Field alive
  /** Motion of the material to the next time step. Empty if it is not known. */
  std::optional<DisplacementField> Motion;
  std::shared_ptr<const void> DisplacementSamples; ///< keeps the memory of Motion alive
  /**
   * Isosurface, which moves to the next time step. Null if there is no mesh or no next time step.
   */
  std::shared_ptr<const SurfaceMesh> Mesh;
};

/**
 * A part of the motion of a time step's mesh. The mesh moves to the next time step from fraction 0
 * to 1; this part lasts from one fraction to another.
 */
struct MeshWay
{
  const SurfaceMesh* Mesh; ///< null if there is no mesh
  double From;
  double To;
  /**
   * Whether the mesh's points move with the material. If not, they only follow the level.
   */
  bool IsMaterial;
};

/** The part of a model that does not depend on the device's placement. Immutable. */
struct BakedVolume
{
  explicit BakedVolume(const HapticModelDescription& description);
  /** Copies a volume, with other time steps of its series. Bakes nothing again. */
  BakedVolume(const BakedVolume& other, const std::vector<VolumeTimeStep>& timeSteps,
    const TimeStepSeries& series);
  /** Copies a volume, which must not move, with another removal. Bakes nothing again. */
  BakedVolume(const BakedVolume& other, std::shared_ptr<TissueRemoval> removal, double airValue);
  struct ForAPoint
  {
  };
  /**
   * Copies a volume, which must not move, for a hand that feels with a point while another hand
   * holds the tool. Bakes nothing again.
   */
  BakedVolume(const BakedVolume& other, ForAPoint);
  BakedVolume(const BakedVolume&) = delete;
  BakedVolume& operator=(const BakedVolume&) = delete;

  /** Makes the gradient kernel for a model with this description. */
  static GradientKernel MakeKernel(const HapticModelDescription& description);

  const GradientKernel Kernel;
  /**
   * The tissue that the tool removes, or null if the tool removes none. A tick changes the object,
   * but not the pointer.
   */
  const std::shared_ptr<TissueRemoval> Removal;
  /**
   * The tissue that another hand's tool removes, or null if there is none. If it is not null,
   * Removal is null.
   */
  const std::shared_ptr<const TissueRemoval> Others;
  /** Samples of the volume, or of the first time step if the volume moves. */
  const FieldSampler Field;
  const TimeStepSeries Series; ///< the series that contains TimeSteps
  /**
   * The time steps in the order of their times. If they cross the end of a loop, those after the
   * end come last. Empty if the volume does not move.
   */
  const std::vector<FieldTimeStep> TimeSteps;
  const bool HasMotion;                 ///< whether the material's motion is known in any time step
  const MaterialTable Materials;        ///< channels k, mu, T_N, R, visibility
  const DistinctnessTable Distinctness; ///< channels W_d, visibility
  const bool IsDistinctFromNoise;       ///< see HapticMaterial
  const bool IsSeenByNearest;           ///< see HapticMaterial
  const Affine3 IndexToWorld;
  const double LargestSpacing; ///< in world units
  const HapticSettings Settings;
  const double ResidentShare;                      ///< see HapticModelDescription
  const std::shared_ptr<const void> Samples;       ///< keeps the memory of Field alive
  const std::shared_ptr<const SurfaceMesh> Mesh;   ///< null without a mesh
  const std::shared_ptr<const BakedLabels> Labels; ///< null without a label image
  /** The walls between labels, or null if all surfaces come from the scalars. */
  const std::shared_ptr<const LabelWalls> Walls;
  const std::shared_ptr<const CutAway> Cut; ///< null if all of the volume is felt
  /** Whether labels or a cut also make surfaces, not only the scalars. */
  const bool HasOtherSurfaces;
  const std::vector<BakedMode> Modes; ///< modes of HapticMethod::Primitives
  /** Tool in the hand, or null if the hand feels with a point. */
  const std::shared_ptr<const BakedTool> Tool;
  const bool IsForAPoint; ///< whether this is a copy without its tool (see ForAPoint)

  /**
   * Returns the fraction of the force that is felt at an index (CutPlace::Fraction), or 1 without a
   * cut.
   */
  double KeptFraction(const Vector3& index) const noexcept
  {
    return this->Cut ? this->Cut->Compute(index).Fraction() : 1.0;
  }
  bool IsMoving() const noexcept { return !this->TimeSteps.empty(); }
  /** Returns whether the volume's scalars alone determine surfaces and materials. */
  bool IsPlain() const noexcept { return !this->HasOtherSurfaces && !this->Labels; }
  /**
   * Returns the field at a data time. The field is constant before the first time step and after
   * the last one. `memory` stores the last gradients.
   */
  FieldAtTime At(double time, TickMemory* memory = nullptr) const noexcept
  {
    return this->IsMoving() ? this->BlendTimeSteps(time, memory) : FieldAtTime(this->Field, memory);
  }
  /**
   * Returns the field at two data times, if both are between the same two time steps and not at
   * one. Returns none if they are not, if the material's motion is known, or if the samples of the
   * two time steps are not blended.
   */
  std::optional<FieldStep> ComputeStep(
    double before, double now, TickMemory& memory) const noexcept;
  TimeSpan GetTimeSpan() const noexcept
  {
    return { this->Series, this->TimeSteps.front().Time, this->TimeSteps.back().Time,
      this->TimeSteps.size() == 1 };
  }
  /**
   * Returns the index of the last time step that is not after a data time. At() blends it with the
   * next one.
   */
  std::size_t FindTimeStep(double time) const noexcept;
  /** Returns the index of the time step nearest to a data time. */
  std::size_t FindNearestTimeStep(double time) const noexcept;
  /**
   * Returns the index to which the material at an index moves between two data times, limited to
   * the volume. Returns the same index if the motion is not known. Crosses at most four time steps.
   */
  Vector3 TrackMaterial(const Vector3& index, double from, double to) const noexcept;

  ///@{
  /**
   * Writes the motions of the meshes between two data times to `ways`, and returns their number.
   * Two data times in one time step, or in two consecutive ones, give the motions within these time
   * steps. If more time steps or the end of a series are between them, the result is only the last
   * mesh, at rest.
   */
  static constexpr int MostMeshWays = 2;
  int CollectMeshWays(double from, double to, MeshWay ways[MostMeshWays]) const noexcept;
  ///@}

  const ForbiddenZone* GetZone() const noexcept
  {
    return this->Labels ? this->Labels->Zone.get() : nullptr;
  }
  /** Returns whether labels make surfaces, that is, walls or a zone around forbidden labels. */
  bool FeelsLabels() const noexcept { return this->Walls || this->GetZone(); }
  /**
   * Number that identifies volume, material and settings. Only models of regions of one volume, or
   * of time steps of one series, share a number.
   */
  const std::uint64_t Number;

private:
  /**
   * Copies a volume, with another removal and other time steps. `shown` is the first time step, or
   * the whole volume if it does not move.
   */
  BakedVolume(const BakedVolume& other, std::shared_ptr<TissueRemoval> removal, double airValue,
    const VolumeTimeStep& shown, const std::vector<VolumeTimeStep>& timeSteps,
    const TimeStepSeries& series, bool isForAPoint = false);

  FieldAtTime BlendTimeSteps(double time, TickMemory* memory) const noexcept;
  /**
   * Returns how much of the way from a time step to the next one is past at a data time, from 0 to
   * 1.
   */
  double ComputeFraction(std::size_t timeStep, double time) const noexcept;
};

} // namespace VolumeHaptics

#endif
