// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Editor/EditHistory.h"

#include "VTK/Material/HapticFunctions.h"

#include "vtkHapticLabelTable.h"
#include "vtkHapticProperty.h"
#include "vtkPiecewiseFunction.h"

#include <utility>

namespace VolumeHaptics
{
namespace
{

constexpr std::size_t MostEdits = 100;
/**
 * Largest number of labels in all steps together, so that a large segmentation does not fill the
 * memory.
 */
constexpr vtkIdType MostLabels = 1000000;

} // namespace

EditHistory::EditHistory() = default;
EditHistory::~EditHistory() = default;

//------------------------------------------------------------------------------
EditHistory::Times EditHistory::ReadTimes(const EditedObjects& objects)
{
  Times times;
  times.Property = objects.Property ? objects.Property->GetMTime() : 0;
  times.Opacity = objects.Opacity ? objects.Opacity->GetMTime() : 0;
  times.Labels = objects.Labels ? objects.Labels->GetMTime() : 0;
  return times;
}

//------------------------------------------------------------------------------
EditHistory::Step EditHistory::Copy(const EditedObjects& objects, const Step* like)
{
  Step step;
  if (objects.Property && (!like || like->Property))
  {
    step.Property = vtkSmartPointer<vtkHapticProperty>::New();
    step.Property->DeepCopy(objects.Property);
  }
  if (objects.Opacity && (!like || like->Opacity))
  {
    step.Opacity = vtkSmartPointer<vtkPiecewiseFunction>::New();
    CopyFunction(objects.Opacity, step.Opacity);
  }
  if (objects.Labels && (!like || like->Labels))
  {
    step.Labels = vtkSmartPointer<vtkHapticLabelTable>::New();
    step.Labels->DeepCopy(objects.Labels);
  }
  return step;
}

//------------------------------------------------------------------------------
void EditHistory::Restore(const Step& step, const EditedObjects& objects)
{
  if (step.Property && objects.Property)
  {
    // Keep the current values of these two, which the editor does not edit.
    step.Property->SetComponent(objects.Property->GetComponent());
    step.Property->SetVisibilityFrom(objects.Property->GetVisibilityFrom());
    objects.Property->DeepCopy(step.Property);
  }
  if (step.Opacity && objects.Opacity)
  {
    CopyFunction(step.Opacity, objects.Opacity);
  }
  if (step.Labels && objects.Labels)
  {
    objects.Labels->DeepCopy(step.Labels);
  }
}

//------------------------------------------------------------------------------
void EditHistory::Keep(std::deque<Step>& steps, Step step)
{
  steps.push_back(std::move(step));
  vtkIdType labels = 0;
  for (const Step& one : steps)
  {
    labels += one.Labels ? one.Labels->GetNumberOfLabels() : 0;
  }
  while (steps.size() > 1 && (steps.size() > MostEdits || labels > MostLabels))
  {
    const Step& oldest = steps.front();
    labels -= oldest.Labels ? oldest.Labels->GetNumberOfLabels() : 0;
    steps.pop_front();
  }
}

//------------------------------------------------------------------------------
void EditHistory::Begin(const EditedObjects& objects)
{
  this->Before = Copy(objects, nullptr);
  this->Begun = ReadTimes(objects);
}

//------------------------------------------------------------------------------
void EditHistory::End(const EditedObjects& objects)
{
  Step step = std::exchange(this->Before, {});
  const Times now = ReadTimes(objects);
  step.Property = now.Property != this->Begun.Property ? step.Property : nullptr;
  step.Opacity = now.Opacity != this->Begun.Opacity ? step.Opacity : nullptr;
  step.Labels = now.Labels != this->Begun.Labels ? step.Labels : nullptr;
  if (step.IsEmpty())
  {
    return;
  }
  this->First.Property = this->First.Property ? this->First.Property : step.Property;
  this->First.Opacity = this->First.Opacity ? this->First.Opacity : step.Opacity;
  this->First.Labels = this->First.Labels ? this->First.Labels : step.Labels;
  this->Undone.clear();
  Keep(this->Done, std::move(step));
}

//------------------------------------------------------------------------------
bool EditHistory::Move(std::deque<Step>& from, std::deque<Step>& to, const EditedObjects& objects)
{
  if (from.empty())
  {
    return false;
  }
  const Step step = std::move(from.back());
  from.pop_back();
  Keep(to, Copy(objects, &step));
  Restore(step, objects);
  return true;
}

bool EditHistory::Undo(const EditedObjects& objects)
{
  return Move(this->Done, this->Undone, objects);
}

bool EditHistory::Redo(const EditedObjects& objects)
{
  return Move(this->Undone, this->Done, objects);
}

//------------------------------------------------------------------------------
bool EditHistory::Reset(const EditedObjects& objects)
{
  if (this->Done.empty())
  {
    return false; // nothing to reset: there were no edits, or all were undone
  }
  this->Undone.clear();
  Keep(this->Done, Copy(objects, &this->First));
  Restore(this->First, objects);
  return true;
}

//------------------------------------------------------------------------------
void EditHistory::Forget()
{
  this->Done.clear();
  this->Undone.clear();
  this->First = {};
  this->Before = {};
}

} // namespace VolumeHaptics
