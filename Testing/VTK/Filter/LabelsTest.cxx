// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests materials by label, with surfaces of the scalars. On the ramp V = 100 z, a press of depth h
 * into a surface results in the force k h of a spring with stiffness k. All expectations follow
 * from this closed form (T1 in Documentation/evaluation.md).
 */

#include "Rigs/ApiRig.h"

#include <vtkDataArray.h>
#include <vtkHapticLabelTable.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>

#include <cmath>

using namespace apitest;

namespace
{
constexpr double Depth = 0.005; ///< depth of the press at the end of the path (m)
constexpr vtkIdType Last = 50;
constexpr double Strong = 100.0; ///< N that no press exceeds

class LabelsTest : public ApiTest
{
protected:
  LabelsTest() { SetConstant(this->Property->GetSurfaceStrength(), Strong); }

  /// Sets labels on the grid of the image: 1 up to x = 7, and 2 for x >= 8.
  void SetHalves(int scalarType = VTK_SHORT)
  {
    this->Filter->SetLabelData(
      MakeImage(16, scalarType, [](const Point& p) { return p[0] < 7.5 ? 1.0 : 2.0; }));
    this->Filter->SetLabelTable(this->Table);
  }

  void PressAt(double x)
  {
    this->Filter->SetPathData(MakePath(Line({ x, 7, 5 }, { x, 7, 10 }, 50)));
  }

  /// Returns the force (N) against the hand at the end of the press.
  double PressedForce(double x)
  {
    this->PressAt(x);
    return -Get(this->Run(51), "Force", Last, 2);
  }

  /// Returns the trace without the array of labels.
  vtkSmartPointer<vtkPolyData> KeepFelt()
  {
    const auto output = Keep(this->Filter);
    output->GetPointData()->RemoveArray("Label");
    return output;
  }

  vtkNew<vtkHapticLabelTable> Table;
};

class LabelsOfSolver
  : public LabelsTest
  , public testing::WithParamInterface<int>
{
protected:
  LabelsOfSolver() { this->Filter->SetSolver(this->GetParam()); }
};
} // namespace

TEST_P(LabelsOfSolver, TellTissuesOfOneValueApart)
{
  // Case L1: two labels in tissue of one value have different stiffnesses.
  this->SetHalves();
  this->Table->SetStiffness(1, 200.0);
  this->Table->SetStiffness(2, 800.0);
  EXPECT_NEAR(this->PressedForce(4.0) / (200.0 * Depth), 1.0, 1e-9);
  EXPECT_NEAR(this->PressedForce(11.0) / (800.0 * Depth), 1.0, 1e-9);
}

TEST_P(LabelsOfSolver, HaveAllFourQuantities)
{
  this->SetHalves();
  this->Table->SetSurfaceStrength(1, 1.5);
  this->Table->SetViscosity(1, 0.25);
  this->Table->SetFriction(1, 0.4);
  this->PressAt(4.0);
  vtkPolyData* const output = this->Run(51);
  // With the default stiffness of 500 N/m, the surface slips at 1.5 N, and the drag adds 0.25 N.
  EXPECT_NEAR(-Get(output, "Force", Last, 2), 1.75, 1e-9);
  EXPECT_NEAR(Get(output, "NormalForce", Last), 1.5, 1e-9);
  EXPECT_NEAR(Get(output, "DragForce", Last), 0.25, 1e-9);
  EXPECT_EQ(Get(output, "SurfaceStrength", Last), 1.5);
  EXPECT_EQ(Get(output, "Viscosity", Last), 0.25);
  EXPECT_EQ(Get(output, "Friction", Last), 0.4);
}

