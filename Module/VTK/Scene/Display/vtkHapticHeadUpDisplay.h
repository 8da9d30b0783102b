// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticHeadUpDisplay
 * @brief   shows forces and contact over the scene, as text and as a plot
 *
 * Shows the forces of the last seconds as a plot, and what is touched as a text, over the scene:
 *
 *   display->SetDevice(device);
 *   display->AddTissue("bone", 300.0, 3000.0);
 *   renderer->AddViewProp(display);
 *
 * **The plot** has curves for the normal, friction and drag force and, in grey, for the whole force
 * that was sent to the hand. Its title is the method. With the method PRIMITIVES, the forces of the
 * modes replace the parts of the force. A list below the text names the modes in the colours of
 * their curves; a mode that is off is grey. vtkInteractorStyleHaptic adds the states of the plot by
 * AddStates.
 *
 * **The text** shows, from top to bottom: what is recorded; which settings are compared; the status
 * of a device other than the virtual one, or a fault; what is touched and how, such as "Resting on
 * skin, 0.62 N of at most 10 N"; whether the volume is cut; the time of a volume that moves and of
 * its nearest time step; measurements; and a notice. The status of a virtual device is left out.
 * vtkInteractorStyleHaptic also sets a hint, which tells the user what to do next, and a list of
 * its keys.
 *
 * Needs VTK::RenderingContextOpenGL2 and VTK::RenderingFreeType in the application.
 *
 * @sa vtkInteractorStyleHaptic, vtkHapticDevice
 */
#ifndef vtkHapticHeadUpDisplay_h
#define vtkHapticHeadUpDisplay_h

#include "vtkProp.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkHapticDevice;
class vtkHapticMeasurements;
class vtkTable;

#ifndef __VTK_WRAP__
namespace VolumeHaptics
{
struct DisplayProbe;
}
#endif

class VTKVOLUMEHAPTICS_EXPORT vtkHapticHeadUpDisplay : public vtkProp
{
public:
  static vtkHapticHeadUpDisplay* New();
  vtkTypeMacro(vtkHapticHeadUpDisplay, vtkProp);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The device whose status is shown, as it was at its last UpdateState(). */
  void SetDevice(vtkHapticDevice* device);
  vtkHapticDevice* GetDevice();
  ///@}

  ///@{
  /** The device of the second hand. A separate line shows its status and force. */
  void SetSecondDevice(vtkHapticDevice* device);
  vtkHapticDevice* GetSecondDevice();
  ///@}

  ///@{
  /**
   * Append states to the plot, or remove all of them. `states` is the table of
   * vtkHapticState::Drain. If a column is missing, an error names it. If time runs backwards, the
   * plot starts again.
   */
  void AddStates(vtkTable* states);
  void Clear();
  ///@}

  ///@{
  /** The time span of the plot (s), 0.5 to 60. Default 5. */
  vtkSetClampMacro(TimeSpan, double, 0.5, 60.0);
  vtkGetMacro(TimeSpan, double);
  ///@}

  ///@{
  /** Whether the plot is shown. Default on. */
  vtkSetMacro(PlotVisibility, vtkTypeBool);
  vtkGetMacro(PlotVisibility, vtkTypeBool);
  vtkBooleanMacro(PlotVisibility, vtkTypeBool);
  ///@}

  enum PlotCornerType
  {
    AUTOMATIC_CORNER = 0,
    LOWER_LEFT_CORNER = 1,
    LOWER_RIGHT_CORNER = 2
  };

  ///@{
  /**
   * The position of the plot. Automatic (default): at the lower left, or if the program has 2D
   * actors there, beside or above them. LowerLeft and LowerRight: in that corner, even over other
   * actors; LowerRight is above the scale of forces.
   */
  vtkSetClampMacro(PlotCorner, int, AUTOMATIC_CORNER, LOWER_RIGHT_CORNER);
  vtkGetMacro(PlotCorner, int);
  void SetPlotCornerToAutomatic() { this->SetPlotCorner(AUTOMATIC_CORNER); }
  void SetPlotCornerToLowerLeft() { this->SetPlotCorner(LOWER_LEFT_CORNER); }
  void SetPlotCornerToLowerRight() { this->SetPlotCorner(LOWER_RIGHT_CORNER); }
  ///@}

