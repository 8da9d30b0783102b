// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticFunctionEditor
 * @brief   edits the transfer functions for touch in a chart over the scene
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
 * The left button drags a point; a click away from the points adds one. The middle button removes a
 * point. The right button selects points; if two or more are selected, a drag away from them moves
 * all of them. The first and the last point move only up and down. The title shows value and
 * position of the point that was touched last. If a point is left at the top of the chart, the axis
 * grows. The left button also drags the axes: it moves the axis of values and stretches the
 * function's axis. The wheel stretches the axis of values about the mouse, or the function's axis
 * if the mouse is on it. A double click on an axis fits the axes again.
 *
 * The tissues of the property (vtkHapticProperty::AddTissue), which presets also add, are bands
 * with names behind the function. A separate page has sliders for the material of each tissue, like
 * the page of labels below.
 *
 * Edits take effect at once: they change the vtkPiecewiseFunction itself, so the property's MTime
 * advances, and the hand feels them with the next vtkHapticDevice::Publish. To follow edits,
 * observe vtkCommand::ModifiedEvent of the function, or vtkCommand::InteractionEvent of this
 * editor, which is invoked after every mouse event that changed something.
 *
 * An empty function is shown as its constant value, without points. It stays empty until the first
 * point is added; then points with the constant value are added at both ends of the axis, too.
 * Showing a function thus never changes it.
 *
 * The editor can propose functions for an image:
 *
 *   editor->Propose();      // the proposal is dashed, over the edges that it was made from
 *   editor->TakeProposal(); // the property's functions, editable as usual
 *
 * The edges are a histogram of value (to the right) and gradient magnitude (upwards), in which each
 * boundary between two materials is an arc. Dotted lines are the gradient magnitudes at which
 * distinctness begins and at which it becomes full. The histogram and the lines are shown while the
 * property has a proposal.
 *
 * With a label table, the page after the functions edits materials by label:
 *
 *   editor->SetLabelTable(filter->GetLabelTable());
 *   editor->SetLabelData(segmentation);
 *   editor->SetFunctionToLabels();
 *
 * The page lists the labels of the image with their colours and names; boxes show whether a label
 * is felt and whether it is forbidden. A click on a label shows sliders for its material. A slider
 * without a bar stands for a quantity that comes from the functions. The wheel scrolls the list, or
 * moves a slider by a two-hundredth of its range. If a slider is left near its end, its range
 * grows. Edits change the table at once, like edits of functions.
 *
 * Undo() and Reset() take edits back; Redo() repeats an edit.
 *
 * The editor is drawn over the scene, in its rectangle, or beside the scene, in a viewport at an
 * edge of the window. The mouse can drag the border between that viewport and the scene:
 *
 *   editor->DockedOn();
 *
 * If the docked editor is wide, the tissues are beside the function.
 *
 * The editor observes no events itself. An interactor style passes the events that it wants:
 *
 *   bool used = editor->ButtonPress(vtkHapticFunctionEditor::LEFT_BUTTON, x, y);
 *   bool used = editor->MouseMove(x, y);          // and render, if used
 *   bool used = editor->ButtonRelease(vtkHapticFunctionEditor::LEFT_BUTTON, x, y);
 *   bool used = editor->TurnWheel(steps, x, y);
 *
 * with display coordinates, as vtkRenderWindowInteractor::GetEventPosition gives them. Each returns
 * true if the style should ignore the event: it is within the editor, or the editor drags a point.
 *
 * @sa vtkHapticProperty, vtkHapticDevice, vtkHapticSetup
 */
#ifndef vtkHapticFunctionEditor_h
#define vtkHapticFunctionEditor_h

#include "vtkProp.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkHapticLabelTable;
class vtkHapticProperty;
class vtkImageData;
class vtkPiecewiseFunction;
class vtkVolumeProperty;

#ifndef __VTK_WRAP__
namespace VolumeHaptics
{
struct EditorProbe;
}
#endif

class VTKVOLUMEHAPTICS_EXPORT vtkHapticFunctionEditor : public vtkProp
{
public:
  static vtkHapticFunctionEditor* New();
  vtkTypeMacro(vtkHapticFunctionEditor, vtkProp);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The property whose functions are edited. Its component determines which histogram and which
   * opacity are shown.
   */
  void SetProperty(vtkHapticProperty* property);
  vtkHapticProperty* GetProperty();
  ///@}

  ///@{
  /**
   * The volume property whose scalar opacity is edited.
   */
  void SetVolumeProperty(vtkVolumeProperty* property);
  vtkVolumeProperty* GetVolumeProperty();
  ///@}

