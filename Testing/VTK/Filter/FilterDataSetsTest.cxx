// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests data sets other than images, which are resampled around the path or the hand. Their fields
 * are linear, so cells and splines reproduce them exactly, and forces have closed forms.
 */

#include "Rigs/ApiRig.h"

#include <vtkAppendFilter.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExplicitStructuredGrid.h>
#include <vtkFloatArray.h>
#include <vtkHapticDevice.h>
#include <vtkHapticMode.h>
#include <vtkHapticRegionSource.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <chrono>
#include <cmath>
#include <thread>

using namespace apitest;

namespace
{
constexpr int Edge = 21;          // points along an edge
constexpr double HalfEdge = 16.0; // mm, half of the grid's edge
constexpr double PerMm = 0.5;     // stiffness of the spring (N/mm)

/// Adds a flow around the z axis, and scalars with the value 100 z.
void AddFields(vtkDataSet* data)
{
  vtkNew<vtkDoubleArray> flow;
  vtkNew<vtkDoubleArray> height;
  flow->SetName("flow");
  flow->SetNumberOfComponents(3);
  height->SetName("height");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double* const x = data->GetPoint(i);
    flow->InsertNextTuple3(-x[1], x[0], 0.0);
    height->InsertNextValue(100.0 * x[2]);
  }
  data->GetPointData()->AddArray(flow);
  data->GetPointData()->SetScalars(height);
}

/// Makes a grid whose points are denser in the middle.
vtkSmartPointer<vtkRectilinearGrid> MakeRectilinear()
{
  vtkNew<vtkDoubleArray> places;
  for (int i = 0; i < Edge; ++i)
  {
    const double t = 2.0 * i / (Edge - 1) - 1.0;
    places->InsertNextValue(HalfEdge * t * (0.7 + 0.3 * t * t));
  }
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetDimensions(Edge, Edge, Edge);
  grid->SetXCoordinates(places);
  grid->SetYCoordinates(places);
  grid->SetZCoordinates(places);
  AddFields(grid);
  return grid;
}

/// Makes a grid of sheared slabs between two heights.
vtkSmartPointer<vtkStructuredGrid> MakeStructured(double low, double high)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k < Edge; ++k)
  {
    for (int j = 0; j < Edge; ++j)
    {
      for (int i = 0; i < Edge; ++i)
      {
        const double z = low + (high - low) * k / (Edge - 1);
        points->InsertNextPoint(HalfEdge * (2.0 * i / (Edge - 1) - 1.0) + 0.1 * z,
          HalfEdge * (2.0 * j / (Edge - 1) - 1.0), z);
      }
    }
  }
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(Edge, Edge, Edge);
  grid->SetPoints(points);
  AddFields(grid);
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> MakeUnstructured(vtkDataSet* data)
{
  vtkNew<vtkAppendFilter> append;
  append->SetInputData(data);
  append->Update();
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->ShallowCopy(append->GetOutput());
  return grid;
}

/// Makes two blocks of different types, one for the lower half and one for the upper half.
vtkSmartPointer<vtkMultiBlockDataSet> MakeBlocks()
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, MakeUnstructured(MakeStructured(-HalfEdge, 0.0)));
  blocks->SetBlock(2, MakeStructured(0.0, HalfEdge));
  return blocks;
}

class FilterDataSets : public ApiTest
{
protected:
  FilterDataSets()
  {
    this->Follow->SetArrayName("flow");
    this->Filter->AddMode(this->Follow);
    this->Filter->SetMethodToPrimitives();
    this->Filter->SetPathData(MakePath(Line({ 8, 0, -1 }, { 9.4, 0, 1 }, 100)));
  }
  void ExpectFlow(vtkDataObject* data)
  {
    this->Filter->SetInputData(0, data);
    vtkPolyData* const trace = this->Run(101);
    // The proxy can only move along the flow, so the spring pulls outwards and along z.
    const double wanted[3] = { -1.4 * PerMm, 0.0, -2.0 * PerMm };
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(Get(trace, "Force", 100, c), wanted[c], 1e-4) << data->GetClassName();
    }
    EXPECT_NEAR(Get(trace, "Value", 100), -100.0, 0.01) << "of the scalars, at the proxy";
  }

  vtkNew<vtkHapticMode> Follow;
};

/// Sets the points of a grid to the eight corners of a unit cube, with the values 0 to 7.
void SetCorners(vtkPointSet* grid)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> values;
  values->SetName("height");
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(i % 2, i / 2 % 2, i / 4);
    values->InsertNextValue(static_cast<float>(i));
  }
  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(values);
}
} // namespace

