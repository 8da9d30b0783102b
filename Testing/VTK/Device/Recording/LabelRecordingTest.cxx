// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a device on a volume with labels, whose state reports the touched label. Recordings must
 * replay bitwise with the same labels, and be refused without labels or with other labels.
 */

#include "Rigs/EventCounter.h"
#include "Rigs/GatedArray.h"
#include "Rigs/RecordingRig.h"

#include <vtkCallbackCommand.h>
#include <vtkExecutive.h>
#include <vtkHapticLabelTable.h>
#include <vtkHapticPathSource.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

using namespace devicetest;

namespace
{
class LabelRecording : public Recording
{
protected:
  LabelRecording()
  {
    this->Table->SetStiffness(-7, 300.0);
    this->Table->SetSurfaceStrength(-7, 3.0);
    this->Table->SetLabelName(-7, "liver");
    this->Table->SetStiffness(9, 700.0);
    this->Filter->SetLabelData(this->Labels);
    this->Filter->SetLabelTable(this->Table);
  }

  /// Expects that the replay causes one error with these words, and no output.
  void ExpectRefused(const std::vector<std::string>& words)
  {
    this->FilterLog.Errors.clear();
    MessageLog executive(this->Filter->GetExecutive());
    this->Filter->Update();
    ASSERT_EQ(this->FilterLog.Errors.size(), 1U);
    for (const std::string& word : words)
    {
      EXPECT_NE(this->FilterLog.Errors[0].find(word), std::string::npos)
        << word << " in " << this->FilterLog.Errors[0];
    }
    EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
    this->FilterLog.Errors.clear();
  }
  void ExpectTaken()
  {
    this->FilterLog.Errors.clear();
    this->Filter->Update();
    EXPECT_TRUE(this->FilterLog.Errors.empty());
    EXPECT_GT(this->Filter->GetOutput()->GetNumberOfPoints(), 20);
  }

  static vtkSmartPointer<vtkImageData> MakeHalves(double left, double right)
  {
    return MakeImage(16, VTK_SHORT, [=](const Point& p) { return p[0] < 7.5 ? left : right; });
  }

  vtkSmartPointer<vtkImageData> Labels = MakeHalves(-7.0, 9.0);
  vtkNew<vtkHapticLabelTable> Table;
};
} // namespace

TEST_F(LabelRecording, ReplaysToTheBitWithItsLabels)
{
  this->Begin();
  this->Wander(30);
  this->StartRecording();
  this->Wander(60);
  this->ExpectSame();
  auto* const settings =
    vtkStringArray::SafeDownCast(this->Recorded->GetFieldData()->GetAbstractArray("Settings"));
  ASSERT_NE(settings, nullptr);
  const std::string text = settings->GetValue(0);
  EXPECT_NE(text.find("LabelHash: " + this->Filter->HashLabels()), std::string::npos) << text;
  EXPECT_NE(text.find("liver"), std::string::npos) << text;

  const std::string hash = this->Filter->HashLabels();
  this->Filter->SetLabelData(nullptr);
  this->ExpectRefused({ "made with labels", "no label image", "port 3", "SetLabelTable" });
  this->Filter->SetLabelData(MakeHalves(-7.0, 8.0));
  this->ExpectRefused({ "made with labels", hash, this->Filter->HashLabels(), "they are others" });
  this->Filter->SetLabelData(MakeHalves(-7.0, 9.0)); // a copy
  this->ExpectTaken();
  // A worker thread hashes a large image, while the filter reports progress.
  vtkNew<GatedArray> gated;
  gated->DeepCopy(this->Labels->GetPointData()->GetScalars());
  vtkNew<vtkImageData> large;
  large->CopyStructure(this->Labels);
  large->GetPointData()->SetScalars(gated);
  vtkNew<vtkCallbackCommand> open;
  open->SetClientData(gated);
  open->SetCallback([](vtkObject*, unsigned long, void* array, void*)
    { static_cast<GatedArray*>(array)->IsOpen = true; });
  const unsigned long opener = this->Filter->AddObserver(vtkCommand::ProgressEvent, open);
  this->Filter->SetLabelData(large);
  this->ExpectTaken();
  EXPECT_GT(gated->Asked, 0);
  this->Filter->RemoveObserver(opener);
  this->Recorded->GetFieldData()->RemoveArray("Settings");
  this->Recorded->Modified();
  this->Filter->SetLabelData(nullptr);
  this->ExpectTaken();
}

