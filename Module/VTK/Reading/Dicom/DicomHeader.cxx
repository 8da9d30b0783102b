// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/Dicom/DicomHeader.h"

#include "VTK/Reading/Dicom/DicomProcess.h"

#include "vtkMath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <locale>
#include <sstream>
#include <vector>

namespace
{
using Explore::DicomAnswer;
using Explore::DicomElement;
using Explore::DicomHeader;
using Explore::DicomRequest;
using Explore::DicomSegment;

constexpr std::uint32_t PIXELS = 0x7fe00010;
constexpr std::uint32_t FLOAT_PIXELS = 0x7fe00008;
constexpr std::uint32_t OFFSETS = 0x3004000c; // tag of GridFrameOffsetVector: the offsets of a
                                              // dose's frames
constexpr std::uint32_t SEGMENTS = 0x00620002;
constexpr std::uint32_t SHARED_GROUPS = 0x52009229;
constexpr std::uint32_t FRAME_GROUPS = 0x52009230;
constexpr std::uint32_t DETECTORS = 0x00540022;
constexpr int MOST_FRAMES = 100000;
constexpr const char* IMPLICIT_LITTLE = "1.2.840.10008.1.2";
constexpr const char* EXPLICIT_LITTLE = "1.2.840.10008.1.2.1";
constexpr const char* EXPLICIT_BIG = "1.2.840.10008.1.2.2";

/// Headers and positions of the frames in a file with several.
struct FramePlaces
{
  // Header of each frame: the file's header with the frame's own values.
  std::vector<DicomHeader> Groups;
  std::vector<double> Offsets; // positions (mm) along the normal, or z in the patient
  std::vector<DicomSegment> Segments;
};

/// A kind of DICOM object without the pixels of a volume, with the prefix of its class UID, and the
/// cure to suggest.
struct ObjectKind
{
  const char* Class;
  const char* Name;
  const char* Cure;
};
constexpr const char* NAME_IMAGES = "choose the folder of its images";
constexpr const char* UNCOMPRESS =
  "export it again without compression, or decompress it with pydicom: dcmread(FILE).decompress()";
constexpr ObjectKind OBJECTS[] = {
  { "1.2.840.10008.5.1.4.1.1.481.3",
    "an RT structure set (RTSTRUCT), whose contours have no voxels",
    "convert it to labels first, e.g. with plastimatch convert or 3D Slicer, and give them as "
    "labels" },
  { "1.2.840.10008.5.1.4.1.1.481.5", "an RT plan (RTPLAN)", NAME_IMAGES },
  { "1.2.840.10008.5.1.4.1.1.481.8", "an RT ion plan (RTPLAN)", NAME_IMAGES },
  { "1.2.840.10008.5.1.4.1.1.481.", "an RT record", NAME_IMAGES },
  { "1.2.840.10008.5.1.4.1.1.88.", "a structured report (SR)", NAME_IMAGES },
  { "1.2.840.10008.5.1.4.1.1.9.", "a waveform, such as an ECG", NAME_IMAGES },
  { "1.2.840.10008.5.1.4.1.1.11.", "a presentation state", NAME_IMAGES },
  { "1.2.840.10008.5.1.4.1.1.104.", "an encapsulated document", NAME_IMAGES },
  { "1.2.840.10008.5.1.4.1.1.66.1", "a spatial registration (REG)", NAME_IMAGES },
  { "1.2.840.10008.5.1.4.1.1.66.2", "a set of fiducials", NAME_IMAGES },
  { "1.2.840.10008.5.1.4.1.1.66.3", "a deformable registration (REG)", NAME_IMAGES },
  { "1.2.840.10008.5.1.4.1.1.66.4", "a segmentation (SEG) that ends before its pixels",
    "copy or export it again" },
  { "1.2.840.10008.5.1.4.1.1.66.5", "a surface segmentation, which has no voxels",
    "write it as a DICOM SEG, or as .seg.nrrd" },
  { "1.2.840.10008.5.1.4.1.1.66.6", "a set of tracts", NAME_IMAGES },
  { "1.2.840.10008.5.1.4.1.1.66", "raw data, without an image", NAME_IMAGES },
  { "1.2.840.10008.5.1.4.1.1.4.2", "a spectrum", NAME_IMAGES },
  { "1.2.840.10008.1.3.10", "the directory of a medium (DICOMDIR)", NAME_IMAGES },
};

/// Returns the integer in the two or four bytes that start at `first`.
std::uint32_t ReadNumber(const std::string& bytes, std::size_t first, std::size_t count)
{
  std::uint32_t number = 0;
  for (std::size_t i = std::min(bytes.size(), first + count); i > first; --i)
  {
    number = number << 8 | static_cast<unsigned char>(bytes[i - 1]);
  }
  return number;
}

/// Returns the floating-point number in 4 or 8 bytes; 0 for any other size.
double ReadReal(const std::string& bytes)
{
  double real = 0.0;
  float single = 0.0F;
  if (bytes.size() == sizeof(real))
  {
    std::memcpy(&real, bytes.data(), sizeof(real));
  }
  else if (bytes.size() == sizeof(single))
  {
    std::memcpy(&single, bytes.data(), sizeof(single));
    real = single;
  }
  return real;
}

/// Removes the trailing blank or zero that makes lengths even.
std::string TrimValue(std::string text)
{
  text.erase(std::find(text.begin(), text.end(), '\0'), text.end());
  const std::size_t last = text.find_last_not_of(' ');
  text.erase(last == std::string::npos ? 0 : last + 1);
  return text.substr(std::min(text.find_first_not_of(' '), text.size()));
}

/// Reads decimal numbers that are separated by backslashes. Returns false, and sets none, if there
/// are too few or if any is not finite.
bool ReadDecimals(const std::string& text, double* numbers, int count)
{
  std::string plain = text;
  std::replace(plain.begin(), plain.end(), '\\', ' ');
  std::istringstream stream(plain);
  stream.imbue(std::locale::classic());
  std::vector<double> read(static_cast<std::size_t>(count));
  for (double& number : read)
  {
    if (!(stream >> number) || !std::isfinite(number))
    {
      return false;
    }
  }
  std::copy(read.begin(), read.end(), numbers);
  return true;
}

int ReadWhole(const std::string& text, int unknown)
{
  double number = 0.0;
  return ReadDecimals(text, &number, 1) && std::abs(number) < 1e9 ? static_cast<int>(number)
                                                                  : unknown;
}

/// Converts a time of day, HHMMSS.F, to seconds.
double ReadTimeOfDay(const std::string& text)
{
  double number = 0.0;
  const bool isRead = text.size() >= 6 && ReadDecimals(text, &number, 1);
  const double hours = std::floor(number / 1e4);
  const double minutes = std::floor((number - 1e4 * hours) / 1e2);
  return isRead ? 3600.0 * hours + 60.0 * minutes + number - 1e4 * hours - 1e2 * minutes : NAN;
}

void TakeFact(const Explore::DicomFact& fact, const std::string& value, DicomHeader& header)
{
  double number = NAN;
  switch (fact.Kind)
  {
    case Explore::DicomFact::Decimal:
      ReadDecimals(value, &number, 1);
      break;
    case Explore::DicomFact::TimeOfDay:
      number = ReadTimeOfDay(TrimValue(value));
      break;
    case Explore::DicomFact::Real:
      number = ReadReal(value);
      break;
    case Explore::DicomFact::Whole:
      number = static_cast<double>(ReadNumber(value, 0, 4));
      break;
  }
  if (std::isfinite(number))
  {
    header.Facts[fact.Tag] = number;
  }
}

void ReadValue(
  std::uint32_t tag, const std::string& value, DicomHeader& header, double orientation[6])
{
  const auto number = [&] { return static_cast<int>(ReadNumber(value, 0, 2)); };
  switch (tag)
  {
    case 0x00020002: // MediaStorageSOPClassUID, which precedes SOPClassUID
      header.Class = TrimValue(value);
      break;
    case 0x00020010:
      header.TransferSyntax = TrimValue(value);
      break;
    case 0x00080008:
      header.ImageType = TrimValue(value);
      break;
    case 0x00080016:
      header.Class = TrimValue(value);
      break;
    case 0x00080018:
      header.Instance = TrimValue(value);
      break;
    case 0x00180050:
      ReadDecimals(value, &header.Thickness, 1);
      break;
    case 0x00180088:
      ReadDecimals(value, &header.Step, 1);
      break;
    case 0x00201041:
    {
      double location;
      if (ReadDecimals(value, &location, 1))
      {
        header.Location = location;
      }
      break;
    }
    case 0x00541001:
    case 0x30040002:
      header.Units = TrimValue(value);
      break;
    case 0x3004000e:
    {
      double scale;
      if (ReadDecimals(value, &scale, 1))
      {
        header.DoseScale = scale;
      }
      break;
    }
    case 0x00620001:
      header.SegmentationType = TrimValue(value);
      break;
    case 0x0062000b:
      header.Segment = number();
      break;
    case 0x0062000e:
      header.Whole = number();
      break;
    case 0x00080060:
      header.Modality = TrimValue(value);
      break;
    case 0x0008103e:
      header.Description = TrimValue(value);
      break;
    case 0x0020000e:
      header.Series = TrimValue(value);
      break;
    case 0x00100020:
      header.Patient = TrimValue(value);
      break;
    case 0x00200011:
      header.SeriesNumber = ReadWhole(value, 0);
      break;
    case 0x00200032:
      header.HasPosition = ReadDecimals(value, header.Position, 3) || header.HasPosition;
      break;
    case 0x00200037:
      ReadDecimals(value, orientation, 6);
      break;
    case 0x00280002:
      header.Samples = number();
      break;
    case 0x00280004:
      header.IsYbr = TrimValue(value) == "YBR_FULL";
      header.IsHalved = TrimValue(value) == "YBR_FULL_422";
      header.IsPalette = TrimValue(value) == "PALETTE COLOR";
      break;
    case 0x00280008:
      header.Frames = ReadWhole(value, 1);
      break;
    case 0x00280010:
      header.Height = number();
      break;
    case 0x00280011:
      header.Width = number();
      break;
    case 0x00181164: // ImagerPixelSpacing, which precedes PixelSpacing
    case 0x00280030:
    {
      double spacing[2]; // first the distance between rows
      if (ReadDecimals(value, spacing, 2))
      {
        header.IsDetectorSpacing = tag == 0x00181164;
        header.Spacing[0] = spacing[1];
        header.Spacing[1] = spacing[0];
      }
      break;
    }
    case 0x00280006:
      header.ArePlanes = number() == 1;
      break;
    case 0x00280100:
      header.Bits = number();
      break;
    case 0x00280101:
      header.Stored = number();
      break;
    case 0x00280102:
      header.HighBit = number();
      break;
    case 0x00283000:
      header.HasValueTable = true;
      break;
    case 0x00280103:
      header.IsSigned = number() == 1;
      break;
    case 0x00280120:
      if (value.size() >= 2)
      {
        header.Padding = number();
      }
      break;
    case 0x00280122:
    case 0x00280123:
      header.Padding = ReadReal(value);
      break;
    case 0x00281052:
      ReadDecimals(value, &header.Intercept, 1);
      break;
    case 0x00281053:
      ReadDecimals(value, &header.Slope, 1);
      break;
    case 0x00281054:
      header.RescaleType = TrimValue(value);
      break;
    case 0x00080100: // CodeValue of the unit of a real-world value map
      header.RealWorld.Unit =
        header.RealWorld.Count == 0 ? TrimValue(value) : header.RealWorld.Unit;
      break;
    case 0x00409210: // LUTLabel, which follows the unit in each map
      ++header.RealWorld.Count;
      break;
    case 0x00409211: // RealWorldValueLastValueMapped
    case 0x00409216: // RealWorldValueFirstValueMapped
      if (header.RealWorld.Count < 2)
      {
        const bool isNegative = header.IsSigned && value.size() == 2 && number() > 32767;
        header.RealWorld.Range[tag == 0x00409211 ? 1 : 0] = number() - (isNegative ? 65536 : 0);
      }
      break;
    case 0x00409224:
      header.RealWorld.Intercept =
        header.RealWorld.Count < 2 ? ReadReal(value) : header.RealWorld.Intercept;
      break;
    case 0x00409225:
      header.RealWorld.Slope =
        header.RealWorld.Count < 2 ? std::optional(ReadReal(value)) : header.RealWorld.Slope;
      break;
    default:
      if (const Explore::DicomFact* const fact = Explore::FindDicomFact(tag))
      {
        TakeFact(*fact, value, header);
      }
      break;
  }
}

/// Reads all decimal numbers that are separated by backslashes; none if any of them is malformed.
std::vector<double> ReadAllDecimals(const std::string& text)
{
  std::vector<double> numbers(
    static_cast<std::size_t>(1 + std::count(text.begin(), text.end(), '\\')));
  return ReadDecimals(text, numbers.data(), static_cast<int>(numbers.size()))
    ? numbers
    : std::vector<double>();
}

/// Converts CIELab in 16-bit integers to red, green and blue: PS3.3, section C.10.7.1.1.
std::vector<double> ReadColor(const std::string& value)
{
  const auto part = [&](std::size_t i) { return ReadNumber(value, 2 * i, 2) / 65535.0; };
  const double lab[3] = { 100.0 * part(0), 255.0 * part(1) - 128.0, 255.0 * part(2) - 128.0 };
  std::vector<double> color(3);
  vtkMath::LabToRGB(lab, color.data());
  return color;
}

void TakeSegment(
  int number, std::uint32_t tag, const std::string& value, std::vector<DicomSegment>& segments)
{
  constexpr int most = 65535;
  if (number < 0 || number >= most)
  {
    return;
  }
  segments.resize(std::max(segments.size(), static_cast<std::size_t>(number) + 1));
  DicomSegment& segment = segments[static_cast<std::size_t>(number)];
  if (tag == 0x00620004)
  {
    segment.Number = static_cast<int>(ReadNumber(value, 0, 2));
  }
  else if (tag == 0x00620005)
  {
    segment.Name = TrimValue(value);
  }
  else if (tag == 0x0062000d && value.size() >= 6)
  {
    segment.Color = ReadColor(value);
  }
}

void OrientSlice(const double orientation[6], DicomHeader& header)
{
  double normal[3];
  vtkMath::Cross(orientation, orientation + 3, normal);
  // Without a valid orientation, keep that of an axial slice, which scanners make by default.
  if (vtkMath::Normalize(normal) > 0.5)
  {
    std::copy_n(orientation, 3, header.Row);
    std::copy_n(orientation + 3, 3, header.Column);
    std::copy_n(normal, 3, header.Normal);
  }
  header.Along = vtkMath::Dot(header.Position, header.Normal);
}

/// Applies the real-world value map, unless a rescale already converts the values.
void UseRealWorld(DicomHeader& header)
{
  DicomHeader::RealWorldMap& map = header.RealWorld;
  const bool isRescaled = header.Slope != 1.0 || header.Intercept != 0.0 ||
    !(header.RescaleType.empty() || header.RescaleType == "US");
  map.IsUsed = !isRescaled && map.Slope && *map.Slope != 0.0 && std::isfinite(*map.Slope) &&
    std::isfinite(map.Intercept);
  if (map.IsUsed)
  {
    header.Slope = *map.Slope;
    header.Intercept = map.Intercept;
  }
}

/// Stores the values of a file in the headers of its frames.
class ValueReader
{
public:
  ValueReader(DicomHeader& header, FramePlaces& places)
    : Header(header)
    , Places(places)
  {
  }

