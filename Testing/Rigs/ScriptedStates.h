// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Makes device states from a formula. */
#ifndef ScriptedStates_h
#define ScriptedStates_h

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

#include <cmath>

namespace scenetest
{

/// Returns a table of states at 1 kHz between two times (s), with the normal force `normal` and
/// matching values.
template <typename F>
vtkSmartPointer<vtkTable> MakeStates(double from, double to, F&& normal)
{
  auto states = vtkSmartPointer<vtkTable>::New();
  const char* const names[] = { "Time", "NormalForce", "FrictionForce", "DragForce", "Command" };
  vtkNew<vtkDoubleArray> columns[5];
  for (int c = 0; c < 5; ++c)
  {
    columns[c]->SetName(names[c]);
    columns[c]->SetNumberOfComponents(c == 4 ? 3 : 1);
    states->AddColumn(columns[c]);
  }
  const int ticks = static_cast<int>(std::lround(1000.0 * (to - from)));
  for (int i = 0; i < ticks; ++i)
  {
    const double t = from + 0.001 * i;
    const double force = normal(t);
    columns[0]->InsertNextValue(t);
    columns[1]->InsertNextValue(force);
    columns[2]->InsertNextValue(0.3 * force);
    columns[3]->InsertNextValue(0.1 * force);
    columns[4]->InsertNextTuple3(-0.3 * force, 0.1 * force, -force);
  }
  return states;
}
} // namespace scenetest

#endif
