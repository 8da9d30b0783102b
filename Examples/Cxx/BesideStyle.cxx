// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// An application that keeps its own interactor style. A vtkInteractorStyleHaptic without an
// interactor does the rest: a timer calls its UpdateHaptics(). Here the key t touches and lets go,
// the mouse leads the tip meanwhile, and the wheel presses.
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkHapticDevice.h>
#include <vtkHapticProperty.h>
#include <vtkHapticRepresentation.h>
#include <vtkInteractorObserver.h>
#include <vtkInteractorStyleHaptic.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSmartVolumeMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeHapticsFilter.h>
#include <vtkVolumeProperty.h>
#include <vtkXMLImageDataReader.h>

#include <string>

// The application's own style, which knows the device and nothing else of haptics.
class ViewerStyle : public vtkInteractorStyleTrackballCamera
{
public:
  static ViewerStyle* New();
  vtkTypeMacro(ViewerStyle, vtkInteractorStyleTrackballCamera);

  vtkHapticDevice* Device = nullptr;
  vtkRenderer* Scene = nullptr;

  void OnKeyPress() override
  {
    if (std::string(this->Interactor->GetKeySym()) != "t")
    {
      this->Superclass::OnKeyPress();
      return;
    }
    this->IsTouching = !this->IsTouching;
    if (!this->IsTouching)
    {
      this->Device->Disarm();
      return;
    }
    // In front of the volume, by half of its size.
    double bounds[6];
    this->Scene->ComputeVisiblePropBounds(bounds);
    this->Depth = 0.5 * (bounds[5] - bounds[4]);
    const double* const tip = this->FindTip();
    this->Device->PlaceVirtualTip(tip[0], tip[1], tip[2]);
    this->Device->Arm();
  }
  void OnMouseMove() override
  {
    this->Superclass::OnMouseMove();
    this->LeadTip();
  }
  void OnMouseWheelForward() override { this->Press(-4.0); }
  void OnMouseWheelBackward() override { this->Press(4.0); }

private:
  void Press(double step)
  {
    this->Depth += step;
    this->LeadTip();
  }
  void LeadTip()
  {
    if (this->IsTouching && this->State == VTKIS_NONE)
    {
      const double* const tip = this->FindTip();
      this->Device->SetVirtualTip(tip[0], tip[1], tip[2]);
    }
  }
  // Under the pointer, at a depth in front of the focal point.
  const double* FindTip()
  {
    vtkCamera* const camera = this->Scene->GetActiveCamera();
    double* const towards = camera->GetDirectionOfProjection();
    const double* const focus = camera->GetFocalPoint();
    double display[3];
    vtkInteractorObserver::ComputeWorldToDisplay(this->Scene, focus[0] - this->Depth * towards[0],
      focus[1] - this->Depth * towards[1], focus[2] - this->Depth * towards[2], display);
    const int* const pointer = this->Interactor->GetEventPosition();
    vtkInteractorObserver::ComputeDisplayToWorld(
      this->Scene, pointer[0], pointer[1], display[2], this->Tip);
    return this->Tip;
  }

  bool IsTouching = false;
  double Depth = 0.0; // of the tip, world units towards the viewer
  double Tip[4] = { 0.0, 0.0, 0.0, 1.0 };
};
vtkStandardNewMacro(ViewerStyle);

int main(int, char* argv[])
{
  vtkNew<vtkXMLImageDataReader> head;
  head->SetFileName(argv[1]); // Data/HeadPhantom.vti
  vtkNew<vtkVolume> volume;
  vtkNew<vtkSmartVolumeMapper> mapper;
  mapper->SetInputConnection(head->GetOutputPort());
  volume->SetMapper(mapper);
  volume->GetProperty()->GetScalarOpacity()->AddSegment(-500.0, 0.0, 1000.0, 0.6);
  volume->GetProperty()->GetRGBTransferFunction()->AddRGBSegment(
    -500.0, 0.9, 0.6, 0.5, 1000.0, 1.0, 1.0, 0.9);
  volume->GetProperty()->ShadeOn();
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  vtkNew<ViewerStyle> own;
  interactor->SetInteractorStyle(own);

  vtkNew<vtkHapticDevice> device;
  vtkNew<vtkInteractorStyleHaptic> haptics; // never given to the interactor
  haptics->SetDevice(device);
  haptics->SetDefaultRenderer(renderer);
  haptics->TouchVolume(volume); // what it shows, now and later
  device->GetVolumeHaptics()->GetProperty()->ApplyPreset("CT contrast");
  device->Open("virtual");
  device->Start();
  vtkNew<vtkHapticRepresentation> hand;
  hand->SetDevice(device);
  renderer->AddViewProp(hand);
  own->Device = device;
  own->Scene = renderer;

  // Sixty times a second: changes go to the hand, and states come from it.
  struct Scene
  {
    vtkInteractorStyleHaptic* Haptics;
    vtkRenderWindowInteractor* Interactor;
  } scene{ haptics, interactor };
  vtkNew<vtkCallbackCommand> tick;
  tick->SetClientData(&scene);
  tick->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*)
    {
      const Scene* const scene = static_cast<Scene*>(data);
      if (scene->Haptics->UpdateHaptics())
      {
        scene->Interactor->Render();
      }
    });
  interactor->AddObserver(vtkCommand::TimerEvent, tick);

  renderer->ResetCamera();
  window->Render();
  interactor->Initialize();
  interactor->CreateRepeatingTimer(1000 / 60);
  interactor->Start();
  device->Close(); // without an interactor, the style does not see the window's end
}
