// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests that a region from vtkHapticRegionFilter has the same forces as the whole image. */

#include "RegionRig.h"

using namespace apitest;

namespace
{
class Region : public testing::TestWithParam<const char*>
{
protected:
  Region()
  {
    this->Crop->SetInputData(this->Whole);
    for (vtkVolumeHapticsFilter* filter : { this->Touch.Get(), this->TouchRegion.Get() })
    {
      EXPECT_TRUE(filter->SetMethodByName(this->GetParam()));
      filter->SetIsoValue(500.0);
      filter->SetForceFieldGain(0.01);
      filter->SetPathData(MakePath(SlideOver(this->Whole, 2000)));
      SetConstant(filter->GetProperty()->GetFriction(), 0.2);
      SetConstant(filter->GetProperty()->GetViscosity(), 0.1);
      SetConstant(filter->GetProperty()->GetSurfaceStrength(), 0.8);
    }
    this->Touch->SetInputData(0, this->Whole);
    this->TouchRegion->SetInputConnection(0, this->Crop->GetOutputPort());
  }
  void ExpectSame(double tolerance)
  {
    this->Touch->Update();
    this->TouchRegion->Update();
    vtkPolyData* const a = this->Touch->GetOutput();
    vtkPolyData* const b = this->TouchRegion->GetOutput();
    ASSERT_EQ(a->GetNumberOfPoints(), 2000);
    EXPECT_LE(FarthestApart(a, b, "Force"), tolerance);
    EXPECT_EQ(this->Touch->GetProperty()->GetNoiseRamp()[0],
      this->TouchRegion->GetProperty()->GetNoiseRamp()[0]);
    EXPECT_GT(a->GetPointData()->GetArray("Force")->GetMaxNorm(), 0.1) << "something is felt";
    EXPECT_EQ(this->Log.Errors.size(), 0U);
  }

  /// Tolerance (N). In a different mesh, the sphere touches the triangles in another order. For two
  /// triangles that are parallel within 1e-6 rad, the normal of the first one is used.
  const double Tolerance = std::string(this->GetParam()) == "surface-proxy" ? 1e-7 : 1e-9;
  vtkSmartPointer<vtkImageData> Whole = MakeBall();
  vtkNew<vtkHapticRegionFilter> Crop;
  vtkNew<vtkVolumeHapticsFilter> Touch;
  vtkNew<vtkVolumeHapticsFilter> TouchRegion;
  MessageLog Log{ this->TouchRegion };
};
} // namespace

TEST_P(Region, IsFeltAsTheWhole)
{
  // The region is the upper half without the outermost voxels, so five of its six borders are
  // inside the volume.
  this->Crop->SetRegion(-4, 53, 4, 57, 22, 70);
  this->Crop->Update();
  int extent[6];
  this->Crop->GetOutput()->GetExtent(extent);
  EXPECT_EQ(extent[5], 61) << "clipped";
  EXPECT_EQ(extent[4], 22) << "with the indices of the whole";
  this->ExpectSame(this->Tolerance);
}

TEST_P(Region, ThatIsAllIsTheWhole)
{
  this->ExpectSame(0.0);
}

TEST_P(Region, WithSamplesThatAreNotNumbersIsFeltAsTheWhole)
{
  const auto holes = MakeBall(VTK_FLOAT, 0.0);
  vtkDataArray* const scalars = holes->GetPointData()->GetScalars();
  double centre[3];
  holes->GetCenter(centre);
  for (const double dx : { 7.0, 9.0 })
  {
    scalars->SetComponent(
      holes->FindPoint(centre[0] + dx, centre[1] - 4.0, centre[2] + 17.0), 0, NAN);
  }
  scalars->SetComponent(0, 0, 345.0); // changes the first corner, which replaces invalid samples
  this->Crop->SetInputData(holes);
  this->Crop->SetRegion(-4, 53, 4, 57, 22, 61);
  this->Touch->SetInputData(0, holes);
  this->ExpectSame(this->Tolerance);
  this->Crop->Update();
  vtkFieldData* const fields = this->Crop->GetOutput()->GetFieldData();
  EXPECT_EQ(fields->GetArray("HapticBorderValue")->GetComponent(0, 0), 345.0);
}

TEST_P(Region, ThatIsElsewhereGivesNoForce)
{
  this->Crop->SetRegion(-3, 52, 5, 56, 12, 28);
  this->TouchRegion->Update();
  EXPECT_EQ(this->TouchRegion->GetOutput()->GetNumberOfPoints(), 2000);
  EXPECT_EQ(this->TouchRegion->GetOutput()->GetPointData()->GetArray("Force")->GetMaxNorm(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Methods, Region,
  testing::Values("proxy", "paper", "force-field", "surface-proxy", "local-surface"),
  [](const auto& info)
  {
    std::string name = info.param;
    name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
    return name;
  });
