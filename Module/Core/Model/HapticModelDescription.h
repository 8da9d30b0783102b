// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The volume, material and settings from which a model is made.
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

/**
 * Material as functions of the scalar. Some are functions of the gradient magnitude per world unit.
 */
struct HapticMaterial
{
  Polyline Stiffness = ConstantPolyline(500.0);      ///< k, N/m
  Polyline Friction = ConstantPolyline(0.0);         ///< mu
  Polyline SurfaceStrength = ConstantPolyline(2.0);  ///< T_N, N
  Polyline Viscosity = ConstantPolyline(0.0);        ///< R, N
  Polyline Distinctness = ConstantPolyline(1.0);     ///< W_d, 0 to 1, of the gradient magnitude
  Polyline ScalarVisibility = ConstantPolyline(1.0); ///< factor 0 or 1 of T_N and R
  /** Factor 0 or 1 of T_N and R, by the gradient magnitude. */
  Polyline GradientVisibility = ConstantPolyline(1.0);
  bool IsSeenByNearest = false; ///< whether the display shows the nearest sample everywhere
  /**
   * Whether Distinctness is the ramp of MakeNoiseRamp(). The larger the spacing along an axis, the
   * less noise the gradient along it has. W_d is therefore looked up for the rise over a voxel
   * along the normal, divided by the smallest spacing (except with the solver Paper).
   */
  bool IsDistinctFromNoise = false;
};

/** A time step of a volume that moves. */
struct VolumeTimeStep
{
  double Time = 0.0; ///< data time, in the units of the data
  VolumeView View;
  std::shared_ptr<const void> Samples; ///< keeps View.Data alive
  /**
   * Displacements to the next time step at the points of View. Empty if they are not known, or if
   * there is no next time step.
   */
  DisplacementView Displacements = {};
  std::shared_ptr<const void> DisplacementSamples = {}; ///< keeps the displacements alive
  /** Isosurface for HapticMethod::SurfaceProxy, with its motion to the next time step. */
  std::shared_ptr<const SurfaceMesh> Mesh = {};
};

/** Everything from which a model is baked. */
struct HapticModelDescription
{
  VolumeView View;
  std::shared_ptr<const void> Samples; ///< keeps View.Data alive
  /**
   * Time steps of a moving volume, in the order of their times: at least two, or one time step of
   * Series. View is the first one, and all have its geometry. In a loop, the first time step may
   * also come after the last one of the series.
   */
  std::vector<VolumeTimeStep> TimeSteps;
  /** The series that contains TimeSteps. If LoopInterval is 0, TimeSteps are the whole series. */
  TimeStepSeries Series;
  Affine3 IndexToWorld;  ///< maps indices to the world; can be inverted
  Affine3 DeviceToWorld; ///< a similarity, with the world units per metre as its factor
  ForceCaps DeviceCaps;  ///< the device's caps; Settings has the user's caps
  GradientEstimator Estimator = GradientEstimator::Gaussian;
  int KernelRadius = 2; ///< radius of the gradient kernel (voxels)
  HapticMaterial Material;
  HapticSettings Settings;
  std::shared_ptr<const SurfaceMesh> Mesh;   ///< isosurface (world) of HapticMethod::SurfaceProxy
  std::shared_ptr<const BakedLabels> Labels; ///< null without a label image
  std::shared_ptr<const CutAway> Cut;        ///< null if all of the volume is felt
  /**
   * Modes for HapticMethod::Primitives. Their samples are at the points of View. Invalid modes are
   * not felt, nor are modes whose primitives exceed the limit of a tick.
   */
  std::vector<ModeDescription> Modes;
  std::shared_ptr<const BakedTool> Tool; ///< tool in the hand; null if the hand feels with a point
  /**
   * The tissue that a tool removes from the samples of View, or null. A tick reads the samples as
   * if removed tissue were absent, and may remove more. Ignored for a moving volume.
   */
  std::shared_ptr<TissueRemoval> Removal;
  double AirValue = 0.0; ///< value of a sample whose tissue was removed
  /**
   * 0, or the BakedVolume::Number of another model with the same material and settings that shows
   * another region or other time steps of the same volume. The servo then continues from that model
   * as if both models were the whole volume.
   */
  std::uint64_t Number = 0;
  /**
   * Fraction of the force that is felt. It is below 1 if coarser samples replace the volume's own.
   */
  double ResidentShare = 1.0;
};

} // namespace VolumeHaptics

#endif
