// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticWidget.h"

#include "VTK/Scene/Base/HapticOverlays.h"
#include "VTK/Scene/Base/WindowVolumes.h"
#include "VTK/Scene/Interaction/HapticInteraction.h"

#include "vtkCallbackCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkHapticProperty.h"
#include "vtkHapticRepresentation.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkObjectFactory.h"
#include "vtkRenderPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeHapticsFilter.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using namespace VolumeHaptics;

namespace
{

/// Priority of the widget, above the 0.5 of VTK's widgets.
constexpr float WidgetPriority = 0.9f;
/// Time (s) without a timer event after which the force fades; longer than any frame takes.
constexpr double Attention = 10.0;
/// Radius of the proxy, and length of the arrow for 1 N, as fractions of the volume's diagonal.
constexpr double ProxyFraction = 0.007;
constexpr double ArrowFraction = 0.05;

/// Rounds to one significant digit, so that the scale beside the arrows shows a round number.
double Round(double value)
{
  const double unit = std::pow(10.0, std::floor(std::log10(value)));
  return unit * std::round(value / unit);
}

/// Marks a program's render pass as modified, so that it collects the props again; f3d's pass
/// caches them.
void TellPass(vtkRenderer* renderer)
{
  if (vtkRenderPass* const pass = renderer->GetPass())
  {
    pass->Modified();
  }
}

/// An interaction that uses the interactor's events in the touch mode, and leaves all others to
/// observers with lower priority.
class StyleBeside : public vtkInteractorStyleHaptic
{
public:
  static StyleBeside* New();
  vtkTypeMacro(StyleBeside, vtkInteractorStyleHaptic);
  using vtkInteractorStyleHaptic::GetInteraction;

  /// Called before the touch mode begins; returns false if there is nothing to touch.
  std::function<bool()> Prepare;
  bool HasActivationKey = true;

  /// Sets the interactor. Also observes button releases as a passive observer: active observers do
  /// not get the release if a style or a widget of the program has grabbed the focus at the press.
  void SetInteractor(vtkRenderWindowInteractor* interactor) override
  {
    if (interactor != this->Interactor)
    {
      if (this->Interactor)
      {
        this->Interactor->RemoveObserver(this->ReleaseObserver);
      }
      this->Buttons = 0;
      this->UsedButtons = 0;
      this->HeldKey.clear();
      if (interactor)
      {
        for (const unsigned long event : { vtkCommand::LeftButtonReleaseEvent,
               vtkCommand::MiddleButtonReleaseEvent, vtkCommand::RightButtonReleaseEvent })
        {
          interactor->AddObserver(event, this->ReleaseObserver);
        }
      }
    }
    this->Superclass::SetInteractor(interactor);
  }
  void OnTimer() override
  {
    const bool isOwn = this->IsOwnTimer();
    this->Superclass::OnTimer();
    if (isOwn)
    {
      this->Abort(); // keep the event from the program, which did not start this timer
    }
  }
  void OnMouseMove() override
  {
    if (this->HasMouse() && this->UseMouseMove())
    {
      this->Abort();
    }
  }
  void OnLeftButtonDown() override
  {
    const bool isUsed = this->HasClick() && this->GetInteraction().PressLeftButton();
    this->Handle(Left, isUsed);
  }
  void OnLeftButtonUp() override
  {
    if (this->Release(Left))
    {
      this->GetInteraction().ReleaseLeftButton();
    }
  }
  void OnLeftButtonDoubleClick() override
  {
    if (this->HasClick() && this->GetInteraction().DoubleClickLeftButton())
    {
      this->Abort();
    }
  }
  void OnRightButtonDown() override
  {
    const bool isUsed = this->HasClick() && this->GetInteraction().PressRightButton();
    this->Handle(Right, isUsed);
  }
  void OnRightButtonUp() override
  {
    if (this->Release(Right))
    {
      this->GetInteraction().ReleaseRightButton();
    }
  }
  void OnMiddleButtonDown() override { this->Handle(Middle, false); }
  void OnMiddleButtonUp() override {}
  void OnMouseWheelForward() override { this->TurnWheel(1.0); }
  void OnMouseWheelBackward() override { this->TurnWheel(-1.0); }
  void OnKeyPress() override
  {
    const std::string name = this->GetKeyName();
    auto& interaction = this->GetInteraction();
    const bool begins = !this->GetTouchMode();
    // Keep a held key that ended the touch from the program. If the touch mode has changed in
    // another way since, the release was lost, and this is a new press.
    const bool isHeld = interaction.IsRepeat(name) ||
      (!this->HeldKey.empty() && this->HeldKey == name && begins != this->HeldInTouch);
    if (!isHeld && begins && (!this->HasActivationKey || interaction.Keys.Find(name) != "t"))
    {
      return;
    }
    if (isHeld || (begins && !this->Prepare()) || interaction.PressKey(name))
    {
      this->HeldKey = name;
      this->HeldInTouch = this->GetTouchMode();
      this->HeldModifiers = this->GetModifiers();
      this->Abort();
    }
  }
  void OnKeyRelease() override
  {
    const std::string name = this->GetKeyName();
    this->GetInteraction().ReleaseKey(name);
    // If Shift or Ctrl was released first, the release has another name than the press: p instead
    // of P.
    const bool isUnshifted = (this->HeldModifiers & ~this->GetModifiers()) != 0;
    if (!this->HeldKey.empty() && (this->HeldKey == name || isUnshifted))
    {
      this->HeldKey.clear();
      this->Abort();
    }
  }
  void OnChar() override
  {
    if (!this->HeldKey.empty() && this->HeldKey == this->GetKeyName())
    {
      this->Abort();
    }
  }

protected:
  StyleBeside()
  {
    this->ReleaseObserver->PassiveObserverOn();
    this->ReleaseObserver->SetClientData(this);
    this->ReleaseObserver->SetCallback(
      [](vtkObject*, unsigned long event, void* self, void*)
      {
        const Button released = event == vtkCommand::LeftButtonReleaseEvent ? Left
          : event == vtkCommand::MiddleButtonReleaseEvent                   ? Middle
                                                                            : Right;
        static_cast<StyleBeside*>(self)->Buttons &= ~static_cast<unsigned int>(released);
      });
  }

private:
  enum Button : unsigned int
  {
    Left = 1,
    Middle = 2,
    Right = 4
  };

