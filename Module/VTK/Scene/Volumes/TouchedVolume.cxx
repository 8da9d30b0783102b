// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Volumes/TouchedVolume.h"

#include "Core/Math/Vector3.h"
#include "VTK/Filter/HapticBaker.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkContourValues.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkHapticProperty.h"
#include "vtkHapticRemoval.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVersionMacros.h"
#include "vtkVolumeHapticsFilter.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
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
  Isosurfaces
};

constexpr unsigned char Hidden = vtkDataSetAttributes::HIDDENPOINT;

/** Looks up whether values have opacity, in a table over their range. */
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
 * Hides the voxels without opacity. The opacity of a voxel's value is that of its label's function,
 * or of the common function if its label has none.
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

/** Hides the voxels below the lowest isosurface, which are outside all isosurfaces. */
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

vtkImageData* GetMask(vtkAbstractVolumeMapper* mapper, int type)
{
  auto* const gpu = vtkGPUVolumeRayCastMapper::SafeDownCast(mapper);
  return gpu && gpu->GetMaskType() == type ? gpu->GetMaskInput() : nullptr;
}

bool DrawsIsosurfaces(vtkAbstractVolumeMapper* mapper)
{
  auto* const regular = vtkVolumeMapper::SafeDownCast(mapper);
  return regular && regular->GetBlendMode() == vtkVolumeMapper::ISOSURFACE_BLEND;
}

bool IsSamePlace(vtkImageData* a, vtkImageData* b)
{
  return std::equal(a->GetOrigin(), a->GetOrigin() + 3, b->GetOrigin()) &&
    std::equal(a->GetSpacing(), a->GetSpacing() + 3, b->GetSpacing()) &&
    std::equal(a->GetDirectionMatrix()->GetData(), a->GetDirectionMatrix()->GetData() + 9,
      b->GetDirectionMatrix()->GetData());
}

void Connect(vtkVolumeHapticsFilter* filter, vtkAlgorithmOutput* input)
{
  if (filter->GetNumberOfInputConnections(0) == 0 || filter->GetInputConnection(0, 0) != input)
  {
    filter->SetInputConnection(0, input);
  }
}

/** Returns whether a filter already selects this array of data other than an image. */
bool IsNamed(vtkVolumeHapticsFilter* filter, vtkDataArray* array, bool areCells)
{
  vtkInformation* const asked = filter->GetInputArrayInformation(0);
  const char* const name = asked->Get(vtkDataObject::FIELD_NAME());
  const int wanted =
    areCells ? vtkDataObject::FIELD_ASSOCIATION_CELLS : vtkDataObject::FIELD_ASSOCIATION_POINTS;
  return array->GetName() ? name && std::string(name) == array->GetName() &&
      asked->Get(vtkDataObject::FIELD_ASSOCIATION()) == wanted
                          : !name;
}

} // namespace

vtkImageData* GetBinaryMask(vtkAbstractVolumeMapper* mapper)
{
  return GetMask(mapper, vtkGPUVolumeRayCastMapper::BinaryMaskType);
}

