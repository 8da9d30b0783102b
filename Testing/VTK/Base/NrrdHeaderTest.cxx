// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests headers of NRRD files. The expectations come from teem's "Definition of NRRD File Format":
 * section 3 for lines, fields and key/value pairs, section 4 for types, and section 5 for spaces.
 */

#include "VTK/Base/NrrdHeader.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

using namespace VolumeHaptics;

TEST(NrrdHeader, HasFieldsKeysAndTheSizeOfItself)
{
  const std::string head = "NRRD0005\r\n# type: double\r\nType: signed short\nsizes: 2 3 4\n"
                           "datafile: a.raw\nname:=a: b\\n\\\\c\n\n";
  const NrrdHeader header = ParseNrrdHeader(head + "samples: 7\n");
  EXPECT_EQ(header.GetType().Size, 2U);
  EXPECT_EQ(header.GetNumbers("sizes"), (std::vector<double>{ 2, 3, 4 }));
  EXPECT_EQ(header.GetDataFile(), "a.raw");
  EXPECT_EQ(header.Values.at("name"), "a: b\n\\c");
  EXPECT_EQ(header.Size, head.size());
  EXPECT_TRUE(header.HasEnd);
  EXPECT_TRUE(header.GetField("samples").empty());
  EXPECT_FALSE(ParseNrrdHeader("NRRD0004\ntype: float\n").HasEnd);
  EXPECT_TRUE(ParseNrrdHeader("type: float\n\n").Fields.empty());
}

TEST(NrrdHeader, KnowsAllNamesOfTypes)
{
  for (const auto& [name, type] :
    { std::pair<const char*, NrrdType>{ "unsigned char", { 1, true, false } },
      { "int8_t", { 1, true, true } }, { "unsigned short int", { 2, true, false } },
      { "signed int", { 4, true, true } }, { "uint32_t", { 4, true, false } },
      { "signed long long int", { 8, true, true } }, { "uint64", { 8, true, false } },
      { "float", { 4, false, true } }, { "double", { 8, false, true } }, { "block", {} },
      { "", {} } })
  {
    const NrrdType told =
      ParseNrrdHeader(std::string("NRRD0004\ntype: ") + name + "\n\n").GetType();
    EXPECT_EQ(told.Size, type.Size) << name;
    EXPECT_EQ(told.IsInteger, type.IsInteger) << name;
    EXPECT_EQ(told.IsSigned, type.IsSigned) << name;
  }
}

TEST(NrrdHeader, PlacesSamplesInLeftPosteriorSuperior)
{
  const std::string rest = "\nspace directions: none (0, 2,0) (-3,0,0) (0,0,4)\n"
                           "space origin: (10,20,30)\n\n";
  for (const auto& [space, signs] :
    { std::pair<std::string, NrrdVector>{ "right-anterior-superior", { -1, -1, 1 } },
      { "RAST", { -1, -1, 1 } }, { "left-anterior-superior-time", { 1, -1, 1 } },
      { "LAS", { 1, -1, 1 } }, { "left-posterior-superior", { 1, 1, 1 } },
      { "scanner-xyz", { 1, 1, 1 } } })
  {
    const NrrdHeader header = ParseNrrdHeader("NRRD0004\nspace: " + space + rest);
    const auto steps = FindNrrdSteps(header);
    ASSERT_TRUE(steps) << space;
    EXPECT_EQ((*steps)[0], (NrrdVector{ 0, signs[1] * 2, 0 })) << space;
    EXPECT_EQ((*steps)[1], (NrrdVector{ signs[0] * -3, 0, 0 })) << space;
    EXPECT_EQ((*steps)[2], (NrrdVector{ 0, 0, 4 })) << space;
    EXPECT_EQ(*FindNrrdOrigin(header), (NrrdVector{ signs[0] * 10, signs[1] * 20, 30 })) << space;
    EXPECT_EQ(FindNrrdSpace(header).IsPatient, space != "scanner-xyz") << space;
    EXPECT_EQ(FindNrrdSpace(header).IsLeftHanded, space[0] == 'L' || space.find("left-a") == 0);
  }
}

