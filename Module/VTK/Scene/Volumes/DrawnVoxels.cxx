// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Volumes/DrawnVoxels.h"

#include "vtkContourValues.h"
#include "vtkDataSetAttributes.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVersionMacros.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace VolumeHaptics
{
namespace
{

enum Kind
{
  Nothing,
  Binary,
  Labels,
  Isosurfaces,
  Cells
};

constexpr unsigned char Hidden = vtkDataSetAttributes::HIDDENPOINT;

/** Whether values have opacity: a table over their range. */
class OpacityTable
{
public:
  OpacityTable(vtkPiecewiseFunction* function, const double range[2])
    : Low(range[0])
    , PerValue(range[1] > range[0] ? (Size - 1) / (range[1] - range[0]) : 0.0)
    , Values(Size)
  {
    function->GetTable(range[0], range[1], Size, this->Values.data());
  }
  bool IsDrawn(double value) const
  {
    const double at = std::round((value - this->Low) * this->PerValue);
    return this->Values[static_cast<std::size_t>(std::clamp(at, 0.0, Size - 1.0))] > 0.0;
  }

private:
  static constexpr int Size = 4096;
  double Low;
  double PerValue;
  std::vector<double> Values;
};

template <typename T>
void HideBinary(const T* mask, vtkUnsignedCharArray* flags)
{
  unsigned char* flag = flags->GetPointer(0);
  for (vtkIdType i = 0; i < flags->GetNumberOfValues(); ++i)
  {
    flag[i] |= mask[i] > T(0) ? 0 : Hidden;
  }
}

/**
 * Visibility by label: the opacity of the label's own function, if it has one, at the voxel's
 * value.
 */
void HideByLabels(const DrawnImage& drawn, vtkDataArray* labels, vtkUnsignedCharArray* flags)
{
  double range[2];
  drawn.Array->GetRange(range, drawn.Component);
  const int whole = drawn.Property->GetIndependentComponents() ? drawn.Component : 0;
  const OpacityTable others(drawn.Property->GetScalarOpacity(whole), range);
  std::map<int, OpacityTable> tables;
  for (const int label : drawn.Property->GetLabelMapLabels())
  {
    if (vtkPiecewiseFunction* const own = drawn.Property->GetLabelScalarOpacity(label))
    {
      tables.emplace(label, OpacityTable(own, range));
    }
  }
  for (vtkIdType i = 0; i < flags->GetNumberOfValues(); ++i)
  {
    const auto own = tables.find(static_cast<int>(labels->GetComponent(i, 0)));
    const OpacityTable& table = own == tables.end() ? others : own->second;
    if (!table.IsDrawn(drawn.Array->GetComponent(i, drawn.Component)))
    {
      flags->SetValue(i, flags->GetValue(i) | Hidden);
    }
  }
}

/** Hides what is outside all isosurfaces: below the lowest one. */
void HideBelow(const DrawnImage& drawn, vtkUnsignedCharArray* flags)
{
  vtkContourValues* const values = drawn.Property->GetIsoSurfaceValues();
  double lowest = HUGE_VAL;
  for (int i = 0; i < values->GetNumberOfContours(); ++i)
  {
    lowest = std::min(lowest, values->GetValue(i));
  }
  for (vtkIdType i = 0; i < flags->GetNumberOfValues(); ++i)
  {
    if (!(drawn.Array->GetComponent(i, drawn.Component) >= lowest))
    {
      flags->SetValue(i, flags->GetValue(i) | Hidden);
    }
  }
}

vtkImageData* FindMask(vtkAbstractVolumeMapper* mapper, int type)
{
  auto* const gpu = vtkGPUVolumeRayCastMapper::SafeDownCast(mapper);
  return gpu && gpu->GetMaskType() == type ? gpu->GetMaskInput() : nullptr;
}

bool DrawsIsosurfaces(vtkAbstractVolumeMapper* mapper)
{
  auto* const regular = vtkVolumeMapper::SafeDownCast(mapper);
  return regular && regular->GetBlendMode() == vtkVolumeMapper::ISOSURFACE_BLEND;
}

} // namespace

vtkImageData* FindBinaryMask(vtkAbstractVolumeMapper* mapper)
{
  return FindMask(mapper, vtkGPUVolumeRayCastMapper::BinaryMaskType);
}

vtkImageData* FindOpacityMask(vtkAbstractVolumeMapper* mapper, vtkVolumeProperty* property)
{
  const std::set<int> labels = property->GetLabelMapLabels();
  const bool hasOpacity = std::any_of(labels.begin(), labels.end(),
    [property](int label) { return property->GetLabelScalarOpacity(label) != nullptr; });
  return hasOpacity ? FindMask(mapper, vtkGPUVolumeRayCastMapper::LabelMapMaskType) : nullptr;
}

bool IsMaskOf(vtkImageData* mask, vtkImageData* image)
{
  vtkDataArray* const values = mask ? mask->GetPointData()->GetScalars() : nullptr;
  return values && values->GetNumberOfTuples() == image->GetNumberOfPoints() &&
    values->HasStandardMemoryLayout() && values->GetNumberOfComponents() == 1 &&
    std::equal(mask->GetDimensions(), mask->GetDimensions() + 3, image->GetDimensions());
}

bool HidesBlanked(vtkAbstractVolumeMapper* mapper, bool areCells)
{
  constexpr bool hidesCells = VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0);
  auto* const smart = vtkSmartVolumeMapper::SafeDownCast(mapper);
  return (hidesCells || !areCells) && !mapper->IsA("vtkFixedPointVolumeRayCastMapper") &&
    !(smart && smart->GetLastUsedRenderMode() == vtkSmartVolumeMapper::RayCastRenderMode);
}

