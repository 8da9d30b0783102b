// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that rendering with rays that are reused between frames equals rendering with a mapper that
 * casts all rays for each frame.
 */

#include "VTK/Scene/Frames/KeptRays.h"
#include "VTK/Scene/Volumes/CarvedScene.h"

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkDirectionEncoder.h>
#include <vtkFixedPointRayCastImage.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkPlaneCollection.h>
#include <vtkPolyDataMapper.h>
#include <vtkSphereSource.h>

#include <functional>
#include <numeric>
#include <string>

using namespace carvedtest;

namespace
{
/// A window with a volume and two balls, which represent a stylus and an arrow. Counts the rays
/// that its mapper casts.
class Drawn
{
public:
  explicit Drawn(vtkImageData* image)
    : Image(image)
  {
    this->Mapper->SetInputData(image);
    this->Mapper->AutoAdjustSampleDistancesOff();
    this->Mapper->SetSampleDistance(0.5F);
    for (const auto& ball : { this->First.Get(), this->Second.Get() })
    {
      vtkNew<vtkSphereSource> sphere;
      sphere->SetRadius(3.0);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(sphere->GetOutputPort());
      ball->SetMapper(mapper);
      this->Scene.Renderer->AddActor(ball);
    }
    this->Move({ 27.0, 11.0, 60.0 }, { 40.0, 0.0, 45.0 });
    this->Scene.Renderer->ResetCameraClippingRange();
    this->Count->SetClientData(this);
    this->Count->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { static_cast<Drawn*>(self)->CountRays(); });
    // Count after the observer that chooses the rows to cast.
    this->Mapper->AddObserver(vtkCommand::VolumeMapperRenderStartEvent, this->Count, -1.0F);
  }
  void Move(std::array<double, 3> first, std::array<double, 3> second)
  {
    this->First->SetPosition(first.data());
    this->Second->SetPosition(second.data());
  }
  std::vector<int> Draw()
  {
    this->Rays = 0;
    this->Scene.Window->Render();
    return this->See();
  }
  std::vector<int> See()
  {
    vtkNew<vtkUnsignedCharArray> pixels;
    const int* const size = this->Scene.Window->GetSize();
    this->Scene.Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
    const unsigned char* const begin = pixels->GetPointer(0);
    return { begin, begin + pixels->GetNumberOfValues() };
  }

  vtkSmartPointer<vtkImageData> Image;
  vtkNew<vtkFixedPointVolumeRayCastMapper> Mapper;
  vtkNew<vtkVolume> Volume;
  Shown Scene{ Volume, Mapper, 1, 0.0, 250.0 };
  vtkNew<vtkActor> First;
  vtkNew<vtkActor> Second;
  vtkNew<vtkCallbackCommand> Count;
  int Rays = 0;

private:
  void CountRays()
  {
    const int rows = this->Mapper->GetRayCastImage()->GetImageInUseSize()[1];
    const int* bounds = this->Mapper->GetRowBounds();
    for (int j = 0; j < rows; ++j, bounds += 2)
    {
      this->Rays += std::max(0, bounds[1] - bounds[0] + 1);
    }
  }
};

class KeptRaysTest : public testing::Test
{
protected:
  using Change = std::function<void(Drawn&)>;

  /// Applies the change to both windows, and expects the same pixels. Returns the numbers of cast
  /// rays: first of the window that reuses rays, then of the window that casts all rays.
  std::pair<int, int> Compare(const Change& change, const std::string& what)
  {
    change(this->Kept);
    change(this->Whole);
    const std::vector<int> whole = this->Whole.Draw();
    EXPECT_EQ(Difference(this->Kept.Draw(), whole), 0) << what;
    this->Before = whole;
    return { this->Kept.Rays, this->Whole.Rays };
  }
  /// Applies the change, and interrupts the next frame.
  void Interrupt(const Change& change)
  {
    change(this->Kept);
    change(this->Whole);
    vtkNew<vtkCallbackCommand> interrupt;
    interrupt->SetClientData(this->Kept.Scene.Window);
    interrupt->SetCallback([](vtkObject*, unsigned long, void* window, void*)
      { static_cast<vtkRenderWindow*>(window)->SetAbortRender(1); });
    this->Kept.Mapper->AddObserver(vtkCommand::VolumeMapperRenderProgressEvent, interrupt);
    this->Kept.Draw();
    this->Kept.Mapper->RemoveObserver(interrupt);
    EXPECT_NE(this->Kept.Scene.Window->GetAbortRender(), 0);
  }
  /// Expects that all rays are cast after the change, and that the pixels differ.
  void ExpectAnew(const Change& change, const std::string& what)
  {
    this->Compare([](Drawn&) {}, "before " + what);
    const std::vector<int> before = this->Before;
    const auto [rays, all] = this->Compare(change, what);
    EXPECT_EQ(rays, all) << what;
    EXPECT_TRUE(this->Rays.DrainWhole()) << what;
    EXPECT_GT(Difference(this->Before, before), 0) << what << " is to be seen";
  }

