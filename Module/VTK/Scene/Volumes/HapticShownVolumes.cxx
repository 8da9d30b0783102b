// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Volumes/HapticShownVolumes.h"

#include "VTK/Filter/HapticBaker.h"
#include "VTK/Scene/Base/WindowVolumes.h"
#include "VTK/Scene/Volumes/CarvedPicture.h"
#include "VTK/Scene/Volumes/HapticShownTimeSteps.h"
#include "VTK/Scene/Volumes/TouchedVolume.h"

#include "vtkContourValues.h"
#include "vtkDataSetAttributes.h"
#include "vtkHapticLabelTable.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeHapticsFilter.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/** A difference between picture and touch: its bit, and a text with the cure. */
struct Difference
{
  unsigned int Bit;
  const char* Text;
};

const Difference Differences[] = {
  { 1,
    "It is moved, turned or scaled in the scene, but felt at the place of its image. Cure: "
    "TouchVolume() of the interactor style, which follows all but shears, or change the origin, "
    "spacing and direction matrix of the image instead, for example with "
    "vtkImageChangeInformation." },
  { 2,
    "Its mapper crops it, but the hidden part is still felt. Cure: TouchVolume() of the interactor "
    "style, or give vtkVolumeHapticsFilter the same regions with CroppingOn() and "
    "SetCroppingRegionPlanes()." },
  { 4,
    "Its mapper has clipping planes, but the part that they hide is still felt. Cure: "
    "TouchVolume() "
    "of the interactor style, or give vtkVolumeHapticsFilter the mapper's planes with "
    "SetClippingPlanes()." },
  { 8,
    "Its mapper has a mask that hides voxels, but they are still felt. Cure: call TouchVolume() of "
    "the interactor style, which follows masks of as many voxels as the image has; or give these "
    "voxels a label that is not felt (vtkHapticLabelTable::SetFelt()), or, with vtkImageMask, a "
    "value that is not felt." },
  { 16,
    "Its property has a 2-D transfer function, but voxels that this hides are still felt. Cure: "
    "SetTransferFunctionMode(vtkVolumeProperty::TF_1D), or SetVisibilityFrom() of the haptic "
    "property with a volume property whose 1-D opacity hides the same values." },
  { 32,
    "Points or cells of the image are blanked (array vtkGhostType) and not felt, but its mapper "
    "draws them. Cure: TouchVolume() of the interactor style, or remove the array." },
  { 64,
    "Its mapper draws another array than the one that is felt. Cure: TouchVolume() of the "
    "interactor style, or SetInputArrayToProcess(0, 0, 0, association, name) of "
    "vtkVolumeHapticsFilter with the array that SelectScalarArray() of the mapper names." },
  { 128,
    "Its mapper draws another component of its array than the one that is felt. Cure: "
    "TouchVolume() of the interactor style, or SetComponent() of the haptic property." },
  { 256,
    "Several components of its array have opacity, of which only one is felt. Cure: "
    "SetComponentWeight(component, 0.0) of the vtkVolumeProperty for all others, or a vtkVolume "
    "for each, with vtkImageExtractComponents, and AddTouchedVolume() of the interactor style." },
  { 512,
    "Its mapper draws the magnitude of vectors, but a component of them is felt. Cure: "
    "vtkImageMagnitude as the input of the mapper." },
  { 1024,
    "Its mapper projects or slices, so that also hidden parts in front of the picture are felt. "
    "Cure: "
    "SetBlendModeToComposite() of the mapper." },
  { 2048,
    "Its mapper draws isosurfaces, but all of its edges are felt. Cure: SetMethodToSurfaceProxy() "
    "of vtkVolumeHapticsFilter, and SetIsoValue() with one of GetIsoSurfaceValues() of the "
    "vtkVolumeProperty; or SetBlendModeToComposite() of the mapper." },
  { 4096,
    "It is opaque up to all faces of its image, behind which there is no surface to feel. Cure: "
    "vtkImageConstantPad with as many voxels as KernelRadius + 1 on each side, of a value that is "
    "not opaque, as the input of the mapper." },
  { 8192,
    "A part of it is hidden by clipping planes, cropping or a mask, or because it is blanked, and "
    "where that cuts through even tissue, its faces are not felt. Cure: FeelCutFacesOn() of "
    "vtkVolumeHapticsFilter." },
  { 16384,
    "It is moved, turned or scaled in the scene, but its data are no image and felt where they "
    "are. Cure: vtkResampleToImage as the input of the mapper." },
  { 32768,
    "Its mapper hides points or cells by flags other than those of blanked ones (array "
    "vtkGhostType), but they are still felt. Cure: TouchVolume() of the interactor style." },
};

/**
 * Returns whether any corner of an image has different positions in the scene and in the felt
 * image.
 */
