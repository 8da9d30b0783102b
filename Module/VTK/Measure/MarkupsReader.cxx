// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Measure/MarkupsJson.h"

#include "VTK/Base/JsonText.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/**
 * Returns whether a quantity changes its sign when the x and y axes are mirrored, as forces along x
 * and y do.
 */
bool IsMirrored(int number)
{
  return number == 1 || number == 2;
}

/** Appends an index to the path of a JSON array, such as "markups[2].controlPoints", for errors. */
std::string At(const std::string& path, Json::ArrayIndex i)
{
  return path + "[" + std::to_string(i) + "]";
}

/** Exception for faults of the text, caught in ReadMarkups(). */
struct MarkupsError
{
  std::string Text;
};

/**
 * Returns a text, or the first text of a code such as ["mm", "UCUM", "millimeter"]; `missing` for
 * any other value.
 */
std::string CodeOf(const Json::Value& value, const std::string& missing)
{
  if (value.isString())
  {
    return value.asString();
  }
  return value.isArray() && !value.empty() && value[0].isString() ? value[0].asString() : missing;
}

class MarkupReader
{
public:
  MarkupReader(const Json::Value& markup, std::string path, const MarkupsFrame& frame)
    : Markup(markup)
    , Path(std::move(path))
  {
    const std::string system = CodeOf(markup["coordinateSystem"], "LPS");
    const std::string unit = CodeOf(markup["coordinateUnits"], "mm");
    if (system != "LPS" && system != "RAS")
    {
      throw MarkupsError{ this->Path + ".coordinateSystem is \"" + system +
        "\". Write \"LPS\" or \"RAS\"." };
    }
    if (unit != "mm" && unit != "um")
    {
      throw MarkupsError{ this->Path + ".coordinateUnits is \"" + unit +
        "\". Write \"mm\" or \"um\"." };
    }
    this->Sign = (system == "RAS") == frame.IsRAS ? 1.0 : -1.0;
    const double meters = unit == "mm" ? 1e-3 : 1e-6;
    const bool isSame = std::abs(frame.MetersPerWorldUnit - meters) <= 1e-9 * meters;
    this->Scale = isSame ? 1.0 : meters / frame.MetersPerWorldUnit;
  }

  /**
   * Reads the defined control points, with their labels and the forces and values measured there.
   */
  void ReadControlPoints()
  {
    const Json::Value& all = this->Markup["controlPoints"];
    const std::string path = this->Path + ".controlPoints";
    if (!all.isNull() && !all.isArray())
    {
      throw MarkupsError{ path + " is no list. Save the markups again." };
    }
    std::vector<MeasuredSample> samples = this->ReadSamples(all.size());
    for (Json::ArrayIndex i = 0; i < all.size(); ++i)
    {
      const Json::Value& point = all[i];
      if (!point.isObject())
      {
        throw MarkupsError{ At(path, i) + " is no object. Save the markups again." };
      }
      if (CodeOf(point["positionStatus"], "defined") != "defined")
      {
        continue;
      }
      this->Read.Points.push_back(this->ReadPosition(point["position"], At(path, i) + ".position"));
      this->Labels.push_back(CodeOf(point["label"], ""));
      if (!samples.empty())
      {
        this->Read.Samples.push_back(samples[i]);
      }
    }
  }

  /** Reads the triangles of an area from the member volumeHaptics. */
  void ReadTriangles()
  {
    const Json::Value& own = this->Markup[OwnMember];
    const std::string path = this->Path + "." + OwnMember;
    this->Read.Points.clear();
    this->Read.Samples.clear();
    if (!own["points"].isArray() || !own["triangles"].isArray())
    {
      throw MarkupsError{ path + " has no lists of points and triangles. Save the area again." };
    }
    for (Json::ArrayIndex i = 0; i < own["points"].size(); ++i)
    {
      this->Read.Points.push_back(this->ReadPosition(own["points"][i], At(path + ".points", i)));
    }
    for (Json::ArrayIndex i = 0; i < own["triangles"].size(); ++i)
    {
      const Json::Value& t = own["triangles"][i];
      if (!t.isArray() || t.size() != 3 || !t[0].isInt() || !t[1].isInt() || !t[2].isInt())
      {
        throw MarkupsError{ At(path + ".triangles", i) +
          " is no list of three whole numbers. Save the area again." };
      }
      this->Read.Triangles.push_back({ t[0].asInt(), t[1].asInt(), t[2].asInt() });
    }
  }

  Measurement Read;
  std::vector<std::string> Labels; ///< labels of the control points

private:
  Vector3 ReadPosition(const Json::Value& position, const std::string& path) const
  {
    if (!position.isArray() || position.size() != 3 || !position[0].isNumeric() ||
      !position[1].isNumeric() || !position[2].isNumeric())
    {
      throw MarkupsError{ path + " is no list of three numbers. Write the coordinates there." };
    }
    return { this->Sign * this->Scale * position[0].asDouble(),
      this->Sign * this->Scale * position[1].asDouble(), this->Scale * position[2].asDouble() };
  }

