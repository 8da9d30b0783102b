// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Files/XmlFiles.h"

#include "VTK/Files/FileReplacement.h"

#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkXMLReader.h"
#include "vtkXMLWriter.h"

namespace VolumeHaptics
{

bool ReadXmlFile(vtkXMLReader* reader, const std::string& file)
{
  bool hasFailed = false;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&hasFailed);
  observer->SetCallback(
    [](vtkObject*, unsigned long, void* failed, void*) { *static_cast<bool*>(failed) = true; });
  reader->SetReaderErrorObserver(observer);
  reader->SetParserErrorObserver(observer);
  const unsigned long ofReader = reader->AddObserver(vtkCommand::ErrorEvent, observer);
  const unsigned long ofExecutive =
    reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  reader->SetFileName(file.c_str());
  reader->UpdateInformation();
  if (!hasFailed)
  {
    reader->Update();
  }
  // The reader may live longer than hasFailed.
  reader->SetReaderErrorObserver(nullptr);
  reader->SetParserErrorObserver(nullptr);
  reader->RemoveObserver(ofReader);
  reader->GetExecutive()->RemoveObserver(ofExecutive);
  return !hasFailed;
}

bool WriteXmlFile(
  vtkXMLWriter* writer, vtkDataObject* data, const std::string& file, std::string& error)
{
  FileReplacement replacement;
  if (!replacement.Open(file, error))
  {
    return false;
  }
  writer->WriteToOutputStringOn();
  writer->SetInputData(data);
  writer->SetDataModeToBinary(); // newer expats can't read appended data
  writer->Write();
  replacement.Write(writer->GetOutputString());
  return replacement.Commit(error);
}

} // namespace VolumeHaptics
