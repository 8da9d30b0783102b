// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVVolumeHapticsFilter
 * @brief   vtkVolumeHapticsFilter with its material as plain settings
 *
 * ParaView sets properties one by one, in any order, and draws its functions from 0 to 1. Therefore
 * this filter stores the user's choices (a preset, or five functions with their scales), and fills
 * its vtkHapticProperty from them after each change. This happens in GetMTime(), which the pipeline
 * and vtkHapticDevice::Publish call first, and thus before the property is used.
 */
#ifndef vtkPVVolumeHapticsFilter_h
#define vtkPVVolumeHapticsFilter_h

#include "HapticModeRows.h"             // for ivars
#include "HapticToolChoice.h"           // for ivars
#include "VolumeHapticsFiltersModule.h" // for export macro
#include "vtkSmartPointer.h"            // for ivars
#include "vtkVolumeHapticsFilter.h"

#include <array>  // for ivars
#include <string> // for std::string
#include <tuple>  // for ivars
#include <vector> // for ivars

class vtkImageData;
class vtkPiecewiseFunction;

class VOLUMEHAPTICSFILTERS_EXPORT vtkPVVolumeHapticsFilter : public vtkVolumeHapticsFilter
{
public:
  static vtkPVVolumeHapticsFilter* New();
  vtkTypeMacro(vtkPVVolumeHapticsFilter, vtkVolumeHapticsFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The preset. "Custom" (default) uses the functions below. Any other preset is one of
   * vtkHapticProperty::GetPresetNames(); then the functions, DistinctnessFromNoise,
   * ScalarsAreLabels, SolidFromImage, ShiftFromImage and SurfaceSide are not used. For an unknown
   * name, the output is empty, and an error lists the known names. A preset for values without a
   * unit is fitted to the image on port 0, like vtkHapticProperty::ApplyPreset(name, image), and
   * again whenever the image has changed. For data other than images, the preset's own table is
   * used.
   */
  void SetPreset(const char* preset);

  /**
   * Get the two factors by which the preset's values and gradients were multiplied. (1, 0) means
   * that the preset's own table is used, with gradients per millimetre. A fitted preset has
   * gradients per world unit.
   */
  double* GetPresetScale() VTK_SIZEHINT(2);

  ///@{
  /**
   * The five functions of vtkHapticProperty, each divided by its scale below. For nullptr (default)
   * or a function without points, the property's default is used.
   */
  void SetStiffnessFunction(vtkPiecewiseFunction* function);
  void SetFrictionFunction(vtkPiecewiseFunction* function);
  void SetViscosityFunction(vtkPiecewiseFunction* function);
  void SetSurfaceStrengthFunction(vtkPiecewiseFunction* function);
  ///@}

  ///@{
  /**
   * The quantity for which a function's value 1 stands: stiffness (N/m, default 1000), friction (no
   * unit, 1), viscosity (N, 1) and surface strength (N, 4).
   */
  void SetStiffnessScale(double scale);
  void SetFrictionScale(double scale);
  void SetViscosityScale(double scale);
  void SetSurfaceStrengthScale(double scale);
  ///@}

  ///@{
  /**
   * Settings of distinctness. If DistinctnessFromNoise is on (default), distinctness is derived
   * from the image's noise, so that noise can't be felt, and the function of distinctness is not
   * used. PerMillimeter, as in vtkHapticProperty, applies to that function.
   */
  void SetDistinctnessFromNoise(bool fromNoise);
  void SetDistinctnessPerMillimeter(bool perMillimeter);
  void SetDistinctnessFunction(vtkPiecewiseFunction* function);
  ///@}

  ///@{
  /**
   * Set whether the scalars are labels, whether the image determines what is solid, or whether the
   * image determines how Hounsfield units are stored: see vtkHapticProperty.
   */
  void SetScalarsAreLabels(bool areLabels);
  void SetSolidFromImage(bool fromImage);
  void SetShiftFromImage(bool fromImage);
  ///@}

  ///@{
  /** Settings of vtkHapticProperty with the same names. */
  void SetSurfaceSide(int side);
  void SetComponent(int component);
  void SetScalarShift(double shift);
  void SetScalarScale(double scale);
  double* GetNoiseRamp() VTK_SIZEHINT(2);
  ///@}

  ///@{
  /**
   * The feel of the labels on port 3. It is defined by files for vtkHapticLabelTable::ReadFile,
   * which are merged; then by rows of a label, stiffness (N/m), friction, viscosity (N) and surface
   * strength (N), in which -1 stands for the value of the functions; and by the stand-off from
   * forbidden labels (world units). If a file or a row can't be read, an error is reported and the
   * output is empty.
   */
  void AddLabelFile(const char* file);
  void RemoveAllLabelFiles();
  void AddLabelMaterial(
    double label, double stiffness, double friction, double viscosity, double surfaceStrength);
  void RemoveAllLabelMaterials();
  void SetStandOff(double distance);
  ///@}

  ///@{
  /**
   * The modes, as rows of four texts, one for each vtkHapticMode. Kind: one of
   * vtkHapticMode::GetKindNames(), or VectorFrontTwoSided or RidgeDark; or Guide, GuideOutside or
   * GuideInside for the polygons or the image of distances on port 2 (Guide also for lines). Point
   * array: its name, or empty for the active vectors, tensors or distances. Strength, and for some
   * kinds SecondStrength: a number of newtons; pairs of the quantity and newtons, such as "0 0, 0.5
   * 2"; or empty for the mode's default. If a row can't be read, an error is reported and the
   * output is empty.
   */
  void AddModeRow(
    const char* kind, const char* array, const char* strength, const char* secondStrength);
  void RemoveAllModeRows();
  ///@}

  /**
   * "None" (default), or one of GetModePresetNames(). The preset's modes precede the modes of the
   * rows. They read the active vectors or tensors or, if none are active, the first ones.
   */
  void SetModePreset(const char* preset);

  ///@{
  /**
   * The tool in the hand: "None" (default), or the kind of a vtkHapticTool, such as "Needle" or
   * "Point shell". The shape of a point shell is the polygons on port 2. The settings of every kind
   * have names such as "Burr.Radius"; they are numbers, or functions of the scalar as texts, as in
   * AddModeRow. If a setting can't be read, an error is reported and the output is empty.
   */
  void SetToolKind(const char* kind);
  void SetToolNumber(const char* setting, double value);
  void SetToolFunction(const char* setting, const char* text);
  ///@}

  ///@{
  /**
   * Undo the last stroke of a burr, redo the last undone stroke, or restore all tissue that the
   * burr removed.
   */
  void UndoRemoval();
  void RedoRemoval();
  void RestoreTissue();
  ///@}

  using vtkVolumeHapticsFilter::SetInputConnection;
  /**
   * Connect an input. If a vtkPVHapticLargeFile is connected to port 0, the filter feels the file
   * itself instead of its coarse image.
   */
  void SetInputConnection(int port, vtkAlgorithmOutput* input) override;

  using vtkVolumeHapticsFilter::SetInputArrayToProcess;
  /**
   * Choose an array. An empty name, as from batch jobs that set no name, stands for the active
   * scalars.
   */
  void SetInputArrayToProcess(
    int index, int port, int connection, int association, const char* name) override;

  vtkMTimeType GetMTime() override;

protected:
  vtkPVVolumeHapticsFilter();
  ~vtkPVVolumeHapticsFilter() override;

  /** Port 2 also accepts an image of distances, which guide the hand: see AddModeRow. */
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  /** A function with values from 0 to 1, and the quantity that its value 1 stands for. */
  struct Curve
  {
    vtkSmartPointer<vtkPiecewiseFunction> Shape;
    double Scale = 1.0;

    void CopyTo(vtkPiecewiseFunction* function) const;
  };

  template <typename T>
  void Choose(T& setting, const T& value);
  /**
   * Returns the image on port 0 with the felt array as its scalars; null if no preset has to be
   * fitted.
   */
  vtkSmartPointer<vtkImageData> FindGreyLevels();
  void FillProperty(vtkImageData* levels);
  /** Fills the property if a choice has changed, or the image to which the preset is fitted. */
  void UpdateProperty();
  vtkMTimeType GetMaterialTime() const;
  void FillTable();
  void FillModes();
  /** Makes the tool again if its settings or its polygons have changed. */
  void FillTool();
  template <typename T>
  void ChooseTool(T& setting, const T& value);

  std::string Preset = "Custom";
  Curve Stiffness;
  Curve Friction;
  Curve Viscosity;
  Curve SurfaceStrength;
  Curve Distinctness;
  bool DistinctnessFromNoise = true;
  bool DistinctnessPerMillimeter = false;
  bool ScalarsAreLabels = false;
  bool SolidFromImage = false;
  bool ShiftFromImage = false;
  int SurfaceSide = 0;
  /**
   * The image, the array and the settings to which the preset was fitted, with their modification
   * times, for comparison.
   */
  using GreyLevels = std::tuple<vtkMTimeType, void*, vtkMTimeType, int, double, double>;
  GreyLevels Fitted{};
  std::array<double, 2> PresetScale{ { 1.0, 0.0 } };
  vtkTimeStamp Chosen; // time of the last change of a setting of the material
  vtkTimeStamp Filled; // time at which the property was last filled
  bool IsPresetKnown = true;
  std::vector<std::string> LabelFiles;
  std::vector<std::array<double, 5>> LabelMaterials;
  double StandOff = 0.0;
  bool IsTableDirty = false;
  bool IsTableGood = true;
  HapticModeRows Modes;
  HapticToolChoice Tools;

  vtkPVVolumeHapticsFilter(const vtkPVVolumeHapticsFilter&) = delete;
  void operator=(const vtkPVVolumeHapticsFilter&) = delete;
};

#endif
