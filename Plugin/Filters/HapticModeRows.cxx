// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticModeRows.h"

#include "HapticFunctionText.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkHapticGuideMode.h"
#include "vtkHapticMode.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <iterator>

namespace
{

/** A kind of mode whose settings differ from the kind's defaults. */
struct ModeVariant
{
  const char* Name; ///< name of the variant in a row
  int Kind;
  void (*Adjust)(vtkHapticMode*);
};

constexpr ModeVariant ModeVariants[] = {
  { "VectorFrontTwoSided", vtkHapticMode::VECTOR_FRONT,
    [](vtkHapticMode* mode) { mode->TwoSidedOn(); } },
  { "RidgeDark", vtkHapticMode::RIDGE, [](vtkHapticMode* mode) { mode->SetPolarityToDark(); } },
  { "GuideOutside", vtkHapticMode::GUIDE,
    [](vtkHapticMode* mode) { vtkHapticGuideMode::SafeDownCast(mode)->SetSideToOutside(); } },
  { "GuideInside", vtkHapticMode::GUIDE,
    [](vtkHapticMode* mode) { vtkHapticGuideMode::SafeDownCast(mode)->SetSideToInside(); } },
};

/** Makes a mode by its name in a row; null if there is no such mode. */
vtkSmartPointer<vtkHapticMode> MakeModeOfRow(const std::string& name)
{
  const auto* const variant = std::find_if(std::begin(ModeVariants), std::end(ModeVariants),
    [&name](const ModeVariant& known) { return name == known.Name; });
  const bool isVariant = variant != std::end(ModeVariants);
  const int kind =
    isVariant ? variant->Kind : static_cast<int>(vtkHapticMode::GetKindNames()->LookupValue(name));
  if (kind < 0)
  {
    return nullptr;
  }
  vtkSmartPointer<vtkHapticMode> mode;
  if (kind == vtkHapticMode::GUIDE)
  {
    mode = vtkSmartPointer<vtkHapticGuideMode>::New();
  }
  else
  {
    mode = vtkSmartPointer<vtkHapticMode>::New();
    mode->SetKind(kind);
  }
  if (isVariant)
  {
    variant->Adjust(mode);
  }
  return mode;
}

/**
 * Makes a field of the distances in an image, which are its active scalars or a named array.
 * Returns null if there are no distances. An image that is not computed yet makes an empty field,
 * which is filled later.
 */
vtkSmartPointer<vtkImageData> MakeField(vtkImageData* image, const std::string& array)
{
  vtkPointData* const points = image->GetPointData();
  vtkDataArray* const distances =
    array.empty() ? points->GetScalars() : points->GetArray(array.c_str());
  const bool isThere = distances && distances->GetNumberOfComponents() == 1;
  if (!isThere && image->GetNumberOfPoints() > 0)
  {
    return nullptr;
  }
  auto field = vtkSmartPointer<vtkImageData>::New();
  field->CopyStructure(image);
  field->GetPointData()->SetScalars(distances);
  return field;
}

/** Passes polygons, lines or distances to a guide. Returns an error on failure. */
std::string FillGuide(vtkDataObject* data, const std::string& array, vtkHapticGuideMode* guide)
{
  if (auto* const image = vtkImageData::SafeDownCast(data))
  {
    guide->SetDistanceField(MakeField(image, array));
    return guide->GetDistanceField()
      ? ""
      : "needs an array of distances, but the image chosen as Surface has no such point array with "
        "one component. Name it in this row, or leave Array empty and make it the active scalars";
  }
  auto* const shape = vtkPolyData::SafeDownCast(data);
  if (!shape)
  {
    return "has no guide. Choose polygons or lines as Surface, or an image of distances";
  }
  const bool isPath = shape->GetNumberOfLines() > 0 && shape->GetNumberOfPolys() == 0 &&
    shape->GetNumberOfStrips() == 0;
  if (isPath && guide->GetSide() != vtkHapticGuideMode::SURFACE)
  {
    return "needs an inside and an outside, which the lines of Surface do not have. Give the kind "
           "Guide, or "
           "choose polygons as Surface";
  }
  guide->SetPath(isPath ? shape : nullptr);
  guide->SetSurface(isPath ? nullptr : shape);
  return {};
}

/** Returns the first data set in data, which may be composite; null if there is none. */
vtkDataSet* FindFirstSet(vtkDataObject* data)
{
  auto* const composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    return vtkDataSet::SafeDownCast(data);
  }
  vtkSmartPointer<vtkCompositeDataIterator> parts;
  parts.TakeReference(composite->NewIterator());
  for (parts->InitTraversal(); !parts->IsDoneWithTraversal(); parts->GoToNextItem())
  {
    auto* const part = vtkDataSet::SafeDownCast(parts->GetCurrentDataObject());
    if (part && part->GetNumberOfPoints() > 0)
    {
      return part;
    }
  }
  return nullptr;
}

/**
 * Returns the name of the first array that a mode can read; empty if an array is active, or if
 * there is none.
 */
