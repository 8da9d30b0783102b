// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticProperty
 * @brief   the materials that define how a volume feels
 *
 * Describes how a volume feels, as vtkVolumeProperty describes how it looks: transfer functions
 * turn the scalar value into a material, and the gradient magnitude into how distinct a surface is
 * (table 1 of Lundin, Ynnerman and Gudmundsson, "Proxy-based Haptic Feedback from Volumetric
 * Density Data", 2002):
 *
 *   Stiffness        k (N/m, >= 0, default 500), of the value inside the surface, V(x_s)
 *   Friction         mu (>= 0, default 0), of the value inside the surface, V(x_s)
 *   SurfaceStrength  T_N (N, >= 0, default 2), of the value inside the surface, V(x_s)
 *   Viscosity        R (N, >= 0, default 0), of the value outside the surface, V(x_v)
 *   Distinctness     W_d (0 to 1, default from the noise), of the gradient magnitude at the proxy
 *
 * The gradient magnitude is in scalar units per world unit (HU/mm for CT), never per voxel; see
 * DistinctnessPerMillimeter. A surface holds the proxy up to T_N W_d newtons; beyond that it is
 * penetrated. A huge T_N makes a surface impenetrable, 0 makes it penetrable without resistance.
 * The viscosity is a Coulomb drag ("3-D friction"): R newtons against any motion. Below 0.001 N/m
 * of stiffness nothing is felt.
 *
 * Presets fill all of these functions. Your own presets are files:
 *
 *   property->ApplyPreset("CT contrast");
 *   property->SetTissueSurfaceStrength(2, 1.4); // of fat; or edit the functions
 *   property->WritePreset("soft.json");         // and later
 *   property->ApplyPreset("soft.json");
 *
 * A function without points stands for its default. vtkPiecewiseFunction's midpoints, sharpness and
 * clamping are honoured. For the servo the functions are baked into tables: linear pieces and steps
 * are reproduced exactly, curved pieces to within 0.01 % of the piece's height and 0.1 % of the
 * value.
 *
 * @sa vtkVolumeHapticsFilter, vtkVolumeProperty
 */
#ifndef vtkHapticProperty_h
#define vtkHapticProperty_h

#include "vtkObject.h"
#include "vtkSmartPointer.h"        // for ivars
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::unique_ptr

class vtkImageData;
class vtkPiecewiseFunction;
class vtkStringArray;
class vtkTable;
class vtkVolumeProperty;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticProperty : public vtkObject
{
public:
  static vtkHapticProperty* New();
  vtkTypeMacro(vtkHapticProperty, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Stiffness k of the spring between proxy and tip, against the data value just inside the
   * surface (N/m). Created without points, clamped at the ends, on first Get; without points it
   * stands for 500 N/m.
   */
  void SetStiffness(vtkPiecewiseFunction* function);
  vtkPiecewiseFunction* GetStiffness();
  ///@}

  ///@{
  /**
   * Coefficient of friction mu (eqs. 8 to 10), against the data value just inside the surface.
   * Without points: 0.
   */
  void SetFriction(vtkPiecewiseFunction* function);
  vtkPiecewiseFunction* GetFriction();
  ///@}

  ///@{
  /**
   * Drag R of the medium against any motion (eq. 14), against the data value just outside the
   * surface (N). Without points: 0 N.
   */
  void SetViscosity(vtkPiecewiseFunction* function);
  vtkPiecewiseFunction* GetViscosity();
  ///@}

  ///@{
  /**
   * Surface strength T_N: the normal force at which a surface is penetrated (eq. 12), against the
   * data value just inside the surface (N). Without points: 2 N.
   */
  void SetSurfaceStrength(vtkPiecewiseFunction* function);
  vtkPiecewiseFunction* GetSurfaceStrength();
  ///@}

  ///@{
  /**
   * Distinctness W_d (0 to 1), which scales the surface strength (eq. 13), against the gradient
   * magnitude in scalar units per world unit. Without points: see DistinctnessFromNoise; per
   * millimetre: see DistinctnessPerMillimeter.
   */
  void SetDistinctness(vtkPiecewiseFunction* function);
  vtkPiecewiseFunction* GetDistinctness();
  ///@}

  ///@{
  /**
   * Whether distinctness (W_d, eq. 13) keeps the noise of the image from being felt as surfaces. On
   * (default): it is 0 up to 3.4 times the noise of the gradient, and 1 from twice that on; the
   * noise is estimated from the flattest blocks of the image. This applies only if the function
   * Distinctness has no points; if off, a Distinctness without points stands for 1.
   *
   * The noise is estimated again after the image or its array is Modified(): call Modified() if you
   * change values in place. Distinctness is 1 if the image has no noise. NoiseRamp has the two
   * gradient magnitudes (scalar units per world unit) of the last ramp, set when a filter with this
   * property last ran or was published; 0, 0 if there was none. They apply along the axis of the
   * smallest spacing; along another axis, noise and ramp are smaller by the ratio of the spacings.
   */
  vtkSetMacro(DistinctnessFromNoise, bool);
  vtkGetMacro(DistinctnessFromNoise, bool);
  vtkBooleanMacro(DistinctnessFromNoise, bool);
  vtkGetVector2Macro(NoiseRamp, double);
  ///@}

#ifndef __VTK_WRAP__
  /** Sets NoiseRamp without changing MTime; for the baker. */
  void NoteNoiseRamp(double start, double full);
#endif

  ///@{
  /**
   * Whether the gradient magnitudes of Distinctness are in scalar units per millimetre of the hand.
   * On, as presets with a Distinctness of their own set it: vtkVolumeHapticsFilter's
   * MetersPerWorldUnit makes them magnitudes per world unit, so that a volume feels the same
   * whether its world is in um, mm or m. Off (default): they are per world unit. With the default
   * MetersPerWorldUnit of 0.001 both are the same. A vtkHapticDevice with a DeviceToWorld of
   * another scale enlarges the volume, and leaves its surfaces unchanged.
   */
  vtkSetMacro(DistinctnessPerMillimeter, bool);
  vtkGetMacro(DistinctnessPerMillimeter, bool);
  vtkBooleanMacro(DistinctnessPerMillimeter, bool);
  ///@}

  ///@{
  /**
   * Whether the scalars are labels, a segmentation that is touched itself. Off (default): they are
   * values, and what lies between two of them is a value, too. On, as ApplyPreset("Labels") sets
   * it: each label has the materials that the functions have at its number, and surfaces are the
   * walls between labels, as with a label image on input port 3 of vtkVolumeHapticsFilter and
   * SetGeometryFromLabels(). Whole numbers that span less than 65536 are labels, of the method
   * PROXY. They stay values if a label image is connected, if the geometry comes from labels
   * already, in a region of a larger volume, and in one that moves.
   */
  vtkSetMacro(ScalarsAreLabels, bool);
  vtkGetMacro(ScalarsAreLabels, bool);
  vtkBooleanMacro(ScalarsAreLabels, bool);
  ///@}

  ///@{
  /**
   * Whether to derive what is solid from the image: the background, darker than Otsu's threshold
   * between the darkest two materials that are apart, then has no surface strength, however steep
   * its noise and its streaks are. On, as ApplyPreset("Micro-CT") sets it: from a little above the
   * threshold on, SurfaceStrength holds. Off (default), with a SurfaceSide other than HIGHER, or if
   * the histogram has a single peak, SurfaceStrength holds everywhere. A material that rises by
   * less than a tenth of the brightest one is background. Padding that is darker than air makes air
   * solid: set it to the value of air first. The threshold is computed whenever the noise of
   * DistinctnessFromNoise is computed; a region of a larger volume has the threshold of the whole
   * volume.
   */
  vtkSetMacro(SolidFromImage, bool);
  vtkGetMacro(SolidFromImage, bool);
  vtkBooleanMacro(SolidFromImage, bool);
  ///@}

  /**
   * The number that is added to each scalar before the functions and tissues read it: -1024 for
   * Hounsfield units that are stored 1024 higher. Default 0. The value is (scalar + ScalarShift)
   * ScalarScale, as vtkImageShiftScale has it; the functions of a needle and of a burr use this
   * value, too. Scalar values of filters, tools and modes, such as an IsoValue, and the opacities
   * of VisibilityFrom stay in scalar units.
   */
  vtkSetClampMacro(ScalarShift, double, -1e30, 1e30);
  vtkGetMacro(ScalarShift, double);

  /**
   * The factor by which the shifted scalar is multiplied, 1e-12 to 1e12, for data in another unit
   * than the functions. Default 1. The gradient magnitudes of Distinctness are scaled, too.
   */
  vtkSetClampMacro(ScalarScale, double, 1e-12, 1e12);
  vtkGetMacro(ScalarScale, double);

  ///@{
  /**
   * Whether to detect how a CT stores Hounsfield units: unchanged, or higher by 1000, 1024 or
   * 32768, so that no value is negative. Default off; ApplyPreset() turns it on for CT. If hardly
   * any value is negative, the peaks of air and soft tissue are searched for at each of these
   * shifts. FoundShift is the number that is then added to the scalars, 0 if none was found; it is
   * updated when a filter with this property runs or is published. A warning reports values that
   * can't be Hounsfield units. Nothing is detected if ScalarShift or ScalarScale is set.
   */
  vtkSetMacro(ShiftFromImage, bool);
  vtkGetMacro(ShiftFromImage, bool);
  vtkBooleanMacro(ShiftFromImage, bool);
  vtkGetMacro(FoundShift, double);
  ///@}

  ///@{
  /** Convert a scalar of the image to a value on the scale of the functions, and back. */
  double ScalarToValue(double scalar)
  {
    return (scalar + this->ScalarShift + this->FoundShift) * this->ScalarScale;
  }
  double ValueToScalar(double value)
  {
    return value / this->ScalarScale - this->ScalarShift - this->FoundShift;
  }
  ///@}

#ifndef __VTK_WRAP__
  /** Sets FoundShift without changing MTime; for the baker. */
  void NoteShift(double shift)
  {
    this->FoundShift = shift;
  }
#endif

  ///@{
  /**
   * The component of the array that is touched, 0 or more. Default 0.
   */
  vtkSetClampMacro(Component, int, 0, VTK_INT_MAX);
  vtkGetMacro(Component, int);
  ///@}

  enum SurfaceSideType
  {
    HIGHER = 0,
    LOWER = 1,
    BOTH = 2
  };

  ///@{
  /**
   * Which way a structure lies from its surface: towards higher values (default; bone in CT),
   * towards lower values (lung seen from tissue), or both, whichever way one pushes (MRI).
   * Surfaces resist the way in, never the way out.
   */
  vtkSetClampMacro(SurfaceSide, int, HIGHER, BOTH);
  vtkGetMacro(SurfaceSide, int);
  void SetSurfaceSideToHigher()
  {
    this->SetSurfaceSide(HIGHER);
  }
  void SetSurfaceSideToLower()
  {
    this->SetSurfaceSide(LOWER);
  }
  void SetSurfaceSideToBoth()
  {
    this->SetSurfaceSide(BOTH);
  }
  ///@}

  ///@{
  /**
   * Fill all five functions, in place, and set the surface side from a named preset:
   *
   * - "CT contrast": Hounsfield units; tissues told apart clearly by hand. Bone is solid.
   * - "CT physical": Hounsfield units; stiffness from published soft-tissue moduli by way of a flat
   *   punch of 2 mm radius, k = 2 E a / (1 - nu^2) (liver: 28 N/m; skin over fat: 53). Subtle on
   *   most devices.
   * - "CT angiography": Hounsfield units, with contrast medium in vessels and heart.
   * - "CT chest": Hounsfield units; lung has one drag, from emphysema on.
   * - "MRI": T1-weighted magnitude images with 0 ... 255 grey levels; surfaces on both sides. Pass
   *   the image, so that it is fitted to other grey levels.
   * - "Micro-CT": one solid material, of any unit: micro-CT and industrial CT. Distinctness is from
   *   the noise, and what is background from the values (SolidFromImage).
   * - "Labels": a segmentation as the touched image: all labels but 0 feel alike, from both sides.
   *
   * All but "CT physical" have one stiffness, 400 N/m, for whatever is felt, so that a hand feels
   * the shape that it sees: strength, friction and drag tell tissues apart. The values are this
   * project's, chosen by hand; they are not measurements: see Documentation/materials.md. The
   * preset's tissues become those of AddTissue(). A name that ends in ".json" is that of a file:
   * see ReadPreset(). For any other name, reports an error, returns false and changes nothing.
   *
   * With an image, a preset whose values have no unit ("MRI") is fitted to the Component of its
   * active point scalars, with ScalarShift and ScalarScale: the factor of the values is the median
   * of what is brighter than the background, as SolidFromImage finds it, divided by 90. It is
   * larger if the background would otherwise end at less than 5 times its own median, because its
   * noise would then be felt. The factor of the gradients is the first one; they are per voxel of
   * mean width, not per millimetre. If no background is found, the preset is the same as without an
   * image. If the image is needed, an image without such scalars is an error.
   */
  bool ApplyPreset(const char* name);
  bool ApplyPreset(const char* name, vtkImageData* image);
  ///@}

  /** Get the names of the built-in presets for ApplyPreset. */
  static vtkStringArray* GetPresetNames();

  ///@{
  /**
   * Write and read your own preset as a file (readable JSON), to keep and to share: the five
   * functions exactly, the tissues, the surface side, DistinctnessFromNoise,
   * DistinctnessPerMillimeter, ScalarsAreLabels, SolidFromImage and ShiftFromImage, but neither the
   * component, the visibility nor ScalarShift and ScalarScale, which belong to the data.
   * WritePreset replaces an existing file only after all of the new one is on the disk. ReadPreset
   * fills the functions in place, and sets everything that the file lacks to its default. On
   * failure, both return false, with an error that names the file and the cure, and change nothing.
   * Give the file a name that ends in ".json", so that ApplyPreset() accepts it.
   */
  bool WritePreset(const char* file);
  bool ReadPreset(const char* file);
  ///@}

  ///@{
  /**
   * Add and read tissues: named ranges of the functions' values, from low to high (both included).
   * The names are for people: vtkHapticFunctionEditor draws them as bands and edits their materials
   * by sliders, but forces do not depend on them. Tissues are numbered from 0, in ascending order
   * of their values. AddTissue returns the number of the new tissue. It reports an error and
   * returns -1 if the name is empty or occurs already, or if the values overlap another tissue.
   * Presets and proposals set their own tissues. Default: none.
   */
  int AddTissue(const char* name, double low, double high);
  void RemoveAllTissues();
  int GetNumberOfTissues();
  const char* GetTissueName(int tissue);
  void GetTissueRange(int tissue, double range[2]) VTK_SIZEHINT(range, 2);
  ///@}

  ///@{
  /**
   * Set and get the material of a tissue. Set makes the function constant from the tissue's lowest
   * value to its highest one; between this and the neighbouring tissues, which stay unchanged, the
   * function is linear. Get returns the function's value in the middle of the tissue. A tissue that
   * does not exist is an error; Get then returns 0.
   */
  void SetTissueStiffness(int tissue, double stiffness);
  double GetTissueStiffness(int tissue);
  void SetTissueFriction(int tissue, double friction);
  double GetTissueFriction(int tissue);
  void SetTissueViscosity(int tissue, double viscosity);
  double GetTissueViscosity(int tissue);
  void SetTissueSurfaceStrength(int tissue, double strength);
  double GetTissueSurfaceStrength(int tissue);
  ///@}

  /**
   * Fill all five functions, in place, and set the surface side from the edges of an image, for
   * data of any unit: see Documentation/materials.md. Examines about a million voxels of the active
   * point scalars' Component, which takes about a second whatever the image's size. If a hand must
   * not wait for this, vtkHapticFunctionEditor::BeginProposal does it in the background.
   *
   * The values on both sides of the edges become materials of one stiffness, told apart by strength
   * (3 N for the largest rise; 12 N for a rise that lies behind another material), friction and
   * drag. Distinctness keeps the weakest of these edges, but neither noise nor shading. Use the
   * result as a beginning, and edit it.
   *
   * The functions use the values that ScalarShift and ScalarScale define; a FoundShift becomes the
   * ScalarShift, and ShiftFromImage is turned off.
   *
   * Reports an error, returns false and changes nothing if there is no edge to propose from:
   * without scalars, with constant scalars, with less than 5 points along an axis, or with nothing
   * but noise.
   */
  bool ProposeFromImage(vtkImageData* image);

  /**
   * Get the KernelRadius (voxels) that suits the edges that ProposeFromImage found: at least two
   * standard deviations of the edges' blur, so that V(x_s) has reached the material inside; 2 to 5,
   * or 1 if the image is not large enough. 0 before the first proposal.
   */
  vtkGetMacro(ProposedKernelRadius, int);

  /**
   * Get the boundaries that ProposeFromImage found, the most important one first; nullptr before
   * the first proposal. Columns: Low and High, the functions' values on both sides; Width, the
   * standard deviation s of the blurred step (world units), V = Low + (High - Low) Phi(x / s);
   * Slope, the largest gradient magnitude that a kernel of ProposedKernelRadius finds, per world
   * unit; Share, the fraction of the area of all edges.
   */
  vtkTable* GetProposedBoundaries();

#ifndef __VTK_WRAP__
  /** Sets the results of GetProposedBoundaries and GetProposedKernelRadius. */
  void NoteProposal(vtkTable* boundaries, int kernelRadius);
#endif

  ///@{
  /**
   * Voxels that the opacity functions of this volume property hide are not felt: surface strength
   * and viscosity are zero if the scalar opacity or the gradient opacity is zero. nullptr
   * (default): everything is felt. The opacity of the touched component is used (of component 0 if
   * components are not independent). As in VTK's volume mappers, gradient opacity is a function of
   * the gradient magnitude per average voxel spacing.
   */
  void SetVisibilityFrom(vtkVolumeProperty* property);
  vtkVolumeProperty* GetVisibilityFrom();
  ///@}

  /**
   * Copy everything: functions point by point, and tissues. Only the volume property for the
   * visibility and the boundaries of the last proposal are shared by reference.
   */
  void DeepCopy(vtkHapticProperty* source);

  /**
   * Returns the latest modification time of this property, its functions, and the volume property
   * of the visibility.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkHapticProperty();
  ~vtkHapticProperty() override;

  vtkSmartPointer<vtkPiecewiseFunction> Stiffness;
  vtkSmartPointer<vtkPiecewiseFunction> Friction;
  vtkSmartPointer<vtkPiecewiseFunction> Viscosity;
  vtkSmartPointer<vtkPiecewiseFunction> SurfaceStrength;
  vtkSmartPointer<vtkPiecewiseFunction> Distinctness;
  vtkSmartPointer<vtkVolumeProperty> VisibilityFrom;
  int Component = 0;
  int SurfaceSide = HIGHER;
  bool DistinctnessFromNoise = true;
  bool DistinctnessPerMillimeter = false;
  bool ScalarsAreLabels = false;
  bool SolidFromImage = false;
  bool ShiftFromImage = false;
  double ScalarShift = 0.0;
  double ScalarScale = 1.0;
  double FoundShift = 0.0;
  double NoiseRamp[2] = { 0.0, 0.0 };
  vtkSmartPointer<vtkTable> ProposedBoundaries;
  int ProposedKernelRadius = 0;

private:
  vtkHapticProperty(const vtkHapticProperty&) = delete;
  void operator=(const vtkHapticProperty&) = delete;

  bool HasTissue(int tissue);

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
