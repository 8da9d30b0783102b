// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Everything that determines a trace: a volume, a property, the settings and a path of the tip.
 * Both the module (through its public VTK classes) and the reference can play a scene.
 */
#ifndef Scene_h
#define Scene_h

#include "Trace.h"

#include <vtkHapticProperty.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace reference
{
enum class Method
{
  Proxy,
  ForceField
};

enum class Estimator
{
  CentralDifference,
  Gaussian,
  CubicBSpline
};

inline constexpr Estimator AllEstimators[] = { Estimator::CentralDifference, Estimator::Gaussian,
  Estimator::CubicBSpline };

/// Solver of the module. The reference has only the paper's solver.
enum class Solver
{
  Paper,
  Precise
};

enum class Side
{
  Higher,
  Lower,
  Both
};

struct Scene
{
  vtkSmartPointer<vtkImageData> image;
  vtkNew<vtkHapticProperty> property;
  std::string arrayName; // name of the touched array; empty for the active scalars
  int component = 0;
  Side side = Side::Higher;
  Method method = Method::Proxy;
  Solver solver = Solver::Paper;
  bool placesAsThePaper = false; ///< alignment Distinctness, kernel materials
  Estimator estimator = Estimator::Gaussian;
  int kernelRadius = 2;
  double servoRate = 1000.0;
  double metersPerWorldUnit = 0.001;
  double forceFieldGain = 0.0;
  double forceFieldDamping = 0.0;
  std::vector<Vec3> path;

  /// Appends points towards `goal`, a `step` apart. The last point is exactly `goal`.
  void MoveTo(const Vec3& goal, double step);
};

/// Sets constant material functions, which most closed forms need.
void SetMaterial(Scene& scene, double stiffness, double friction, double viscosity,
  double surfaceStrength, double distinctness = 1.0);

/// Plays the scene with vtkVolumeHapticsFilter. Throws std::runtime_error if the output is not as
/// documented.
Trace RunFilter(Scene& scene);

/// Plays the scene with the reference. If the gradient vanishes, the normal is arbitrary: the
/// reference uses the normal of `played`, if given, and only checks that it is a unit vector. With
/// `resume`, every tick starts at the last proxy in `played`, so that each tick is compared
/// independently.
Trace RunReference(Scene& scene, const Trace* played = nullptr, bool resume = false);
} // namespace reference

#endif
