// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Fixture for a recorder without a device: a model, ticks with random digits, and files in a folder
 * that is removed at the end.
 */
#ifndef RecorderRig_h
#define RecorderRig_h

#include "Rigs/TemporaryFolder.h"

#include "Core/Servo/ServoLoop.h"
#include "VTK/Device/Recording/HapticRecording.h"
#include "VTK/Device/Recording/HapticRecordingFile.h"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>
#include <vtksys/SystemTools.hxx>

#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <random>
#include <sstream>
#include <thread>
#include <unistd.h>

namespace recordertest
{
using namespace VolumeHaptics;

inline std::shared_ptr<const HapticModel> MakeModel(double shift = 0.0)
{
  constexpr int n = 16;
  auto samples = std::make_shared<std::vector<short>>(n * n * n);
  for (std::size_t i = 0; i < samples->size(); ++i)
  {
    (*samples)[i] = static_cast<short>(7 * (i % n) + 3 * i / (n * n));
  }
  HapticModelDescription description;
  description.View.Data = samples->data();
  description.View.Type = ScalarType::Int16;
  for (int axis = 0; axis < 3; ++axis)
  {
    description.View.Dimensions[axis] = n;
  }
  description.View.Stride[0] = 1;
  description.View.Stride[1] = n;
  description.View.Stride[2] = n * n;
  description.Samples = samples;
  description.DeviceToWorld.Linear = 1000.0 * Matrix3{};
  description.DeviceToWorld.Offset.X = shift;
  return std::make_shared<const HapticModel>(description);
}

/// Makes ticks in which all numbers that depend on the hand are random, with all their digits.
class Ticks
{
public:
  ServoSnapshot Next()
  {
    ServoSnapshot s;
    s.Tick = this->Count++;
    s.Time = 1e-3 * static_cast<double>(s.Tick) + 1e-7 * this->Draw();
    s.Generation = 1;
    s.Gate = VolumeHaptics::GateState::Ramping;
    s.Reason = VolumeHaptics::GateReason::Rising;
    s.Share = 0.75;
    s.Torque = { 1e-3 * this->Draw(), 0.0, 0.0 };
    const double half = 0.5 * this->Draw();
    s.Orientation = { std::cos(half), 0.0, 0.0, std::sin(half) };
    s.HasOrientation = true;
    TickRecord& r = s.Record;
    r.Torque = { 0.0, 1e-4, 0.0 };
    r.ToolOrientation = { 0.6, 0.0, 0.8, 0.0 };
    const double t = 1e-3 * static_cast<double>(s.Tick);
    r.Tip = { 0.007 + 0.003 * std::sin(t), 0.007 + 0.002 * std::sin(0.7 * t),
      0.008 + 1e-6 * this->Draw() };
    r.Proxy = r.Tip + Vector3{ 1e-4 * this->Draw(), 1e-4 * this->Draw(), 1e-3 };
    r.Force = 800.0 * (r.Proxy - r.Tip);
    r.Normal = { 0.6 + 1e-3 * this->Draw(), 0.8, 0.1 * this->Draw() };
    s.Command = r.Force;
    r.NormalForce = Norm(r.Force);
    r.FrictionForce = 0.1 + 0.01 * this->Draw();
    r.GradientMagnitude = 40.0 + this->Draw();
    r.SurfaceValue = 300.0 + this->Draw();
    r.MediumValue = 100.0 + this->Draw();
    r.Stiffness = 800.0;
    r.Friction = 0.3;
    r.SurfaceStrength = 2.0;
    r.Contact = ContactState::Sliding;
    return s;
  }
  std::uint64_t Count = 0;

private:
  double Draw() { return this->Distribution(this->Generator); }
  std::mt19937 Generator{ 7 };
  std::uniform_real_distribution<double> Distribution{ -1.0, 1.0 };
};

inline std::string Load(const std::string& file)
{
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

inline bool Exists(const std::string& file)
{
  return access(file.c_str(), F_OK) == 0;
}

inline vtkSmartPointer<vtkPolyData> Read(const std::string& file)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), 0UL);
  return reader->GetOutput();
}

class Recorder : public testing::Test
{
protected:
  Recorder()
  {
    vtksys::SystemTools::RemoveADirectory(this->Folder);
    vtksys::SystemTools::MakeDirectory(this->Folder);
  }
  ~Recorder() override { vtksys::SystemTools::RemoveADirectory(this->Folder); }
  void Start(HapticRecording& recording, const std::string& file)
  {
    std::string error;
    std::string warning;
    ASSERT_TRUE(recording.Start(file, { "virtual", "settings <&> \xFF", "hash" }, error, warning))
      << error;
    EXPECT_EQ(warning, "");
    recording.AddModel(1, this->Model);
  }
  void Push(HapticRecording& recording, const ServoSnapshot& tick)
  {
    while (!recording.Append(tick))
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  void Finish(HapticRecording& recording)
  {
    std::string error;
    EXPECT_TRUE(recording.Finish(error)) << error;
  }

  const std::string Folder = TemporaryPath("Recorder");
  const std::string File = this->Folder + "/a.vtp";
  const std::shared_ptr<const HapticModel> Model = MakeModel();
  Ticks Source;
};

} // namespace recordertest

#endif