bool DrawnVoxels::Source::operator==(const Source& other) const
{
  return this->Mask == other.Mask && this->Array == other.Array && this->Own == other.Own &&
    this->Time == other.Time && this->Kind == other.Kind && this->Component == other.Component;
}

vtkUnsignedCharArray* DrawnVoxels::FindCells(const DrawnImage& drawn)
{
  vtkUnsignedCharArray* const own = drawn.Image->GetCellGhostArray();
  Source now;
  if (own && HidesBlanked(drawn.Mapper, true))
  {
    now.Kind = Cells;
    now.Own = own;
    now.Time = own->GetMTime();
  }
  if (!(now == this->From))
  {
    this->From = now;
    this->Flags = nullptr;
  }
  this->HasOpacity = false;
  if (now.Kind == Cells && !this->Flags)
  {
    this->Flags = vtkSmartPointer<vtkUnsignedCharArray>::New();
    this->Flags->SetName(vtkDataSetAttributes::GhostArrayName());
    this->Flags->SetNumberOfValues(own->GetNumberOfValues());
    std::transform(own->GetPointer(0), own->GetPointer(0) + own->GetNumberOfValues(),
      this->Flags->GetPointer(0),
      [](unsigned char flag) -> unsigned char
      { return (flag & vtkDataSetAttributes::HIDDENCELL) != 0 ? Hidden : 0; });
  }
  return this->Flags;
}

vtkUnsignedCharArray* DrawnVoxels::Find(const DrawnImage& drawn)
{
  if (drawn.AreCells)
  {
    return this->FindCells(drawn);
  }
  vtkImageData* const binary = FindBinaryMask(drawn.Mapper);
  vtkImageData* const labels = FindOpacityMask(drawn.Mapper, drawn.Property);
  vtkUnsignedCharArray* const own = drawn.Image->GetPointGhostArray();
  const bool hides = HidesBlanked(drawn.Mapper, false);
  const bool hasFlags = own && hides;
  const bool hasValues = drawn.Array &&
    drawn.Array->GetNumberOfTuples() == drawn.Image->GetNumberOfPoints() &&
    drawn.Component < drawn.Array->GetNumberOfComponents();
  Source now;
  now.Own = hasFlags ? own : nullptr;
  now.Time = hasFlags ? own->GetMTime() : 0;
  vtkImageData* const mask = binary ? binary : labels;
  if (hasValues && !drawn.IsIsosurface && DrawsIsosurfaces(drawn.Mapper))
  {
    now.Kind = Isosurfaces;
  }
  else if (IsMaskOf(mask, drawn.Image) && (binary || hasValues))
  {
    now.Kind = binary ? Binary : Labels;
    now.Mask = mask;
    now.Time = std::max(now.Time, mask->GetMTime());
  }
  this->HasOpacity = now.Kind == Labels || now.Kind == Isosurfaces;
  if (this->HasOpacity)
  {
    now.Array = drawn.Array;
    now.Component = drawn.Component;
    now.Time = std::max({ now.Time, drawn.Array->GetMTime(), drawn.Property->GetMTime() });
  }
  if (now.Kind == Nothing && (hides || (!own && !drawn.Image->GetCellGhostArray())))
  {
    this->From = now;
    this->Flags = nullptr;
    return nullptr;
  }
  if (!this->Flags || !(now == this->From))
  {
    this->From = now;
    this->Fill(drawn, mask, hasFlags ? own : nullptr);
  }
  return this->Flags;
}

void DrawnVoxels::Fill(const DrawnImage& drawn, vtkImageData* mask, vtkUnsignedCharArray* own)
{
  this->Flags = vtkSmartPointer<vtkUnsignedCharArray>::New();
  this->Flags->SetName(vtkDataSetAttributes::GhostArrayName());
  this->Flags->SetNumberOfValues(drawn.Image->GetNumberOfPoints());
  this->Flags->FillValue(0);
  if (own)
  {
    std::copy_n(own->GetPointer(0),
      std::min(own->GetNumberOfValues(), this->Flags->GetNumberOfValues()),
      this->Flags->GetPointer(0));
  }
  switch (this->From.Kind)
  {
    case Binary:
    {
      vtkDataArray* const values = mask->GetPointData()->GetScalars();
      switch (values->GetDataType())
      {
        vtkTemplateMacro(
          HideBinary(static_cast<const VTK_TT*>(values->GetVoidPointer(0)), this->Flags));
        default:
          break;
      }
      break;
    }
    case Labels:
      HideByLabels(drawn, mask->GetPointData()->GetScalars(), this->Flags);
      break;
    case Isosurfaces:
      HideBelow(drawn, this->Flags);
      break;
    default:
      break;
  }
}

} // namespace VolumeHaptics
