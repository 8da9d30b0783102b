// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/Paths/RecordedPath.h"

#include "Core/State/ServoStateNumbers.h"
#include "VTK/Baking/HapticPlacement.h"
#include "VTK/Base/HapticTuples.h"
#include "VTK/Tools/TissueArrays.h"
#include "VTK/Trace/HapticTraceColumns.h"
#include "VTK/Trace/RecordingNames.h"
#include "VTK/Trace/TraceArrayChoice.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/** Range of the periods (s) that vtkHapticDevice::SetServoRate allows, with a margin. */
constexpr double ShortestPeriod = 1e-6;
constexpr double LongestPeriod = 1.0;
/**
 * Distance (m) of the farthest accepted tip. A tip farther away could overflow to infinity in the
 * world.
 */
constexpr double FarthestRecordedTip = 1e15;

} // namespace

RecordedPathReader::RecordedPathReader(vtkPolyData* path, RecordedPath& result)
  : Path(path)
  , Result(result)
  , Ticks(path->GetNumberOfPoints())
{
}

std::string RecordedPathReader::Read()
{
  this->ReadPlacements();
  this->ReadBegin();
  this->ReadTicks();
  this->ReadOrientations();
  this->ReadContacts();
  this->ReadRemoval();
  return this->Flaw;
}

vtkDataArray* RecordedPathReader::Find(
  vtkFieldData* data, const char* kind, const char* name, int components, vtkIdType tuples)
{
  vtkDataArray* const array = data->GetArray(name);
  const bool hasShape = array && array->GetNumberOfComponents() == components &&
    (tuples < 0 ? array->GetNumberOfTuples() > 0 : array->GetNumberOfTuples() == tuples);
  if (!hasShape && this->Flaw.empty())
  {
    this->Flaw = std::string("its ") + kind + " array \"" + name + "\" " +
      (array ? "has " + std::to_string(array->GetNumberOfTuples()) + " tuples of " +
            std::to_string(array->GetNumberOfComponents()) + " component(s) instead of " +
            (tuples < 0 ? std::string("some") : std::to_string(tuples)) + " of " +
            std::to_string(components)
             : std::string("is missing"));
  }
  return hasShape ? array : nullptr;
}

vtkDataArray* RecordedPathReader::FindOfTicks(const char* name, int components)
{
  return this->Find(this->Path->GetPointData(), "point", name, components, this->Ticks);
}

vtkDataArray* RecordedPathReader::FindField(const char* name, int components, vtkIdType tuples)
{
  return this->Find(this->Path->GetFieldData(), "field", name, components, tuples);
}

void RecordedPathReader::Require(bool holds, const char* array, vtkIdType tuple, const char* wanted)
{
  if (!holds && this->Flaw.empty())
  {
    this->Flaw = std::string("its array \"") + array + "\" is not " + wanted + " in tuple " +
      std::to_string(tuple);
  }
}

void RecordedPathReader::ReadPlacements()
{
  constexpr vtkIdType anyNumber = -1;
  vtkDataArray* const matrices = this->FindField(RecordingNames::DeviceToWorld, 16, anyNumber);
  vtkNew<vtkMatrix4x4> matrix;
  for (vtkIdType i = 0; matrices && this->Flaw.empty() && i < matrices->GetNumberOfTuples(); ++i)
  {
    matrices->GetTuple(i, matrix->GetData());
    Affine3 map;
    std::string error;
    this->Require(ReadSimilarity(matrix, map, error), RecordingNames::DeviceToWorld, i,
      "a rotation, a translation and one uniform, positive scale");
    this->Result.Placements.push_back(map);
  }
}

