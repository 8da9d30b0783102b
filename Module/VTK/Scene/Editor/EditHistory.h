// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Undo and redo for vtkHapticFunctionEditor.
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

/** The objects that an editor changes; each may be null. */
struct EditedObjects
{
  vtkHapticProperty* Property = nullptr;
  vtkPiecewiseFunction* Opacity = nullptr;
  vtkHapticLabelTable* Labels = nullptr;
};

/**
 * Steps that hold what was before an edit, of the objects that it has changed. Edits by others, a
 * program for example, are no steps.
 */
class EditHistory
{
public:
  EditHistory();
  ~EditHistory();
  EditHistory(const EditHistory&) = delete;
  EditHistory& operator=(const EditHistory&) = delete;

  ///@{
  /** Around an edit. If it has changed nothing, there is no step. */
  void Begin(const EditedObjects& objects);
  void End(const EditedObjects& objects);
  ///@}

  ///@{
  /** Brings a state back, in place. False if there is none. */
  bool Undo(const EditedObjects& objects);
  bool Redo(const EditedObjects& objects);
  /** As before the first edit; a step of its own. */
  bool Reset(const EditedObjects& objects);
  ///@}

  /** For other objects. */
  void Forget();

private:
  struct Step
  {
    vtkSmartPointer<vtkHapticProperty> Property; ///< null if it was not changed
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
  /** Copies of the objects, or of those alone that another step has. */
  static Step Copy(const EditedObjects& objects, const Step* like);
  static void Restore(const Step& step, const EditedObjects& objects);
  static void Keep(std::deque<Step>& steps, Step step);
  static bool Move(std::deque<Step>& from, std::deque<Step>& to, const EditedObjects& objects);

  std::deque<Step> Done;
  std::deque<Step> Undone;
  Step First;  ///< each object as it was before its first edit
  Step Before; ///< of the edit that goes on
  Times Begun;
};

} // namespace VolumeHaptics

#endif
