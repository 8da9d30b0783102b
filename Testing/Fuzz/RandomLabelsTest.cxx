// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Runs the fuzzer's target for tables of labels on random bytes, and on valid files with some bytes
 * changed.
 */

#include "TouchLabels.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace
{
std::string Nifti()
{
  std::string bytes(352, '\0');
  bytes[0] = '\x5C';
  bytes[1] = '\1';
  bytes.replace(344, 3, "n+1");
  bytes[348] = '\1';
  // In this header, the samples begin at byte 416 (416.0 as a float), and the extension has 64
  // bytes.
  bytes.replace(108, 4, std::string("\0\0\xD0\x43", 4));
  bytes +=
    std::string("\x40\0\0\0\0\0\0\0", 8) + "<LabelTable><Label Key=\"1\">a</Label></LabelTable>";
  bytes.resize(450, '1');
  return bytes;
}

const std::string Files[] = { Nifti(),
  "label,name,stiffness,friction,viscosity,strength,felt,forbidden,color,r,g,b\n"
  "5,\"liver, \"\"x\"\"\",300,0.1,0.5,1.5,1,0,#ff3300,,,\n-2,\xC3\xB6,,,,,yes,no,,1,2,3\n",
  "# ITK\n 1 255 0 51 1 1 1 \"Left ventricle\"\n 2 0 1 2 1 1 1 \"\"\n",
  "#No. Label\n0 Unknown 0 0 0 0\n17 Left-Hippocampus 220 216 20 0\n",
  "1 Precentral_L 2001\r\n48\tTapetum_L\r\n",
  "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 2 2 1 1\nspace: RAS\n"
  "space directions: none (1,0,0) (0,1,0) (0,0,1)\nspace origin: (1,2,3)\nencoding: raw\n\n"
  "\1\2\1\2",
  "NRRD0004\ntype: uchar\nSegment0_LabelValue:=1\nSegment0_Layer:=0\nSegment0_Name:=a\\n\n"
  "Segment1_LabelValue:=1\nSegment1_Color:=1 0 0.25\n\n\1" };
} // namespace

TEST(Fuzz, RandomLabelsAreTouched)
{
  for (unsigned seed = 0; seed < 2000; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    // Every tenth file has 768 bytes, which makes it a palette.
    std::vector<std::uint8_t> bytes(seed % 10 == 0 ? 768 : random() % 800);
    for (std::uint8_t& byte : bytes)
    {
      // Half of the files consist of characters that occur in tables of labels.
      byte = static_cast<std::uint8_t>(
        seed % 2 == 0 ? random() : "0123 ,;\"#\n\r:=_aN.-"[random() % 19]);
    }
    TouchLabels(bytes.data(), bytes.size());
  }
}

TEST(Fuzz, SpoiltLabelsAreTouched)
{
  for (unsigned seed = 0; seed < 6000; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::string file = Files[seed % std::size(Files)];
    for (unsigned changes = random() % 6; changes > 0; --changes)
    {
      file[random() % file.size()] =
        static_cast<char>(random() % 3 == 0 ? random() : "0,\"\n :="[random() % 7]);
    }
    file.resize(random() % 4 == 0 ? random() % file.size() : file.size());
    TouchLabels(reinterpret_cast<const std::uint8_t*>(file.data()), file.size());
  }
}
