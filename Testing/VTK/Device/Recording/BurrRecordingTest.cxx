// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a burr in the hand: the tissue that it removes, undo under force, bitwise replays of
 * recordings with their removal, and other tools and devices on the same volume.
 */

#include "Rigs/RecordingRig.h"

#include <vtkHapticBurr.h>
#include <vtkHapticLabelTable.h>
#include <vtkHapticNeedle.h>
#include <vtkHapticRemoval.h>
#include <vtkPiecewiseFunction.h>
#include <vtkUnsignedCharArray.h>

using namespace devicetest;

namespace
{
class BurrRecording : public Recording
{
protected:
  BurrRecording()
  {
    this->Burr->SetRadius(2.5);
    this->Burr->SetSolidToAbove();
    this->Burr->SetContactValue(800.0);
    SetConstant(this->Burr->GetSpecificEnergy(), 1.0);
    this->Filter->SetTool(this->Burr);
  }
  ~BurrRecording() override { this->Device->GetVirtualHand()->SpinningOff(); }

  /// Starts the servo, and arms the device, because only an armed burr spins.
  void Begin()
  {
    Recording::Begin();
    this->Device->Arm();
  }
  vtkHapticRemoval* GetRemoval() { return this->Filter->GetRemoval(); }
  std::vector<unsigned char> GetShares()
  {
    vtkNew<vtkImageData> image;
    this->GetRemoval()->MakeShares(image);
    auto* const array = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
    return array ? std::vector<unsigned char>(
                     array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues())
                 : std::vector<unsigned char>();
  }
  bool IsRequestDone()
  {
    return this->Wait([this] { return this->GetRemoval()->GetNumberOfRequests() == 0; }) &&
      this->WaitTicks(2);
  }
  /// Presses at `x` (mm) until another `volume` (mm^3) is removed.
  bool Drill(double x, double volume)
  {
    const double goal = this->GetRemoval()->GetRemovedVolume() + volume;
    return this->Lead(x, 7.0, 4.0) && this->Lead(x, 7.0, 9.0) &&
      this->Wait([&] { return this->GetRemoval()->GetRemovedVolume() > goal; });
  }
  /// Stops the burr, which ends the stroke, so that no more tissue is removed.
  bool EndStroke()
  {
    this->Device->GetVirtualHand()->SpinningOff();
    return this->Wait([this] { return !this->Device->GetState()->IsSpinning(); }) &&
      this->WaitTicks(2);
  }
  /// Expects that the recording replays with the same forces, and results in the same remaining
  /// tissue.
  void ExpectSameRemoval()
  {
    ASSERT_TRUE(this->EndStroke());
    const auto shares = this->GetShares();
    this->ExpectSame(0.1);
    ASSERT_TRUE(this->GetRemoval()->ReadTrace(this->Filter->GetOutput()));
    EXPECT_EQ(this->GetShares(), shares);
  }

  vtkNew<vtkHapticBurr> Burr;
};
} // namespace

TEST_F(BurrRecording, RemovesWhileItSpins)
{
  this->Begin();
  ASSERT_TRUE(this->Lead(7.0, 7.0, 4.0));
  ASSERT_TRUE(this->Lead(7.0, 7.0, 9.0));
  ASSERT_TRUE(this->WaitTicks(100));
  EXPECT_GT(Length(this->Device->GetState()->GetComputedForce()), 0.2);
  EXPECT_FALSE(this->Device->GetState()->IsSpinning());
  EXPECT_EQ(this->GetRemoval()->GetRemovedVolume(), 0.0);
  this->Device->GetVirtualHand()->SpinningOn();
  EXPECT_TRUE(this->Device->GetVirtualHand()->GetSpinning());
  ASSERT_TRUE(this->Wait([this] { return this->GetRemoval()->GetRemovedVolume() > 1.0; }));
  EXPECT_TRUE(this->Device->GetState()->IsSpinning());
  EXPECT_FALSE(this->GetRemoval()->IsEmpty());
  EXPECT_FALSE(this->GetRemoval()->IsUsedUp());
  ASSERT_TRUE(this->EndStroke());
  EXPECT_EQ(this->GetRemoval()->GetNumberOfUndos(), 1);
}

