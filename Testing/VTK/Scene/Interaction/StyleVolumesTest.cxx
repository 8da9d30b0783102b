// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests volumes with rendering settings that haptics can't reproduce. Each reason must cause one
 * warning.
 */

#include "Rigs/LoopPauses.h"
#include "StyleRig.h"

#include <vtkAssembly.h>
#include <vtkDataSetAttributes.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkHapticHeadUpDisplay.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkMultiVolume.h>
#include <vtkPlane.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

using namespace scenetest;

namespace
{
class StyleVolumes : public StyleTest
{
protected:
  StyleVolumes()
  {
    this->Mapper = vtkSmartPointer<vtkGPUVolumeRayCastMapper>::New();
    this->Mapper->SetInputData(this->Ball);
    this->Volume->SetMapper(this->Mapper);
    ShowBall(this->Volume);
    this->Renderer->AddVolume(this->Volume);
    this->Device->Open("virtual");
    this->Device->Start();
    this->Run(2);
  }
  /// Returns the number of warnings since the last call. Expects that the newest warning contains
  /// the words and a remedy.
  std::size_t CountWarnings(const char* words = "")
  {
    this->Style->UpdateHaptics();
    this->Style->UpdateHaptics();
    const std::size_t count = this->Log.Warnings.size();
    if (count > 0)
    {
      EXPECT_NE(this->Log.Warnings.back().find(words), std::string::npos)
        << this->Log.Warnings.back();
      EXPECT_NE(this->Log.Warnings.back().find("Cure:"), std::string::npos);
    }
    this->Log.Warnings.clear();
    return count;
  }
  /// Presses into the middle of the view until the ball exerts a force.
  void Push()
  {
    this->Pointer(150, 150);
    this->Style->TouchModeOn();
    this->RunUntilFullyArmed();
    for (int i = 0; i < 6; ++i)
    {
      this->Pointer(150, 150, vtkCommand::MouseWheelForwardEvent);
      this->Run(10);
    }
    ASSERT_GT(Length(this->Device->GetState()->GetForce()), 0.3) << "N";
    ASSERT_TRUE(this->Log.Warnings.empty()) << this->Log.Warnings[0];
  }
  /// Expects that the touch has ended and can't start again, and that each attempt has caused a
  /// warning with the remedy.
  void ExpectLetGo(const std::string& cure)
  {
    for (const char* const when : { "touched before", "begins anew" })
    {
      this->RunUntilReady();
      EXPECT_FALSE(this->Style->GetTouchMode()) << when;
      EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::READY) << when;
      EXPECT_EQ(Length(this->Device->GetState()->GetForce()), 0.0) << when;
      ASSERT_EQ(this->Log.Warnings.size(), 1U) << when;
      EXPECT_NE(this->Log.Warnings[0].find(cure), std::string::npos) << this->Log.Warnings[0];
      this->Log.Warnings.clear();
      this->Style->TouchModeOn();
    }
    this->Log.Warnings.clear();
    // Arming without touch mode, as with a hardware device, must also be refused.
    this->Device->Arm();
    this->RunUntilReady();
    EXPECT_EQ(this->Log.Warnings.size(), 1U);
    this->Log.Warnings.clear();
  }
  /// Updates the style until the force has faded.
  void RunUntilReady()
  {
    EXPECT_TRUE(Eventually(
      [this]
      {
        this->Style->UpdateHaptics();
        return this->Device->GetStatus() == vtkHapticDevice::READY;
      }));
  }
  /// Returns the largest change (N) of the force between two ticks, until the force is 0.
  double MeasureLargestStep(LoopPauses& pauses)
  {
    double last = Length(this->Device->GetState()->GetForce());
    double largest = 0.0;
    EXPECT_TRUE(Eventually(
      [&]
      {
        this->Style->UpdateHaptics();
        pauses.Look(this->Device);
        vtkTable* const states = this->Style->GetStates();
        for (vtkIdType i = 0; i < states->GetNumberOfRows(); ++i)
        {
          const double force =
            Length(vtkDataArray::SafeDownCast(states->GetColumnByName("Command"))->GetTuple3(i));
          largest = std::max(largest, std::abs(force - last));
          last = force;
        }
        return last == 0.0 && this->Device->GetStatus() == vtkHapticDevice::READY;
      }));
    return largest;
  }

