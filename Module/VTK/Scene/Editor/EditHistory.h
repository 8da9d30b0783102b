// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Implements undo and redo for vtkHapticFunctionEditor.
 */
#ifndef EditHistory_h
#define EditHistory_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <deque>

class vtkHapticLabelTable;
class vtkHapticProperty;
class vtkPiecewiseFunction;

namespace VolumeHaptics
{

/** Objects that an editor changes; any may be null. */
struct EditedObjects
{
  vtkHapticProperty* Property = nullptr;
  vtkPiecewiseFunction* Opacity = nullptr;
  vtkHapticLabelTable* Labels = nullptr;
};

/**
 * A list of steps. Each step stores the state before an edit, of the objects that the edit changed.
 * Changes that the program makes are not recorded as steps.
 */
class EditHistory
{
public:
  EditHistory();
  ~EditHistory();
  EditHistory(const EditHistory&) = delete;
  EditHistory& operator=(const EditHistory&) = delete;

  ///@{
  /**
   * Begin and end a step: call Begin before an edit and End after it. An edit without a change
   * makes no step.
   */
  void Begin(const EditedObjects& objects);
  void End(const EditedObjects& objects);
  ///@}

  ///@{
  /**
   * Restore, in the objects themselves, the state before the last edit or after the last undone
   * edit. Return false if there is none.
   */
  bool Undo(const EditedObjects& objects);
  bool Redo(const EditedObjects& objects);
  /**
   * Restores the state before the first edit, recorded as a further step. Returns false if there is
   * nothing to reset.
   */
  bool Reset(const EditedObjects& objects);
  ///@}

  /** Removes all steps. Call this before other objects are edited. */
  void Forget();

private:
  struct Step
  {
    vtkSmartPointer<vtkHapticProperty> Property; ///< null if the edit did not change it
    vtkSmartPointer<vtkPiecewiseFunction> Opacity;
    vtkSmartPointer<vtkHapticLabelTable> Labels;
    bool IsEmpty() const { return !this->Property && !this->Opacity && !this->Labels; }
  };
  struct Times
  {
    vtkMTimeType Property = 0;
    vtkMTimeType Opacity = 0;
    vtkMTimeType Labels = 0;
  };

  static Times ReadTimes(const EditedObjects& objects);
  /** Copies the objects. With `like`, copies only the objects that this step contains. */
  static Step Copy(const EditedObjects& objects, const Step* like);
  static void Restore(const Step& step, const EditedObjects& objects);
  static void Keep(std::deque<Step>& steps, Step step);
  static bool Move(std::deque<Step>& from, std::deque<Step>& to, const EditedObjects& objects);

  std::deque<Step> Done;
  std::deque<Step> Undone;
  Step First;  ///< state of each object before its first edit
  Step Before; ///< state before the edit in progress
  Times Begun;
};

} // namespace VolumeHaptics

#endif