TEST_F(BurrRecording, UndoAndRedoUnderTheHand)
{
  this->Begin();
  this->Device->GetVirtualHand()->SpinningOn();
  ASSERT_TRUE(this->Drill(6.0, 0.5));
  ASSERT_TRUE(this->EndStroke());
  const auto first = this->GetShares();
  const double volume = this->GetRemoval()->GetRemovedVolume();
  this->Device->GetVirtualHand()->SpinningOn();
  ASSERT_TRUE(this->Drill(9.0, 0.5));
  ASSERT_TRUE(this->EndStroke());
  const auto second = this->GetShares();
  ASSERT_NE(first, second);
  EXPECT_EQ(this->GetRemoval()->GetNumberOfUndos(), 2);
  // Undo must fill the hole around the hand without pushing the hand. Begin a new way, because the
  // tip may have moved while the loop paused.
  this->BeginWayHere();
  EXPECT_TRUE(this->GetRemoval()->Undo());
  ASSERT_TRUE(this->IsRequestDone());
  EXPECT_EQ(this->GetShares(), first);
  EXPECT_NEAR(this->GetRemoval()->GetRemovedVolume(), volume, 1e-9);
  EXPECT_LE(Length(this->Device->GetState()->GetComputedForce()), 1e-9);
  EXPECT_TRUE(this->GetRemoval()->Redo());
  ASSERT_TRUE(this->IsRequestDone());
  EXPECT_EQ(this->GetShares(), second);
  EXPECT_FALSE(this->GetRemoval()->Redo()) << "there is no more";
  // Undo must also work while the hand has the point instead of the burr, and redo after the servo
  // has stopped.
  this->Filter->SetTool(nullptr);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->WaitTicks(5));
  EXPECT_TRUE(this->GetRemoval()->Undo());
  ASSERT_TRUE(this->IsRequestDone());
  EXPECT_EQ(this->GetShares(), first);
  this->Device->Stop();
  EXPECT_TRUE(this->GetRemoval()->Redo());
  EXPECT_EQ(this->GetRemoval()->GetNumberOfRequests(), 0);
  EXPECT_EQ(this->GetShares(), second);
}

TEST_F(BurrRecording, ReplaysItsRemovalToTheBit)
{
  this->Begin();
  this->StartRecording();
  this->Device->GetVirtualHand()->SpinningOn();
  ASSERT_TRUE(this->Drill(7.0, 0.5));
  this->Wander(20);
  ASSERT_TRUE(this->EndStroke());
  this->Wander(3);
  EXPECT_TRUE(this->GetRemoval()->Undo());
  this->Wander(3);
  this->Device->GetVirtualHand()->SpinningOn();
  this->Wander(20);
  this->ExpectSameRemoval();
  EXPECT_FALSE(this->Recorded->GetFieldData()->HasArray("InitialBricks"));
}

/// The labels' specific energies must apply; the burr's own function would allow almost no removal.
TEST_F(BurrRecording, ReplaysWithTheEnergyOfLabels)
{
  const auto labels = MakeImage(16, VTK_SHORT, [](const Point& p) { return p[0] < 7.5 ? 2 : 3; });
  vtkNew<vtkHapticLabelTable> table;
  table->SetSpecificEnergy(2, 0.5);
  table->SetSpecificEnergy(3, 4.0);
  SetConstant(this->Burr->GetSpecificEnergy(), 1e6);
  this->Filter->SetLabelData(labels);
  this->Filter->SetLabelTable(table);
  this->Begin();
  this->StartRecording();
  this->Device->GetVirtualHand()->SpinningOn();
  ASSERT_TRUE(this->Drill(7.0, 0.5));
  this->Wander(20);
  this->ExpectSameRemoval();
}

TEST_F(BurrRecording, ReplaysFromWhatWasRemovedBefore)
{
  this->Begin();
  this->Device->GetVirtualHand()->SpinningOn();
  ASSERT_TRUE(this->Drill(7.0, 0.5));
  ASSERT_TRUE(this->EndStroke());
  this->Device->GetVirtualHand()->SpinningOn();
  ASSERT_TRUE(this->Drill(8.0, 0.5));
  EXPECT_GT(this->GetRemoval()->GetNumberOfUndos(), 0);
  this->StartRecording(); // starts while the burr drills
  this->Wander(20);
  this->Turn(20.0, 1.0); // changes the placement of the device
  this->Wander(10);
  EXPECT_TRUE(this->GetRemoval()->Undo()) << "of what was removed since the recording began";
  this->Wander(10);
  EXPECT_FALSE(this->GetRemoval()->GetNumberOfUndos() > 1);
  this->ExpectSameRemoval();
  ASSERT_TRUE(this->Recorded->GetFieldData()->HasArray("InitialBricks"));
  EXPECT_GT(this->Recorded->GetFieldData()->GetArray("InitialShares")->GetNumberOfTuples(), 1);
}

