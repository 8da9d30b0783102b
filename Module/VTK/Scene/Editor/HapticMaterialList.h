// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The list in the function editor whose materials are edited by sliders: labels, or tissues.
 */
#ifndef HapticMaterialList_h
#define HapticMaterialList_h

#include "vtkHapticProperty.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <optional>
#include <string>

class vtkObject;

namespace VolumeHaptics
{

/** A quantity of a material, as a slider shows it. */
struct MaterialQuantity
{
  const char* Title;
  double Usual; ///< end of the slider; larger values move it
  double Most;  ///< largest end
};

/**
 * Rows of materials in ascending order of their keys, a window of rows, and a selected row. Only
 * rows in the window are looked up, so that a million labels are as quick as ten.
 */
class HapticMaterialList
{
public:
  static constexpr int Quantities = 4;
  static const MaterialQuantity& GetQuantity(int quantity);

  HapticMaterialList() = default;
  virtual ~HapticMaterialList() = default;
  HapticMaterialList(const HapticMaterialList&) = delete;
  HapticMaterialList& operator=(const HapticMaterialList&) = delete;

  virtual vtkIdType GetNumberOfRows() const = 0;
  virtual int GetKey(vtkIdType row) const = 0;
  /** Whether the rows show the current data. */
  virtual bool IsCounted() const { return true; }
  /** Returns the object whose MTime advances with edits; may be null. */
  virtual vtkObject* GetEdited() const = 0;

  ///@{
  /**
   * Return what to paint: the title, or why there are no rows; and the text and colour of each row.
   */
  virtual std::string GetTitle() const = 0;
  /** Returns a hint how to select a row. */
  virtual const char* GetHint() const = 0;
  virtual std::string Describe(int key) const = 0;
  virtual std::array<double, 3> GetColor(int key) const = 0;
  ///@}

  ///@{
  /** Tell whether rows have boxes (felt, forbidden), and get and change the values of the boxes. */
  virtual bool HasBoxes() const { return false; }
  virtual bool IsFelt(int) const { return true; }
  virtual bool IsForbidden(int) const { return false; }
  virtual void ToggleFelt(int) {}
  virtual void ToggleForbidden(int) {}
  ///@}

  ///@{
  /**
   * Tell, in lists with boxes, whether a row has a material of its own, and remove this material.
   */
  virtual bool HasMaterial(int) const { return true; }
  virtual void RemoveMaterial(int) {}
  ///@}

  /** Returns the row of a key; -1 if it is not listed. */
  vtkIdType FindRow(int key) const;

  ///@{
  /**
   * Set and get the window of rows; its first row is moved so that all rows of the window exist, if
   * possible.
   */
  void SetVisibleRows(vtkIdType rows);
  vtkIdType GetVisibleRows() const { return this->VisibleRows; }
  void ScrollTo(vtkIdType first);
  vtkIdType GetFirstRow() const { return this->FirstRow; }
  ///@}

  ///@{
  /**
   * Select and get the key of a listed row. Select also scrolls to the row; false if the key is not
   * listed.
   */
  bool Select(int key);
  std::optional<int> GetSelected() const;
  ///@}

  ///@{
  /** Returns a quantity of the selected row; -1 if the functions decide it. */
  double GetValue(int quantity) const;
  void SetValue(int quantity, double value);
  ///@}

  ///@{
  /**
   * Return the end of a slider, and fit the ends to the values. A slider's end stays while it is
   * dragged.
   */
  double GetEnd(int quantity) const { return this->Ends[static_cast<std::size_t>(quantity)]; }
  void FitEnds();
  ///@}

protected:
  virtual double ReadValue(int key, int quantity) const = 0;
  virtual void WriteValue(int key, int quantity, double value) = 0;

private:
  vtkIdType FirstRow = 0;
  vtkIdType VisibleRows = 1;
  std::optional<int> Selected;
  std::array<double, Quantities> Ends{ 1.0, 1.0, 1.0, 1.0 };
};

/** Returns the colour of a tissue by number, in lists and bands: RGB, 0 to 1. */
std::array<double, 3> GetTissueColor(int tissue);

/** The tissues that the function editor lists, and the material of the selected tissue. */
class HapticTissueList : public HapticMaterialList
{
public:
  /** Borrows the property, which may be null. */
  explicit HapticTissueList(const vtkSmartPointer<vtkHapticProperty>& property)
    : Property(property)
  {
  }

  vtkIdType GetNumberOfRows() const override;
  int GetKey(vtkIdType row) const override { return static_cast<int>(row); }
  vtkObject* GetEdited() const override { return this->Property; }
  std::string GetTitle() const override;
  const char* GetHint() const override { return "Click on a tissue to edit its material"; }
  std::string Describe(int tissue) const override;
  std::array<double, 3> GetColor(int tissue) const override { return GetTissueColor(tissue); }

protected:
  double ReadValue(int tissue, int quantity) const override;
  void WriteValue(int tissue, int quantity, double value) override;

private:
  const vtkSmartPointer<vtkHapticProperty>& Property;
};

} // namespace VolumeHaptics

#endif