// teem's "Definition of NRRD File Format": "space units" refer to the axes of the space, "units" to
// the axes of the samples. If samples are cells, "axis mins" is the border of the first sample.
TEST(NrrdHeader, TurnsUnitsIntoMillimetres)
{
  const NrrdHeader space = ParseNrrdHeader("NRRD0005\nspace: right-anterior-superior\n"
                                           "sizes: 2 3 4\nspace units: \"um\" \"mm\" \"m\"\n"
                                           "space directions: (500,0,0) (0,2,0) (0,0,0.003)\n"
                                           "space origin: (1000,5,0.01)\n\n");
  const auto steps = FindNrrdSteps(space);
  ASSERT_TRUE(steps);
  EXPECT_NEAR((*steps)[0][0], -0.5, 1e-12);
  EXPECT_NEAR((*steps)[1][1], -2.0, 1e-12);
  EXPECT_NEAR((*steps)[2][2], 3.0, 1e-12);
  EXPECT_NEAR((*FindNrrdOrigin(space))[2], 10.0, 1e-12);
  EXPECT_EQ(DescribeNrrdUnits(space), "lengths turned from the unit um into millimetres");
  const std::string axes = "NRRD0005\nsizes: 3 2 4 5\nkinds: vector space space space\n"
                           "units: \"\" \"cm\" \"parsec\" mm\n";
  const NrrdHeader plain = ParseNrrdHeader(axes +
    "spacings: nan 2 3 4\naxis mins: nan 1 2 3\n"
    "centers: none cell node none\n\n");
  EXPECT_FALSE(FindNrrdSteps(plain));
  EXPECT_EQ(*ReadNrrdAxes(plain), (std::array<std::size_t, 3>{ 1, 2, 3 }));
  EXPECT_EQ(FindNrrdSpacings(plain), (NrrdVector{ 20, 3, 4 }));
  EXPECT_EQ(*FindNrrdOrigin(plain), (NrrdVector{ 20, 2, 3 }));
  // The first spatial axis has two cells of 3 cm. The second has four nodes, and thus three steps
  // of 2.
  const NrrdHeader ends = ParseNrrdHeader(axes +
    "axis mins: nan 0 0 1\naxis maxs: nan 6 6 9\n"
    "centerings: none cell node node\n\n");
  EXPECT_EQ(FindNrrdSpacings(ends), (NrrdVector{ 30, 2, 2 }));
  EXPECT_EQ(*FindNrrdOrigin(ends), (NrrdVector{ 15, 0, 1 }));
}

TEST(NrrdHeader, FindsTheAxesOfSpace)
{
  const auto axes = [](const std::string& lines)
  { return ReadNrrdAxes(ParseNrrdHeader("NRRD0005\n" + lines + "\n\n")); };
  using Axes = std::array<std::size_t, 3>;
  EXPECT_EQ(*axes("sizes: 2 3 4"), (Axes{ 0, 1, 2 }));
  EXPECT_EQ(*axes("sizes: 2 3 4 5"), (Axes{ 0, 1, 2 }));
  EXPECT_EQ(*axes("sizes: 2 3 4 5\nkinds: list domain domain domain"), (Axes{ 1, 2, 3 }));
  EXPECT_EQ(*axes("sizes: 2 3 4 5\nkinds: domain domain domain list"), (Axes{ 0, 1, 2 }));
  EXPECT_EQ(
    *axes("sizes: 2 3 4 5\nspace directions: (1,0,0) none (0,1,0) (0,0,1)"), (Axes{ 0, 2, 3 }));
  // ITK writes a series with four space axes; the last one is time.
  const std::string series =
    "sizes: 2 3 4 5\nkinds: domain domain domain domain\nspace origin: (1,2,3,0)\n"
    "space directions: (1,0,0,0) (0,2,0,0) (0,0,3,0) (0,0,0,1)";
  EXPECT_EQ(*axes(series), (Axes{ 0, 1, 2 }));
  const NrrdHeader header = ParseNrrdHeader("NRRD0005\n" + series + "\n\n");
  EXPECT_EQ((*FindNrrdSteps(header))[2], (NrrdVector{ 0, 0, 3 }));
  EXPECT_EQ(*FindNrrdOrigin(header), (NrrdVector{ 1, 2, 3 }));
  EXPECT_FALSE(axes("sizes: 2 3"));
  EXPECT_FALSE(axes("sizes: 2 3 4\nspace directions: (1,0) (0,1) none"));
}

TEST(NrrdHeader, ListsFilesOfSamples)
{
  const NrrdHeader header =
    ParseNrrdHeader("NRRD0005\nsizes: 2 3 4\ndata file: LIST\na: 1.raw\nb.raw\n");
  EXPECT_EQ(header.Files, (std::vector<std::string>{ "a: 1.raw", "b.raw" }));
}

TEST(NrrdHeader, RefusesWhatIsNoDirectionOrPosition)
{
  for (const char* const bad : { "(1,0,0) (0,1,0)", "(1,0,0) (0,1,0) (0,1)",
         "(1,0,0) (0,1,0) (0,0,nan)", "(1,0,0) (0,1,0) 5", "(1,0,0) (0,1,0) (0,0,1,0)", "" })
  {
    const NrrdHeader header = ParseNrrdHeader(
      "NRRD0004\nspace directions: " + std::string(bad) + "\nspace origin: (1,2)\n\n");
    EXPECT_FALSE(FindNrrdSteps(header)) << bad;
    EXPECT_FALSE(FindNrrdOrigin(header));
  }
  EXPECT_EQ(*FindNrrdOrigin(ParseNrrdHeader("NRRD0004\n\n")), (NrrdVector{ 0, 0, 0 }));
}