TEST_F(FilterDataSets, AreFeltAsTheFieldThatTheyHold)
{
  this->ExpectFlow(MakeRectilinear());
  this->ExpectFlow(MakeStructured(-HalfEdge, HalfEdge));
  this->ExpectFlow(MakeUnstructured(MakeStructured(-HalfEdge, HalfEdge)));
  this->ExpectFlow(MakeBlocks());
  // The method Force Field uses only the scalars: the force is the gain times the gradient (eq. 1).
  this->Filter->SetMethodToForceField();
  this->Filter->SetForceFieldGain(0.01);
  vtkPolyData* const trace = this->Run(101);
  EXPECT_NEAR(Get(trace, "GradientMagnitude", 50), 100.0, 0.01);
  EXPECT_NEAR(std::abs(Get(trace, "Force", 50, 2)), 1.0, 1e-4);
}

TEST_F(FilterDataSets, MayHaveTheirFieldsInTheCells)
{
  const auto grid = MakeUnstructured(MakeRectilinear());
  vtkNew<vtkDoubleArray> flow;
  flow->SetName("spin");
  flow->SetNumberOfComponents(3);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    grid->GetCellBounds(cell, bounds);
    flow->InsertNextTuple3(-0.5 * (bounds[2] + bounds[3]), 0.5 * (bounds[0] + bounds[1]), 0.0);
  }
  grid->GetCellData()->AddArray(flow);
  this->Follow->SetArrayName("spin");
  this->Filter->SetInputData(0, grid);
  vtkPolyData* const trace = this->Run(101);
  // The averages of unequal cells differ slightly from the linear field.
  EXPECT_NEAR(Get(trace, "Force", 100, 0), -1.4 * PerMm, 0.02);
  EXPECT_NEAR(Get(trace, "Force", 100, 2), -2.0 * PerMm, 0.02);
}

TEST_F(FilterDataSets, AreFeltLiveAroundTheHand)
{
  this->Filter->SetInputData(0, MakeUnstructured(MakeRectilinear()));
  vtkNew<vtkHapticDevice> device;
  device->SetVolumeHaptics(this->Filter);
  ASSERT_TRUE(device->Open("virtual"));
  device->GetVirtualHand()->SetPosition(8.0, 0.0, -1.0);
  ASSERT_TRUE(device->Start());
  const auto await = [&](const std::function<bool()>& isDone)
  {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!isDone() && std::chrono::steady_clock::now() < end)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      device->UpdateState();
    }
    return isDone();
  };
  ASSERT_TRUE(await(
    [&] { return device->GetState()->GetTick() > 5 && device->GetState()->GetResidency() == 1.0; }))
    << device->GetStatusText();
  device->GetVirtualHand()->SetPosition(9.4, 0.0, 1.0);
  EXPECT_TRUE(
    await([&] { return std::abs(device->GetState()->GetComputedForce()[0] + 0.7) < 1e-3; }))
    << device->GetState()->GetComputedForce()[0];
  EXPECT_NEAR(device->GetState()->GetComputedForce()[2], -1.0, 1e-3);
  EXPECT_NEAR(device->GetState()->GetModeForce(0)[2], -1.0, 1e-3);
  // A tip outside the data must have no force.
  device->GetVirtualHand()->SetPosition(40.0, 0.0, 1.0);
  EXPECT_TRUE(await([&] { return std::abs(device->GetState()->GetComputedForce()[0]) < 1e-9; }));
}

TEST_F(FilterDataSets, ThatCanNotBeFeltGiveOneErrorWithTheCure)
{
  const vtkNew<vtkUnstructuredGrid> empty;
  this->Filter->SetInputData(0, empty);
  this->ExpectError({ "vtkUnstructuredGrid", "port 0", "no cells", "vtkDelaunay3D" });
  const auto flat = MakeStructured(0.0, 0.0);
  this->Filter->SetInputData(0, flat);
  this->ExpectError({ "vtkStructuredGrid", "port 0", "no volume" });
  const auto grid = MakeRectilinear();
  this->Filter->SetInputData(0, grid);
  this->Follow->SetArrayName("wind");
  this->ExpectError({ "vtkRectilinearGrid", "port 0", "\"wind\"", "flow" });
  this->Follow->SetArrayName("height");
  this->ExpectError({ "\"height\"", "1 component(s)", "SetArrayName()" });
  this->Filter->RemoveAllModes();
  grid->GetPointData()->Initialize();
  grid->Modified();
  this->ExpectError({ "vtkRectilinearGrid", "no numeric point or cell array" });
}

