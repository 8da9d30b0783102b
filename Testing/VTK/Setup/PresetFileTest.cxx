// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests preset files: the restored functions, and the errors for other files. */

#include "SetupRig.h"

#include <vtkStringArray.h>

#include <cmath>
#include <limits>

#include <sys/stat.h>
#include <unistd.h>

using namespace setuptest;

namespace
{
void Write(const std::string& file, const std::string& text)
{
  std::ofstream(file) << text;
}

class PresetFile : public testing::Test
{
protected:
  static std::vector<vtkPiecewiseFunction*> Functions(vtkHapticProperty* p)
  {
    return { p->GetStiffness(), p->GetFriction(), p->GetViscosity(), p->GetSurfaceStrength(),
      p->GetDistinctness() };
  }
  /// Expects that both properties have functions with bitwise equal nodes.
  static void ExpectSame(vtkHapticProperty* a, vtkHapticProperty* b)
  {
    for (std::size_t f = 0; f < 5; ++f)
    {
      vtkPiecewiseFunction* const one = Functions(a)[f];
      vtkPiecewiseFunction* const other = Functions(b)[f];
      ASSERT_EQ(one->GetSize(), other->GetSize()) << f;
      EXPECT_EQ(one->GetClamping(), other->GetClamping());
      EXPECT_EQ(one->GetUseLogScale(), other->GetUseLogScale());
      for (int i = 0; i < one->GetSize(); ++i)
      {
        double x[4];
        double y[4];
        one->GetNodeValue(i, x);
        other->GetNodeValue(i, y);
        EXPECT_TRUE(std::equal(x, x + 4, y)) << "function " << f << ", node " << i;
      }
    }
    EXPECT_EQ(a->GetSurfaceSide(), b->GetSurfaceSide());
    EXPECT_EQ(a->GetDistinctnessFromNoise(), b->GetDistinctnessFromNoise());
    EXPECT_EQ(a->GetDistinctnessPerMillimeter(), b->GetDistinctnessPerMillimeter());
    EXPECT_EQ(a->GetScalarsAreLabels(), b->GetScalarsAreLabels());
    EXPECT_EQ(a->GetSolidFromImage(), b->GetSolidFromImage());
    EXPECT_EQ(a->GetShiftFromImage(), b->GetShiftFromImage());
    ASSERT_EQ(a->GetNumberOfTissues(), b->GetNumberOfTissues());
    for (int i = 0; i < a->GetNumberOfTissues(); ++i)
    {
      double x[2];
      double y[2];
      a->GetTissueRange(i, x);
      b->GetTissueRange(i, y);
      EXPECT_STREQ(a->GetTissueName(i), b->GetTissueName(i));
      EXPECT_TRUE(x[0] == y[0] && x[1] == y[1]) << i;
    }
  }
  bool Says(const std::string& words)
  {
    return this->Log.Errors.size() == 1 && this->Log.Errors[0].find(words) != std::string::npos;
  }
  /// Expects one error with these words and the file's name, and an unchanged property.
  void ExpectRefused(const std::string& file, const std::string& words)
  {
    SCOPED_TRACE(words);
    vtkNew<vtkHapticProperty> before;
    before->DeepCopy(this->Property);
    const vtkMTimeType time = this->Property->GetMTime();
    this->Log.Errors.clear();
    EXPECT_FALSE(this->Property->ReadPreset(file.c_str()));
    EXPECT_TRUE(this->Says(words)) << (this->Log.Errors.empty() ? "nothing" : this->Log.Errors[0]);
    EXPECT_TRUE(file.empty() || this->Says(file)) << this->Log.Errors[0];
    EXPECT_EQ(this->Property->GetMTime(), time);
    ExpectSame(before, this->Property);
  }

  vtkNew<vtkHapticProperty> Property;
  MessageLog Log{ this->Property };
};
} // namespace

