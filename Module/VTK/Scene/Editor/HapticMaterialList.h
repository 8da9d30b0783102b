// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists of labels or tissues in the function editor, whose materials are edited with sliders.
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

/** A quantity of a material with a slider. */
struct MaterialQuantity
{
  const char* Title;
  double Usual; ///< usual upper end of the slider; a larger value extends it
  double Most;  ///< largest upper end of the slider
};

/**
 * Rows of materials in ascending order of their keys, of which some are visible and one is
 * selected. Only visible rows are looked up, so that a million labels are as fast as ten.
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
  /** Returns whether the rows are up to date with the data. */
  virtual bool IsCounted() const { return true; }
  /** Returns the object whose MTime changes with each edit; may be null. */
  virtual vtkObject* GetEdited() const = 0;

  ///@{
  /** Return the texts to paint. GetTitle() returns the title, or why there are no rows. */
  virtual std::string GetTitle() const = 0;
  /** Returns a hint on how to select a row. */
  virtual const char* GetHint() const = 0;
  virtual std::string Describe(int key) const = 0;
  virtual std::array<double, 3> GetColor(int key) const = 0;
  ///@}

  ///@{
  /**
   * HasBoxes() returns whether rows have check boxes for "felt" and "forbidden". The other
   * functions read and change the boxes.
   */
  virtual bool HasBoxes() const { return false; }
  virtual bool IsFelt(int) const { return true; }
  virtual bool IsForbidden(int) const { return false; }
  virtual void ToggleFelt(int) {}
  virtual void ToggleForbidden(int) {}
  ///@}

  ///@{
  /**
   * Return whether a row has its own material, or remove that material. Only lists with check boxes
   * distinguish this.
   */
  virtual bool HasMaterial(int) const { return true; }
  virtual void RemoveMaterial(int) {}
  ///@}

  /** Returns the row of a key; -1 if the key is not in the list. */
  vtkIdType FindRow(int key) const;

  ///@{
  /**
   * Set and get the visible rows: their number, and the first one. The first row is adjusted so
   * that as many visible rows as possible exist.
   */
  void SetVisibleRows(vtkIdType rows);
  vtkIdType GetVisibleRows() const { return this->VisibleRows; }
  void ScrollTo(vtkIdType first);
  vtkIdType GetFirstRow() const { return this->FirstRow; }
  ///@}

  ///@{
  /**
   * Select a row, or get the key of the selected row. Select() also scrolls to the row. It returns
   * false if the key is not in the list.
   */
  bool Select(int key);
  std::optional<int> GetSelected() const;
  ///@}

  ///@{
  /** Returns a quantity of the selected row; -1 if the functions determine its value. */
  double GetValue(int quantity) const;
  void SetValue(int quantity, double value);
  ///@}

  ///@{
  /**
   * GetEnd() returns the upper end of a slider. FitEnds() fits all ends to the values; do not call
   * it during a drag, so that the slider stays in place.
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

/** Returns the colour (RGB, 0 to 1) of a tissue, by its index, in lists and bands. */
std::array<double, 3> GetTissueColor(int tissue);

/** List of tissues in the function editor, and the material of the selected tissue. */
class HapticTissueList : public HapticMaterialList
{
public:
  /** The pointer `property` must outlive this list. It may be null. */
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
