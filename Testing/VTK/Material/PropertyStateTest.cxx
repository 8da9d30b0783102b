// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests the remaining state of vtkHapticProperty: component, side and visibility. */

#include "Rigs/ApiRig.h"

#include <vtkVolumeProperty.h>

#include <sstream>

using namespace apitest;

TEST(PropertyState, Defaults)
{
  vtkNew<vtkHapticProperty> property;
  EXPECT_EQ(property->GetComponent(), 0);
  EXPECT_EQ(property->GetSurfaceSide(), vtkHapticProperty::HIGHER);
  EXPECT_EQ(property->GetVisibilityFrom(), nullptr);
  EXPECT_STREQ(property->GetClassName(), "vtkHapticProperty");
}

TEST(PropertyState, SettersModifyOnlyOnChange)
{
  vtkNew<vtkHapticProperty> property;
  vtkNew<vtkVolumeProperty> volume;
  const auto modifies = [&](const std::function<void()>& change)
  {
    const vtkMTimeType before = property->GetMTime();
    change();
    return property->GetMTime() > before;
  };
  for (const bool first : { true, false })
  {
    EXPECT_EQ(modifies([&] { property->SetComponent(2); }), first);
    EXPECT_EQ(modifies([&] { property->SetSurfaceSideToBoth(); }), first);
    EXPECT_EQ(modifies([&] { property->SetVisibilityFrom(volume); }), first);
  }
  EXPECT_EQ(property->GetComponent(), 2);
  EXPECT_EQ(property->GetSurfaceSide(), vtkHapticProperty::BOTH);
  EXPECT_EQ(property->GetVisibilityFrom(), volume.Get());
  property->SetSurfaceSideToLower();
  EXPECT_EQ(property->GetSurfaceSide(), vtkHapticProperty::LOWER);
  property->SetSurfaceSideToHigher();
  EXPECT_EQ(property->GetSurfaceSide(), vtkHapticProperty::HIGHER);
  property->SetComponent(-3);
  EXPECT_EQ(property->GetComponent(), 0);
  EXPECT_TRUE(modifies([&] { property->SetVisibilityFrom(nullptr); }));
  EXPECT_EQ(volume->GetReferenceCount(), 1);
}

TEST(PropertyState, VisibilityCountsAsPartOfTheProperty)
{
  vtkNew<vtkHapticProperty> property;
  vtkNew<vtkVolumeProperty> volume;
  vtkNew<vtkPiecewiseFunction> opacity;
  vtkNew<vtkPiecewiseFunction> gradientOpacity;
  volume->SetScalarOpacity(opacity);
  volume->SetGradientOpacity(gradientOpacity);
  property->SetVisibilityFrom(volume);
  vtkMTimeType time = property->GetMTime();
  const auto advances = [&]
  {
    const vtkMTimeType before = time;
    time = property->GetMTime();
    return time > before;
  };
  opacity->AddPoint(1.0, 1.0);
  EXPECT_TRUE(advances());
  gradientOpacity->AddPoint(1.0, 1.0);
  EXPECT_TRUE(advances());
  volume->SetIndependentComponents(0);
  EXPECT_TRUE(advances());
  EXPECT_FALSE(advances());
}

TEST(PropertyState, PrintsEveryMember)
{
  vtkNew<vtkHapticProperty> property;
  std::ostringstream bare;
  property->Print(bare);
  vtkNew<vtkVolumeProperty> volume;
  property->SetVisibilityFrom(volume);
  property->SetComponent(3);
  property->SetSurfaceSideToBoth();
  property->GetStiffness()->AddPoint(4.0, 123.0);
  std::ostringstream full;
  property->Print(full);
  for (const std::string& text : { bare.str(), full.str() })
  {
    for (const char* const member : { "Stiffness:", "Friction:", "Viscosity:", "SurfaceStrength:",
           "Distinctness:", "VisibilityFrom:", "Component:", "SurfaceSide:" })
    {
      EXPECT_NE(text.find(member), std::string::npos) << member;
    }
  }
  EXPECT_NE(full.str().find("Component: 3"), std::string::npos);
  EXPECT_NE(full.str().find("SurfaceSide: Both"), std::string::npos);
  EXPECT_NE(full.str().find("123"), std::string::npos);
}

TEST(PropertyState, DeepCopyCopiesTheRestToo)
{
  vtkNew<vtkHapticProperty> source;
  vtkNew<vtkVolumeProperty> volume;
  source->SetVisibilityFrom(volume);
  source->SetComponent(1);
  source->SetSurfaceSideToLower();
  vtkNew<vtkHapticProperty> copy;
  const vtkMTimeType before = copy->GetMTime();
  copy->DeepCopy(source);
  EXPECT_GT(copy->GetMTime(), before);
  EXPECT_EQ(copy->GetVisibilityFrom(), volume.Get());
  EXPECT_EQ(copy->GetComponent(), 1);
  EXPECT_EQ(copy->GetSurfaceSide(), vtkHapticProperty::LOWER);
  copy->DeepCopy(nullptr);
  copy->DeepCopy(copy);
  EXPECT_EQ(copy->GetComponent(), 1);
}