TEST_F(FilterDataSets, WithCellsThatMakeNoSenseAreRefused)
{
  const auto make = [](int kind, std::initializer_list<vtkIdType> corners)
  {
    const vtkIdType good[] = { 0, 1, 2, 4 };
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    SetCorners(grid);
    grid->InsertNextCell(VTK_TETRA, 4, good);
    vtkNew<vtkCellArray> cells;
    cells->DeepCopy(grid->GetCells());
    cells->InsertNextCell(corners);
    grid->SetCells(VTK_TETRA, cells);
    grid->GetCellTypesArray()->SetValue(
      1, static_cast<unsigned char>(kind)); // SetCells() reads faces
    return grid;
  };
  this->Filter->SetInputData(0, make(VTK_TETRA, { 7, 4, 5, 999999999 }));
  this->ExpectError({ "vtkUnstructuredGrid", "port 0", "point that does not exist" });
  this->Filter->SetInputData(0, make(VTK_TETRA, { 7, 4, 5, -1 }));
  this->ExpectError({ "point that does not exist" });
  this->Filter->SetInputData(0, make(VTK_HEXAHEDRON, { 7, 4, 5, 6 }));
  this->ExpectError({ "fewer corners" });
  this->Filter->SetInputData(0, make(VTK_POLYHEDRON, { 7, 4, 5, 6 }));
  this->ExpectError({ "polyhedra without faces" });
  vtkNew<vtkHapticRegionSource> source;
  EXPECT_TRUE(source->OpenDataSet(make(VTK_TETRA, { 7, 4, 5, 6 }), 0.5, "height"));

  // an offset before the list, one smaller than the offset before it, and one past the list's end
  for (const vtkIdType offset : { -4, 3, 9 })
  {
    const auto grid = make(VTK_TETRA, { 7, 4, 5, 6 });
    vtkDataArray* const offsets = grid->GetCells()->GetOffsetsArray();
    offsets->SetComponent(offset == 3 ? 2 : 1, 0, static_cast<double>(offset));
    this->Filter->SetInputData(0, grid);
    this->ExpectError({ "point that does not exist" });
  }
  const auto untyped = make(VTK_TETRA, { 7, 4, 5, 6 });
  untyped->GetCellTypesArray()->SetNumberOfValues(1);
  this->Filter->SetInputData(0, untyped);
  this->ExpectError({ "fewer cells" });
}

TEST_F(FilterDataSets, WithFacesOfOtherCellsAreRefused)
{
  const auto make = [](vtkIdType last)
  {
    const vtkIdType corners[] = { 0, 1, 2, 4 };
    const vtkIdType faces[] = { 3, 0, 1, 2, 3, 0, 1, 4, 3, 0, 2, 4, 3, 1, 2, last };
    vtkNew<vtkUnstructuredGrid> grid;
    SetCorners(grid);
    grid->InsertNextCell(VTK_POLYHEDRON, 4, corners, 4, faces);
    return vtkSmartPointer<vtkUnstructuredGrid>(grid);
  };
  vtkNew<vtkHapticRegionSource> source;
  EXPECT_TRUE(source->OpenDataSet(make(4), 0.1, "height"));
  for (const vtkIdType last : { vtkIdType{ 999999999 }, vtkIdType{ -1 }, vtkIdType{ 7 } })
  {
    this->Filter->SetInputData(0, make(last));
    this->ExpectError({ "faces that do not exist" });
  }
}

TEST_F(FilterDataSets, ThatAreExplicitGridsWithCellsThatMakeNoSenseAreRefused)
{
  const auto make = [](vtkIdType last, int count)
  {
    const vtkIdType corners[] = { 0, 1, 3, 2, 4, 5, 7, last };
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell(count, corners);
    vtkNew<vtkExplicitStructuredGrid> grid;
    grid->SetDimensions(2, 2, 2);
    SetCorners(grid);
    grid->SetCells(cells);
    return vtkSmartPointer<vtkExplicitStructuredGrid>(grid);
  };
  vtkNew<vtkHapticRegionSource> source;
  EXPECT_TRUE(source->OpenDataSet(make(6, 8), 0.1, "height"));
  this->Filter->SetInputData(0, make(999999999, 8));
  this->ExpectError({ "point that does not exist" });
  this->Filter->SetInputData(0, make(6, 7));
  this->ExpectError({ "fewer corners" });
}

TEST_F(FilterDataSets, AreResampledWithASpacingOfTheUsersChoice)
{
  vtkNew<vtkHapticRegionSource> source;
  ASSERT_TRUE(source->OpenDataSet(MakeRectilinear(), 0.5, "flow"));
  EXPECT_EQ(source->GetSpacing()[1], 0.5);
  EXPECT_EQ(source->GetWholeExtent()[5], 64);
  vtkNew<vtkImageData> image;
  const int region[6] = { 20, 30, 31, 33, 60, 64 };
  ASSERT_TRUE(source->ReadRegion(region, image));
  vtkDataArray* const flow = image->GetPointData()->GetArray("flow");
  ASSERT_TRUE(flow);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* const x = image->GetPoint(i);
    EXPECT_NEAR(flow->GetComponent(i, 0), -x[1], 1e-5);
    EXPECT_NEAR(image->GetPointData()->GetScalars()->GetComponent(i, 0), 100.0 * x[2], 1e-3);
  }
}
