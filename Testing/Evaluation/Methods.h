// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The methods that the report compares, and how each method touches the same surface.
 */
#ifndef Evaluation_Methods_h
#define Evaluation_Methods_h

#include "Figure.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeHapticsFilter.h"

#include <memory>

class vtkImageData;
class vtkPiecewiseFunction;
class vtkPolyData;

namespace evaluation
{

/**
 * Radius (mm) of SURFACE_PROXY's sphere, small enough compared with a voxel that the sphere goes
 * wherever a point goes.
 */
constexpr double ProbeRadius = 0.02;

struct Method
{
  const char* Name;
  int Kind;   ///< vtkVolumeHapticsFilter::MethodType
  int Solver; ///< vtkVolumeHapticsFilter::SolverType
  int Colour; ///< colour of its curves, see Curve::Colour
  /**
   * Returns whether the method has a surface. A force field has no surface, and is compared only
   * where a surface makes no difference.
   */
  bool HasSurface() const { return this->Kind != vtkVolumeHapticsFilter::FORCE_FIELD; }
  /** Returns the distance (mm) between the surface and the proxy in contact. */
  double Offset() const
  {
    return this->Kind == vtkVolumeHapticsFilter::SURFACE_PROXY ? ProbeRadius : 0.0;
  }
};

/** Returns all methods in the order of the report's lines. */
const std::vector<Method>& AllMethods();
/**
 * Returns proxy-based surface haptics, from which people can't distinguish the paper's method,
 * according to the paper.
 */
const Method& SurfaceHaptics();

/**
 * A stroke that presses into a surface and slides along it. The first tip is on the surface,
 * because PROXY takes its level from the value there.
 */
struct Stroke
{
  Vector3 Start;           ///< mm, on the surface
  Vector3 Outward;         ///< unit normal at the start
  Path Tips;               ///< mm, from the second tick on
  std::size_t Pressed = 0; ///< number of tips that press before the slide begins
};

/** Makes the function constant. */
void SetConstant(vtkPiecewiseFunction* function, double value);

/** Samples a field around the origin, in voxels of 1 mm. */
vtkSmartPointer<vtkImageData> SampleImage(const Field& field, double halfSize);

/**
 * An image with a surface. All solid tissue has the same stiffness and friction, and unlimited
 * strength.
 */
class Scene
{
public:
  /** Uses the isosurface, unless another surface is given for SURFACE_PROXY. */
  Scene(vtkImageData* image, double isoValue, vtkPolyData* surface = nullptr);

  /**
   * Returns whether a method can touch the surface. A local surface is always a surface of the
   * image.
   */
  bool CanFeel(const Method& method) const
  {
    return method.HasSurface() &&
      (method.Kind != vtkVolumeHapticsFilter::LOCAL_SURFACE || !this->IsGiven);
  }
  void SetMaterial(double stiffness, double friction);
  void SetKernelRadius(int voxels) { this->Filter->SetKernelRadius(voxels); }
  void SetForceFieldGain(double gain) { this->Filter->SetForceFieldGain(gain); }

  /** Returns the filter's model, or null after an error. */
  std::shared_ptr<const VolumeHaptics::HapticModel> Bake(const Method& method);

  /**
   * Returns a record for each of the stroke's tips, or nothing after an error. 1 mm of the stroke
   * is 1 mm of the hand.
   *
   * The sphere of SURFACE_PROXY rolls on the surface with its centre one radius outside. For the
   * comparison, proxy and force are corrected by this offset to those of the touching point. Only
   * friction still includes the offset, as mu k ProbeRadius: 3 mN at 500 N/m and mu = 0.3. Methods
   * other than PROXY begin outside of the surface, because they must determine their side.
   */
  Trace Feel(const Method& method, const Stroke& stroke);

private:
  vtkNew<vtkVolumeHapticsFilter> Filter;
  const bool IsGiven;
};

} // namespace evaluation

#endif
