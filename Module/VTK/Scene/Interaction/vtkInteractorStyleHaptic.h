// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInteractorStyleHaptic
 * @brief   adds a hand that touches the scene to a trackball camera style
 *
 * Lets the user touch the volumes of a scene with a vtkHapticDevice, or with the mouse in its
 * place, and moves the camera as vtkInteractorStyleTrackballCamera does. A timer collects the
 * device's states, sends changes of the filter to the servo, and renders:
 *
 *   style->SetDevice(device);             // open, and started
 *   interactor->SetInteractorStyle(style);
 *   style->TouchVolume(volume);           // the hand feels what this volume shows
 *   interactor->Start();                  // then press t, and move the mouse
 *
 * In the touch mode the mouse moves the tip of the virtual device:
 *
 *   mouse                 moves the tip along the surface, or in the plane of the view; see
 *                         SetTipFollowsSurface()
 *   wheel                 moves the tip into the screen and out of it, along the line of sight
 *   Ctrl + mouse          the same; a motion upwards moves the tip into the screen
 *   Alt + mouse, wheel    turn a tool with a shape (vtkHapticPointShell), also in a real device
 *                         that measures no orientation; the wheel turns it about the line of sight
 *   Shift                 makes any of these motions five times finer
 *   left button           the device's button
 *   right button          rotates the camera
 *   middle button         pans the camera
 *   Ctrl + wheel          zooms
 *
 * Keys, in any mode (besides those of vtkInteractorStyle), unless SetKey() has changed them:
 *
 *   t           touch mode on and off; it begins in front of the first surface under the pointer
 *   a           arm, so that force may flow, or disarm; touch mode also arms. A hand that is armed
 *               inside a body feels nothing until it moves
 *   Escape, End disarm, and leave the touch mode and the clutch
 *   c           put the device's workspace back around the camera's focal point
 *   k           clutch: while the key is held, a real device moves without the tip and without
 *               force. The force comes back when the key is released, unless the device was
 *               disarmed before that
 *   Home        search for the zero of a real device's encoders: see vtkHapticDevice::Home()
 *   + and -     a larger and a smaller workspace
 *   m           the next method: see NextMethod()
 *   y           compare two settings, A and B, at one position: see SwapSettings()
 *   j           feel only the next mode of PRIMITIVES; after the last one, all modes. A click on a
 *               mode in the head-up display switches it on or off
 *   ? or F1     show the keys that do something in this scene; again, or Escape: hide them
 *   h, g and d  head-up display: text, graph, and details in the text
 *   v and n     function editor: on and off, and the next function
 *   u           function editor beside the scene, and over it
 *   Ctrl+Z, Ctrl+Y
 *               undo and redo edits, if the pointer is over the function editor or there are no
 *               measurements; Ctrl+Backspace takes back all edits
 *   l           materials of labels in the function editor: on, with the touched label selected,
 *               and off
 *   p           propose functions in the editor; again: accept the proposal, and the KernelRadius
 *               of the filter that suits it
 *   Backspace   drop the proposal
 *   s           slices: on and off
 *
 * Keys of a volume that moves (vtkHapticPlayback::Play):
 *
 *   space       play, and hold
 *   Left, Right hold, and go to the previous and the next time step
 *   , and .     half and double the speed
 *   b           at the last time step: hold (once), go on with the first (loop), or turn back
 *
 * SetMeasurements and SetSliceView bring keys and mouse actions of their own. Mouse events over the
 * function editor go to the editor.
 *
 * **A real device.** The workspace follows the camera: right, up and towards the user are the same
 * for the hand as for the eye. A SpaceMouse turns the volume about the focal point: the camera
 * moves the other way.
 *
 * **The end of force.** The style leaves the touch mode and disarms when the interactor's loop ends
 * (the keys q and e, the window manager's close, TerminateApp()), before any other observer of
 * ExitEvent is called; when the window is finalized; when the touched renderer is taken out of it;
 * and when the interactor is disabled, deleted or given another style. Force fades out when a
 * window is minimised or hidden, if the system reports it: see FadeOut. If the force ends for long
 * work (vtkHapticDevice::BeginLongWork), the style renders first, so that the head-up display shows
 * the reason. It calls BeginLongWork by itself for the function editor's histogram of a large
 * volume.
 *
 * **Pictures.** While a device is set, volumes of the scene show what is felt:
 *
 * - if the felt volume moves, the volumes of the renderer that show the felt image (by their
 *   mapper's input, or its scalars) show the time step nearest to what is felt, for which the style
 *   replaces the input of their mappers. The head-up display shows the time;
 * - volumes in the window that show the touched array show what a vtkHapticBurr has left of it.
 *   vtkGPUVolumeRayCastMapper, also in a vtkSmartVolumeMapper, gets only the parts of its texture
 *   that have changed. Other mappers, textures that are divided (SetPartitions), and images that
 *   nowhere have a value as low (or high) as the removal's AirValue are shown by a copy, which
 *   takes the memory of the array once more and is prepared as a whole after each change; this copy
 *   replaces the input of the mapper. The image itself does not change.
 *
 * The style sets a hint in the head-up display (vtkHapticHeadUpDisplay::SetHint) that says how to
 * begin, and then how to go on, until something was touched.
 *
 * @sa vtkHapticDevice, vtkHapticRepresentation, vtkHapticHeadUpDisplay, vtkHapticFunctionEditor,
 * vtkHapticSliceView
 */
#ifndef vtkInteractorStyleHaptic_h
#define vtkInteractorStyleHaptic_h

#include "vtkCommand.h" // for vtkCommand::UserEvent
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkHapticDevice;
class vtkHapticFunctionEditor;
class vtkHapticHeadUpDisplay;
class vtkHapticMeasurements;
class vtkHapticSliceView;
class vtkStringArray;
class vtkTable;
class vtkVolume;
class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{
class HapticInteraction;
}

class VTKVOLUMEHAPTICS_EXPORT vtkInteractorStyleHaptic : public vtkInteractorStyleTrackballCamera
{
public:
  static vtkInteractorStyleHaptic* New();
  vtkTypeMacro(vtkInteractorStyleHaptic, vtkInteractorStyleTrackballCamera);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Events, one per change, in the order of the changes in the servo. */
  enum HapticEvents
  {
    ContactBeginEvent = vtkCommand::UserEvent + 100, ///< a surface starts to hold the proxy
    ContactEndEvent,                                 ///< no surface holds the proxy any more
    ArmedEvent,                                      ///< force may flow from now on
    DisarmedEvent,                                   ///< force may not flow any more; not sent
                                                     ///< after a fault
    FaultEvent,                                      ///< the safety stage has cut the force off
    StatesEvent                                      ///< sent after each update with new states
  };

  ///@{
  /** The device, which the application has to open and start. */
  void SetDevice(vtkHapticDevice* device);
  vtkHapticDevice* GetDevice();
  ///@}

  ///@{
  /**
   * A device for the other hand (optional), which the application has to open and start, with the
   * same filter or another one. Each hand has its own force, and a fault affects only one hand. The
   * key a arms the hands that are not armed, and disarms both if both are armed; Escape, End and
   * the end of the window release both; k, c, + and - change both workspaces. The mouse,
   * measurements, slices, recordings, events and GetStates() belong to the first hand. Only the
   * first hand feels a moving volume. Default: nullptr.
   */
  void SetSecondDevice(vtkHapticDevice* device);
  vtkHapticDevice* GetSecondDevice();
  ///@}

  ///@{
  /**
   * The head-up display, which gets the states from the style, and the function editor. Both are
   * optional. Keys switch them on and off. The application adds them to a renderer.
   */
  void SetHeadUpDisplay(vtkHapticHeadUpDisplay* display);
  vtkHapticHeadUpDisplay* GetHeadUpDisplay();
  void SetFunctionEditor(vtkHapticFunctionEditor* editor);
  vtkHapticFunctionEditor* GetFunctionEditor();
  ///@}

  ///@{
  /**
   * Slices beside the scene (optional), which the application has put into the window. The key s
   * switches them on and off. The mouse in a slice:
   *
   *   left button           begins the touch mode at the position, or moves the tip there; the tip
   *                         touches what lies between
   *   wheel                 moves the slice, and in the touch mode also the tip
   *   right button, or Shift + left: change the window (left and right) and the level (up, down)
   *
   * A program can't move a real device. So with a real device, or without a device, only the slices
   * move to the position, until the tip moves.
   */
  void SetSliceView(vtkHapticSliceView* slices);
  vtkHapticSliceView* GetSliceView();
  ///@}

  ///@{
  /**
   * The volume that shows the CoarseImage of the vtkHapticRegionSource that the device's filter
   * feels (optional). The style cuts the box of the samples in memory out of it, and shows these
   * samples there, so that the picture is fine around the hand. The image of the volume's mapper
   * must not have a direction matrix; use the volume's matrix to rotate it. The style sets the
   * mapper's cropping. nullptr (default) restores the volume.
   */
  void SetCoarseVolume(vtkVolume* volume);
  vtkVolume* GetCoarseVolume();
  ///@}

  ///@{
  /**
   * The list of measurements that the keys below fill (optional). The application shows it with a
   * vtkHapticMeasurementRepresentation, and lists it with vtkHapticHeadUpDisplay::SetMeasurements.
   * Default nullptr: these keys do nothing. They measure the position of the proxy while something
   * is touched:
   *
   *   1           a point
   *   2           the ends of a distance, one after the other
   *   3           the points of an angle; the second one is its corner
   *   4           begins and ends a path. It has a sample for each tick in contact, or samples at
   *               the distance of vtkHapticMeasurements::SetPathSpacing. With FORCE_FIELD, 4 and 5
   *               record nothing, because it has no contact
   *   5           begins and ends an area, which a brush paints on an isosurface. It is the one of
   *               SURFACE_PROXY; with other methods, its value is halfway between the values at the
   *               proxy and at the surface where the brush begins. See
   *               vtkHapticMeasurements::AddPaintedArea
   *   Ctrl+Z, Ctrl+Y
   *               undo and redo. While a distance or an angle is incomplete, Ctrl+Z takes back its
   *               last point instead
   *   Delete      remove the last measurement of the list
   *   i           the list in the head-up display: on and off
   *
   * Escape ends a path or an area, and discards the points of an incomplete distance or angle.
   */
  void SetMeasurements(vtkHapticMeasurements* measurements);
  vtkHapticMeasurements* GetMeasurements();
  ///@}

  ///@{
  /**
   * The application's keys for the list of keys, in the form of vtkHapticHeadUpDisplay::HelpText.
   * They are shown below the keys of the style. Default empty.
   */
  void SetApplicationKeys(const char* keys);
  const char* GetApplicationKeys();
  ///@}

  ///@{
  /**
   * The keys of an action, separated by spaces, with the names that
   * vtkRenderWindowInteractor::GetKeySym() gives. An empty text ("") disables the action; the key
   * then goes to vtkInteractorStyle or the application. SetKey returns false and reports an error
   * if there is no such action, or if another action has one of the keys. The hint and the list of
   * keys show the new keys.
   *
   *   style->SetKey("Touch", "Return"); // instead of t
   *   style->SetKey("NextMethod", ""); // none
   *
   * Actions and default keys: Touch t, Arm a, LetGo Escape End, NextMethod m, Compare y, NextMode
   * j, Help question F1, Text h, Graph g, Details d, Slices s, Point 1, Distance 2, Angle 3, Path
   * 4, Area 5, Undo Ctrl+z, Redo Ctrl+y, RemoveLast Delete, Measurements i, FunctionEditor v,
   * NextFunction n, Propose p, DropProposal BackSpace, DockEditor u, ResetFunctions Ctrl+BackSpace,
   * Labels l, Play space, FrameBefore Left, FrameAfter Right, Slower comma, Faster period, AtTheEnd
   * b, RecenterWorkspace c, Clutch k, LargerWorkspace plus KP_Add, SmallerWorkspace minus
   * KP_Subtract, Home Home. With "Ctrl+" before its name, a key is pressed with Ctrl; its letter is
   * lower case. A capital letter that no action has does what its small letter does.
   */
  bool SetKey(const char* action, const char* keys);
  std::string GetKey(const char* action);
  static vtkStringArray* GetKeyActions();
  ///@}

  ///@{
  /**
   * Perform and describe actions, for buttons and menus of a program. PerformAction does what the
   * action's key does, and returns false if the scene has no part for it; Clutch is on until
   * SetClutch(false) or LetGo. Undo and Redo are those of the measurements, if there are any,
   * wherever the pointer is. GetActionText returns what an action does, such as "the next method",
   * and an empty text if the scene has no part for it. GetActionGroup returns the title above it in
   * the list of keys.
   *
   *   style->PerformAction("Touch"); // as key t: touch what is under the pointer; let go
   */
  bool PerformAction(const char* action);
  std::string GetActionText(const char* action);
  static std::string GetActionGroup(const char* action);
  ///@}

  /** Get the list of keys for the present scene, including the application's keys. */
  std::string GetKeys();

  ///@{
  /**
   * The touch mode, default off. Switching it on puts the tip of a virtual device in front of the
   * first surface under the pointer, or if there is none, into the plane of the focal point, and
   * arms the device. Without an interactor or a running device, or if the window was closed, it
   * stays off and reports an error. It also stays off if one of these happens while the surface is
   * meshed: the loop ends, the device is disarmed, or the device or the interactor is removed.
   */
  void SetTouchMode(bool on);
  virtual bool GetTouchMode();
  vtkBooleanMacro(TouchMode, bool);
  ///@}

  ///@{
  /**
   * Hold the hand in place for a number of clicks in the scene. 1: the hand stays in place, so that
   * the pointer can move to a button while the hand still presses; a click releases it. 2: a click
   * holds it, and the next one releases it. Each click lowers the number by 1. A released hand
   * continues from its position. The end of a touch releases it. Default: 0, not held.
   */
  void SetHoldClicks(int clicks);
  int GetHoldClicks() { return this->HoldClicks; }
  ///@}

  /**
   * Leave the touch mode and fade the force out. Call this in a program that hides the view,
   * because cutting the force off would be felt as a jump.
   *
   * The style fades the force by itself when a window of X11, or a window around it, is minimised
   * or hidden, which includes Tk and wx. Neither VTK nor X11 reports that a QVTKOpenGLNativeWidget
   * is hidden: call VolumeHaptics::WidgetWatch::Watch() of Qt/WidgetWatch.h once. On other systems,
   * call FadeOut() when the program hides a view.
   */
  void FadeOut();

  ///@{
  /**
   * The distance that a step of the wheel moves the tip (world units, 0 or more). Default 0: the
   * smallest spacing of the image.
   */
  vtkSetClampMacro(DepthStep, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(DepthStep, double);
  ///@}

  ///@{
  /**
   * Whether the quality of ray casters is adjusted. While something moves, they draw as finely as
   * 20 frames per second allow. At rest, input interrupts a frame; while the device is armed, a
   * frame takes at most 0.5 s, or 0.1 s if it can't be interrupted. Default on.
   *
   * In motion, vtkGPUVolumeRayCastMapper and vtkFixedPointVolumeRayCastMapper cast fewer rays and
   * take fewer samples on them, at least one in each voxel. Only the fixed point mapper, which runs
   * on the processor, can be interrupted. If OpenGL runs on the processor, too,
   * vtkSmartVolumeMapper uses that mapper while a scene is touched. Windows off the screen are not
   * adjusted, unless AutoAdjustOffScreen is on.
   */
  vtkSetMacro(AutoAdjustVolumeQuality, bool);
  vtkGetMacro(AutoAdjustVolumeQuality, bool);
  vtkBooleanMacro(AutoAdjustVolumeQuality, bool);
  ///@}

  ///@{
  /**
   * Whether AutoAdjustVolumeQuality also adjusts a window off the screen, for applications that
   * show its frames elsewhere, such as in a browser. Default off.
   */
  vtkSetMacro(AutoAdjustOffScreen, bool);
  vtkGetMacro(AutoAdjustOffScreen, bool);
  vtkBooleanMacro(AutoAdjustOffScreen, bool);
  ///@}

  ///@{
  /**
   * Updates per second, 1 to 240. Default 60. Takes effect with the next interactor.
   *
   * At each update the timer collects the device's states, sends changes of the filter (image,
   * functions, settings) to the servo, updates the head-up display, invokes events, and renders. It
   * never waits for the servo. While the tip or the camera moves, it renders at the interactor's
   * desired update rate, so that mappers with adjustable sample distances sample more coarsely. At
   * rest it renders once at the still rate, and then only when figures in the head-up display
   * change, in at most a tenth of the time.
   */
  vtkSetClampMacro(DisplayRate, double, 1.0, 240.0);
  vtkGetMacro(DisplayRate, double);
  ///@}

  ///@{
  /**
   * Whether the mouse moves the tip along the first surface under the pointer, at the depth that
   * the wheel has set, so that a stroke can go around a head. If this is off, if there is no
   * surface, or beyond an edge, the tip moves in the plane of the view. Default on.
   */
  vtkSetMacro(TipFollowsSurface, bool);
  vtkGetMacro(TipFollowsSurface, bool);
  vtkBooleanMacro(TipFollowsSurface, bool);
  ///@}

  ///@{
  /** Whether the workspace of a real device follows the camera. Default on. */
  vtkSetMacro(WorkspaceFollowsCamera, bool);
  vtkGetMacro(WorkspaceFollowsCamera, bool);
  vtkBooleanMacro(WorkspaceFollowsCamera, bool);
  ///@}

  ///@{
  /**
   * World units per metre of a real device's workspace, 0 or more. Default 0: computed from the
   * filter's MetersPerWorldUnit.
   */
  vtkSetClampMacro(WorkspaceScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(WorkspaceScale, double);
  ///@}

  ///@{
  /**
   * Bring the workspace of a real device back to the focal point, or switch its clutch on and off.
   */
  void RecenterWorkspace();
  void SetClutch(bool on);
  virtual bool GetClutch();
  ///@}

  /**
   * Feel the same position with the next method of the device's filter, in the order of
   * vtkVolumeHapticsFilter::GetMethodNames. The servo continues, and the force grows at most at the
   * device's MaximumForceRate. While the mesh of SURFACE_PROXY is made, the hand feels the previous
   * method, and then the surface around the tip (vtkHapticDevice::Publish), as the head-up display
   * shows. Returns false and reports an error if the method can't be felt, for example because
   * IsoValue does not occur in the image. The previous method then stays, and the next call skips
   * the method that failed.
   */
  bool NextMethod();

  ///@{
  /**
   * Compare two settings of the device's filter on one spot. The first call keeps the present
   * settings as A, and makes B a copy of them, which you then change: its method, its preset or its
   * functions. Each further call swaps A and B under the hand. A swap never pushes a resting hand:
   * if the other settings would give more force, that force comes only after the hand lifts and
   * presses again. A and B differ in the settings of the filter, of its property and of its label
   * table; the modes of PRIMITIVES and the inputs are the same in both. The head-up display tells
   * which settings are felt. If there is no filter, or if the other settings can't be felt here,
   * returns false, reports an error, and changes nothing.
   *
   * GetComparedSettings returns "A" or "B", whichever is felt, or an empty text if nothing is
   * compared. EndComparison keeps the felt settings and discards the others, and so does setting
   * another device or filter.
   */
  bool SwapSettings();
  std::string GetComparedSettings();
  void EndComparison();
  ///@}

  /**
   * Do what the timer does at each update, except drawing: publish changes, read states, invoke
   * events, and update the head-up display. For applications without timers. Returns whether there
   * is anything new to draw.
   *
   * If an event loop sends mouse and key events, but no timer events for a second, the style warns
   * once, and updates with these events and with each frame of the window, until the program calls
   * UpdateHaptics() or DrawHaptics().
   */
  bool UpdateHaptics();

  /**
   * Do all that the timer does: call UpdateHaptics(), and draw a frame if one is due. For
   * applications whose event loop runs no VTK timers, such as a server; call it DisplayRate times
   * per second. Returns whether it has drawn.
   */
  bool DrawHaptics();

  /**
   * Draw a fine frame, as at rest, that input can't interrupt, for example for a picture in a
   * file: an interrupted frame lacks the volumes. Returns false if the window is closed.
   */
  bool DrawWholeFrame();

  ///@{
  /**
   * Feel what a volume shows, and follow it. From now on, each update of the haptics gives the
   * device's filter: the image of the volume's mapper, placed by the volume's position,
   * orientation, scale and user matrix; the array and the component that the mapper draws; its
   * clipping planes and cropping; and the opacity of the volume's property as visibility
   * (vtkHapticProperty::SetVisibilityFrom). Data other than images are felt at their own positions.
   * All ports of a vtkMultiVolume are felt, each by a copy of the device's filter that follows its
   * settings, as after AddTouchedVolume(); for a single port call TouchVolume(GetVolume(0)). Voxels
   * that the mapper hides by a mask or by the opacity of a mask's labels, blanked voxels, and
   * everything outside of all isosurfaces that it draws are cut away. Materials, method and
   * FeelCutFaces stay the filter's own. If a matrix places the image, only its current time step is
   * felt. nullptr stops following, and leaves the filter unchanged. Returns false and reports an
   * error if there is no device, or if the volume has no mapper with an input. A device without a
   * filter gets one, even if this call fails.
   *
   * What is not visible is not felt. The style leaves the touch mode, disarms and warns if the
   * volume or an assembly around it is made invisible, if the volume loses its mapper or its data,
   * or if it is removed from the default renderer (if there is none, from all renderers of the
   * window). Until the volume is shown again, every attempt to touch or arm ends in the same way.
   * Default: nullptr.
   */
  bool TouchVolume(vtkVolume* volume);
  vtkVolume* GetTouchedVolume();
  ///@}

  ///@{
  /**
   * Feel a further volume, such as an MRI beside a CT, with a filter of its own for materials and
   * method. The hand feels one volume at a time, which FeltVolume chooses: along the line of sight
   * through the pointer when the touch mode begins, and ahead of the tip later. The felt volume
   * changes only in the air, more than a voxel away from a surface, so that the force does not
   * jump. GetTouchedVolume() then returns the felt volume, and the device's filter is its filter.
   * The first volume is the one of TouchVolume(), or of the first call of this function;
   * TouchVolume() removes all others. Returns false and reports an error if there is no device,
   * volume or filter, if the volume has no mapper with an input, or if the filter already feels
   * another volume.
   */
  bool AddTouchedVolume(vtkVolume* volume, vtkVolumeHapticsFilter* filter);
  int GetNumberOfTouchedVolumes();
  ///@}

  enum FeltVolumeType
  {
    NEAREST = 0,
    STRONGEST = 1
  };

  ///@{
  /**
   * How the felt volume is chosen among several ones. NEAREST (default): the volume whose surface
   * comes first along the line of sight. STRONGEST: the volume whose surface along this line pushes
   * back with the largest force when pressed in by four of the smallest voxels; if forces are
   * equal, the nearest volume.
   */
  vtkSetClampMacro(FeltVolume, int, NEAREST, STRONGEST);
  vtkGetMacro(FeltVolume, int);
  void SetFeltVolumeToNearest() { this->SetFeltVolume(NEAREST); }
  void SetFeltVolumeToStrongest() { this->SetFeltVolume(STRONGEST); }
  ///@}

  /**
   * Warn if a visible volume in the renderer shows the image of the device's filter differently
   * from how it is felt: with a position, orientation, scale or user matrix, cropping, clipping
   * planes, a mask, a 2-D transfer function, or blanked points or cells. UpdateHaptics() does this,
   * too. Each reason is reported once per volume, and again only if it has disappeared in between.
   */
  void CheckShownVolumes();

  /**
   * Get the states that the last update read from the device: see vtkHapticState::Drain. Each style
   * gets all states, even if several styles use the same device.
   */
  vtkTable* GetStates();

  /**
   * Called by interactors. A style that loses its interactor, to another style or because the
   * window closes, leaves the touch mode and disarms. Always marks the style as modified.
   */
  void SetInteractor(vtkRenderWindowInteractor* interactor) override;
  void OnTimer() override;
  void OnMouseMove() override;
  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnRightButtonDown() override;
  void OnRightButtonUp() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;
  void OnLeftButtonDoubleClick() override;
  void OnKeyPress() override;
  void OnKeyRelease() override;
  void OnChar() override;

protected:
  vtkInteractorStyleHaptic();
  ~vtkInteractorStyleHaptic() override;

  /**
   * Draw the scene now: quickly while anything moves, otherwise finely. Sets the window's desired
   * update rate and calls the interactor's Render(). Override this in applications that render in
   * another way.
   */
  virtual void DrawScene(bool quickly);

  /**
   * Get whether the force may come back when the clutch is released: the device was armed before,
   * and nothing has disarmed it since. Override it in applications that track arming themselves.
   */
  virtual bool ArmsAfterClutch();

  ///@{
  /**
   * Functions for subclasses that work beside another style, as in vtkHapticWidget.
   * GetInteraction() returns the parts of this style. IsOwnTimer() returns whether the last timer
   * event came from its timer. UseMouseMove() returns whether the hand has used a mouse motion.
   * GetKeyName() returns the name of the last event's key: if a toolkit such as wx sends only a
   * key's code, X11's name for the key. IsPressOf() returns whether the last event, a press, is
   * that of an action's key.
   */
  VolumeHaptics::HapticInteraction& GetInteraction();
  bool IsOwnTimer() const;
  bool UseMouseMove();
  std::string GetKeyName();
  bool IsPressOf(const char* action);
  ///@}

  double DepthStep = 0.0;
  double DisplayRate = 60.0;
  bool TipFollowsSurface = true;
  bool AutoAdjustVolumeQuality = true;
  int FeltVolume = NEAREST;
  int HoldClicks = 0;
  bool AutoAdjustOffScreen = false;
  bool WorkspaceFollowsCamera = true;
  double WorkspaceScale = 0.0;

private:
  vtkInteractorStyleHaptic(const vtkInteractorStyleHaptic&) = delete;
  void operator=(const vtkInteractorStyleHaptic&) = delete;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
