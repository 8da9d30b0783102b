// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Expects that a hand can follow the planned path, and that the path touches the intended tissues.
#include "Applications/Explorer/Exploration/TissueTable.h"
#include "Expectations.h"
#include "HeadExploration.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>

namespace
{
/// Computes the highest speed (m/s) and the highest acceleration (m/s^2) along the path.
void Motion(const Explore::Exploration& e, double& speed, double& acceleration)
{
  double last[3] = { 0, 0, 0 };
  for (vtkIdType i = 1; i < e.Tip.Path->GetNumberOfPoints(); ++i)
  {
    double a[3], b[3], velocity[3], change = 0.0, size = 0.0;
    e.Tip.Path->GetPoint(i - 1, a);
    e.Tip.Path->GetPoint(i, b);
    for (int axis = 0; axis < 3; ++axis)
    {
      velocity[axis] = (b[axis] - a[axis]) * e.Values.MetersPerWorldUnit * e.ServoRate;
      size += velocity[axis] * velocity[axis];
      change += std::pow(velocity[axis] - last[axis], 2);
      last[axis] = velocity[axis];
    }
    speed = std::max(speed, std::sqrt(size));
    acceleration = std::max(acceleration, std::sqrt(change) * e.ServoRate);
  }
}

/// Returns the tissues in contact during a phase, by an array of the trace: `Value` at the proxy,
/// or `SurfaceValue`, the value of the surface that is felt.
std::set<std::string> Touched(
  const Explore::Exploration& e, const std::string& phase, const char* array)
{
  const std::vector<Explore::Tissue> tissues = Explore::MakeTissueTable(e.Values);
  vtkDataArray* contact = e.Trace->GetPointData()->GetArray("Contact");
  vtkDataArray* value = e.Trace->GetPointData()->GetArray(array);
  std::set<std::string> names;
  for (const Explore::Phase& p : e.Tip.Phases)
  {
    for (vtkIdType i = p.First; p.Name == phase && i < p.Last; ++i)
    {
      if (contact->GetComponent(i, 0) > 0.0)
      {
        names.insert(tissues[Explore::FindTissue(tissues, value->GetComponent(i, 0))].Name);
      }
    }
  }
  return names;
}

} // namespace

int TestExploreTipPath(int argc, char* argv[])
{
  const Explore::Exploration e = ExploreHead(argc, argv);
  double speed = 0.0, acceleration = 0.0;
  Motion(e, speed, acceleration);
  const double seconds = e.Tip.Path->GetNumberOfPoints() / e.ServoRate;
  std::cout << seconds << " s, " << speed << " m/s, " << acceleration << " m/s^2\n";
  Expect(speed > 0.02 && speed < 0.1001, "the hand moves with 0.1 m/s at most");
  Expect(acceleration < 5.0, "the hand does not jerk");
  Expect(seconds > 5.0 && seconds < 12.0, "it takes some seconds");
  Expect(e.Trace->GetNumberOfPoints() == e.Tip.Path->GetNumberOfPoints(), "a point a tick");
  Expect(
    e.Tip.Phases.front().First == 0 && e.Tip.Phases.back().Last == e.Tip.Path->GetNumberOfPoints(),
    "the phases cover the path");

  Expect(Touched(e, "slide outside", "Value").count("bone") == 0, "it slides outside the bone");
  Expect(!Touched(e, "slide outside", "Value").empty(), "it touches what it slides over");
  Expect(Touched(e, "slide inside", "SurfaceValue").count("bone") == 1, "it slides over bone");
  double force[3];
  vtkDataArray* forces = e.Trace->GetPointData()->GetArray("Force");
  forces->GetTuple(0, force);
  Expect(force[0] == 0.0 && force[1] == 0.0 && force[2] == 0.0, "it begins without force");
  forces->GetTuple(forces->GetNumberOfTuples() - 1, force);
  Expect(std::hypot(force[0], force[1], force[2]) < 0.1, "it ends without force");
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