vtkImageData* GetOpacityMask(vtkAbstractVolumeMapper* mapper, vtkVolumeProperty* property)
{
  const std::set<int> labels = property->GetLabelMapLabels();
  const bool hasOpacity = std::any_of(labels.begin(), labels.end(),
    [property](int label) { return property->GetLabelScalarOpacity(label) != nullptr; });
  return hasOpacity ? GetMask(mapper, vtkGPUVolumeRayCastMapper::LabelMapMaskType) : nullptr;
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

vtkUnsignedCharArray* MapperFlags::Get(vtkUnsignedCharArray* own, unsigned char hidden, bool isRead)
{
  const vtkMTimeType time = own ? own->GetMTime() : 0;
  if (std::exchange(this->Own, own) != own || std::exchange(this->Time, time) != time)
  {
    this->Flags = nullptr;
    const unsigned char* const begin = own ? own->GetPointer(0) : nullptr;
    const unsigned char* const end = own ? begin + own->GetNumberOfValues() : nullptr;
    if (std::any_of(begin, end,
          [hidden, isRead](unsigned char flag)
          { return flag != 0 && !(isRead && (flag & hidden) != 0); }))
    {
      this->Flags = vtkSmartPointer<vtkUnsignedCharArray>::New();
      this->Flags->SetName(vtkDataSetAttributes::GhostArrayName());
      this->Flags->SetNumberOfValues(own->GetNumberOfValues());
      std::transform(begin, end, this->Flags->GetPointer(0),
        [hidden](unsigned char flag) { return flag != 0 ? hidden : flag; });
    }
  }
  return this->Flags;
}

vtkUnsignedCharArray* DrawnVoxels::GetCells(const DrawnImage& drawn)
{
  const bool hides = !drawn.AreCells && HidesBlanked(drawn.Mapper, false);
  return hides
    ? this->Cells.Get(drawn.Image->GetCellGhostArray(), vtkDataSetAttributes::HIDDENCELL, true)
    : nullptr;
}

vtkUnsignedCharArray* DrawnVoxels::Get(const DrawnImage& drawn)
{
  if (drawn.AreCells)
  {
    this->HasOpacity = false;
    return HidesBlanked(drawn.Mapper, true)
      ? this->Cells.Get(drawn.Image->GetCellGhostArray(), Hidden, false)
      : nullptr;
  }
  vtkImageData* const binary = GetBinaryMask(drawn.Mapper);
  vtkImageData* const labels = GetOpacityMask(drawn.Mapper, drawn.Property);
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
    return hides ? this->Points.Get(own, Hidden, true) : nullptr;
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
    std::transform(own->GetPointer(0),
      own->GetPointer(0) + std::min(own->GetNumberOfValues(), this->Flags->GetNumberOfValues()),
      this->Flags->GetPointer(0),
      [](unsigned char flag) -> unsigned char { return flag != 0 ? Hidden : 0; });
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

TouchedVolume::TouchedVolume() = default;
TouchedVolume::~TouchedVolume() = default;

vtkDataArray* GetDrawnArray(vtkAbstractVolumeMapper* mapper, vtkDataObject* data, bool& areCells)
{
  auto* set = vtkDataSet::SafeDownCast(data);
  if (auto* const blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    it->InitTraversal();
    set =
      it->IsDoneWithTraversal() ? nullptr : vtkDataSet::SafeDownCast(it->GetCurrentDataObject());
  }
  int cells = 0;
  vtkDataArray* const array = set
    ? vtkAbstractMapper::GetScalars(set, mapper->GetScalarMode(), mapper->GetArrayAccessMode(),
        mapper->GetArrayId(), mapper->GetArrayName(), cells)
    : nullptr;
  areCells = cells != 0;
  return array;
}

bool TouchesIsosurface(vtkVolumeHapticsFilter* filter)
{
  const int method = filter->GetMethod();
  return method == vtkVolumeHapticsFilter::SURFACE_PROXY ||
    method == vtkVolumeHapticsFilter::LOCAL_SURFACE;
}

bool FeelsArray(vtkVolumeHapticsFilter* filter, vtkDataArray* array)
{
  vtkDataArray* const felt = filter->GetBaker().GetTouched()[0].Array;
  return felt == array ||
    (felt && array->HasInformation() &&
      array->GetInformation()->Get(vtkHapticRemoval::TOUCHED_ARRAY()) == felt);
}

bool IsComponentDrawn(vtkVolumeProperty* property, vtkDataArray* array, int component)
{
  double range[2];
  array->GetRange(range, component);
  vtkPiecewiseFunction* const opacity = property->GetScalarOpacity(component);
  bool isSeen = opacity->GetValue(range[0]) > 0.0 || opacity->GetValue(range[1]) > 0.0;
  for (int i = 0; i < opacity->GetSize(); ++i)
  {
    double node[4]; // value, opacity, midpoint, sharpness
    opacity->GetNodeValue(i, node);
    isSeen = isSeen || (node[1] > 0.0 && node[0] >= range[0] && node[0] <= range[1]);
  }
  return isSeen && property->GetComponentWeight(component) > 0.0;
}

int ChooseDrawnComponent(
  vtkAbstractVolumeMapper* mapper, vtkVolumeProperty* property, vtkDataArray* array, int wanted)
{
  const int count = array->GetNumberOfComponents();
  auto* const smart = vtkSmartVolumeMapper::SafeDownCast(mapper);
  if (smart && smart->GetVectorMode() == vtkSmartVolumeMapper::COMPONENT && count > 1)
  {
    return std::min(smart->GetVectorComponent(), count - 1);
  }
  if (!property->GetIndependentComponents())
  {
    return count == 2 || count == 4 ? count - 1 : wanted;
  }
  for (int c = 0; c < std::min(count, VTK_MAX_VRCOMP); ++c)
  {
    const int component = (std::max(wanted, 0) + c) % count;
    if (component < VTK_MAX_VRCOMP && IsComponentDrawn(property, array, component))
    {
      return component;
    }
  }
  return wanted;
}

bool PlaceImage(vtkMatrix4x4* matrix, vtkImageData* image, vtkImageData* placed)
{
  constexpr double rounding = 1e-9;
  double origin[4] = { 0.0, 0.0, 0.0, 1.0 };
  std::copy(image->GetOrigin(), image->GetOrigin() + 3, origin);
  matrix->MultiplyPoint(origin, origin);
  Vector3 columns[3];
  double spacing[3];
  double direction[9];
  for (int axis = 0; axis < 3; ++axis)
  {
    double step[4] = { 0.0, 0.0, 0.0, 0.0 };
    for (int row = 0; row < 3; ++row)
    {
      step[row] = image->GetDirectionMatrix()->GetElement(row, axis) * image->GetSpacing()[axis];
    }
    matrix->MultiplyPoint(step, step);
    columns[axis] = { step[0], step[1], step[2] };
    spacing[axis] = Norm(columns[axis]);
    for (int row = 0; row < 3; ++row)
    {
      direction[3 * row + axis] = step[row] / spacing[axis];
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const int next = (axis + 1) % 3;
    const double together = std::abs(Dot(columns[axis], columns[next]));
    // The negated comparison also refuses NaN.
    if (!(together <= rounding * spacing[axis] * spacing[next]) || !(spacing[axis] > 0.0))
    {
      return false;
    }
  }
  placed->SetOrigin(origin);
  placed->SetSpacing(spacing);
  placed->SetDirectionMatrix(direction);
  return true;
}

void MapCropping(vtkVolumeMapper* mapper, vtkImageData* shown, vtkImageData* felt, double planes[6])
{
  mapper->GetCroppingRegionPlanes(planes);
  for (int i = 0; i < 6; ++i)
  {
    const int axis = i / 2;
    const double index = (planes[i] - shown->GetOrigin()[axis]) / shown->GetSpacing()[axis] -
      shown->GetExtent()[2 * axis] + felt->GetExtent()[2 * axis] -
      0.5 * (shown->GetDimensions()[axis] - felt->GetDimensions()[axis]);
    planes[i] = felt->GetOrigin()[axis] + index * felt->GetSpacing()[axis];
  }
}

bool TouchedVolume::FindPlace(const std::vector<DrawnVolume>& drawn)
{
  const auto one = std::find_if(drawn.begin(), drawn.end(),
    [this](const DrawnVolume& candidate) { return candidate.Volume == this->Volume; });
  const bool isDrawn = one != drawn.end();
  if (isDrawn)
  {
    this->Drawn = *one;
    return true;
  }
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  matrix->DeepCopy(this->Volume->GetMatrix());
  this->Drawn = { this->Volume, this->Volume->GetMapper(), 0, matrix, this->Volume };
  return false;
}

vtkAlgorithmOutput* TouchedVolume::GetGivenInput(const CarvedPictures& carved) const
{
  auto* const mapper = vtkVolumeMapper::SafeDownCast(this->Drawn.Mapper);
  return mapper && this->Drawn.Port == 0
    ? carved.GetGivenInput(mapper)
    : this->Drawn.Mapper->GetInputConnection(this->Drawn.Port, 0);
}

void TouchedVolume::Update(vtkVolumeHapticsFilter* filter, const HapticShownTimeSteps& pictures,
  const CarvedPictures& carved)
{
  vtkAlgorithmOutput* const input = this->HasData() ? this->GetGivenInput(carved) : nullptr;
  vtkDataObject* const data =
    input ? input->GetProducer()->GetOutputDataObject(input->GetIndex()) : nullptr;
  if (!data)
  {
    return;
  }
  auto* const shown = vtkImageData::SafeDownCast(data);
  vtkVolumeProperty* const property = this->Volume->GetProperty();
  const bool isPicture = shown && pictures.IsPicture(shown);
  if (!shown)
  {
    Connect(filter, input);
  }
  else if (!isPicture)
  {
    this->Place(input, shown, filter);
  }
  if (!isPicture)
  {
    this->ChooseArray(data, filter);
  }
  filter->GetProperty()->SetVisibilityFrom(this->Voxels.ReplacesOpacity() ? nullptr : property);
  this->Crop(shown, filter);
  filter->SetClippingPlanes(this->Drawn.Mapper->GetClippingPlanes());
}

void TouchedVolume::ChooseArray(vtkDataObject* data, vtkVolumeHapticsFilter* filter)
{
  bool areCells = false;
  vtkDataArray* const array = GetDrawnArray(this->Drawn.Mapper, data, areCells);
  auto* const image = vtkImageData::SafeDownCast(filter->GetInputDataObject(0, 0));
  if (!array)
  {
    return;
  }
  if (image ? !FeelsArray(filter, array) : !IsNamed(filter, array, areCells))
  {
    const int association = !image && areCells ? vtkDataObject::FIELD_ASSOCIATION_CELLS
                                               : vtkDataObject::FIELD_ASSOCIATION_POINTS;
    if (array->GetName())
    {
      filter->SetInputArrayToProcess(0, 0, 0, association, array->GetName());
    }
    else
    {
      filter->SetInputArrayToProcess(0, 0, 0, association, vtkDataSetAttributes::SCALARS);
    }
  }
  const bool areTimeSteps = filter->GetFrames() == vtkVolumeHapticsFilter::COMPONENTS &&
    filter->GetTimeUnitsPerSecond() != 0.0;
  if (!areTimeSteps)
  {
    filter->GetProperty()->SetComponent(this->ChooseComponent(array, filter));
  }
}

int TouchedVolume::ChooseComponent(vtkDataArray* array, vtkVolumeHapticsFilter* filter) const
{
  return array->GetNumberOfComponents() > 1
    ? ChooseDrawnComponent(this->Drawn.Mapper, this->Volume->GetProperty(), array,
        filter->GetProperty()->GetComponent())
    : 0;
}

void TouchedVolume::CopyImage(
  vtkImageData* shown, bool areCells, vtkUnsignedCharArray* flags, vtkUnsignedCharArray* cells)
{
  this->PlacedTime = shown->GetMTime();
  this->ArePlacedCells = areCells;
  this->PlacedFlags = flags;
  this->PlacedCells = cells;
  vtkPointData* const points = this->Placed->GetPointData();
  const char* const name = vtkDataSetAttributes::GhostArrayName();
  if (areCells)
  {
    int extent[6];
    shown->GetExtent(extent);
    for (int axis = 0; axis < 3; ++axis)
    {
      --extent[2 * axis + 1];
    }
    this->Placed->Initialize();
    this->Placed->SetExtent(extent);
    points->ShallowCopy(shown->GetCellData());
    points->RemoveArray(name); // these flags belong to points instead of cells
  }
  else
  {
    this->Placed->ShallowCopy(shown);
  }
  if (flags)
  {
    points->RemoveArray(name);
    points->AddArray(flags);
  }
  if (flags && !HidesBlanked(this->Drawn.Mapper, areCells))
  {
    this->Placed->GetCellData()->RemoveArray(name);
  }
  if (cells)
  {
    this->Placed->GetCellData()->RemoveArray(name);
    this->Placed->GetCellData()->AddArray(cells);
  }
}

void TouchedVolume::Place(
  vtkAlgorithmOutput* input, vtkImageData* shown, vtkVolumeHapticsFilter* filter)
{
  bool areCells = false;
  vtkDataArray* const array = GetDrawnArray(this->Drawn.Mapper, shown, areCells);
  const DrawnImage drawn{ this->Drawn.Mapper, this->Volume->GetProperty(), shown, array, areCells,
    array ? this->ChooseComponent(array, filter) : 0, TouchesIsosurface(filter) };
  const bool isFirst = this->Drawn.Port == 0;
  vtkUnsignedCharArray* const flags = isFirst ? this->Voxels.Get(drawn) : nullptr;
  vtkUnsignedCharArray* const cells = isFirst ? this->Voxels.GetCells(drawn) : nullptr;
  vtkNew<vtkImageData> place;
  place->SetExtent(shown->GetExtent());
  // Leave a sheared image in place: the interactor style warns about it.
  if (!PlaceImage(this->Drawn.Matrix, shown, place))
  {
    place->CopyStructure(shown);
  }
  if (!areCells && !flags && !cells && IsSamePlace(place, shown))
  {
    Connect(filter, input);
    return;
  }
  if (areCells)
  {
    // Move the points to the centres of the cells, where a mapper shows the value of a cell.
    const int* const first = shown->GetExtent();
    double centre[3];
    place->TransformContinuousIndexToPhysicalPoint(0.5, 0.5, 0.5, centre);
    place->SetExtent(first[0], first[1] - 1, first[2], first[3] - 1, first[4], first[5] - 1);
    place->SetOrigin(centre);
  }
  if (this->PlacedTime != shown->GetMTime() || this->ArePlacedCells != areCells ||
    this->PlacedFlags != flags || this->PlacedCells != cells)
  {
    this->CopyImage(shown, areCells, flags, cells);
  }
  if (!IsSamePlace(place, this->Placed))
  {
    this->Placed->SetOrigin(place->GetOrigin());
    this->Placed->SetSpacing(place->GetSpacing());
    this->Placed->SetDirectionMatrix(place->GetDirectionMatrix());
  }
  if (filter->GetInputDataObject(0, 0) != this->Placed)
  {
    filter->SetInputData(0, this->Placed);
  }
}

void TouchedVolume::Crop(vtkImageData* shown, vtkVolumeHapticsFilter* filter)
{
  auto* const mapper = vtkVolumeMapper::SafeDownCast(this->Drawn.Mapper);
  vtkImageData* const felt = filter->GetTouchedImage();
  filter->SetCropping(mapper && mapper->GetCropping());
  if (felt && filter->GetCropping())
  {
    double planes[6];
    MapCropping(mapper, shown ? shown : felt, felt, planes);
    filter->SetCroppingRegionPlanes(planes);
    filter->SetCroppingRegionFlags(mapper->GetCroppingRegionFlags());
  }
}

} // namespace VolumeHaptics