  ///@{
  /**
   * The data, which determine the histogram, the range and the name of the axis of values. Without
   * data, the axis is fitted to the points.
   */
  void SetInputData(vtkImageData* image);
  vtkImageData* GetInputData();
  ///@}

  ///@{
  /**
   * SetLabelTable sets the table whose materials are edited; SetLabelData sets the label image,
   * whose point scalars determine which labels are listed. Without an image, the labels of the
   * table are listed.
   */
  void SetLabelTable(vtkHapticLabelTable* table);
  vtkHapticLabelTable* GetLabelTable();
  void SetLabelData(vtkImageData* labels);
  vtkImageData* GetLabelData();
  ///@}

  enum FunctionType
  {
    STIFFNESS = 0,
    FRICTION = 1,
    VISCOSITY = 2,
    SURFACE_STRENGTH = 3,
    OPACITY = 4,
    LABELS = 5,
    TISSUES = 6
  };

  ///@{
  /**
   * The edited function; LABELS and TISSUES are lists. Default STIFFNESS. NextFunction switches to
   * the next function whose property or table is set, in the order above, and skips TISSUES if
   * there are no tissues.
   */
  void SetFunction(int function);
  vtkGetMacro(Function, int);
  void SetFunctionToStiffness() { this->SetFunction(STIFFNESS); }
  void SetFunctionToFriction() { this->SetFunction(FRICTION); }
  void SetFunctionToViscosity() { this->SetFunction(VISCOSITY); }
  void SetFunctionToSurfaceStrength() { this->SetFunction(SURFACE_STRENGTH); }
  void SetFunctionToOpacity() { this->SetFunction(OPACITY); }
  void SetFunctionToLabels() { this->SetFunction(LABELS); }
  void SetFunctionToTissues() { this->SetFunction(TISSUES); }
  void NextFunction();
  ///@}

  ///@{
  /**
   * Propose searches for functions that suit the input data (vtkHapticProperty::ProposeFromImage),
   * and shows them, dashed, beside the functions of the property, until they are accepted
   * (TakeProposal) or dropped. Returns false and reports an error if there is no property, or
   * nothing to propose. The work takes about a second, between vtkCommand::StartEvent and
   * vtkCommand::EndEvent.
   *
   * BeginProposal does the same in the background, so that a hand can go on touching, and returns
   * at once. It returns false and reports an error if there is no property or no volume. Update()
   * shows the proposal when it is ready, or reports an error that says why there is none. Until
   * then, IsProposing returns true.
   *
   * TakeProposal makes the proposal the property's functions and surface side, and invokes
   * vtkCommand::InteractionEvent; the kernel's radius that suits it is
   * vtkHapticProperty::GetProposedKernelRadius. TakeProposal and DropProposal return whether there
   * was a proposal; DropProposal also ends the search for one.
   */
  bool Propose();
  bool BeginProposal();
  bool IsProposing();
  bool HasProposal();
  bool TakeProposal();
  bool DropProposal();
  ///@}

  /**
   * Select the label whose material has sliders, and scroll to it. Returns false if the label is
   * not in the list.
   */
  bool SelectLabel(int label);

  ///@{
  /**
   * Undo the last edit of this editor, redo it, or undo all edits. Each returns whether anything
   * was undone or redone, and invokes vtkCommand::InteractionEvent. An edit is what happens from
   * the press of a button to its release, a step of the wheel, a proposal that was taken, or
   * another Reset(). Functions, surface side and tissues of the property, opacity and label table
   * become what they were before the edit, even if a program has changed them since. The component
   * and the visibility stay unchanged. The last 100 edits are kept. Setting another property,
   * volume property or label table clears them.
   */
  bool Undo();
  bool Redo();
  bool Reset();
  ///@}

  /** Get the title of the edited function, with its unit, such as "Stiffness (N/m)". */
  std::string GetTitle();

  /**
   * Get the warning that the title of stiffness and viscosity shows if the drag is too strong for
   * the stiffness at some value: the proxy would lag by more than 10 mm, so the drag is limited.
   * Empty without a warning.
   */
  std::string GetWarning();

  /** Get the edited function; nullptr for LABELS and TISSUES, or if its property is not set. */
  vtkPiecewiseFunction* GetPiecewiseFunction();

