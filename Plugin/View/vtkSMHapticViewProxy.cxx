// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMHapticViewProxy.h"

#include "vtkHapticViewLink.h"

#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkSMHapticDeviceProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"

vtkStandardNewMacro(vtkSMHapticViewProxy);

//------------------------------------------------------------------------------
vtkSMHapticViewProxy::vtkSMHapticViewProxy()
{
  this->Link->AddObserver(vtkCommand::EndEvent, this, &vtkSMHapticViewProxy::OnEnd);
  this->Link->AddObserver(vtkCommand::ModifiedEvent, this, &vtkSMHapticViewProxy::OnModified);
}

//------------------------------------------------------------------------------
vtkSMHapticViewProxy::~vtkSMHapticViewProxy()
{
  this->Link->Detach();
}

//------------------------------------------------------------------------------
vtkHapticViewLink* vtkSMHapticViewProxy::GetLink()
{
  return this->Link;
}

//------------------------------------------------------------------------------
void vtkSMHapticViewProxy::UpdateVTKObjects()
{
  // Nothing has to be sent to a server, because all objects are in the client.
  this->Link->SetSlicesFollowTip(vtkSMPropertyHelper(this, "SlicesFollowTip").GetAsInt() != 0);
  if (vtkSMPropertyHelper(this, "Attached").GetAsInt() == 0)
  {
    this->Link->Detach();
    vtkSMPropertyHelper(this, "TouchMode").Set(0);
    return;
  }
  auto* const view =
    vtkSMRenderViewProxy::SafeDownCast(vtkSMPropertyHelper(this, "View").GetAsProxy());
  auto* const device =
    vtkSMHapticDeviceProxy::SafeDownCast(vtkSMPropertyHelper(this, "Device").GetAsProxy());
  if (this->Link->Attach(view, device))
  {
    this->Link->SetSecondDevice(
      vtkSMHapticDeviceProxy::SafeDownCast(vtkSMPropertyHelper(this, "SecondDevice").GetAsProxy()));
    this->Link->SetTouchMode(vtkSMPropertyHelper(this, "TouchMode").GetAsInt() != 0);
    this->OnModified();
    vtkSMPropertyHelper(this, "Keys").Set(this->Link->GetKeys().c_str());
  }
  else
  {
    this->OnEnd();
  }
}

//------------------------------------------------------------------------------
void vtkSMHapticViewProxy::OnEnd()
{
  vtkSMPropertyHelper(this, "Attached").Set(0);
  vtkSMPropertyHelper(this, "TouchMode").Set(0);
  // Remove the view, because the property would keep a closed view alive.
  vtkSMPropertyHelper(this, "View").RemoveAllValues();
  vtkSMPropertyHelper(this, "Device").RemoveAllValues();
  vtkSMPropertyHelper(this, "SecondDevice").RemoveAllValues();
}

//------------------------------------------------------------------------------
void vtkSMHapticViewProxy::OnModified()
{
  vtkSMPropertyHelper(this, "TouchMode").Set(this->Link->GetTouchMode() ? 1 : 0);
  if (!this->Link->GetSecondDeviceProxy())
  {
    // Remove the device, because it was refused, or because the property would keep it alive.
    vtkSMPropertyHelper(this, "SecondDevice").RemoveAllValues();
  }
}

//------------------------------------------------------------------------------
void vtkSMHapticViewProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Link:\n";
  this->Link->PrintSelf(os, indent.GetNextIndent());
}