  void Read(const DicomElement& element, const std::string& value)
  {
    switch (element.Sequence)
    {
      case SEGMENTS:
        TakeSegment(element.Item, element.Tag, value, this->Places.Segments);
        break;
      case FRAME_GROUPS:
        this->ReadOfFrame(element, value);
        break;
      case DETECTORS: // all detectors of a reconstruction state the same position
        if (element.Item > 0)
        {
          break;
        }
        [[fallthrough]];
      default: // a value that applies to the whole file, or to all frames
        ReadValue(element.Tag, value, this->Header, this->Orientation);
        if (element.Tag == OFFSETS)
        {
          this->Places.Offsets = ReadAllDecimals(value);
        }
        break;
    }
  }

  void Orient()
  {
    OrientSlice(this->Orientation, this->Header);
    for (std::size_t i = 0; i < this->Places.Groups.size(); ++i)
    {
      OrientSlice(this->Orientations[i].data(), this->Places.Groups[i]);
    }
  }

private:
  void ReadOfFrame(const DicomElement& element, const std::string& value)
  {
    if (element.Item < 0 || element.Item >= MOST_FRAMES)
    {
      return;
    }
    std::vector<DicomHeader>& groups = this->Places.Groups;
    const auto index = static_cast<std::size_t>(element.Item);
    while (groups.size() <= index)
    {
      groups.push_back(this->Header);
      this->Orientations.emplace_back();
      std::copy_n(this->Orientation, 6, this->Orientations.back().begin());
      groups.back().HasPlaces = false;
    }
    groups[index].HasPlaces = groups[index].HasPlaces || element.Tag == 0x00200032;
    ReadValue(element.Tag, value, groups[index], this->Orientations[index].data());
  }

