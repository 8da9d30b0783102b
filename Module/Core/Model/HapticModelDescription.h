// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The input of a model: volume, material and settings.
 */
#ifndef HapticModelDescription_h
#define HapticModelDescription_h

#include "Core/Carving/TissueRemoval.h"
#include "Core/Field/DisplacementField.h"
#include "Core/Field/GradientKernel.h"
#include "Core/Field/VolumeView.h"
#include "Core/Math/PiecewiseTable.h"
#include "Core/Math/Vector3.h"
#include "Core/Model/BakedMode.h"
#include "Core/Model/BakedTool.h"
#include "Core/Model/HapticSettings.h"
#include "Core/Model/TimeStepSeries.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace VolumeHaptics
{
class SurfaceMesh;
struct BakedLabels;
class CutAway;

/** Material functions of the scalar, and functions of the gradient magnitude per world unit. */
struct HapticMaterial
{
  Polyline Stiffness = ConstantPolyline(500.0);        ///< k, N/m
  Polyline Friction = ConstantPolyline(0.0);           ///< mu
  Polyline SurfaceStrength = ConstantPolyline(2.0);    ///< T_N, N
  Polyline Viscosity = ConstantPolyline(0.0);          ///< R, N
  Polyline Distinctness = ConstantPolyline(1.0);       ///< W_d, 0 to 1, of the gradient magnitude
  Polyline ScalarVisibility = ConstantPolyline(1.0);   ///< 0 or 1, scales T_N and R
  Polyline GradientVisibility = ConstantPolyline(1.0); ///< 0 or 1, scales T_N and R
  /**
   * Whether Distinctness is the ramp of MakeNoiseRamp. The larger the spacing along an axis, the
   * less noise its gradient has; so W_d is taken at the rise over a voxel along the normal, divided
   * by the smallest spacing (not with the solver PAPER).
   */
  bool IsDistinctFromNoise = false;
};

/** The samples of a volume that moves, at one instant. */
struct VolumeTimeStep
{
  double Time = 0.0; ///< data time, in the units of the data
  VolumeView View;
  std::shared_ptr<const void> Samples; ///< keeps View.Data alive
  /**
   * The displacements to the next time step, on the points of View; none if they are not known, or
   * if there is no next time step.
   */
  DisplacementView Displacements = {};
  std::shared_ptr<const void> DisplacementSamples = {}; ///< keeps the displacements alive
  /** The isosurface for HapticMethod::SurfaceProxy, which moves to the next time step. */
  std::shared_ptr<const SurfaceMesh> Mesh = {};
};

/** Everything that a model is baked from. */
struct HapticModelDescription
{
  VolumeView View;
  std::shared_ptr<const void> Samples; ///< keeps View.Data alive
  /**
   * The time steps of a volume that moves, by ascending time: at least two, or one of a Series.
   * View is the first one, and all have its geometry. After the last time step of the series, the
   * first one may follow again.
   */
  std::vector<VolumeTimeStep> TimeSteps;
  /**
   * The series of which the time steps are a part; with a LoopInterval of 0, they are the whole
   * series.
   */
  TimeStepSeries Series;
  Affine3 IndexToWorld;  ///< not singular
  Affine3 DeviceToWorld; ///< a similarity, world units per metre
  ForceCaps DeviceCaps;  ///< the user's caps are in Settings
  GradientEstimator Estimator = GradientEstimator::Gaussian;
  int KernelRadius = 2; ///< voxels
  HapticMaterial Material;
  HapticSettings Settings;
  std::shared_ptr<const SurfaceMesh> Mesh;   ///< isosurface (world) of HapticMethod::SurfaceProxy
  std::shared_ptr<const BakedLabels> Labels; ///< null without a label image
  std::shared_ptr<const CutAway> Cut;        ///< null if all of the volume is felt
  /**
   * For HapticMethod::Primitives, on the points of View. Modes that are not valid, or whose
   * primitives exceed the limit of a tick, are not felt.
   */
  std::vector<ModeDescription> Modes;
  std::shared_ptr<const BakedTool> Tool; ///< null: the hand feels with a point
  /**
   * The tissue that a tool removes from the samples of View, which are then read as if it were
   * absent; may be null. The thread that ticks writes to it. Not for a volume that moves.
   */
  std::shared_ptr<TissueRemoval> Removal;
  double AirValue = 0.0; ///< the value of a sample without tissue
  /**
   * 0, or the BakedVolume::Number of a model of another region of the same volume, or of other time
   * steps, with the same material and settings: a servo goes on from that model as if both models
   * were the whole volume.
   */
  std::uint64_t Number = 0;
  /**
   * The fraction of the force that is felt; below 1 if the samples stand in for the volume's own.
   */
  double ResidentShare = 1.0;
};

} // namespace VolumeHaptics

#endif
