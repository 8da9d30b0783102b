// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests the selection of a trace's arrays. */

#include "Rigs/ApiRig.h"

#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

using namespace apitest;

namespace
{
class TraceArrays : public ApiTest
{
protected:
  std::vector<std::string> Names()
  {
    std::vector<std::string> names;
    vtkPointData* const arrays = this->Run(51)->GetPointData();
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      names.emplace_back(arrays->GetArrayName(i));
    }
    return names;
  }
};

using Texts = std::vector<std::string>;

/// Arrays in the class documentation of vtkVolumeHapticsFilter, except Label, DataTime, the eight
/// ModeForce_i and the four arrays of every tool.
const Texts All = { "Time", "Tip", "Force", "NormalForce", "FrictionForce", "DragForce", "Normal",
  "Value", "GradientMagnitude", "SurfaceValue", "MediumValue", "Stiffness", "Friction", "Viscosity",
  "SurfaceStrength", "Contact", "Unfinished", "Renewed", "Energy" };

/// Reads the names of the arrays in the class documentation of each tool.
std::set<std::string> ReadArraysOfTools()
{
  std::set<std::string> names;
  const std::filesystem::path folder = VolumeHaptics_SOURCE_DIR "/Module/VTK/Tools";
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    const bool isTool = entry.path().filename().string().rfind("vtkHaptic", 0) == 0;
    std::ifstream file(entry.path());
    bool isListed = false;
    for (std::string line; isTool && std::getline(file, line) && line != " */";)
    {
      isListed = isListed || line.find("that only this tool has:") != std::string::npos;
      std::smatch name;
      if (isListed && std::regex_match(line, name, std::regex(R"( \*   (\w+)( \(\d\))?  .*)")))
      {
        names.insert(name[1]);
      }
      isListed = isListed && (line == " *" || !name.empty() || line.back() == ':');
    }
  }
  return names;
}
} // namespace

TEST_F(TraceArrays, AreAllByDefault)
{
  EXPECT_EQ(this->Filter->GetTraceArrays(), "all");
  EXPECT_EQ(this->Names(), All);
  Texts expected = All;
  expected.insert(expected.end(), { "Label", "DataTime" });
  for (int mode = 0; mode < 8; ++mode)
  {
    expected.push_back("ModeForce_" + std::to_string(mode));
  }
  expected.insert(expected.end(), { "Orientation", "Torque", "Depth", "ShaftForce" });
  Texts choices;
  for (int i = 0; i < this->Filter->GetNumberOfTraceArrays(); ++i)
  {
    choices.emplace_back(this->Filter->GetTraceArrayName(i));
  }
  ASSERT_GE(choices.size(), expected.size() + 3);
  const auto ofTools = choices.begin() + static_cast<std::ptrdiff_t>(expected.size());
  EXPECT_EQ(Texts(choices.begin(), ofTools), expected);
  const std::set<std::string> documented = ReadArraysOfTools();
  EXPECT_EQ(std::set<std::string>(ofTools, choices.end()), documented);
  EXPECT_EQ(documented.size(), choices.size() - expected.size());
  for (const char* const name : { "ForbiddenTouches", "RemovedVolume", "ToolOrientation" })
  {
    EXPECT_EQ(documented.count(name), 1U) << name;
  }
}

TEST_F(TraceArrays, TheChosenOnesAreTheSameToTheBit)
{
  const auto full = (this->Run(51), Keep(this->Filter));
  for (const std::string& name : All)
  {
    SCOPED_TRACE(name);
    EXPECT_TRUE(this->Filter->SetTraceArrays(name.c_str()));
    EXPECT_EQ(this->Filter->GetTraceArrays(), name);
    ASSERT_EQ(this->Names(), Texts{ name });
    vtkDataArray* const whole = full->GetPointData()->GetArray(name.c_str());
    for (vtkIdType tick = 0; tick < 51; ++tick)
    {
      for (int c = 0; c < whole->GetNumberOfComponents(); ++c)
      {
        ASSERT_EQ(
          Get(this->Filter->GetOutput(), name.c_str(), tick, c), whole->GetComponent(tick, c));
      }
      ASSERT_EQ(this->Filter->GetOutput()->GetPoint(tick)[2], full->GetPoint(tick)[2]);
    }
  }
}