void RecordedPathReader::ReadBegin()
{
  vtkDataArray* const found = this->Path->GetFieldData()->GetArray(RecordingNames::InitialState);
  const int size = found ? found->GetNumberOfComponents() : ServoStateSize;
  const bool isOld = IsOldServoStateSize(size);
  vtkDataArray* const state =
    this->FindField(RecordingNames::InitialState, isOld ? size : ServoStateSize, 1);
  vtkDataArray* const period = this->FindField(RecordingNames::TickPeriod, 1, 1);
  this->ReadCaps();
  if (!state || !period)
  {
    return;
  }
  std::array<double, ServoStateSize> numbers{};
  state->GetTuple(0, numbers.data());
  this->Require(
    AreOfAState(numbers), RecordingNames::InitialState, 0, "a state that the servo can be in");
  this->Result.InitialState = FromNumbers(numbers);
  this->Result.TickPeriod = period->GetComponent(0, 0);
  this->Require(
    this->Result.TickPeriod >= ShortestPeriod && this->Result.TickPeriod <= LongestPeriod,
    RecordingNames::TickPeriod, 0, "between a microsecond and a second");
}

void RecordedPathReader::ReadCaps()
{
  vtkDataArray* const found = this->Path->GetFieldData()->GetArray(RecordingNames::Caps);
  const auto placements = static_cast<vtkIdType>(this->Result.Placements.size());
  const bool isOfEach = found && found->GetNumberOfTuples() == placements;
  vtkDataArray* const caps = this->FindField(RecordingNames::Caps, 2, isOfEach ? placements : 1);
  const auto isCap = [](double cap) { return cap >= 0.0 && std::isfinite(cap); };
  for (vtkIdType i = 0; caps && i < placements; ++i)
  {
    const vtkIdType tuple = isOfEach ? i : 0;
    const ForceCaps cap{ caps->GetComponent(tuple, 0), caps->GetComponent(tuple, 1) };
    this->Require(isCap(cap.Stiffness) && isCap(cap.Damping), RecordingNames::Caps, tuple,
      "two numbers of 0 or more");
    this->Result.Caps.push_back(cap);
  }
}

void RecordedPathReader::ReadTicks()
{
  vtkDataArray* const tips = this->FindOfTicks(RecordingNames::DeviceTip, 3);
  vtkDataArray* const enabled = this->FindOfTicks(RecordingNames::Enabled, 1);
  vtkDataArray* const renewed = this->FindOfTicks(RecordingNames::Renewed, 1);
  vtkDataArray* const placement = this->FindOfTicks(RecordingNames::Placement, 1);
  vtkDataArray* const times = this->FindOfTicks("Time", 1);
  const auto isFlag = [](double flag) { return flag == 0.0 || flag == 1.0; };
  // This array may be missing in older recordings, and in recordings that a user has reduced.
  vtkDataArray* const dataTimes = this->Path->GetPointData()->GetArray(DataTimeColumn)
    ? this->FindOfTicks(DataTimeColumn, 1)
    : nullptr;
  bool isMoving = false;
  const auto placements = static_cast<double>(this->Result.Placements.size());
  double last = -HUGE_VAL;
  for (vtkIdType i = 0; this->Flaw.empty() && i < this->Ticks; ++i)
  {
    const Vector3 tip = ReadVector(tips, i);
    const double index = placement->GetComponent(i, 0);
    const double time = times->GetComponent(i, 0);
    this->Require(Norm(tip) < FarthestRecordedTip, RecordingNames::DeviceTip, i, "a place near");
    this->Require(index >= 0.0 && index < placements && index == std::floor(index),
      RecordingNames::Placement, i, "the number of a tuple of DeviceToWorld");
    this->Require(std::isfinite(time) && time >= last, "Time", i, "finite and in order");
    this->Require(isFlag(enabled->GetComponent(i, 0)), RecordingNames::Enabled, i, "0 or 1");
    this->Require(isFlag(renewed->GetComponent(i, 0)), RecordingNames::Renewed, i, "0 or 1");
    if (!this->Flaw.empty())
    {
      return;
    }
    last = time;
    this->Result.Tips.push_back(tip);
    this->Result.PlacementOf.push_back(static_cast<int>(index));
    this->Result.Enabled.push_back(enabled->GetComponent(i, 0) != 0.0);
    this->Result.Renewed.push_back(renewed->GetComponent(i, 0) != 0.0);
    this->Result.Times.push_back(time);
    const double dataTime = dataTimes ? dataTimes->GetComponent(i, 0) : 0.0;
    this->Require(std::isfinite(dataTime), DataTimeColumn, i, "finite");
    this->Result.DataTimes.push_back(dataTime);
    isMoving = isMoving || dataTime != 0.0;
  }
  if (!isMoving)
  {
    // If all data times are 0, the volume showed its first time step or did not move.
    this->Result.DataTimes.clear();
  }
}