/// Stops a recording at once, and starts a second one, which must replay independently.
TEST_F(BurrRecording, ASecondRecordingBeginsAnew)
{
  this->Begin();
  this->Device->GetVirtualHand()->SpinningOn();
  ASSERT_TRUE(this->Drill(7.0, 0.3));
  this->StartRecording();
  ASSERT_TRUE(this->Device->GetRecorder()->Stop());
  this->Wander(10);
  this->StartRecording();
  EXPECT_TRUE(this->GetRemoval()->Reset());
  this->Wander(20);
  this->ExpectSameRemoval();
}

/// Records the touch of a drilled hole with the point, and replays it with a filter that has
/// drilled no hole.
TEST_F(BurrRecording, AHoleReplaysWithoutTheBurr)
{
  this->Begin();
  this->GetRemoval()->SetAirValue(-50.0);
  ASSERT_TRUE(this->Device->Publish());
  this->Device->GetVirtualHand()->SpinningOn();
  ASSERT_TRUE(this->Drill(7.0, 1.0));
  ASSERT_TRUE(this->EndStroke());
  this->Filter->SetTool(nullptr);
  ASSERT_TRUE(this->Device->Publish());
  this->StartRecording();
  this->Wander(10);
  EXPECT_TRUE(this->GetRemoval()->Reset());
  this->Wander(20);
  ASSERT_TRUE(this->Device->GetRecorder()->Stop());
  this->Device->Stop();
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(this->Name.c_str());
  reader->Update();
  vtkNew<vtkVolumeHapticsFilter> other;
  other->SetInputData(this->Image);
  other->GetProperty()->DeepCopy(this->Filter->GetProperty());
  other->SetInputData(1, reader->GetOutput());
  other->Update();
  vtkPolyData* const replayed = other->GetOutput();
  ASSERT_EQ(replayed->GetNumberOfPoints(), reader->GetOutput()->GetNumberOfPoints());
  for (vtkIdType i = 0; i < replayed->GetNumberOfPoints(); ++i)
  {
    for (const char* const array : { "Value", "NormalForce", "DragForce" })
    {
      ASSERT_EQ(Get(replayed, array, i), Get(reader->GetOutput(), array, i)) << array << " " << i;
    }
  }
}

TEST_F(BurrRecording, WithoutAServoRequestsAreCarriedOutAtOnce)
{
  this->Begin();
  this->Device->GetVirtualHand()->SpinningOn();
  ASSERT_TRUE(this->Drill(7.0, 0.5));
  ASSERT_TRUE(this->EndStroke());
  const auto shares = this->GetShares();
  this->Device->Stop();
  // An undo that is requested just before the servo stops must be carried out.
  ASSERT_TRUE(this->Device->Start());
  ASSERT_TRUE(this->WaitTicks(2));
  EXPECT_TRUE(this->GetRemoval()->Undo());
  this->Device->Stop();
  EXPECT_EQ(this->GetRemoval()->GetNumberOfRequests(), 0);
  EXPECT_TRUE(this->GetRemoval()->IsEmpty());
  // Publishing without a servo must not delay requests.
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_TRUE(this->GetRemoval()->Redo());
  EXPECT_EQ(this->GetRemoval()->GetNumberOfRequests(), 0);
  EXPECT_EQ(this->GetShares(), shares);
}

/// The device no longer uses the burr's filter, so requests to the removal must be executed at
/// once.
TEST_F(BurrRecording, ARemovalThatIsNoLongerFeltIsFree)
{
  this->Begin();
  this->Device->GetVirtualHand()->SpinningOn();
  ASSERT_TRUE(this->Drill(7.0, 0.3));
  ASSERT_TRUE(this->EndStroke());
  vtkNew<vtkVolumeHapticsFilter> other;
  other->SetInputData(this->Image);
  this->Device->SetVolumeHaptics(other);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->WaitTicks(5));
  EXPECT_TRUE(this->GetRemoval()->Undo());
  EXPECT_EQ(this->GetRemoval()->GetNumberOfRequests(), 0);
  EXPECT_TRUE(this->GetRemoval()->IsEmpty());
}

