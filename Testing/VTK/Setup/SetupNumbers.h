// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Settings that a setup must restore, as numbers to compare.
 */
#ifndef SetupNumbers_h
#define SetupNumbers_h

#include "SetupRig.h"

#include <vtkColorTransferFunction.h>

namespace setuptest
{
using Numbers = std::vector<double>;

inline Numbers Nodes(vtkPiecewiseFunction* f)
{
  Numbers list{ static_cast<double>(f->GetClamping()), static_cast<double>(f->GetUseLogScale()),
    static_cast<double>(f->GetAllowDuplicateScalars()) };
  for (int i = 0; i < f->GetSize(); ++i)
  {
    double node[4];
    f->GetNodeValue(i, node);
    list.insert(list.end(), node, node + 4);
  }
  return list;
}

inline void Append(Numbers& list, const Numbers& more)
{
  list.insert(list.end(), more.begin(), more.end());
}

/// Returns everything that a setup restores, as numbers.
inline Numbers Everything(Scene& s)
{
  vtkVolumeHapticsFilter* const f = s.Filter;
  vtkHapticProperty* const p = f->GetProperty();
  vtkVolumeProperty* const v = s.Volume;
  Numbers all{ 1.0 * f->GetMethod(), 1.0 * f->GetSolver(), 1.0 * f->GetGradientEstimator(),
    1.0 * f->GetKernelRadius(), f->GetServoRate(), f->GetMetersPerWorldUnit(),
    f->GetForceFieldGain(), f->GetForceFieldDamping(), f->GetIsoValue(), f->GetProxyRadius(),
    f->GetForceShading() ? 1.0 : 0.0, 1.0 * f->GetLocalSurfaceShape(), f->GetLocalSurfaceRate(),
    f->GetRecoveryTime(), f->GetReleaseTime(), 1.0 * f->GetContactAlignment(),
    1.0 * f->GetMaterialPlacement(), 1.0 * f->GetGeometry(), f->GetSameShape() ? 1.0 : 0.0,
    f->GetCouplingStiffness(), f->GetTimeUnitsPerSecond(), 1.0 * f->GetFrames(),
    f->GetFrameSpacing(), f->GetMaximumForce(), f->GetMaximumStiffness(), 1.0 * p->GetComponent(),
    1.0 * p->GetSurfaceSide(), p->GetVisibilityFrom() == v ? 1.0 : 0.0,
    1.0 * v->GetInterpolationType(), 1.0 * v->GetIndependentComponents() };
  const std::string motion = f->GetDisplacementArrayName();
  Append(all, Numbers(motion.begin(), motion.end()));
  for (vtkPiecewiseFunction* function : s.Materials())
  {
    Append(all, Nodes(function));
  }
  for (int c = 0; c < 4; ++c)
  {
    Append(all, Nodes(v->GetScalarOpacity(c)));
    Append(all, Nodes(v->GetStoredGradientOpacity(c)));
    Append(all,
      { 1.0 * v->GetDisableGradientOpacity(c), v->GetScalarOpacityUnitDistance(c),
        1.0 * v->GetShade(c), v->GetAmbient(c), v->GetDiffuse(c), v->GetSpecular(c),
        v->GetSpecularPower(c), 1.0 * v->GetColorChannels(c) });
  }
  Append(all, Nodes(v->GetGrayTransferFunction(0)));
  vtkColorTransferFunction* const colors = v->GetRGBTransferFunction(1);
  Append(all, { 1.0 * colors->GetColorSpace(), 1.0 * colors->GetClamping() });
  for (int i = 0; i < colors->GetSize(); ++i)
  {
    double node[6];
    colors->GetNodeValue(i, node);
    Append(all, Numbers(node, node + 6));
  }
  for (const double* x :
    { s.Camera->GetPosition(), s.Camera->GetFocalPoint(), s.Camera->GetViewUp() })
  {
    Append(all, Numbers(x, x + 3));
  }
  Append(all,
    { s.Camera->GetViewAngle(), 1.0 * s.Camera->GetParallelProjection(),
      s.Camera->GetParallelScale() });
  Append(all, Numbers(s.Matrix->GetData(), s.Matrix->GetData() + 16));
  return all;
}
} // namespace setuptest

#endif