  vtkSmartPointer<vtkVolumeMapper> Mapper;
  vtkNew<vtkVolume> Volume;
};

constexpr const char* Moved = "moved, turned or scaled";
} // namespace

TEST_F(StyleVolumes, ThatArePlainGiveNone)
{
  EXPECT_EQ(this->CountWarnings(), 0U);
  // These settings neither cut nor move the volume.
  this->Mapper->CroppingOn();
  this->Mapper->SetCroppingRegionPlanes(-50.0, 50.0, -50.0, 50.0, -50.0, 50.0);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, -50.0);
  this->Mapper->AddClippingPlane(plane);
  vtkNew<vtkMatrix4x4> unity;
  this->Volume->SetUserMatrix(unity);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(this->Ball->GetNumberOfPoints());
  ghosts->FillValue(0);
  this->Ball->GetPointData()->AddArray(ghosts);
  EXPECT_EQ(this->CountWarnings(), 0U);
}

TEST_F(StyleVolumes, ThatAreMovedWarnOncePerWay)
{
  this->Volume->SetPosition(5.0, 0.0, 0.0);
  EXPECT_EQ(this->CountWarnings(Moved), 1U);
  EXPECT_EQ(this->CountWarnings(), 0U) << "once";
  this->Volume->SetPosition(6.0, 0.0, 0.0);
  EXPECT_EQ(this->CountWarnings(), 0U) << "the same reason";
  this->Volume->SetPosition(0.0, 0.0, 0.0);
  EXPECT_EQ(this->CountWarnings(), 0U);
  this->Volume->RotateZ(10.0);
  EXPECT_EQ(this->CountWarnings(Moved), 1U);
  this->Volume->SetOrientation(0.0, 0.0, 0.0);
  EXPECT_EQ(this->CountWarnings(), 0U);
  this->Volume->SetScale(2.0);
  EXPECT_EQ(this->CountWarnings(Moved), 1U);
  this->Volume->SetScale(1.0);
  EXPECT_EQ(this->CountWarnings(), 0U);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 0, -1.0);
  this->Volume->SetUserMatrix(matrix);
  EXPECT_EQ(this->CountWarnings(Moved), 1U);
}

TEST_F(StyleVolumes, ThatShowTheSameScalarsInTheSamePlaceGiveNone)
{
  // The volume's matrix places the image, as in the explorer.
  this->Ball->SetOrigin(-40.0, 3.0, 2.0);
  double turn[9] = { 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0 };
  this->Ball->SetDirectionMatrix(turn);
  vtkNew<vtkImageData> plain;
  plain->ShallowCopy(this->Ball);
  plain->SetOrigin(0.0, 0.0, 0.0);
  plain->GetDirectionMatrix()->Identity();
  plain->SetDirectionMatrix(plain->GetDirectionMatrix()->GetData());
  this->Mapper->SetInputData(plain);
  EXPECT_EQ(this->CountWarnings(Moved), 1U) << "shown somewhere else";
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 3; ++row)
  {
    matrix->SetElement(row, 3, this->Ball->GetOrigin()[row]);
    for (int column = 0; column < 3; ++column)
    {
      matrix->SetElement(row, column, turn[3 * row + column]);
    }
  }
  this->Volume->SetUserMatrix(matrix);
  EXPECT_EQ(this->CountWarnings(), 0U);
}