  Drawn Kept{ MakeImage(VTK_UNSIGNED_CHAR, 1, 0.0, 250.0) };
  Drawn Whole{ MakeImage(VTK_UNSIGNED_CHAR, 1, 0.0, 250.0) };
  KeptRays Rays{ this->Kept.Scene.Renderer, this->Kept.Volume, this->Kept.Mapper };
  std::vector<int> Before;
};
} // namespace

TEST_F(KeptRaysTest, AHandThatMovesChangesTheRaysThatItMeets)
{
  EXPECT_FALSE(this->Rays.IsCurrent()) << "nothing was drawn";
  const auto [first, all] = this->Compare([](Drawn&) {}, "the first frame");
  EXPECT_EQ(first, all);
  EXPECT_GT(all, Side * Side / 4) << "the volume fills the window";
  EXPECT_TRUE(this->Rays.DrainWhole());
  EXPECT_TRUE(this->Rays.IsCurrent());
  EXPECT_EQ(this->Compare([](Drawn&) {}, "nothing has moved").first, 0);
  int most = 0;
  for (int i = 0; i <= 40; ++i) // moves from the front of the volume through it to its back
  {
    const double way = i / 40.0;
    const auto move = [way](Drawn& drawn)
    {
      drawn.Move({ 27.0 - 8.0 * way, 11.0 + 6.0 * way, 60.0 - 60.0 * way },
        { 40.0 - 20.0 * way, 8.0 * std::sin(9.0 * way), 45.0 });
    };
    most = std::max(most, this->Compare(move, "step " + std::to_string(i)).first);
    EXPECT_TRUE(this->Rays.IsCurrent());
  }
  EXPECT_GT(most, 0);
  EXPECT_LT(most, all / 2);
  EXPECT_FALSE(this->Rays.DrainWhole());
}

TEST_F(KeptRaysTest, PixelsMayBeFartherApart)
{
  const auto coarse = [](Drawn& drawn) { drawn.Mapper->SetImageSampleDistance(2.8F); };
  this->Compare([](Drawn&) {}, "finely");
  const auto [first, all] = this->Compare(coarse, "coarsely");
  EXPECT_EQ(first, all);
  EXPECT_EQ(this->Rays.GetImageDistance(), 2.8F);
  for (const double x : { 30.0, 25.0, 20.0 })
  {
    const auto move = [x](Drawn& drawn) { drawn.Move({ x, 11.0, 60.0 }, { x, 2.0, 45.0 }); };
    EXPECT_LT(this->Compare(move, "moved").first, all / 2);
  }
}

