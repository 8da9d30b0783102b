// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticLabelTable
 * @brief   names, colours and materials of the labels of a segmentation
 *
 * Describes how each label of a label image feels. Transfer functions can't distinguish tissues
 * with the same scalar values; labels can:
 *
 *   vtkNew<vtkHapticLabelTable> table;
 *   table->SetLabelName(5, "liver");
 *   table->SetStiffness(5, 300.0);
 *   table->SetSurfaceStrength(5, 1.5);
 *   table->SetForbidden(52, true); // the aorta
 *
 * Labels are integers of any sign; 0 has no special meaning, so that air, too, can have a material.
 * A quantity that is not set for a label comes from the transfer functions of vtkHapticProperty: a
 * label with only a name and a colour feels as if there were no label image, and a label with only
 * a stiffness gets friction, viscosity and surface strength from the functions.
 *
 * ReadFile reads names and colours that other programs store with their segmentations, and
 * materials from CSV files. Files add up: one file may have the names, and another file the
 * materials.
 *
 *   table->ReadFile("Liver.seg.nrrd");
 *   table->ReadFile("materials.csv"); // label,name,stiffness,friction,viscosity,strength
 *
 * @sa vtkHapticProperty, vtkVolumeHapticsFilter
 */
#ifndef vtkHapticLabelTable_h
#define vtkHapticLabelTable_h

#include "vtkObject.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for ivars
#include <string> // for names

