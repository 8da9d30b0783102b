// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticSliceView
 * @brief   shows three slices of the touched image through the tip, beside the scene
 *
 * Shows slices along the three axes of the image in a column at the right edge of a window, each
 * with a crosshair at the tip. The first slice shows the value at the tip, the name of the label
 * there in the filter's label table, and the tissue as the head-up display names it. The other
 * renderers of the window get the rest of its width.
 *
 *   slices->SetDevice(device);
 *   slices->SetRenderWindow(window);
 *   style->SetSliceView(slices);
 *
 * The slices follow the tip before each frame of the window, without a call by the program. They
 * stay within the image, and move once the tip has moved by half a voxel. With the last line above,
 * a click moves the tip to its position, and a key of vtkInteractorStyleHaptic shows and hides the
 * slices.
 *
 * Slices are along the image's own axes, so that nothing is interpolated between them, even if the
 * image is oblique. They show the felt time step of a moving volume, and the coarse level of a
 * volume larger than memory. Where a vtkHapticBurr of the filter has removed tissue, they show what
 * is left; a coarse level shows the mean in each voxel. If the image has several components, they
 * show the felt one, or the magnitude if modes of PRIMITIVES feel all components.
 *
 * Needs VTK::RenderingOpenGL2 and VTK::RenderingFreeType in the application.
 *
 * @sa vtkInteractorStyleHaptic, vtkHapticHeadUpDisplay
 */
#ifndef vtkHapticSliceView_h
#define vtkHapticSliceView_h

#include "vtkObject.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkHapticDevice;
class vtkHapticHeadUpDisplay;
class vtkImageData;
class vtkRenderer;
class vtkRenderWindow;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticSliceView : public vtkObject
{
public:
  static vtkHapticSliceView* New();
  vtkTypeMacro(vtkHapticSliceView, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The device whose image the slices show, and whose tip they follow. The tip is that of the
   * device's last UpdateState().
   */
  void SetDevice(vtkHapticDevice* device);
  vtkHapticDevice* GetDevice();
  ///@}

  ///@{
  /**
   * An image to show instead of the image of the device's filter, for example a larger image.
   * Default: none.
   */
  void SetImage(vtkImageData* image);
  vtkImageData* GetImage();
  ///@}

  ///@{
  /** The window that shows the slices, kept without a reference; nullptr removes the slices. */
  void SetRenderWindow(vtkRenderWindow* window);
  vtkRenderWindow* GetRenderWindow();
  ///@}

  ///@{
  /**
   * A head-up display that names the tissue of a range of values: see
   * vtkHapticHeadUpDisplay::AddTissue. Default: none, so that tissue has no name.
   */
  void SetHeadUpDisplay(vtkHapticHeadUpDisplay* display);
  vtkHapticHeadUpDisplay* GetHeadUpDisplay();
  ///@}

  ///@{
  /** Whether the slices are shown. Default on. Takes effect with the next frame. */
  vtkSetMacro(Visibility, bool);
  vtkGetMacro(Visibility, bool);
  vtkBooleanMacro(Visibility, bool);
  ///@}

  ///@{
  /** The fraction of the window's width that the column takes, 0.1 to 0.9. Default 0.3. */
  vtkSetClampMacro(Share, double, 0.1, 0.9);
  vtkGetMacro(Share, double);
  ///@}

  ///@{
  /**
   * Whether this class sets the viewports of all renderers in the window. Default on. If off, the
   * application sets them.
   */
  vtkSetMacro(AutoLayout, bool);
  vtkGetMacro(AutoLayout, bool);
  vtkBooleanMacro(AutoLayout, bool);
  ///@}

  ///@{
  /**
   * Whether the world's axes point to a patient's left, back and head, as in DICOM. The slices are
   * then axial, coronal and sagittal, as radiologists look at them: with the patient's right at the
   * left. Default off: the slices are along the index axes k, j and i.
   */
  vtkSetMacro(Anatomical, bool);
  vtkGetMacro(Anatomical, bool);
  vtkBooleanMacro(Anatomical, bool);
  ///@}

  ///@{
  /**
   * The range of values from black to white, 0 or more. Default 0: the range contains nearly all
   * values of the image, and ColorLevel is not used.
   */
  vtkSetClampMacro(ColorWindow, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ColorWindow, double);
  ///@}

  ///@{
  /** The value in the middle of the range from black to white. Default 0. */
  vtkSetMacro(ColorLevel, double);
  vtkGetMacro(ColorLevel, double);
  ///@}

  /**
   * Get the shown range of values from black to white, and its middle, even if they were computed
   * from the image.
   */
  void GetShownWindowLevel(double windowLevel[2]) VTK_SIZEHINT(2);

  ///@{
  /** The unit that is shown after a value, such as "HU". Default empty. */
  vtkSetStdStringFromCharMacro(Unit);
  vtkGetCharFromStdStringMacro(Unit);
  ///@}

  /**
   * Get the renderer of a slice: 0 (axial, or along k), 1 (coronal, or along j) or 2 (sagittal, or
   * along i); nullptr for any other number. It shows the image along the image's axes, in world
   * units, with the index (0, 0, 0) at the origin.
   */
  vtkRenderer* GetRenderer(int slice);

  ///@{
  /**
   * The position of the crosshair (world), within the image; the origin without an image. A
   * position that was set stays until the tip moves by half a voxel.
   */
  void SetPosition(const double position[3]) VTK_SIZEHINT(3);
  void GetPosition(double position[3]) VTK_SIZEHINT(3);
  ///@}

  /**
   * Get the number of the slice at a position in the window (pixels from its lower left corner); -1
   * if there is none.
   */
  int FindSlice(int x, int y);

  /**
   * Convert a position in the window (pixels) to the world position that the slice shows there, or
   * to the nearest position in the image. Returns false without an image.
   */
  bool FindPosition(int slice, int x, int y, double position[3]) VTK_SIZEHINT(3);

  /**
   * Move a position (world) perpendicular to a slice by a number of voxels, towards a patient's
   * head, back or left, and keep it within the image. Returns false without an image.
   */
  bool MoveAcross(int slice, double voxels, double position[3]) VTK_SIZEHINT(3);

  /** Get the text of a slice, with its lines in the order in which they are shown. */
  std::string GetText(int slice);

  /**
   * Move the slices to the tip. The window calls this before each frame. Returns whether any slice
   * has changed.
   */
  bool Update();

protected:
  vtkHapticSliceView();
  ~vtkHapticSliceView() override;

  bool Visibility = true;
  double Share = 0.3;
  bool AutoLayout = true;
  bool Anatomical = false;
  double ColorWindow = 0.0;
  double ColorLevel = 0.0;
  std::string Unit;

private:
  vtkHapticSliceView(const vtkHapticSliceView&) = delete;
  void operator=(const vtkHapticSliceView&) = delete;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
