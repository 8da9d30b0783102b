// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Base/XmlFiles.h"

#include "VTK/Base/FileReplacement.h"

#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLReader.h"
#include "vtkXMLWriter.h"

#include <algorithm>
#include <fstream>

namespace VolumeHaptics
{
namespace
{

/**
 * Whether a file is complete. VTK's readers fill samples that are missing at its end with arbitrary
 * memory.
 */
bool HasEnd(const std::string& file)
{
  // size of the end of a file that contains its last element (bytes)
  constexpr std::streamoff longest = 1024;
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  const std::streamoff size = in.tellg();
  std::string end(static_cast<std::size_t>(std::clamp<std::streamoff>(size, 0, longest)), ' ');
  in.seekg(size - static_cast<std::streamoff>(end.size()));
  in.read(end.data(), static_cast<std::streamsize>(end.size()));
  return end.find("</VTKFile>") != std::string::npos;
}

} // namespace

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
    hasFailed = hasFailed || !HasEnd(file);
  }
  // Remove the observers, because the reader may outlive hasFailed.
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
  writer->SetDataModeToBinary(); // newer versions of expat can't read appended data
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