TEST_F(BurrRecording, AnotherDeviceNeedsAnotherRemoval)
{
  this->Begin();
  vtkNew<vtkHapticDevice> other;
  other->SetVolumeHaptics(this->Filter);
  ASSERT_TRUE(other->Open("virtual"));
  {
    MessageLog log(other);
    EXPECT_FALSE(other->Start());
    ASSERT_EQ(log.Errors.size(), 1u);
    EXPECT_NE(log.Errors[0].find("SetRemoval"), std::string::npos) << log.Errors[0];
  }
  this->Device->Stop();
  EXPECT_TRUE(other->Start());
  other->Close();
  EXPECT_TRUE(this->Device->Start());
}

TEST_F(BurrRecording, AFileIsReadUnderTheHand)
{
  const std::string file = this->File("Removal.vti");
  this->Begin();
  this->Device->GetVirtualHand()->SpinningOn();
  ASSERT_TRUE(this->Drill(7.0, 0.5));
  ASSERT_TRUE(this->EndStroke());
  const auto shares = this->GetShares();
  ASSERT_TRUE(this->GetRemoval()->WriteFile(file));
  EXPECT_TRUE(this->GetRemoval()->Reset());
  ASSERT_TRUE(this->IsRequestDone());
  ASSERT_NE(this->GetShares(), shares);
  ASSERT_TRUE(this->GetRemoval()->ReadFile(file));
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->WaitTicks(5));
  EXPECT_EQ(this->GetShares(), shares);
  this->Device->GetVirtualHand()->SpinningOn();
  ASSERT_TRUE(this->Drill(8.0, 0.2)) << "the servo goes on with it";
  EXPECT_NE(this->GetShares(), shares);
}

TEST_F(BurrRecording, SpinsWhileItsButtonIsPressed)
{
  this->Burr->SetSpinButton(1);
  Recording::Begin();
  this->Device->GetVirtualHand()->SetButtons(2);
  ASSERT_TRUE(this->WaitTicks(5));
  EXPECT_FALSE(this->Device->GetState()->IsSpinning()) << "nothing would be felt";
  this->Device->Arm();
  this->Device->GetVirtualHand()->SetButtons(1);
  ASSERT_TRUE(this->WaitTicks(5));
  EXPECT_FALSE(this->Device->GetState()->IsSpinning()) << "that is another one";
  this->Device->GetVirtualHand()->SetButtons(3);
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetState()->IsSpinning(); }));
  // While long work suppresses the force, the burr must not spin, even if its button is pressed.
  this->Device->BeginLongWork("the test thinks", 10.0);
  ASSERT_TRUE(this->Wait([this] { return !this->Device->GetState()->IsSpinning(); }));
  this->Device->EndLongWork();
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetState()->IsSpinning(); }));
  this->Device->GetVirtualHand()->SetButtons(0);
  ASSERT_TRUE(this->Wait([this] { return !this->Device->GetState()->IsSpinning(); }));
  this->Burr->SetSpinButton(-1);
  ASSERT_TRUE(this->Device->Publish());
  this->Device->GetVirtualHand()->SetButtons(-1);
  ASSERT_TRUE(this->WaitTicks(5));
  EXPECT_FALSE(this->Device->GetState()->IsSpinning());
  this->Filter->SetTool(nullptr);
  this->Device->GetVirtualHand()->SpinningOn();
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->WaitTicks(5));
  EXPECT_FALSE(this->Device->GetState()->IsSpinning()) << "a point does not spin";
}

TEST_F(BurrRecording, TheToolMayChangeUnderForce)
{
  vtkNew<vtkHapticNeedle> needle;
  this->Begin();
  this->Device->GetVirtualHand()->SpinningOn();
  for (vtkHapticTool* const next :
    { static_cast<vtkHapticTool*>(nullptr), static_cast<vtkHapticTool*>(needle.Get()) })
  {
    ASSERT_TRUE(this->Lead(7.0, 7.0, 4.0));
    ASSERT_TRUE(this->WaitFullyArmed());
    const double before = this->GetRemoval()->GetRemovedVolume();
    ASSERT_TRUE(this->LeadInto(8.5));
    ASSERT_TRUE(this->Wait([&] { return this->GetRemoval()->GetRemovedVolume() > before + 0.2; }));
    this->Filter->SetTool(next);
    ASSERT_TRUE(this->Device->Publish());
    ASSERT_TRUE(this->WaitTicks(20));
    EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE) << this->Device->GetStatusText();
    EXPECT_FALSE(this->Device->GetState()->IsSpinning());
    const auto shares = this->GetShares();
    ASSERT_TRUE(this->WaitTicks(50));
    EXPECT_EQ(this->GetShares(), shares) << "only a burr removes";
    this->Filter->SetTool(this->Burr);
    ASSERT_TRUE(this->Device->Publish());
  }
}
