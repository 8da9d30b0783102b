// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests 3D Slicer's markups. The files were written by hand from the published schema
 * (Modules/Loadable/Markups/Resources/Schema/markups-schema-v1.0.3.json of 3D Slicer) and from the
 * example in its developer's guide, "Markups json file format", not by the code under test.
 */

#include "MeasureRig.h"

#include <vtkPlaneSource.h>
#include <vtk_jsoncpp.h>

#include <algorithm>
#include <set>
#include <sstream>

using namespace measuretest;

namespace
{
const std::string Schema =
  R"("@schema": "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/markups-schema-v1.0.3.json#")";

std::string MarkupFile(const std::string& markups)
{
  return "{" + Schema + R"(, "markups": [)" + markups + "]}";
}

class Markups : public MeasureTest
{
protected:
  bool Read(const std::string& text)
  {
    return this->List->ReadFile(WriteTextFile("Read.mrk.json", text).c_str());
  }
  void Refuse(const std::string& text, const std::vector<std::string>& words)
  {
    SCOPED_TRACE(text);
    EXPECT_FALSE(this->Read(text));
    this->ExpectError(words);
  }
  void ExpectPoint(vtkIdType index, vtkIdType point, const Point& wanted)
  {
    double x[3];
    this->List->GetPoint(index, point, x);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_DOUBLE_EQ(x[c], wanted[static_cast<std::size_t>(c)]);
    }
  }
  Json::Value Write()
  {
    EXPECT_TRUE(this->List->WriteFile(File("Written.mrk.json").c_str()));
    std::ifstream stream(File("Written.mrk.json"));
    Json::Value root;
    stream >> root;
    return root;
  }
};
} // namespace

TEST_F(Markups, ReadsTheExampleOfTheDevelopersGuide)
{
  // This example has version 1.0.0, without units and status of positions.
  ASSERT_TRUE(this->Read(
    R"({"@schema": "https://raw.githubusercontent.com/Slicer/Slicer/main/Modules/Loadable/Markups/Resources/Schema/markups-schema-v1.0.0.json#",
"markups": [{"type": "Fiducial", "coordinateSystem": "LPS", "controlPoints": [
    { "label": "F-1", "position": [-53.388409961685827, -73.33572796934868, 0.0] },
    { "label": "F-2", "position": [49.8682950191571, -88.58955938697324, 0.0] }
]}]})"));
  ASSERT_EQ(this->List->GetNumberOfMeasurements(), 2);
  EXPECT_EQ(this->List->GetName(1), "F-2");
  EXPECT_EQ(this->List->GetKind(1), vtkHapticMeasurements::POINT);
  this->ExpectPoint(1, 0, { 49.8682950191571, -88.58955938697324, 0.0 });
}