class vtkFieldData;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticLabelTable : public vtkObject
{
public:
  static vtkHapticLabelTable* New();
  vtkTypeMacro(vtkHapticLabelTable, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Stiffness k of the spring between proxy and tip, for surfaces of this label (N/m, 0 or more).
   * The getter returns -1 if it is not set.
   */
  void SetStiffness(int label, double stiffness);
  double GetStiffness(int label);
  ///@}

  ///@{
  /**
   * Coefficient of friction mu of this label's surfaces (0 or more). The getter returns -1 if it is
   * not set.
   */
  void SetFriction(int label, double friction);
  double GetFriction(int label);
  ///@}

  ///@{
  /**
   * Drag R of this label's tissue against any motion (N, 0 or more). The getter returns -1 if it is
   * not set.
   */
  void SetViscosity(int label, double viscosity);
  double GetViscosity(int label);
  ///@}

  ///@{
  /**
   * Surface strength T_N: the normal force at which a surface of this label is penetrated (N, 0 or
   * more). The getter returns -1 if it is not set.
   */
  void SetSurfaceStrength(int label, double strength);
  double GetSurfaceStrength(int label);
  ///@}

  ///@{
  /**
   * Friction tau of this label's tissue along the shaft of a vtkHapticNeedle (N per metre of the
   * shaft in it, 0 or more). The getter returns -1 if it is not set.
   */
  void SetShaftFriction(int label, double friction);
  double GetShaftFriction(int label);
  ///@}

  ///@{
  /**
   * Energy U that a vtkHapticBurr needs to remove this label's tissue (J/mm^3, 0 or more). The
   * getter returns -1 if it is not set.
   */
  void SetSpecificEnergy(int label, double energy);
  double GetSpecificEnergy(int label);
  ///@}

  /**
   * Remove all material numbers of a label (stiffness, friction, viscosity, surface strength, shaft
   * friction and specific energy), so that the transfer functions apply again.
   */
  void RemoveMaterial(int label);

  /**
   * Get whether a label has at least one of stiffness, friction, viscosity, surface strength, shaft
   * friction and specific energy.
   */
  bool HasMaterial(int label);

  ///@{
  /**
   * The name of a label, UTF-8. A text that is not UTF-8 is read as ISO 8859-1. The getter returns
   * an empty text if there is no name.
   */
  void SetLabelName(int label, const std::string& name);
  std::string GetLabelName(int label);
  ///@}

  ///@{
  /**
   * The colour of a label (red, green and blue, 0 to 1), for displays. The getter returns a middle
   * grey if it is not set.
   */
  void SetColor(int label, double red, double green, double blue);
  void SetColor(int label, const double color[3]) VTK_SIZEHINT(color, 3);
  const double* GetColor(int label) VTK_SIZEHINT(3);
  void GetColor(int label, double color[3]) VTK_SIZEHINT(color, 3);
  bool HasColor(int label);
  ///@}

  ///@{
  /**
   * Whether a label is felt at all. A label that is not felt has neither surfaces nor drag. Default
   * true.
   */
  void SetFelt(int label, bool felt);
  bool GetFelt(int label);
  ///@}

  ///@{
  /**
   * Whether the tip is kept out of a label, at the distance StandOff. Default false.
   */
  void SetForbidden(int label, bool forbidden);
  bool GetForbidden(int label);
  ///@}

  ///@{
  /**
   * The distance from forbidden labels at which the tip is kept (world units, 0 or more). Default
   * 0.
   */
  void SetStandOff(double distance);
  vtkGetMacro(StandOff, double);
  ///@}

  ///@{
  /**
   * Get the labels that have an entry, in ascending order. The index counts from 0. For an index
   * out of range, GetLabel reports an error and returns 0.
   */
  vtkIdType GetNumberOfLabels();
  int GetLabel(vtkIdType index);
  ///@}

  bool HasLabel(int label);
  /** Remove a label's entry with its name, colour and material. */
  void RemoveLabel(int label);
  void RemoveAllLabels();

  /**
   * Read labels from a file. Its contents determine the format, not its name; gzip is allowed:
   *
   * - 3D Slicer and VolView, segmentation (.seg.nrrd): names and colours. If overlapping segments
   *   of different layers have the same value, segment N gets the label N + 1;
   * - NIfTI with a table in its header (TotalSegmentator --ml, Connectome Workbench, MRIcron);
   * - ITK-SNAP, label descriptions;
   * - FreeSurfer, colour table such as FreeSurferColorLUT.txt;
   * - MRIcron, names (.txt) and colours (.lut);
   * - VTK, image (.vti) with the arrays of WriteFieldData;
   * - CSV whose first line names the columns: label (or index, id), name, stiffness (N/m),
   *   friction, viscosity (N), strength (N), shaft (N/m), energy (J/mm^3), felt, forbidden (1 or
   *   0), and color (`\#rrggbb`). Only label is needed, other columns are ignored, and empty cells
   *   set nothing.
   *
   * Quantities of a label in the file replace those in the table; everything else stays. A text
   * that is not UTF-8 is read as ISO 8859-1. If the file can't be read, reports an error, returns
   * false and changes nothing.
   */
  bool ReadFile(VTK_FILEPATH const char* path);

  /** Write a CSV file that ReadFile can read. On failure, reports an error and returns false. */
  bool WriteFile(VTK_FILEPATH const char* path);

  ///@{
  /**
   * Read or write the table as arrays with a tuple for each label, so that an image can carry it in
   * its field data: Label; LabelName; LabelColor (3 components); LabelStiffness, LabelFriction,
   * LabelViscosity, LabelSurfaceStrength, LabelShaftFriction, LabelSpecificEnergy, LabelFelt,
   * LabelForbidden, -1 for unset values; and LabelStandOff, one number. Reading requires only
   * Label, and changes the table as ReadFile does. On failure, it reports an error, returns false
   * and changes nothing.
   */
  bool ReadFieldData(vtkFieldData* data);
  void WriteFieldData(vtkFieldData* data);
  ///@}

  /** Copy all labels and settings of another table. */
  void DeepCopy(vtkHapticLabelTable* source);

protected:
  vtkHapticLabelTable();
  ~vtkHapticLabelTable() override;

  double StandOff = 0.0;

private:
  vtkHapticLabelTable(const vtkHapticLabelTable&) = delete;
  void operator=(const vtkHapticLabelTable&) = delete;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
