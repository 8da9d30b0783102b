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
/// A numeric attribute in which slices at the same position may differ, such as a time.
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
  // seconds per unit of a time; 0: a number that rises with time; -1: unrelated to time
  double Seconds;
};

/// All facts, by priority: if slices differ in several, the first one decides.
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

/// Returns the fact with a DICOM tag; null if there is none.
const DicomFact* FindDicomFact(std::uint32_t tag);

/// Header of a DICOM slice: its series, its position, and the meaning of its samples. Not read with
/// VTK's reader, which supports neither series nor sequences: it reads the preview in front of a
/// slice instead of the slice.
struct DicomHeader
{
  std::string File; // absolute path
  std::string TransferSyntax;
  std::string Class;    // kind of the object (SOPClassUID)
  std::string Instance; // unique identifier of the file (SOPInstanceUID)
  std::string ImageType;
  std::string Series;  // unique identifier of the series (SeriesInstanceUID)
  std::string Patient; // identifier (PatientID)
  int SeriesNumber = 0;
  std::string Description; // SeriesDescription, for lists of series
  std::string Modality;
  int Width = 0, Height = 0;
  int Samples = 1;        // samples per pixel: 3 in RGB
  bool ArePlanes = false; // whether all samples of a colour are stored together
  // Whether colours are luminance and two colour differences (YBR_FULL) instead of RGB.
  bool IsYbr = false;
  bool IsHalved = false;      // whether two pixels share their colour differences (YBR_FULL_422)
  bool IsPalette = false;     // whether samples are indices of colours
  bool HasValueTable = false; // whether a table (ModalityLUTSequence) defines the meaning of
                              // samples
  int Bits = 0, Stored = 0;   // bits per sample in the file; number of bits in use
  int HighBit = -1;           // index of the highest bit in use; -1: not given
  bool IsSigned = false;
  bool IsFloat = false;
  bool HasPixels = false;
  bool IsBig = false; // number of frames in this file
  int Frames = 1;     // number of frames in the file
  int Frame = 0;      // index of this slice among the frames
  ///@{
  /// Value = Slope * sample + Intercept, for example in Hounsfield units.
  double Slope = 1.0, Intercept = 0.0;
  ///@}
  std::string RescaleType; // unit of the values, such as "HU"; "US" stands for unspecified
  // Real-world value map (PS3.3, section C.7.6.16.2.11); the first one if the file has several.
  struct RealWorldMap
  {
    std::optional<double> Slope; // empty if the map is a table
    double Intercept = 0.0;
    std::string Unit; // UCUM code, such as "um2/s"
    int Count = 0;    // number of such maps in the file
    // First and last stored value to which the map applies; equal if the file has no range.
    double Range[2] = { 0.0, 0.0 };
    bool IsUsed = false;
  };
  RealWorldMap RealWorld;
  std::optional<double> DoseScale;       // factor that converts samples to a dose (DoseGridScaling)
  std::string Units;                     // unit of a dose or of PET, as named in the file
  std::optional<double> Padding;         // sample value of pixels that were not measured
  std::map<std::uint32_t, double> Facts; // values of the attributes in DICOM_FACTS, by tag
  // Position of the first pixel, and directions of rows and columns, in the patient. Default: an
  // axial slice at 0.
  double Position[3] = { 0.0, 0.0, 0.0 };
  double Row[3] = { 1.0, 0.0, 0.0 };
  double Column[3] = { 0.0, 1.0, 0.0 };
  double Normal[3] = { 0.0, 0.0, 1.0 };
  double Along = 0.0;               // position along the normal (mm)
  double Spacing[2] = { 0.0, 0.0 }; // distance of pixels along a row and along a column (mm); 0:
                                    // unknown
  bool IsDetectorSpacing = false;   // whether Spacing is measured at the detector instead of in the
                                    // patient
  // Distance (mm) of slices as stated in the file, negative if they follow each other against the
  // normal; 0: unknown.
  double Step = 0.0;
  double Thickness = 0.0;         // mm; 0: unknown
  std::optional<double> Location; // SliceLocation, mm
  bool HasPosition = false;       // whether the file states the position
  std::uint64_t Pixels = 0;       // offset (bytes) of the pixels in the file
  bool IsDeflated = false;        // whether the whole data set is compressed by deflate
  bool IsWhole = false;           // whether the file is long enough for its pixels
  bool HasPlaces = true;          // whether the file states the position of each frame
  // For a segmentation: the frame's segment, and the sample of a voxel that is completely inside.
  int Segment = 1;
  double Whole = 1.0;
  std::string SegmentationType;

  /// Returns whether the slice is uncompressed, in implicit or explicit little endian or explicit
  /// big endian, with samples of 1, 8, 16 or 32 bits or floating-point samples.
  bool IsPlain() const;
  /// Returns the size (bytes) of this slice's uncompressed pixels. 1-bit samples are rounded up to
  /// whole bytes.
  std::uint64_t GetSize() const;
  /// Returns the size (bytes) of the uncompressed pixels of all frames.
  std::uint64_t GetSizeOfAll() const;
  bool IsSegmentation() const;
};

/// A segment of a DICOM segmentation.
struct DicomSegment
{
  int Number = 0;
  std::string Name;
  std::vector<double> Color; // red, green and blue, 0 to 1; empty without a colour
};

/// Reads the segments of a segmentation file: PS3.3, section C.8.20.2.
std::vector<DicomSegment> ReadDicomSegments(const std::string& path);

/// A kind of DICOM object without the pixels of a volume, such as "an RT plan", with the cure. Both
/// texts are empty for a slice or for a file that is not DICOM.
struct DicomObject
{
  std::string Name;
  std::string Cure;
};
DicomObject FindDicomObject(const std::string& path);

/// Returns the name of a compression that is not supported here, such as "JPEG XL"; empty if the
/// syntax is supported.
std::string NameUnreadSyntax(const std::string& transferSyntax);

/// Reads a header. Returns false if the file is not a DICOM file with pixels. Follows PS3.5 of the
/// standard, section 7 and annex A.
bool ReadDicomHeader(const std::string& path, DicomHeader& header);

/// Reads one header per frame of a file, with the frame's own position and meaning of samples.
/// These come from the functional groups (PS3.3, section C.7.6.16), from the offsets of a dose, or
/// from the spacing between slices. Returns none if the file is not a DICOM file with pixels.
std::vector<DicomHeader> ReadDicomSlices(const std::string& path);
} // namespace Explore

#endif