TEST_P(LabelsOfSolver, WithoutEntryMakeNoDifference)
{
  // Case L4: the path crosses both labels and their border, in all states of contact.
  SetConstant(this->Property->GetSurfaceStrength(), 1.2);
  SetConstant(this->Property->GetFriction(), 0.3);
  SetConstant(this->Property->GetViscosity(), 0.1);
  std::vector<Point> points = Line({ 3, 5, 4 }, { 12.5, 6, 11 }, 400);
  const std::vector<Point> back = Line({ 12.5, 6, 11 }, { -2, 4, 3 }, 400);
  points.insert(points.end(), back.begin(), back.end());
  this->Filter->SetPathData(MakePath(points));
  this->Run(802);
  const auto without = Keep(this->Filter);
  this->SetHalves();
  this->Run(802);
  EXPECT_TRUE(IsSame(without, this->KeepFelt())) << "an empty table";
  this->Table->SetLabelName(1, "liver");
  this->Table->SetColor(2, 1.0, 0.0, 0.0);
  this->Table->SetStiffness(3, 77.0);
  this->Table->SetStandOff(1.0);
  this->Run(802);
  EXPECT_TRUE(IsSame(without, this->KeepFelt())) << "entries without a material, or of others";
  this->Filter->SetLabelTable(nullptr);
  this->Run(802);
  EXPECT_TRUE(IsSame(without, this->KeepFelt())) << "no table";
  this->Filter->SetLabelTable(this->Table);
  this->Table->SetStiffness(2, 77.0);
  this->Run(802);
  EXPECT_FALSE(IsSame(without, this->KeepFelt())) << "the comparison sees an entry";
  this->Table->RemoveMaterial(2);
  this->Run(802);
  EXPECT_TRUE(IsSame(without, this->KeepFelt())) << "the material was removed";
}

TEST_P(LabelsOfSolver, OfAnyTypeFeelTheSame)
{
  // Case L7: label images of all types must result in the same forces.
  this->Table->SetStiffness(1, 200.0);
  this->Table->SetStiffness(2, 800.0);
  this->Filter->SetPathData(MakePath(Line({ 3, 7, 6 }, { 12, 7, 8 }, 300)));
  this->SetHalves(VTK_UNSIGNED_CHAR);
  this->Run(301);
  const auto first = Keep(this->Filter);
  EXPECT_GT(Get(first, "Stiffness", 290), Get(first, "Stiffness", 20));
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT,
         VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG,
         VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE })
  {
    this->SetHalves(type);
    this->Run(301);
    EXPECT_TRUE(IsSame(first, Keep(this->Filter))) << type;
  }
}

TEST_P(LabelsOfSolver, ThatAreNotFeltAreNotThere)
{
  this->SetHalves();
  SetConstant(this->Property->GetViscosity(), 0.5);
  this->Table->SetFelt(1, false);
  this->PressAt(4.0);
  vtkPolyData* const output = this->Run(51);
  for (vtkIdType tick = 0; tick <= Last; ++tick)
  {
    ASSERT_EQ(Get(output, "Force", tick, 2), 0.0) << tick;
  }
  EXPECT_NEAR(this->PressedForce(11.0), 500.0 * Depth, 1e-9);
}

TEST_P(LabelsOfSolver, BeyondTheLabelImageTheFunctionsHold)
{
  // The label image ends at x = 5.
  auto labels = vtkSmartPointer<vtkImageData>::New();
  labels->SetDimensions(6, 16, 16);
  labels->AllocateScalars(VTK_INT, 1);
  labels->GetPointData()->GetScalars()->Fill(-3.0);
  this->Filter->SetLabelData(labels);
  this->Filter->SetLabelTable(this->Table);
  this->Table->SetStiffness(-3, 900.0);
  EXPECT_NEAR(this->PressedForce(4.0), 900.0 * Depth, 1e-9);
  EXPECT_NEAR(this->PressedForce(6.0), 500.0 * Depth, 1e-9);
  EXPECT_NEAR(this->PressedForce(12.0), 500.0 * Depth, 1e-9);
}

TEST_P(LabelsOfSolver, AreTheScalarsThemselvesOfThePresetLabels)
{
  // The label fills a half-space whose wall is halfway between the voxels, at z = 7.5. For every
  // label number, the preset's stiffness of 400 N/m results in 0.4 N per millimetre of depth.
  this->Property->ApplyPreset("Labels");
  vtkSmartPointer<vtkPolyData> first;
  for (const double label : { 1.0, 7.0, 250.0 })
  {
    SCOPED_TRACE(label);
    this->Filter->SetInputData(MakeImage(
      16, VTK_UNSIGNED_CHAR, [label](const Point& p) { return p[2] < 7.5 ? 0.0 : label; }));
    this->Filter->SetPathData(MakePath(Line({ 7, 7, 4 }, { 7, 7, 10 }, 600)));
    vtkPolyData* const output = this->Run(601);
    EXPECT_NEAR(-Get(output, "Force", 600, 2), 0.4 * 2.5, 0.4 * 0.1) << "a tenth of a voxel";
    EXPECT_EQ(Get(output, "Force", 200, 2), 0.0) << "the air";
    EXPECT_EQ(Get(output, "Label", 600), label);
    first = first ? first : Keep(this->Filter);
    for (vtkIdType tick = 0; tick <= 600; ++tick)
    {
      ASSERT_NEAR(Get(output, "Force", tick, 2), Get(first, "Force", tick, 2), 1e-9) << tick;
    }
  }
}

