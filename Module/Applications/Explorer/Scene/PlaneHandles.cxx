// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Scene/PlaneHandles.h"

#include "vtkActor.h"
#include "vtkCellPicker.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"

namespace Explore
{
vtkStandardNewMacro(PlaneHandles);

PlaneHandles::PlaneHandles()
{
  constexpr double pixels = 9.0;
  constexpr double line = 0.85; // the brightness of handles that are not held
  this->SetPlaceFactor(1.0);
  this->SetHandleSize(pixels);
  this->SetDrawPlane(0);
  this->SetDrawOutline(0);
  this->SetTubing(0);
  this->OutlineTranslationOff();
  this->ScaleEnabledOff();
  this->SetEdgeColor(line, line, line);
  this->GetEdgesProperty()->SetLineWidth(1.5f);
  this->GetNormalProperty()->SetColor(0.35, 0.65, 0.95);
  this->GetSelectedNormalProperty()->SetColor(1.0, 0.75, 0.2);
  this->Picker->DeletePickList(this->CutActor);
  // The outline, which has no name common to all versions of VTK.
  vtkPropCollection* const picked = this->Picker->GetPickList();
  for (int i = picked->GetNumberOfItems(); i-- > 0;)
  {
    auto* const actor = vtkActor::SafeDownCast(picked->GetItemAsObject(i));
    if (actor && actor->GetProperty() == this->GetOutlineProperty())
    {
      this->Picker->DeletePickList(actor);
    }
  }
}

int PlaneHandles::ComputeInteractionState(int x, int y, int modify)
{
  if (this->Superclass::ComputeInteractionState(x, y, modify) == MovingOrigin)
  {
    this->InteractionState = Pushing;
    this->SetRepresentationState(Pushing);
  }
  return this->InteractionState;
}
} // namespace Explore
