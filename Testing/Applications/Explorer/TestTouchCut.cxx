// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Cuts a head open: keys and mouse cut, the removed part is not felt, and a drag that begins on a
// handle moves only the handle. The baseline shows the box after dragging a face. The brain in the
// cut face, whose gradients have random directions, must not be black.
#include "TouchedHead.h"

#include "vtkMatrix4x4.h"
#include "vtkPlaneCollection.h"
#include "vtkRegressionTestImage.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolumeMapper.h"

#include <array>
#include <chrono>
#include <cmath>
#include <iostream>
#include <thread>

namespace
{
bool IsSame(double a, double b)
{
  return std::abs(a - b) < 1e-6;
}

struct CutHead : TouchedHead
{
  CutHead(int argc, char* argv[])
    : TouchedHead(argc, argv, Explore::MapperChoice::CPU)
    , Mapper(vtkVolumeMapper::SafeDownCast(Touch.Scene.Volume->GetMapper()))
  {
    this->Touch.Scene.Renderer->GetActiveCamera()->Zoom(0.45);
    this->Touch.Cut.SetInteractor(this->Interactor);
  }
  ~CutHead() { this->Touch.Cut.SetInteractor(nullptr); }

  void Press(char key, const char* symbol)
  {
    // A faster repetition would count as a held key.
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    this->Interactor->SetKeyEventInformation(0, 0, key, 0, symbol);
    this->Interactor->InvokeEvent(vtkCommand::KeyPressEvent);
    this->Interactor->InvokeEvent(vtkCommand::CharEvent);
    this->Interactor->InvokeEvent(vtkCommand::KeyReleaseEvent);
  }
  std::array<double, 6> GetPlanes()
  {
    std::array<double, 6> planes;
    this->Mapper->GetCroppingRegionPlanes(planes.data());
    return planes;
  }
  /// Computes where the middle of a face of the mapper's box is in the picture (pixels).
  void ComputeFace(int face, int display[2])
  {
    const std::array<double, 6> planes = this->GetPlanes();
    double x[4] = { 0.5 * (planes[0] + planes[1]), 0.5 * (planes[2] + planes[3]),
      0.5 * (planes[4] + planes[5]), 1.0 };
    x[face / 2] = planes[static_cast<std::size_t>(face)];
    this->Touch.Scene.Volume->GetMatrix()->MultiplyPoint(x, x);
    vtkRenderer* const renderer = this->Touch.Scene.Renderer;
    renderer->SetWorldPoint(x);
    renderer->WorldToDisplay();
    display[0] = static_cast<int>(std::lround(renderer->GetDisplayPoint()[0]));
    display[1] = static_cast<int>(std::lround(renderer->GetDisplayPoint()[1]));
  }
  void Drag(const int from[2], int dx, int dy)
  {
    this->Event(from[0], from[1], vtkCommand::MouseMoveEvent);
    this->Event(from[0], from[1], vtkCommand::LeftButtonPressEvent);
    for (int step = 1; step <= 4; ++step)
    {
      this->Event(from[0] + step * dx / 4, from[1] + step * dy / 4, vtkCommand::MouseMoveEvent);
    }
    this->Event(from[0] + dx, from[1] + dy, vtkCommand::LeftButtonReleaseEvent);
  }
  /// Returns whether the filter crops the same regions as the mapper. The filter's planes are in
  /// the image's coordinates: the mapper's planes plus the image's origin.
  bool FeelsRegions()
  {
    vtkVolumeHapticsFilter* const filter = this->Exploration.Filter;
    const std::array<double, 6> shown = this->GetPlanes();
    bool isSame = filter->GetCropping() && this->Mapper->GetCropping() &&
      filter->GetCroppingRegionFlags() == this->Mapper->GetCroppingRegionFlags();
    for (std::size_t i = 0; i < 6; ++i)
    {
      const double origin = this->Exploration.Input.Image->GetOrigin()[i / 2];
      isSame = isSame && IsSame(filter->GetCroppingRegionPlanes()[i], origin + shown[i]);
    }
    return isSame;
  }
  /// Returns whether a position (world coordinates) is inside the cropped box by more than a voxel.
  bool IsCutAway(const double world[3])
  {
    vtkNew<vtkMatrix4x4> toVolume;
    vtkMatrix4x4::Invert(this->Touch.Scene.Volume->GetMatrix(), toVolume);
    double x[4] = { world[0], world[1], world[2], 1.0 };
    toVolume->MultiplyPoint(x, x);
    const std::array<double, 6> planes = this->GetPlanes();
    const double voxel = this->Exploration.Input.Image->GetSpacing()[0];
    bool isInside = true;
    for (std::size_t a = 0; a < 3; ++a)
    {
      isInside = isInside && x[a] > planes[2 * a] + voxel && x[a] < planes[2 * a + 1] - voxel;
    }
    return isInside;
  }
  /// Presses at pixel (x, y) and returns the proxy.
  std::array<double, 3> Touches(int x, int y)
  {
    this->TouchAt(x, y, [&] { this->TouchedHead::Press(x, y, 4); });
    std::array<double, 3> proxy;
    std::copy_n(this->Touch.Device->GetState()->GetProxyPosition(), 3, proxy.data());
    return proxy;
  }

