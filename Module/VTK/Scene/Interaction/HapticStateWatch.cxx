// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Interaction/HapticStateWatch.h"

#include "vtkDataArray.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkTable.h"

namespace VolumeHaptics
{

std::vector<unsigned long> HapticStateWatch::Watch(vtkTable* states)
{
  std::vector<unsigned long> events;
  auto* const contact = vtkDataArray::SafeDownCast(states->GetColumnByName("Contact"));
  auto* const armed = vtkDataArray::SafeDownCast(states->GetColumnByName("Armed"));
  auto* const fault = vtkDataArray::SafeDownCast(states->GetColumnByName("Fault"));
  const auto note = [&](bool& was, bool is, unsigned long begins, unsigned long ends)
  {
    if (is != was && (is || ends != 0))
    {
      events.push_back(is ? begins : ends);
    }
    was = is;
  };
  for (vtkIdType i = 0; contact && armed && fault && i < states->GetNumberOfRows(); ++i)
  {
    const bool hasFault = fault->GetComponent(i, 0) != 0.0;
    note(this->HasFault, hasFault, vtkInteractorStyleHaptic::FaultEvent, 0);
    // After a fault, DisarmedEvent would add nothing.
    note(this->IsArmed, armed->GetComponent(i, 0) != 0.0, vtkInteractorStyleHaptic::ArmedEvent,
      hasFault ? 0 : vtkInteractorStyleHaptic::DisarmedEvent);
    note(this->IsTouching, contact->GetComponent(i, 0) != 0.0,
      vtkInteractorStyleHaptic::ContactBeginEvent, vtkInteractorStyleHaptic::ContactEndEvent);
  }
  return events;
}

} // namespace VolumeHaptics
