// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Tests --guide: a hand over the head is guided along a line, on a surface, or along a recorded
// path. Unsuitable files must cause an error message.
#include "Applications/Explorer/Exploration/ModeChoice.h"
#include "Applications/Explorer/HelpText.h"
#include "Applications/Explorer/Options.h"
#include "Expectations.h"
#include "HeadExploration.h"
#include "VTK/Reading/InputError.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkHapticGuideMode.h"
#include "vtkHapticMeasurements.h"
#include "vtkLineSource.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataWriter.h"
#include "vtkSTLWriter.h"
#include "vtkSphereSource.h"
#include "vtkXMLPolyDataWriter.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace
{
Explore::Options ParseGuide(std::vector<std::string> more)
{
  more.insert(more.begin(), { "explore", "head.vti", "--guide" });
  std::vector<char*> arguments;
  for (std::string& word : more)
  {
    arguments.push_back(&word[0]);
  }
  return Explore::ParseOptions(static_cast<int>(arguments.size()), arguments.data());
}

template <typename Writer>
std::string Write(const std::string& file, vtkPolyData* shape)
{
  vtkNew<Writer> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(shape);
  writer->Write();
  return file;
}

/// Returns a line along x through the middle of the head that ends far beyond the head.
vtkSmartPointer<vtkPolyData> MakeLine(vtkImageData* head)
{
  const double* const b = head->GetBounds();
  vtkNew<vtkLineSource> line;
  const double y = 0.5 * (b[2] + b[3]);
  const double z = 0.5 * (b[4] + b[5]);
  line->SetPoint1(b[0] - 500.0, y, z);
  line->SetPoint2(b[1] + 500.0, y, z);
  line->Update();
  return line->GetOutput();
}

/// Expects that a line pulls perpendicularly towards itself with at most 2 N.
void ExpectLed(const Explore::Exploration& e, vtkPolyData* line)
{
  vtkPointData* const trace = e.Trace->GetPointData();
  vtkDataArray* const force = trace->GetArray("ModeForce_0");
  vtkDataArray* const tip = trace->GetArray("Tip");
  const double* const end = line->GetPoint(0);
  double largest = 0.0;
  double along = 0.0;
  bool isToTheLine = true;
  for (vtkIdType i = 0; i < force->GetNumberOfTuples(); ++i)
  {
    double f[3];
    double x[3];
    force->GetTuple(i, f);
    tip->GetTuple(i, x);
    largest = std::max(largest, std::sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]));
    along = std::max(along, std::abs(f[0]));
    isToTheLine = isToTheLine && f[1] * (end[1] - x[1]) + f[2] * (end[2] - x[2]) >= -1e-12;
  }
  Expect(std::abs(largest - 2.0) < 1e-6, "far from the line it pulls with 2 N");
  Expect(along < 1e-9, "nothing pulls along the line");
  Expect(isToTheLine, "the force is to the line");
}

std::string FindError(const std::string& file, vtkImageData* head)
{
  try
  {
    const Explore::Options options = ParseGuide({ file });
    vtkNew<vtkVolumeHapticsFilter> filter;
    Explore::AddModes({}, "", options.How.Guide, head, filter);
  }
  catch (const Explore::InputError& error)
  {
    return error.what();
  }
  return "nothing";
}

void ExpectErrors(const std::string& folder, vtkImageData* head)
{
  const auto expect = [head](const std::string& file, const std::string& fault)
  {
    const std::string said = FindError(file, head);
    Expect(said.find("--guide") != std::string::npos && said.find(file) != std::string::npos &&
        said.find(fault) != std::string::npos,
      "--guide " + file + " gives " + said);
  };
  expect("plan.step", "unknown extension");
  expect(folder + "/missing.vtp", "there is no such file");
  std::ofstream(folder + "/junk.vtk") << "junk\n";
  expect(folder + "/junk.vtk", "can't be read");
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkPoints> point;
  point->InsertNextPoint(head->GetCenter());
  nothing->SetPoints(point);
  expect(Write<vtkXMLPolyDataWriter>(folder + "/nothing.vtp", nothing), "no line and no polygons");
  vtkNew<vtkSphereSource> far;
  far->SetCenter(1e6, 0.0, 0.0);
  far->Update();
  expect(
    Write<vtkSTLWriter>(folder + "/far.stl", far->GetOutput()), "lies entirely outside the volume");
  vtkNew<vtkHapticMeasurements> distance;
  const double a[3] = { 0.0, 0.0, 0.0 };
  const double b[3] = { 10.0, 0.0, 0.0 };
  distance->AddDistance(a, b);
  Expect(distance->WriteFile((folder + "/distance.csv").c_str()), "measurements are written");
  expect(folder + "/distance.csv", "have no path");
}
} // namespace

