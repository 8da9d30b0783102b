// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/PolyDataReading.h"

#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"

namespace VolumeHaptics
{

vtkSmartPointer<vtkPolyData> ReadXmlPolyData(const std::string& file, bool& failed)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  // One error that tells the cure replaces those of the reader.
  struct Observer : vtkCommand
  {
    static Observer* New() { return new Observer; }
    void Execute(vtkObject*, unsigned long, void*) override { *this->Failed = true; }
    bool* Failed = nullptr;
  };
  vtkNew<Observer> observer;
  observer->Failed = &failed;
  reader->SetReaderErrorObserver(observer);
  reader->SetParserErrorObserver(observer);
  reader->AddObserver(vtkCommand::ErrorEvent, observer);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

} // namespace VolumeHaptics