TEST_F(StyleVolumes, ThatAreTouchedAreFeltWhereTheyAre)
{
  this->Style->TouchVolume(this->Volume);
  EXPECT_EQ(this->Style->GetTouchedVolume(), this->Volume);
  // The ball of 30 mm at the origin becomes a ball of 60 mm at (5, 0, 0).
  this->Volume->SetPosition(5.0, 0.0, 0.0);
  this->Volume->RotateZ(30.0);
  this->Volume->SetScale(2.0);
  EXPECT_EQ(this->CountWarnings(), 0U);
  vtkNew<vtkPolyData> path;
  vtkNew<vtkPoints> points;
  for (int i = 0; i <= 180; ++i)
  {
    points->InsertNextPoint(75.0 - 0.1 * i, 0.0, 0.0);
  }
  path->SetPoints(points);
  const auto forceAt = [&](double x)
  {
    this->Filter->SetPathData(path);
    this->Filter->Update();
    vtkDataArray* const force = this->Filter->GetOutput()->GetPointData()->GetArray("Force");
    const auto tick = static_cast<vtkIdType>(std::lround((75.0 - x) / 0.1));
    return force && force->GetNumberOfTuples() == 181 ? force->GetComponent(tick, 0) : -1.0;
  };
  // The ball's visible surface is at x = 65 mm.
  EXPECT_EQ(forceAt(65.5), 0.0);
  EXPECT_NEAR(forceAt(62.0), 500.0 * 0.003, 0.1);
  this->Volume->SetOrientation(0.0, 40.0, 0.0);
  this->Volume->SetPosition(3.0, 0.0, 0.0);
  EXPECT_EQ(this->CountWarnings(), 0U);
  EXPECT_NEAR(forceAt(60.0), 500.0 * 0.003, 0.1) << "the volume has moved by 2 mm";
  // Parts that the mapper clips must not be felt. The clipping plane is in world coordinates.
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(50.0, 0.0, 0.0);
  plane->SetNormal(-1.0, 0.0, 0.0);
  this->Mapper->AddClippingPlane(plane);
  EXPECT_EQ(this->CountWarnings("Cure: FeelCutFacesOn()"), 1U);
  EXPECT_EQ(forceAt(60.0), 0.0);
  plane->SetOrigin(70.0, 0.0, 0.0);
  EXPECT_NEAR(forceAt(60.0), 500.0 * 0.003, 0.1);
  // Cropping planes are in coordinates of the data. The face at x = 24 is at 3 + 2 * 24 = 51 in the
  // world.
  this->Volume->SetOrientation(0.0, 0.0, 0.0);
  this->Mapper->CroppingOn();
  this->Mapper->SetCroppingRegionPlanes(-50.0, 24.0, -50.0, 50.0, -50.0, 50.0);
  EXPECT_EQ(this->CountWarnings(), 0U);
  EXPECT_EQ(forceAt(60.0), 0.0);
  EXPECT_NEAR(this->Filter->GetCroppingRegionPlanes()[1], 51.0, 1e-9);
  this->Mapper->CroppingOff();
  EXPECT_EQ(this->CountWarnings(), 0U);
  EXPECT_NEAR(forceAt(60.0), 500.0 * 0.003, 0.1);
  // A volume with a shear must cause a warning.
  vtkNew<vtkMatrix4x4> shear;
  shear->SetElement(0, 1, 0.5);
  this->Volume->SetUserMatrix(shear);
  EXPECT_EQ(this->CountWarnings(Moved), 1U);
}

TEST_F(StyleVolumes, ThatCantBeTouchedAreErrors)
{
  this->Device->Stop();
  this->Device->SetVolumeHaptics(nullptr);
  vtkNew<vtkVolume> empty;
  EXPECT_FALSE(this->Style->TouchVolume(empty));
  ASSERT_EQ(this->Log.Errors.size(), 1U);
  EXPECT_NE(this->Log.Errors[0].find("vtkVolume::SetMapper()"), std::string::npos);
  EXPECT_NE(this->Device->GetVolumeHaptics(), nullptr) << "the next line may set it up";
  EXPECT_EQ(this->Style->GetTouchedVolume(), nullptr);
  vtkNew<vtkGPUVolumeRayCastMapper> bare;
  empty->SetMapper(bare);
  EXPECT_FALSE(this->Style->TouchVolume(empty));
  EXPECT_EQ(this->Log.Errors.size(), 2U);
  bare->SetInputData(this->Ball);
  EXPECT_TRUE(this->Style->TouchVolume(empty));
  EXPECT_EQ(this->Style->GetTouchedVolume(), empty);
  EXPECT_TRUE(this->Style->TouchVolume(nullptr));
  this->Style->SetDevice(nullptr);
  EXPECT_FALSE(this->Style->TouchVolume(this->Volume));
  ASSERT_EQ(this->Log.Errors.size(), 3U);
  EXPECT_NE(this->Log.Errors[2].find("SetDevice()"), std::string::npos);
  this->Log.Errors.clear();
}

