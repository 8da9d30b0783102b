// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Recording/HapticStateTable.h"

#include "vtkDoubleArray.h"
#include "vtkTable.h"

#include <algorithm>

namespace VolumeHaptics
{

StateRow::StateRow(const ServoSnapshot& state)
  : Tip(state.Record.Tip)
  , Proxy(state.Record.Proxy)
  , Force(state.Record.Force)
  , Command(state.Command)
  , Orientation(state.Orientation)
  , Time(state.Time)
  , NormalForce(state.Record.NormalForce)
  , FrictionForce(state.Record.FrictionForce)
  , DragForce(state.Record.DragForce)
  , SurfaceValue(state.Record.SurfaceValue)
  , Residency(state.Residency)
  , Tick(state.Tick)
  , Generation(state.Generation)
  , Contact(state.Record.Contact)
  , Fault(state.GetFault())
  , Armed(state.IsArmed())
  , HasOrientation(state.HasOrientation)
{
  std::transform(state.Modes.begin(), state.Modes.end(), this->ModeForces.begin(),
    [](const Vector3& force) { return static_cast<float>(Norm(force)); });
}

StateTable::StateTable()
{
  static const char* const scalars[] = { "Time", "Tick", "NormalForce", "FrictionForce",
    "DragForce", "SurfaceValue", "Contact", "Armed", "Fault", "Residency" };
  static const char* const vectors[] = { "Tip", "Proxy", "Force", "Command" };
  for (int i = 0; i < Scalars; ++i)
  {
    this->ScalarColumns[i]->SetName(scalars[i]);
  }
  for (int i = 0; i < Vectors; ++i)
  {
    this->VectorColumns[i]->SetName(vectors[i]);
    this->VectorColumns[i]->SetNumberOfComponents(3);
  }
  this->Orientations->SetName("Orientation");
  this->Orientations->SetNumberOfComponents(4);
  this->ModeForces->SetName("ModeForces");
  this->ModeForces->SetNumberOfComponents(MostPrimitives);
}

StateTable::~StateTable() = default;

void StateTable::Append(const StateRow& state, const Affine3& toWorld)
{
  const double scalars[Scalars] = { state.Time, static_cast<double>(state.Tick), state.NormalForce,
    state.FrictionForce, state.DragForce, state.SurfaceValue, static_cast<double>(state.Contact),
    state.Armed ? 1.0 : 0.0, static_cast<double>(state.Fault), state.Residency };
  const Matrix3 rotation = RotationOf(toWorld);
  const Vector3 vectors[Vectors] = { toWorld(state.Tip), toWorld(state.Proxy),
    rotation * state.Force, rotation * state.Command };
  for (int i = 0; i < Scalars; ++i)
  {
    this->ScalarColumns[i]->InsertNextValue(scalars[i]);
  }
  for (int i = 0; i < Vectors; ++i)
  {
    this->VectorColumns[i]->InsertNextTuple3(vectors[i].X, vectors[i].Y, vectors[i].Z);
  }
  const Quaternion q = TurnedBy(rotation, state.Orientation, state.HasOrientation);
  this->Orientations->InsertNextTuple4(q.W, q.X, q.Y, q.Z);
  this->ModeForces->InsertNextTuple(state.ModeForces.data());
}

void StateTable::WriteTo(vtkTable* table)
{
  table->Initialize();
  for (const auto& column : this->ScalarColumns)
  {
    table->AddColumn(column);
  }
  for (const auto& column : this->VectorColumns)
  {
    table->AddColumn(column);
  }
  table->AddColumn(this->Orientations);
  table->AddColumn(this->ModeForces);
}

} // namespace VolumeHaptics
