// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Fixture that records a short push, and makes files to replay. */
#ifndef ReplayRig_h
#define ReplayRig_h

#include "Rigs/DeviceRig.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkStringOutputWindow.h>
#include <vtkXMLPolyDataReader.h>

#include <fstream>
#include <sstream>

namespace devicetest
{
class Replay : public DeviceTest
{
protected:
  /// Records a short push to this file.
  void Record(const std::string& file)
  {
    this->Begin();
    ASSERT_TRUE(this->Device->GetRecorder()->Start(file.c_str()));
    ASSERT_TRUE(this->Lead(7.0, 7.1, 9.0));
    ASSERT_TRUE(this->Lead(7.0, 7.2, 6.0));
    ASSERT_TRUE(this->Device->GetRecorder()->Stop());
    this->Device->Close();
  }
  static vtkSmartPointer<vtkPolyData> Read(const std::string& file)
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    return reader->GetOutput();
  }
  static std::string Load(const std::string& file)
  {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
  }
  void ExpectRefused(const char* ending, const std::string& content)
  {
    const std::string file = this->File("Bad") + ending;
    std::ofstream(file, std::ios::binary) << content;
    vtkNew<vtkStringOutputWindow> console;
    vtkOutputWindow::SetInstance(console);
    EXPECT_FALSE(this->Device->Open(("replay:" + file).c_str())) << content.substr(0, 300);
    vtkOutputWindow::SetInstance(nullptr);
    EXPECT_EQ(console->GetOutput(), "") << "more than one error";
    this->ExpectError(file.c_str());
    EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::CLOSED);
    EXPECT_FALSE(this->Device->Start());
    this->Log.Errors.clear();
  }
};
} // namespace devicetest

#endif
