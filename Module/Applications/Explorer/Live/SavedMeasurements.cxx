// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/SavedMeasurements.h"

#include "Applications/Explorer/Errors/InputError.h"
#include "Applications/Explorer/Errors/MessageCapture.h"

#include <vtksys/SystemTools.hxx>

#include <iostream>
#include <utility>

namespace Explore
{
SavedMeasurements::SavedMeasurements(TouchScene& touch, std::string file)
  : Touch(touch)
  , File(std::move(file))
{
  vtkHapticMeasurements* const list = touch.Measurements;
  if (!this->File.empty() && vtksys::SystemTools::FileExists(this->File, true))
  {
    const MessageCapture capture;
    if (!list->ReadFile(this->File.c_str()))
    {
      throw InputError(
        "--measurements " + this->File, capture.FirstError(), "correct it or name another file");
    }
  }
  this->Saved = list->GetMTime();
}

void SavedMeasurements::SaveByKey(vtkRenderWindowInteractor* interactor)
{
  this->Key->SetClientData(this);
  this->Key->SetCallback(
    [](vtkObject* caller, unsigned long, void* self, void*)
    {
      auto* const pressed = static_cast<vtkRenderWindowInteractor*>(caller);
      const char* const key = pressed->GetKeySym();
      if (key && key == std::string("S"))
      {
        auto& saved = *static_cast<SavedMeasurements*>(self);
        if (saved.File.empty())
        {
          saved.File = "measurements.mrk.json";
        }
        std::string error;
        const bool isSaved = saved.Save(error);
        const std::string count =
          std::to_string(saved.Touch.Measurements->GetNumberOfMeasurements());
        saved.Touch.Display->SetNotice(
          (isSaved ? count + " measurements saved to " + saved.File : error).c_str());
        pressed->Render();
      }
    });
  interactor->AddObserver(vtkCommand::KeyPressEvent, this->Key);
}

void SavedMeasurements::SaveAtEnd()
{
  vtkHapticMeasurements* const list = this->Touch.Measurements;
  std::string error;
  if (!this->File.empty() && list->GetMTime() != this->Saved && !this->Save(error))
  {
    throw InputError("--measurements " + this->File, error, "name a file in a folder of yours");
  }
  if (this->File.empty() && list->GetNumberOfMeasurements() > 0)
  {
    std::cout << list->GetNumberOfMeasurements() << " measurements are not saved:\n";
    for (vtkIdType i = 0; i < list->GetNumberOfMeasurements(); ++i)
    {
      std::cout << "  " << list->GetText(i) << "\n";
    }
    std::cout << "--measurements FILE saves them the next time." << std::endl;
  }
}

bool SavedMeasurements::Save(std::string& error)
{
  const MessageCapture capture;
  vtkHapticMeasurements* const list = this->Touch.Measurements;
  if (!list->WriteFile(this->File.c_str()))
  {
    error = capture.FirstError();
    return false;
  }
  this->Saved = list->GetMTime();
  return true;
}
} // namespace Explore