bool IsPlacedElsewhere(vtkMatrix4x4* matrix, vtkImageData* shown, vtkImageData* felt)
{
  const int* const here = shown->GetExtent();
  const int* const there = felt->GetExtent();
  const double most = 1e-6 * felt->GetLength();
  for (int corner = 0; corner < 8; ++corner)
  {
    const int x = corner & 1;
    const int y = 2 + (corner >> 1 & 1);
    const int z = 4 + (corner >> 2 & 1);
    double seen[4] = { 0.0, 0.0, 0.0, 1.0 };
    double touched[3];
    shown->TransformIndexToPhysicalPoint(here[x], here[y], here[z], seen);
    matrix->MultiplyPoint(seen, seen);
    felt->TransformIndexToPhysicalPoint(there[x], there[y], there[z], touched);
    for (int c = 0; c < 3; ++c)
    {
      if (!(std::abs(seen[c] - touched[c]) <= most))
      {
        return true;
      }
    }
  }
  return false;
}

/** Returns whether a mapper's cropping regions hide a part of an image. */
bool IsCropped(vtkVolumeMapper* mapper, vtkImageData* image)
{
  constexpr int everything = 0x7ffffff;
  if (!mapper->GetCropping() || mapper->GetCroppingRegionFlags() == everything)
  {
    return false;
  }
  // The planes are in the image's own coordinates; bit 13 is the middle region.
  double planes[6];
  double bounds[6];
  mapper->GetCroppingRegionPlanes(planes);
  image->GetBounds(bounds);
  bool isInMiddle = (mapper->GetCroppingRegionFlags() >> 13 & 1) != 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    isInMiddle = isInMiddle && planes[2 * axis] <= bounds[2 * axis] &&
      planes[2 * axis + 1] >= bounds[2 * axis + 1];
  }
  return !isInMiddle;
}

/** Returns whether a mapper's clipping planes cut a part off a volume's bounds. */
bool IsClipped(vtkAbstractVolumeMapper* mapper, vtkVolume* volume)
{
  vtkPlaneCollection* const planes = mapper->GetClippingPlanes();
  const double* const b = volume->GetBounds();
  for (int i = 0; planes && b && i < planes->GetNumberOfItems(); ++i)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      const double x[3] = { b[corner & 1], b[2 + (corner >> 1 & 1)], b[4 + (corner >> 2 & 1)] };
      if (planes->GetItem(i)->EvaluateFunction(x[0], x[1], x[2]) < 0.0)
      {
        return true;
      }
    }
  }
  return false;
}

/** Returns whether a filter's cropping cuts away the same regions as a mapper's. */
bool FeelsCropping(
  vtkVolumeHapticsFilter* filter, vtkVolumeMapper* mapper, vtkImageData* shown, vtkImageData* felt)
{
  if (!filter->GetCropping() ||
    filter->GetCroppingRegionFlags() != mapper->GetCroppingRegionFlags())
  {
    return false;
  }
  double planes[6];
  MapCropping(mapper, shown, felt, planes);
  const double* const own = filter->GetCroppingRegionPlanes();
  const double most = 1e-6 * felt->GetLength();
  return std::equal(
    planes, planes + 6, own, [most](double a, double b) { return std::abs(a - b) <= most; });
}

/** Returns whether a filter has all clipping planes of a mapper. */
bool FeelsClipping(vtkVolumeHapticsFilter* filter, vtkAbstractVolumeMapper* mapper)
{
  vtkPlaneCollection* const own = filter->GetClippingPlanes();
  vtkPlaneCollection* const planes = mapper->GetClippingPlanes();
  for (int i = 0; own && i < planes->GetNumberOfItems(); ++i)
  {
    if (!own->IsItemPresent(planes->GetItem(i)))
    {
      return false;
    }
  }
  return own != nullptr;
}

/** Returns whether a filter uses a mapper's mask as its label image. */
bool FeelsMask(vtkVolumeHapticsFilter* filter, vtkAbstractVolumeMapper* mapper)
{
  vtkImageData* const mask = GetBinaryMask(mapper);
  auto* const labels = vtkImageData::SafeDownCast(filter->GetInputDataObject(3, 0));
  return mask && labels && HasSamplesOf(mask, labels) && filter->GetLabelTable() &&
    !filter->GetLabelTable()->GetFelt(0);
}

bool HasTransferFunction2D(vtkVolumeProperty* property)
{
  return property->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D;
}

bool HasMagnitude(vtkAbstractVolumeMapper* mapper)
{
  auto* const smart = vtkSmartVolumeMapper::SafeDownCast(mapper);
  return smart && smart->GetVectorMode() == vtkSmartVolumeMapper::MAGNITUDE;
}