// Ends the touch with a renderer that draws nothing, a volume without a mapper, and a mapper
// without an input. The volume can be touched again once each is restored.
TEST_F(StyleVolumes, ThatShowNothingAreNotFelt)
{
  vtkNew<vtkHapticHeadUpDisplay> display;
  display->SetDevice(this->Device);
  this->Style->SetHeadUpDisplay(display);
  ASSERT_TRUE(this->Style->TouchVolume(this->Volume));
  const auto expectLetGo = [&](const char* cure)
  {
    this->ExpectLetGo(cure);
    EXPECT_NE(std::string(display->GetHint()).find("can't be felt"), std::string::npos) << cure;
  };
  this->Push();
  this->Renderer->DrawOff();
  expectLetGo("DrawOn() of the renderer");
  this->Renderer->DrawOn();
  this->Push();
  this->Volume->SetMapper(nullptr);
  expectLetGo("Cure: SetMapper() of the vtkVolume");
  this->Volume->SetMapper(this->Mapper);
  this->Push();
  this->Mapper->RemoveAllInputs();
  expectLetGo("SetInputData() or SetInputConnection() of the mapper");
  this->Mapper->SetInputData(this->Ball);
  this->Push();
  EXPECT_EQ(std::string(display->GetHint()).find("can't be felt"), std::string::npos);
}

TEST_F(StyleVolumes, ThatAreHiddenAreNotFelt)
{
  vtkNew<vtkHapticHeadUpDisplay> display;
  display->SetDevice(this->Device);
  this->Style->SetHeadUpDisplay(display);
  this->Style->TouchVolume(this->Volume);
  this->Push();
  this->Volume->VisibilityOff();
  this->ExpectLetGo("Cure: VisibilityOn() of the vtkVolume");
  EXPECT_NE(std::string(display->GetHint()).find("can't be felt"), std::string::npos);
  this->Volume->VisibilityOn();
  this->Push();
  EXPECT_EQ(std::string(display->GetHint()).find("can't be felt"), std::string::npos);
}

// The fade takes 50 ms (ForceGate::FadeTime), so at 1000 Hz the force falls by a fiftieth in each
// tick.
TEST_F(StyleVolumes, ThatAreHiddenOrRemovedFade)
{
  constexpr double ticks = 50.0;
  this->Style->TouchVolume(this->Volume);
  for (const bool isRemoved : { false, true })
  {
    LoopPauses pauses;
    double force = 0.0;
    double step = 0.0;
    do // repeats if the servo was held up, since the fade then began at another force
    {
      this->Push();
      this->Style->UpdateHaptics(); // drains the earlier states
      pauses.Look(this->Device);
      pauses.Forget();
      force = Length(this->Device->GetState()->GetForce());
      isRemoved ? this->Renderer->RemoveVolume(this->Volume) : this->Volume->VisibilityOff();
      step = this->MeasureLargestStep(pauses);
      this->Log.Warnings.clear();
      this->Volume->VisibilityOn();
      this->Renderer->AddVolume(this->Volume);
    } while (pauses.WasHeldUp() && !this->HasFatalFailure());
    EXPECT_LT(step, 1.2 * force / ticks) << (isRemoved ? "removed" : "hidden");
    EXPECT_GT(step, 0.0);
  }
}

TEST_F(StyleVolumes, ThatAreReplacedAreNotFelt)
{
  this->Style->TouchVolume(this->Volume);
  this->Push();
  this->Renderer->RemoveVolume(this->Volume);
  vtkNew<vtkVolume> other;
  other->SetMapper(this->Mapper);
  ShowBall(other);
  this->Renderer->AddVolume(other);
  this->ExpectLetGo("Cure: TouchVolume() of the interactor style");
  this->Style->TouchVolume(other);
  this->Push();
}

TEST_F(StyleVolumes, OfAnotherRendererAreNotFeltUnlessItShowsTheSame)
{
  vtkNew<vtkRenderer> beside;
  beside->SetViewport(0.5, 0.0, 1.0, 1.0);
  this->Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  this->Window->AddRenderer(beside);
  this->Style->TouchVolume(this->Volume);
  this->Style->SetDefaultRenderer(beside);
  this->Device->Arm();
  this->ExpectLetGo("SetDefaultRenderer() of the style");
  this->Style->SetDefaultRenderer(this->Renderer);
  this->Style->TouchModeOn();
  EXPECT_TRUE(this->Style->GetTouchMode());
  // The renderer is a layer over the renderer with the volume, and shares its camera.
  beside->SetViewport(this->Renderer->GetViewport());
  beside->SetActiveCamera(this->Renderer->GetActiveCamera());
  this->Style->SetDefaultRenderer(beside);
  this->Run(20);
  EXPECT_TRUE(this->Style->GetTouchMode());
  // Without a default renderer, the volumes of all renderers in the window can be touched, so the
  // touch must continue.
  this->Style->SetDefaultRenderer(nullptr);
  beside->SetActiveCamera(nullptr);
  this->Run(20);
  EXPECT_TRUE(this->Style->GetTouchMode());
  EXPECT_TRUE(this->Log.Warnings.empty());
}

