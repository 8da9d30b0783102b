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
  std::size_t Size = 0;                      ///< bytes, including the empty line at the end
  bool HasEnd = false;                       ///< whether it ends with an empty line

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

/** A position or a step, in left-posterior-superior coordinates as in ITK. */
using NrrdVector = std::array<double, 3>;

/** The space that the positions of a header belong to. */
struct NrrdSpace
{
  bool IsPatient = false;    ///< whether its axes are those of a patient
  bool IsLeftHanded = false; ///< whether it is a mirror image of space
  NrrdVector Signs;          ///< what converts its positions to left-posterior-superior
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
 * Returns the steps from a sample to the next one along three axes. Axes without a direction
 * ("none") are left out; nothing is returned unless three remain.
 */
std::optional<std::array<NrrdVector, 3>> FindNrrdSteps(const NrrdHeader& header);

/** Returns the position of the first sample; zeros if none is given, nothing if it is malformed. */
std::optional<NrrdVector> FindNrrdOrigin(const NrrdHeader& header);

} // namespace VolumeHaptics

#endif