TEST_F(LabelsTest, OfTheScalarsThemselvesHaveTheMaterialsOfTheirNumbers)
{
  // Labels 1 and 2 are adjacent along x. Label 2 must have the function's stiffness at 2 even near
  // label 1, because values between labels are never used.
  this->Property->ApplyPreset("Labels");
  vtkPiecewiseFunction* const stiffness = this->Property->GetStiffness();
  stiffness->RemoveAllPoints();
  stiffness->AddPoint(0.0, 0.0);
  stiffness->AddPoint(1.0, 200.0);
  stiffness->AddPoint(1.5, 5000.0);
  stiffness->AddPoint(2.0, 800.0);
  this->Filter->SetInputData(MakeImage(
    16, VTK_SHORT, [](const Point& p) { return p[2] < 7.5 ? 0.0
                                          : p[0] < 7.5    ? 1.0
                                                          : 2.0; }));
  for (const auto& [x, k] : { std::pair<double, double>{ 3.0, 0.2 }, { 12.0, 0.8 } })
  {
    this->Filter->SetPathData(MakePath(Line({ x, 7, 4 }, { x, 7, 9 }, 500)));
    EXPECT_NEAR(-Get(this->Run(501), "Force", 500, 2), k * 1.5, k * 0.1) << x;
  }
}

TEST_F(LabelsTest, OfTheScalarsThemselvesAreWholeNumbersOfAnyType)
{
  this->Property->ApplyPreset("Labels");
  this->Filter->SetPathData(MakePath(Line({ 7, 7, 4 }, { 7, 7, 9 }, 100)));
  const auto feel = [this](int type, double label)
  {
    this->Filter->SetInputData(
      MakeImage(16, type, [label](const Point& p) { return p[2] < 7.5 ? 0.0 : label; }));
    this->Run(101);
    return Keep(this->Filter);
  };
  EXPECT_TRUE(IsSame(feel(VTK_FLOAT, 3.0), feel(VTK_SHORT, 3.0)));
  // A fraction, or a number that is too large for a table, must count as a value, as if
  // ScalarsAreLabels were off.
  for (const double value : { 0.9, 70000.0 })
  {
    const auto felt = feel(VTK_FLOAT, value);
    EXPECT_EQ(felt->GetPointData()->GetArray("Label"), nullptr) << value;
    this->Property->ScalarsAreLabelsOff();
    EXPECT_TRUE(IsSame(felt, feel(VTK_FLOAT, value))) << value;
    this->Property->ScalarsAreLabelsOn();
  }
  // A label image on port 3 must determine the materials, with or without ScalarsAreLabels.
  this->SetHalves();
  const auto beside = feel(VTK_SHORT, 3.0);
  this->Property->ScalarsAreLabelsOff();
  EXPECT_TRUE(IsSame(beside, feel(VTK_SHORT, 3.0)));
}

INSTANTIATE_TEST_SUITE_P(Both, LabelsOfSolver,
  testing::Values(vtkVolumeHapticsFilter::PAPER, vtkVolumeHapticsFilter::PRECISE));

