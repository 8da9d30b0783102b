// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Display/DisplayText.h"

#include "VTK/Filter/HapticBaker.h"
#include "VTK/Measure/MeasurementUnits.h"
#include "VTK/Scene/Hand/DrawnTool.h"
#include "VTK/Tools/ToolKind.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkHapticDevice.h"
#include "vtkHapticLabelTable.h"
#include "vtkHapticMeasurements.h"
#include "vtkHapticMode.h"
#include "vtkHapticProperty.h"
#include "vtkHapticRemoval.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace VolumeHaptics
{
namespace
{

/** Smallest force (N) that counts as felt. */
constexpr double LeastForce = 0.005;

bool AreModesFelt(vtkVolumeHapticsFilter* filter)
{
  return filter && filter->GetMethod() == vtkVolumeHapticsFilter::PRIMITIVES;
}

/** Returns whether only modes without a surface that could support a hand are felt. */
bool AreOnlyFieldsFelt(vtkVolumeHapticsFilter* filter)
{
  if (!AreModesFelt(filter))
  {
    return false;
  }
  for (int i = 0; i < filter->GetNumberOfModes(); ++i)
  {
    vtkHapticMode* const mode = filter->GetMode(i);
    if (mode->GetActive() && mode->GetKind() == vtkHapticMode::SURFACE)
    {
      return false;
    }
  }
  return true;
}

/**
 * Describes an inserted needle, except its depth and the tissue; empty in the tick that inserts it.
 */
std::string DescribeNeedle(vtkHapticDevice* device)
{
  vtkNew<vtkPolyData> track;
  device->GetState()->GetNeedleTrack(track);
  const auto number = [&track](const char* name)
  {
    vtkDataArray* const array = track->GetFieldData()->GetArray(name);
    return array ? array->GetComponent(0, 0) : 0.0;
  };
  const vtkIdType layers = track->GetNumberOfCells();
  if (layers == 0)
  {
    return {};
  }
  const auto touches = static_cast<int>(number("ForbiddenTouches"));
  std::ostringstream text;
  text << std::fixed << std::setprecision(0);
  if (number("Angle") >= 0.0)
  {
    text << number("Angle") << " degrees from upright, ";
  }
  text << layers << (layers == 1 ? " layer" : " layers");
  if (touches > 0)
  {
    text << ", forbidden tissue touched " << touches << (touches == 1 ? " time" : " times");
  }
  return text.str();
}

/**
 * Describes the torque (N mm) of a tool with a shape; empty without such a tool or without torque.
 */
std::string DescribeTorque(vtkHapticDevice* device)
{
  const double torque = 1e3 * vtkMath::Norm(device->GetState()->GetComputedTorque());
  const ToolKind* const kind = FindToolKind(GetHeldTool(device));
  if (!kind || !kind->IsTurnable() || kind->TurnsWithStylus() || !(torque >= 0.05))
  {
    return {};
  }
  std::ostringstream text;
  text << ", turned by " << std::fixed << std::setprecision(1) << torque << " N mm";
  return text.str();
}

/** Describes the detected shift between stored values and HU; empty without one. */
std::string DescribeShift(vtkHapticDevice* device)
{
  vtkVolumeHapticsFilter* const filter = device->GetVolumeHaptics();
  const double shift = filter ? filter->GetProperty()->GetFoundShift() : 0.0;
  std::ostringstream text;
  text << " HU (stored as HU + " << -shift << ")";
  return shift == 0.0 ? std::string() : text.str();
}

} // namespace

std::string DescribeStatus(vtkHapticDevice* device)
{
  const std::string status = device->GetStatusText();
  if (status.rfind("Running: virtual.", 0) == 0 || status.rfind("Active: virtual.", 0) == 0)
  {
    return {};
  }
  const std::size_t sentence = status.find(". ");
  if (sentence == std::string::npos)
  {
    return status;
  }
  const int code = device->GetStatus();
  // Include the second sentence, too, if it tells the hand what to do. For a mouse user, the hint
  // says this instead.
  const bool asksHand = (code == vtkHapticDevice::FAULT && device->GetDeviceId() != "virtual") ||
    code == vtkHapticDevice::HOMING || code == vtkHapticDevice::FIRMWARE;
  const std::string first = status.substr(0, sentence + 1);
  return asksHand ? first + "\n" + status.substr(sentence + 2) : first;
}

std::string DescribeTouch(vtkHapticDevice* device, const std::string& tissue, bool slides)
{
  static const char* const contacts[] = { "", "Resting on ", "Sliding over ", "Pushed through " };
  const int now = device->GetState()->GetContact() & 3;
  const int contact = now == 1 || now == 2 ? (slides ? 2 : 1) : now;
  const double force = vtkMath::Norm(device->GetState()->GetForce());
  if (force < LeastForce && (contact == 0 || device->GetStatus() != vtkHapticDevice::ACTIVE))
  {
    return {};
  }
  std::ostringstream text;
  const double depth = device->GetState()->GetNeedleDepth();
  vtkVolumeHapticsFilter* const filter = device->GetVolumeHaptics();
  if (filter && device->GetState()->IsSpinning())
  {
    vtkHapticRemoval* const removal = filter->GetRemoval();
    const double removed = removal->GetRemovedVolume();
    text << "Drilling, " << std::fixed << std::setprecision(removed < 10.0 ? 1 : 0) << removed
         << " mm^3 removed" << (removal->IsUsedUp() ? " (memory for holes is full)" : "");
  }
  else if (depth > 0.0)
  {
    const LengthUnit unit = ChooseLengthUnit(filter ? filter->GetMetersPerWorldUnit() : 0.001);
    text << "Needle " << std::fixed << std::setprecision(1) << unit.PerWorldUnit * depth << " "
         << unit.Name << " deep" << (tissue.empty() ? "" : " in ") << tissue;
  }
  else if (AreOnlyFieldsFelt(device->GetVolumeHaptics()))
  {
    static const char* const guidance[] = { "Pushed", "Held", "Guided", "Guided" };
    text << guidance[contact] << (tissue.empty() ? "" : " in ") << tissue;
  }
  else
  {
    text << (contact == 0 ? "Force of " : contacts[contact])
         << (tissue.empty() ? "the volume" : tissue);
  }
  text << ", " << std::fixed << std::setprecision(2) << force << " N of at most "
       << std::defaultfloat << std::setprecision(3) << device->GetMaximumForce() << " N"
       << DescribeTorque(device);
  const std::string needle = depth > 0.0 ? DescribeNeedle(device) : std::string();
  text << (needle.empty() ? "" : "\n") << needle;
  return text.str();
}

std::string DescribeCut(vtkHapticDevice* device)
{
  vtkVolumeHapticsFilter* const filter = device->GetVolumeHaptics();
  vtkPlaneCollection* const planes = filter ? filter->GetClippingPlanes() : nullptr;
  const bool isCut =
    filter && (filter->GetCropping() || (planes && planes->GetNumberOfItems() > 0));
  if (!isCut)
  {
    return {};
  }
  return filter->GetFeelCutFaces() ? "Cut open, its faces are felt"
                                   : "Cut open, its faces are not felt";
}

double ComputeFeltValue(vtkHapticDevice* device)
{
  vtkVolumeHapticsFilter* const filter = device->GetVolumeHaptics();
  const double scalar = device->GetState()->GetSurfaceValue();
  return filter ? filter->GetProperty()->ScalarToValue(scalar) : scalar;
}

double ComputeTissueValue(vtkHapticDevice* device)
{
  constexpr double depth = 2.0; // voxels
  vtkVolumeHapticsFilter* const filter = device->GetVolumeHaptics();
  vtkImageData* const image = filter ? filter->GetTouchedImage() : nullptr;
  vtkDataArray* const scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  const int component = filter ? filter->GetProperty()->GetComponent() : 0;
  // The image of a moving volume is not the felt time step.
  if (!scalars || component >= scalars->GetNumberOfComponents() ||
    device->GetPlayback()->HasTimeSteps())
  {
    return ComputeFeltValue(device);
  }
  const double* const spacing = image->GetSpacing();
  const double* const surface = device->GetState()->GetSurfacePosition();
  const double* const normal = device->GetState()->GetNormal();
  double below[3];
  for (int i = 0; i < 3; ++i)
  {
    below[i] = surface[i] + depth * std::min({ spacing[0], spacing[1], spacing[2] }) * normal[i];
  }
  double index[3];
  image->TransformPhysicalPointToContinuousIndex(below, index);
  const int* const extent = image->GetExtent();
  int voxel[3];
  for (int i = 0; i < 3; ++i)
  {
    voxel[i] = static_cast<int>(std::lround(index[i]));
    if (voxel[i] < extent[2 * i] || voxel[i] > extent[2 * i + 1])
    {
      return ComputeFeltValue(device);
    }
  }
  const double scalar = scalars->GetComponent(image->ComputePointId(voxel), component);
  return filter->GetProperty()->ScalarToValue(scalar);
}

std::string NameTissue(vtkHapticProperty* property, double value)
{
  std::string name;
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < property->GetNumberOfTissues(); ++i)
  {
    double range[2];
    property->GetTissueRange(i, range);
    const double away = std::max({ range[0] - value, value - range[1], 0.0 });
    if (away < nearest)
    {
      nearest = away;
      name = property->GetTissueName(i);
    }
  }
  return name;
}

