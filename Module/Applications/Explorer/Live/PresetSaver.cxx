// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/PresetSaver.h"

#include "Applications/Explorer/Errors/MessageCapture.h"
#include "Applications/Explorer/Live/FreeFile.h"

#include "vtkHapticProperty.h"

namespace Explore
{
PresetSaver::PresetSaver(TouchScene& touch, vtkRenderWindowInteractor* interactor)
  : Touch(touch)
  , Interactor(interactor)
  , Key(interactor, "F8", [this] { this->Save(); })
{
}

void PresetSaver::Save()
{
  const std::string file = FindFreeFile("preset", ".json");
  std::string notice = "Materials saved, for --preset " + file;
  {
    const MessageCapture capture;
    if (!this->Touch.Editor->GetProperty()->WritePreset(file.c_str()))
    {
      notice = capture.FirstError();
    }
  }
  this->Touch.Display->SetNotice(notice.c_str());
  this->Interactor->Render();
}
} // namespace Explore