TEST_F(KeptRaysTest, WhateverElseChangesCastsAllRays)
{
  this->ExpectAnew([](Drawn& d) { d.Scene.Renderer->GetActiveCamera()->Azimuth(5.0); }, "camera");
  this->ExpectAnew([](Drawn& d) { d.Scene.Renderer->GetActiveCamera()->Zoom(0.9); }, "zoom");
  this->ExpectAnew([](Drawn& d) { d.Volume->SetPosition(1.0, 2.0, 0.0); }, "volume");
  this->ExpectAnew(
    [](Drawn& d) { d.Volume->GetProperty()->GetScalarOpacity()->AddPoint(120.0, 0.9); }, "opacity");
  this->ExpectAnew([](Drawn& d)
    { d.Volume->GetProperty()->GetRGBTransferFunction()->AddRGBPoint(200.0, 0.1, 0.9, 0.2); },
    "color");
  this->ExpectAnew([](Drawn& d) { d.Volume->GetProperty()->SetSpecular(0.9); }, "shades");
  this->ExpectAnew(
    [](Drawn& d)
    {
      vtkNew<vtkLight> light;
      light->SetPosition(-90.0, 20.0, 40.0);
      light->SetDiffuseColor(0.9, 0.2, 0.1);
      d.Scene.Renderer->AddLight(light);
    },
    "light");
  this->ExpectAnew(
    [](Drawn& d)
    {
      auto* const light = vtkLight::SafeDownCast(d.Scene.Renderer->GetLights()->GetItemAsObject(0));
      light->SetIntensity(0.5);
    },
    "intensity");
  this->ExpectAnew(
    [](Drawn& d)
    {
      d.Mapper->SetCroppingRegionPlanes(15.0, 35.0, -2.0, 25.0, 10.0, 35.0);
      d.Mapper->CroppingOn();
    },
    "cropping");
  this->ExpectAnew([](Drawn& d) { d.Mapper->SetCroppingRegionFlagsToFence(); }, "fence");
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(27.0, 11.0, 22.0);
  plane->SetNormal(1.0, 0.2, -0.3);
  this->ExpectAnew([&](Drawn& d) { d.Mapper->AddClippingPlane(plane); }, "clipping");
  this->ExpectAnew([&](Drawn& d) { plane->SetOrigin(30.0, 11.0, 22.0); }, "plane");
  this->ExpectAnew([](Drawn& d) { d.Mapper->RemoveAllClippingPlanes(); }, "no clipping");
  this->ExpectAnew([](Drawn& d) { d.Mapper->SetSampleDistance(2.0F); }, "samples");
  this->ExpectAnew(
    [](Drawn& d)
    {
      vtkDataArray* const values = d.Image->GetPointData()->GetScalars();
      for (vtkIdType i = 0; i < values->GetNumberOfTuples(); i += 2)
      {
        values->SetComponent(i, 0, 0.5 * values->GetComponent(i, 0));
      }
      values->Modified();
      d.Image->Modified();
    },
    "values");
  this->ExpectAnew([](Drawn& d) { d.Volume->GetProperty()->ShadeOff(); }, "no shades");
  this->ExpectAnew(
    [](Drawn& d) { d.Mapper->SetBlendModeToMaximumIntensity(); }, "maximum intensity");
  this->ExpectAnew([](Drawn& d) { d.Scene.Window->SetSize(Side + 20, Side - 10); }, "size");
  this->ExpectAnew([](Drawn& d) { d.Scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0); }, "viewport");
}

TEST_F(KeptRaysTest, ShadesAreComputedIfTheyWouldBeOthers)
{
  struct Parts : vtkFixedPointVolumeRayCastMapper
  {
    static vtkDirectionEncoder* Find(vtkFixedPointVolumeRayCastMapper* mapper)
    {
      return mapper->*(&Parts::DirectionEncoder);
    }
  };
  const auto count = [this]
  { return Parts::Find(this->Kept.Mapper)->GetNumberOfEncodedDirections(); };
  const int all = Parts::Find(this->Whole.Mapper)->GetNumberOfEncodedDirections();
  this->Compare([](Drawn&) {}, "the first frame");
  EXPECT_EQ(count(), all);
  this->Compare([](Drawn& d) { d.Move({ 25.0, 11.0, 60.0 }, { 38.0, 0.0, 45.0 }); }, "moved");
  EXPECT_EQ(count(), 0);
  // Cropping changes the pixels, but not the shading, so the shades of earlier frames are reused.
  this->ExpectAnew(
    [](Drawn& d)
    {
      d.Mapper->SetCroppingRegionPlanes(15.0, 35.0, -2.0, 25.0, 10.0, 35.0);
      d.Mapper->CroppingOn();
    },
    "cropping");
  EXPECT_EQ(count(), 0);
  this->ExpectAnew([](Drawn& d) { d.Volume->GetProperty()->SetDiffuse(0.3); }, "diffuse light");
  EXPECT_EQ(count(), all);
  this->Compare([](Drawn&) {}, "again");
  EXPECT_EQ(count(), 0);
  vtkNew<vtkVolume> other;
  Shown(other, this->Kept.Mapper, 1, 0.0, 250.0).Draw();
  EXPECT_EQ(count(), all) << "for another window";
  this->Compare([](Drawn&) {}, "after another window");
  EXPECT_EQ(count(), all);
  {
    const KeptRays second(this->Whole.Scene.Renderer, this->Whole.Volume, this->Whole.Mapper);
    this->Compare([](Drawn&) {}, "both");
  }
  EXPECT_FALSE(Parts::Find(this->Whole.Mapper)->IsA("ShadedDirections")) << "its own again";
  this->ExpectAnew([](Drawn& d) { d.Volume->GetProperty()->SetDiffuse(0.9); }, "by itself");
}