std::string DescribeDetails(vtkHapticDevice* device)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(0);
  if (!AreModesFelt(device->GetVolumeHaptics()))
  {
    text << "Value " << ComputeFeltValue(device) << DescribeShift(device) << ", ";
  }
  text << device->GetTickRate() << " ticks/s, " << device->GetMissedTicks() << " missed";
  return text.str();
}

vtkVolumeHapticsFilter* GetModesFilter(vtkHapticDevice* device)
{
  vtkVolumeHapticsFilter* const filter = device ? device->GetVolumeHaptics() : nullptr;
  return filter && filter->GetMethod() == vtkVolumeHapticsFilter::PRIMITIVES ? filter : nullptr;
}

std::vector<std::string> NameModes(vtkHapticDevice* device)
{
  std::vector<std::string> names;
  vtkVolumeHapticsFilter* const filter = GetModesFilter(device);
  for (int i = 0; filter && i < filter->GetNumberOfModes(); ++i)
  {
    names.push_back(std::to_string(i + 1) + " " + filter->GetMode(i)->GetText());
  }
  return names;
}

std::vector<std::string> NameActiveModes(vtkHapticDevice* device)
{
  std::vector<std::string> names = NameModes(device);
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const bool isActive = GetModesFilter(device)->GetMode(static_cast<int>(i))->GetActive();
    names[i] = isActive ? names[i] : std::string();
  }
  return names;
}