  void Abort() { this->EventCallbackCommand->SetAbortFlag(1); }
  int GetModifiers()
  {
    return (this->Interactor->GetShiftKey() ? 1 : 0) + (this->Interactor->GetControlKey() ? 2 : 0);
  }
  /// Returns whether the hand gets the mouse. A drag that the program has begun remains with the
  /// program. Slices beside the scene always belong to the hand.
  bool HasMouse()
  {
    const int* const at = this->Interactor->GetEventPosition();
    vtkHapticSliceView* const slices = this->GetSliceView();
    const bool isOurs = this->GetTouchMode() || this->UsedButtons != 0 ||
      (slices && slices->FindSlice(at[0], at[1]) >= 0);
    return isOurs && this->Buttons == 0 && this->Interactor->GetRenderWindow();
  }
  /// Returns whether the hand gets a click. Clicks on a slider, handle or text of the program
  /// belong to the program.
  bool HasClick()
  {
    const int* const at = this->Interactor->GetEventPosition();
    return this->HasMouse() && !IsOverPartOfHost(this->Interactor->GetRenderWindow(), at[0], at[1]);
  }
  void Handle(Button button, bool isUsed)
  {
    (isUsed ? this->UsedButtons : this->Buttons) |= button;
    if (isUsed)
    {
      this->Abort();
    }
  }
  /// Returns whether the hand has used the press, so that the release must be kept from the
  /// program.
  bool Release(Button button)
  {
    const bool isUsed = (this->UsedButtons & button) != 0;
    this->UsedButtons &= ~static_cast<unsigned int>(button);
    if (isUsed)
    {
      this->Abort();
    }
    return isUsed;
  }
  void TurnWheel(double steps)
  {
    if (this->HasMouse() && this->GetInteraction().TurnWheel(steps))
    {
      this->Abort();
    }
  }

  vtkNew<vtkCallbackCommand> ReleaseObserver;
  unsigned int Buttons = 0; ///< bit mask of the buttons whose press went to the program
  /// Bit mask of the buttons whose press and release are kept from the program.
  unsigned int UsedButtons = 0;
  std::string HeldKey;      ///< last key used, whose repetitions are kept from the program
  int HeldModifiers = 0;    ///< GetModifiers() when that key was pressed
  bool HeldInTouch = false; ///< whether the touch mode was on after that press
};

vtkStandardNewMacro(StyleBeside);

/// Returns whether a filter can feel the drawn data: an image, or data with cells.
bool IsTouchable(const DrawnVolume& drawn)
{
  vtkDataObject* const data = drawn.GetData();
  return vtkDataSet::SafeDownCast(data) || vtkCompositeDataSet::SafeDownCast(data);
}

} // namespace

