// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticModeRows.h"

#include "HapticFunctionText.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkHapticGuideMode.h"
#include "vtkHapticRidgeMode.h"
#include "vtkHapticShearMode.h"
#include "vtkHapticSurfaceMode.h"
#include "vtkHapticTensorFollowMode.h"
#include "vtkHapticVectorFollowMode.h"
#include "vtkHapticVectorFrontMode.h"
#include "vtkHapticVortexMode.h"
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

/** A kind of mode by its name in a row, and its second function. */
struct ModeOfRow
{
  const char* Kind;
  vtkSmartPointer<vtkHapticMode> (*Make)();
  vtkPiecewiseFunction* (*GetSecond)(vtkHapticMode* mode); ///< null: no second function
};

template <typename Mode>
vtkSmartPointer<vtkHapticMode> MakeModeOfRow()
{
  return vtkSmartPointer<Mode>::New();
}

vtkSmartPointer<vtkHapticMode> MakeTwoSidedFront()
{
  auto front = vtkSmartPointer<vtkHapticVectorFrontMode>::New();
  front->TwoSidedOn();
  return front;
}

vtkSmartPointer<vtkHapticMode> MakeDarkRidge()
{
  auto ridge = vtkSmartPointer<vtkHapticRidgeMode>::New();
  ridge->SetPolarityToDark();
  return ridge;
}

template <int Side>
vtkSmartPointer<vtkHapticMode> MakeGuide()
{
  auto guide = vtkSmartPointer<vtkHapticGuideMode>::New();
  guide->SetSide(Side);
  return guide;
}

constexpr ModeOfRow ModesOfRows[] = {
  { "VectorFollow", &MakeModeOfRow<vtkHapticVectorFollowMode>,
    [](vtkHapticMode* mode) { return vtkHapticVectorFollowMode::SafeDownCast(mode)->GetPush(); } },
  { "VectorFront", &MakeModeOfRow<vtkHapticVectorFrontMode>, nullptr },
  { "VectorFrontTwoSided", &MakeTwoSidedFront, nullptr },
  { "Vortex", &MakeModeOfRow<vtkHapticVortexMode>,
    [](vtkHapticMode* mode)
    { return vtkHapticVortexMode::SafeDownCast(mode)->GetAxisStrength(); } },
  { "Shear", &MakeModeOfRow<vtkHapticShearMode>, nullptr },
  { "TensorFollow", &MakeModeOfRow<vtkHapticTensorFollowMode>,
    [](vtkHapticMode* mode)
    { return vtkHapticTensorFollowMode::SafeDownCast(mode)->GetSheetStrength(); } },
  { "Ridge", &MakeModeOfRow<vtkHapticRidgeMode>, nullptr },
  { "RidgeDark", &MakeDarkRidge, nullptr },
  { "Surface", &MakeModeOfRow<vtkHapticSurfaceMode>, nullptr },
  { "Guide", &MakeGuide<vtkHapticGuideMode::SURFACE>, nullptr },
  { "GuideOutside", &MakeGuide<vtkHapticGuideMode::OUTSIDE>, nullptr },
  { "GuideInside", &MakeGuide<vtkHapticGuideMode::INSIDE>, nullptr },
};

/**
 * The distances of an image, the active scalars or an array, as a field; null if there are none. An
 * image that is not computed yet gives an empty field, which is filled later.
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

/** Gives polygons, lines or distances to a guide; returns the error if that fails. */
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
    return "has nothing that guides. Choose polygons or lines as Surface, or an image of distances";
  }
  const bool isPath = shape->GetNumberOfLines() > 0 && shape->GetNumberOfPolys() == 0 &&
    shape->GetNumberOfStrips() == 0;
  if (isPath && guide->GetSide() != vtkHapticGuideMode::SURFACE)
  {
    return "is about a side, but the Surface has lines, which have none. Give the kind Guide, or "
           "choose polygons as Surface";
  }
  guide->SetPath(isPath ? shape : nullptr);
  guide->SetSurface(isPath ? nullptr : shape);
  return {};
}

/** The first data set in data that may be composite; null if there is none. */
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

/** The first array of vectors or tensors, unless one is active; else empty. */
std::string FindArray(vtkDataObject* data, bool isTensor)
{
  vtkDataSet* const set = FindFirstSet(data);
  vtkPointData* const points = set ? set->GetPointData() : nullptr;
  if (!points || (isTensor ? points->GetTensors() : points->GetVectors()))
  {
    return {};
  }
  for (int i = 0; i < points->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = points->GetArray(i);
    const int components = array && array->GetName() ? array->GetNumberOfComponents() : 0;
    if (isTensor ? components == 6 || components == 9 : components == 3)
    {
      return array->GetName();
    }
  }
  return {};
}

} // namespace

//------------------------------------------------------------------------------
bool HapticModeRows::Seen::Note(vtkDataObject* data)
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
  const bool hasData = this->Preset != "None" && this->Input.Note(dataOf(0));
  const bool hasGuide = this->HasGuide() && this->Guide.Note(dataOf(2));
  if (!this->IsDirty && !hasData && !hasGuide)
  {
    return {};
  }
  this->IsDirty = false; // the calls below call this function again
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
    const bool isOfScalars =
      vtkHapticRidgeMode::SafeDownCast(mode) || vtkHapticSurfaceMode::SafeDownCast(mode);
    if (!isOfScalars)
    {
      const bool isTensor = vtkHapticTensorFollowMode::SafeDownCast(mode) != nullptr;
      mode->SetArrayName(FindArray(this->Input.Data, isTensor).c_str());
    }
    filter->AddMode(mode);
  }
}

//------------------------------------------------------------------------------
void HapticModeRows::AddRow(
  const Row& row, vtkVolumeHapticsFilter* filter, std::string& error) const
{
  const auto& [kind, array, strength, second] = row;
  const auto* const found = std::find_if(std::begin(ModesOfRows), std::end(ModesOfRows),
    [name = &kind](const ModeOfRow& known) { return *name == known.Kind; });
  std::string flaw;
  if (found == std::end(ModesOfRows))
  {
    flaw = "has no kind of mode. Give one of";
    for (const ModeOfRow& known : ModesOfRows)
    {
      flaw += std::string(" ") + known.Kind;
    }
  }
  else if (!found->GetSecond && !second.empty())
  {
    flaw = "has a second strength, which this kind has none of. Leave it empty";
  }
  else
  {
    const vtkSmartPointer<vtkHapticMode> mode = found->Make();
    if (auto* const guide = vtkHapticGuideMode::SafeDownCast(mode))
    {
      flaw = FillGuide(this->Guide.Data, array, guide);
    }
    else // an array of the touched data
    {
      mode->SetArrayName(array.c_str());
    }
    if (!ReadFunctionText(strength, mode->GetStrength()) ||
      (found->GetSecond && !ReadFunctionText(second, found->GetSecond(mode))))
    {
      flaw = "has a strength that is no number of newtons. Give one, or pairs such as "
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
