// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that the scene shows the tissue that a burr has removed, restores it on undo, and leaves
 * the image unchanged.
 */

#include "StyleRig.h"

#include "Rigs/EventCounter.h"

#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkHapticBurr.h>
#include <vtkHapticRemoval.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <thread>
#include <utility>
#include <vector>

using namespace scenetest;

namespace
{
using Levels = std::vector<int>;

int MostDifference(const Levels& a, const Levels& b)
{
  int most = a.size() == b.size() && !a.empty() ? 0 : 256;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    most = std::max(most, std::abs(a[i] - b[i]));
  }
  return most;
}

class StyleBurr : public StyleTest
{
protected:
  StyleBurr()
  {
    this->Burr->SetRadius(6.0);
    this->Burr->SetSolidToAbove();
    this->Burr->SetContactValue(0.0);
    vtkPiecewiseFunction* const energy = this->Burr->GetSpecificEnergy();
    energy->AddPoint(0.0, 0.05); // J/mm^3
    this->Filter->SetTool(this->Burr);
    vtkPiecewiseFunction* const strength = this->Filter->GetProperty()->GetSurfaceStrength();
    strength->RemoveAllPoints();
    strength->AddPoint(0.0, 1e4);
    this->Filter->SetMethodToProxy();
    this->Before->DeepCopy(this->Ball);
    this->Interactor->SetAltKey(0);
  }
  ~StyleBurr() override { this->Device->Stop(); }

  void Show(vtkVolumeMapper* mapper)
  {
    mapper->SetInputDataObject(this->Ball);
    this->Shown->SetMapper(mapper);
    SetLook(this->Shown, mapper);
    this->Renderer->AddVolume(this->Shown);
    this->Renderer->ResetCameraClippingRange();
    this->Window->Render();
  }
  static void SetLook(vtkVolume* volume, vtkVolumeMapper* mapper)
  {
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(-100.0, 0.0);
    opacity->AddPoint(300.0, 0.5);
    volume->GetProperty()->SetScalarOpacity(opacity);
    volume->GetProperty()->SetInterpolationTypeToLinear();
    volume->GetProperty()->ShadeOn();
    if (auto* const texture = vtkGPUVolumeRayCastMapper::SafeDownCast(mapper))
    {
      texture->SetAutoAdjustSampleDistances(0);
      texture->SetSampleDistance(2.0f);
    }
    if (auto* const software = vtkFixedPointVolumeRayCastMapper::SafeDownCast(mapper))
    {
      software->SetAutoAdjustSampleDistances(0);
      software->SetImageSampleDistance(1.0f);
    }
  }
  static Levels Read(vtkRenderWindow* window)
  {
    vtkNew<vtkUnsignedCharArray> pixels;
    const int* const size = window->GetSize();
    window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
    return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
  }
  /// Renders an image from which a loop in this test has removed tissue according to the filter's
  /// fractions.
  Levels DrawReference(vtkVolumeMapper* mapper)
  {
    vtkNew<vtkImageData> fractions;
    this->Filter->GetRemoval()->MakeShares(fractions);
    vtkNew<vtkImageData> left;
    left->DeepCopy(this->Before);
    vtkDataArray* const values = left->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      const double value = values->GetTuple1(i);
      const double rho = fractions->GetPointData()->GetScalars()->GetTuple1(i) / 255.0;
      values->SetTuple1(
        i, value - (1.0 - rho) * (value - this->Filter->GetRemoval()->GetAirValue()));
    }
    mapper->SetInputDataObject(left);
    vtkNew<vtkVolume> volume;
    volume->SetMapper(mapper);
    SetLook(volume, mapper);
    vtkNew<vtkRenderer> renderer;
    renderer->AddVolume(volume);
    renderer->SetActiveCamera(this->Renderer->GetActiveCamera());
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    window->SetSize(300, 300);
    window->AddRenderer(renderer);
    window->Render();
    return Read(window);
  }
  void Drill()
  {
    this->PushIn();
    this->Device->GetVirtualHand()->SpinningOn();
    for (int i = 0; i < 10; ++i)
    {
      this->Pointer(150, 150, vtkCommand::MouseWheelForwardEvent);
      this->Run(30);
      this->Style->DrawHaptics();
    }
    EXPECT_GT(this->Filter->GetRemoval()->GetRemovedVolume(), 50.0);
    this->Device->GetVirtualHand()->SpinningOff();
    this->Run(20);
    this->Press("Escape");
    this->Run(20);
  }
  /// Lets the style draw until the pixels equal `wanted` within 2 grey levels. Returns false if
  /// this never happens.
  bool Becomes(const Levels& wanted)
  {
    return Eventually(
      [&]
      {
        this->Style->DrawHaptics();
        return MostDifference(Read(this->Window), wanted) <= 2;
      });
  }
  void Check(vtkVolumeMapper* mapper, vtkVolumeMapper* reference)
  {
    this->Show(mapper);
    this->Style->TouchVolume(this->Shown);
    const Levels whole = Read(this->Window);
    this->Drill();
    const Levels drilled = this->DrawReference(reference);
    EXPECT_GT(MostDifference(drilled, whole), 20);
    EXPECT_TRUE(this->Becomes(drilled));
    // The filter must touch the image that the application has set, not the carved copy.
    EXPECT_EQ(this->Filter->GetTouchedImage(), this->Ball);
    // Undo must restore the rendered tissue while the servo runs. After Stop(), redo must remove
    // the tissue again without a servo.
    vtkHapticRemoval* const removal = this->Filter->GetRemoval();
    const int strokes = removal->GetNumberOfUndos();
    EXPECT_GT(strokes, 0);
    for (int i = 0; i < strokes; ++i)
    {
      EXPECT_TRUE(removal->Undo());
    }
    EXPECT_TRUE(this->Becomes(whole))
      << removal->GetNumberOfRequests() << " requests of " << strokes << " wait";
    this->Device->Stop();
    for (int i = 0; i < strokes; ++i)
    {
      EXPECT_TRUE(removal->Redo());
    }
    EXPECT_TRUE(this->Becomes(drilled));
    this->Style->SetDevice(nullptr);
    this->Window->Render();
    EXPECT_LE(MostDifference(Read(this->Window), whole), 2) << "nobody feels it";
    EXPECT_EQ(mapper->GetInputDataObject(0, 0), this->Ball);
    vtkDataArray* const now = this->Ball->GetPointData()->GetScalars();
    vtkDataArray* const before = this->Before->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < now->GetNumberOfTuples(); ++i)
    {
      ASSERT_EQ(now->GetTuple1(i), before->GetTuple1(i));
    }
    EXPECT_TRUE(this->Log.Errors.empty());
    EXPECT_TRUE(this->Log.Warnings.empty());
  }

  vtkNew<vtkHapticBurr> Burr;
  vtkNew<vtkImageData> Before;
  vtkNew<vtkVolume> Shown;
};
} // namespace

