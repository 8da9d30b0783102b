// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** A scene whose settings are random. */
#ifndef RandomSetup_h
#define RandomSetup_h

#include "SetupRig.h"

#include <vtkColorTransferFunction.h>

#include <cmath>
#include <random>

namespace setuptest
{
/// A scene in which all numbers are random with all their digits, and differ from the defaults.
class RandomScene : public Scene
{
public:
  explicit RandomScene(unsigned int seed)
    : Random(seed)
  {
    vtkVolumeHapticsFilter* const f = this->Filter;
    f->SetTraceArrays("Force, Contact, Label");
    f->SetMethodToForceField();
    f->SetGradientEstimatorToCubicBSpline();
    f->SetKernelRadius(3);
    f->SetServoRate(this->Draw(2000.0));
    f->SetMetersPerWorldUnit(this->Draw(0.01));
    f->SetForceFieldGain(-this->Draw(1.0));
    f->SetForceFieldDamping(this->Draw(5.0));
    f->SetIsoValue(-this->Draw(500.0));
    f->SetProxyRadius(this->Draw(3.0));
    f->ForceShadingOff();
    f->SetLocalSurfaceShapeToQuadric();
    f->SetLocalSurfaceRate(this->Draw(100.0));
    f->SetRecoveryTime(this->Draw(0.5));
    f->SetReleaseTime(this->Draw(0.5));
    f->SetContactAlignmentToEdge();
    f->SetTimeUnitsPerSecond(this->Draw(9.0));
    f->SetDisplacementArrayName("motion of \"tissue\"");
    f->SetFramesToComponents();
    f->SetFrameSpacing(this->Draw(3.0));
    f->SameShapeOn();
    f->SetCouplingStiffness(this->Draw(1000.0));
    f->SetGeometryFromBoth();
    f->SetMaterialPlacementToFarSide();
    f->SetMaximumForce(this->Draw(10.0));
    f->SetMaximumStiffness(this->Draw(3000.0));
    f->GetProperty()->SetComponent(2);
    f->GetProperty()->SetSurfaceSideToBoth();
    f->GetProperty()->SetVisibilityFrom(this->Volume);
    for (vtkPiecewiseFunction* function : this->Materials())
    {
      this->Fill(function);
    }
    for (int c = 0; c < 4; ++c)
    {
      this->Fill(this->Volume->GetScalarOpacity(c));
      this->Fill(this->Volume->GetGradientOpacity(c));
      this->Volume->SetScalarOpacityUnitDistance(c, this->Draw(3.0));
      this->Volume->SetShade(c, c % 2);
      this->Volume->SetAmbient(c, this->Draw(1.0));
      this->Volume->SetDiffuse(c, this->Draw(1.0));
      this->Volume->SetSpecular(c, this->Draw(1.0));
      this->Volume->SetSpecularPower(c, this->Draw(50.0));
    }
    this->Volume->SetDisableGradientOpacity(3, 1);
    this->Fill(this->Volume->GetGrayTransferFunction(0));
    vtkNew<vtkColorTransferFunction> colors;
    colors->SetColorSpaceToLab();
    colors->SetClamping(0);
    for (double x = this->Draw(1.0); x < 9.0; x += 1.0)
    {
      colors->AddRGBPoint(
        x, this->Draw(1.0), this->Draw(1.0), this->Draw(1.0), this->Draw(1.0), this->Draw(1.0));
    }
    this->Volume->SetColor(1, colors);
    this->Volume->SetInterpolationTypeToLinear();
    this->Volume->SetIndependentComponents(0);
    this->Camera->SetPosition(this->Draw(300.0), this->Draw(300.0), this->Draw(300.0));
    this->Camera->SetFocalPoint(this->Draw(9.0), this->Draw(9.0), this->Draw(9.0));
    this->Camera->SetViewUp(this->Draw(1.0), this->Draw(1.0), this->Draw(1.0));
    this->Camera->SetViewAngle(this->Draw(60.0));
    this->Camera->SetParallelProjection(1);
    this->Camera->SetParallelScale(this->Draw(200.0));
    this->Turn();
  }

  double Draw(double largest)
  {
    return largest * std::uniform_real_distribution<double>(0.1, 1.0)(this->Random);
  }

private:
  void Fill(vtkPiecewiseFunction* function)
  {
    function->RemoveAllPoints();
    function->SetClamping(0);
    function->SetUseLogScale(true);
    for (double x = this->Draw(1.0); x < 9.0; x += 1.0)
    {
      function->AddPoint(x / 3.0, this->Draw(1.0), this->Draw(1.0), this->Draw(1.0));
    }
  }

  /// Sets a random rotation about z, with a random scale and shift.
  void Turn()
  {
    const double angle = this->Draw(3.0);
    const double scale = this->Draw(2000.0);
    const double turn[2] = { scale * std::cos(angle), scale * std::sin(angle) };
    const double elements[16] = { turn[0], -turn[1], 0.0, this->Draw(50.0), turn[1], turn[0], 0.0,
      this->Draw(50.0), 0.0, 0.0, scale, this->Draw(50.0), 0.0, 0.0, 0.0, 1.0 };
    this->Matrix->DeepCopy(elements);
  }

  std::mt19937 Random;
};
} // namespace setuptest

#endif
