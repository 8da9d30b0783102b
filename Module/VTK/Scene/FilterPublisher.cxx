// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/FilterPublisher.h"

#include "VTK/Baking/HapticMethods.h"
#include "VTK/Session/HapticChangeTime.h"

#include "vtkInteractorStyleHaptic.h"
#include "vtkVolumeHapticsFilter.h"

namespace VolumeHaptics
{

vtkMTimeType FilterPublisher::GetChangeTime() const
{
  return FindChangeTime(this->Scene.Device->GetVolumeHaptics());
}

void FilterPublisher::Update(bool isPlaced)
{
  const vtkSmartPointer<vtkHapticDevice> device = this->Scene.Device;
  const vtkMTimeType time = this->GetChangeTime();
  // The application or another style may have published it.
  const bool hasChanged = time != this->Published && !device->IsPublished();
  this->Published = time;
  if ((isPlaced || hasChanged) && device->Publish() && hasChanged && this->Scene.Display)
  {
    this->Scene.Display->SetNotice("");
  }
}

bool FilterPublisher::NextMethod(const std::function<void(const std::string&)>& notify)
{
  // Observers of the following events may take any of these away.
  const vtkSmartPointer<vtkInteractorStyleHaptic> style = this->Scene.Style;
  const vtkSmartPointer<vtkHapticDevice> device = this->Scene.Device;
  const vtkSmartPointer<vtkVolumeHapticsFilter> filter =
    device ? device->GetVolumeHaptics() : nullptr;
  if (!filter)
  {
    vtkErrorWithObjectMacro(style,
      "There is no method to change: SetDevice() one that SetVolumeHaptics() was called on.");
    return false;
  }
  const int method = filter->GetMethod();
  const int solver = filter->GetSolver();
  const std::string before = filter->GetMethodText();
  const bool wasPublished = this->Published == this->GetChangeTime();
  if (!this->Unfelt.empty() && this->FeltInstead == before)
  {
    filter->SetMethodByName(this->Unfelt.c_str());
  }
  filter->NextMethod();
  const std::string wanted = filter->GetMethodText();
  const bool isPrepared = GetMethodChoice(filter->GetMethod(), filter->GetSolver()).IsPrepared;
  notify(isPrepared ? wanted + " is being prepared ..." : "");
  this->Unfelt.clear();
  const bool isFelt = device->Publish();
  const bool isOurs = this->Scene.Device == device;
  if (isFelt)
  {
    this->Published = isOurs ? this->GetChangeTime() : this->Published;
    notify("");
    return true;
  }
  this->Unfelt = filter->GetMethodName();
  this->FeltInstead = before;
  filter->SetMethod(method);
  filter->SetSolver(solver);
  // The servo still has the previous method, so publishing is needed only if it was needed before.
  this->Published = isOurs && wasPublished ? this->GetChangeTime() : 0;
  vtkErrorWithObjectMacro(style, << wanted << " can't be felt here, for the reason given before; "
                                 << before << " goes on.");
  notify(wanted + " can't be felt here: see the messages.\n" + before + " goes on.");
  return false;
}

} // namespace VolumeHaptics
