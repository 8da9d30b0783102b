// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Report/ReportFiles.h"

#include "VTK/Reading/InputError.h"
#include "VTK/Reading/MessageCapture.h"
#include "VTK/Trace/TraceWriter.h"

#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkWindowToImageFilter.h"
#include "vtkXMLImageDataWriter.h"

#include <vtksys/FStream.hxx>
#include <vtksys/SystemTools.hxx>

namespace
{
void Check(bool written, const std::string& file)
{
  if (!written)
  {
    throw Explore::InputError(file, "cannot be written",
      "check that the disk is not full and that you may write to the folder; --pictures DIR "
      "chooses another one");
  }
}

using Writer = bool (*)(vtkPolyData*, const std::string&, std::string&);

void Write(Writer write, vtkPolyData* trace, const std::string& file)
{
  std::string error;
  if (!write(trace, file, error))
  {
    error.pop_back(); // removes the full stop, because InputError adds one
    throw Explore::InputError(
      file, "cannot be written: " + error, "--pictures DIR chooses another folder");
  }
}
} // namespace

namespace Explore
{
void MakeFolder(const std::string& folder)
{
  if (!vtksys::SystemTools::MakeDirectory(folder))
  {
    throw InputError(folder, "can't be created as a folder",
      "choose one that you may write to with --pictures DIR");
  }
}

void WriteTrace(vtkPolyData* trace, const std::string& file)
{
  Write(VolumeHaptics::WriteTracePolyData, trace, file);
}

void WriteTable(vtkPolyData* trace, const std::string& file)
{
  Write(VolumeHaptics::WriteTraceTable, trace, file);
}

void WriteImage(vtkImageData* image, const std::string& file)
{
  // keeps VTK's message from the terminal; the error is reported below
  const MessageCapture capture;
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(image);
  writer->SetCompressorTypeToNone();
  writer->EncodeAppendedDataOff();
  if (writer->Write() == 0 || writer->GetErrorCode() != 0)
  {
    throw InputError(file, "cannot be written",
      "check that the disk is not full, the folder exists, and you may write to it");
  }
}

void WritePicture(vtkRenderWindow* window, const std::string& file)
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputConnection(grab->GetOutputPort());
  writer->Write();
  Check(writer->GetErrorCode() == 0, file);
}

void WriteText(const std::string& text, const std::string& file)
{
  vtksys::ofstream stream(file.c_str());
  stream << text;
  stream.close();
  Check(stream.good(), file);
}
} // namespace Explore
