// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Tools/ShareArrays.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <set>

namespace VolumeHaptics
{

std::array<std::int32_t, 3> PlaceOfBrick(const BrickShares& brick)
{
  const BrickPlace place = CarvedBricks::PlaceOf(brick.Key);
  return { static_cast<std::int32_t>(place.X), static_cast<std::int32_t>(place.Y),
    static_cast<std::int32_t>(place.Z) };
}

std::array<unsigned char, SharesOfBrick> SharesAsBytes(const BrickShares& brick)
{
  std::array<unsigned char, SharesOfBrick> bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    const std::uint64_t row = brick.Rows[i / CarvedBricks::Side];
    bytes[i] = static_cast<unsigned char>(row >> (8 * (i % CarvedBricks::Side)));
  }
  return bytes;
}

void AddShareArrays(
  const std::vector<BrickShares>& bricks, const ShareArrayNames& names, vtkFieldData* data)
{
  vtkNew<vtkIntArray> places;
  places->SetName(names.Bricks);
  places->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> shares;
  shares->SetName(names.Shares);
  shares->SetNumberOfComponents(SharesOfBrick);
  for (const BrickShares& brick : bricks)
  {
    places->InsertNextTypedTuple(PlaceOfBrick(brick).data());
    shares->InsertNextTypedTuple(SharesAsBytes(brick).data());
  }
  data->AddArray(places);
  data->AddArray(shares);
}

bool ReadShareArrays(vtkFieldData* data, const ShareArrayNames& names,
  std::vector<BrickShares>& bricks, std::string& flaw)
{
  bricks.clear();
  vtkDataArray* const places = data->GetArray(names.Bricks);
  vtkDataArray* const shares = data->GetArray(names.Shares);
  if (!places && !shares)
  {
    return true;
  }
  if (!places || !shares)
  {
    flaw = std::string("its array \"") + (places ? names.Shares : names.Bricks) + "\" is missing";
    return false;
  }
  const vtkIdType count = places->GetNumberOfTuples();
  if (places->GetNumberOfComponents() != 3 || shares->GetNumberOfComponents() != SharesOfBrick ||
    shares->GetNumberOfTuples() != count)
  {
    flaw = std::string("its arrays \"") + names.Bricks + "\" and \"" + names.Shares +
      "\" don't have as many tuples of 3 and " + std::to_string(SharesOfBrick) + " components";
    return false;
  }
  std::set<std::uint64_t> keys;
  std::array<double, SharesOfBrick> bytes{};
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
    BrickShares brick{};
    if (isGood)
    {
      brick.Key = CarvedBricks::KeyOf({ static_cast<std::int64_t>(place[0]),
        static_cast<std::int64_t>(place[1]), static_cast<std::int64_t>(place[2]) });
      isGood = keys.insert(brick.Key).second;
    }
    shares->GetTuple(i, bytes.data());
    for (std::size_t k = 0; k < bytes.size(); ++k)
    {
      isGood = isGood && bytes[k] >= 0.0 && bytes[k] <= CarvedBricks::Whole;
      const auto byte = static_cast<std::uint64_t>(isGood ? bytes[k] : 0.0);
      brick.Rows[k / CarvedBricks::Side] |= byte << (8 * (k % CarvedBricks::Side));
    }
    if (!isGood)
    {
      flaw = "tuple " + std::to_string(i) + " of its arrays \"" + names.Bricks + "\" and \"" +
        names.Shares + "\" is not the place of a brick and shares from 0 to 255";
      return false;
    }
    bricks.push_back(brick);
  }
  return true;
}

} // namespace VolumeHaptics
