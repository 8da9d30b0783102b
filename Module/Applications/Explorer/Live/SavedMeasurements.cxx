// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/SavedMeasurements.h"

#include "Applications/Explorer/Live/FreeFile.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/MessageCapture.h"

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
    std::string warning;
    vtkNew<vtkCallbackCommand> warned;
    warned->SetClientData(&warning);
    warned->SetCallback([](vtkObject*, unsigned long, void* text, void* message)
      { *static_cast<std::string*>(text) = static_cast<const char*>(message); });
    const unsigned long observer = list->AddObserver(vtkCommand::WarningEvent, warned);
    {
      const MessageCapture capture;
      if (!list->ReadFile(this->File.c_str()))
      {
        throw InputError("--measurements " + this->File, capture.FirstError(),
          "correct it or choose another file");
      }
    }
    list->RemoveObserver(observer);
    this->InFile = list->GetNumberOfMeasurements();
    if (!warning.empty())
    {
      const std::size_t dot = this->File.find('.', this->File.find_last_of('/') + 1);
      const std::string read = this->File;
      this->File = FindFreeFile(read.substr(0, dot), read.substr(dot));
      this->InFile = 0;
      // end of the source location that VTK prints first
      const std::size_t text = warning.find("): ");
      std::cout << (text == std::string::npos ? warning : warning.substr(text + 3)) << read
                << " stays as it is: measurements are saved to " << this->File << std::endl;
    }
  }
  this->Saved = list->GetMTime();
  touch.Commands.Add(
    this, { "File", "save measurements", "Ctrl+s", [this] { this->SaveNow(); }, nullptr, nullptr });
}

SavedMeasurements::~SavedMeasurements()
{
  this->Touch.Commands.Remove(this);
}

void SavedMeasurements::SaveNow()
{
  const vtkIdType number = this->Touch.Measurements->GetNumberOfMeasurements();
  if (number == 0)
  {
    this->Touch.Display->SetNotice("There are no measurements to save");
    return;
  }
  if (this->File.empty())
  {
    this->File = FindFreeFile("measurements", ".mrk.json");
  }
  std::string error;
  const bool isSaved = this->Save(error);
  const std::string words =
    std::to_string(number) + (number == 1 ? " measurement" : " measurements");
  const std::string path = vtksys::SystemTools::CollapseFullPath(this->File);
  this->Touch.Display->SetNotice((isSaved ? words + " saved to " + path : error).c_str());
}

std::string SavedMeasurements::SaveAtEnd()
{
  if (this->IsSaved())
  {
    return {};
  }
  if (this->File.empty())
  {
    this->Report(std::cout);
    std::cout << "Next time, --measurements FILE saves them." << std::endl;
    return {};
  }
  if (this->Touch.Measurements->GetNumberOfMeasurements() == 0)
  {
    if (this->InFile > 0)
    {
      std::cout << "There are no measurements; " << this->File << " is unchanged." << std::endl;
    }
    return {};
  }
  std::string error;
  if (!this->Save(error))
  {
    this->Report(std::cerr);
  }
  return error;
}

bool SavedMeasurements::IsSaved() const
{
  vtkHapticMeasurements* const list = this->Touch.Measurements;
  const bool isNew = list->GetMTime() != this->Saved;
  return !isNew || (list->GetNumberOfMeasurements() == 0 && this->InFile == 0);
}

void SavedMeasurements::Report(std::ostream& out) const
{
  vtkHapticMeasurements* const list = this->Touch.Measurements;
  const vtkIdType count = list->GetNumberOfMeasurements();
  out << "Not saved: " << count << (count == 1 ? " measurement" : " measurements") << "\n";
  for (vtkIdType i = 0; i < count; ++i)
  {
    out << "  " << list->GetText(i) << "\n";
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
  this->InFile = list->GetNumberOfMeasurements();
  return true;
}
} // namespace Explore
