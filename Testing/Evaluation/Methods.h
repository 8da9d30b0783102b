// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The methods that the report compares, and how each of them touches the same surface.
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
 * The sphere of SURFACE_PROXY (mm): small beside a voxel, so that it goes wherever a point does.
 */
constexpr double ProbeRadius = 0.02;

struct Method
{
  const char* Name;
  int Kind;   ///< vtkVolumeHapticsFilter::MethodType
  int Solver; ///< vtkVolumeHapticsFilter::SolverType
  int Colour; ///< of its curves, see Curve
  /** A field of forces has no surface: it is compared only if that makes no difference. */
  bool HasSurface() const { return this->Kind != vtkVolumeHapticsFilter::FORCE_FIELD; }
  /** How far (mm) off the surface the proxy is held. */
  double Offset() const
  {
    return this->Kind == vtkVolumeHapticsFilter::SURFACE_PROXY ? ProbeRadius : 0.0;
  }
};

/** One line a method. */
const std::vector<Method>& AllMethods();
/** The method from which the paper can't tell its own apart: proxy-based surface haptics. */
const Method& SurfaceHaptics();

/**
 * Down to a surface and along it. The tip begins on the surface: PROXY, to which any place can be a
 * surface, is held by this one from then on.
 */
struct Stroke
{
  Vector3 Start;           ///< mm, on the surface
  Vector3 Outward;         ///< unit, there
  Path Tips;               ///< mm, from the second tick on
  std::size_t Pressed = 0; ///< how many of these press, before the others slide
};

/** The function has this value everywhere. */
void SetConstant(vtkPiecewiseFunction* function, double value);

/** A field, sampled in voxels of 1 mm around the origin. */
vtkSmartPointer<vtkImageData> SampleImage(const Field& field, double halfSize);

/**
 * An image with a surface of which all that holds has the same stiffness and friction, without
 * limit.
 */
class Scene
{
public:
  /** The surface is the isosurface, unless SURFACE_PROXY is given another. */
  Scene(vtkImageData* image, double isoValue, vtkPolyData* surface = nullptr);

  /**
   * Whether a method touches the surface. Local surfaces are those of the image, whatever is given.
   */
  bool CanFeel(const Method& method) const
  {
    return method.HasSurface() &&
      (method.Kind != vtkVolumeHapticsFilter::LOCAL_SURFACE || !this->IsGiven);
  }
  void SetMaterial(double stiffness, double friction);
  void SetKernelRadius(int voxels) { this->Filter->SetKernelRadius(voxels); }
  void SetForceFieldGain(double gain) { this->Filter->SetForceFieldGain(gain); }

  /** Null after an error of the filter. */
  std::shared_ptr<const VolumeHaptics::HapticModel> Bake(const Method& method);

  /**
   * A record for each of the stroke's tips, life-size; none after an error.
   *
   * The sphere of SURFACE_PROXY rolls on the surface, its centre a radius outside. What is compared
   * is the point of it that touches, and the spring from there: the offset is taken from proxy and
   * force. Only friction has seen it, as mu k ProbeRadius: 3 mN at 500 N/m and mu = 0.3. What is no
   * proxy of ours begins outside, to have a side.
   */
  Trace Feel(const Method& method, const Stroke& stroke);

private:
  vtkNew<vtkVolumeHapticsFilter> Filter;
  const bool IsGiven;
};

} // namespace evaluation

#endif
