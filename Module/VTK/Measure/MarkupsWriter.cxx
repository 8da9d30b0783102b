// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Base/JsonText.h"
#include "VTK/Measure/MarkupsJson.h"
#include "VTK/Measure/Measurement.h"
#include "VTK/Measure/MeasurementUnits.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/**
 * Returns the points of the longest closed line along the border of an area, in order, without
 * repeating the first point. The border consists of the edges that belong to only one triangle. For
 * a closed surface, which has no border, returns its first triangle.
 */
std::vector<Vector3> ExtractBorder(const Measurement& area)
{
  using Edge = std::pair<int, int>;
  std::set<Edge> edges; // with the directions that the triangles give them
  for (const std::array<int, 3>& t : area.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      edges.insert({ t[i], t[(i + 1) % 3] });
    }
  }
  std::multimap<int, int> next;
  for (const Edge& edge : edges)
  {
    if (edges.count({ edge.second, edge.first }) == 0)
    {
      next.insert(edge);
    }
  }
  std::vector<Vector3> longest;
  double most = 0.0;
  while (!next.empty())
  {
    std::vector<Vector3> line;
    double length = 0.0;
    for (auto edge = next.begin(); edge != next.end();)
    {
      const auto [from, to] = *edge;
      next.erase(edge);
      line.push_back(area.Points[static_cast<std::size_t>(from)]);
      length += Norm(area.Points[static_cast<std::size_t>(to)] - line.back());
      edge = next.find(to);
    }
    if (length > most)
    {
      most = length;
      longest = std::move(line);
    }
  }
  if (longest.empty() && !area.Triangles.empty())
  {
    for (const int corner : area.Triangles.front())
    {
      longest.push_back(area.Points[static_cast<std::size_t>(corner)]);
    }
  }
  return longest;
}

constexpr const char* Schema =
  "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/"
  "Schema/markups-schema-v1.0.3.json#";

const char* ValueName(MeasuredKind kind)
{
  return kind == MeasuredKind::Angle ? "angle" : (kind == MeasuredKind::Area ? "area" : "length");
}

/** Returns a bit mask of the felt quantities that are known at a point. */
int CollectKnown(const Measurement& point)
{
  MeasuredSample sample = point.Samples.empty() ? MeasuredSample() : point.Samples[0];
  int known = 0;
  for (int i = 0; i < SampleNumbers; ++i)
  {
    known |= std::isfinite(NumberOf(sample, i)) ? 1 << i : 0;
  }
  return known;
}

class MarkupsWriter
{
public:
  explicit MarkupsWriter(const MarkupsFrame& frame)
    : Frame(frame)
    , IsMicro(ChooseLengthUnit(frame.MetersPerWorldUnit).Name == std::string("um"))
    // Make the scale exactly 1 if the world is in the unit of the file.
    , Scale(this->IsMicro || std::abs(frame.MetersPerWorldUnit - 1e-3) <= 1e-12
          ? 1.0
          : frame.MetersPerWorldUnit / 1e-3)
  {
  }

  void AddPoints(const Measurement* first, std::size_t count)
  {
    Json::Value& markup = this->Begin(MeasuredKind::Point);
    markup["name"] = count == 1 ? first->Name : "Points";
    std::vector<MeasuredSample> samples;
    for (std::size_t i = 0; i < count; ++i)
    {
      this->AddControlPoint(markup, first[i].Points[0], first[i].Name);
      samples.push_back(first[i].Samples.empty() ? MeasuredSample() : first[i].Samples[0]);
    }
    AddSamples(markup, samples);
  }

  void Add(const Measurement& measurement)
  {
    Json::Value& markup = this->Begin(measurement.Kind);
    markup["name"] = measurement.Name;
    const bool isArea = measurement.Kind == MeasuredKind::Area;
    const std::vector<Vector3> points = isArea ? ExtractBorder(measurement) : measurement.Points;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      this->AddControlPoint(markup, points[i], measurement.Name + "-" + std::to_string(i + 1));
    }
    Json::Value value(Json::objectValue);
    value["name"] = ValueName(measurement.Kind);
    value["enabled"] = true;
    value["value"] = this->ValueOf(measurement);
    value["units"] = this->UnitOf(measurement.Kind);
    value["printFormat"] = "%-#4.4g%s";
    markup["measurements"].append(value);
    AddSamples(markup, measurement.Samples);
    markup["display"]["propertiesLabelVisibility"] = true;
    if (isArea)
    {
      this->AddTriangles(markup[OwnMember], measurement);
    }
  }

  Json::Value Root{ Json::objectValue };

