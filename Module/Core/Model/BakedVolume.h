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
#include "Core/Model/FrameSeries.h"
#include "Core/Model/HapticModelDescription.h"
#include "Core/Model/LabelWalls.h"

#include <memory>
#include <optional>
#include <vector>

namespace VolumeHaptics
{

/** A volume that moves, at an instant. */
struct FieldFrame
{
  double Time;     ///< data time, in the units of the data
  double Interval; ///< data time to the next frame; 0: there is none
  bool BlendsNext; ///< FieldSampler::BlendsSamples() of the next frame
  FieldSampler Field;
  std::shared_ptr<const void> Samples; ///< keeps the memory of Field alive
  /** Where its material goes until the next frame, if that is known. */
  std::optional<DisplacementField> Motion;
  std::shared_ptr<const void> DisplacementSamples; ///< keeps the memory of Motion alive
  /** The isosurface on its way to the next frame; null if there is no mesh, or no next frame. */
  std::shared_ptr<const SurfaceMesh> Mesh;
};

/** A mesh that moves, from one share of its way to another one. */
struct MeshWay
{
  const SurfaceMesh* Mesh; ///< null: there is none
  double From;
  double To;
  /** Whether its points go along with the material, and not only with their level. */
  bool IsMaterial;
};

/** The part of a model that does not depend on the device's placement. Immutable. */
struct BakedVolume
{
  explicit BakedVolume(const HapticModelDescription& description);
  /** Another window of a series of a volume that moves. Bakes nothing again. */
  BakedVolume(
    const BakedVolume& other, const std::vector<VolumeFrame>& frames, const FrameSeries& series);
  /** The same volume, which does not move, with another removal. Bakes nothing again. */
  BakedVolume(const BakedVolume& other, std::shared_ptr<TissueRemoval> removal, double airValue);
  BakedVolume(const BakedVolume&) = delete;
  BakedVolume& operator=(const BakedVolume&) = delete;

  /** The kernel that a model of this description gets. */
  static GradientKernel MakeKernel(const HapticModelDescription& description);

  const GradientKernel Kernel;
  /**
   * Null if no tool removes anything. What it has, and not the pointer, is what a tick may change.
   */
  const std::shared_ptr<TissueRemoval> Removal;
  const FieldSampler Field; ///< the first frame, if there are several
  const FrameSeries Series; ///< of which Frames are a window
  /**
   * By ascending time, but those that follow the last one of the series; empty if the volume does
   * not move.
   */
  const std::vector<FieldFrame> Frames;
  const bool HasMotion;                 ///< of the material, between any frames
  const MaterialTable Materials;        ///< channels k, mu, T_N, R, visibility
  const DistinctnessTable Distinctness; ///< channels W_d, visibility
  const Affine3 IndexToWorld;
  const double LargestSpacing; ///< world units
  const HapticSettings Settings;
  const double ResidentShare;                      ///< see HapticModelDescription
  const std::shared_ptr<const void> Samples;       ///< keeps the memory of Field alive
  const std::shared_ptr<const SurfaceMesh> Mesh;   ///< null without one
  const std::shared_ptr<const BakedLabels> Labels; ///< null without a label image
  /** Null if all surfaces are those of the scalars. */
  const std::shared_ptr<const LabelWalls> Walls;
  const std::shared_ptr<const CutAway> Cut; ///< null if all of the volume is felt
  /** Whether surfaces depend on more than the scalars: labels or a cut. */
  const bool HasOtherSurfaces;
  const std::vector<BakedMode> Modes;          ///< of HapticMethod::Primitives
  const std::shared_ptr<const BakedTool> Tool; ///< null if the hand feels with a point

  /** The share of what is felt at an index that a cut leaves. */
  double KeptShare(const Vector3& index) const noexcept
  {
    return this->Cut ? this->Cut->Find(index).Share() : 1.0;
  }
  bool HasTool(ToolKind kind) const noexcept { return this->Tool && this->Tool->Kind == kind; }
  /** Whether the tool has points that touch. */
  bool HasShape() const noexcept
  {
    return this->HasTool(ToolKind::Shell) || this->HasTool(ToolKind::Burr);
  }
  bool IsMoving() const noexcept { return !this->Frames.empty(); }
  /** Whether surfaces and materials are those of its scalars alone. */
  bool IsPlain() const noexcept { return !this->HasOtherSurfaces && !this->Labels; }
  /**
   * The volume at a data time; before the first frame and after the last one, it stands still. The
   * memory is that of the last gradients.
   */
  FieldAtTime At(double time, TickMemory* memory = nullptr) const noexcept
  {
    return this->IsMoving() ? this->BlendFrames(time, memory) : FieldAtTime(this->Field, memory);
  }
  /**
   * Two data times between the same two frames, whose material is not followed; none if either of
   * them is that of a frame, or if samples are not blended.
   */
  std::optional<FieldStep> FindStep(double before, double now, TickMemory& memory) const noexcept;
  FrameWindow GetWindow() const noexcept
  {
    return { this->Series, this->Frames.front().Time, this->Frames.back().Time,
      this->Frames.size() == 1 };
  }
  /** The number of the frame that a data time follows, and to which At blends the next one. */
  std::size_t FindFrame(double time) const noexcept;
  /** The number of the frame that is nearest to a data time. */
  std::size_t FindNearestFrame(double time) const noexcept;
  /**
   * Where the material at an index at a data time is at another one, within the volume; the same
   * index where that is not known. It is followed through four frames at most.
   */
  Vector3 FollowMaterial(const Vector3& index, double from, double to) const noexcept;

  ///@{
  /**
   * The meshes of the way from one data time to another one: of the frame in which it begins, and
   * of that in which it ends. Over more frames, or over the end of a series, only the end.
   */
  static constexpr int MostMeshWays = 2;
  int FindMeshWays(double from, double to, MeshWay ways[MostMeshWays]) const noexcept;
  ///@}

  const ForbiddenZone* GetZone() const noexcept
  {
    return this->Labels ? this->Labels->Zone.get() : nullptr;
  }
  /** Whether there are surfaces that the label image makes. */
  bool FeelsLabels() const noexcept { return this->Walls || this->GetZone(); }
  /**
   * Of the volume, the material and the settings; only regions of one volume, and parts of one
   * series of frames, may share one.
   */
  const std::uint64_t Number;

private:
  /**
   * With another removal and other frames; `shown` is the first one, or the volume if it does not
   * move.
   */
  BakedVolume(const BakedVolume& other, std::shared_ptr<TissueRemoval> removal, double airValue,
    const VolumeFrame& shown, const std::vector<VolumeFrame>& frames, const FrameSeries& series);

  FieldAtTime BlendFrames(double time, TickMemory* memory) const noexcept;
  /** Of the frame after this one, at a data time. */
  double FindShare(std::size_t frame, double time) const noexcept;
};

} // namespace VolumeHaptics

#endif