// The world position is the assembly's matrix times the part's matrix: (2, 0, 0) + 2 * ((3, 0, 0) +
// x).
TEST_F(StyleVolumes, OfAnAssemblyAreFeltWhereItPutsThem)
{
  this->Renderer->RemoveVolume(this->Volume);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(this->Volume);
  assembly->SetPosition(2.0, 0.0, 0.0);
  assembly->SetScale(2.0);
  this->Renderer->AddActor(assembly);
  this->Volume->SetPosition(3.0, 0.0, 0.0);
  EXPECT_EQ(this->CountWarnings(Moved), 1U) << "the filter has the image alone";
  this->Style->TouchVolume(this->Volume);
  EXPECT_EQ(this->CountWarnings(), 0U);
  vtkImageData* const felt = this->Filter->GetTouchedImage();
  EXPECT_DOUBLE_EQ(felt->GetOrigin()[0], 2.0 + 2.0 * (3.0 - 48.0));
  EXPECT_DOUBLE_EQ(felt->GetOrigin()[1], -96.0);
  EXPECT_DOUBLE_EQ(felt->GetSpacing()[2], 2.0);
  assembly->SetPosition(4.0, 0.0, 0.0);
  EXPECT_EQ(this->CountWarnings(), 0U);
  EXPECT_DOUBLE_EQ(this->Filter->GetTouchedImage()->GetOrigin()[0], 4.0 + 2.0 * (3.0 - 48.0));
  this->Device->Arm();
  this->Run(20);
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ARMED);
  assembly->VisibilityOff();
  this->ExpectLetGo("Cure: TouchVolume()");
}

TEST_F(StyleVolumes, OfAMultiVolumeAreFeltEachAtItsPlace)
{
  this->Renderer->RemoveVolume(this->Volume);
  vtkNew<vtkMultiVolume> multi;
  vtkNew<vtkVolume> parts[2];
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  multi->SetMapper(mapper);
  const auto other = MakeBall();
  for (int port = 0; port < 2; ++port)
  {
    mapper->SetInputDataObject(port, port == 0 ? other.Get() : this->Ball.Get());
    multi->SetVolume(parts[port], port);
    ShowBall(parts[port]);
  }
  this->Renderer->AddVolume(multi);
  EXPECT_EQ(this->CountWarnings(), 0U) << "the filter's image is where it is";
  parts[1]->SetPosition(5.0, 0.0, 0.0);
  EXPECT_EQ(this->CountWarnings(Moved), 1U);
  vtkNew<vtkVolumeHapticsFilter> both;
  EXPECT_FALSE(this->Style->AddTouchedVolume(multi, both));
  ASSERT_EQ(this->Log.Errors.size(), 1U);
  EXPECT_NE(
    this->Log.Errors[0].find("Cure: TouchVolume() with the vtkMultiVolume, or"), std::string::npos);
  this->Log.Errors.clear();
  EXPECT_EQ(this->Style->GetTouchedVolume(), nullptr);
  // This test follows the second remedy in the error. StyleSeveral.EachPortOfAMultiVolumeIsTouched
  // follows the first one.
  parts[1]->SetPosition(0.0, 0.0, 5.0);
  ASSERT_TRUE(this->Style->TouchVolume(multi->GetVolume(1)));
  vtkNew<vtkVolumeHapticsFilter> first;
  EXPECT_TRUE(this->Style->AddTouchedVolume(multi->GetVolume(0), first));
  EXPECT_EQ(this->CountWarnings(), 0U);
  EXPECT_EQ(first->GetTouchedImage(), other);
  this->Push();
  EXPECT_EQ(this->Filter->GetTouchedImage()->GetOrigin()[2], -43.0);
  EXPECT_EQ(this->Filter->GetTouchedImage()->GetPointData()->GetScalars(),
    this->Ball->GetPointData()->GetScalars());
  multi->VisibilityOff();
  this->ExpectLetGo("not felt");
}

