// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The modes of a filter, from rows of texts and the name of a preset.
 */
#ifndef HapticModeRows_h
#define HapticModeRows_h

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkDataObject;
class vtkHapticMode;
class vtkVolumeHapticsFilter;

/**
 * See vtkPVVolumeHapticsFilter::AddModeRow and SetModePreset. Guides use the shape or the distances
 * on the filter's port 2. A preset without an array searches the data on port 0 for one, so the
 * modes are made again if these data change.
 */
class HapticModeRows
{
public:
  /** The texts of a row: kind, array, strength, second strength. */
  using Row = std::array<std::string, 4>;

  void Add(const Row& row);
  ///@{
  /** Remove the rows, or set the preset. Return whether anything has changed. */
  bool Clear();
  bool SetPreset(const std::string& preset);
  ///@}

  /**
   * Makes the filter's modes if anything has changed. Returns the errors of modes that can't be
   * made.
   */
  std::string Fill(vtkVolumeHapticsFilter* filter);
  /** Returns whether all modes could be made. */
  bool IsGood() const { return this->AreGood; }

  std::size_t GetNumberOfRows() const { return this->Rows.size(); }
  const std::string& GetPreset() const { return this->Preset; }

private:
  struct Seen
  {
    vtkWeakPointer<vtkDataObject> Data;
    vtkMTimeType Time = 0;

    /** Stores the data and their modification time. Returns whether the data have changed. */
    bool Record(vtkDataObject* data);
  };

  bool HasGuide() const;
  void AddPreset(vtkVolumeHapticsFilter* filter, std::string& error) const;
  void AddRow(const Row& row, vtkVolumeHapticsFilter* filter, std::string& error) const;

  std::vector<Row> Rows;
  std::string Preset = "None";
  Seen Input;
  Seen Guide;
  bool IsDirty = false;
  bool AreGood = true;
};

#endif
