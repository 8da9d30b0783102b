// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Base/XmlFiles.h"

#include "Core/Platform/FileReplacement.h"
#include "VTK/Base/XmlStructure.h"

#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLReader.h"
#include "vtkXMLWriter.h"

#include <exception>

namespace VolumeHaptics
{
bool ReadXmlFile(vtkXMLReader* reader, const std::string& file)
{
  bool hasFailed = !DetectFalseXml(file).empty();
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
  try
  {
    hasFailed ? void() : reader->UpdateInformation();
    hasFailed ? void() : reader->Update();
  }
  catch (const std::exception&) // the file declares more data than fits into memory
  {
    hasFailed = true;
  }
  // Remove the observers, which refer to the local variable hasFailed: the reader may outlive it.
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
  writer->SetDataModeToBinary(); // appended data, VTK's default, can't be read with newer versions
                                 // of expat
  writer->Write();
  replacement.Write(writer->GetOutputString());
  return replacement.Commit(error);
}

vtkSmartPointer<vtkPolyData> ReadXmlPolyData(const std::string& file, bool& failed)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  failed = !ReadXmlFile(reader, file) || failed;
  return reader->GetOutput();
}

} // namespace VolumeHaptics
