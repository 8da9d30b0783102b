// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticSliceView
 * @brief   three slices of the touched image through the tip, beside the scene
 *
 * A column at the right edge of a window, of slices along the three axes of the image, each with a
 * crosshair at the tip. The first slice shows the value there, the name of its label in the
 * filter's label table, and the tissue as the head-up display names it. The other renderers of the
 * window get the rest of its width.
 *
 *   slices->SetDevice(device);
 *   slices->SetRenderWindow(window);
 *   style->SetSliceView(slices);
 *
 * The slices follow the tip before each frame of the window, within the image and in steps of half
 * a voxel; they need no update by the program. With the last line, vtkInteractorStyleHaptic moves
 * to the place of a click, and a key shows and hides the slices.
 *
 * Slices lie along the image's own axes, so that nothing is interpolated between them, even if the
 * image is oblique. They show the felt frame of a moving volume, and the coarse level of a volume
 * larger than memory. Where a vtkHapticBurr of the filter has removed tissue, they show what is
 * left; a coarse level shows the mean in each voxel. Of several components they show the felt one,
 * or the magnitude if the modes of PRIMITIVES feel all of them.
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
  /** The device whose tip is followed, as of its last UpdateState(), and whose image is shown. */
  void SetDevice(vtkHapticDevice* device);
  vtkHapticDevice* GetDevice();
  ///@}

  ///@{
  /** Another image than that of the device's filter, such as a larger one. Default: none. */
  void SetImage(vtkImageData* image);
  vtkImageData* GetImage();
  ///@}

  ///@{
  /** The window that has the slices; null takes them out of it. It is not kept alive. */
  void SetRenderWindow(vtkRenderWindow* window);
  vtkRenderWindow* GetRenderWindow();
  ///@}

  ///@{
  /** What names the tissue of a value: see vtkHapticHeadUpDisplay::AddTissue. Default: nothing. */
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
  /** The column's share of the window's width, 0.1 to 0.9. Default 0.3. */
  vtkSetClampMacro(Share, double, 0.1, 0.9);
  vtkGetMacro(Share, double);
  ///@}

  ///@{
  /**
   * Whether this places the renderers in the window. Default on. If not, the application sets the
   * viewports of all renderers.
   */
  vtkSetMacro(AutoLayout, bool);
  vtkGetMacro(AutoLayout, bool);
  vtkBooleanMacro(AutoLayout, bool);
  ///@}

  ///@{
  /**
   * Whether the world's axes point to a patient's left, back and head, as in DICOM. The slices are
   * then axial, coronal and sagittal, as radiologists look at them: the patient's right is at the
   * left. Default off: along the index axes k, j and i.
   */
  vtkSetMacro(Anatomical, bool);
  vtkGetMacro(Anatomical, bool);
  vtkBooleanMacro(Anatomical, bool);
  ///@}

  ///@{
  /**
   * The range of values from black to white, 0 or more. Default 0: nearly all values of the image,
   * whatever the level.
   */
  vtkSetClampMacro(ColorWindow, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ColorWindow, double);
  ///@}

  ///@{
  /** The value in the middle of the range. Default 0. */
  vtkSetMacro(ColorLevel, double);
  vtkGetMacro(ColorLevel, double);
  ///@}

  /** Window and level as they are shown, also if they were chosen by the values. */
  void GetShownWindowLevel(double windowLevel[2]) VTK_SIZEHINT(2);

  ///@{
  /** The unit that is written behind a value, such as "HU". Default empty. */
  vtkSetStdStringFromCharMacro(Unit);
  vtkGetCharFromStdStringMacro(Unit);
  ///@}

  /**
   * The renderer of a slice: 0 (axial, or along k), 1 (coronal, j) or 2 (sagittal, i); else null.
   * It shows the image along its own axes, in world units, with its index (0, 0, 0) in the origin.
   */
  vtkRenderer* GetRenderer(int slice);

  ///@{
  /**
   * The position of the crosshair (world), which is in the image; the origin without one. If it is
   * set, the slices stay there until the tip moves by half a voxel.
   */
  void SetPosition(const double position[3]) VTK_SIZEHINT(3);
  void GetPosition(double position[3]) VTK_SIZEHINT(3);
  ///@}

  /** The slice at a position of the window (pixels from its lower left corner); -1 if none. */
  int FindSlice(int x, int y);

  /**
   * What a slice shows at a position of the window (pixels), as a position in the world, or the
   * nearest one in the image. False if there is no image.
   */
  bool FindPosition(int slice, int x, int y, double position[3]) VTK_SIZEHINT(3);

  /**
   * Moves a position (world) across a slice by a number of voxels, towards the head, the back or
   * the left of a patient, but not out of the image. False if there is no image.
   */
  bool MoveAcross(int slice, double voxels, double position[3]) VTK_SIZEHINT(3);

  /** The text of a slice, lines in the order in which they are shown. */
  std::string GetText(int slice);

  /**
   * Follows the tip. It is called before each frame of the window; true if there is something else
   * to see than before.
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
