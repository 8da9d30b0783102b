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
/// knows neither series nor sequences: it takes the preview in front of a slice for the slice.
struct DicomHeader
{
  std::string File; // whole path
  std::string TransferSyntax;
  std::string Series; // its unique identifier
  int SeriesNumber = 0;
  std::string Description; // of the series
  std::string Modality;
  int Width = 0, Height = 0;
  int Samples = 1;          // of a pixel: 3 in RGB
  bool ArePlanes = false;   // all samples of a colour together
  bool IsYbr = false;       // colours are luminance and two differences (YBR_FULL) instead of RGB
  int Bits = 0, Stored = 0; // of a sample: its size in the file, and how many of them count
  bool IsSigned = false;
  bool IsBig = false; // the byte of the highest bits comes first
  int Frames = 1;     // in the file
  int Frame = 0;      // this slice's number among them
  ///@{
  /// The value, such as Hounsfield units, is slope times sample plus intercept.
  double Slope = 1.0, Intercept = 0.0;
  ///@}
  std::optional<int> Padding; // the sample of pixels that were not measured
  // Of the first pixel, and along rows and columns; axial at 0 if the file does not tell.
  double Position[3] = { 0.0, 0.0, 0.0 };
  double Row[3] = { 1.0, 0.0, 0.0 };
  double Column[3] = { 0.0, 1.0, 0.0 };
  double Normal[3] = { 0.0, 0.0, 1.0 };
  double Along = 0.0;               // position along the normal, mm
  double Spacing[2] = { 0.0, 0.0 }; // of pixels along a row and along a column, mm; 0: not told
  std::uint64_t Pixels = 0;         // where they begin in the file
  bool IsWhole = false;             // the file is long enough for its pixels
  bool HasPlaces = true;            // it tells where each of its frames is

  /// Uncompressed little endian, implicit and explicit, and explicit big endian, with samples of
  /// 8, 16 or 32 bits.
  bool IsPlain() const;
  /// The bytes of this slice's pixels, if they are not compressed.
  std::uint64_t GetSize() const;
};

/// False if a file is not a DICOM file with pixels. Follows PS3.5 of the standard, sections 7 and
/// A.
bool ReadDicomHeader(const std::string& path, DicomHeader& header);

/// A header for each frame of a file, with its own place and meaning of samples: by the functional
/// groups of PS3.3, section C.7.6.16, by the offsets of a dose, or by the spacing between slices.
/// Empty if this is not a DICOM file with pixels.
std::vector<DicomHeader> ReadDicomSlices(const std::string& path);
} // namespace Explore

#endif
