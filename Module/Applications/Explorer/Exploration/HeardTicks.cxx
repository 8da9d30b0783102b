// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Exploration/HeardTicks.h"

#include "vtkDataArray.h"
#include "vtkHapticLabelTable.h"
#include "vtkHapticProperty.h"
#include "vtkMath.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Explore
{
struct HeardTicks::Columns
{
  vtkIdType Count;
  vtkDataArray *Time, *Proxy, *Force, *Command, *NormalForce, *FrictionForce, *Contact,
    *SurfaceValue, *Label;
};

HeardTicks::HeardTicks(vtkVolumeHapticsFilter* filter)
  : Filter(filter)
{
}

std::vector<SoundTick> HeardTicks::Read(vtkTable* states, std::int64_t label)
{
  const auto find = [states](const char* name)
  { return vtkDataArray::SafeDownCast(states->GetColumnByName(name)); };
  return this->Read(
    { states->GetNumberOfRows(), find("Time"), find("Proxy"), find("Force"), find("Command"),
      find("NormalForce"), find("FrictionForce"), find("Contact"), find("SurfaceValue"), nullptr },
    label);
}

std::vector<SoundTick> HeardTicks::Read(vtkPolyData* trace)
{
  const auto find = [trace](const char* name) { return trace->GetPointData()->GetArray(name); };
  return this->Read({ trace->GetNumberOfPoints(), find("Time"), trace->GetPoints()->GetData(),
                      find("Force"), find("Command"), find("NormalForce"), find("FrictionForce"),
                      find("Contact"), find("SurfaceValue"), find("Label") },
    0);
}

std::vector<SoundTick> HeardTicks::Read(const Columns& columns, std::int64_t label)
{
  const double meters = this->Filter->GetMetersPerWorldUnit();
  std::vector<SoundTick> ticks;
  for (vtkIdType i = 0; i < columns.Count; ++i)
  {
    SoundTick tick;
    tick.Time = columns.Time->GetComponent(i, 0);
    double proxy[3];
    columns.Proxy->GetTuple(i, proxy);
    const double seconds = tick.Time - this->Time;
    if (this->HasProxy && seconds > 0.0)
    {
      tick.Speed =
        meters * std::sqrt(vtkMath::Distance2BetweenPoints(proxy, this->Proxy)) / seconds;
    }
    std::copy(proxy, proxy + 3, this->Proxy);
    this->Time = tick.Time;
    this->HasProxy = true;

    double share = 1.0;
    if (columns.Command)
    {
      double force[3];
      double command[3];
      columns.Force->GetTuple(i, force);
      columns.Command->GetTuple(i, command);
      const double norm = vtkMath::Norm(force);
      share = norm > 0.0 ? std::min(1.0, vtkMath::Norm(command) / norm) : 0.0;
    }
    if (share > 0.0)
    {
      const double contact = columns.Contact->GetComponent(i, 0);
      tick.Contact = static_cast<SurfaceContact>(std::clamp(contact, 0.0, 3.0));
      tick.NormalForce = share * columns.NormalForce->GetComponent(i, 0);
      tick.FrictionForce = share * columns.FrictionForce->GetComponent(i, 0);
      this->SetMaterial(tick, columns.SurfaceValue->GetComponent(i, 0),
        columns.Label ? static_cast<std::int64_t>(columns.Label->GetComponent(i, 0)) : label);
    }
    ticks.push_back(tick);
  }
  return ticks;
}

void HeardTicks::SetMaterial(SoundTick& tick, double value, std::int64_t label) const
{
  vtkHapticProperty* const property = this->Filter->GetProperty();
  const double felt = property->ScalarToValue(value);
  tick.Stiffness = property->GetStiffness()->GetValue(felt);
  tick.Strength = property->GetSurfaceStrength()->GetValue(felt);
  vtkHapticLabelTable* const table = this->Filter->GetLabelTable();
  if (table && label > 0 && label <= std::numeric_limits<int>::max())
  {
    // A value below 0 means that the table sets none for the label.
    const double stiffness = table->GetStiffness(static_cast<int>(label));
    const double strength = table->GetSurfaceStrength(static_cast<int>(label));
    tick.Stiffness = stiffness >= 0.0 ? stiffness : tick.Stiffness;
    tick.Strength = strength >= 0.0 ? strength : tick.Strength;
  }
}
} // namespace Explore