TEST_F(StyleVolumes, ThatAreCutWarn)
{
  this->Mapper->CroppingOn();
  this->Mapper->SetCroppingRegionPlanes(-10.0, 10.0, -50.0, 50.0, -50.0, 50.0);
  EXPECT_EQ(this->CountWarnings("crops"), 1U);
  this->Mapper->CroppingOff();
  vtkNew<vtkPlane> plane;
  this->Mapper->AddClippingPlane(plane);
  EXPECT_EQ(this->CountWarnings("clipping planes"), 1U);
  this->Mapper->CroppingOn();
  this->Mapper->SetCroppingRegionFlagsToFence();
  EXPECT_EQ(this->CountWarnings("crops"), 1U) << "another reason";
}

TEST_F(StyleVolumes, WithAMaskWarn)
{
  vtkNew<vtkImageData> mask;
  mask->SetDimensions(this->Ball->GetDimensions());
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* const mapper = vtkGPUVolumeRayCastMapper::SafeDownCast(this->Mapper);
  mapper->SetMaskInput(mask);
  mapper->SetMaskTypeToLabelMap();
  EXPECT_EQ(this->CountWarnings(), 0U) << "labels only colour voxels";
  vtkNew<vtkPiecewiseFunction> hidden;
  this->Volume->GetProperty()->SetLabelScalarOpacity(1, hidden);
  EXPECT_EQ(this->CountWarnings("mask"), 1U) << "unless they have an opacity";
  mapper->SetMaskInput(nullptr);
  EXPECT_EQ(this->CountWarnings(), 0U);
  mapper->SetMaskTypeToBinary();
  mapper->SetMaskInput(mask);
  EXPECT_EQ(this->CountWarnings("mask"), 1U);
}

// The expected force is that of ThatAreTouchedAreFeltWhereTheyAre: the tip is 3 mm behind the
// surface at 30 mm.
TEST_F(StyleVolumes, ThatAreMaskedAreFeltWhereTheMaskShowsThem)
{
  auto* const mapper = vtkGPUVolumeRayCastMapper::SafeDownCast(this->Mapper);
  vtkNew<vtkImageData> mask;
  // The mask's origin differs, which must have no effect.
  mask->SetDimensions(this->Ball->GetDimensions());
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (vtkIdType i = 0; i < mask->GetNumberOfPoints(); ++i)
  {
    mask->GetPointData()->GetScalars()->SetTuple1(
      i, this->Ball->GetPoint(i)[0] > 0.0 ? 0.0 : 255.0);
  }
  mapper->SetMaskTypeToBinary();
  mapper->SetMaskInput(mask);
  this->Style->TouchVolume(this->Volume);
  EXPECT_EQ(this->CountWarnings("Cure: FeelCutFacesOn()"), 1U);
  const auto forceAt = [&](double x)
  {
    vtkNew<vtkPolyData> path;
    vtkNew<vtkPoints> points;
    for (int i = 0; i <= 140; ++i)
    {
      points->InsertNextPoint(x * (40.0 - 0.1 * i) / 27.0, 0.0, 0.0);
    }
    path->SetPoints(points);
    this->Filter->SetPathData(path);
    this->Filter->Update();
    vtkDataArray* const force = this->Filter->GetOutput()->GetPointData()->GetArray("Force");
    return force && force->GetNumberOfTuples() == 141 ? force->GetComponent(130, 0) : HUGE_VAL;
  };
  EXPECT_EQ(forceAt(27.0), 0.0) << "hidden";
  EXPECT_NEAR(forceAt(-27.0), -500.0 * 0.003, 0.1);
  // The mask must rotate with the volume.
  this->Volume->RotateZ(180.0);
  EXPECT_EQ(this->CountWarnings(), 0U);
  EXPECT_NEAR(forceAt(27.0), 500.0 * 0.003, 0.1);
  EXPECT_EQ(forceAt(-27.0), 0.0);
  // A change of the mask's values must take effect at once.
  mask->GetPointData()->GetScalars()->Fill(1.0);
  mask->Modified();
  EXPECT_EQ(this->CountWarnings(), 0U);
  EXPECT_NEAR(forceAt(-27.0), -500.0 * 0.003, 0.1);
  // Touching another volume must remove the mask from the filter, and touching this volume again
  // must restore it.
  const auto isBlanked = [this] { return this->Filter->GetTouchedImage()->HasAnyBlankPoints(); };
  mask->GetPointData()->GetScalars()->SetTuple1(0, 0.0);
  mask->Modified();
  EXPECT_EQ(this->CountWarnings(), 0U);
  EXPECT_TRUE(isBlanked());
  vtkNew<vtkVolume> other;
  vtkNew<vtkGPUVolumeRayCastMapper> otherMapper;
  otherMapper->SetInputData(this->Ball);
  other->SetMapper(otherMapper);
  ShowBall(other);
  this->Style->TouchVolume(other);
  EXPECT_FALSE(isBlanked());
  this->Style->TouchVolume(this->Volume);
  EXPECT_TRUE(isBlanked());
  mapper->SetMaskInput(nullptr);
  EXPECT_EQ(this->CountWarnings(), 0U);
  EXPECT_FALSE(isBlanked());
  // Labels that the application has set on the filter must remain.
  this->Filter->SetLabelData(mask);
  mapper->SetMaskInput(mask);
  EXPECT_EQ(this->CountWarnings("Cure: FeelCutFacesOn()"), 1U);
  EXPECT_EQ(this->Filter->GetInputDataObject(3, 0), mask);
  EXPECT_TRUE(isBlanked());
  // A mask of another size must not be used, because mappers render it in undefined ways.
  vtkNew<vtkImageData> small;
  small->SetDimensions(9, 9, 9);
  small->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  mapper->SetMaskInput(small);
  EXPECT_EQ(this->CountWarnings("masks of as many voxels as the image has"), 1U);
}