std::vector<ModeLine> DescribeModeForces(vtkHapticDevice* device)
{
  std::vector<ModeLine> lines;
  for (const std::string& name : NameModes(device))
  {
    const auto mode = static_cast<int>(lines.size());
    const bool isActive = GetModesFilter(device)->GetMode(mode)->GetActive();
    std::ostringstream text;
    text << name << ": " << std::fixed << std::setprecision(2);
    isActive ? text << vtkMath::Norm(device->GetState()->GetModeForce(mode)) << " N"
             : text << "off";
    lines.push_back({ text.str(), isActive });
  }
  return lines;
}

std::string ListMeasurements(vtkHapticMeasurements* measurements)
{
  constexpr vtkIdType most = 8;
  const vtkIdType count = measurements->GetNumberOfMeasurements();
  const vtkIdType first = std::max<vtkIdType>(count - most, 0);
  std::string text = first > 0 ? "... " + std::to_string(first) + " more\n" : std::string();
  for (vtkIdType i = first; i < count; ++i)
  {
    text += measurements->GetText(i) + "\n";
  }
  text += measurements->GetUnfinishedText();
  return !text.empty() && text.back() == '\n' ? text.substr(0, text.size() - 1) : text;
}

std::string DescribeTime(vtkHapticDevice* device)
{
  if (!device->GetPlayback()->HasTimeSteps())
  {
    return {};
  }
  static const char* const ends[] = { "once", "looping", "back and forth" };
  vtkVolumeHapticsFilter* const filter = device->GetVolumeHaptics();
  const std::vector<double> times =
    filter ? filter->GetBaker().GetDataTimes() : std::vector<double>();
  const auto shown =
    std::lower_bound(times.begin(), times.end(), device->GetPlayback()->GetTimeStepValue());
  const double time = device->GetPlayback()->GetDataTime();
  std::ostringstream text;
  if (filter && filter->GetTimeUnitsPerSecond() == 1.0)
  {
    text << std::fixed << std::setprecision(2) << time << " s" << std::defaultfloat;
  }
  else
  {
    text << "Time " << std::setprecision(4) << time;
  }
  if (shown != times.end())
  {
    text << ", frame " << shown - times.begin() + 1 << " of " << times.size();
  }
  text << ", ";
  if (device->GetPlayback()->IsPlaying())
  {
    text << ends[device->GetPlayback()->GetMode()];
    if (device->GetPlayback()->GetSpeed() != 1.0)
    {
      text << std::setprecision(4) << ", speed " << device->GetPlayback()->GetSpeed();
    }
  }
  else
  {
    text << "paused";
  }
  // Slow reading or drawing delays the time steps.
  text << (device->GetPlayback()->IsWaitingForData() ? ", waiting for data" : "");
  return text.str();
}

