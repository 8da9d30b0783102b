// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Interaction/EditorKeys.h"

#include "VTK/Scene/Interaction/SceneFrames.h"

#include "vtkHapticProperty.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkVolumeHapticsFilter.h"

#include <cstring>
#include <utility>

namespace VolumeHaptics
{
namespace
{

constexpr const char* ProposingNotice = "Functions are looked for";
constexpr const char* NoProposalNotice = "No functions can be proposed for this volume";

} // namespace

//------------------------------------------------------------------------------
bool EditorKeys::Press(const std::string& key)
{
  vtkHapticFunctionEditor* const editor = this->Scene.Editor;
  if (!editor)
  {
    return false;
  }
  if (key == "v")
  {
    editor->SetVisibility(!editor->GetVisibility());
  }
  else if (key == "V")
  {
    // Show a hidden editor beside the scene.
    editor->SetDocked(!editor->GetVisibility() || !editor->GetDocked());
    editor->VisibilityOn();
  }
  else if (key == "n")
  {
    editor->NextFunction();
  }
  else if (key == "R")
  {
    this->Tell(editor->Reset(), "There are no edits to take back");
  }
  else if ((key == "Z" || key == "Y") && this->HasPointer())
  {
    key == "Z" ? this->Tell(editor->Undo(), "There is no edit to undo")
               : this->Tell(editor->Redo(), "There is no edit to redo");
  }
  else if (key == "l")
  {
    this->ToggleLabels();
  }
  else if (key == "p")
  {
    this->Propose();
  }
  else if (key == "BackSpace")
  {
    editor->DropProposal();
    this->EndProposing("");
  }
  else
  {
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool EditorKeys::HasPointer() const
{
  const int* const at = this->Scene.Style->GetInteractor()->GetEventPosition();
  return !this->Scene.Measurements || this->Scene.Editor->Contains(at[0], at[1]);
}

//------------------------------------------------------------------------------
void EditorKeys::Tell(bool isDone, const char* notice)
{
  if (!isDone)
  {
    this->Frames.Notify(notice);
  }
}

//------------------------------------------------------------------------------
void EditorKeys::Propose()
{
  vtkHapticFunctionEditor* const editor = this->Scene.Editor;
  if (editor->GetVisibility() && editor->TakeProposal())
  {
    vtkVolumeHapticsFilter* const filter =
      this->Scene.Device ? this->Scene.Device->GetVolumeHaptics() : nullptr;
    if (filter && filter->GetProperty() == editor->GetProperty())
    {
      filter->SetKernelRadius(editor->GetProperty()->GetProposedKernelRadius());
    }
    return;
  }
  editor->VisibilityOn();
  if (editor->HasProposal())
  {
    return;
  }
  if (editor->BeginProposal())
  {
    this->ProposingEditor = editor;
    this->IsProposing = true;
    this->Frames.Notify(ProposingNotice);
  }
  else
  {
    this->Frames.Notify(NoProposalNotice);
  }
}

//------------------------------------------------------------------------------
void EditorKeys::FollowProposal()
{
  const vtkSmartPointer<vtkHapticFunctionEditor> editor = this->Scene.Editor;
  if (!this->IsProposing)
  {
    return;
  }
  if (!editor || editor.Get() != this->ProposingEditor.GetPointer())
  {
    this->EndProposing("");
    return;
  }
  editor->Update();
  if (!editor->IsProposing())
  {
    this->EndProposing(editor->HasProposal() ? "" : NoProposalNotice);
  }
}

//------------------------------------------------------------------------------
void EditorKeys::EndProposing(const char* notice)
{
  vtkHapticHeadUpDisplay* const display = this->Scene.Display;
  if (std::exchange(this->IsProposing, false) && display &&
    (*notice || std::strcmp(display->GetNotice(), ProposingNotice) == 0))
  {
    display->SetNotice(notice);
  }
  this->ProposingEditor = nullptr;
  this->Frames.NoteEvent();
}

//------------------------------------------------------------------------------
void EditorKeys::ToggleLabels()
{
  // Observers of the editor's work may remove the editor.
  const vtkSmartPointer<vtkHapticFunctionEditor> editor = this->Scene.Editor;
  vtkHapticLabelTable* const table = editor->GetLabelTable();
  if (!table)
  {
    this->Frames.Notify("There are no labels to edit");
    return;
  }
  const bool isShown =
    editor->GetVisibility() && editor->GetFunction() == vtkHapticFunctionEditor::LABELS;
  editor->SetVisibility(!isShown);
  if (!isShown)
  {
    editor->SetFunctionToLabels();
    editor->Update();
    if (vtkHapticDevice* const device = this->Scene.Device; device && device->GetContact() != 0)
    {
      const vtkTypeInt64 label = device->GetLabel();
      if (label == static_cast<int>(label)) // only these tables exist
      {
        editor->SelectLabel(static_cast<int>(label));
      }
    }
  }
}

} // namespace VolumeHaptics
