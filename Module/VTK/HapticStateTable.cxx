// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticStateTable.h"

#include "vtkDoubleArray.h"
#include "vtkTable.h"

namespace VolumeHaptics
{

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
}

StateTable::~StateTable() = default;

void StateTable::Append(const ServoSnapshot& state, const Affine3& toWorld)
{
  const TickRecord& record = state.Record;
  const double scalars[Scalars] = { state.Time, static_cast<double>(state.Tick), record.NormalForce,
    record.FrictionForce, record.DragForce, record.SurfaceValue,
    static_cast<double>(record.Contact), state.Armed ? 1.0 : 0.0, static_cast<double>(state.Fault),
    state.Residency };
  const Matrix3 rotation = (1.0 / std::cbrt(Determinant(toWorld.Linear))) * toWorld.Linear;
  const Vector3 vectors[Vectors] = { toWorld(record.Tip), toWorld(record.Proxy),
    rotation * record.Force, rotation * state.Command };
  for (int i = 0; i < Scalars; ++i)
  {
    this->ScalarColumns[i]->InsertNextValue(scalars[i]);
  }
  for (int i = 0; i < Vectors; ++i)
  {
    this->VectorColumns[i]->InsertNextTuple3(vectors[i].X, vectors[i].Y, vectors[i].Z);
  }
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
}

} // namespace VolumeHaptics
