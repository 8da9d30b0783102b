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

/** Sample type of a NRRD file. */
struct NrrdType
{
  std::size_t Size = 0; ///< bytes; 0 if this computer lacks the type
  bool IsInteger = true;
  bool IsSigned = true;
};

struct NrrdHeader
{
  /**
   * Field values by field name. The names are in lower case without blanks, such as
   * "spacedirections".
   */
  std::map<std::string, std::string> Fields;
  std::map<std::string, std::string> Values; ///< values of the lines "key:=value", with their
                                             ///< escape sequences resolved
  std::vector<std::string> Files;            ///< files with the samples, from the field "data file:
                                             ///< LIST"
  std::size_t Size = 0;                      ///< bytes, including the empty line at the header's
                                             ///< end
  bool HasEnd = false;                       ///< whether the header ends with an empty line

  /** Returns the value of a field; empty if the header lacks it. */
  std::string GetField(const std::string& name) const;
  /** Returns the numbers of a field and skips words that are not numbers. */
  std::vector<double> GetNumbers(const std::string& name) const;
  NrrdType GetType() const;
  /** Returns whether the samples are big-endian. */
  bool IsBig() const;
  /**
   * Returns the file with the samples, as named in the header; empty if the samples follow the
   * header.
   */
  std::string GetDataFile() const { return this->GetField("data file"); }
};

/** Position or step (mm) in left-posterior-superior coordinates, as in ITK. */
using NrrdVector = std::array<double, 3>;

/** Coordinate system of the positions in a header. */
struct NrrdSpace
{
  bool IsPatient = false;    ///< whether the axes are anatomical directions of a patient
  bool IsLeftHanded = false; ///< whether the axes are left-handed
  NrrdVector Signs;          ///< factors that convert positions to left-posterior-superior
                             ///< coordinates
};

/** Returns whether the bytes start like a NRRD file. */
bool IsNrrd(std::string_view bytes);

///@{
/**
 * Parse the header at the beginning of a file. The result is empty if the file is not a NRRD file.
 */
NrrdHeader ParseNrrdHeader(std::string_view bytes);
NrrdHeader ReadNrrdHeader(const std::string& path);
///@}

NrrdSpace FindNrrdSpace(const NrrdHeader& header);

/** Splits a text at its blanks, except inside parentheses, where blanks are removed. */
std::vector<std::string> SplitNrrdVectors(const std::string& text);

/**
 * Returns the indices of the three spatial axes, identified by their directions or kinds; if the
 * header has neither, the first three axes. Returns nothing if there are fewer than three.
 */
std::optional<std::array<std::size_t, 3>> ReadNrrdAxes(const NrrdHeader& header);

/**
 * Returns the vectors from a sample to its neighbours along the spatial axes; for a header without
 * directions, along the axes of its space if that is rotated. Returns nothing if the header gives
 * no vectors.
 */
std::optional<std::array<NrrdVector, 3>> FindNrrdSteps(const NrrdHeader& header);

/**
 * Returns the spacings (mm) along the spatial axes, for a header without the vectors of
 * FindNrrdSteps().
 */
NrrdVector FindNrrdSpacings(const NrrdHeader& header);

/**
 * Returns the position of the first sample, from "space origin" or "axis mins"; zeros if the header
 * has neither. Returns nothing if the position is malformed.
 */
std::optional<NrrdVector> FindNrrdOrigin(const NrrdHeader& header);

/**
 * Returns a note that lists the values assumed because the header lacks them; empty if the header
 * is complete.
 */
std::string DescribeNrrdGuess(const NrrdHeader& header);

/** Returns a note on the unit of length; empty for millimetres or if the header states none. */
std::string DescribeNrrdUnits(const NrrdHeader& header);

} // namespace VolumeHaptics

#endif