TEST_F(LabelRecording, AsATableIsAPathForItsLabels)
{
  const std::string file = this->File("Labels.csv");
  this->Begin();
  ASSERT_TRUE(this->Device->GetRecorder()->Start(file.c_str()));
  this->Wander(60);
  ASSERT_TRUE(this->Device->GetRecorder()->Stop());
  this->Device->Stop();
  vtkNew<vtkHapticPathSource> path;
  path->SetShapeToFromFile();
  path->SetFileName(file);
  this->Filter->SetInputConnection(1, path->GetOutputPort());
  this->ExpectTaken();
  const std::string hash = this->Filter->HashLabels();
  this->Filter->SetLabelData(nullptr);
  this->ExpectRefused({ "made with labels", "no label image", ".csv.json" });
  this->Filter->SetLabelData(MakeHalves(5.0, 9.0));
  this->ExpectRefused({ "made with labels", hash, this->Filter->HashLabels(), ".csv.json" });
  // Unreadable fields may refer to other labels, so they must cause an error.
  for (const std::string fields : { "", "{" })
  {
    std::ofstream(file + ".json") << fields;
    path->Modified();
    MessageLog log(path);
    MessageLog executive(path->GetExecutive());
    path->Update();
    ASSERT_EQ(log.Errors.size(), 1U);
    EXPECT_NE(log.Errors[0].find("Labels.csv.json, can't be read"), std::string::npos)
      << log.Errors[0];
  }
  // A file whose fields contain no labels is an ordinary path, which must be accepted.
  for (const std::string fields : { "[1]", "{\"Settings\":5}", "{\"Settings\":\"none\"}" })
  {
    std::ofstream(file + ".json") << fields;
    path->Modified();
    this->ExpectTaken();
  }
  // A label whose name begins with "LabelHash" must not be read as the line "LabelHash".
  std::ofstream(file + ".json") << R"({"Settings":"Geometry: 0\n 5: LabelHash: 0123\n"})";
  path->Modified();
  this->ExpectTaken();
  std::ofstream(file + ".json") << R"({"Settings":"Geometry: 0\nLabelHash: 0123\n5: liver\n"})";
  path->Modified();
  this->ExpectRefused({ "of the hash 0123, " });
  std::remove((file + ".json").c_str());
  path->Modified();
  this->ExpectTaken();
}

TEST_F(LabelRecording, ReplaysToTheBitWithWallsOfLabels)
{
  this->Filter->SetGeometryFromLabels();
  this->Begin();
  this->Wander(20);
  this->StartRecording();
  this->Wander(80);
  this->ExpectSame(0.1);
}

TEST_F(LabelRecording, ReplaysToTheBitWithWallsOfThickSlices)
{
  this->Labels =
    MakeImage(16, VTK_SHORT, [](const Point& p) { return p[0] + 1.5 * p[2] < 12.0 ? -7.0 : 9.0; });
  this->Labels->SetSpacing(1.0, 1.0, 3.0);
  this->Filter->SetGeometryFromLabels();
  this->Filter->SetLabelData(this->Labels);
  this->Begin();
  this->Wander(20);
  this->StartRecording();
  this->Wander(80);
  this->ExpectSame(0.1);
  auto* const settings =
    vtkStringArray::SafeDownCast(this->Recorded->GetFieldData()->GetAbstractArray("Settings"));
  ASSERT_NE(settings, nullptr);
  std::string text = settings->GetValue(0);
  const std::string line = "\nLabelGrid: 1 x 1 x 3\n";
  ASSERT_NE(text.find(line), std::string::npos) << text;
  // A recording of an earlier version, which had no finer grids, must replay without a finer grid.
  this->Filter->Update();
  const auto fine = apitest::Keep(this->Filter);
  settings->SetValue(0, text.replace(text.find(line), line.size(), "\n"));
  this->Recorded->Modified();
  this->Filter->Update();
  EXPECT_FALSE(apitest::IsSame(fine, this->Filter->GetOutput()));
}

TEST_F(LabelRecording, TheStateTellsTheLabel)
{
  this->Begin();
  EXPECT_EQ(this->Device->GetState()->GetLabel(), -7);
  ASSERT_TRUE(this->Lead(11.0, 7.0, 5.0));
  EXPECT_EQ(this->Device->GetState()->GetLabel(), 9);
  ASSERT_TRUE(this->Lead(11.0, 7.0, 40.0));
  EXPECT_EQ(this->Device->GetState()->GetLabel(), 0) << "beyond the label image";
  this->Filter->SetLabelData(nullptr);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Lead(7.0, 7.0, 5.0));
  ASSERT_TRUE(this->WaitTicks(3));
  EXPECT_EQ(this->Device->GetState()->GetLabel(), 0) << "there is no label image";
}

TEST_F(LabelRecording, AForbiddenLabelIsToldOnce)
{
  // The label begins at z = 11.5 mm, and the wall is 1.5 mm in front of it. The wall alone can stop
  // the proxy, because the surface strength is 0.
  this->Filter->SetLabelData(
    MakeImage(16, VTK_SHORT, [](const Point& p) { return p[2] < 11.5 ? 0.0 : 9.0; }));
  this->Table->SetForbidden(9, true);
  this->Table->SetStandOff(1.5);
  SetConstant(this->Filter->GetProperty()->GetSurfaceStrength(), 0.0);
  SetConstant(this->Filter->GetProperty()->GetViscosity(), 0.0);
  const apitest::EventCounter events(this->Device, vtkCommand::UserEvent);
  this->Begin();
  ASSERT_TRUE(this->ArmFully());
  ASSERT_TRUE(this->LeadInto(9.5));
  EXPECT_FALSE(this->Device->GetState()->IsAtForbiddenLabel());
  EXPECT_EQ(Length(this->Device->GetState()->GetComputedForce()), 0.0);
  ASSERT_TRUE(this->LeadInto(12.0));
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetState()->IsAtForbiddenLabel(); }));
  EXPECT_NEAR(this->Device->GetState()->GetProxyPosition()[2], 10.0, 0.1);
  // The tip is 2 mm behind the wall. The point x_s, where the material is read, is inside the label
  // with 700 N/m.
  EXPECT_NEAR(this->Device->GetState()->GetComputedForce()[2], -700.0 * 0.002, 0.1);
  EXPECT_EQ(events.Count, 1);
  ASSERT_TRUE(this->Lead(7.0, 7.0, 6.0));
  EXPECT_FALSE(this->Device->GetState()->IsAtForbiddenLabel());
  EXPECT_EQ(events.Count, 1);
}

