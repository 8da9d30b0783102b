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
  double Interval; ///< data time to the next time step; 0: no next time step
  bool BlendsNext; ///< whether FieldSampler::BlendsSamples() holds for the next time step
  FieldSampler Field;
  std::shared_ptr<const void> Samples; ///< keeps the memory of Field alive
  /** The motion of the material until the next time step, if it is known. */
  std::optional<DisplacementField> Motion;
  std::shared_ptr<const void> DisplacementSamples; ///< keeps the memory of Motion alive
  /**
   * The isosurface, which moves to the next time step; null if there is no mesh, or no next time
   * step.
   */
  std::shared_ptr<const SurfaceMesh> Mesh;
};

/** The mesh of a time step, and the fractions (0 to 1) of the time step between which it moves. */
struct MeshWay
{
  const SurfaceMesh* Mesh; ///< null if there is no mesh
  double From;
  double To;
  /** Whether the mesh's points move with the material, not only with their level. */
  bool IsMaterial;
};

/** The part of a model that does not depend on the device's placement. Immutable. */
struct BakedVolume
{
  explicit BakedVolume(const HapticModelDescription& description);
  /** Makes the same volume with other time steps of the series, without baking again. */
  BakedVolume(const BakedVolume& other, const std::vector<VolumeTimeStep>& timeSteps,
    const TimeStepSeries& series);
  /** Makes the same volume, which does not move, with another removal, without baking again. */
  BakedVolume(const BakedVolume& other, std::shared_ptr<TissueRemoval> removal, double airValue);
  BakedVolume(const BakedVolume&) = delete;
  BakedVolume& operator=(const BakedVolume&) = delete;

  /** Makes the kernel of a model with this description. */
  static GradientKernel MakeKernel(const HapticModelDescription& description);

  const GradientKernel Kernel;
  /**
   * Null if no tool removes tissue. A tick may change the object that it points to, but not the
   * pointer.
   */
  const std::shared_ptr<TissueRemoval> Removal;
  const FieldSampler Field;    ///< the first time step, if there are several
  const TimeStepSeries Series; ///< the series of which Time steps are a part
  /**
   * The time steps in ascending time; those after the end of a loop come last. Empty if the volume
   * does not move.
   */
  const std::vector<FieldTimeStep> TimeSteps;
  const bool HasMotion;                 ///< whether a motion of the material is known
  const MaterialTable Materials;        ///< channels k, mu, T_N, R, visibility
  const DistinctnessTable Distinctness; ///< channels W_d, visibility
  const bool IsDistinctFromNoise;       ///< see HapticMaterial
  const Affine3 IndexToWorld;
  const double LargestSpacing; ///< world units
  const HapticSettings Settings;
  const double ResidentShare;                      ///< see HapticModelDescription
  const std::shared_ptr<const void> Samples;       ///< keeps the memory of Field alive
  const std::shared_ptr<const SurfaceMesh> Mesh;   ///< null without a mesh
  const std::shared_ptr<const BakedLabels> Labels; ///< null without a label image
  /** The walls between labels; null if all surfaces come from the scalars. */
  const std::shared_ptr<const LabelWalls> Walls;
  const std::shared_ptr<const CutAway> Cut; ///< null if all of the volume is felt
  /** Whether surfaces depend on more than the scalars: labels or a cut. */
  const bool HasOtherSurfaces;
  const std::vector<BakedMode> Modes;          ///< for HapticMethod::Primitives
  const std::shared_ptr<const BakedTool> Tool; ///< null if the hand feels with a point

  /**
   * Returns the fraction of the force that is felt at an index of a cut volume: see
   * CutPlace::Fraction.
   */
  double KeptFraction(const Vector3& index) const noexcept
  {
    return this->Cut ? this->Cut->Compute(index).Fraction() : 1.0;
  }
  bool IsMoving() const noexcept { return !this->TimeSteps.empty(); }
  /** Returns whether surfaces and materials come from the volume's scalars alone. */
  bool IsPlain() const noexcept { return !this->HasOtherSurfaces && !this->Labels; }
  /**
   * Returns the volume at a data time. Before the first time step and after the last one, the
   * volume stands still. `memory` holds the last gradients.
   */
  FieldAtTime At(double time, TickMemory* memory = nullptr) const noexcept
  {
    return this->IsMoving() ? this->BlendTimeSteps(time, memory) : FieldAtTime(this->Field, memory);
  }
  /**
   * Returns the step between two data times that lie between the same two time steps; none if the
   * material's motion is known, if a time step is at either time, or if samples are not blended.
   */
  std::optional<FieldStep> ComputeStep(
    double before, double now, TickMemory& memory) const noexcept;
  TimeSpan GetTimeSpan() const noexcept
  {
    return { this->Series, this->TimeSteps.front().Time, this->TimeSteps.back().Time,
      this->TimeSteps.size() == 1 };
  }
  /**
   * Returns the number of the time step at or before a data time, which At blends with the next
   * one.
   */
  std::size_t FindTimeStep(double time) const noexcept;
  /** Returns the number of the time step that is nearest to a data time. */
  std::size_t FindNearestTimeStep(double time) const noexcept;
  /**
   * Follows the material at an index to another data time, and returns its index there, within the
   * volume; the same index if the motion is not known. Crosses at most four time steps.
   */
  Vector3 TrackMaterial(const Vector3& index, double from, double to) const noexcept;

  ///@{
  /**
   * Collects the meshes on the way from one data time to another, and returns their number: the
   * mesh of the time step in which the way begins, and the mesh of the time step in which the way
   * ends. If the way crosses more time steps, or the end of a series, collects only the last mesh.
   */
  static constexpr int MostMeshWays = 2;
  int CollectMeshWays(double from, double to, MeshWay ways[MostMeshWays]) const noexcept;
  ///@}

  const ForbiddenZone* GetZone() const noexcept
  {
    return this->Labels ? this->Labels->Zone.get() : nullptr;
  }
  /** Returns whether the label image makes surfaces. */
  bool FeelsLabels() const noexcept { return this->Walls || this->GetZone(); }
  /**
   * Identifies volume, material and settings. Only regions of one volume, and parts of one series
   * of time steps, may share a number.
   */
  const std::uint64_t Number;

private:
  /**
   * Copies a volume with another removal and other time steps; `shown` is the first time step, or
   * the volume if it does not move.
   */
  BakedVolume(const BakedVolume& other, std::shared_ptr<TissueRemoval> removal, double airValue,
    const VolumeTimeStep& shown, const std::vector<VolumeTimeStep>& timeSteps,
    const TimeStepSeries& series);

  FieldAtTime BlendTimeSteps(double time, TickMemory* memory) const noexcept;
  /** Returns the fraction of the way from this time step to the next one, at a data time. */
  double ComputeFraction(std::size_t timeStep, double time) const noexcept;
};

} // namespace VolumeHaptics

#endif