  vtkVolumeMapper* const Mapper;
  int Faults = 0;
  void Expect(bool isTrue, const char* what)
  {
    if (!isTrue)
    {
      std::cerr << "FAILED: " << what << "\n";
      ++this->Faults;
    }
  }
};

/// Expects that rendering and haptics share one plane object, which the key x creates and the key e
/// flips.
void CutByPlane(CutHead& head)
{
  head.Press('x', "x");
  vtkPlaneCollection* const seen = head.Mapper->GetClippingPlanes();
  vtkPlaneCollection* const felt = head.Exploration.Filter->GetClippingPlanes();
  head.Expect(seen && seen->GetNumberOfItems() == 1 && felt && felt->GetNumberOfItems() == 1 &&
      seen->GetItem(0) == felt->GetItem(0),
    "x cuts by one plane");
  if (head.Faults > 0)
  {
    return;
  }
  vtkPlane* const plane = seen->GetItem(0);
  vtkCamera* const camera = head.Touch.Scene.Renderer->GetActiveCamera();
  head.Expect(
    plane->EvaluateFunction(camera->GetPosition()) < 0.0, "the viewer's side is cut away");
  double before[3];
  std::copy_n(plane->GetNormal(), 3, before);
  head.Press('e', "e");
  head.Expect(IsSame(vtkMath::Dot(before, plane->GetNormal()), -1.0), "e keeps the other part");
}

/// Expects that dragging a face's handle moves only this face.
void DragFace(CutHead& head)
{
  vtkCamera* const camera = head.Touch.Scene.Renderer->GetActiveCamera();
  const std::array<double, 6> before = head.GetPlanes();
  std::array<double, 3> eye;
  camera->GetPosition(eye.data());
  int at[2];
  constexpr int top = 5;
  head.ComputeFace(top, at);
  head.Drag(at, 0, -25);
  const std::array<double, 6> after = head.GetPlanes();
  std::array<double, 3> eyeAfter;
  camera->GetPosition(eyeAfter.data());
  head.Expect(after[5] < before[5] - 5.0, "the top face goes down");
  head.Expect(
    std::equal(before.begin(), before.begin() + 5, after.begin(), IsSame), "the other faces stay");
  head.Expect(eye == eyeAfter, "the camera stays");
  head.Expect(head.FeelsRegions(), "the filter follows the handle");
  head.Drag(at, 0, 40); // drag at the handle's old position
  head.Expect(!(eye == (camera->GetPosition(eyeAfter.data()), eyeAfter)),
    "beside the handles the mouse turns the camera");
  head.Drag(at, 0, -40);
}
} // namespace

int TestTouchCut(int argc, char* argv[])
{
  CutHead head(argc, argv);
  const int middle[2] = { 181, 154 };
  const std::array<double, 3> skin = head.Touches(middle[0], middle[1]);
  head.Expect(head.Touch.Device->GetState()->GetContact() != 0, "the skin is touched");
  head.Touch.Style->TouchModeOff();
  CutByPlane(head);
  head.Press('x', "x");
  head.Expect(head.Touch.Cut.GetKind() == Explore::CutKind::Box, "the next cut is a box");
  head.Expect(head.FeelsRegions(), "eye and hand have one box");
  head.Expect(head.IsCutAway(skin.data()), "the skin in front of the middle is cut away");
  DragFace(head);
  const std::array<double, 3> inside = head.Touches(middle[0], middle[1]);
  head.Expect(!head.IsCutAway(inside.data()), "nothing is felt in what is cut away");
  head.Press('z', "z");
  head.Expect(head.Exploration.Filter->GetFeelCutFaces(), "z makes faces hold");
  head.Press('z', "z");
  head.Expect(!head.Exploration.Filter->GetFeelCutFaces(), "z opens them again");
  head.Touch.Style->TouchModeOff();
  vtkRenderWindow* const window = head.Touch.Scene.Window;
  head.Touch.Hand->VisibilityOff();
  window->Render();
  vtkNew<vtkUnsignedCharArray> brain;
  window->GetPixelData(208, 199, 224, 219, 0, brain);
  double red[2];
  brain->GetRange(red, 0);
  head.Expect(red[0] > 40.0, "the light falls on the brain in the cut face");
  const bool looksRight = vtkRegressionTestImage(window) == vtkTesting::PASSED;
  head.Press('x', "x");
  head.Expect(!head.Mapper->GetCropping() && !head.Exploration.Filter->GetCropping(),
    "after the box there is no cut");
  return looksRight && head.Faults == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