  /** Reads the lists that have one number per control point; returns nothing if there are none. */
  std::vector<MeasuredSample> ReadSamples(Json::ArrayIndex count) const
  {
    std::vector<MeasuredSample> samples;
    const Json::Value& all = this->Markup["measurements"];
    for (Json::ArrayIndex m = 0; all.isArray() && m < all.size(); ++m)
    {
      const Json::Value& numbers =
        all[m].isObject() ? all[m]["controlPointValues"] : Json::Value::nullSingleton();
      const std::string name = all[m].isObject() ? CodeOf(all[m]["name"], "") : std::string();
      const auto* const known = std::find(std::begin(SampleNames), std::end(SampleNames), name);
      if (known == std::end(SampleNames) || !numbers.isArray() || numbers.size() != count)
      {
        continue;
      }
      samples.resize(count);
      const auto number = static_cast<int>(known - std::begin(SampleNames));
      for (Json::ArrayIndex i = 0; i < count; ++i)
      {
        const double value =
          numbers[i].isNumeric() ? numbers[i].asDouble() : MeasuredSample::Unknown;
        NumberOf(samples[i], number) = (IsMirrored(number) ? this->Sign : 1.0) * value;
      }
    }
    return samples;
  }

  const Json::Value& Markup;
  const std::string Path;
  double Sign = 1.0;  ///< sign of x and y in the world
  double Scale = 1.0; ///< world units per unit of the file
};

/**
 * Appends the measurements of a markup. If the markup is of an unknown kind, adds a note instead.
 */
void ReadMarkup(const Json::Value& markup, const std::string& path, const MarkupsFrame& frame,
  std::vector<Measurement>& measurements, std::string& notes)
{
  if (!markup.isObject() || !markup["type"].isString())
  {
    throw MarkupsError{ path + " has no type. Save the markups again." };
  }
  const std::string type = markup["type"].asString();
  const std::string name = CodeOf(markup["name"], "");
  int kind = 0;
  while (kind < MeasuredKinds && type != TypeOf(static_cast<MeasuredKind>(kind)))
  {
    ++kind;
  }
  if (kind == MeasuredKinds)
  {
    notes += type + " \"" + name + "\" is left out: it is no point, distance, angle or path.\n";
    return;
  }
  MarkupReader reader(markup, path, frame);
  reader.ReadControlPoints();
  Measurement& read = reader.Read;
  read.Name = name;
  read.Kind = static_cast<MeasuredKind>(kind);
  if (read.Kind == MeasuredKind::Point)
  {
    for (std::size_t i = 0; i < read.Points.size(); ++i)
    {
      Measurement point;
      point.Name = reader.Labels[i];
      point.Points = { read.Points[i] };
      const bool isFelt = !read.Samples.empty();
      point.Samples = isFelt ? std::vector<MeasuredSample>{ read.Samples[i] } : point.Samples;
      measurements.push_back(point);
    }
    return;
  }
  if (read.Kind == MeasuredKind::Area && markup[OwnMember].isObject())
  {
    reader.ReadTriangles();
  }
  else if (read.Kind == MeasuredKind::Area)
  {
    read.Kind = MeasuredKind::Path;
    if (!read.Points.empty())
    {
      read.Points.push_back(read.Points.front());
    }
    if (!read.Samples.empty())
    {
      read.Samples.push_back(read.Samples.front());
    }
  }
  const std::string fault = DetectFault(read);
  if (!fault.empty())
  {
    notes += type + " \"" + name + "\" is left out: " + fault + ".\n";
    return;
  }
  measurements.push_back(std::move(read));
}

} // namespace

bool ReadMarkups(const std::string& text, const MarkupsFrame& frame,
  std::vector<Measurement>& measurements, std::string& notes, std::string& error)
{
  Json::Value root;
  if (!ParseJson(text, root, error))
  {
    error += " Save the markups again.";
    return false;
  }
  const std::string schema = root.isObject() ? CodeOf(root["@schema"], "") : std::string();
  if (schema.find("markups-schema-v1.") == std::string::npos || !root["markups"].isArray())
  {
    error = "it has no \"@schema\" of markups of 3D Slicer, version 1, with a list \"markups\". "
            "Choose a file that 3D Slicer, or this software, saved as .mrk.json.";
    return false;
  }
  std::vector<Measurement> found;
  try
  {
    for (Json::ArrayIndex i = 0; i < root["markups"].size(); ++i)
    {
      ReadMarkup(root["markups"][i], At("markups", i), frame, found, notes);
    }
  }
  catch (const MarkupsError& fault)
  {
    error = fault.Text;
    return false;
  }
  if (!notes.empty())
  {
    notes.pop_back(); // removes the last line break
  }
  measurements = std::move(found);
  return true;
}

} // namespace VolumeHaptics
