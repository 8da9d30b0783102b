// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Opens grids of all kinds. The flow of a rotating block, (-y, x, 0), and the pressure x + 2 y are
// linear, so every way of resampling reproduces the formulas. By default, the hand follows the
// flow.
#include "Applications/Explorer/Exploration/ModeChoice.h"
#include "Applications/Explorer/Exploration/TissueTable.h"
#include "Applications/Explorer/Report/TraceSummary.h"
#include "Expectations.h"
#include "HeadExploration.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/VolumeSeries.h"

#include "vtkAppendFilter.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkHapticMode.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLDataObjectWriter.h"
#include "vtkXMLMultiBlockDataWriter.h"

#include <vtksys/FStream.hxx>

#include <cmath>

namespace
{
constexpr int EDGE = 21; // points along an edge of a block of 20 mm

/// Returns a block of hexahedra whose x begins at `left`, with or without an array of velocities.
vtkSmartPointer<vtkStructuredGrid> MakeBlock(double left, bool flows)
{
  auto block = vtkSmartPointer<vtkStructuredGrid>::New();
  block->SetDimensions(EDGE, EDGE, EDGE);
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> flow;
  flow->SetName("U");
  flow->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> pressure;
  pressure->SetName("p");
  for (int i = 0; i < EDGE * EDGE * EDGE; ++i)
  {
    const double x = left + i % EDGE;
    const double y = i / EDGE % EDGE - 10.0;
    points->InsertNextPoint(x, y, i / (EDGE * EDGE) - 10.0);
    flow->InsertNextTuple3(-y, x, 0.0);
    pressure->InsertNextValue(static_cast<float>(x + 2.0 * y));
  }
  block->SetPoints(points);
  if (flows)
  {
    block->GetPointData()->AddArray(flow);
  }
  block->GetPointData()->AddArray(pressure);
  return block;
}

std::string WriteGrid(const std::string& name, vtkDataObject* data)
{
  const std::string path = folder + "/" + name;
  vtkSmartPointer<vtkXMLWriter> writer = vtkSmartPointer<vtkXMLMultiBlockDataWriter>::New();
  if (data->IsA("vtkDataSet"))
  {
    writer.TakeReference(vtkXMLDataObjectWriter::NewWriter(data->GetDataObjectType()));
  }
  writer->SetFileName(path.c_str());
  writer->SetInputDataObject(data);
  writer->Write();
  return path;
}

/// Expects the arrays to have the formulas' values at all samples.
void ExpectFormulas(const std::string& path)
{
  const Explore::Volume volume = Explore::LoadVolumes({ path });
  vtkDataArray* const flow = volume.Image->GetPointData()->GetArray("U");
  vtkDataArray* const speed = volume.Image->GetPointData()->GetScalars();
  Expect(volume.IsGrid && volume.Flow == "U" && flow, path + " has a flow");
  double worst = flow && speed ? 0.0 : 1.0;
  for (vtkIdType i = 0; worst < 1.0 && i < volume.Image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    volume.Image->GetPoint(i, x);
    worst = std::max({ worst, std::abs(flow->GetComponent(i, 0) + x[1]),
      std::abs(flow->GetComponent(i, 1) - x[0]), std::abs(flow->GetComponent(i, 2)),
      std::abs(speed->GetComponent(i, 0) - std::hypot(x[0], x[1])) });
  }
  Expect(worst < 1e-4 && volume.Image->GetNumberOfPoints() > 20 * 20 * 20,
    path + " is resampled as it is, but for " + std::to_string(worst));
  const Explore::Volume chosen = Explore::LoadVolumes({ path }, false, 0, "p");
  double x[3];
  chosen.Image->GetPoint(1000, x);
  const double there = chosen.Image->GetPointData()->GetScalars()->GetComponent(1000, 0);
  Expect(std::abs(there - x[0] - 2.0 * x[1]) < 1e-4, path + " has pressures");
  Expect(chosen.Flow.empty(), "whoever wants pressures does not follow the flow");
}

/// Expects the outline of a block: exactly its 12 edges, with one line per cell.
void ExpectOutline(const std::string& path)
{
  const vtkSmartPointer<vtkPolyData> outline = Explore::LoadVolumes({ path }).Outline;
  double bounds[6] = { 0, 0, 0, 0, 0, 0 };
  if (outline)
  {
    outline->GetBounds(bounds);
  }
  bool isEdge = outline && outline->GetNumberOfLines() == 12 * (EDGE - 1);
  for (vtkIdType i = 0; isEdge && i < outline->GetNumberOfPoints(); ++i)
  {
    double x[3];
    outline->GetPoint(i, x);
    int borders = 0;
    for (int a = 0; a < 3; ++a)
    {
      borders += std::abs(std::abs(x[a]) - 10.0) < 1e-6 ? 1 : 0;
    }
    isEdge = borders >= 2;
  }
  Expect(isEdge && bounds[0] == -10.0 && bounds[1] == 10.0 && bounds[5] == 10.0,
    path + " has its edges as outline");
}

/// Expects a box as the outline of a block that is inflated into a ball, since a ball has no edges.
void ExpectBox()
{
  const vtkSmartPointer<vtkStructuredGrid> ball = MakeBlock(-10.0, false);
  for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
  {
    double x[3];
    ball->GetPoint(i, x);
    const double square[3] = { 0.01 * x[0] * x[0], 0.01 * x[1] * x[1], 0.01 * x[2] * x[2] };
    for (int a = 0; a < 3; ++a)
    {
      const double b = square[(a + 1) % 3];
      const double c = square[(a + 2) % 3];
      x[a] *= std::sqrt(1.0 - 0.5 * b - 0.5 * c + b * c / 3.0);
    }
    ball->GetPoints()->SetPoint(i, x);
  }
  const std::string path = WriteGrid("ball.vts", ball);
  const vtkSmartPointer<vtkPolyData> outline = Explore::LoadVolumes({ path }).Outline;
  Expect(outline && outline->GetNumberOfLines() == 12 && outline->GetNumberOfPoints() == 8,
    "a ball has a box around it");
}

void ExpectGridError(
  const std::string& path, const std::string& fault, const std::string& array = "")
{
  std::string message = "nothing";
  try
  {
    Explore::LoadVolumes({ path }, false, 0, array);
  }
  catch (const Explore::InputError& error)
  {
    message = error.what();
  }
  Expect(message.find(fault) != std::string::npos && message.find("Cure: ") != std::string::npos,
    path + " should say '" + fault + "', but said: " + message);
}

std::string WriteWords(const std::string& name, const char* words = "this is no grid\n")
{
  const std::string path = folder + "/" + name;
  vtksys::ofstream(path.c_str()) << words;
  return path;
}
} // namespace

