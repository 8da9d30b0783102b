// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Tools/TissueArrays.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <set>

namespace VolumeHaptics
{

std::array<std::int32_t, 3> PlaceOfBrick(const BrickTissue& brick)
{
  const BrickPlace place = CarvedBricks::PlaceOf(brick.Key);
  return { static_cast<std::int32_t>(place.X), static_cast<std::int32_t>(place.Y),
    static_cast<std::int32_t>(place.Z) };
}

std::array<unsigned char, SamplesOfBrick> TissueAsBytes(const BrickTissue& brick)
{
  std::array<unsigned char, SamplesOfBrick> bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    const std::uint64_t row = brick.Rows[i / CarvedBricks::Side];
    bytes[i] = static_cast<unsigned char>(row >> (8 * (i % CarvedBricks::Side)));
  }
  return bytes;
}

void AddTissueArrays(
  const std::vector<BrickTissue>& bricks, const TissueArrayNames& names, vtkFieldData* data)
{
  vtkNew<vtkIntArray> places;
  places->SetName(names.Bricks);
  places->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> fractions;
  fractions->SetName(names.Fractions);
  fractions->SetNumberOfComponents(SamplesOfBrick);
  for (const BrickTissue& brick : bricks)
  {
    places->InsertNextTypedTuple(PlaceOfBrick(brick).data());
    fractions->InsertNextTypedTuple(TissueAsBytes(brick).data());
  }
  data->AddArray(places);
  data->AddArray(fractions);
}

bool ReadTissueArrays(vtkFieldData* data, const TissueArrayNames& names,
  std::vector<BrickTissue>& bricks, std::string& flaw)
{
  bricks.clear();
  vtkDataArray* const places = data->GetArray(names.Bricks);
  vtkDataArray* const fractions = data->GetArray(names.Fractions);
  if (!places && !fractions)
  {
    return true;
  }
  if (!places || !fractions)
  {
    flaw =
      std::string("its array \"") + (places ? names.Fractions : names.Bricks) + "\" is missing";
    return false;
  }
  const vtkIdType count = places->GetNumberOfTuples();
  if (places->GetNumberOfComponents() != 3 ||
    fractions->GetNumberOfComponents() != SamplesOfBrick || fractions->GetNumberOfTuples() != count)
  {
    flaw = std::string("its arrays \"") + names.Bricks + "\" and \"" + names.Fractions +
      "\" don't have as many tuples of 3 and " + std::to_string(SamplesOfBrick) + " components";
    return false;
  }
  std::set<std::uint64_t> keys;
  std::array<double, SamplesOfBrick> bytes{};
  for (vtkIdType i = 0; i < count; ++i)
  {
    double place[3];
    places->GetTuple(i, place);
    bool isGood = true;
    for (const double x : place)
    {
      isGood = isGood && x >= 0.0 && x < static_cast<double>(CarvedBricks::PlaceLimit) &&
        x == std::floor(x);
    }
    BrickTissue brick{};
    if (isGood)
    {
      brick.Key = CarvedBricks::KeyOf({ static_cast<std::int64_t>(place[0]),
        static_cast<std::int64_t>(place[1]), static_cast<std::int64_t>(place[2]) });
      isGood = keys.insert(brick.Key).second;
    }
    fractions->GetTuple(i, bytes.data());
    for (std::size_t k = 0; k < bytes.size(); ++k)
    {
      isGood = isGood && bytes[k] >= 0.0 && bytes[k] <= CarvedBricks::Whole;
      const auto byte = static_cast<std::uint64_t>(isGood ? bytes[k] : 0.0);
      brick.Rows[k / CarvedBricks::Side] |= byte << (8 * (k % CarvedBricks::Side));
    }
    if (!isGood)
    {
      flaw = "tuple " + std::to_string(i) + " of its arrays \"" + names.Bricks + "\" and \"" +
        names.Fractions + "\" is not the place of a brick and shares from 0 to 255";
      return false;
    }
    bricks.push_back(brick);
  }
  return true;
}

} // namespace VolumeHaptics