TEST_P(LabelsOfSolver, MakeWallsInAVolumeOfOneValue)
{
  // Case L1 with walls between labels: the wall is at z = 7.5, and the press ends at z = 9.5.
  this->Filter->SetInputData(MakeImage(16, VTK_SHORT, [](const Point&) { return 40.0; }));
  this->Filter->SetLabelData(MakeImage(16, VTK_UNSIGNED_SHORT,
    [](const Point& p) { return p[2] < 7.5 ? 0.0 : (p[0] < 7.5 ? 1000.0 : 2000.0); }));
  this->Filter->SetLabelTable(this->Table);
  this->Filter->SetGeometryFromLabels();
  this->Table->SetStiffness(1000, 200.0);
  this->Table->SetStiffness(2000, 800.0);
  for (const auto& [x, stiffness] : { std::pair(4.0, 200.0), std::pair(11.0, 800.0) })
  {
    this->Filter->SetPathData(MakePath(Line({ x, 7, 5 }, { x, 7, 9.5 }, 450)));
    vtkPolyData* const output = this->Run(451);
    EXPECT_EQ(Get(output, "Force", 200, 2), 0.0);
    EXPECT_EQ(Get(output, "Stiffness", 450), stiffness);
    EXPECT_NEAR(output->GetPoint(450)[2], 7.5, 0.015);
    const double depth = 1e-3 * (9.5 - output->GetPoint(450)[2]);
    EXPECT_NEAR(-Get(output, "Force", 450, 2) / (stiffness * depth), 1.0, 1e-9);
    EXPECT_NEAR(Get(output, "Normal", 450, 2), 1.0, 1e-6);
  }
  // The volume itself has no surface, so without the labels' walls there is no force.
  this->Filter->SetGeometryFromScalars();
  EXPECT_EQ(Get(this->Run(451), "Force", 450, 2), 0.0);
  this->Filter->SetGeometryFromBoth();
  EXPECT_NEAR(Get(this->Run(451), "Force", 450, 2), -800.0 * 0.002, 0.012);
}

TEST_P(LabelsOfSolver, OfThickSlicesHaveWallsWithoutStairs)
{
  // The plane is tilted by 45 degrees relative to slices of 3 mm. The press is 2 mm deep along its
  // normal.
  const double n[3] = { 0.8 * std::sqrt(0.5), 0.6 * std::sqrt(0.5), std::sqrt(0.5) };
  const auto depth = [&n](double x, double y, double z)
  { return n[0] * (x - 12.03) + n[1] * (y - 12.11) + n[2] * (z - 12.17); };
  constexpr int size = 41;
  const auto labels = MakeImage(size, VTK_UNSIGNED_SHORT,
    [&](const Point& p) { return depth(0.6 * p[0], 0.6 * p[1], 3.0 * p[2]) < 0.0 ? 1000.0 : 0.0; });
  labels->SetSpacing(0.6, 0.6, 3.0);
  this->Filter->SetInputData(MakeImage(25, VTK_SHORT, [](const Point&) { return 40.0; }));
  this->Filter->SetLabelData(labels);
  this->Filter->SetLabelTable(this->Table);
  this->Filter->SetGeometryFromLabels();
  this->Table->SetStiffness(1000, 500.0);
  const auto at = [&n](double height) {
    return Point{ 12.03 + height * n[0], 12.11 + height * n[1], 12.17 + height * n[2] };
  };
  this->Filter->SetPathData(MakePath(Line(at(2.0), at(-2.0), 400)));
  const auto press = [&](double tolerance)
  {
    vtkPolyData* const output = this->Run(401);
    double force = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      force += n[axis] * Get(output, "Force", 400, axis);
      EXPECT_NEAR(Get(output, "Normal", 400, axis), -n[axis], tolerance);
    }
    EXPECT_NEAR(force, 1.0, 0.075) << "N";
  };
  press(0.05);
  // A brush stroke elsewhere must not change the force here, and the trace must be that of a new
  // filter.
  vtkDataArray* const array = labels->GetPointData()->GetScalars();
  for (int i = 0; i < 200; ++i)
  {
    array->SetComponent(10 * size + 5 + i / 20 * size + i % 20 + size * size * 20, 0, 7.0);
  }
  array->Modified();
  press(0.05);
  const auto again = Keep(this->Filter);
  vtkNew<vtkVolumeHapticsFilter> fresh;
  fresh->SetInputDataObject(0, this->Filter->GetInputDataObject(0, 0));
  fresh->SetLabelData(labels);
  fresh->SetLabelTable(this->Table);
  fresh->SetGeometryFromLabels();
  fresh->SetSolver(this->Filter->GetSolver());
  fresh->SetProperty(this->Property);
  fresh->SetPathData(MakePath(Line(at(2.0), at(-2.0), 400)));
  fresh->Update();
  EXPECT_TRUE(IsSame(again, fresh->GetOutput()));
  EXPECT_TRUE(this->Log.Warnings.empty());
}

TEST_P(LabelsOfSolver, LeaveSurfacesOfTheVolumeAlone)
{
  // The ramp has a surface everywhere, so with both geometries only the ramp is felt.
  this->SetHalves();
  this->PressAt(4.0);
  this->Run(51);
  const auto scalars = Keep(this->Filter);
  this->Filter->SetGeometryFromBoth();
  this->Run(51);
  EXPECT_TRUE(IsSame(scalars, Keep(this->Filter)));
  // The press meets no wall of the labels, since their only wall is at x = 7.5.
  this->Filter->SetGeometryFromLabels();
  EXPECT_EQ(Get(this->Run(51), "Force", Last, 2), 0.0);
}

