// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DicomHeader_h
#define Explore_DicomHeader_h

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Explore
{
/// A number in which slices at the same position may differ.
struct DicomFact
{
  enum Encoding
  {
    Decimal,
    TimeOfDay,
    Real,
    Whole
  };
  std::uint32_t Tag;
  const char* Name;
  Encoding Kind;
  // seconds in one unit if this is a time; 0: numbers in the order of time; -1: not a time
  double Seconds;
};

/// The facts, in order of priority: if slices differ in two of them, the first one decides.
constexpr DicomFact DICOM_FACTS[] = {
  { 0x00181060, "TriggerTime", DicomFact::Decimal, 1e-3 },
  { 0x00209153, "NominalCardiacTriggerDelayTime", DicomFact::Real, 1e-3 },
  { 0x00209241, "NominalPercentageOfCardiacPhase", DicomFact::Real, 0.0 },
  { 0x00200100, "TemporalPositionIdentifier", DicomFact::Decimal, 0.0 },
  { 0x00209128, "TemporalPositionIndex", DicomFact::Whole, 0.0 },
  { 0x00541300, "FrameReferenceTime", DicomFact::Decimal, 1e-3 },
  { 0x00200012, "AcquisitionNumber", DicomFact::Decimal, 0.0 },
  { 0x00080032, "AcquisitionTime", DicomFact::TimeOfDay, 1.0 },
  { 0x00080033, "ContentTime", DicomFact::TimeOfDay, 1.0 },
  { 0x00180081, "EchoTime", DicomFact::Decimal, -1.0 },
  { 0x00189082, "EffectiveEchoTime", DicomFact::Real, -1.0 },
  { 0x00180086, "EchoNumbers", DicomFact::Decimal, -1.0 },
  { 0x00189087, "DiffusionBValue", DicomFact::Real, -1.0 },
  { 0x00200013, "InstanceNumber", DicomFact::Decimal, 0.0 },
};

/// Returns the fact with a tag; null if no fact has this tag.
const DicomFact* FindDicomFact(std::uint32_t tag);

/// The header of a DICOM slice: its series, its position, and the meaning of its samples. VTK's
/// reader is not used, because it supports neither series nor sequences: it reads the preview in
/// front of a slice instead of the slice.
struct DicomHeader
{
  std::string File; // whole path
  std::string TransferSyntax;
  std::string Class;    // kind of the object (SOPClassUID)
  std::string Instance; // unique identifier of the file
  std::string ImageType;
  std::string Series;  // unique identifier of the series
  std::string Patient; // identifier of the patient
  int SeriesNumber = 0;
  std::string Description; // description of the series
  std::string Modality;
  int Width = 0, Height = 0;
  int Samples = 1;        // samples per pixel: 3 in RGB
  bool ArePlanes = false; // whether the samples of each colour are stored together
  // whether colours are stored as luminance and two differences (YBR_FULL) instead of RGB
  bool IsYbr = false;
  bool IsHalved = false;      // whether two pixels share their differences (YBR_FULL_422)
  bool IsPalette = false;     // whether samples are numbers of colours
  bool HasValueTable = false; // whether a table (ModalityLUTSequence) gives samples their meaning
  int Bits = 0, Stored = 0;   // bits of a sample in the file, and the number of those that are used
  int HighBit = -1;           // number of the highest bit that is used; -1: not given
  bool IsSigned = false;
  bool IsFloat = false;
  bool HasPixels = false;
  bool IsBig = false; // whether the most significant byte comes first
  int Frames = 1;     // number of frames in the file
  int Frame = 0;      // number of this slice among the frames
  ///@{
  /// The value, such as Hounsfield units, is slope times sample plus intercept.
  double Slope = 1.0, Intercept = 0.0;
  ///@}
  std::string RescaleType; // unit of these values, such as "HU"; "US" is not specified
  // The map to real-world values (PS3.3, section C.7.6.16.2.11); of several, the first one.
  struct RealWorldMap
  {
    std::optional<double> Slope; // empty if the map is a table
    double Intercept = 0.0;
    std::string Unit; // UCUM's code, such as "um2/s"
    int Count = 0;    // number of maps in the file
    // first and last stored value of the map; equal if the file has no range
    double Range[2] = { 0.0, 0.0 };
    bool IsUsed = false;
  };
  RealWorldMap RealWorld;
  std::optional<double> DoseScale;       // slope of a dose
  std::string Units;                     // units of a dose or of PET, as the file names them
  std::optional<double> Padding;         // sample of pixels that were not measured
  std::map<std::uint32_t, double> Facts; // facts in which slices at the same position may differ
  // Position of the first pixel, and directions along rows and columns. If the file does not define
  // them, the slice is axial and at 0.
  double Position[3] = { 0.0, 0.0, 0.0 };
  double Row[3] = { 1.0, 0.0, 0.0 };
  double Column[3] = { 0.0, 1.0, 0.0 };
  double Normal[3] = { 0.0, 0.0, 1.0 };
  double Along = 0.0;               // position along the normal, mm
  double Spacing[2] = { 0.0, 0.0 }; // between pixels along a row and along a column, mm; 0: unknown
  bool IsDetectorSpacing = false;   // measured at the detector, not in the patient
  // distance of slices in the file, mm, negative if they follow each other against the normal; 0:
  // not known
  double Step = 0.0;
  double Thickness = 0.0;         // mm; 0: not known
  std::optional<double> Location; // SliceLocation, mm
  bool HasPosition = false;       // whether the file gives the position
  std::uint64_t Pixels = 0;       // where the pixels begin in the file
  bool IsDeflated = false;        // whether the whole data set is packed by deflate
  bool IsWhole = false;           // whether the file is long enough for its pixels
  bool HasPlaces = true;          // whether the file has the place of each frame
  // For a segmentation: the frame's segment, and the sample of a voxel that is wholly inside.
  int Segment = 1;
  double Whole = 1.0;
  std::string SegmentationType;

  /// Returns whether the slice is uncompressed little endian, implicit or explicit, or explicit big
  /// endian, with samples of 1, 8, 16 or 32 bits, or floating-point numbers.
  bool IsPlain() const;
  /// Returns the size of this slice's pixels in bytes, if they are not compressed. Samples of one
  /// bit are rounded up to whole bytes.
  std::uint64_t GetSize() const;
  /// Returns the size of the pixels of all frames in bytes.
  std::uint64_t GetSizeOfAll() const;
  bool IsSegmentation() const;
};

/// A segment of a segmentation.
struct DicomSegment
{
  int Number = 0;
  std::string Name;
  std::vector<double> Color; // red, green and blue, 0 to 1; empty if the segment has no colour
};

/// Reads the segments of a segmentation file: PS3.3, section C.8.20.2.
std::vector<DicomSegment> ReadDicomSegments(const std::string& path);

/// The kind of a DICOM object that contains no pixels of a volume, such as "an RT plan", with the
/// cure. Both texts are empty for a slice, and for a file that is not DICOM.
struct DicomObject
{
  std::string Name;
  std::string Cure;
};
DicomObject FindDicomObject(const std::string& path);

/// Names a compression of pixels that is not read here, such as "JPEG XL"; empty if it is none.
std::string NameUnreadSyntax(const std::string& transferSyntax);

/// Reads a header. Returns false if a file is not a DICOM file with pixels. Follows PS3.5 of the
/// standard, sections 7 and A.
bool ReadDicomHeader(const std::string& path, DicomHeader& header);

/// Reads a header for each frame of a file, each with its own position and meaning of samples. They
/// come from the functional groups (PS3.3, section C.7.6.16), from the offsets of a dose, or from
/// the spacing between slices. Returns none if this is not a DICOM file with pixels.
std::vector<DicomHeader> ReadDicomSlices(const std::string& path);
} // namespace Explore

#endif
