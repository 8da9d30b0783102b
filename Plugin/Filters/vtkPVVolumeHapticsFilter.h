// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVVolumeHapticsFilter
 * @brief   vtkVolumeHapticsFilter with its material as plain settings
 *
 * ParaView sets properties one by one, in any order, and draws its functions from 0 to 1. So this
 * filter stores the user's choices (a preset, or five functions and the newtons of their value 1),
 * and fills its vtkHapticProperty from them after each change. This happens before the property
 * is used: the pipeline and vtkHapticDevice::Publish both begin with GetMTime().
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
   * "Custom" (default): the functions below. Otherwise one of vtkHapticProperty::GetPresetNames();
   * the functions, DistinctnessFromNoise, ScalarsAreLabels, SolidFromImage, ShiftFromImage and
   * SurfaceSide are then unused until it is "Custom" again. Any other name is an error that lists
   * these, and the output is empty. A preset for values without a unit is fitted to the image on
   * port 0, as vtkHapticProperty::ApplyPreset(name, image) does it, and again after the image has
   * changed; data other than images are felt as in the preset's table.
   */
  void SetPreset(const char* preset);

  /**
   * Get the two factors by which the preset's values and gradients were multiplied. (1, 0): the
   * preset's own table is used, with gradients per millimetre; a fitted preset has gradients per
   * world unit.
   */
  double* GetPresetScale() VTK_SIZEHINT(2);

  ///@{
  /**
   * The five functions of vtkHapticProperty, each divided by its scale below. nullptr (default) or
   * a function without points: the default of the property.
   */
  void SetStiffnessFunction(vtkPiecewiseFunction* function);
  void SetFrictionFunction(vtkPiecewiseFunction* function);
  void SetViscosityFunction(vtkPiecewiseFunction* function);
  void SetSurfaceStrengthFunction(vtkPiecewiseFunction* function);
  ///@}

  ///@{
  /**
   * The value of a function at 1: stiffness (N/m, default 1000), friction (no unit, 1), viscosity
   * (N, 1) and surface strength (N, 4).
   */
  void SetStiffnessScale(double scale);
  void SetFrictionScale(double scale);
  void SetViscosityScale(double scale);
  void SetSurfaceStrengthScale(double scale);
  ///@}

  ///@{
  /**
   * Set DistinctnessFromNoise: on (default), distinctness keeps noise from being felt, and the
   * function of distinctness is not used. PerMillimeter, as in vtkHapticProperty, is for that
   * function.
   */
  void SetDistinctnessFromNoise(bool fromNoise);
  void SetDistinctnessPerMillimeter(bool perMillimeter);
  void SetDistinctnessFunction(vtkPiecewiseFunction* function);
  ///@}

  ///@{
  /**
   * Whether the scalars are labels, whether the image tells what is solid, and whether it tells how
   * Hounsfield units are stored: see vtkHapticProperty.
   */
  void SetScalarsAreLabels(bool areLabels);
  void SetSolidFromImage(bool fromImage);
  void SetShiftFromImage(bool fromImage);
  ///@}

  ///@{
  /** Set side, component, shift, scale and ramp: see vtkHapticProperty. */
  void SetSurfaceSide(int side);
  void SetComponent(int component);
  void SetScalarShift(double shift);
  void SetScalarScale(double scale);
  double* GetNoiseRamp() VTK_SIZEHINT(2);
  ///@}

  ///@{
  /**
   * What the labels of port 3 feel like: files for vtkHapticLabelTable::ReadFile, which add up;
   * then rows of a label, stiffness (N/m), friction, viscosity (N) and surface strength (N), -1
   * where the functions hold; and the stand-off from forbidden labels (world units). A file or a
   * row that can't be read is an error, and the output is empty.
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
   * Rows of four texts, each for a vtkHapticMode. Kind: one of vtkHapticMode::GetKindNames(), or
   * VectorFrontTwoSided or RidgeDark; or Guide, GuideOutside or GuideInside for the polygons or the
   * image of distances on port 2 (Guide for lines, too). Point array: empty for the active vectors,
   * tensors or distances. Strength, and SecondStrength of kinds that have one: a number of newtons;
   * pairs such as "0 0, 0.5 2" of the quantity and newtons; or empty for the mode's default. A row
   * that can't be read is an error, and the output is empty.
   */
  void AddModeRow(
    const char* kind, const char* array, const char* strength, const char* secondStrength);
  void RemoveAllModeRows();
  ///@}

  /**
   * "None" (default), or one of GetModePresetNames(): its modes come before those of the rows.
   * These modes read the active vectors or tensors or, if there are none, the first ones.
   */
  void SetModePreset(const char* preset);

  ///@{
  /**
   * What the hand holds: "None" (default), or the kind of a vtkHapticTool, such as "Needle" or
   * "Point shell", whose shape is the polygons on port 2. Settings of every kind, such as
   * "Burr.Radius", are numbers, or functions of the scalar as texts as in AddModeRow. What can't be
   * read is an error, and the output is empty.
   */
  void SetToolKind(const char* kind);
  void SetToolNumber(const char* setting, double value);
  void SetToolFunction(const char* setting, const char* text);
  ///@}

  ///@{
  /**
   * Undo the last stroke of a burr in the hand, redo it, and restore all tissue that it removed.
   */
  void UndoRemoval();
  void RedoRemoval();
  void RestoreTissue();
  ///@}

  using vtkVolumeHapticsFilter::SetInputConnection;
  /**
   * Whether a vtkPVHapticLargeFile on port 0 is felt itself, instead of the coarse image that it
   * shows.
   */
  void SetInputConnection(int port, vtkAlgorithmOutput* input) override;

  using vtkVolumeHapticsFilter::SetInputArrayToProcess;
  /**
   * An empty name, as in batch jobs that have not set one, means the active scalars.
   */
  void SetInputArrayToProcess(
    int index, int port, int connection, int association, const char* name) override;

  vtkMTimeType GetMTime() override;

protected:
  vtkPVVolumeHapticsFilter();
  ~vtkPVVolumeHapticsFilter() override;

  /** Accepts an image on port 2, too, whose distances guide the hand: see AddModeRow. */
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  /** A function from 0 to 1, and the quantity that its value 1 stands for. */
  struct Curve
  {
    vtkSmartPointer<vtkPiecewiseFunction> Shape;
    double Scale = 1.0;

    void CopyTo(vtkPiecewiseFunction* function) const;
  };

  template <typename T>
  void Choose(T& setting, const T& value);
  /**
   * Returns the image on port 0, with its felt array as scalars; null if no preset is fitted to it.
   */
  vtkSmartPointer<vtkImageData> FindGreyLevels();
  void FillProperty(vtkImageData* levels);
  /** Fills the property if a choice, or the image that the preset is fitted to, has changed. */
  void UpdateProperty();
  vtkMTimeType GetMaterialTime() const;
  /** Makes the label table. */
  void FillTable();
  /** Makes the modes. */
  void FillModes();
  /** Makes the tool, if its settings or its polygons have changed. */
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
  /** the image, array and settings that the preset was fitted to, with their times */
  using GreyLevels = std::tuple<vtkMTimeType, void*, vtkMTimeType, int, double, double>;
  GreyLevels Fitted{};
  std::array<double, 2> PresetScale{ { 1.0, 0.0 } };
  vtkTimeStamp Chosen; // last change of a setting of the material
  vtkTimeStamp Filled; // last filling of the property
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