TEST_F(StyleVolumes, WithATransferFunctionOfTwoDimensionsWarn)
{
  vtkNew<vtkImageData> function;
  function->SetDimensions(2, 2, 1);
  function->AllocateScalars(VTK_FLOAT, 4);
  this->Volume->GetProperty()->SetTransferFunction2D(function);
  // VTK 9.6 does not set the mode together with the function, so set it here.
  this->Volume->GetProperty()->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  EXPECT_EQ(this->CountWarnings("2-D transfer function"), 1U);
}

TEST_F(StyleVolumes, WithBlanksWarnIfTheirMapperDrawsThem)
{
  // The GPU mapper does not draw the hidden point, so it must not be felt.
  vtkUnsignedCharArray* const points = this->Ball->AllocatePointGhostArray();
  points->SetValue(1234, vtkDataSetAttributes::HIDDENPOINT);
  EXPECT_EQ(this->CountWarnings(), 0U);
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->SetInputData(this->Ball);
  this->Volume->SetMapper(mapper);
  EXPECT_EQ(this->CountWarnings("vtkGhostType"), 1U);
  // marks a point that is drawn like other points
  points->SetValue(1234, vtkDataSetAttributes::DUPLICATEPOINT);
  points->Modified();
  EXPECT_EQ(this->CountWarnings(), 0U);
  this->Ball->AllocateCellGhostArray()->SetValue(77, vtkDataSetAttributes::HIDDENCELL);
  EXPECT_EQ(this->CountWarnings("vtkGhostType"), 1U);
}

TEST_F(StyleVolumes, ThatShowSomethingElseOrNothingGiveNone)
{
  this->Volume->SetPosition(5.0, 0.0, 0.0);
  this->Volume->VisibilityOff();
  EXPECT_EQ(this->CountWarnings(), 0U);
  this->Volume->VisibilityOn();
  this->Mapper->SetInputData(MakeBall());
  EXPECT_EQ(this->CountWarnings(), 0U);
  this->Volume->SetMapper(nullptr);
  EXPECT_EQ(this->CountWarnings(), 0U);
  this->Renderer->RemoveVolume(this->Volume);
  EXPECT_EQ(this->CountWarnings(), 0U);
}

TEST_F(StyleVolumes, AreToldApart)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->SetInputData(this->Ball);
  vtkNew<vtkVolume> other;
  other->SetMapper(mapper);
  this->Renderer->AddVolume(other);
  this->Volume->SetPosition(5.0, 0.0, 0.0);
  EXPECT_EQ(this->CountWarnings(Moved), 1U);
  other->SetPosition(5.0, 0.0, 0.0);
  EXPECT_EQ(this->CountWarnings(Moved), 1U);
  this->Style->CheckShownVolumes();
  EXPECT_TRUE(this->Log.Warnings.empty());
}