bool AreSeveralDrawn(
  vtkAbstractVolumeMapper* mapper, vtkVolumeProperty* property, vtkDataArray* array)
{
  auto* const smart = vtkSmartVolumeMapper::SafeDownCast(mapper);
  int count = 0;
  for (int c = 0; c < std::min(array->GetNumberOfComponents(), VTK_MAX_VRCOMP); ++c)
  {
    count += IsComponentDrawn(property, array, c) ? 1 : 0;
  }
  return count > 1 && property->GetIndependentComponents() &&
    !(smart && smart->GetVectorMode() == vtkSmartVolumeMapper::COMPONENT);
}

/** Returns whether a filter touches any of the isosurfaces that a mapper draws. */
bool FeelsIso(vtkVolumeHapticsFilter* filter, vtkVolumeProperty* property)
{
  vtkContourValues* const values = property->GetIsoSurfaceValues();
  bool isDrawn = false;
  for (int i = 0; i < values->GetNumberOfContours(); ++i)
  {
    isDrawn = isDrawn || values->GetValue(i) == filter->GetIsoValue();
  }
  return isDrawn && TouchesIsosurface(filter);
}

/** Returns whether most samples on a face of an image are opaque, judged by a subset. */
bool IsOpaque(vtkDataArray* array, int component, const int dimensions[3], int face,
  vtkPiecewiseFunction* opacity)
{
  constexpr int looks = 24; // samples along an axis
  constexpr double opaque = 0.5;
  const int axis = face / 2;
  const int others[2] = { (axis + 1) % 3, (axis + 2) % 3 };
  vtkIdType strides[3] = { 1, dimensions[0],
    static_cast<vtkIdType>(dimensions[0]) * dimensions[1] };
  const vtkIdType first = face % 2 == 0 ? 0 : strides[axis] * (dimensions[axis] - 1);
  int count = 0;
  for (int j = 0; j < looks; ++j)
  {
    for (int i = 0; i < looks; ++i)
    {
      const vtkIdType at = first + strides[others[0]] * (dimensions[others[0]] * i / looks) +
        strides[others[1]] * (dimensions[others[1]] * j / looks);
      count += opacity->GetValue(array->GetComponent(at, component)) >= opaque ? 1 : 0;
    }
  }
  return 2 * count > looks * looks;
}

} // namespace

std::vector<std::string> HapticShownVolumes::Check(vtkRenderer* renderer, vtkImageData* image,
  vtkVolumeHapticsFilter* filter, const HapticShownTimeSteps& pictures,
  const CarvedPictures& carved, vtkVolume* followed)
{
  std::vector<std::string> warnings;
  std::vector<Known> now;
  for (const DrawnVolume& drawn : CollectDrawnVolumes(renderer))
  {
    vtkVolume* const volume = drawn.Volume;
    const auto known = std::find_if(this->All.begin(), this->All.end(),
      [volume](const Known& one) { return one.Volume.GetPointer() == volume; });
    const unsigned int before = known == this->All.end() ? 0 : known->Differences;
    const unsigned int differences =
      this->DetectDifferences(drawn, image, filter, pictures, carved, followed);
    std::string text;
    for (const Difference& one : Differences)
    {
      text += one.Bit & differences & ~before ? std::string(" ") + one.Text : std::string();
    }
    if (!text.empty())
    {
      warnings.push_back(
        "A volume in the renderer is felt differently from how it is shown." + text);
    }
    now.push_back({ volume, differences });
  }
  this->All = std::move(now);
  return warnings;
}