TEST_F(TraceArrays, TakeTextsAndStringArrays)
{
  EXPECT_TRUE(this->Filter->SetTraceArrays(" Contact,Force ,\tTime, Force,"));
  EXPECT_EQ(this->Filter->GetTraceArrays(), "Time, Force, Contact");
  EXPECT_EQ(this->Names(), (Texts{ "Time", "Force", "Contact" }));
  const vtkMTimeType time = this->Filter->GetMTime();
  EXPECT_TRUE(this->Filter->SetTraceArrays("Time Force Contact"));
  EXPECT_EQ(this->Filter->GetMTime(), time) << "the same choice is no change";

  vtkNew<vtkStringArray> names;
  names->InsertNextValue("Energy");
  names->InsertNextValue("Tip");
  EXPECT_TRUE(this->Filter->SetTraceArrays(names));
  EXPECT_EQ(this->Names(), (Texts{ "Tip", "Energy" }));
  names->Initialize();
  EXPECT_TRUE(this->Filter->SetTraceArrays(names));
  EXPECT_EQ(this->Filter->GetTraceArrays(), "none");
  EXPECT_TRUE(this->Names().empty());
  EXPECT_TRUE(this->Filter->SetTraceArrays("all"));
  EXPECT_EQ(this->Names(), All);
  EXPECT_TRUE(this->Filter->SetTraceArrays("none"));
  EXPECT_TRUE(this->Names().empty());
  EXPECT_TRUE(this->Filter->SetTraceArrays(static_cast<const char*>(nullptr)));
  EXPECT_EQ(this->Filter->GetTraceArrays(), "all");
  std::ostringstream text;
  this->Filter->SetTraceArrays("Force");
  this->Filter->PrintSelf(text, vtkIndent());
  EXPECT_NE(text.str().find("TraceArrays: Force\n"), std::string::npos);
}

TEST_F(TraceArrays, AnUnknownOneIsAnErrorThatListsThem)
{
  ASSERT_TRUE(this->Filter->SetTraceArrays("Force"));
  for (const char* names : { "Force, Furce", "furce", "all, Force", "Force none", "\"Force\"" })
  {
    SCOPED_TRACE(names);
    EXPECT_FALSE(this->Filter->SetTraceArrays(names));
    ASSERT_EQ(this->Log.Errors.size(), 1U);
    EXPECT_NE(this->Log.Errors[0].find("There is no trace array"), std::string::npos);
    for (const std::string& known : All)
    {
      EXPECT_NE(this->Log.Errors[0].find('"' + known + '"'), std::string::npos);
    }
    EXPECT_NE(this->Log.Errors[0].find("\"Label\""), std::string::npos);
    this->Log.Errors.clear();
    EXPECT_EQ(this->Filter->GetTraceArrays(), "Force");
  }
}

