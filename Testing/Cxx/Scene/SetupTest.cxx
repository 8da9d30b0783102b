// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * What a setup saves comes back to the bit, in place, and nothing else changes.
 */

#include "SetupRig.h"

using namespace setuptest;

namespace
{
using Numbers = std::vector<double>;

Numbers Nodes(vtkPiecewiseFunction* f)
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

void Append(Numbers& list, const Numbers& more)
{
  list.insert(list.end(), more.begin(), more.end());
}

/// Everything that a setup has to bring back, as numbers.
Numbers Everything(Scene& s)
{
  vtkVolumeHapticsFilter* const f = s.Filter;
  vtkHapticProperty* const p = f->GetProperty();
  vtkVolumeProperty* const v = s.Volume;
  Numbers all{ 1.0 * f->GetMethod(), 1.0 * f->GetSolver(), 1.0 * f->GetGradientEstimator(),
    1.0 * f->GetKernelRadius(), f->GetServoRate(), f->GetMetersPerWorldUnit(),
    f->GetForceFieldGain(), f->GetForceFieldDamping(), f->GetMaximumForce(),
    f->GetMaximumStiffness(), 1.0 * p->GetComponent(), 1.0 * p->GetSurfaceSide(),
    p->GetVisibilityFrom() == v ? 1.0 : 0.0, 1.0 * v->GetInterpolationType(),
    1.0 * v->GetIndependentComponents() };
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
  const vtkCamera* const c = s.Camera;
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
} // namespace

TEST(Setup, EverythingComesBackToTheBit)
{
  const std::string file = File("Everything.json");
  for (unsigned int seed = 1; seed <= 50; ++seed)
  {
    RandomScene saved(seed);
    ASSERT_TRUE(saved.Setup->Save(file.c_str()));
    Scene loaded;
    vtkPiecewiseFunction* const stiffness = loaded.Filter->GetProperty()->GetStiffness();
    ASSERT_TRUE(loaded.Setup->Load(file.c_str()));
    ASSERT_EQ(Everything(loaded), Everything(saved)) << "seed " << seed;
    EXPECT_EQ(loaded.Filter->GetProperty()->GetStiffness(), stiffness) << "not in place";
    // The same setup, written again, is the same file.
    const std::string text = Read(file);
    ASSERT_TRUE(loaded.Setup->Save(file.c_str()));
    ASSERT_EQ(Read(file), text);
    EXPECT_TRUE(saved.Log.Errors.empty() && loaded.Log.Errors.empty());
  }
}

TEST(Setup, EmptyFunctionsAndTwoNodesInOnePlaceStaySo)
{
  const std::string file = File("Nodes.json");
  Scene saved;
  vtkPiecewiseFunction* const friction = saved.Filter->GetProperty()->GetFriction();
  friction->SetAllowDuplicateScalars(1);
  friction->AddPoint(1.0, 0.25);
  friction->AddPoint(1.0, 0.5);
  friction->SetAllowDuplicateScalars(0);
  ASSERT_TRUE(saved.Setup->Save(file.c_str()));
  RandomScene loaded(7);
  ASSERT_TRUE(loaded.Setup->Load(file.c_str()));
  EXPECT_EQ(loaded.Filter->GetProperty()->GetStiffness()->GetSize(), 0);
  EXPECT_EQ(Nodes(loaded.Filter->GetProperty()->GetFriction()), Nodes(friction));
  EXPECT_EQ(loaded.Filter->GetProperty()->GetVisibilityFrom(), nullptr);
}

TEST(Setup, WhatIsNotSetIsLeftOutAndWhatIsMissingStays)
{
  const std::string file = File("Part.json");
  RandomScene saved(3);
  saved.Setup->SetCamera(nullptr);
  saved.Setup->SetVolumeHaptics(nullptr);
  ASSERT_TRUE(saved.Setup->Save(file.c_str()));
  EXPECT_EQ(Read(file).find("Stiffness"), std::string::npos);
  RandomScene loaded(4);
  Scene like;
  const Numbers position(loaded.Camera->GetPosition(), loaded.Camera->GetPosition() + 3);
  const double rate = loaded.Filter->GetServoRate();
  ASSERT_TRUE(loaded.Setup->Load(file.c_str()));
  EXPECT_EQ(Numbers(loaded.Camera->GetPosition(), loaded.Camera->GetPosition() + 3), position);
  EXPECT_EQ(loaded.Filter->GetServoRate(), rate);
  EXPECT_EQ(loaded.Matrix->GetElement(0, 0), saved.Matrix->GetElement(0, 0));
}