int TestExploreGrids(int argc, char* argv[])
{
  folder = MakeTestFolder(argc, argv, "TestExploreGrids");
  const vtkSmartPointer<vtkStructuredGrid> whole = MakeBlock(-10.0, true);
  vtkNew<vtkAppendFilter> append;
  append->SetInputData(whole);
  append->Update();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeBlock(-10.0, true));
  blocks->SetBlock(1, MakeBlock(10.0, true));
  const std::string cells = WriteGrid("block.vtu", append->GetOutput());
  ExpectFormulas(cells);
  ExpectFormulas(WriteGrid("block.vts", whole));
  ExpectOutline(cells);
  ExpectOutline(folder + "/block.vts");
  ExpectBox();
  ExpectFormulas(WriteGrid("blocks.vtm", blocks));

  const Explore::Exploration e =
    Explore::ExploreVolume(Explore::LoadVolumes({ cells }), Explore::Settings());
  Expect(e.Filter->GetMethod() == vtkVolumeHapticsFilter::PRIMITIVES, "modes are felt");
  std::string modes;
  for (int i = 0; i < e.Filter->GetNumberOfModes(); ++i)
  {
    vtkHapticMode* const mode = e.Filter->GetMode(i);
    modes += std::string(mode->GetActive() ? "+" : " -") + mode->GetText();
  }
  Expect(modes.rfind("+vector follow, U -vector front, U -vortex, U", 0) == 0,
    "the flow is followed, and other modes are offered: " + modes);
  const std::vector<std::string> named = Explore::NameModes(e.Filter);
  Expect(
    named.size() > 2 && named[0] == "1 vector follow, U" && named[1].empty() && named[2].empty(),
    "the picture names those that are felt");
  vtkDataArray* const force = e.Trace->GetPointData()->GetArray("ModeForce_0");
  Expect(force && force->GetMaxNorm() > 0.01, "the flow is felt");
  Expect(e.Values.Kind == Explore::VolumeKind::Field && Explore::MakeTissueTable(e.Values).empty(),
    "a flow has no tissues");
  const std::string told = Explore::Summarise(e);
  Expect(told.find("background") == std::string::npos && told.find("tissue") == std::string::npos &&
      told.find("Contact state") != std::string::npos,
    "and the summary names none: " + told);

  // A grid without velocities is explored like an image.
  const std::string still = WriteGrid("still.vts", MakeBlock(-10.0, false));
  const Explore::Exploration plain =
    Explore::ExploreVolume(Explore::LoadVolumes({ still }), Explore::Settings());
  Expect(plain.Filter->GetMethod() == vtkVolumeHapticsFilter::PROXY, "a grid has surfaces, too");
  Expect(Explore::Summarise(plain).find(", value ") != std::string::npos, "which have values");

  ExpectGridError(cells, "use one of 'U'", "T");
  for (const char* const name : { "words.vtu", "words.vtm", "words.vtk", "words.case" })
  {
    ExpectGridError(WriteWords(name), "cannot be read as");
  }
  vtkNew<vtkUnstructuredGrid> flat;
  vtkNew<vtkPoints> corners;
  const vtkIdType triangle[3] = { corners->InsertNextPoint(0.0, 0.0, 0.0),
    corners->InsertNextPoint(1.0, 0.0, 0.0), corners->InsertNextPoint(0.0, 1.0, 0.0) };
  flat->SetPoints(corners);
  flat->InsertNextCell(VTK_TRIANGLE, 3, triangle);
  ExpectGridError(WriteGrid("flat.vtu", flat), "no volume");
  ExpectGridError(WriteWords("nothing.vtu", ""), "is empty");
  ExpectGridError(WriteWords("alone.foam", ""), "cannot be read as OpenFOAM case");
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
