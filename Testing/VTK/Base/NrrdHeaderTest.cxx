// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The header of NRRD files. What is expected is written in teem's "Definition of NRRD File Format":
 * section 3 for lines, fields and key/value pairs, section 4 for types, section 5 for spaces.
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