TEST_F(LabelsTest, OtherMethodsDoNotFeelThem)
{
  this->Filter->SetIsoValue(700.0);
  SetConstant(this->Property->GetFriction(), 0.3);
  this->Filter->SetPathData(MakePath(Line({ 3, 7, 5 }, { 12, 7, 9 }, 200)));
  for (const int method : { vtkVolumeHapticsFilter::FORCE_FIELD,
         vtkVolumeHapticsFilter::SURFACE_PROXY, vtkVolumeHapticsFilter::LOCAL_SURFACE })
  {
    this->Filter->SetMethod(method);
    this->Filter->SetLabelData(nullptr);
    this->Filter->SetGeometryFromScalars();
    this->Run(201);
    const auto without = Keep(this->Filter);
    this->SetHalves();
    this->Table->SetStiffness(1, 77.0);
    this->Table->SetFelt(2, false);
    this->Filter->SetGeometryFromLabels();
    vtkPolyData* const output = this->Run(201);
    for (vtkIdType tick = 0; tick <= 200; ++tick)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        ASSERT_EQ(Get(output, "Force", tick, axis), Get(without, "Force", tick, axis)) << method;
      }
    }
  }
}

TEST_F(LabelsTest, GoOverWithinAVoxel)
{
  // PAPER uses the material without an additional blend: between the voxels at x = 7 and x = 8, k =
  // 200 + 600 (x - 7).
  this->Filter->SetSolverToPaper();
  this->SetHalves();
  this->Table->SetStiffness(1, 200.0);
  this->Table->SetStiffness(2, 800.0);
  this->Filter->SetPathData(MakePath(Line({ 6, 7, 6 }, { 9, 7, 6 }, 300)));
  vtkPolyData* const output = this->Run(301);
  for (vtkIdType tick = 1; tick <= 300; ++tick)
  {
    // A tick reads the material at the last tick's proxy, which was at the tip.
    const double x = 6.0 + 0.01 * static_cast<double>(tick - 1);
    const double share = std::min(std::max(x - 7.0, 0.0), 1.0);
    ASSERT_NEAR(Get(output, "Stiffness", tick), 200.0 + 600.0 * share, 1e-9) << tick;
  }
}

