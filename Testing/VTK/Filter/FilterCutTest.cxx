// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the filter's clipping planes and cropping regions, which have the meaning that
 * vtkVolumeMapper documents.
 */

#include "Rigs/ApiRig.h"

#include "vtkDataSetAttributes.h"
#include "vtkHapticMode.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolumeMapper.h"

#include <cmath>
#include <limits>

using namespace apitest;

namespace
{
class FilterCut : public ApiTest
{
protected:
  /// Returns the largest force (N) on the path of ApiTest, which goes from z = 5 to z = 10 at x = y
  /// = 7.
  double Strongest()
  {
    vtkPolyData* const output = this->Run(51);
    double most = 0.0;
    for (vtkIdType i = 0; output && i < 51; ++i)
    {
      most = std::max(most, std::abs(Get(output, "Force", i, 2)));
    }
    return most;
  }
};
} // namespace

TEST_F(FilterCut, APlaneThatMovesMovesTheCut)
{
  const double whole = this->Strongest();
  EXPECT_NEAR(whole, 2.0, 1e-9);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(4.0, 0.0, 0.0);
  plane->SetNormal(2.0, 0.0, 0.0);
  this->Filter->AddClippingPlane(plane);
  EXPECT_NEAR(this->Strongest(), whole, 1e-12) << "x = 7 is on the side to which the normal points";
  plane->SetOrigin(9.0, 0.0, 0.0);
  EXPECT_EQ(this->Strongest(), 0.0);
  plane->SetNormal(-1.0, 0.0, 0.0);
  EXPECT_NEAR(this->Strongest(), whole, 1e-12);
  this->Filter->RemoveAllClippingPlanes();
  plane->SetNormal(1.0, 0.0, 0.0);
  EXPECT_NEAR(this->Strongest(), whole, 1e-12);
}

// VTK's GPU mappers don't draw blanked points and cells, so these must not be felt. Blank the
// points and cells with small x; the path is at x = 7.
TEST_F(FilterCut, BlankedPointsAndCellsAreNotFelt)
{
  const double whole = this->Strongest();
  const auto blank = [this](vtkUnsignedCharArray* flags, int side, int first, unsigned char flag)
  {
    for (vtkIdType i = 0; i < flags->GetNumberOfValues(); ++i)
    {
      flags->SetValue(i, i % side < first ? flag : 0);
    }
    flags->Modified();
  };
  const int side = this->Image->GetDimensions()[0];
  vtkUnsignedCharArray* const points = this->Image->AllocatePointGhostArray();
  blank(points, side, 5, vtkDataSetAttributes::HIDDENPOINT);
  EXPECT_NEAR(this->Strongest(), whole, 1e-12);
  blank(points, side, 9, vtkDataSetAttributes::HIDDENPOINT);
  EXPECT_EQ(this->Strongest(), 0.0);
  blank(points, side, 9, vtkDataSetAttributes::DUPLICATEPOINT);
  EXPECT_NEAR(this->Strongest(), whole, 1e-12) << "seen all the same";
  vtkUnsignedCharArray* const cells = this->Image->AllocateCellGhostArray();
  blank(cells, side - 1, 6, vtkDataSetAttributes::HIDDENCELL);
  EXPECT_NEAR(this->Strongest(), whole, 1e-12);
  blank(cells, side - 1, 9, vtkDataSetAttributes::HIDDENCELL);
  EXPECT_EQ(this->Strongest(), 0.0);
}

TEST_F(FilterCut, AMappersOwnPlanesAreTaken)
{
  vtkNew<vtkPlaneCollection> planes;
  this->Filter->SetClippingPlanes(planes);
  EXPECT_NEAR(this->Strongest(), 2.0, 1e-9);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 9.0, 0.0);
  plane->SetNormal(0.0, 1.0, 0.0);
  planes->AddItem(plane);
  EXPECT_EQ(this->Strongest(), 0.0);
  this->Filter->RemoveClippingPlane(plane);
  EXPECT_EQ(planes->GetNumberOfItems(), 0);
  EXPECT_NEAR(this->Strongest(), 2.0, 1e-9);
}