TEST_F(StyleBurr, ShowsWhatItHasRemoved)
{
  this->Check(vtkNew<vtkOpenGLGPUVolumeRayCastMapper>(), vtkNew<vtkOpenGLGPUVolumeRayCastMapper>());
}

TEST_F(StyleBurr, ShowsItWithAMapperThatHasNoTexture)
{
  this->Check(
    vtkNew<vtkFixedPointVolumeRayCastMapper>(), vtkNew<vtkFixedPointVolumeRayCastMapper>());
}

/// Expects the scene to show removed tissue within 100 ms of servo time, measured from the tick
/// that removes the tissue to the end of the frame that shows it. The measurement starts at the
/// last poll before the removal, so it is slightly too long. Since the machine may be busy, it is
/// enough that one of 20 strokes is shown in time, or by the second frame after that poll. The
/// mapper must keep its unchanged image, because only bricks are uploaded.
TEST_F(StyleBurr, TheSceneFollowsWithin100Milliseconds)
{
  // A software renderer draws a window of this size in a few milliseconds.
  this->Window->SetSize(64, 64);
  const vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  this->Show(mapper);
  this->Style->TouchVolume(this->Shown);
  const vtkMTimeType uploaded = this->Ball->GetMTime();
  vtkHapticRemoval* const removal = this->Filter->GetRemoval();
  this->PushIn(32, 32);
  apitest::EventCounter frames(this->Window, vtkCommand::EndEvent);
  bool isInTime = false;
  for (int stroke = 0; stroke < 20 && !isInTime; ++stroke)
  {
    this->Device->GetVirtualHand()->SpinningOff();
    this->Pointer(32, 32, vtkCommand::MouseWheelForwardEvent);
    this->Run(50);
    Levels before = Read(this->Window);
    ASSERT_TRUE(Eventually(
      [&]
      {
        this->Style->DrawHaptics();
        const Levels now = Read(this->Window);
        return MostDifference(std::exchange(before, now), now) == 0 &&
          !this->Device->GetState()->IsSpinning();
      }));
    const double volume = removal->GetRemovedVolume();
    double begin = this->Device->GetState()->GetTime();
    bool isSeen = false;
    this->Device->GetVirtualHand()->SpinningOn();
    for (int look = 0; look < 4000 && !isSeen; ++look)
    {
      this->Style->UpdateHaptics();
      // Read the time before the volume. If the volume is unchanged, nothing was removed until this
      // time.
      const double now = this->Device->GetState()->GetTime();
      if (removal->GetRemovedVolume() == volume)
      {
        begin = now;
        frames.Count = 0;
      }
      this->Style->DrawHaptics();
      isSeen =
        removal->GetRemovedVolume() > volume && MostDifference(Read(this->Window), before) > 10;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_TRUE(isSeen) << "stroke " << stroke;
    this->Style->UpdateHaptics();
    const double delay = this->Device->GetState()->GetTime() - begin;
    EXPECT_GT(delay, 0.0);
    isInTime = delay <= 0.1 || frames.Count <= 2;
    std::cout << "stroke " << stroke << ": " << 1e3 * delay << " ms, " << frames.Count
              << " frames\n";
  }
  this->Device->GetVirtualHand()->SpinningOff();
  EXPECT_TRUE(isInTime);
  EXPECT_EQ(mapper->GetInputDataObject(0, 0), this->Ball);
  EXPECT_EQ(this->Ball->GetMTime(), uploaded);
}