unsigned int HapticShownVolumes::DetectDifferences(const DrawnVolume& drawn, vtkImageData* image,
  vtkVolumeHapticsFilter* filter, const HapticShownTimeSteps& pictures,
  const CarvedPictures& carved, vtkVolume* followed)
{
  vtkVolume* const volume = drawn.Volume;
  vtkVolumeProperty* const property = volume->GetProperty();
  auto* const mapper = vtkVolumeMapper::SafeDownCast(drawn.Mapper);
  vtkDataObject* const data =
    mapper && drawn.Port == 0 ? static_cast<vtkDataObject*>(carved.GetImage(mapper)) : nullptr;
  vtkDataObject* const drawnData = data ? data : drawn.GetData();
  auto* const shown = vtkImageData::SafeDownCast(drawnData);
  const bool isPicture = shown && pictures.IsPicture(shown);
  const bool isFollowed = volume == followed;
  const bool isFelt = isFollowed || isPicture || (shown && HasSamplesOf(shown, image)) ||
    (!shown && drawnData == filter->GetInputDataObject(0, 0));
  if (!drawnData || !isFelt)
  {
    return 0;
  }
  bool areCells = false;
  vtkDataArray* const array = GetDrawnArray(drawn.Mapper, drawnData, areCells);
  const int felt = filter->GetProperty()->GetComponent();
  const bool hasTimeSteps = isPicture || filter->GetFrames() == vtkVolumeHapticsFilter::COMPONENTS;
  const bool hasComponents = array && array->GetNumberOfComponents() > 1 && !hasTimeSteps;
  vtkImageData* const binary = GetBinaryMask(drawn.Mapper);
  vtkImageData* const mask = binary ? binary : GetOpacityMask(drawn.Mapper, property);
  const int blend = mapper ? mapper->GetBlendMode() : vtkVolumeMapper::COMPOSITE_BLEND;
  const bool isIso = blend == vtkVolumeMapper::ISOSURFACE_BLEND;
  const bool isMagnitude = HasMagnitude(drawn.Mapper) && hasComponents;
  const bool isCropped = mapper && shown && IsCropped(mapper, shown);
  const bool isClipped = IsClipped(drawn.Mapper, volume);
  const bool hides = HidesBlanked(drawn.Mapper, areCells);
  const bool isTrue[] = { shown && !areCells && IsPlacedElsewhere(drawn.Matrix, shown, image),
    isCropped && !FeelsCropping(filter, mapper, shown, image),
    isClipped && !FeelsClipping(filter, drawn.Mapper),
    mask && !(isFollowed && !areCells && shown && IsMaskOf(mask, shown)) &&
      !FeelsMask(filter, drawn.Mapper),
    HasTransferFunction2D(property),
    shown && !isFollowed && !hides && this->HasBlanks(shown, false, false),
    array && shown && !isPicture && !areCells && !FeelsArray(filter, array),
    hasComponents && !isMagnitude &&
      ChooseDrawnComponent(drawn.Mapper, property, array, felt) != felt,
    hasComponents && !isMagnitude && AreSeveralDrawn(drawn.Mapper, property, array), isMagnitude,
    blend != vtkVolumeMapper::COMPOSITE_BLEND && !isIso, isIso && !FeelsIso(filter, property),
    isFollowed && shown && !isIso && !mapper->GetCropping() && this->IsFull(image, filter),
    isFollowed && !filter->GetFeelCutFaces() &&
      (isCropped || isClipped ||
        (shown && (mask || (hides && this->HasBlanks(shown, areCells, true))))),
    !shown && !drawn.Matrix->IsIdentity(),
    shown && !isFollowed && !areCells && hides && this->HasBlanks(shown, false, true) &&
      !this->HasBlanks(shown, false, false) };
  static_assert(std::size(isTrue) == std::size(Differences));
  unsigned int differences = 0;
  for (std::size_t i = 0; i < std::size(Differences); ++i)
  {
    differences |= isTrue[i] ? Differences[i].Bit : 0;
  }
  return differences;
}

bool HapticShownVolumes::IsFull(vtkImageData* image, vtkVolumeHapticsFilter* filter)
{
  vtkDataArray* const array = filter->GetBaker().GetTouched()[0].Array;
  vtkVolumeProperty* const seen = filter->GetProperty()->GetVisibilityFrom();
  const int component = filter->GetProperty()->GetComponent();
  if (!array || !seen || component >= array->GetNumberOfComponents() ||
    array->GetNumberOfTuples() != image->GetNumberOfPoints() || component >= VTK_MAX_VRCOMP)
  {
    return false;
  }
  const vtkMTimeType time = std::max({ filter->GetMTime(), image->GetMTime(), array->GetMTime() });
  if (std::exchange(this->LastFilled.Time, time) != time)
  {
    vtkPiecewiseFunction* const opacity =
      seen->GetScalarOpacity(seen->GetIndependentComponents() ? component : 0);
    this->LastFilled.IsTrue = true;
    for (int face = 0; face < 6 && this->LastFilled.IsTrue; ++face)
    {
      this->LastFilled.IsTrue = IsOpaque(array, component, image->GetDimensions(), face, opacity);
    }
  }
  return this->LastFilled.IsTrue;
}

bool HapticShownVolumes::HasBlanks(vtkImageData* image, bool areCells, bool byAnyFlag)
{
  const auto hasFlag = [this, byAnyFlag](vtkUnsignedCharArray* ghosts, int hidden, Blanks& last)
  {
    if (ghosts && (last.Ghosts != ghosts || last.Time != ghosts->GetMTime()))
    {
      const unsigned char* const flags = ghosts->GetPointer(0);
      last.Flags = std::accumulate(
        flags, flags + ghosts->GetNumberOfValues(), 0, [](int all, int one) { return all | one; });
      last.Ghosts = ghosts;
      last.Time = ghosts->GetMTime();
    }
    return ghosts && (byAnyFlag ? last.Flags : last.Flags & hidden) != 0;
  };
  return (!areCells &&
           hasFlag(
             image->GetPointGhostArray(), vtkDataSetAttributes::HIDDENPOINT, this->Last[0])) ||
    hasFlag(image->GetCellGhostArray(), vtkDataSetAttributes::HIDDENCELL, this->Last[1]);
}

} // namespace VolumeHaptics