TEST_F(FilterCut, RegionsLieAlongTheAxesOfTheData)
{
  this->Filter->CroppingOn();
  this->Filter->SetCroppingRegionPlanes(0, 5, 0, 20, 0, 20);
  EXPECT_EQ(this->Strongest(), 0.0);
  this->Filter->SetCroppingRegionFlags(1 << 14);
  EXPECT_NEAR(this->Strongest(), 2.0, 1e-9) << "region 14 lies beyond xmax";
  this->Filter->SetCroppingRegionFlags(VTK_CROP_SUBVOLUME);
  this->Filter->SetCroppingRegionPlanes(5, 9, 0, 20, 0, 20);
  EXPECT_NEAR(this->Strongest(), 2.0, 1e-9);
  this->Filter->SetCroppingRegionPlanes(0, 5, 0, 20, 0, 20);
  this->Filter->CroppingOff();
  EXPECT_NEAR(this->Strongest(), 2.0, 1e-9);
}

TEST_F(FilterCut, AFaceIsFeltIfThatIsWanted)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 7.0);
  plane->SetNormal(0.0, 0.0, 1.0);
  this->Filter->AddClippingPlane(plane);
  this->Filter->FeelCutFacesOn();
  vtkPolyData* const output = this->Run(51);
  EXPECT_EQ(Get(output, "Force", 19, 2), 0.0) << "at z = 6.9";
  EXPECT_NEAR(Get(output, "Force", 40, 2), -500.0 * 0.002, 4e-3) << "2 mm behind a wall of 500 N/m";
}

TEST_F(FilterCut, WhatIsWrongIsNamed)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.0, 0.0, 0.0);
  this->Filter->AddClippingPlane(plane);
  this->ExpectError({ "Clipping plane 0", "vtkPlane::SetNormal()" });
  plane->SetNormal(0.0, 0.0, 1.0);
  plane->SetOrigin(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  this->ExpectError({ "Clipping plane 0", "RemoveClippingPlane()" });
  this->Filter->RemoveAllClippingPlanes();
  this->Filter->CroppingOn();
  this->Filter->SetCroppingRegionPlanes(0, 5, 9, 3, 0, 20);
  this->ExpectError({ "along axis 1 are 9 and 3", "SetCroppingRegionPlanes()" });
}

namespace
{
/// Tests methods other than PROXY, on the path of ApiTest through a surface at z = 7.
class FilterCutMethods : public FilterCut
{
protected:
  void ExpectThatAPlaneEndsIt()
  {
    const double whole = this->Strongest();
    EXPECT_GT(whole, 0.5);
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(9.0, 0.0, 0.0);
    plane->SetNormal(1.0, 0.0, 0.0);
    this->Filter->AddClippingPlane(plane);
    EXPECT_EQ(this->Strongest(), 0.0) << "x = 7 is cut away";
    plane->SetNormal(-1.0, 0.0, 0.0);
    EXPECT_NEAR(this->Strongest(), whole, 1e-12) << "the kept part feels as before";
    this->Filter->RemoveAllClippingPlanes();
    this->Filter->CroppingOn();
    this->Filter->SetCroppingRegionPlanes(0, 5, 0, 20, 0, 20);
    EXPECT_EQ(this->Strongest(), 0.0);
    this->Filter->SetCroppingRegionPlanes(5, 9, 0, 20, 0, 20);
    EXPECT_NEAR(this->Strongest(), whole, 1e-12);
  }
};
} // namespace

TEST_F(FilterCutMethods, TheMeshOfAnIsosurfaceEndsAtACut)
{
  this->Filter->SetMethodToSurfaceProxy();
  this->Filter->SetIsoValue(700.0);
  this->ExpectThatAPlaneEndsIt();
}

TEST_F(FilterCutMethods, ALocalSurfaceEndsAtACut)
{
  this->Filter->SetMethodToLocalSurface();
  this->Filter->SetIsoValue(700.0);
  this->ExpectThatAPlaneEndsIt();
}

TEST_F(FilterCutMethods, AForceFieldEndsAtACut)
{
  this->Filter->SetMethodToForceField();
  this->ExpectThatAPlaneEndsIt();
}

TEST_F(FilterCutMethods, ThePapersSurfacesEndAtACut)
{
  this->Filter->SetSolverToPaper();
  this->ExpectThatAPlaneEndsIt();
}

TEST_F(FilterCutMethods, SurfacesAmongModesEndAtACut)
{
  this->Filter->SetMethodToPrimitives();
  vtkNew<vtkHapticMode> mode;
  mode->SetKindToSurface();
  this->Filter->AddMode(mode);
  this->ExpectThatAPlaneEndsIt();
}
