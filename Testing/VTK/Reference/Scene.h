// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Everything that decides a trace: a volume, a property, the settings and a tip path. A scene can
 * be played by the module (through its public VTK classes only) or by the reference.
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

/// The reference plays the paper's; only the module has the other one.
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
  std::string arrayName; // empty: the active scalars
  int component = 0;
  Side side = Side::Higher;
  Method method = Method::Proxy;
  Solver solver = Solver::Paper;
  bool placesAsThePaper = false; ///< alignment Distinctness, materials of the kernel
  Estimator estimator = Estimator::Gaussian;
  int kernelRadius = 2;
  double servoRate = 1000.0;
  double metersPerWorldUnit = 0.001;
  double forceFieldGain = 0.0;
  double forceFieldDamping = 0.0;
  std::vector<Vec3> path;

  /// Append points on the way to `goal`, `step` apart; the last one is exactly `goal`.
  void MoveTo(const Vec3& goal, double step);
};

/// Constant material functions, the closed forms' usual case.
void SetMaterial(Scene& scene, double stiffness, double friction, double viscosity,
  double surfaceStrength, double distinctness = 1.0);

/// Play the scene with vtkVolumeHapticsFilter. Throws std::runtime_error if the output is not as
/// documented.
Trace RunFilter(Scene& scene);

/// Play the scene with the reference. If the gradient vanishes, the method leaves the normal free
/// although x_s and x_v depend on it: `played`, if given, tells which one was taken, and the
/// reference only checks that it is a unit vector. With `resume`, every tick starts at the proxy of
/// the tick before in `played`, so that each tick is judged alone.
Trace RunReference(Scene& scene, const Trace* played = nullptr, bool resume = false);
} // namespace reference

#endif
