// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests that running out of memory causes one error, and that the process continues. */

#include "Rigs/ApiRig.h"
#include "Rigs/TemporaryFolder.h"

#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkHapticDevice.h>
#include <vtkHapticPathSource.h>
#include <vtkImageAlgorithm.h>
#include <vtkInformation.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkResampleToImage.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <new>

namespace
{
/// Least size (bytes) of allocations that fail.
std::atomic<std::size_t> Scarce{ std::numeric_limits<std::size_t>::max() };
} // namespace

void* operator new(std::size_t bytes)
{
  void* const memory = bytes < Scarce ? std::malloc(bytes ? bytes : 1) : nullptr;
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}
void operator delete(void* memory) noexcept
{
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

using namespace apitest;

namespace
{
/// A source whose file is larger than the memory.
class GreedySource : public vtkImageAlgorithm
{
public:
  static GreedySource* New();
  vtkTypeMacro(GreedySource, vtkImageAlgorithm);

protected:
  GreedySource() { this->SetNumberOfInputPorts(0); }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override
  {
    throw std::bad_alloc();
  }
};
vtkStandardNewMacro(GreedySource);

class Memory : public ApiTest
{
protected:
  ~Memory() override { this->IsPlenty(); }
  static void IsScarceFrom(std::size_t bytes) { Scarce = bytes; }
  static void IsPlenty() { Scarce = std::numeric_limits<std::size_t>::max(); }

  /// Expects one error that contains these words.
  static void Expect(MessageLog& log, const std::vector<std::string>& words)
  {
    ASSERT_EQ(log.Errors.size(), 1U);
    for (const std::string& word : words)
    {
      EXPECT_NE(log.Errors[0].find(word), std::string::npos)
        << "no \"" << word << "\" in: " << log.Errors[0];
    }
    log.Errors.clear();
  }
};
} // namespace

TEST_F(Memory, OfALongPathIsNamedInBytes)
{
  // Two points that are 20000 s apart make 20 million ticks, each with 24 bytes for the position of
  // the tip.
  this->Filter->SetPathData(MakePath({ { 7, 7, 5 }, { 7, 7, 10 } }, { 0.0, 2e4 }));
  IsScarceFrom(64 << 20);
  this->ExpectError({ "not enough memory", "20000001 ticks", "port 1", "GB", "in pieces" });
  IsPlenty();
  this->Filter->SetPathData(this->Path);
  this->Run(51);
}

TEST_F(Memory, OfAnImageThatIsMadeReady)
{
  // The isosurface has 256 points of 24 bytes each.
  this->Filter->SetMethodToSurfaceProxy();
  this->Filter->SetIsoValue(750.0);
  IsScarceFrom(4 << 10);
  this->ExpectError({ "not enough memory", "port 0", "16 x 16 x 16", "MiB" });
  IsPlenty();
  this->Filter->Modified();
  this->Run(51);
}

TEST_F(Memory, OfDataThatHaveToBeCopied)
{
  vtkNew<vtkRectilinearGrid> grid;
  vtkNew<vtkDoubleArray> places;
  for (int i = 0; i < 16; ++i)
  {
    places->InsertNextValue(i);
  }
  grid->SetDimensions(16, 16, 16);
  grid->SetXCoordinates(places);
  grid->SetYCoordinates(places);
  grid->SetZCoordinates(places);
  grid->GetPointData()->ShallowCopy(this->Image->GetPointData()); // 32 KiB
  this->Filter->SetInputDataObject(0, grid);
  IsScarceFrom(64 << 10);
  this->ExpectError({ "not enough memory to touch the vtkRectilinearGrid", "has to be copied",
    "which vtkResampleToImage makes" });
  vtkNew<vtkResampleToImage> image;
  image->SetInputDataObject(grid);
  image->SetSamplingDimensions(16, 16, 16);
  this->Filter->SetInputConnection(0, image->GetOutputPort());
  this->Run(51);
  IsPlenty();
  grid->Modified();
  this->Filter->SetInputDataObject(0, grid);
  this->Run(51);
}

TEST_F(Memory, OfAPathThatIsMade)
{
  vtkNew<vtkHapticPathSource> source;
  MessageLog log(source);
  MessageLog executiveLog(source->GetExecutive());
  source->SetSpeed(1e-2); // results in ten million points
  IsScarceFrom(64 << 20);
  source->Update();
  IsPlenty();
  Expect(log, { "not enough memory", "haptic path", "Raise Speed" });
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0);
  source->SetSpeed(100.0);
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 1001);
}

TEST_F(Memory, RunsOutInPublish)
{
  vtkNew<vtkHapticDevice> device;
  MessageLog log(device);
  ASSERT_TRUE(device->Open("virtual"));
  device->SetVolumeHaptics(this->Filter);
  vtkNew<GreedySource> greedy;
  MessageLog executiveLog(greedy->GetExecutive());
  this->Filter->SetInputConnection(greedy->GetOutputPort());
  EXPECT_FALSE(device->Start());
  Expect(this->Log, { "not enough memory", "port 0", "connect a new source" });
  EXPECT_FALSE(device->IsRunning());
  // VTK's executive assumes that the source is still executing, so the filter must refuse this
  // source from now on.
  EXPECT_FALSE(device->Start());
  EXPECT_FALSE(device->Publish());
  ASSERT_EQ(this->Log.Errors.size(), 2U);
  for (const std::string& error : this->Log.Errors)
  {
    EXPECT_NE(error.find("new source"), std::string::npos) << error;
  }
  this->Log.Errors.clear();

  this->Filter->SetInputDataObject(0, this->Image);
  ASSERT_TRUE(device->Start());
  device->Arm();
  this->Filter->SetMethodToSurfaceProxy();
  this->Filter->SetIsoValue(750.0);
  IsScarceFrom(4 << 10);
  EXPECT_FALSE(device->Publish());
  IsPlenty();
  Expect(this->Log, { "not enough memory", "16 x 16 x 16", "SURFACE_PROXY" });
  EXPECT_TRUE(device->IsRunning()) << "the servo goes on with what it has";
  EXPECT_EQ(device->GetMethodText(), "Proxy, PRECISE");
  this->Filter->Modified();
  EXPECT_TRUE(device->Publish());

  const std::string file = TemporaryPath("memory.vtp");
  IsScarceFrom(1 << 10); // the journal starts with the settings, which need more memory
  EXPECT_FALSE(device->GetRecorder()->Start(file.c_str()));
  IsPlenty();
  Expect(log, { "not enough memory", "memory.vtp" });
  EXPECT_FALSE(std::filesystem::exists(file + ".part"));
  EXPECT_TRUE(device->GetRecorder()->Start(file.c_str()));
  EXPECT_TRUE(device->GetRecorder()->Stop());
  EXPECT_TRUE(log.Errors.empty());
}