  DicomHeader& Header;
  FramePlaces& Places;
  double Orientation[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
  std::vector<std::array<double, 6>> Orientations;
};

/// Reads the header without the pixels. Returns false if the file can't be read or has no pixels.
bool ReadHeader(const std::string& path, DicomHeader& header, FramePlaces& places)
{
  header = {};
  header.File = path;
  DicomAnswer answer;
  std::string bytes;
  if (!Explore::AskDicom(DicomRequest::Values, path, 0, answer, bytes))
  {
    return false;
  }
  ValueReader reader(header, places);
  DicomElement element;
  for (std::size_t at = 0; at + sizeof(element) <= bytes.size(); at += element.Length)
  {
    std::memcpy(&element, &bytes[at], sizeof(element));
    at += sizeof(element);
    if (element.Length > bytes.size() - at)
    {
      return false;
    }
    reader.Read(element, bytes.substr(at, element.Length));
  }
  header.HasPixels = answer.PixelTag != 0;
  header.IsFloat = answer.PixelTag != PIXELS;
  const int bits = !header.IsFloat ? header.Bits : answer.PixelTag == FLOAT_PIXELS ? 32 : 64;
  if (answer.PixelTag == 0 || header.Width <= 0 || header.Height <= 0 || header.Bits <= 0 ||
    header.Samples <= 0 || header.Bits != bits)
  {
    return false;
  }
  header.Slope = header.DoseScale.value_or(header.Slope);
  UseRealWorld(header);
  std::for_each(places.Groups.begin(), places.Groups.end(), UseRealWorld);
  header.IsBig = answer.IsBig != 0;
  header.IsDeflated = answer.IsDeflated != 0;
  header.Pixels = answer.PixelPlace;
  header.Frames = std::max(header.Frames, 1);
  header.Stored = header.Stored > 0 ? std::min(header.Stored, header.Bits) : header.Bits;
  // The length of compressed pixels does not follow from the header.
  header.IsWhole = answer.AreItems != 0 ? answer.AreItemsWhole != 0
                                        : answer.PixelLength >=
      (header.IsHalved ? header.GetSizeOfAll() / 3 * 2 : header.GetSizeOfAll());
  reader.Orient();
  return true;
}
} // namespace

namespace Explore
{
bool DicomHeader::IsPlain() const
{
  const bool isPlain = this->TransferSyntax.empty() || this->TransferSyntax == IMPLICIT_LITTLE ||
    this->TransferSyntax == EXPLICIT_LITTLE || this->TransferSyntax == EXPLICIT_BIG;
  return isPlain && !this->IsHalved &&
    (this->Bits == 1 || this->Bits == 8 || this->Bits == 16 || this->Bits == 32 || this->IsFloat);
}

std::uint64_t DicomHeader::GetSize() const
{
  return (static_cast<std::uint64_t>(this->Width) * this->Height * this->Samples * this->Bits + 7) /
    8;
}

std::uint64_t DicomHeader::GetSizeOfAll() const
{
  // Frames of 1-bit samples follow each other without padding.
  return (static_cast<std::uint64_t>(this->Width) * this->Height * this->Samples * this->Bits *
             static_cast<std::uint64_t>(this->Frames) +
           7) /
    8;
}

bool DicomHeader::IsSegmentation() const
{
  return this->Class == "1.2.840.10008.5.1.4.1.1.66.4" ||
    this->Class == "1.2.840.10008.5.1.4.1.1.66.7" || this->Modality == "SEG";
}

const DicomFact* FindDicomFact(std::uint32_t tag)
{
  const auto* const found = std::find_if(std::begin(DICOM_FACTS), std::end(DICOM_FACTS),
    [tag](const DicomFact& fact) { return fact.Tag == tag; });
  return found != std::end(DICOM_FACTS) ? found : nullptr;
}

std::vector<DicomSegment> ReadDicomSegments(const std::string& path)
{
  DicomHeader header;
  FramePlaces places;
  ReadHeader(path, header, places);
  return places.Segments;
}

std::string NameUnreadSyntax(const std::string& transferSyntax)
{
  const std::string standard = "1.2.840.10008.1.2.";
  const auto begins = [&](const std::string& end)
  { return transferSyntax.compare(0, standard.size() + end.size(), standard + end) == 0; };
  return begins("4.20")                ? "High-Throughput JPEG 2000 (HTJ2K)"
    : begins("4.11")                   ? "JPEG XL"
    : begins("4.10")                   ? "a video (MPEG, H.264 or H.265)"
    : begins("4.94") || begins("4.95") ? "JPIP, whose pixels are on a server"
    : transferSyntax.empty() || transferSyntax.compare(0, 17, standard, 0, 17) == 0
    ? ""
    : "a private transfer syntax (" + transferSyntax + ")";
}

DicomObject FindDicomObject(const std::string& path)
{
  DicomHeader header;
  FramePlaces places;
  if (ReadHeader(path, header, places))
  {
    return {};
  }
  const std::string syntax = NameUnreadSyntax(header.TransferSyntax);
  if (!syntax.empty() && header.Width == 0)
  {
    return { "a DICOM file whose pixels are compressed as " + syntax + ", which is not supported",
      UNCOMPRESS };
  }
  for (const auto& [begin, name, cure] : OBJECTS)
  {
    if (header.Class.compare(0, std::strlen(begin), begin) == 0)
    {
      return { name, cure };
    }
  }
  const bool isUnread = header.Class.empty() && header.TransferSyntax.empty();
  const bool isMarked = header.Class.empty() && HasDicomMark(path);
  if (header.Width > 0 || (isUnread && isMarked))
  {
    return { header.Width > 0 && !header.HasPixels
        ? "a DICOM file without pixel data: damaged, truncated, or written without it"
        : "a damaged or truncated DICOM file",
      "copy or export it again" };
  }
  if (header.Class.empty() && !isMarked)
  {
    return {};
  }
  return { "a DICOM object" + (header.Modality.empty() ? "" : " (" + header.Modality + ")") +
      " without an image",
    NAME_IMAGES };
}

bool ReadDicomHeader(const std::string& path, DicomHeader& header)
{
  FramePlaces places;
  return ReadHeader(path, header, places);
}

std::vector<DicomHeader> ReadDicomSlices(const std::string& path)
{
  DicomHeader header;
  FramePlaces places;
  if (!ReadHeader(path, header, places))
  {
    return {};
  }
  // For a truncated file, 1000 frames are enough to report the fault.
  const int count = std::min(header.Frames, header.IsWhole ? MOST_FRAMES : 1000);
  const auto frames = static_cast<std::size_t>(count);
  std::vector<DicomHeader> slices(frames, header);
  const bool haveGroups = places.Groups.size() >= frames;
  const bool haveOffsets = places.Offsets.size() == frames;
  for (std::size_t i = 0; i < frames; ++i)
  {
    DicomHeader& slice = slices[i];
    slice.Frame = static_cast<int>(i);
    slice.Pixels += header.Bits == 1 ? 0 : header.GetSize() * i;
    if (haveGroups && places.Groups[i].HasPlaces)
    {
      const DicomHeader& own = places.Groups[i];
      std::copy_n(own.Position, 3, slice.Position);
      std::copy_n(own.Row, 3, slice.Row);
      std::copy_n(own.Column, 3, slice.Column);
      std::copy_n(own.Normal, 3, slice.Normal);
      std::copy_n(own.Spacing, 2, slice.Spacing);
      slice.Along = own.Along;
      slice.Slope = own.Slope;
      slice.Intercept = own.Intercept;
      slice.RealWorld = own.RealWorld;
      slice.HasPosition = true;
      slice.Facts = own.Facts;
      slice.Step = own.Step;
      slice.Segment = own.Segment;
      continue;
    }
    if (count == 1)
    {
      continue; // a single frame has the header's position, or a scanner's default position
    }
    // The offsets of a dose either start at 0 along the normal, or are absolute z positions in the
    // patient (PS3.3, section C.8.8.3.2).
    const bool areAbsolute = haveOffsets && places.Offsets[0] != 0.0;
    const double step = !haveOffsets ? header.Step * static_cast<double>(i)
                                     : (places.Offsets[i] - places.Offsets[0]) *
        (areAbsolute && slice.Normal[2] < 0.0 ? -1.0 : 1.0);
    slice.HasPlaces = haveOffsets || header.Step != 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      slice.Position[axis] += step * slice.Normal[axis];
    }
    slice.Along += step;
  }
  return slices;
}
} // namespace Explore