std::string FindArray(vtkDataObject* data, vtkHapticMode* mode)
{
  vtkDataSet* const set = FindFirstSet(data);
  vtkPointData* const points = set ? set->GetPointData() : nullptr;
  const bool isTensor = mode->GetKind() == vtkHapticMode::TENSOR_FOLLOW;
  return !points || (isTensor ? points->GetTensors() : points->GetVectors())
    ? std::string()
    : mode->FindArrayName(set);
}

} // namespace

//------------------------------------------------------------------------------
bool HapticModeRows::Seen::Record(vtkDataObject* data)
{
  const vtkMTimeType time = data ? data->GetMTime() : 0;
  const bool isOther = data != this->Data || time != this->Time;
  this->Data = data;
  this->Time = time;
  return isOther;
}

//------------------------------------------------------------------------------
void HapticModeRows::Add(const Row& row)
{
  this->Rows.push_back(row);
  this->IsDirty = true;
}

//------------------------------------------------------------------------------
bool HapticModeRows::Clear()
{
  const bool changes = !this->Rows.empty();
  this->Rows.clear();
  this->IsDirty = this->IsDirty || changes;
  return changes;
}

//------------------------------------------------------------------------------
bool HapticModeRows::SetPreset(const std::string& preset)
{
  const bool changes = preset != this->Preset;
  this->Preset = preset;
  this->IsDirty = this->IsDirty || changes;
  return changes;
}

//------------------------------------------------------------------------------
bool HapticModeRows::HasGuide() const
{
  return std::any_of(this->Rows.begin(), this->Rows.end(),
    [](const Row& row) { return row[0].rfind("Guide", 0) == 0; });
}

//------------------------------------------------------------------------------
std::string HapticModeRows::Fill(vtkVolumeHapticsFilter* filter)
{
  const auto dataOf = [&](int port)
  {
    return filter->GetNumberOfInputConnections(port) > 0 ? filter->GetInputDataObject(port, 0)
                                                         : nullptr;
  };
  const bool hasData = this->Preset != "None" && this->Input.Record(dataOf(0));
  const bool hasGuide = this->HasGuide() && this->Guide.Record(dataOf(2));
  if (!this->IsDirty && !hasData && !hasGuide)
  {
    return {};
  }
  this->IsDirty = false; // reset this first, because the calls below re-enter this function
  std::string error;
  filter->RemoveAllModes();
  if (this->Preset != "None")
  {
    this->AddPreset(filter, error);
  }
  for (const Row& row : this->Rows)
  {
    this->AddRow(row, filter, error);
  }
  this->AreGood = error.empty();
  return error;
}

//------------------------------------------------------------------------------
void HapticModeRows::AddPreset(vtkVolumeHapticsFilter* filter, std::string& error) const
{
  vtkStringArray* const names = vtkVolumeHapticsFilter::GetModePresetNames();
  if (names->LookupValue(this->Preset) < 0)
  {
    error += "There is no preset of modes \"" + this->Preset + "\". Use one of: \"None\"";
    for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
    {
      error += ", \"" + std::string(names->GetValue(i)) + "\"";
    }
    error += ". ";
    return;
  }
  vtkNew<vtkVolumeHapticsFilter> preset;
  preset->ApplyModePreset(this->Preset.c_str(), nullptr);
  for (int i = 0; i < preset->GetNumberOfModes(); ++i)
  {
    vtkHapticMode* const mode = preset->GetMode(i);
    mode->SetArrayName(FindArray(this->Input.Data, mode).c_str());
    filter->AddMode(mode);
  }
}

//------------------------------------------------------------------------------
void HapticModeRows::AddRow(
  const Row& row, vtkVolumeHapticsFilter* filter, std::string& error) const
{
  const auto& [kind, array, strength, second] = row;
  const vtkSmartPointer<vtkHapticMode> mode = MakeModeOfRow(kind);
  std::string flaw;
  if (!mode)
  {
    flaw = "has no kind of mode. Give one of";
    vtkStringArray* const kinds = vtkHapticMode::GetKindNames();
    for (vtkIdType i = 0; i < kinds->GetNumberOfValues(); ++i)
    {
      flaw += " " + kinds->GetValue(i);
    }
    for (const ModeVariant& known : ModeVariants)
    {
      flaw += std::string(" ") + known.Name;
    }
  }
  else if (!mode->HasSecondStrength() && !second.empty())
  {
    flaw = "has a second strength, which this kind does not use. Leave it empty";
  }
  else
  {
    if (auto* const guide = vtkHapticGuideMode::SafeDownCast(mode))
    {
      flaw = FillGuide(this->Guide.Data, array, guide);
    }
    else // the name is that of an array of the touched data
    {
      mode->SetArrayName(array.c_str());
    }
    if (!ReadFunctionText(strength, mode->GetStrength()) ||
      (mode->HasSecondStrength() && !ReadFunctionText(second, mode->GetSecondStrength())))
    {
      flaw = "has a strength that is not a number of newtons. Give one, or pairs such as "
             "\"0 0, 0.5 2\"";
    }
    filter->AddMode(mode);
  }
  if (!flaw.empty())
  {
    error += "The row \"" + kind + "\", \"" + array + "\", \"" + strength + "\", \"" + second +
      "\" of Modes " + flaw + ". ";
  }
}