  ///@{
  /** Whether the text is shown. Default on. */
  vtkSetMacro(TextVisibility, vtkTypeBool);
  vtkGetMacro(TextVisibility, vtkTypeBool);
  vtkBooleanMacro(TextVisibility, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Whether the text has a line with the value at the surface, the rate of the servo, and the
   * number of ticks that the servo has missed. Default off.
   */
  vtkSetMacro(DetailsVisibility, vtkTypeBool);
  vtkGetMacro(DetailsVisibility, vtkTypeBool);
  vtkBooleanMacro(DetailsVisibility, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Measurements whose names and values are listed below the text: the last eight, and the
   * measurement in progress. Default nullptr.
   */
  void SetMeasurements(vtkHapticMeasurements* measurements);
  vtkHapticMeasurements* GetMeasurements();
  ///@}

  ///@{
  /** Whether the measurements are listed. Default on. */
  vtkSetMacro(MeasurementsVisibility, vtkTypeBool);
  vtkGetMacro(MeasurementsVisibility, vtkTypeBool);
  vtkBooleanMacro(MeasurementsVisibility, vtkTypeBool);
  ///@}

  ///@{
  /**
   * One or two lines over the scene that tell the user what to do next. vtkInteractorStyleHaptic
   * sets the hint whenever the next step changes. Default empty.
   */
  vtkSetStdStringFromCharMacro(Hint);
  vtkGetCharFromStdStringMacro(Hint);
  ///@}

  ///@{
  /** Whether the hint is shown. Default on. */
  vtkSetMacro(HintVisibility, vtkTypeBool);
  vtkGetMacro(HintVisibility, vtkTypeBool);
  vtkBooleanMacro(HintVisibility, vtkTypeBool);
  ///@}

  ///@{
  /**
   * A list of keys for the middle of the viewport: lines that consist of a key, a tab and the key's
   * meaning, in groups. Each group follows a line with its title. vtkInteractorStyleHaptic sets the
   * list for its key "?". Default empty.
   */
  vtkSetStdStringFromCharMacro(HelpText);
  vtkGetCharFromStdStringMacro(HelpText);
  ///@}

  ///@{
  /** Whether HelpText is shown. Default off. */
  vtkSetMacro(HelpVisibility, vtkTypeBool);
  vtkGetMacro(HelpVisibility, vtkTypeBool);
  vtkBooleanMacro(HelpVisibility, vtkTypeBool);
  ///@}

  /**
   * Scroll the shown HelpText up by some lines, or down (negative), if the viewport is too small
   * for all of it. Returns false if no help is shown, or if all of it is.
   */
  bool ScrollHelp(int lines);

  ///@{
  /**
   * Name ranges of values, and get the name of a value. A range begins at `from` and ends before
   * `to`; both are on the scale of vtkHapticProperty's functions (see ScalarShift). The text shows
   * the name of the first range that contains the value two voxels below the touched surface,
   * unless the filter's label table has a name for the touched label. Without ranges, it shows the
   * name of the nearest tissue of the filter's vtkHapticProperty, as in vtkHapticFunctionEditor.
   * GetTouchedTissue() returns the name in the text; empty without one.
   */
  void AddTissue(const char* name, double from, double to);
  void RemoveAllTissues();
  std::string GetTissueName(double value);
  std::string GetTouchedTissue();
  ///@}

  ///@{
  /**
   * What is being recorded, such as "movie-001.ogv, 0:12". The text then begins with "Recording
   * movie-001.ogv, 0:12". Default empty: nothing is recorded.
   */
  vtkSetStdStringFromCharMacro(RecordingText);
  vtkGetCharFromStdStringMacro(RecordingText);
  ///@}

  ///@{
  /**
   * The name of the settings that are felt while several are compared. The text then has a line
   * such as "Settings A". vtkInteractorStyleHaptic::SwapSettings() sets the name. Default empty: no
   * line.
   */
  vtkSetStdStringFromCharMacro(SettingsText);
  vtkGetCharFromStdStringMacro(SettingsText);
  ///@}

  ///@{
  /** A notice for the user, shown below the text until it is set to empty. Default empty. */
  vtkSetStdStringFromCharMacro(Notice);
  vtkGetCharFromStdStringMacro(Notice);
  ///@}

  /** Get the text as it would be shown now. */
  std::string GetText();

  /**
   * Get the index of the mode whose line in the list is at a position (pixels, from the lower left
   * corner of the viewport); -1 if there is none.
   */
  int FindMode(int x, int y);

  /**
   * Get whether the text, hint or plot of the last frame overlaps a box of the viewport (pixels
   * from its lower left corner: left, right, bottom, top). Always returns true while the list of
   * keys is shown.
   */
  bool Covers(const double box[4]) VTK_SIZEHINT(box, 4);

  ///@{
  /** Draw the display, and release its graphics resources; called by the renderer. */
  int RenderOverlay(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  ///@}

protected:
  vtkHapticHeadUpDisplay();
  ~vtkHapticHeadUpDisplay() override;

  double TimeSpan = 5.0;
  int PlotCorner = AUTOMATIC_CORNER;
  vtkTypeBool PlotVisibility = 1;
  vtkTypeBool TextVisibility = 1;
  vtkTypeBool DetailsVisibility = 0;
  vtkTypeBool HintVisibility = 1;
  vtkTypeBool MeasurementsVisibility = 1;
  vtkTypeBool HelpVisibility = 0;
  std::string Notice;
  std::string RecordingText;
  std::string SettingsText;
  std::string Hint;
  std::string HelpText;

private:
#ifndef __VTK_WRAP__
  friend struct VolumeHaptics::DisplayProbe;
#endif
  vtkHapticHeadUpDisplay(const vtkHapticHeadUpDisplay&) = delete;
  void operator=(const vtkHapticHeadUpDisplay&) = delete;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