  ///@{
  /**
   * Set the lower left corner, width and height in pixels of the viewport, for an editor that is
   * not Docked. It is legible from 120 x 90 on. Corner coordinates are clamped to -16384 to 16384,
   * width and height to 1 to 16384. Default (10, 10, 300, 200).
   */
  void SetRectangle(int x, int y, int width, int height);
  void SetRectangle(const int rectangle[4]) VTK_SIZEHINT(4);
  vtkGetVector4Macro(Rectangle, int);
  ///@}

  ///@{
  /**
   * Whether the editor is beside the scene, in a viewport of its own, instead of over the scene in
   * its rectangle. Default off. While the editor is visible, the other renderers of the window
   * share the rest. Takes effect with the next frame of the window in which the editor was drawn.
   */
  vtkSetMacro(Docked, bool);
  vtkGetMacro(Docked, bool);
  vtkBooleanMacro(Docked, bool);
  ///@}

  enum DockEdgeType
  {
    LEFT_EDGE = 0,
    RIGHT_EDGE = 1,
    BOTTOM_EDGE = 2,
    TOP_EDGE = 3
  };

  ///@{
  /** The edge of the window for an editor that is Docked: Left, Right, Bottom (default) or Top. */
  vtkSetClampMacro(DockEdge, int, LEFT_EDGE, TOP_EDGE);
  vtkGetMacro(DockEdge, int);
  void SetDockEdgeToLeft() { this->SetDockEdge(LEFT_EDGE); }
  void SetDockEdgeToRight() { this->SetDockEdge(RIGHT_EDGE); }
  void SetDockEdgeToBottom() { this->SetDockEdge(BOTTOM_EDGE); }
  void SetDockEdgeToTop() { this->SetDockEdge(TOP_EDGE); }
  ///@}

  ///@{
  /**
   * The fraction of the window's width or height that a Docked editor takes, 0.1 to 0.9. Default
   * 0.35. Dragging the border to the scene changes it.
   */
  vtkSetClampMacro(DockShare, double, 0.1, 0.9);
  vtkGetMacro(DockShare, double);
  ///@}

  ///@{
  /**
   * Update recomputes the histogram, or the list of LABELS, if the data have changed, between
   * vtkCommand::StartEvent and vtkCommand::EndEvent. Mouse events and rendering also call it.
   * EstimateUpdateTime returns the approximate time (s) of the update on a desktop computer; only
   * Propose() takes a noticeable time. If it is long, vtkInteractorStyleHaptic fades the force out
   * first.
   *
   * For a large image (more than 4 million points), histogram and list first come from samples that
   * are spread over the image. A background thread then reads all values and edges, and the next
   * Update() shows the result. GetCountedFraction returns the finished fraction of this work (0 to
   * 1); vtkInteractorStyleHaptic redraws the editor while the fraction grows.
   */
  void Update();
  double EstimateUpdateTime();
  double GetCountedFraction();
  ///@}

  /** Returns whether the editor is visible and contains a position on the display (pixels). */
  bool Contains(int x, int y);

  enum ButtonType
  {
    LEFT_BUTTON = 1,
    MIDDLE_BUTTON = 2,
    RIGHT_BUTTON = 4
  };

  ///@{
  /**
   * Handle mouse events at a position on the display (pixels). Return true if the editor uses the
   * event.
   */
  bool MouseMove(int x, int y);
  bool ButtonPress(int button, int x, int y);
  bool ButtonRelease(int button, int x, int y);
  bool DoubleClick(int button, int x, int y);
  ///@}

  /**
   * Handle a turn of the mouse wheel; steps away from the user are positive. Returns true if the
   * editor uses the event.
   */
  bool TurnWheel(double steps, int x, int y);

  ///@{
  /** Draw the editor, and release its graphics resources; called by the renderer. */
  int RenderOverlay(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  ///@}

protected:
  vtkHapticFunctionEditor();
  ~vtkHapticFunctionEditor() override;

  int Function = STIFFNESS;
  int Rectangle[4] = { 10, 10, 300, 200 };
  bool Docked = false;
  int DockEdge = BOTTOM_EDGE;
  double DockShare = 0.35;

private:
  vtkHapticFunctionEditor(const vtkHapticFunctionEditor&) = delete;
  void operator=(const vtkHapticFunctionEditor&) = delete;

  void UpdatePage();
  bool CanPropose();
  void PollProposal();
  bool Send(int event, int button, int x, int y);
  bool TakeBack(bool hasChanged);
  int Draw(vtkViewport* viewport);

#ifndef __VTK_WRAP__
  friend struct VolumeHaptics::EditorProbe;
#endif
  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