TEST_F(PresetFile, BringsBackEveryPresetToTheBit)
{
  const std::string file = File("preset.json");
  vtkStringArray* const names = vtkHapticProperty::GetPresetNames();
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    SCOPED_TRACE(names->GetValue(i));
    ASSERT_TRUE(this->Property->ApplyPreset(names->GetValue(i).c_str()));
    ASSERT_TRUE(this->Property->WritePreset(file.c_str()));
    vtkNew<vtkHapticProperty> read;
    read->GetStiffness()->AddPoint(7.0, 7.0);
    read->SetSurfaceSideToLower();
    read->DistinctnessFromNoiseOff();
    read->AddTissue("something else", 1e6, 1e7);
    ASSERT_TRUE(read->ApplyPreset(file.c_str())) << "as any preset";
    ExpectSame(this->Property, read);
  }
  EXPECT_TRUE(this->Log.Errors.empty());
}

TEST_F(PresetFile, BringsBackWhatWasEdited)
{
  this->Property->ApplyPreset("MRI");
  this->Property->GetStiffness()->AddPoint(1.0 / 3.0, 1e5 / 7.0, 0.25, 0.75);
  this->Property->GetFriction()->RemoveAllPoints();
  this->Property->GetViscosity()->ClampingOff();
  this->Property->GetViscosity()->UseLogScaleOn();
  this->Property->AddTissue("Gef\xC3\xA4\xC3\x9F \"A\"", 300.0, 400.0);
  this->Property->SetComponent(2);
  this->Property->SetScalarShift(-1024.0);
  this->Property->SetScalarScale(0.5);
  const std::string file = File("edited.json");
  ASSERT_TRUE(this->Property->WritePreset(file.c_str()));
  vtkNew<vtkHapticProperty> read;
  vtkNew<vtkVolumeProperty> visible;
  read->SetComponent(1);
  read->SetScalarShift(7.0);
  read->SetScalarScale(2.0);
  read->SetVisibilityFrom(visible);
  vtkPiecewiseFunction* const stiffness = read->GetStiffness();
  ASSERT_TRUE(read->ReadPreset(file.c_str()));
  ExpectSame(this->Property, read);
  EXPECT_EQ(read->GetStiffness(), stiffness) << "in place";
  EXPECT_EQ(read->GetComponent(), 1) << "a preset is for any component";
  EXPECT_EQ(read->GetVisibilityFrom(), visible.Get());
  EXPECT_EQ(Read(file).find("Component"), std::string::npos);
  EXPECT_EQ(read->GetScalarShift(), 7.0) << "nor of data that is stored in one way";
  EXPECT_EQ(read->GetScalarScale(), 2.0);
}

TEST_F(PresetFile, ThatAHandWroteNeedsNoMoreThanAFunction)
{
  const std::string file = File("by_hand.JSON");
  Write(file, R"({"Format": "VTK Volume Haptics preset", "Version": 1,
    "Tissues": {"wood": [10, 20], "air": [0, 2]},
    "SurfaceStrength": {"Nodes": [[0, 0, 0.5, 0], [15, 2.5, 0.5, 0]]}})");
  this->Property->ApplyPreset("CT contrast");
  ASSERT_TRUE(this->Property->ApplyPreset(file.c_str())) << "whatever the case of its ending";
  EXPECT_EQ(this->Property->GetSurfaceStrength()->GetValue(7.5), 1.25);
  EXPECT_EQ(this->Property->GetStiffness()->GetSize(), 0) << "its default, not that of before";
  EXPECT_TRUE(this->Property->GetDistinctnessFromNoise());
  EXPECT_FALSE(this->Property->GetDistinctnessPerMillimeter());
  ASSERT_EQ(this->Property->GetNumberOfTissues(), 2);
  EXPECT_STREQ(this->Property->GetTissueName(0), "air");
}