//------------------------------------------------------------------------------
namespace
{

/** Returns the chosen point array of the labels, or the scalars by default. */
vtkDataArray* FindLabels(vtkVolumeHapticsFilter* filter, vtkImageData* image)
{
  vtkInformation* const choice = filter->GetInputArrayInformation(1);
  const char* const name = choice && choice->Has(vtkDataObject::FIELD_NAME())
    ? choice->Get(vtkDataObject::FIELD_NAME())
    : nullptr;
  return name ? image->GetPointData()->GetArray(name) : image->GetPointData()->GetScalars();
}

} // namespace

std::string NameLabelAt(vtkVolumeHapticsFilter* filter, const double position[3])
{
  constexpr int labelPort = 3;
  vtkHapticLabelTable* const table = filter ? filter->GetLabelTable() : nullptr;
  if (!table || filter->GetNumberOfInputConnections(labelPort) == 0)
  {
    return {};
  }
  auto* const image = vtkImageData::SafeDownCast(filter->GetInputDataObject(labelPort, 0));
  vtkDataArray* const labels = image ? FindLabels(filter, image) : nullptr;
  if (!labels || labels->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    return {};
  }
  double continuous[3];
  image->TransformPhysicalPointToContinuousIndex(position, continuous);
  const int* const extent = image->GetExtent();
  int index[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double nearest = std::round(continuous[axis]);
    if (!(nearest >= extent[2 * axis] && nearest <= extent[2 * axis + 1]))
    {
      return {};
    }
    index[axis] = static_cast<int>(nearest);
  }
  const double label = labels->GetComponent(image->ComputePointId(index), 0);
  if (!(label >= std::numeric_limits<int>::min() && label <= std::numeric_limits<int>::max()) ||
    !table->HasLabel(static_cast<int>(label)))
  {
    return {};
  }
  const std::string name = table->GetLabelName(static_cast<int>(label));
  return name.empty() ? "label " + std::to_string(static_cast<int>(label)) : name;
}

} // namespace VolumeHaptics