//------------------------------------------------------------------------------
struct vtkHapticWidget::vtkInternals
{
  vtkInternals()
  {
    // Leave the hand out of the bounds, so that resetting the camera shows the volume.
    this->Hand->UseBoundsOff();
    this->SecondHand->UseBoundsOff();
    this->SecondHand->SecondHandOn();
    this->Display->UseBoundsOff();
    this->Style->GetInteraction().Scene.TurnsView = false;
    this->Style->SetHeadUpDisplay(this->Display);
    this->Style->SetPriority(WidgetPriority);
    vtkNew<vtkHapticDevice> device;
    device->SetAttentionTime(Attention);
    this->SetDevice(device);
  }

  void SetDevice(vtkHapticDevice* device)
  {
    this->Leave();
    if (device == this->Style->GetSecondDevice())
    {
      this->SetSecondDevice(nullptr);
    }
    this->Device = device;
    device->SetVolumeHaptics(this->Filter);
    this->Style->SetDevice(device);
    this->Hand->SetDevice(device);
    this->Display->SetDevice(device);
  }

  void SetSecondDevice(vtkHapticDevice* device)
  {
    this->StopSecond();
    if (this->Renderer)
    {
      this->Renderer->RemoveViewProp(this->SecondHand);
      TellPass(this->Renderer);
    }
    this->Style->SetSecondDevice(device);
    this->SecondHand->SetDevice(device);
    this->Display->SetSecondDevice(device);
  }

  /** Returns whether the program itself has connected an input to the filter. */
  bool HasOwnInput() const
  {
    return !this->Volume && !this->IsInputOurs && this->Filter->GetNumberOfInputConnections(0) > 0;
  }

  /** Returns the touchable volumes in a renderer, limited to parts of Volume if that is set. */
  std::vector<vtkVolume*> CollectVolumes(vtkRenderer* renderer) const
  {
    std::vector<vtkVolume*> found;
    for (const DrawnVolume& drawn : CollectDrawnVolumes(renderer))
    {
      const bool isWanted = drawn.Volume == this->Volume || drawn.Whole == this->Volume;
      if (this->Volume ? isWanted : IsTouchable(drawn))
      {
        found.push_back(drawn.Volume);
      }
    }
    return found;
  }

  /**
   * Returns the topmost renderer with volumes under the pointer, or the first renderer with volumes
   * if there is none.
   */
  vtkRenderer* ChooseRenderer(vtkRenderWindowInteractor* interactor) const
  {
    vtkRenderWindow* const window = interactor->GetRenderWindow();
    const int* const at = interactor->GetEventPosition();
    vtkRenderer* found = nullptr;
    vtkRenderer* first = nullptr;
    vtkCollectionSimpleIterator it;
    vtkRendererCollection* const renderers = window ? window->GetRenderers() : nullptr;
    if (renderers)
    {
      renderers->InitTraversal(it);
    }
    while (vtkRenderer* const renderer = renderers ? renderers->GetNextRenderer(it) : nullptr)
    {
      if (this->CollectVolumes(renderer).empty())
      {
        continue;
      }
      first = first ? first : renderer;
      if (renderer->IsInViewport(at[0], at[1]) &&
        (!found || renderer->GetLayer() >= found->GetLayer()))
      {
        found = renderer;
      }
    }
    return found ? found : first;
  }

  /** Sets the volumes to touch, all with the settings of the filter. */
  void Touch(const std::vector<vtkVolume*>& volumes)
  {
    const bool isSame =
      std::equal(volumes.begin(), volumes.end(), this->Touched.begin(), this->Touched.end(),
        [](vtkVolume* a, const vtkSmartPointer<vtkVolume>& b) { return a == b; });
    if (!isSame)
    {
      this->IsInputOurs = true;
      this->Device->SetVolumeHaptics(this->Filter);
      this->Style->TouchVolume(volumes.front());
      TouchedVolumes& all = this->Style->GetInteraction().Touched;
      std::for_each(
        volumes.begin() + 1, volumes.end(), [&all](vtkVolume* one) { all.AddAlike(one); });
      this->Touched.assign(volumes.begin(), volumes.end());
    }
    this->Style->GetInteraction().Touched.Update();
  }