void RecordedPathReader::ReadOrientations()
{
  // These arrays may be missing in older recordings, and in recordings that a user has reduced.
  if (!this->Path->GetPointData()->GetArray(RecordingNames::DeviceOrientation))
  {
    return;
  }
  vtkDataArray* const array = this->FindOfTicks(RecordingNames::DeviceOrientation, 4);
  bool isTurned = false;
  for (vtkIdType i = 0; this->Flaw.empty() && i < this->Ticks; ++i)
  {
    Quaternion q = ReadQuaternion(array, i);
    const bool isNone = IsIdentical(q, NoOrientation);
    this->Require(isNone || MakeUnit(q), RecordingNames::DeviceOrientation, i,
      "a unit quaternion, or four zeros");
    this->Result.Orientations.push_back(q);
    isTurned = isTurned || !isNone;
  }
  if (!isTurned)
  {
    this->Result.Orientations.clear();
  }
}

void RecordedPathReader::ReadRemoval()
{
  std::string flaw;
  if (!ReadTissueArrays(
        this->Path->GetFieldData(), InitialTissueNames, this->Result.InitialTissue, flaw) &&
    this->Flaw.empty())
  {
    this->Flaw = flaw;
  }
  if (this->Path->GetFieldData()->GetArray(RecordingNames::AirValue))
  {
    vtkDataArray* const air = this->FindField(RecordingNames::AirValue, 1, 1);
    this->Result.AirValue = air ? air->GetComponent(0, 0) : this->Result.AirValue;
    this->Require(std::isfinite(this->Result.AirValue), RecordingNames::AirValue, 0, "finite");
  }
  // These arrays may be missing in older recordings, and in recordings that a user has reduced.
  vtkPointData* const data = this->Path->GetPointData();
  const auto find = [&](const char* name)
  { return data->GetArray(name) ? this->FindOfTicks(name, 1) : nullptr; };
  vtkDataArray* const spinning = find(RecordingNames::Spinning);
  vtkDataArray* const requests = find(RecordingNames::RemovalRequest);
  for (vtkIdType i = 0; spinning && this->Flaw.empty() && i < this->Ticks; ++i)
  {
    const double spins = spinning->GetComponent(i, 0);
    this->Require(spins == 0.0 || spins == 1.0, RecordingNames::Spinning, i, "0 or 1");
    this->Result.Spinning.push_back(spins != 0.0);
  }
  for (vtkIdType i = 0; requests && this->Flaw.empty() && i < this->Ticks; ++i)
  {
    const double request = requests->GetComponent(i, 0);
    const bool isOne = request == 0.0 || request == 1.0 || request == 2.0 || request == 3.0;
    this->Require(isOne, RecordingNames::RemovalRequest, i, "0, 1, 2 or 3");
    this->Result.Requests.push_back(
      isOne ? static_cast<RemovalRequest>(request) : RemovalRequest::None);
  }
}

void RecordedPathReader::ReadContacts()
{
  // Present only if a tool with a shape touched something at the beginning of the recording.
  if (!this->Path->GetFieldData()->GetArray(RecordingNames::InitialContacts))
  {
    return;
  }
  ContactRow row;
  vtkDataArray* const array =
    this->FindField(RecordingNames::InitialContacts, static_cast<int>(row.size()), -1);
  double next = 0.0;
  for (vtkIdType i = 0; this->Flaw.empty() && i < array->GetNumberOfTuples(); ++i)
  {
    array->GetTuple(i, row.data());
    ShellContact contact;
    const bool isGood = FromRow(row, contact, this->Result.ContactFraction);
    this->Require(isGood && row[0] >= next, RecordingNames::InitialContacts, i,
      "a contact, of a later point than the one before");
    next = row[0] + 1.0;
    this->Result.InitialContacts.push_back(contact);
  }
}

} // namespace VolumeHaptics
