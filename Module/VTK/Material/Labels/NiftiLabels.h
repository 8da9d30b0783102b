// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds the label tables that NIfTI files contain between their header and samples.
 *
 * TotalSegmentator and programs of the Human Connectome Project store a header extension in XML,
 * with an element <Label Key="5" Red="1" Green="0" Blue="0" Alpha="1">liver</Label> for each label.
 * MRIcron and MRIcroGL store one line per label: the label, a tab and the name. No extension header
 * precedes these lines.
 */
#ifndef NiftiLabels_h
#define NiftiLabels_h

#include <cstddef>
#include <string_view>

namespace VolumeHaptics
{

/** Returns whether uncompressed bytes start like a NIfTI file of version 1 or 2. */
bool IsNifti(std::string_view bytes);

/** Computes the size of everything before the samples, at most `most`, from the first 540 bytes. */
std::size_t GetNiftiHeadSize(std::string_view bytes, std::size_t most);

enum class NiftiTable
{
  None,
  Xml,
  Names
};

/**
 * Finds the label table between header and samples. Returns its format, and its text in `table`.
 */
NiftiTable FindNiftiTable(std::string_view bytes, std::string_view& table);

} // namespace VolumeHaptics

#endif