  /**
   * Shows the hand and the display in a renderer, sized for a volume of this length (world units).
   */
  void Show(vtkRenderer* renderer, double length)
  {
    if (this->Renderer != renderer)
    {
      this->Hide();
      this->Renderer = renderer;
      this->Style->SetDefaultRenderer(renderer);
      this->Style->SetCurrentRenderer(renderer);
    }
    // Check this in each call, because the program may clear its scene.
    if (!renderer->HasViewProp(this->Hand) || !renderer->HasViewProp(this->Display))
    {
      renderer->AddViewProp(this->Hand);
      renderer->AddViewProp(this->Display);
      TellPass(renderer);
    }
    if (this->Style->GetSecondDevice() && !renderer->HasViewProp(this->SecondHand))
    {
      renderer->AddViewProp(this->SecondHand);
      TellPass(renderer);
    }
    // Fit the sizes to the volume unless the application has changed them.
    if (length > 0.0 && this->Hand->GetRadius() == this->Radius)
    {
      this->Radius = ProxyFraction * length;
      this->Hand->SetRadius(this->Radius);
    }
    if (length > 0.0 && this->Hand->GetForceScale() == this->ForceScale)
    {
      this->ForceScale = 1.0 / Round(ArrowFraction * length);
      this->Hand->SetForceScale(this->ForceScale);
    }
    this->SecondHand->SetRadius(this->Hand->GetRadius());
    this->SecondHand->SetForceScale(this->Hand->GetForceScale());
  }

  void Hide()
  {
    if (this->Renderer)
    {
      this->Renderer->RemoveViewProp(this->Hand);
      this->Renderer->RemoveViewProp(this->SecondHand);
      this->Renderer->RemoveViewProp(this->Display);
      TellPass(this->Renderer);
    }
    this->Renderer = nullptr;
    this->Style->SetDefaultRenderer(nullptr);
    this->Style->SetCurrentRenderer(nullptr);
  }

  /**
   * Opens and starts the device if necessary. On failure, reports the device's error and returns
   * false.
   */
  bool Start()
  {
    if (!this->Device->IsOpen())
    {
      this->HasOpened = this->Device->Open("virtual");
    }
    if (this->Device->IsOpen() && !this->Device->IsRunning())
    {
      this->HasStarted = this->Device->Start();
    }
    vtkHapticDevice* const second = this->Style->GetSecondDevice();
    if (second && !second->IsRunning() && this->Device->IsRunning())
    {
      if (!second->GetVolumeHaptics())
      {
        second->SetVolumeHaptics(this->Filter);
      }
      this->HasStartedSecond = second->Start(); // reports an error if the device is closed
    }
    return this->Device->IsRunning();
  }

  void StopSecond()
  {
    vtkHapticDevice* const second = this->Style->GetSecondDevice();
    if (std::exchange(this->HasStartedSecond, false) && second)
    {
      second->Stop();
    }
  }

  /** Ends the touch and removes the props that were added for it. */
  void Leave()
  {
    this->Style->SetInteractor(nullptr);
    this->Hide();
    this->Touched.clear();
    if (this->Device && this->Style->GetDevice())
    {
      this->Style->TouchVolume(nullptr);
    }
    this->StopSecond();
    if (std::exchange(this->HasStarted, false))
    {
      this->Device->Stop();
    }
    if (std::exchange(this->HasOpened, false))
    {
      this->Device->Close();
    }
  }

  vtkSmartPointer<vtkVolumeHapticsFilter> Filter = vtkSmartPointer<vtkVolumeHapticsFilter>::New();
  vtkSmartPointer<vtkHapticDevice> Device;
  vtkSmartPointer<vtkVolume> Volume;
  vtkNew<vtkHapticRepresentation> Hand;
  vtkNew<vtkHapticRepresentation> SecondHand;
  vtkNew<vtkHapticHeadUpDisplay> Display;
  vtkNew<StyleBeside> Style;
  vtkSmartPointer<vtkRenderer> Renderer; ///< renderer that shows the hand
  std::vector<vtkSmartPointer<vtkVolume>> Touched;
  double Radius = this->Hand->GetRadius();
  double ForceScale = this->Hand->GetForceScale();
  /** Whether the widget has connected a volume's data to the filter. */
  bool IsInputOurs = false;
  bool HasOpened = false;
  bool HasStarted = false;
  bool HasStartedSecond = false;
};

