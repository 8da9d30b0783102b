// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticWidget
 * @brief   adds touch to a window of any VTK program, beside its own interactor style
 *
 * A widget that follows VTK's convention: it observes the interactor of a program, and the program
 * keeps its interactor style, its widgets and its keys.
 *
 *   vtkNew<vtkHapticWidget> widget;
 *   widget->SetInteractor(interactor);
 *   widget->GetProperty()->ApplyPreset("CT contrast");
 *   widget->On();
 *
 * While it is on, the key t (KeyPressActivationValue) with the pointer on a volume begins the touch
 * mode of vtkInteractorStyleHaptic: the mouse strokes, the wheel presses, Escape lets go. The
 * touched volume is the one of SetVolume(), or if there is none, the volume in the renderer under
 * the pointer whose surface comes first along the line of sight. Only what is shown of it is felt:
 * see vtkInteractorStyleHaptic::TouchVolume().
 *
 * In the touch mode the widget aborts the events of keys, wheel and buttons that it uses, so that
 * no observer of the program with a lower Priority gets them. The program gets all other events,
 * and outside the touch mode all events except the activation key. The right button therefore turns
 * the camera as always, and so does a drag that began before the touch mode. The widget observes
 * the interactor instead of the style, so it continues to work if the program sets another style.
 * Default Priority: 0.9, above VTK's widgets (0.5).
 *
 * The widget creates what it needs: a vtkHapticDevice, which it opens as "virtual" (the mouse) and
 * starts; a vtkVolumeHapticsFilter; and, in the renderer of the volume, a vtkHapticRepresentation
 * and a vtkHapticHeadUpDisplay. Each has a getter; device and filter also have a setter. Force ends
 * with the window: see vtkInteractorStyleHaptic. Off() ends all force, stops the device if the
 * widget has started it, and removes hand and display from the renderer.
 *
 * Needs VTK::RenderingOpenGL2 and VTK::RenderingFreeType in the application.
 *
 * @sa vtkInteractorStyleHaptic, vtkHapticDevice, vtkVolumeHapticsFilter
 */
#ifndef vtkHapticWidget_h
#define vtkHapticWidget_h

#include "vtkInteractorObserver.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::unique_ptr

class vtkHapticDevice;
class vtkHapticHeadUpDisplay;
class vtkHapticProperty;
class vtkHapticRepresentation;
class vtkInteractorStyleHaptic;
class vtkVolume;
class vtkVolumeHapticsFilter;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticWidget : public vtkInteractorObserver
{
public:
  static vtkHapticWidget* New();
  vtkTypeMacro(vtkHapticWidget, vtkInteractorObserver);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Switch the widget on or off; On() and Off() call this. Without an interactor, or if the device
   * does not open, the widget stays off and reports an error. If the window shows no volume yet,
   * the hand and the display are added when the touch mode begins.
   */
  void SetEnabled(int enabling) override;

  ///@{
  /**
   * The touch mode of vtkInteractorStyleHaptic, which begins with the volume under the pointer.
   * Default off. If the widget is off or there is no volume, the mode stays off and an error is
   * reported.
   */
  void SetTouchMode(bool on);
  bool GetTouchMode();
  vtkBooleanMacro(TouchMode, bool);
  ///@}

  ///@{
  /**
   * The volume to touch, which may be a vtkMultiVolume. Default nullptr: all volumes in the
   * renderer under the pointer can be touched.
   */
  void SetVolume(vtkVolume* volume);
  vtkVolume* GetVolume();
  ///@}

  ///@{
  /**
   * The device. When the widget is switched on, it opens a closed device as "virtual" and starts
   * it; when it is switched off, it stops and closes that device again. Default: a device that the
   * widget makes. nullptr is an error.
   */
  void SetDevice(vtkHapticDevice* device);
  vtkHapticDevice* GetDevice();
  ///@}

  ///@{
  /**
   * A device for the other hand (optional), with its own hand in the scene. The application has to
   * open it. It feels the first volume with the filter below, unless it already has a filter. The
   * widget starts it, and stops it when the widget is switched off. See
   * vtkInteractorStyleHaptic::SetSecondDevice. Default: nullptr.
   */
  void SetSecondDevice(vtkHapticDevice* device);
  vtkHapticDevice* GetSecondDevice();
  ///@}

  ///@{
  /**
   * The filter that determines how volumes feel, and its property. If several volumes can be
   * touched, this filter feels the first one, and each other volume is felt by a copy with the same
   * settings. A filter with an input feels this input, whatever the window shows; the hand is then
   * in the DefaultRenderer, or, if that is not set, in the window's first renderer. Default: a
   * filter that the widget makes. nullptr is an error.
   */
  void SetVolumeHaptics(vtkVolumeHapticsFilter* filter);
  vtkVolumeHapticsFilter* GetVolumeHaptics();
  vtkHapticProperty* GetProperty();
  ///@}

  /**
   * Get the hand in the scene. The widget fits its sizes to the touched volume, unless the
   * application has set them.
   */
  vtkHapticRepresentation* GetRepresentation();
  /** Get the second device's hand in the scene. */
  vtkHapticRepresentation* GetSecondRepresentation();
  /** Get the head-up display over the scene. */
  vtkHapticHeadUpDisplay* GetHeadUpDisplay();

  /**
   * Get the interaction, to change its settings (such as keys, measurements, slices, method and
   * comparison), and to observe its events of contact and force. The widget sets its interactor,
   * device and volume. It never becomes the interactor's style.
   */
  vtkInteractorStyleHaptic* GetStyle();

  /**
   * Update the haptics in a program whose event loop runs no VTK timers: see
   * vtkInteractorStyleHaptic::UpdateHaptics.
   */
  bool UpdateHaptics();

  void SetKeyPressActivation(vtkTypeBool on) override;
  void SetKeyPressActivationValue(char key) override;
  void OnChar() override;

protected:
  vtkHapticWidget();
  ~vtkHapticWidget() override;

private:
  vtkHapticWidget(const vtkHapticWidget&) = delete;
  void operator=(const vtkHapticWidget&) = delete;

  /**
   * Finds volumes, shows the hand in their renderer, and starts the device. Returns false on
   * failure.
   */
  bool Prepare(bool isNeeded);

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
