// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticFunctionEditor
 * @brief   an editor in the scene for what a volume feels like
 *
 * A chart over the view that shows one of the functions of a vtkHapticProperty, or the scalar
 * opacity of a vtkVolumeProperty, over the histogram of the data (on a logarithmic scale), with
 * control points to drag:
 *
 *   editor->SetProperty(filter->GetProperty());
 *   editor->SetVolumeProperty(volume->GetProperty());
 *   editor->SetInputData(image);
 *   renderer->AddViewProp(editor);
 *
 * Left button: drag a point; a click beside the points adds one. Middle button: remove a point.
 * Right button: select points, which then move together. The first and the last point move up and
 * down only. The title tells value and place of the point that was touched last. Where a point was
 * left at the top of the chart, the axis grows.
 *
 * Edits are live: they change the vtkPiecewiseFunction itself, so that the property's MTime
 * advances; the hand feels them with the next vtkHapticDevice::Publish. To be told, observe
 * vtkCommand::ModifiedEvent of the function, or vtkCommand::InteractionEvent of this editor, which
 * follows every event of the mouse that changed something.
 *
 * An empty function is shown as the constant that it stands for, without points, and stays empty
 * until the first point is added: that adds the constant at both ends of the axis, too. So nothing
 * that is felt changes by looking.
 *
 * The editor takes no events by itself. An interactor style hands it those that it wants:
 *
 *   bool used = editor->ButtonPress(vtkHapticFunctionEditor::LEFT_BUTTON, x, y);
 *   bool used = editor->MouseMove(x, y);          // and render, if used
 *   bool used = editor->ButtonRelease(vtkHapticFunctionEditor::LEFT_BUTTON, x, y);
 *
 * with display coordinates, as vtkRenderWindowInteractor::GetEventPosition gives them. Each is true
 * where the style should leave the event alone: within the editor, or while it drags.
 *
 * @sa vtkHapticProperty, vtkHapticDevice, vtkHapticSetup
 */
#ifndef vtkHapticFunctionEditor_h
#define vtkHapticFunctionEditor_h

#include "vtkProp.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkHapticProperty;
class vtkImageData;
class vtkPiecewiseFunction;
class vtkVolumeProperty;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticFunctionEditor : public vtkProp
{
public:
  static vtkHapticFunctionEditor* New();
  vtkTypeMacro(vtkHapticFunctionEditor, vtkProp);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whose haptic functions are edited. Its component is that of histogram and opacity.
   */
  void SetProperty(vtkHapticProperty* property);
  vtkHapticProperty* GetProperty();
  ///@}

  ///@{
  /**
   * Whose scalar opacity is edited.
   */
  void SetVolumeProperty(vtkVolumeProperty* property);
  vtkVolumeProperty* GetVolumeProperty();
  ///@}

  ///@{
  /**
   * The data, for histogram, range and name of the value axis. Without data the axis fits the
   * points.
   */
  void SetInputData(vtkImageData* image);
  vtkImageData* GetInputData();
  ///@}

  enum FunctionType
  {
    STIFFNESS = 0,
    FRICTION = 1,
    VISCOSITY = 2,
    SURFACE_STRENGTH = 3,
    OPACITY = 4
  };

  ///@{
  /**
   * The function that is edited. Default STIFFNESS. NextFunction goes through all that there is a
   * property for, in the order above.
   */
  void SetFunction(int function);
  vtkGetMacro(Function, int);
  void SetFunctionToStiffness() { this->SetFunction(STIFFNESS); }
  void SetFunctionToFriction() { this->SetFunction(FRICTION); }
  void SetFunctionToViscosity() { this->SetFunction(VISCOSITY); }
  void SetFunctionToSurfaceStrength() { this->SetFunction(SURFACE_STRENGTH); }
  void SetFunctionToOpacity() { this->SetFunction(OPACITY); }
  void NextFunction();
  ///@}

  /** Its name and unit, as the title shows them: "Stiffness (N/m)". */
  std::string GetTitle();

  /** The function itself; nullptr where its property is not set. */
  vtkPiecewiseFunction* GetPiecewiseFunction();

  ///@{
  /**
   * Lower left corner, width and height in pixels of the viewport; 120 x 90 or more is readable.
   * Corner coordinates are clamped to -16384 to 16384, width and height to 1 to 16384. Default (10,
   * 10, 300, 200).
   */
  void SetRectangle(int x, int y, int width, int height);
  void SetRectangle(const int rectangle[4]) VTK_SIZEHINT(4);
  vtkGetVector4Macro(Rectangle, int);
  ///@}

  ///@{
  /**
   * Update computes the histogram again if the data have changed, and invokes
   * vtkCommand::StartEvent before and vtkCommand::EndEvent after that. Mouse events and rendering
   * call it, too. EstimateUpdateTime returns about how long (s) it will take on a desktop computer,
   * 0 if the histogram is up to date. If that is long, vtkInteractorStyleHaptic fades the force out
   * meanwhile.
   */
  void Update();
  double EstimateUpdateTime();
  ///@}

  /** Whether a place on the display (pixels) is within the editor, and that is visible. */
  bool Contains(int x, int y);

  enum ButtonType
  {
    LEFT_BUTTON = 1,
    MIDDLE_BUTTON = 2,
    RIGHT_BUTTON = 4
  };

  ///@{
  /**
   * Events of the mouse at a place on the display (pixels). True if the editor takes it.
   */
  bool MouseMove(int x, int y);
  bool ButtonPress(int button, int x, int y);
  bool ButtonRelease(int button, int x, int y);
  bool DoubleClick(int button, int x, int y);
  ///@}

  /**
   * Where a value and a function's value stand on the display (pixels), after a render.
   */
  void GetDisplayPosition(double value, double functionValue, double position[2])
    VTK_SIZEHINT(position, 2);

  ///@{
  /** For the renderer. */
  int RenderOverlay(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  ///@}

protected:
  vtkHapticFunctionEditor();
  ~vtkHapticFunctionEditor() override;

  int Function = STIFFNESS;
  int Rectangle[4] = { 10, 10, 300, 200 };

private:
  vtkHapticFunctionEditor(const vtkHapticFunctionEditor&) = delete;
  void operator=(const vtkHapticFunctionEditor&) = delete;

  void UpdateChart();
  bool Send(int event, int button, int x, int y);

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