private:
  Json::Value& Begin(MeasuredKind kind)
  {
    this->Root["@schema"] = Schema;
    Json::Value& markup = this->Root["markups"].append(Json::Value(Json::objectValue));
    markup["type"] = TypeOf(kind);
    markup["coordinateSystem"] = this->Frame.IsRAS ? "RAS" : "LPS";
    markup["coordinateUnits"] = this->IsMicro ? "um" : "mm";
    markup["controlPoints"] = Json::Value(Json::arrayValue);
    return markup;
  }

  Json::Value Position(const Vector3& point) const
  {
    Json::Value position(Json::arrayValue);
    for (const double x : { point.X, point.Y, point.Z })
    {
      position.append(this->Scale * x);
    }
    return position;
  }

  void AddControlPoint(Json::Value& markup, const Vector3& point, const std::string& label) const
  {
    Json::Value& points = markup["controlPoints"];
    Json::Value added(Json::objectValue);
    added["id"] = std::to_string(points.size() + 1);
    added["label"] = label;
    added["position"] = this->Position(point);
    // Some versions treat a point without this member as undefined.
    added["positionStatus"] = "defined";
    points.append(added);
  }

  double ValueOf(const Measurement& measurement) const
  {
    const double value = measurement.Measure();
    switch (measurement.Kind)
    {
      case MeasuredKind::Angle:
        return value;
      case MeasuredKind::Area:
        return this->Scale * this->Scale * value;
      default:
        return this->Scale * value;
    }
  }

  std::string UnitOf(MeasuredKind kind) const
  {
    const std::string length = this->IsMicro ? "um" : "mm";
    return kind == MeasuredKind::Angle ? "deg"
                                       : (kind == MeasuredKind::Area ? length + "2" : length);
  }

  /** Writes lists with one number per point. Skips a quantity that is unknown at any point. */
  static void AddSamples(Json::Value& markup, std::vector<MeasuredSample> samples)
  {
    for (int i = 0; i < SampleNumbers; ++i)
    {
      const auto isKnown = [i](MeasuredSample& s) { return std::isfinite(NumberOf(s, i)); };
      if (samples.empty() || !std::all_of(samples.begin(), samples.end(), isKnown))
      {
        continue;
      }
      Json::Value felt(Json::objectValue);
      felt["name"] = SampleNames[i];
      felt["enabled"] = true;
      felt["units"] = SampleUnits[i];
      for (MeasuredSample& sample : samples)
      {
        felt["controlPointValues"].append(NumberOf(sample, i));
      }
      markup["measurements"].append(felt);
    }
  }

  void AddTriangles(Json::Value& own, const Measurement& area) const
  {
    own["kind"] = GetKindName(area.Kind);
    for (const Vector3& point : area.Points)
    {
      own["points"].append(this->Position(point));
    }
    for (const std::array<int, 3>& triangle : area.Triangles)
    {
      Json::Value corners(Json::arrayValue);
      for (const int corner : triangle)
      {
        corners.append(corner);
      }
      own["triangles"].append(corners);
    }
  }

  const MarkupsFrame Frame;
  const bool IsMicro;
  const double Scale; ///< units of the file per world unit
};

} // namespace

std::string WriteMarkups(const std::vector<Measurement>& measurements, const MarkupsFrame& frame)
{
  MarkupsWriter writer(frame);
  writer.Root["@schema"] = Schema;
  writer.Root["markups"] = Json::Value(Json::arrayValue);
  for (std::size_t i = 0; i < measurements.size();)
  {
    std::size_t end = i;
    while (end < measurements.size() && measurements[end].Kind == MeasuredKind::Point &&
      CollectKnown(measurements[end]) == CollectKnown(measurements[i]))
    {
      ++end;
    }
    if (end > i)
    {
      writer.AddPoints(&measurements[i], end - i);
      i = end;
    }
    else
    {
      writer.Add(measurements[i++]);
    }
  }
  return WriteJson(writer.Root);
}

} // namespace VolumeHaptics