TEST_F(KeptRaysTest, AWindowAndLevelOfTheImageAreNotAppliedTwice)
{
  const auto change = [](Drawn& drawn)
  {
    drawn.Mapper->SetFinalColorWindow(0.7F);
    drawn.Mapper->SetFinalColorLevel(0.4F);
  };
  this->Compare([](Drawn&) {}, "before");
  for (int i = 0; i < 3; ++i)
  {
    const auto [rays, all] = this->Compare(change, "frame " + std::to_string(i));
    EXPECT_EQ(rays, all);
    EXPECT_FALSE(this->Rays.IsCurrent());
  }
}

TEST_F(KeptRaysTest, AMapperThatHasDrawnElsewhereBeginsAnew)
{
  const auto fine = [](Drawn& d) { d.Mapper->SetImageSampleDistance(0.25F); };
  this->Compare([](Drawn&) {}, "coarsely");
  this->Compare(fine, "finely");
  for (Drawn* const drawn : { &this->Kept, &this->Whole })
  {
    Shown other(vtkNew<vtkVolume>(), drawn->Mapper, 1, 0.0, 250.0);
    other.Draw();
  }
  EXPECT_FALSE(this->Rays.IsCurrent());
  const auto [rays, all] = this->Compare([](Drawn&) {}, "after");
  EXPECT_EQ(rays, all);
  // The coarse image of earlier frames is still valid, so no rays must be cast.
  const auto coarse = [](Drawn& d) { d.Mapper->SetImageSampleDistance(1.0F); };
  EXPECT_EQ(this->Compare(coarse, "coarsely again").first, 0);
}

TEST_F(KeptRaysTest, AFrameThatWasToBeQuickIsGivenUp)
{
  this->Compare([](Drawn&) {}, "before");
  this->Rays.Expect();
  EXPECT_EQ(this->Compare([](Drawn&) {}, "nothing has changed").first, 0);
  EXPECT_EQ(this->Kept.Scene.Window->GetAbortRender(), 0);
  this->Kept.Volume->GetProperty()->SetSpecular(0.9);
  this->Whole.Volume->GetProperty()->SetSpecular(0.9);
  this->Rays.Expect();
  this->Kept.Draw();
  EXPECT_EQ(this->Kept.Rays, 0);
  EXPECT_NE(this->Kept.Scene.Window->GetAbortRender(), 0);
  EXPECT_FALSE(this->Rays.IsCurrent());
  const auto [rays, all] = this->Compare([](Drawn&) {}, "the next frame");
  EXPECT_EQ(rays, all);
}

TEST_F(KeptRaysTest, AnInterruptedFrameIsNotKept)
{
  this->Compare([](Drawn&) {}, "before");
  this->Interrupt([](Drawn& d) { d.Volume->GetProperty()->SetSpecular(0.9); });
  EXPECT_FALSE(this->Rays.IsCurrent());
  const auto [rays, all] = this->Compare([](Drawn&) {}, "after");
  EXPECT_EQ(rays, all);
}

TEST_F(KeptRaysTest, MotionGoesOnAfterAnInterruptedFrameAtRest)
{
  const auto coarse = [](Drawn& d) { d.Mapper->SetImageSampleDistance(4.0F); };
  const auto fine = [](Drawn& d) { d.Mapper->SetImageSampleDistance(0.25F); };
  this->Compare(coarse, "in motion");
  for (const double x : { 30.0, 26.0 })
  {
    this->Interrupt(fine);
    const auto move = [&](Drawn& d)
    {
      coarse(d);
      d.Move({ x, 11.0, 60.0 }, { x, 2.0, 45.0 });
    };
    const auto [rays, all] = this->Compare(move, "the motion goes on");
    EXPECT_LT(rays, all / 2);
    EXPECT_GT(rays, 0);
  }
  // The opacity changes while the motion pauses, so all rays must be cast.
  this->Interrupt(
    [&](Drawn& d)
    {
      fine(d);
      d.Volume->GetProperty()->SetSpecular(0.9);
    });
  const auto [rays, all] = this->Compare(coarse, "another look");
  EXPECT_EQ(rays, all);
  // The window's size changes while the motion pauses, so all rays must be cast.
  this->Interrupt(fine);
  for (Drawn* const drawn : { &this->Kept, &this->Whole })
  {
    drawn->Scene.Window->SetSize(Side + 8, Side + 8);
  }
  EXPECT_EQ(this->Compare(coarse, "another size").first, this->Whole.Rays);
}
