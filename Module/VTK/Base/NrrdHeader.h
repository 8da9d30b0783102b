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
  std::size_t Size = 0; ///< bytes; 0 if this computer has no such type
  bool IsInteger = true;
  bool IsSigned = true;
};

struct NrrdHeader
{
  /** Descriptions by field. Names are in lower case without blanks, such as "spacedirections". */
  std::map<std::string, std::string> Fields;
  std::map<std::string, std::string> Values; ///< values of the lines "key:=value", without escapes
  std::vector<std::string> Files;            ///< files with the samples, from "data file: LIST"
  std::size_t Size = 0;                      ///< bytes, with the empty line at the header's end
  bool HasEnd = false;                       ///< whether the header ends with an empty line

  /** Returns the description of a field; empty if there is none. */
  std::string GetField(const std::string& name) const;
  /** Returns the numbers of a field. Leaves out words that are not numbers. */
  std::vector<double> GetNumbers(const std::string& name) const;
  NrrdType GetType() const;
  /** Returns whether the most significant byte of a sample comes first. */
  bool IsBig() const;
  /**
   * Returns the file with the samples, as the header names it; empty if the samples follow the
   * header.
   */
  std::string GetDataFile() const { return this->GetField("data file"); }
};

/** A position or a step (mm), in left-posterior-superior coordinates as in ITK. */
using NrrdVector = std::array<double, 3>;

/** The coordinate system of the positions in a header. */
struct NrrdSpace
{
  bool IsPatient = false;    ///< whether its axes are those of a patient
  bool IsLeftHanded = false; ///< whether its axes are left-handed
  NrrdVector Signs;          ///< factors that convert positions to left-posterior-superior
};

/** Returns whether bytes begin like a NRRD file. */
bool IsNrrd(std::string_view bytes);

///@{
/** Parse the header at the beginning of a file. The result is empty if the file is no NRRD file. */
NrrdHeader ParseNrrdHeader(std::string_view bytes);
NrrdHeader ReadNrrdHeader(const std::string& path);
///@}

NrrdSpace FindNrrdSpace(const NrrdHeader& header);

/** Splits a text at its blanks, but not within parentheses, where it removes the blanks. */
std::vector<std::string> SplitNrrdVectors(const std::string& text);

/**
 * Returns the indices of the three axes of space, chosen by their directions or kinds; if neither
 * is given, of the first three axes. Returns nothing unless there are three.
 */
std::optional<std::array<std::size_t, 3>> ReadNrrdAxes(const NrrdHeader& header);

/**
 * Returns the vectors from a sample to its neighbours along the axes of space; without directions,
 * along the axes of a space that is turned. Returns nothing if they are not given.
 */
std::optional<std::array<NrrdVector, 3>> FindNrrdSteps(const NrrdHeader& header);

/** Returns the spacings (mm) along the axes of space, for a header without such vectors. */
NrrdVector FindNrrdSpacings(const NrrdHeader& header);

/**
 * Returns the position of the first sample: that of "space origin" or "axis mins", or zeros if
 * neither is given. Returns nothing if it is malformed.
 */
std::optional<NrrdVector> FindNrrdOrigin(const NrrdHeader& header);

/**
 * Returns a note on the values that are assumed because the header lacks them; empty if the header
 * is complete.
 */
std::string DescribeNrrdGuess(const NrrdHeader& header);

/** Returns a note on the unit of length; empty if it is the millimetre or not given. */
std::string DescribeNrrdUnits(const NrrdHeader& header);

} // namespace VolumeHaptics

#endif
