// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Manages the tissues of a vtkHapticProperty: named ranges of values, and their materials in
 * functions.
 */
#ifndef HapticTissues_h
#define HapticTissues_h

#include <string>
#include <vector>

class vtkHapticProperty;
class vtkPiecewiseFunction;

namespace VolumeHaptics
{

/** A named range of values (scalar units), including both ends. */
struct NamedTissue
{
  std::string Name;
  double Low = 0.0;
  double High = 0.0;

  bool operator==(const NamedTissue& other) const
  {
    return this->Name == other.Name && this->Low == other.Low && this->High == other.High;
  }
};

/** List of tissues in ascending order of their values, without overlaps. */
class HapticTissues
{
public:
  /**
   * Adds a tissue and returns its index. Returns -1, with the reason and the cure in `error`, if it
   * can't be added.
   */
  int Add(const NamedTissue& tissue, std::string& error);
  void Clear() { this->All.clear(); }
  bool operator==(const HapticTissues& other) const { return this->All == other.All; }

  int GetSize() const { return static_cast<int>(this->All.size()); }
  const NamedTissue& Get(int tissue) const { return this->All[static_cast<std::size_t>(tissue)]; }

  /**
   * Returns a function's value in the middle of a tissue; `empty` for a function without points.
   */
  double GetValue(vtkPiecewiseFunction* function, int tissue, double empty) const;
  /**
   * Makes a function constant over a tissue. From there to the neighbouring tissues, which keep
   * their values, the function changes linearly. Before the first tissue and after the last one,
   * the function continues with the value of that tissue, unless it has points there.
   */
  void SetValue(vtkPiecewiseFunction* function, int tissue, double value, double empty) const;

private:
  std::vector<NamedTissue> All;
};

///@{
/** Get and set the tissues of a property. Setting an equal list does not modify the property. */
HapticTissues GetTissues(vtkHapticProperty* property);
void SetTissues(vtkHapticProperty* property, const HapticTissues& tissues);
///@}

} // namespace VolumeHaptics

#endif
