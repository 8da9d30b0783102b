// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Fixture with a scene whose settings must survive invalid files. */
#ifndef SetupErrorsRig_h
#define SetupErrorsRig_h

#include "RandomSetup.h"

namespace setuptest
{
class SetupErrors : public testing::Test
{
protected:
  SetupErrors() { this->Good = this->Save("Good.json"); }

  std::string Save(const char* name)
  {
    const std::string file = File(name);
    EXPECT_TRUE(this->Target.Setup->Save(file.c_str()));
    return Read(file);
  }

  void ExpectError(const std::vector<std::string>& words)
  {
    ASSERT_EQ(this->Target.Log.Errors.size(), 1U);
    for (const std::string& word : words)
    {
      EXPECT_NE(this->Target.Log.Errors[0].find(word), std::string::npos)
        << word << " in " << this->Target.Log.Errors[0];
    }
    this->Target.Log.Errors.clear();
  }

  /// Loads a text, and expects an error with these words and unchanged settings.
  void Refuse(const std::string& text, std::vector<std::string> words)
  {
    const std::string file = File("Bad.json");
    std::ofstream(file) << text;
    EXPECT_FALSE(this->Target.Setup->Load(file.c_str())) << text.substr(0, 200);
    words.push_back(file);
    this->ExpectError(words);
    EXPECT_EQ(this->Save("After.json"), this->Good);
  }

  /// Returns the valid file with another value for the first key of this name.
  std::string With(const std::string& key, const std::string& value)
  {
    const std::size_t colon = this->Good.find(" : ", this->Good.find('"' + key + '"'));
    const std::size_t end = this->Good.find_first_of(",\n", colon);
    return this->Good.substr(0, colon) + " : " + value + this->Good.substr(end);
  }

  /// Returns a file with two haptics keys. The first differs from the target's setting, and the
  /// second, `bad`, must be refused.
  std::string Haptics(const std::string& bad)
  {
    return R"({"Format":"VTK Volume Haptics setup","Version":1,"DeviceToWorld":)"
           R"([1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],"Haptics":{"KernelRadius":7,)" +
      bad + "}}";
  }

  RandomScene Target{ 11 };
  std::string Good;
};
} // namespace setuptest

#endif
