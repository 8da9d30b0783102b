// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the header of a NRRD file (teem's "Definition of NRRD File Format").
 */
#ifndef NrrdHeader_h
#define NrrdHeader_h

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace VolumeHaptics
{

/** The type of samples. */
struct NrrdType
{
  std::size_t Size = 0; ///< bytes; 0 if the samples are no numbers of this computer
  bool IsInteger = true;
  bool IsSigned = true;
};

struct NrrdHeader
{
  /** "field: description"; names in lower case and without blanks, such as "spacedirections". */
  std::map<std::string, std::string> Fields;
  std::map<std::string, std::string> Values; ///< "key:=value", without escapes
  std::vector<std::string> Files;            ///< files with the samples, from "data file: LIST"
  std::size_t Size = 0;                      ///< bytes, including the empty line at the end
  bool HasEnd = false;                       ///< whether the header ends with an empty line

  /** Returns the description of a field; empty if there is none. */
  std::string GetField(const std::string& name) const;
  /** Returns the numbers of a field. Words that are no numbers are left out. */
  std::vector<double> GetNumbers(const std::string& name) const;
  NrrdType GetType() const;
  /** Whether the most significant byte of a sample comes first. */
  bool IsBig() const;
  /** Returns the file with the samples, as the header names it; empty if they follow the header. */
  std::string GetDataFile() const { return this->GetField("data file"); }
};

/** A position or a step (mm), in left-posterior-superior coordinates as in ITK. */
using NrrdVector = std::array<double, 3>;

/** The space that the positions of a header belong to. */
struct NrrdSpace
{
  bool IsPatient = false;    ///< whether its axes are those of a patient
  bool IsLeftHanded = false; ///< whether it is a mirror image of space
  NrrdVector Signs;          ///< factors that turn positions to left-posterior-superior
};

/** Whether bytes begin like a NRRD file. */
bool IsNrrd(std::string_view bytes);

///@{
/** Parse the header at the beginning of a file; it is empty if the file is no NRRD file. */
NrrdHeader ParseNrrdHeader(std::string_view bytes);
NrrdHeader ReadNrrdHeader(const std::string& path);
///@}

NrrdSpace FindNrrdSpace(const NrrdHeader& header);

/** Splits a text at its blanks, except within parentheses, from which blanks are removed. */
std::vector<std::string> SplitNrrdVectors(const std::string& text);

/**
 * Returns the numbers of the three axes of space, by their directions or kinds; else of the first
 * three. Nothing if space has not three axes.
 */
std::optional<std::array<std::size_t, 3>> ReadNrrdAxes(const NrrdHeader& header);

/**
 * Returns the steps from a sample to the next one along the axes of space; nothing if they are not
 * given.
 */
std::optional<std::array<NrrdVector, 3>> FindNrrdSteps(const NrrdHeader& header);

/** Returns the distances (mm) of samples along the axes of space, where no steps are given. */
NrrdVector FindNrrdSpacings(const NrrdHeader& header);

/**
 * Returns the position of the first sample: "space origin", or "axis mins", else zeros; nothing if
 * it is malformed.
 */
std::optional<NrrdVector> FindNrrdOrigin(const NrrdHeader& header);

/** Returns a note on the unit of lengths; empty if it is the millimetre, or not given. */
std::string DescribeNrrdUnits(const NrrdHeader& header);

} // namespace VolumeHaptics

#endif