TEST_F(TraceArrays, HaveAStatusEach)
{
  for (int i = 0; i < this->Filter->GetNumberOfTraceArrays(); ++i)
  {
    const char* const name = this->Filter->GetTraceArrayName(i);
    ASSERT_NE(name, nullptr);
    EXPECT_EQ(this->Filter->GetTraceArrayStatus(name), 1) << name;
    this->Filter->SetTraceArrayStatus(name, 0);
    EXPECT_EQ(this->Filter->GetTraceArrayStatus(name), 0) << name;
  }
  EXPECT_EQ(this->Filter->GetTraceArrays(), "none");
  this->Filter->SetTraceArrayStatus("Contact", 1);
  this->Filter->SetTraceArrayStatus("Force", 1);
  EXPECT_EQ(this->Names(), (Texts{ "Force", "Contact" }));
  EXPECT_EQ(this->Filter->GetTraceArrayName(-1), nullptr);
  EXPECT_EQ(this->Filter->GetTraceArrayName(this->Filter->GetNumberOfTraceArrays()), nullptr);
  EXPECT_EQ(this->Filter->GetTraceArrayStatus("Furce"), 0);
  EXPECT_TRUE(this->Log.Errors.empty());
  this->Filter->SetTraceArrayStatus("Furce", 0);
  ASSERT_EQ(this->Log.Errors.size(), 1U);
  EXPECT_NE(this->Log.Errors[0].find("\"Furce\""), std::string::npos);
  EXPECT_EQ(this->Filter->GetTraceArrays(), "Force, Contact");
}

TEST_F(TraceArrays, LabelsAreOneOfThem)
{
  this->Filter->SetLabelData(MakeImage(16, VTK_SHORT, [](const Point&) { return 4.0; }));
  this->Filter->SetTraceArrays("Label");
  EXPECT_EQ(this->Names(), Texts{ "Label" });
  EXPECT_EQ(Get(this->Filter->GetOutput(), "Label", 50), 4.0);
  this->Filter->SetTraceArrays("Force");
  EXPECT_EQ(this->Names(), Texts{ "Force" });
}

TEST_F(TraceArrays, KeepTheirMemoryAsLongAsAnythingUsesIt)
{
  // Later traces reuse the memory of a deleted trace. They must not reuse memory that is in use by
  // an output, by an array, or by two arrays that share it.
  std::vector<vtkSmartPointer<vtkPolyData>> outputs;
  std::vector<vtkSmartPointer<vtkDataArray>> shared;
  const auto zOf = [](int run) { return 5.0 + 0.25 * run; };
  constexpr int runs = 12;
  constexpr int ticks = 3001;
  for (int run = 0; run < runs; ++run)
  {
    this->Filter->SetPathData(
      MakePath(Line({ 7, 7, zOf(run) }, { 7, 7, 5 + zOf(run) }, ticks - 1)));
    vtkPolyData* const output = this->Run(ticks);
    vtkDataArray* const tips = output->GetPointData()->GetArray("Tip");
    if (run % 3 == 0)
    {
      outputs.push_back(Keep(this->Filter));
      vtkSmartPointer<vtkDataArray> other;
      other.TakeReference(tips->NewInstance());
      other->ShallowCopy(tips);
      shared.push_back(other);
    }
    else if (run % 3 == 1)
    {
      vtkNew<vtkPolyData> copy;
      copy->ShallowCopy(output);
      outputs.emplace_back(copy.Get());
      shared.emplace_back(tips);
    }
    else
    {
      // Arrays that grow or are emptied release their memory.
      tips->Resize(2 * ticks);
      tips->InsertNextTuple3(1.0, 2.0, 3.0);
      EXPECT_NEAR(tips->GetComponent(ticks - 1, 2), 5 + zOf(run), 1e-9);
      output->GetPointData()->GetArray("Force")->Initialize();
      output->GetPointData()->GetArray("Time")->Squeeze();
      output->Initialize();
    }
  }
  for (std::size_t i = 0; i < shared.size(); ++i)
  {
    const int run = static_cast<int>(i / 2 * 3 + i % 2);
    for (vtkDataArray* const tips :
      { shared[i].Get(), outputs[i]->GetPointData()->GetArray("Tip") })
    {
      EXPECT_NEAR(tips->GetComponent(0, 2), zOf(run), 1e-9);
      EXPECT_NEAR(tips->GetComponent(ticks - 1, 2), 5 + zOf(run), 1e-9);
    }
    EXPECT_NEAR(outputs[i]->GetPoint(0)[2], zOf(run), 1e-9);
  }
}