//------------------------------------------------------------------------------
vtkStandardNewMacro(vtkHapticWidget);

//------------------------------------------------------------------------------
vtkHapticWidget::vtkHapticWidget()
  : Internals(new vtkInternals)
{
  this->Priority = WidgetPriority;
  this->KeyPressActivationValue = 't';
  this->Internals->Style->Prepare = [this] { return this->Prepare(true); };
}

//------------------------------------------------------------------------------
vtkHapticWidget::~vtkHapticWidget()
{
  this->SetInteractor(nullptr);
  this->Internals->Leave();
}

//------------------------------------------------------------------------------
void vtkHapticWidget::SetEnabled(int enabling)
{
  auto& d = *this->Internals;
  if ((enabling != 0) == (this->Enabled != 0))
  {
    return;
  }
  if (!enabling)
  {
    this->Enabled = 0;
    d.Leave();
    this->InvokeEvent(vtkCommand::DisableEvent);
    return;
  }
  if (!this->Interactor)
  {
    vtkErrorMacro("The widget has no window whose events it could observe. Cure: SetInteractor() "
                  "with the window's vtkRenderWindowInteractor before On().");
    return;
  }
  d.Style->SetInteractor(this->Interactor);
  if (!this->Prepare(false))
  {
    d.Leave();
    return;
  }
  this->Enabled = 1;
  this->InvokeEvent(vtkCommand::EnableEvent);
}

//------------------------------------------------------------------------------
bool vtkHapticWidget::Prepare(bool isNeeded)
{
  auto& d = *this->Internals;
  if (d.HasOwnInput())
  {
    vtkRenderWindow* const window = this->Interactor->GetRenderWindow();
    vtkRenderer* const first = window ? window->GetRenderers()->GetFirstRenderer() : nullptr;
    vtkRenderer* const shown = this->DefaultRenderer ? this->DefaultRenderer : first;
    vtkImageData* const image = d.Filter->GetTouchedImage();
    if (shown)
    {
      d.Show(shown, image ? image->GetLength() : 0.0);
    }
    return d.Start();
  }
  if (vtkRenderer* const renderer = d.ChooseRenderer(this->Interactor))
  {
    d.Touch(d.CollectVolumes(renderer));
    d.Show(renderer, d.Touched.front()->GetLength());
    return d.Start();
  }
  if (isNeeded)
  {
    vtkErrorMacro(<< (d.Volume ? "The volume to be touched is not shown in the window. Cure: "
                                 "AddVolume() of a renderer of the window, and VisibilityOn()."
                               : "The window shows no volume that can be touched. Cure: add a "
                                 "visible vtkVolume whose mapper has an input."));
  }
  return !isNeeded;
}

//------------------------------------------------------------------------------
void vtkHapticWidget::SetTouchMode(bool on)
{
  auto& d = *this->Internals;
  if (on && !this->Enabled)
  {
    vtkErrorMacro("The widget is off. Cure: On() before SetTouchMode(true).");
    return;
  }
  if (!on || d.Style->GetTouchMode() || this->Prepare(true))
  {
    d.Style->SetTouchMode(on);
  }
}

//------------------------------------------------------------------------------
bool vtkHapticWidget::GetTouchMode()
{
  return this->Internals->Style->GetTouchMode();
}