TEST_F(LabelRecording, AForbiddenLabelOfALargeImageDoesNotHoldTheProgramUp)
{
  // Repeat the test above with voxels of 0.15 mm: the label begins halfway between the slices 76
  // and 77.
  constexpr int n = 104;
  const auto labels =
    MakeImage(n, VTK_SHORT, [](const Point& p) { return p[2] < 76.5 ? 0.0 : 9.0; });
  labels->SetSpacing(0.15, 0.15, 0.15);
  this->Filter->SetLabelData(labels);
  this->Table->SetStandOff(1.5);
  SetConstant(this->Filter->GetProperty()->GetSurfaceStrength(), 0.0);
  SetConstant(this->Filter->GetProperty()->GetViscosity(), 0.0);
  const auto isMeasuring = [this]
  {
    return this->Device->GetStatusText().find("distances to forbidden labels are measured") !=
      std::string::npos;
  };
  this->Begin();
  ASSERT_TRUE(this->ArmFully());
  this->Table->SetForbidden(9, true);
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_FALSE(this->Device->IsPublished());
  EXPECT_TRUE(isMeasuring()) << this->Device->GetStatusText();
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE);
  ASSERT_TRUE(this->Wait([this] { return this->Device->IsPublished(); }));
  EXPECT_FALSE(isMeasuring());
  ASSERT_TRUE(this->LeadInto(12.0));
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetState()->IsAtForbiddenLabel(); }));
  EXPECT_NEAR(this->Device->GetState()->GetProxyPosition()[2], 76.5 * 0.15 - 1.5, 0.1);
  // A further change of the table, which allows the label again, must cancel the measurement of
  // distances.
  this->Table->SetStandOff(2.0);
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_TRUE(isMeasuring());
  this->Table->SetForbidden(9, false);
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_TRUE(this->Device->IsPublished());
  EXPECT_FALSE(isMeasuring());
  ASSERT_TRUE(this->Wait([this] { return !this->Device->GetState()->IsAtForbiddenLabel(); }));
}

TEST_F(LabelRecording, ThickSlicesOfALargeImageDoNotHoldTheProgramUp)
{
  // The slices are 0.9 mm apart, the pixels 0.15 mm. The label begins halfway between the slices 12
  // and 13.
  constexpr int n = 104;
  vtkNew<vtkImageData> slices;
  slices->SetDimensions(n, n, 18);
  slices->SetSpacing(0.15, 0.15, 0.9);
  slices->AllocateScalars(VTK_SHORT, 1);
  auto* const label = static_cast<short*>(slices->GetScalarPointer());
  std::fill_n(label, n * n * 13, short{ 0 });
  std::fill_n(label + n * n * 13, n * n * 5, short{ 9 });
  const auto isRefining = [this]
  { return this->Device->GetStatusText().find("between thick slices") != std::string::npos; };
  this->Begin();
  ASSERT_TRUE(this->ArmFully());
  this->Filter->SetLabelData(slices);
  this->Filter->SetGeometryFromLabels();
  this->Table->SetStiffness(9, 700.0);
  this->Table->SetSurfaceStrength(9, 5.0);
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_FALSE(this->Device->IsPublished());
  EXPECT_TRUE(isRefining()) << this->Device->GetStatusText();
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE);
  ASSERT_TRUE(this->Wait([this] { return this->Device->IsPublished(); }));
  EXPECT_FALSE(isRefining());
  ASSERT_TRUE(this->LeadInto(12.5 * 0.9 + 1.5));
  ASSERT_TRUE(this->Wait([this]
    { return std::abs(this->Device->GetState()->GetProxyPosition()[2] - 12.5 * 0.9) < 0.15; }));
  // With unchanged labels, a change of the materials must take effect at once.
  this->Table->SetStiffness(9, 600.0);
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_FALSE(isRefining());
  EXPECT_TRUE(this->Device->IsPublished());
  // Without walls around labels, there is nothing to wait for.
  slices->GetPointData()->GetScalars()->Modified();
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_TRUE(isRefining());
  this->Filter->SetGeometryFromScalars();
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_TRUE(this->Device->IsPublished());
  EXPECT_FALSE(isRefining());
}