TEST_F(LabelsTest, HaveAGeometryOfTheirOwn)
{
  // Case L3: sample three labels on the grid of the image, and on a finer, rotated grid.
  this->Table->SetStiffness(1, 200.0);
  this->Table->SetStiffness(2, 800.0);
  this->Table->SetSurfaceStrength(3, 0.5);
  this->Filter->SetLabelTable(this->Table);
  const auto labelAt = [](double x, double y) { return x < 6.5 ? 1 : (y < 7.5 ? 2 : 3); };
  this->Filter->SetPathData(MakePath(Line({ 2, 4, 5 }, { 13, 11, 9 }, 500)));
  this->Filter->SetLabelData(
    MakeImage(16, VTK_UNSIGNED_CHAR, [&](const Point& p) { return labelAt(p[0], p[1]); }));
  this->Run(501);
  const auto onGrid = Keep(this->Filter);

  // Store the same voxels in another order: the axes of the image are y, -x and z.
  vtkNew<vtkImageData> turned;
  turned->SetDimensions(16, 16, 16);
  turned->SetOrigin(15.0, 0.0, 0.0);
  turned->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1);
  turned->AllocateScalars(VTK_INT, 1);
  for (int k = 0; k < 16; ++k)
  {
    for (int j = 0; j < 16; ++j)
    {
      for (int i = 0; i < 16; ++i)
      {
        turned->SetScalarComponentFromDouble(i, j, k, 0, labelAt(15.0 - j, i));
      }
    }
  }
  this->Filter->SetLabelData(turned);
  vtkPolyData* output = this->Run(501);
  for (vtkIdType tick = 0; tick <= 500; ++tick)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_NEAR(Get(output, "Force", tick, axis), Get(onGrid, "Force", tick, axis), 1e-6) << tick;
    }
  }

  // The voxels have 0.4 x 0.3 x 0.5 mm and are rotated by 30 degrees about z, and the extent does
  // not begin at 0. Both images have the same labels, except within a voxel of the faces between
  // labels.
  const double c = std::cos(vtkMath::Pi() / 6.0);
  const double s = std::sin(vtkMath::Pi() / 6.0);
  vtkNew<vtkImageData> fine;
  fine->SetExtent(-20, 70, -40, 60, 5, 40);
  fine->SetSpacing(0.4, 0.3, 0.5);
  fine->SetOrigin(1.0, 2.0, -2.5);
  fine->SetDirectionMatrix(c, -s, 0, s, c, 0, 0, 0, 1);
  fine->AllocateScalars(VTK_LONG_LONG, 1);
  for (vtkIdType point = 0; point < fine->GetNumberOfPoints(); ++point)
  {
    const double* const at = fine->GetPoint(point);
    fine->GetPointData()->GetScalars()->SetComponent(point, 0, labelAt(at[0], at[1]));
  }
  // PAPER passes only the proxy from tick to tick, so single ticks can be compared.
  this->Filter->SetSolverToPaper();
  SetConstant(this->Property->GetSurfaceStrength(), 0.0);
  this->Table->SetSurfaceStrength(3, 0.0);
  this->Filter->SetLabelData(
    MakeImage(16, VTK_UNSIGNED_CHAR, [&](const Point& p) { return labelAt(p[0], p[1]); }));
  this->Run(501);
  const auto coarse = Keep(this->Filter);
  this->Filter->SetLabelData(fine);
  output = this->Run(501);
  int compared = 0;
  for (vtkIdType tick = 1; tick <= 500; ++tick)
  {
    const double x = Get(output, "Tip", tick - 1, 0);
    const double y = Get(output, "Tip", tick - 1, 1);
    if (std::abs(x - 6.5) > 1.0 && (x < 6.5 || std::abs(y - 7.5) > 1.0))
    {
      ++compared;
      ASSERT_NEAR(Get(output, "Stiffness", tick), Get(coarse, "Stiffness", tick), 1e-6) << tick;
    }
  }
  EXPECT_GT(compared, 300);
}

TEST_F(LabelsTest, AreInTheTrace)
{
  this->Filter->SetPathData(MakePath(Line({ 3, 7, 5 }, { 20, 7, 5 }, 340)));
  SetConstant(this->Property->GetSurfaceStrength(), 0.0);
  EXPECT_EQ(this->Run(341)->GetPointData()->GetArray("Label"), nullptr) << "without labels";
  this->SetHalves();
  vtkPolyData* const output = this->Run(341);
  ASSERT_NE(output->GetPointData()->GetArray("Label"), nullptr);
  for (vtkIdType tick = 0; tick <= 340; ++tick)
  {
    // The label must be the label of the nearest voxel. The normal is along z.
    const double x = output->GetPoint(tick)[0];
    if (std::abs(x - 7.5) > 1e-6 && std::abs(x - 15.5) > 1e-6)
    {
      ASSERT_EQ(Get(output, "Label", tick), x < 7.5 ? 1.0 : x < 15.5 ? 2.0 : 0.0) << x;
    }
  }
}

TEST_F(LabelsTest, AreReadAgainAfterAChange)
{
  this->SetHalves();
  this->Table->SetStiffness(1, 200.0);
  EXPECT_NEAR(this->PressedForce(4.0), 200.0 * Depth, 1e-9);
  this->Table->SetStiffness(1, 300.0);
  EXPECT_NEAR(-Get(this->Run(51), "Force", Last, 2), 300.0 * Depth, 1e-9);
  auto* const labels = vtkImageData::SafeDownCast(this->Filter->GetInputDataObject(3, 0));
  labels->GetPointData()->GetScalars()->Fill(5.0);
  labels->GetPointData()->GetScalars()->Modified();
  labels->Modified();
  EXPECT_NEAR(-Get(this->Run(51), "Force", Last, 2), 500.0 * Depth, 1e-9);
  this->Filter->SetLabelData(nullptr);
  EXPECT_NEAR(-Get(this->Run(51), "Force", Last, 2), 500.0 * Depth, 1e-9);
}