int TestExploreGuide(int argc, char* argv[])
{
  const std::string folder = MakeTestFolder(argc, argv, "guide");
  const vtkSmartPointer<vtkImageData> head = LoadHead(argc, argv);
  const vtkSmartPointer<vtkPolyData> line = MakeLine(head);
  Expect(Explore::HelpText().find("--guide FILE") != std::string::npos, "the help tells of it");
  const std::string plan = Write<vtkXMLPolyDataWriter>(folder + "/plan.vtp", line);
  const Explore::Options options = ParseGuide({ plan });
  Expect(options.How.Method == "primitives", "a guide chooses its method");
  const Explore::Exploration e = ExploreHead(argc, argv, options.How);
  Expect(e.Filter->GetNumberOfModes() == 2 && e.Filter->GetMode(0)->GetActive() &&
      !e.Filter->GetMode(1)->GetActive(),
    "the guide is felt, the surfaces are offered");
  Expect(Explore::NameModes(e.Filter)[0].find("guide") != std::string::npos, "it has a name");
  ExpectLed(e, line);
  const Explore::Exploration both =
    ExploreHead(argc, argv, ParseGuide({ plan, "--mode=surface" }).How);
  Expect(both.Filter->GetNumberOfModes() == 2 && both.Filter->GetMode(1)->GetActive(),
    "a mode that is named is felt, too");

  // Read a legacy file with the same line, a recorded path with this line, and a surface.
  const auto read = [head](const std::string& file)
  {
    vtkNew<vtkVolumeHapticsFilter> filter;
    Explore::AddModes({}, "", ParseGuide({ file }).How.Guide, head, filter);
    return vtkSmartPointer<vtkHapticGuideMode>(
      vtkHapticGuideMode::SafeDownCast(filter->GetMode(0)));
  };
  const auto old = read(Write<vtkPolyDataWriter>(folder + "/plan.vtk", line));
  Expect(old && old->GetPath() && !old->GetSurface(), "a .vtk leads along its line");
  vtkNew<vtkHapticMeasurements> measured;
  vtkNew<vtkPolyData> felt;
  felt->DeepCopy(line);
  for (const char* const name : { "Time", "Force", "SurfaceValue" })
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(std::string(name) == "Force" ? 3 : 1);
    array->SetNumberOfTuples(felt->GetNumberOfPoints());
    array->Fill(1.0);
    felt->GetPointData()->AddArray(array);
  }
  measured->AddMeasurement(vtkHapticMeasurements::PATH, felt);
  const double corner[3] = { 1.0, 2.0, 3.0 };
  measured->AddPoint(corner);
  for (const char* const name : { "/path.vtp", "/path.csv" })
  {
    Expect(measured->WriteFile((folder + name).c_str()), "measurements are written");
    const auto guide = read(folder + name);
    Expect(guide && guide->GetPath()->GetNumberOfLines() == 1 &&
        guide->GetPath()->GetNumberOfPoints() == 2 &&
        guide->GetPath()->GetPoint(1)[0] == line->GetPoint(1)[0],
      "only the measured path leads");
  }
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(head->GetCenter());
  sphere->SetRadius(20.0);
  sphere->Update();
  const auto surface = read(Write<vtkSTLWriter>(folder + "/plan.stl", sphere->GetOutput()));
  Expect(surface && surface->GetSurface() && !surface->GetPath(), "triangles hold the hand");
  ExpectErrors(folder, head);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