TEST_F(PresetFile, ThatIsNoneIsOneErrorWithTheCure)
{
  this->Property->ApplyPreset("CT contrast");
  const std::string file = File("bad.json");
  const auto refuse = [&](const std::string& text, const std::string& words)
  {
    Write(file, text);
    this->ExpectRefused(file, words);
  };
  const std::string head = R"({"Format": "VTK Volume Haptics preset", "Version": 1, )";
  this->ExpectRefused(File("missing.json"), "Choose a file that exists");
  this->ExpectRefused("", "Give ReadPreset() the name of one");
  this->ExpectRefused(File(""), "can't be read");
  refuse("", "not JSON");
  refuse("{\"Format\": ", "not JSON");
  refuse("[1, 2]", "Choose a file that vtkHapticProperty::WritePreset() wrote");
  refuse(
    R"({"Format": "VTK Volume Haptics setup", "Version": 1, "Stiffness": {}})", "not a preset");
  refuse(R"({"Format": "VTK Volume Haptics preset", "Version": 9, "Stiffness": {}})", "newer");
  refuse(R"({"Format": "VTK Volume Haptics preset", "Version": "1", "Stiffness": {}})", "Version");
  refuse(head + R"("Tissues": {}})", "none of the functions");
  refuse(head + R"("Stiffness": 7})", "Stiffness is 7, but has to be an object");
  refuse(head + R"("Stiffness": {"Nodes": [[0, -1, 0.5, 0]]}})", "Stiffness.Nodes[0]");
  refuse(head + R"("Stiffness": {"Nodes": [[1, 1, 0.5, 0], [0, 1, 0.5, 0]]}})", "Nodes[1]");
  refuse(head + R"("Friction": {"Nodes": [[0, NaN, 0.5, 0]]}})", "Friction.Nodes[0][1]");
  refuse(head + R"("Stiffness": {}, "SurfaceSide": "Inner"})", "\"Higher\", \"Lower\", \"Both\"");
  refuse(head + R"("Stiffness": {}, "Tissues": {"a": [2, 1]}})", "Tissues.a");
  refuse(head + R"("Stiffness": {}, "Tissues": {"a": [0, 2], "b": [2, 3]}})", "Tissues.b");
  refuse(head + R"("Stiffness": {}, "Tissues": {"": [0, 2]}})", "lower one first");
  refuse(head + R"("Stiffness": {}, "Tissues": {"a": "b"}})", "a list of 2 numbers");
  refuse(head + R"("Stiffness": {}, "Note": )" + std::string(70, '[') + std::string(70, ']') + "}",
    "nested more than 64 deep"); // freeing deep lists is recursive
  refuse(std::string(2 << 20, ' '), "can't be read");

  // A truncated file must be refused.
  ASSERT_TRUE(this->Property->WritePreset(file.c_str()));
  const std::string good = Read(file);
  for (std::size_t size = 0; size < good.size() - 2; size += 7)
  {
    Write(file, good.substr(0, size));
    EXPECT_FALSE(this->Property->ReadPreset(file.c_str())) << size;
  }
}

TEST_F(PresetFile, IsNotReplacedByOneThatCouldNotBeRead)
{
  const std::string file = File("kept.json");
  this->Property->ApplyPreset("CT contrast");
  ASSERT_TRUE(this->Property->WritePreset(file.c_str()));
  const std::string before = Read(file);
  this->Property->GetStiffness()->AddPoint(0.0, std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(this->Property->WritePreset(file.c_str()));
  EXPECT_TRUE(this->Says("Correct this function first"));
  EXPECT_EQ(Read(file), before);
  this->Log.Errors.clear();
  this->Property->ApplyPreset("CT contrast");
  EXPECT_FALSE(this->Property->WritePreset(File("no/such/folder.json").c_str()));
  EXPECT_TRUE(this->Says("can't be written"));
  this->Log.Errors.clear();
  EXPECT_FALSE(this->Property->WritePreset(nullptr));
  EXPECT_TRUE(this->Says("Give WritePreset() the name of one"));
}

TEST_F(PresetFile, TissuesAreInSetupsToo)
{
  Scene scene;
  scene.Filter->GetProperty()->ApplyPreset("CT chest");
  const std::string file = File("tissues.json");
  ASSERT_TRUE(scene.Setup->Save(file.c_str()));
  scene.Filter->GetProperty()->RemoveAllTissues();
  ASSERT_TRUE(scene.Setup->Load(file.c_str()));
  ASSERT_EQ(scene.Filter->GetProperty()->GetNumberOfTissues(), 6);
  EXPECT_STREQ(scene.Filter->GetProperty()->GetTissueName(1), "lung");
}