TEST_F(LabelsTest, ThatAreForbiddenAreReadAgainAfterAChange)
{
  // The surface strength is 0, so only the wall in front of label 2, which begins at x = 7.5, stops
  // the proxy.
  SetConstant(this->Property->GetSurfaceStrength(), 0.0);
  this->SetHalves();
  this->Filter->SetPathData(MakePath(Line({ 3, 7, 7 }, { 10, 7, 7 }, 200)));
  const auto reached = [this] { return this->Run(201)->GetPoint(200)[0]; };
  EXPECT_EQ(reached(), 10.0);
  this->Table->SetForbidden(2, true);
  EXPECT_NEAR(reached(), 7.5, 0.1);
  this->Table->SetStandOff(2.0);
  EXPECT_NEAR(reached(), 5.5, 0.1);
  this->Table->SetStiffness(1, 900.0); // changes only materials, so the wall remains
  this->Table->SetStiffness(2, 900.0);
  EXPECT_NEAR(reached(), 5.5, 0.1);
  EXPECT_EQ(Get(this->Run(201), "Stiffness", 200), 900.0);
  this->Table->SetForbidden(2, false);
  EXPECT_EQ(reached(), 10.0);
  this->Table->SetForbidden(2, true);
  EXPECT_NEAR(reached(), 5.5, 0.1);
  this->Filter->SetLabelData(
    MakeImage(16, VTK_SHORT, [](const Point& p) { return p[0] < 8.5 ? 1.0 : 2.0; }));
  EXPECT_NEAR(reached(), 6.5, 0.1);
  this->Filter->SetLabelTable(nullptr);
  EXPECT_EQ(reached(), 10.0);
}

TEST_F(LabelsTest, AMillionOfThemCanBeTold)
{
  constexpr int side = 100;
  vtkNew<vtkImageData> labels;
  labels->SetDimensions(side, side, side);
  labels->SetSpacing(0.15, 0.15, 0.15);
  labels->AllocateScalars(VTK_INT, 1);
  for (vtkIdType point = 0; point < labels->GetNumberOfPoints(); ++point)
  {
    // Assign a separate label to each voxel, negative or positive.
    const auto label = static_cast<int>(point) - 500000;
    labels->GetPointData()->GetScalars()->SetComponent(point, 0, label);
    this->Table->SetStiffness(label, 100.0 + 1e-3 * static_cast<double>(point));
  }
  this->Filter->SetLabelData(labels);
  this->Filter->SetLabelTable(this->Table);
  this->Filter->SetSolverToPaper();
  this->Filter->SetPathData(MakePath(Line({ 4.05, 6.0, 4.5 }, { 4.05, 6.0, 4.55 }, 1)));
  // The material is read at x_s, two voxels of the image (2 mm) ahead of the proxy, which is the
  // voxel (27, 40, 130 / 3) of the labels.
  const double above = 6.5 / 0.15;
  const double k = std::floor(above);
  const auto stiffness = [](double i, double j, double at)
  { return 100.0 + 1e-3 * (i + side * (j + side * at)); };
  EXPECT_NEAR(Get(this->Run(2), "Stiffness", 1),
    stiffness(27, 40, k) + (above - k) * (stiffness(27, 40, k + 1.0) - stiffness(27, 40, k)), 1e-6);
}

TEST_F(LabelsTest, TooManyOfThemInThickSlicesAreTold)
{
  constexpr int side = 80;
  vtkNew<vtkImageData> labels;
  labels->SetDimensions(side, side, side + 2);
  labels->SetSpacing(0.2, 0.2, 0.6);
  labels->AllocateScalars(VTK_INT, 1);
  vtkDataArray* const array = labels->GetPointData()->GetScalars();
  for (vtkIdType point = 0; point < array->GetNumberOfTuples(); ++point)
  {
    array->SetComponent(point, 0, static_cast<double>(point % (side * side)));
  }
  this->Filter->SetLabelData(labels);
  this->Table->SetStiffness(1, 300.0);
  this->Filter->SetLabelTable(this->Table);
  this->Filter->SetGeometryFromLabels();
  this->Filter->Update();
  ASSERT_EQ(this->Log.Warnings.size(), 1U);
  EXPECT_NE(this->Log.Warnings[0].find("walls between labels are stairs"), std::string::npos);
  // Use the finer grid for fewer labels.
  for (vtkIdType point = 0; point < array->GetNumberOfTuples(); ++point)
  {
    array->SetComponent(point, 0, array->GetComponent(point, 0) < 3200.0 ? 1.0 : 0.0);
  }
  array->Modified();
  this->Filter->Update();
  EXPECT_EQ(this->Log.Warnings.size(), 1U);
}
