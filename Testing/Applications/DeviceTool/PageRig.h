// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Types the commands that a device's documentation page lists, line by line, as the device's owner
 * would.
 */
#ifndef PageRig_h
#define PageRig_h

#include "Rigs/TemporaryFolder.h"
#include "ToolRig.h"

#include <cstdlib>
#include <fstream>

namespace emulated
{

class PageTest : public ToolTest
{
protected:
  /// Starts with an empty file of devices, so that no device counts as confirmed.
  PageTest()
  {
    const std::string file = TemporaryPath("devices.txt");
    std::ofstream(file).close();
    setenv("VOLUMEHAPTICS_DEVICES", file.c_str(), 1);
  }

  /**
   * Types the volumehaptics-device commands of Documentation/devices/PAGE, except commands for
   * other ids, and presses Enter at each question. `instead` is the emulated device's id if it
   * differs from the page's. Returns the number of commands.
   */
  int Type(const std::string& page, const std::string& id, const std::string& instead = "",
    const std::string& firmware = "")
  {
    std::ifstream file(std::string(VOLUME_HAPTICS_PAGES) + page);
    EXPECT_TRUE(file) << page;
    int typed = 0;
    for (std::string line; std::getline(file, line);)
    {
      std::istringstream words(line.substr(0, line.find('#')));
      std::vector<std::string> arguments;
      for (std::string word; words >> word;)
      {
        arguments.push_back(word == id && !instead.empty() ? instead
            : word == "nvent.bin"                          ? firmware
                                                           : word);
      }
      const bool isCall = arguments.size() > 1 && arguments[0] == "volumehaptics-device";
      if (!isCall || (arguments.size() > 2 && arguments[2] != (instead.empty() ? id : instead)))
      {
        continue;
      }
      arguments.erase(arguments.begin());
      if (arguments[0] == "monitor" || arguments[0] == "test")
      {
        arguments.insert(arguments.end(), { "--seconds", arguments[0] == "test" ? "2" : "0.2" });
      }
      ++typed;
      EXPECT_EQ(this->Run(arguments, "\n\n\n"), 0) << line << "\n" << this->Out << this->Errors;
      if (arguments[0] == "list" && instead.empty())
      {
        EXPECT_TRUE(this->Shows(id.c_str())) << line << this->Out;
        EXPECT_TRUE(this->Shows("available")) << line << this->Out;
      }
    }
    return typed;
  }

  /// Returns the devices that a page's lines give to the explorer.
  static std::vector<std::string> ReadDevices(const std::string& page)
  {
    std::ifstream file(std::string(VOLUME_HAPTICS_PAGES) + page);
    EXPECT_TRUE(file) << page;
    std::vector<std::string> devices;
    for (std::string line; std::getline(file, line);)
    {
      std::istringstream words(line);
      std::string first;
      words >> first;
      for (std::string word; first == "volumehaptics-explore" && words >> word;)
      {
        if (word == "--device" && words >> word)
        {
          devices.push_back(word);
        }
      }
    }
    return devices;
  }
};

} // namespace emulated

#endif
