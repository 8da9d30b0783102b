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
  double Interval; ///< data time from this time step to the next; 0 if no time step is next
  bool BlendsNext; ///< whether FieldSampler::BlendsSamples() holds for this and the next time step
  FieldSampler Field;
  std::shared_ptr<const void> Samples; ///< keeps the memory of Field alive
  /** Motion of the material to the next time step, if it is known. */
  std::optional<DisplacementField> Motion;
  std::shared_ptr<const void> DisplacementSamples; ///< keeps the memory of Motion alive
  /** Isosurface that moves to the next time step. Null if there is no mesh or no next time step. */
  std::shared_ptr<const SurfaceMesh> Mesh;
};

/**
 * The way of a time step's mesh: the mesh moves between two fractions (0 to 1) of the way to the
 * next time step.
 */
struct MeshWay
{
  const SurfaceMesh* Mesh; ///< null if there is no mesh
  double From;
  double To;
  /**
   * Whether the points of the mesh move with the material. If not, they move only with the level.
   */
  bool IsMaterial;
};

/** The part of a model that does not depend on the device's placement. Immutable. */
struct BakedVolume
{
  explicit BakedVolume(const HapticModelDescription& description);
  /** Makes the same volume with other time steps of its series. Nothing is baked again. */
  BakedVolume(const BakedVolume& other, const std::vector<VolumeTimeStep>& timeSteps,
    const TimeStepSeries& series);
  /** Makes the same volume, which must not move, with another removal. Nothing is baked again. */
  BakedVolume(const BakedVolume& other, std::shared_ptr<TissueRemoval> removal, double airValue);
  struct ForAPoint
  {
  };
  /**
   * Makes the same volume, which must not move, for a hand that feels with a point while another
   * hand holds the tool. Nothing is baked again.
   */
  BakedVolume(const BakedVolume& other, ForAPoint);
  BakedVolume(const BakedVolume&) = delete;
  BakedVolume& operator=(const BakedVolume&) = delete;

  /** Makes the kernel of a model with this description. */
  static GradientKernel MakeKernel(const HapticModelDescription& description);

  const GradientKernel Kernel;
  /**
   * The tissue that a tool removes; null if no tool removes tissue. A tick changes the object, but
   * not the pointer.
   */
  const std::shared_ptr<TissueRemoval> Removal;
  /** The tissue that another hand's tool removes; null if there is none. Removal is then null. */
  const std::shared_ptr<const TissueRemoval> Others;
  /** Samples of the volume, or of the first time step if the volume moves. */
  const FieldSampler Field;
  const TimeStepSeries Series; ///< the series that contains TimeSteps
  /**
   * The time steps in the order of their times. If they cross the end of a loop, the time steps
   * after that end come last. Empty if the volume does not move.
   */
  const std::vector<FieldTimeStep> TimeSteps;
  const bool HasMotion;          ///< whether the material's motion is known for any time step
  const MaterialTable Materials; ///< channels k, mu, T_N, R, visibility
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
  /** The walls between labels; null if all surfaces come from the scalars. */
  const std::shared_ptr<const LabelWalls> Walls;
  const std::shared_ptr<const CutAway> Cut; ///< null if all of the volume is felt
  /** Whether surfaces depend on labels or on a cut, and not only on the scalars. */
  const bool HasOtherSurfaces;
  const std::vector<BakedMode> Modes; ///< modes of HapticMethod::Primitives
  /** Tool in the hand; null if the hand feels with a point. */
  const std::shared_ptr<const BakedTool> Tool;
  const bool IsForAPoint; ///< whether the tool was left out: see ForAPoint

  /**
   * Returns the fraction of the force that is felt at an index (CutPlace::Fraction); 1 without a
   * cut.
   */
  double KeptFraction(const Vector3& index) const noexcept
  {
    return this->Cut ? this->Cut->Compute(index).Fraction() : 1.0;
  }
  bool IsMoving() const noexcept { return !this->TimeSteps.empty(); }
  /** Returns whether surfaces and materials come from the volume's scalars alone. */
  bool IsPlain() const noexcept { return !this->HasOtherSurfaces && !this->Labels; }
  /**
   * Returns the field at a data time. Before the first time step and after the last one, the field
   * does not change. `memory` stores the last gradients.
   */
  FieldAtTime At(double time, TickMemory* memory = nullptr) const noexcept
  {
    return this->IsMoving() ? this->BlendTimeSteps(time, memory) : FieldAtTime(this->Field, memory);
  }
  /**
   * Returns the field at two data times that lie between the same two time steps, and not at them.
   * Returns none if they do not, if the material's motion is known, or if the samples of the two
   * time steps are not blended.
   */
  std::optional<FieldStep> ComputeStep(
    double before, double now, TickMemory& memory) const noexcept;
  TimeSpan GetTimeSpan() const noexcept
  {
    return { this->Series, this->TimeSteps.front().Time, this->TimeSteps.back().Time,
      this->TimeSteps.size() == 1 };
  }
  /**
   * Returns the index of the last time step that is not later than a data time. At() blends it with
   * the next time step.
   */
  std::size_t FindTimeStep(double time) const noexcept;
  /** Returns the index of the time step nearest to a data time. */
  std::size_t FindNearestTimeStep(double time) const noexcept;
  /**
   * Returns the index to which the material at an index moves between two data times. The result
   * lies in the volume. Returns the same index if the motion is not known. Crosses at most four
   * time steps.
   */
  Vector3 TrackMaterial(const Vector3& index, double from, double to) const noexcept;

  ///@{
  /**
   * Writes the ways of the meshes between two data times to `ways`, and returns their number. If
   * both times are in one time step, or in two consecutive ones, these are the ways within them. If
   * there are more time steps between them, or the end of a series, it is only the last mesh, which
   * then does not move.
   */
  static constexpr int MostMeshWays = 2;
  int CollectMeshWays(double from, double to, MeshWay ways[MostMeshWays]) const noexcept;
  ///@}

  const ForbiddenZone* GetZone() const noexcept
  {
    return this->Labels ? this->Labels->Zone.get() : nullptr;
  }
  /** Returns whether labels make surfaces: walls, or a zone around forbidden labels. */
  bool FeelsLabels() const noexcept { return this->Walls || this->GetZone(); }
  /**
   * Number that identifies volume, material and settings. Only models of regions of one volume, or
   * of time steps of one series, share a number.
   */
  const std::uint64_t Number;

private:
  /**
   * Copies a volume, with another removal and other time steps. `shown` is the first time step, or
   * the volume if it does not move.
   */
  BakedVolume(const BakedVolume& other, std::shared_ptr<TissueRemoval> removal, double airValue,
    const VolumeTimeStep& shown, const std::vector<VolumeTimeStep>& timeSteps,
    const TimeStepSeries& series, bool isForAPoint = false);

  FieldAtTime BlendTimeSteps(double time, TickMemory* memory) const noexcept;
  /** Returns the fraction (0 to 1) of the way from a time step to the next one at a data time. */
  double ComputeFraction(std::size_t timeStep, double time) const noexcept;
};

} // namespace VolumeHaptics

#endif