//------------------------------------------------------------------------------
void vtkHapticWidget::SetVolume(vtkVolume* volume)
{
  if (this->Internals->Volume != volume)
  {
    this->SetTouchMode(false);
    this->Internals->Volume = volume;
    if (this->Enabled)
    {
      this->Prepare(false);
    }
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkVolume* vtkHapticWidget::GetVolume()
{
  return this->Internals->Volume;
}

//------------------------------------------------------------------------------
void vtkHapticWidget::SetDevice(vtkHapticDevice* device)
{
  auto& d = *this->Internals;
  if (!device)
  {
    vtkErrorMacro("The widget needs a device. Cure: SetDevice(), or Off().");
    return;
  }
  if (d.Device != device)
  {
    const bool wasOn = this->Enabled != 0;
    this->Off();
    d.SetDevice(device);
    this->SetEnabled(wasOn);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticDevice* vtkHapticWidget::GetDevice()
{
  return this->Internals->Device;
}

//------------------------------------------------------------------------------
void vtkHapticWidget::SetSecondDevice(vtkHapticDevice* device)
{
  auto& d = *this->Internals;
  if (device && device == this->GetDevice())
  {
    d.Style->SetSecondDevice(device); // reports an error, because it is the first hand's device
    return;
  }
  if (this->GetSecondDevice() != device)
  {
    d.SetSecondDevice(device);
    // Leave the first hand in place: it may be touching, and the pointer may be elsewhere.
    if (this->Enabled && d.Renderer)
    {
      d.Show(d.Renderer, 0.0);
      d.Start();
    }
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticDevice* vtkHapticWidget::GetSecondDevice()
{
  return this->Internals->Style->GetSecondDevice();
}

//------------------------------------------------------------------------------
void vtkHapticWidget::SetVolumeHaptics(vtkVolumeHapticsFilter* filter)
{
  auto& d = *this->Internals;
  if (!filter)
  {
    vtkErrorMacro("The widget needs a filter, which says how volumes feel. Cure: a "
                  "vtkVolumeHapticsFilter.");
    return;
  }
  if (d.Filter != filter)
  {
    const bool wasOn = this->Enabled != 0;
    this->Off();
    vtkHapticDevice* const second = this->GetSecondDevice();
    if (second && second->GetVolumeHaptics() == d.Filter)
    {
      second->SetVolumeHaptics(filter);
    }
    d.Filter = filter;
    d.IsInputOurs = false;
    d.Device->SetVolumeHaptics(filter);
    this->SetEnabled(wasOn);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkVolumeHapticsFilter* vtkHapticWidget::GetVolumeHaptics()
{
  return this->Internals->Filter;
}

//------------------------------------------------------------------------------
vtkHapticProperty* vtkHapticWidget::GetProperty()
{
  return this->Internals->Filter->GetProperty();
}

//------------------------------------------------------------------------------
vtkHapticRepresentation* vtkHapticWidget::GetRepresentation()
{
  return this->Internals->Hand;
}

//------------------------------------------------------------------------------
vtkHapticRepresentation* vtkHapticWidget::GetSecondRepresentation()
{
  return this->Internals->SecondHand;
}

//------------------------------------------------------------------------------
vtkHapticHeadUpDisplay* vtkHapticWidget::GetHeadUpDisplay()
{
  return this->Internals->Display;
}

//------------------------------------------------------------------------------
vtkInteractorStyleHaptic* vtkHapticWidget::GetStyle()
{
  return this->Internals->Style;
}

//------------------------------------------------------------------------------
bool vtkHapticWidget::UpdateHaptics()
{
  return this->Enabled && this->Internals->Style->UpdateHaptics();
}

//------------------------------------------------------------------------------
void vtkHapticWidget::SetKeyPressActivation(vtkTypeBool on)
{
  this->Internals->Style->HasActivationKey = on != 0;
  this->Superclass::SetKeyPressActivation(on);
}

//------------------------------------------------------------------------------
void vtkHapticWidget::SetKeyPressActivationValue(char key)
{
  const std::string name = KeyMap::FindName(nullptr, key, true);
  if (this->Internals->Style->SetKey("Touch", name.c_str()))
  {
    this->Superclass::SetKeyPressActivationValue(key);
  }
}

//------------------------------------------------------------------------------
void vtkHapticWidget::OnChar()
{
  // While the widget is on, StyleBeside handles the key instead.
  if (!this->Enabled && this->KeyPressActivation && this->Interactor &&
    this->Interactor->GetKeyCode() == this->KeyPressActivationValue)
  {
    this->On();
    if (this->Enabled)
    {
      this->SetTouchMode(true);
    }
    this->KeyPressCallbackCommand->SetAbortFlag(1);
  }
}

//------------------------------------------------------------------------------
void vtkHapticWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  auto& d = *this->Internals;
  os << indent << "TouchMode: " << (this->GetTouchMode() ? "On" : "Off") << "\n";
  os << indent << "Volume: " << d.Volume.GetPointer() << "\n";
  os << indent << "Device: " << d.Device.GetPointer() << "\n";
  os << indent << "SecondDevice: " << this->GetSecondDevice() << "\n";
  os << indent << "VolumeHaptics: " << d.Filter.GetPointer() << "\n";
  os << indent << "Representation: " << d.Hand.GetPointer() << "\n";
  os << indent << "HeadUpDisplay: " << d.Display.GetPointer() << "\n";
  os << indent << "Style: " << d.Style.GetPointer() << "\n";
}