TEST_F(Markups, ReadsEachTypeOfTheSchema)
{
  ASSERT_TRUE(this->Read(MarkupFile(R"(
{"type": "Line", "name": "width", "coordinateSystem": "LPS", "coordinateUnits": "mm", "locked": false,
 "controlPoints": [
  {"id": "1", "label": "L-1", "position": [0, 0, 0], "orientation": [-1,0,0,0,-1,0,0,0,1],
   "selected": true, "visibility": true, "positionStatus": "defined"},
  {"id": "2", "label": "L-2", "position": [3, 4, 12], "positionStatus": "defined"},
  {"id": "3", "label": "L-3", "position": [9, 9, 9], "positionStatus": "preview"}],
 "measurements": [{"name": "length", "enabled": true, "value": 13.0, "units": "mm", "printFormat": "%-#4.4g%s"}],
 "display": {"visibility": true, "opacity": 1.0, "color": [0.4, 1.0, 1.0]}},
{"type": "Angle", "name": "bend", "controlPoints": [
  {"position": [1, 0, 0]}, {"position": [0, 0, 0]}, {"position": [1, 1, 0]}]},
{"type": "Curve", "name": "way", "coordinateUnits": ["mm", "UCUM", "millimeter"], "controlPoints": [
  {"position": [0, 0, 0]}, {"position": [0, 0, 5]}, {"position": [0, 2, 5]}],
 "measurements": [{"name": "force z", "units": "N", "controlPointValues": [0.5, 1.5, 2.5]}]},
{"type": "ClosedCurve", "name": "ring", "controlPoints": [
  {"position": [0, 0, 0]}, {"position": [6, 0, 0]}, {"position": [6, 8, 0]}]})")));
  ASSERT_EQ(this->List->GetNumberOfMeasurements(), 4);
  EXPECT_EQ(this->List->GetText(0), "width: 13.0 mm");
  EXPECT_NEAR(this->List->GetValue(1), 45.0, 1e-12);
  EXPECT_EQ(this->List->GetKind(2), vtkHapticMeasurements::PATH);
  EXPECT_DOUBLE_EQ(this->List->GetValue(2), 7.0);
  EXPECT_EQ(this->List->GetKind(3), vtkHapticMeasurements::PATH);
  EXPECT_DOUBLE_EQ(this->List->GetValue(3), 24.0) << "6, 8 and 10: it ends where it begins";
  vtkNew<vtkPolyData> way;
  this->List->GetShape(2, way);
  EXPECT_EQ(way->GetPointData()->GetArray("Force")->GetComponent(2, 2), 2.5);
}

TEST_F(Markups, TurnsRightAnteriorSuperior)
{
  const std::string markup =
    R"({"type": "Fiducial", "coordinateSystem": "RAS", "controlPoints": [{"label": "a", "position": [10, 20, 30]}]})";
  ASSERT_TRUE(this->Read(MarkupFile(markup)));
  this->ExpectPoint(0, 0, { -10.0, -20.0, 30.0 });
  this->List->SetCoordinateSystemToRAS();
  ASSERT_TRUE(this->Read(MarkupFile(markup)));
  this->ExpectPoint(0, 0, { 10.0, 20.0, 30.0 });
  const Json::Value written = this->Write();
  EXPECT_EQ(written["markups"][0]["coordinateSystem"].asString(), "RAS");
  EXPECT_EQ(written["markups"][0]["controlPoints"][0]["position"][0].asDouble(), 10.0);
}

TEST_F(Markups, TakesMicrometresAndOtherUnitsOfTheWorld)
{
  const std::string markup =
    R"({"type": "Fiducial", "coordinateUnits": "um", "controlPoints": [{"position": [1500, 0, 0]}]})";
  ASSERT_TRUE(this->Read(MarkupFile(markup)));
  this->ExpectPoint(0, 0, { 1.5, 0.0, 0.0 });
  this->List->SetMetersPerWorldUnit(0.01);
  ASSERT_TRUE(this->Read(MarkupFile(markup)));
  this->ExpectPoint(0, 0, { 0.15, 0.0, 0.0 });
  const Json::Value written = this->Write();
  EXPECT_EQ(written["markups"][0]["coordinateUnits"].asString(), "mm");
  EXPECT_DOUBLE_EQ(written["markups"][0]["controlPoints"][0]["position"][0].asDouble(), 1.5);
}

TEST_F(Markups, LeavesOutWhatIsNoMeasurementAndSaysSo)
{
  ASSERT_TRUE(this->Read(MarkupFile(R"(
{"type": "Plane", "name": "cut", "controlPoints": [], "center": [0, 0, 0]},
{"type": "ROI", "name": "box", "controlPoints": []},
{"type": "Line", "name": "begun", "controlPoints": [{"position": [1, 2, 3]}]},
{"type": "Fiducial", "controlPoints": [{"label": "kept", "position": [1, 2, 3]},
  {"label": "gone", "position": [1, 2, 3], "positionStatus": "undefined"}]})")));
  ASSERT_EQ(this->List->GetNumberOfMeasurements(), 1);
  EXPECT_EQ(this->List->GetName(0), "kept");
  ASSERT_EQ(this->Log.Warnings.size(), 1u);
  for (const char* const word : { "\"cut\"", "\"box\"", "\"begun\"", "1 point." })
  {
    EXPECT_NE(this->Log.Warnings[0].find(word), std::string::npos) << word;
  }
  this->Log.Warnings.clear();
}

TEST_F(Markups, RefusesWhatIsNoFileOfMarkups)
{
  this->Refuse("no JSON", { "not JSON", "Read.mrk.json" });
  this->Refuse(
    "{" + Schema + R"(, "markups": )" + std::string(70, '[') + std::string(70, ']') + "}",
    { "nested more than 64 deep", "Read.mrk.json" });
  this->Refuse("[]", { "@schema" });
  this->Refuse(R"({"markups": []})", { "@schema" });
  this->Refuse("{" + Schema + "}", { "\"markups\"" });
  this->Refuse(MarkupFile(R"({"name": "no type"})"), { "markups[0]", "type" });
  this->Refuse(
    MarkupFile(R"({"type": "Line", "controlPoints": 5})"), { "markups[0].controlPoints" });
  this->Refuse(MarkupFile(R"({"type": "Line", "controlPoints": [5]})"), { "controlPoints[0]" });
  this->Refuse(MarkupFile(R"({"type": "Line", "controlPoints": [{"position": [1, 2]}]})"),
    { "markups[0].controlPoints[0].position", "three numbers" });
  this->Refuse(MarkupFile(R"({"type": "Line", "controlPoints": [{}]})"), { "position" });
  this->Refuse(MarkupFile(R"({"type": "Line", "coordinateSystem": "XYZ", "controlPoints": []})"),
    { "coordinateSystem", "\"LPS\"" });
  this->Refuse(MarkupFile(R"({"type": "Line", "coordinateUnits": "inch", "controlPoints": []})"),
    { "inch", "\"mm\"" });
  this->Refuse(
    MarkupFile(R"({"type": "Fiducial", "controlPoints": [{"position": [NaN, 0, 0]}]})"), { "NaN" });
  this->Refuse(MarkupFile(R"({"type": "ClosedCurve", "controlPoints": [], "volumeHaptics": {}})"),
    { "markups[0].volumeHaptics", "triangles" });
  this->Refuse(
    MarkupFile(
      R"({"type": "ClosedCurve", "controlPoints": [], "volumeHaptics": {"points": [[0,0,0]], "triangles": [[0,1]]}})"),
    { "triangles[0]" });
}

TEST_F(Markups, WritesWhatTheSchemaAllows)
{
  using M = vtkHapticMeasurements;
  const std::vector<Point> points = { { 1, 2, 3 }, { 4, 6, 3 }, { 4, 6, 10 } };
  this->List->AddMeasurement(M::POINT, MakeFelt({ points[0] }), "a");
  this->List->AddMeasurement(M::POINT, MakeFelt({ points[1] }), "b");
  this->List->AddDistance(points[0].data(), points[1].data(), "d");
  this->List->AddMeasurement(M::ANGLE, MakeFelt(points), "w");
  this->List->AddMeasurement(M::PATH, MakeFelt(points), "p");
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(4, 4);
  plane->Update();
  this->List->AddMeasurement(M::AREA, plane->GetOutput(), "s");
  const Json::Value root = this->Write();
  EXPECT_NE(root["@schema"].asString().find("markups-schema-v1.0.3.json"), std::string::npos);
  const Json::Value& markups = root["markups"];
  ASSERT_EQ(markups.size(), 5u) << "the two points are one list";
  const char* const types[] = { "Fiducial", "Line", "Angle", "Curve", "ClosedCurve" };
  // Members of a control point and of a measurement that the schema allows.
  const std::set<std::string> ofPoint = { "id", "label", "description", "associatedNodeID",
    "position", "orientation", "selected", "locked", "visibility", "positionStatus" };
  const std::set<std::string> ofMeasurement = { "name", "enabled", "value", "units", "description",
    "printFormat", "quantityCode", "derivationCode", "methodCode", "controlPointValues" };
  for (Json::ArrayIndex i = 0; i < markups.size(); ++i)
  {
    SCOPED_TRACE(types[i]);
    const Json::Value& markup = markups[i];
    EXPECT_EQ(markup["type"].asString(), types[i]);
    EXPECT_TRUE(markup["name"].isString());
    EXPECT_EQ(markup["coordinateSystem"].asString(), "LPS");
    EXPECT_EQ(markup["coordinateUnits"].asString(), "mm");
    for (const Json::Value& point : markup["controlPoints"])
    {
      for (const std::string& member : point.getMemberNames())
      {
        EXPECT_EQ(ofPoint.count(member), 1u) << member;
      }
      EXPECT_TRUE(point["id"].isString());
      EXPECT_TRUE(point["label"].isString());
      EXPECT_EQ(point["position"].size(), 3u);
      EXPECT_EQ(point["positionStatus"].asString(), "defined");
    }
    for (const Json::Value& measurement : markup["measurements"])
    {
      for (const std::string& member : measurement.getMemberNames())
      {
        EXPECT_EQ(ofMeasurement.count(member), 1u) << member;
      }
      if (measurement.isMember("controlPointValues"))
      {
        EXPECT_EQ(measurement["controlPointValues"].size(), markup["controlPoints"].size());
      }
    }
  }
  EXPECT_EQ(markups[1]["measurements"][0]["value"].asDouble(), 5.0);
  EXPECT_EQ(markups[1]["measurements"][0]["units"].asString(), "mm");
  EXPECT_EQ(markups[4]["measurements"][0]["units"].asString(), "mm2");
  EXPECT_NEAR(markups[4]["measurements"][0]["value"].asDouble(), 1.0, 1e-12);
  EXPECT_EQ(markups[4]["controlPoints"].size(), 16u) << "around 4 x 4 squares";
}
