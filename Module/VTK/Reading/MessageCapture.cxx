// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/MessageCapture.h"

#include "vtkAlgorithm.h"
#include "vtkObjectFactory.h"

#include <exception>
#include <iostream>

namespace
{
constexpr const char* ENDS_EARLY = "the file ends before the last voxel";

class ErrorCollector : public vtkOutputWindow
{
public:
  static ErrorCollector* New();
  vtkTypeMacro(ErrorCollector, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayErrorText(const char* text) override { this->Keep(text); }
  void DisplayWarningText(const char* text) override { this->DisplayGenericWarningText(text); }
  void DisplayGenericWarningText(const char* text) override
  {
    // Detect these warnings: if a file is too short, vtkImageReader and the readers of .vtk report
    // no error.
    const std::string warning = text;
    if (warning.find("File operation failed") != std::string::npos ||
      warning.find("Error reading binary data") != std::string::npos ||
      warning.find("Error reading ascii data") != std::string::npos)
    {
      this->Keep(ENDS_EARLY);
    }
  }

  std::string First;

private:
  void Keep(const std::string& text)
  {
    if (this->First.empty())
    {
      this->First = text;
    }
  }
};
vtkStandardNewMacro(ErrorCollector);

std::string OneLine(std::string text)
{
  const std::size_t address = text.find("): ");
  if (address != std::string::npos)
  {
    text.erase(0, address + 3);
  }
  const std::size_t end = text.find_last_not_of(" \t\r\n.");
  text.erase(end == std::string::npos ? 0 : end + 1);
  for (char& letter : text)
  {
    letter = letter == '\n' || letter == '\r' ? ' ' : letter;
  }
  return text;
}
} // namespace

namespace Explore
{
MessageCapture::MessageCapture()
  : Previous(vtkOutputWindow::GetInstance())
  , Window(vtkSmartPointer<ErrorCollector>::New())
  , Verbosity(vtkLogger::GetCurrentVerbosityCutoff())
  , Cerr(std::cerr.rdbuf(this->Stream.rdbuf()))
  , Cout(std::cout.rdbuf(this->Stream.rdbuf()))
{
  vtkOutputWindow::SetInstance(this->Window);
  // Since VTK 9, each message is also printed to stderr.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

MessageCapture::~MessageCapture()
{
  vtkOutputWindow::SetInstance(this->Previous);
  vtkLogger::SetStderrVerbosity(this->Verbosity);
  std::cerr.rdbuf(this->Cerr);
  std::cout.rdbuf(this->Cout);
}

bool MessageCapture::HasErrors() const
{
  return !this->FirstError().empty();
}

std::string MessageCapture::FirstError() const
{
  const std::string metaIO = this->Stream.str();
  if (metaIO.find("not read completely") != std::string::npos)
  {
    return ENDS_EARLY;
  }
  if (metaIO.find("Cannot open data file") != std::string::npos)
  {
    return "the file of voxels that its header names is missing";
  }
  return OneLine(static_cast<ErrorCollector*>(this->Window.Get())->First);
}

//------------------------------------------------------------------------------
bool ReadChecked(
  vtkAlgorithm* reader, std::string& detail, const std::function<std::string()>& check)
{
  const MessageCapture capture;
  const auto isGood = [&]
  {
    detail = detail.empty() ? capture.FirstError() : detail;
    return detail.empty() && reader->GetErrorCode() == 0;
  };
  detail.clear();
  try
  {
    reader->UpdateInformation();
    if (isGood() && check)
    {
      detail = check();
    }
    if (isGood())
    {
      reader->Update();
    }
  }
  catch (const std::exception&)
  {
    detail = "there is not enough memory for what its header announces";
  }
  return isGood();
}

} // namespace Explore
