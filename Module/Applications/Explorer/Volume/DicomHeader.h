// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DicomHeader_h
#define Explore_DicomHeader_h

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace Explore
{
/// The header of a DICOM slice: its series, its place, and the meaning of its samples. VTK's reader
/// supports neither series nor sequences: it reads the preview in front of a slice instead of the
/// slice.
struct DicomHeader
{
  std::string File; // whole path
  std::string TransferSyntax;
  std::string Series; // the series' unique identifier
  int SeriesNumber = 0;
  std::string Description; // the series'
  std::string Modality;
  int Width = 0, Height = 0;
  int Samples = 1;          // per pixel: 3 in RGB
  bool ArePlanes = false;   // samples are stored by colour
  bool IsYbr = false;       // colours are luminance and two differences (YBR_FULL) instead of RGB
  int Bits = 0, Stored = 0; // bits of a sample in the file, and how many of them count
  bool IsSigned = false;
  bool IsBig = false; // the most significant byte comes first
  int Frames = 1;     // in the file
  int Frame = 0;      // this slice's number among the frames
  ///@{
  /// The value, such as Hounsfield units, is slope times sample plus intercept.
  double Slope = 1.0, Intercept = 0.0;
  ///@}
  std::optional<int> Padding; // the sample of pixels that were not measured
  // Position of the first pixel, and directions along rows and columns; axial at 0 if the file does
  // not give them.
  double Position[3] = { 0.0, 0.0, 0.0 };
  double Row[3] = { 1.0, 0.0, 0.0 };
  double Column[3] = { 0.0, 1.0, 0.0 };
  double Normal[3] = { 0.0, 0.0, 1.0 };
  double Along = 0.0;               // position along the normal, mm
  double Spacing[2] = { 0.0, 0.0 }; // of pixels along a row and along a column, mm; 0: not known
  std::uint64_t Pixels = 0;         // where the pixels begin in the file
  bool IsWhole = false;             // the file is long enough for its pixels
  bool HasPlaces = true;            // the file has the place of each frame

  /// Uncompressed little endian, implicit and explicit, and explicit big endian, with samples of
  /// 8, 16 or 32 bits.
  bool IsPlain() const;
  /// The size of this slice's pixels in bytes, if they are not compressed.
  std::uint64_t GetSize() const;
};

/// False if a file is not a DICOM file with pixels. Follows PS3.5 of the standard, sections 7 and
/// A.
bool ReadDicomHeader(const std::string& path, DicomHeader& header);

/// A header for each frame of a file, with its own place and meaning of samples: from the
/// functional groups of PS3.3, section C.7.6.16, from the offsets of a dose, or from the spacing
/// between slices. Empty if this is not a DICOM file with pixels.
std::vector<DicomHeader> ReadDicomSlices(const std::string& path);
} // namespace Explore

#endif
