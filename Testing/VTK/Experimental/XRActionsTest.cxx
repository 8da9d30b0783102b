// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests action manifests in the format that VTK's vtkOpenXRRenderWindowInteractor reads: "actions",
 * "default_bindings" and "localization" in one file, "bindings" with "sources" and "haptics" in the
 * others (see its LoadActions and LoadDefaultBinding, 9.2 to 9.6).
 */

#include "Rigs/ApiRig.h"
#include "Rigs/TemporaryFolder.h"

#include <vtkHapticXRController.h>
#include <vtk_jsoncpp.h>

#include <filesystem>
#include <fstream>
#include <iterator>

using namespace apitest;

namespace
{
const char* const ActionsText = R"({
  "actions": [ { "name": "handpose", "type": "pose" }, { "name": "haptic", "type": "vibration" } ],
  "default_bindings": [
    { "binding_url": "simple.json", "controller_type": "khr_simple" },
    { "binding_url": "hands.json", "controller_type": "hands" },
    { "binding_url": "index.json", "controller_type": "knuckles" } ],
  "action_sets": [ { "name": "vtk-actions" } ],
  "localization": [ { "handpose": "Hand Pose", "haptic": "Haptic", "language_tag": "en_US" } ]
})";

std::string BindingText(const std::string& profile, const std::string& haptics)
{
  return R"({ "interaction_profile": "/interaction_profiles/)" + profile +
    R"(", "bindings": { "vtk-actions": { "sources": [ { "path": "/user/hand/left/input/aim",
    "inputs": { "pose": { "output": "handpose" } } } ])" +
    haptics + "} } }";
}

class XRActions : public testing::Test
{
protected:
  XRActions()
  {
    std::filesystem::create_directories(this->From);
    this->Save("actions.json", ActionsText);
    this->Save("simple.json", BindingText("khr/simple_controller", ""));
    this->Save("hands.json", BindingText("microsoft/hand_interaction", ""));
    this->Save("index.json",
      BindingText("valve/index_controller",
        R"(, "haptics": [ { "path": "/user/hand/left/output/haptic", "output": "mine" } ])"));
  }
  void Save(const std::string& name, const std::string& text)
  {
    std::ofstream(this->From + "/" + name) << text;
  }
  bool Copy(const std::string& to = TemporaryPath("to/deep"))
  {
    return this->Controller->WriteActions((this->From + "/actions.json").c_str(), to.c_str());
  }
  static Json::Value Load(const std::string& name)
  {
    std::ifstream file(TemporaryPath("to/deep/" + name));
    Json::Value root;
    file >> root;
    return root;
  }
  /// Returns "action at path" for each haptic output of a binding.
  static std::vector<std::string> Haptics(const std::string& name)
  {
    const Json::Value binding = Load(name);
    std::vector<std::string> all;
    for (const Json::Value& haptic : binding["bindings"]["vtk-actions"]["haptics"])
    {
      all.push_back(haptic["output"].asString() + " at " + haptic["path"].asString());
    }
    return all;
  }
  void ExpectError(const char* words)
  {
    this->Log.Errors.clear();
    EXPECT_FALSE(this->Copy());
    ASSERT_EQ(this->Log.Errors.size(), 1U);
    EXPECT_NE(this->Log.Errors[0].find(words), std::string::npos) << this->Log.Errors[0];
  }

  const std::string From = TemporaryPath("from");
  vtkNew<vtkHapticXRController> Controller;
  MessageLog Log{ this->Controller };
};
} // namespace

TEST_F(XRActions, AreCopiedWithTheMotorsOfBothHandsBound)
{
  ASSERT_TRUE(this->Copy());
  const std::vector<std::string> both{ "haptic at /user/hand/left/output/haptic",
    "haptic at /user/hand/right/output/haptic" };
  EXPECT_EQ(this->Haptics("simple.json"), both);
  EXPECT_TRUE(this->Haptics("hands.json").empty()) << "bare hands have no motors";
  const std::vector<std::string> other{ "mine at /user/hand/left/output/haptic",
    "haptic at /user/hand/right/output/haptic" };
  EXPECT_EQ(this->Haptics("index.json"), other) << "what is bound stays";
  const Json::Value simple = this->Load("simple.json");
  EXPECT_EQ(simple["bindings"]["vtk-actions"]["sources"].size(), 1U);
  Json::Value expected;
  std::ifstream(this->From + "/actions.json") >> expected;
  EXPECT_EQ(this->Load("actions.json"), expected) << "the action was there";
  // A second call must change nothing.
  ASSERT_TRUE(this->Controller->WriteActions(
    TemporaryPath("to/deep/actions.json").c_str(), TemporaryPath("to/deep").c_str()));
  EXPECT_EQ(this->Haptics("simple.json"), both);
}

TEST_F(XRActions, AnActionOfAnotherNameIsAdded)
{
  this->Controller->SetActionName("buzz");
  ASSERT_TRUE(this->Copy());
  const Json::Value actions = this->Load("actions.json");
  ASSERT_EQ(actions["actions"].size(), 3U);
  EXPECT_EQ(actions["actions"][2]["name"], "buzz");
  EXPECT_EQ(actions["actions"][2]["type"], "vibration");
  EXPECT_FALSE(actions["localization"][0]["buzz"].asString().empty()) << "OpenXR wants a text";
  EXPECT_EQ(this->Haptics("simple.json")[1], "buzz at /user/hand/right/output/haptic");
}

TEST_F(XRActions, FilesThatAreNoneAreOneErrorWithTheCure)
{
  this->Save("hands.json", "[ 1, 2 ]");
  this->ExpectError("hands.json\" is no manifest of actions or bindings in JSON");
  std::filesystem::remove(this->From + "/hands.json");
  this->ExpectError("hands.json\" can't be read: it does not exist");
  this->Save("actions.json", R"({ "actions": [], "default_bindings": [ { "controller": 1 } ] })");
  this->ExpectError("has a binding without a binding_url");
  this->Save("actions.json", "{ \"actions\": ");
  this->ExpectError("Give VTK's vtk_openxr_actions.json");
  std::string nested;
  for (int i = 0; i < 5000; ++i)
  {
    nested += "{\"a\":[";
  }
  this->Save("actions.json", nested);
  this->ExpectError("is no manifest");
  this->Save("actions.json",
    // The text is valid JSON, but has 70 nested levels.
    "{ \"actions\": " + std::string(70, '[') + std::string(70, ']') + " }");
  this->ExpectError("nested more than 64 deep");
  this->Log.Errors.clear();
  EXPECT_FALSE(this->Controller->WriteActions(nullptr, "x"));
  EXPECT_EQ(this->Log.Errors.size(), 1U);
  this->Save("actions.json", ActionsText);
  this->Save("file", "");
  this->Log.Errors.clear();
  EXPECT_FALSE(this->Copy(this->From + "/file/below"));
  ASSERT_EQ(this->Log.Errors.size(), 1U);
  EXPECT_NE(this->Log.Errors[0].find("can't be made"), std::string::npos) << this->Log.Errors[0];
}
