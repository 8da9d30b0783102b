// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/HapticShownVolumes.h"

#include "VTK/Scene/CarvedPictures.h"
#include "VTK/Scene/HapticShownFrames.h"
#include "VTK/Scene/TouchedVolume.h"
#include "VTK/Scene/WindowVolumes.h"

#include "vtkDataSetAttributes.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkHapticLabelTable.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeHapticsFilter.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/** Each kind of difference is a bit. */
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
    "Its mapper has a mask that hides voxels, but they are still felt. Cure: call "
    "TouchVolume() of the interactor style, which follows a binary mask if vtkVolumeHapticsFilter "
    "has no labels of its own; or give these voxels a label that is not felt "
    "(vtkHapticLabelTable::SetFelt()), or, with vtkImageMask, a value that is not felt." },
  { 16,
    "Its property has a 2-D transfer function, but voxels that this hides are still felt. Cure: "
    "SetTransferFunctionMode(vtkVolumeProperty::TF_1D), or SetVisibilityFrom() of the haptic "
    "property with a volume property whose 1-D opacity hides the same values." },
  { 32,
    "Points or cells of the image are blanked (array vtkGhostType), but still felt. Cure: give "
    "them a value that is not felt, or remove the array." },
};

/** Whether corners of an image are at other positions in a scene than in the world. */
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

/** Whether a mapper's regions leave out a part of an image. */
bool IsCropped(vtkVolumeMapper* mapper, vtkImageData* image)
{
  constexpr int everything = 0x7ffffff;
  if (!mapper->GetCropping() || mapper->GetCroppingRegionFlags() == everything)
  {
    return false;
  }
  // The planes are in the image's own coordinates; the middle region is bit 13.
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

/** Whether a mapper's planes cut off a part of a volume's box. */
bool IsClipped(vtkVolumeMapper* mapper, vtkVolume* volume)
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

/** Whether a filter leaves out the same regions of an image. */
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

/** Whether a filter has all clipping planes of a mapper. */
bool FeelsClipping(vtkVolumeHapticsFilter* filter, vtkVolumeMapper* mapper)
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

/** Whether a mapper's mask hides voxels: a binary one, or labels with an opacity of their own. */
bool HidesByMask(vtkVolumeMapper* mapper, vtkVolumeProperty* property)
{
  auto* const gpu = vtkGPUVolumeRayCastMapper::SafeDownCast(mapper);
  return gpu && gpu->GetMaskInput() &&
    (FindBinaryMask(mapper) || !property->GetLabelMapLabels().empty());
}

/** Whether a filter has a mapper's mask as a label image. */
bool FeelsMask(vtkVolumeHapticsFilter* filter, vtkVolumeMapper* mapper)
{
  vtkImageData* const mask = FindBinaryMask(mapper);
  auto* const labels = vtkImageData::SafeDownCast(filter->GetInputDataObject(3, 0));
  return mask && labels && HasSamplesOf(mask, labels) && filter->GetLabelTable() &&
    !filter->GetLabelTable()->GetFelt(0);
}

bool HasTransferFunction2D(vtkVolumeProperty* property)
{
  return property->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D;
}

} // namespace

std::vector<std::string> HapticShownVolumes::Check(vtkRenderer* renderer, vtkImageData* image,
  vtkVolumeHapticsFilter* filter, const HapticShownFrames& pictures, const CarvedPictures& carved)
{
  std::vector<std::string> warnings;
  std::vector<Known> now;
  for (const DrawnVolume& drawn : FindDrawnVolumes(renderer))
  {
    vtkVolume* const volume = drawn.Volume;
    const auto known = std::find_if(this->All.begin(), this->All.end(),
      [volume](const Known& one) { return one.Volume.GetPointer() == volume; });
    const unsigned int before = known == this->All.end() ? 0 : known->Differences;
    const unsigned int differences = this->FindDifferences(drawn, image, filter, pictures, carved);
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

unsigned int HapticShownVolumes::FindDifferences(const DrawnVolume& drawn, vtkImageData* image,
  vtkVolumeHapticsFilter* filter, const HapticShownFrames& pictures, const CarvedPictures& carved)
{
  vtkVolume* const volume = drawn.Volume;
  vtkVolumeMapper* const mapper = drawn.Mapper;
  vtkImageData* const shown = drawn.Port == 0
    ? carved.FindImage(mapper)
    : vtkImageData::SafeDownCast(mapper->GetInputDataObject(drawn.Port, 0));
  if (!shown || !(HasSamplesOf(shown, image) || pictures.IsPicture(shown)))
  {
    return 0;
  }
  const bool isTrue[] = { IsPlacedElsewhere(drawn.Matrix, shown, image),
    IsCropped(mapper, shown) && !FeelsCropping(filter, mapper, shown, image),
    IsClipped(mapper, volume) && !FeelsClipping(filter, mapper),
    HidesByMask(mapper, volume->GetProperty()) && !FeelsMask(filter, mapper),
    HasTransferFunction2D(volume->GetProperty()), this->HasBlanks(shown) };
  unsigned int differences = 0;
  for (std::size_t i = 0; i < std::size(Differences); ++i)
  {
    differences |= isTrue[i] ? Differences[i].Bit : 0;
  }
  return differences;
}

bool HapticShownVolumes::HasBlanks(vtkImageData* image)
{
  return this->HasBlanks(image->GetPointGhostArray(), vtkDataSetAttributes::HIDDENPOINT, 0) ||
    this->HasBlanks(image->GetCellGhostArray(), vtkDataSetAttributes::HIDDENCELL, 1);
}

bool HapticShownVolumes::HasBlanks(vtkUnsignedCharArray* ghosts, int hidden, int which)
{
  Blanks& last = this->Last[which];
  if (!ghosts)
  {
    return false;
  }
  if (last.Ghosts != ghosts || last.Time != ghosts->GetMTime())
  {
    const unsigned char* const flags = ghosts->GetPointer(0);
    last.HasAny = std::any_of(flags, flags + ghosts->GetNumberOfValues(),
      [hidden](unsigned char flag) { return (flag & hidden) != 0; });
    last.Ghosts = ghosts;
    last.Time = ghosts->GetMTime();
  }
  return last.HasAny;
}

} // namespace VolumeHaptics
