// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads TIFF files. libtiff runs in another process, which a damaged file may crash: it first lists
 * the pages of the files, and then reads the samples of boxes.
 */
#include "VTK/Regions/Formats/LargeFile.h"

#include "Core/Platform/HapticFiles.h"
#include "Core/Platform/PackedBytes.h"
#include "Core/Platform/ReaderProcess.h"
#include "VTK/Base/ArrayMemory.h"
#include "VTK/Base/ByteOrder.h"
#include "VTK/Base/LengthUnit.h"
#include "VTK/Base/NameOrder.h"
#include "VTK/Regions/Formats/FurtherAxes.h"
#include "VTK/Regions/Formats/OpenedFile.h"
#include "VTK/Regions/Formats/RawVolumeFile.h"
#include "VTK/Regions/Formats/TiffText.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtk_tiff.h"

#include "vtksys/Directory.hxx"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

using TiffPointer = std::unique_ptr<TIFF, decltype(&TIFFClose)>;

/**
 * Location of a page: its file's index in the stack, and the offset of its directory in that file.
 */
struct TiffPage
{
  std::size_t File = 0;
  toff_t Offset = 0;
};

/** Layout of a page, the same for all pages of a stack. */
struct TiffLayout
{
  uint32_t Width = 0;
  uint32_t Height = 0;
  int ScalarType = 0;

  bool operator==(const TiffLayout& other) const
  {
    return this->Width == other.Width && this->Height == other.Height &&
      this->ScalarType == other.ScalarType;
  }
};

struct TiffStack
{
  std::vector<std::string> Files;
  std::vector<TiffPage> Pages; ///< one page per slice
  TiffLayout Layout;

  /** Returns the number of bytes of a box in each slice. */
  std::size_t CountSliceBytes(const int box[6]) const
  {
    return static_cast<std::size_t>(vtkAbstractArray::GetDataTypeSize(this->Layout.ScalarType)) *
      static_cast<std::size_t>(box[1] - box[0] + 1) * static_cast<std::size_t>(box[3] - box[2] + 1);
  }
  /** Reads a box through the reader process. */
  bool Read(const int box[6], void* samples) const;
  void ReadHere(const int box[6], void* samples) const;

private:
  void ReadPage(TIFF* tiff, const int box[6], char* samples) const;
};

/** Location of the samples of an image and of the images that follow without directories. */
struct TiffSamples
{
  std::uint8_t AreUsed = 0;
  std::uint8_t AreSwapped = 0; ///< whether the byte order differs from this computer's
  std::uint64_t Offset = 0;
  ///@{
  /** Number of pages before the first slice, and from one slice to the next. */
  std::uint64_t First = 0;
  std::uint64_t Step = 1;
  ///@}
};

/** Facts about files that OpenTiff() gets from the reader process. */
struct TiffFacts
{
  TiffStack Stack;
  TiffSamples Headless;
  std::size_t Slices = 0;
  std::array<double, 3> Spacing{}; ///< mm
  /** Slope and offset of ImageJ's calibration: value = Line[0] + Line[1] * sample. */
  std::array<double, 2> Line{ 0.0, 1.0 };
  bool IsCurved = false; ///< whether ImageJ's calibration is not linear
  LargeFile Told;        ///< notes and list of volumes
};

/** Pages of one volume: a channel at one time. */
struct TiffVolume
{
  std::size_t First = 0; ///< index of the first slice's page
  std::size_t Step = 1;  ///< number of pages from one slice to the next
  std::size_t Slices = 1;

  std::size_t GetPage(std::size_t slice) const { return this->First + slice * this->Step; }
  std::size_t GetLastPage() const { return this->GetPage(this->Slices - 1); }
};

#if defined(TIFFLIB_VERSION) && TIFFLIB_VERSION >= 20221213
int IgnoreMessage(TIFF*, void*, const char*, const char*, va_list)
{
  return 1;
}
#endif

/** Opens a file without printing libtiff's messages. */
TiffPointer OpenQuietly(const std::string& name)
{
  const OpenedFile isThere(name); // opened only to throw if the file is missing or a pipe
#if defined(TIFFLIB_VERSION) && TIFFLIB_VERSION >= 20221213
  TIFFOpenOptions* const options = TIFFOpenOptionsAlloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options, IgnoreMessage, nullptr);
  TIFFOpenOptionsSetWarningHandlerExtR(options, IgnoreMessage, nullptr);
  TiffPointer tiff(TIFFOpenExt(name.c_str(), "rm", options), TIFFClose);
  TIFFOpenOptionsFree(options);
#else
  TiffPointer tiff(TIFFOpen(name.c_str(), "rm"), TIFFClose);
#endif
  if (!tiff)
  {
    throw std::runtime_error("it is not a TIFF file, or its header is damaged. Check what " +
      vtksys::SystemTools::GetFilenameName(name) + " really is, and that its copy is complete.");
  }
  return tiff;
}

template <typename Number>
Number Tag(TIFF* tiff, uint32_t tag, Number otherwise)
{
  Number number = otherwise;
  return TIFFGetFieldDefaulted(tiff, tag, &number) == 1 ? number : otherwise;
}

std::string Describe(TIFF* tiff)
{
  char* text = nullptr;
  return TIFFGetField(tiff, TIFFTAG_IMAGEDESCRIPTION, &text) == 1 && text ? text : "";
}

/** Reads the layout of a page. Throws unless its samples are numbers with one channel. */
TiffLayout ReadLayout(TIFF* tiff)
{
  TiffLayout layout;
  TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &layout.Width);
  TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &layout.Height);
  const auto bits = Tag<uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE, 1);
  const auto samples = Tag<uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  const auto format = Tag<uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  const auto meaning = Tag<uint16_t>(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  if (samples != 1)
  {
    throw std::runtime_error("its pages have " + std::to_string(samples) +
      " samples a pixel, as pictures in colours have. Write it with one grey value a pixel.");
  }
  if (meaning != PHOTOMETRIC_MINISBLACK)
  {
    throw std::runtime_error("its values are not brightness from black on: they are inverted, or "
                             "numbers of colours. Write it with one grey value a pixel.");
  }
  const bool isInteger = format != SAMPLEFORMAT_IEEEFP;
  layout.ScalarType = bits % 8 != 0 || format > SAMPLEFORMAT_IEEEFP
    ? 0
    : ChooseScalarType(isInteger, format == SAMPLEFORMAT_INT, bits / 8U);
  if (layout.ScalarType == 0)
  {
    throw std::runtime_error("its samples have " + std::to_string(bits) +
      " bits, or are complex. Write it with 8, 16, 32 or 64 bits.");
  }
  constexpr auto most = static_cast<uint32_t>(std::numeric_limits<int>::max());
  if (layout.Width < 1 || layout.Height < 1 || layout.Width > most || layout.Height > most)
  {
    throw std::runtime_error("its pages have no size, or a damaged one. Write it again.");
  }
  if (!TIFFIsCODECConfigured(Tag<uint16_t>(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE)))
  {
    throw std::runtime_error("its samples are compressed in a way that this libtiff can't unpack. "
                             "Write it uncompressed, or with LZW or Deflate.");
  }
  return layout;
}

double CountPageBytes(const TiffLayout& layout)
{
  return double{ 1.0 } * layout.Width * layout.Height *
    vtkAbstractArray::GetDataTypeSize(layout.ScalarType);
}

/**
 * Throws unless a page's samples are within the file. `more` is the number of images that follow
 * without a directory.
 */
void CheckPage(TIFF* tiff, const TiffLayout& layout, double size, std::size_t more)
{
  uint64_t* offsets = nullptr;
  uint64_t* counts = nullptr;
  const bool isTiled = TIFFIsTiled(tiff) != 0;
  const uint32_t pieces = isTiled ? TIFFNumberOfTiles(tiff) : TIFFNumberOfStrips(tiff);
  const bool isThere =
    TIFFGetField(tiff, isTiled ? TIFFTAG_TILEOFFSETS : TIFFTAG_STRIPOFFSETS, &offsets) == 1 &&
    TIFFGetField(tiff, isTiled ? TIFFTAG_TILEBYTECOUNTS : TIFFTAG_STRIPBYTECOUNTS, &counts) == 1 &&
    offsets && counts;
  constexpr uint32_t largestTile = 65536;
  bool isWhole = isThere && pieces > 0 &&
    (!isTiled ||
      (Tag<uint32_t>(tiff, TIFFTAG_TILEWIDTH, 0) <= largestTile &&
        Tag<uint32_t>(tiff, TIFFTAG_TILELENGTH, 0) <= largestTile));
  double held = 0.0;
  for (uint32_t piece = 0; isWhole && piece < pieces; ++piece)
  {
    held += static_cast<double>(counts[piece]);
    isWhole = static_cast<double>(offsets[piece]) + static_cast<double>(counts[piece]) <= size;
  }
  // Upper limit of compression: deflate shrinks zeros by at most 1032, LZMA by 7000, Zstandard by
  // 32000.
  constexpr double smallest = 40000.0;
  const double piece = static_cast<double>(isTiled ? TIFFTileSize64(tiff) : TIFFStripSize64(tiff));
  const bool isPlain =
    Tag<uint16_t>(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE) == COMPRESSION_NONE;
  isWhole = isWhole && CountPageBytes(layout) <= held * (isPlain ? 1.0 : smallest) &&
    piece <= held * smallest;
  if (isWhole && more > 0)
  {
    isWhole = isPlain && !isTiled &&
      static_cast<double>(offsets[0]) +
          (1.0 + static_cast<double>(more)) * CountPageBytes(layout) <=
        size;
  }
  if (!isWhole)
  {
    throw std::runtime_error("it is cut off or damaged: it names samples that are not in the file. "
                             "Check that its copy is complete.");
  }
}

/** Sets the pixel distances that the description lacks from the resolution of a page. */
void AddResolution(TIFF* tiff, TiffText& text, std::vector<std::string>& notes)
{
  const float resolution[2] = { Tag(tiff, TIFFTAG_XRESOLUTION, 0.0F),
    Tag(tiff, TIFFTAG_YRESOLUTION, 0.0F) };
  const auto unit = Tag<uint16_t>(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
  const double perUnit = text.IsImageJ ? text.PerUnit
    : unit == RESUNIT_CENTIMETER       ? MillimetresPerUnit("cm")
    : unit == RESUNIT_INCH             ? MillimetresPerUnit("in")
                                       : 0.0;
  // Ignore the resolution of a screen or a printer, which programs write if they do not know the
  // size.
  const bool isOfScreen = !text.IsImageJ && unit == RESUNIT_INCH &&
    (resolution[0] <= 1.0F || resolution[0] == 72.0F || resolution[0] == 96.0F ||
      resolution[0] == 300.0F);
  for (int a = 0; a < 2; ++a)
  {
    if (!(text.Spacing[a] > 0.0) && resolution[a] > 0.0F && !isOfScreen)
    {
      text.Spacing[a] = perUnit / static_cast<double>(resolution[a]);
    }
  }
  const bool isKnown = text.Spacing[0] > 0.0 && text.Spacing[1] > 0.0;
  if (!isKnown)
  {
    std::fill_n(text.Spacing, 3, 1.0);
    notes.emplace_back("the TIFF file gives no size of a voxel: cubes of 1 mm are assumed");
  }
  else if (!(text.Spacing[2] > 0.0))
  {
    text.Spacing[2] = text.Spacing[0];
    notes.emplace_back("the TIFF file gives no distance of its pages: the spacing along x is used");
  }
}

std::vector<std::string> ListFiles(const std::string& folder)
{
  vtksys::Directory directory;
  directory.Load(folder);
  std::vector<std::string> names;
  for (unsigned long i = 0; i < directory.GetNumberOfFiles(); ++i)
  {
    const std::string name = directory.GetFile(i);
    const std::string ending =
      vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(name));
    if ((ending == ".tif" || ending == ".tiff") && name.front() != '.')
    {
      names.push_back(name);
    }
  }
  std::sort(names.begin(), names.end(), IsNamedBefore);
  for (std::string& name : names)
  {
    name.insert(0, folder + "/");
  }
  return names;
}

/** Adds the current page if it has the layout of the first page. Returns whether it does. */
bool AddPage(TIFF* tiff, std::size_t file, double size, TiffStack& stack)
{
  constexpr uint32_t aside = FILETYPE_REDUCEDIMAGE | FILETYPE_MASK;
  if ((Tag<uint32_t>(tiff, TIFFTAG_SUBFILETYPE, 0) & aside) != 0)
  {
    return false;
  }
  const TiffLayout layout = ReadLayout(tiff);
  if (stack.Pages.empty())
  {
    stack.Layout = layout;
  }
  if (!(layout == stack.Layout))
  {
    return false;
  }
  CheckPage(tiff, layout, size, 0);
  stack.Pages.push_back({ file, TIFFCurrentDirOffset(tiff) });
  return true;
}

/**
 * Adds the pages of a file that have the first page's layout. Returns the number of other pages.
 */
std::size_t AddPages(std::size_t file, TiffStack& stack)
{
  const TiffPointer tiff = OpenQuietly(stack.Files[file]);
  const auto size = static_cast<double>(OpenedFile(stack.Files[file]).GetSize());
  std::size_t others = AddPage(tiff.get(), file, size, stack) ? 0 : 1;
  while (TIFFLastDirectory(tiff.get()) == 0)
  {
    if (TIFFReadDirectory(tiff.get()) != 1)
    {
      throw std::runtime_error("it is cut off or damaged: a page that it names is not in the file. "
                               "Check that its copy is complete.");
    }
    others += AddPage(tiff.get(), file, size, stack) ? 0 : 1;
  }
  return others;
}

/** Adds the pages of all files in a folder. Returns the number of pages with another layout. */
std::size_t AddFiles(TiffStack& stack)
{
  std::size_t others = 0;
  std::string left;
  for (std::size_t i = 0; i < stack.Files.size(); ++i)
  {
    const std::size_t before = stack.Pages.size();
    others += AddPages(i, stack);
    const std::string name = vtksys::SystemTools::GetFilenameName(stack.Files[i]);
    if (stack.Pages.size() == before)
    {
      left = before > 0 ? name : left;
    }
    else if (!left.empty())
    {
      throw std::runtime_error("its pages have several sizes or types: " + Printable(left) +
        ", between others, has its own. Write all slices alike, or remove that file.");
    }
  }
  return others;
}

/** Returns the last number in a file's name; -1 if there is none. */
double ReadLastNumber(const std::string& path)
{
  const std::string name = vtksys::SystemTools::GetFilenameWithoutLastExtension(path);
  const std::size_t last = name.find_last_of("0123456789");
  if (last == std::string::npos)
  {
    return -1.0;
  }
  const std::size_t first = name.find_last_not_of("0123456789", last);
  return ReadNumberOr(name.substr(first + 1, last - first).c_str(), -1.0);
}

/** Returns a note if the numbers in the slices' names have gaps; empty otherwise. */
std::string DescribeGaps(const std::vector<std::string>& files)
{
  std::vector<double> steps;
  for (std::size_t i = 1; i < files.size(); ++i)
  {
    steps.push_back(ReadLastNumber(files[i]) - ReadLastNumber(files[i - 1]));
  }
  const double least = steps.empty() ? 0.0 : *std::min_element(steps.begin(), steps.end());
  const double most = steps.empty() ? 0.0 : *std::max_element(steps.begin(), steps.end());
  return least >= 1.0 && most > least ? "the numbers in the names of the slices have gaps: slices "
                                        "beside a gap are taken for neighbours"
                                      : std::string();
}

/** Chooses a channel and a time by the number of the volume: see ChooseVolume(). */
TiffVolume ChooseChannel(const TiffText& text, int number, LargeFile& file)
{
  const std::vector<std::size_t> indices =
    ChooseVolume({ { "channel", text.Channels, text.ChannelNames }, { text.TimeName, text.Times } },
      number, file);
  return { indices[0] * text.ChannelStep + indices[1] * text.TimeStep, text.SliceStep,
    std::max<std::size_t>(1, text.Slices) };
}

/** Removes all pages except those of a volume. */
void KeepVolume(const TiffText& text, TiffVolume volume, TiffStack& stack, LargeFile& file)
{
  const std::size_t pages = stack.Pages.size();
  volume.Slices = text.Slices > 0 ? text.Slices : pages;
  if (volume.Slices > pages)
  {
    throw std::runtime_error("it tells of " + std::to_string(volume.Slices) + " slices, and has " +
      std::to_string(pages) + ". Check that its copy is complete.");
  }
  if (volume.GetLastPage() >= pages)
  {
    throw std::runtime_error("it tells of " + std::to_string(volume.Slices) + " slices in " +
      std::to_string(volume.GetLastPage() + 1) + " pages, and has " + std::to_string(pages) +
      ". Check that its copy is complete.");
  }
  std::vector<TiffPage> kept;
  for (std::size_t k = 0; k < volume.Slices; ++k)
  {
    kept.push_back(stack.Pages[volume.GetPage(k)]);
  }
  if (kept.size() < pages && text.Channels * text.Times == 1)
  {
    file.Notes.push_back(std::to_string(pages - kept.size()) + " further TIFF pages are left out");
  }
  stack.Pages = std::move(kept);
}

/** Collects the pages of a stack from several files in the folder of the file that names them. */
void CollectPlanes(
  const std::string& folder, const TiffText& text, const TiffVolume& volume, TiffStack& stack)
{
  stack.Files.clear();
  std::vector<TiffPage> kept;
  std::vector<std::vector<TiffPage>> pages; // pages of each file
  for (std::size_t slice = 0; slice < volume.Slices; ++slice)
  {
    const auto& [name, page] = text.Planes[volume.GetPage(slice)];
    const std::string path = folder + "/" + vtksys::SystemTools::GetFilenameName(name);
    const auto found = std::find(stack.Files.begin(), stack.Files.end(), path);
    const auto file = static_cast<std::size_t>(found - stack.Files.begin());
    if (found == stack.Files.end())
    {
      if (name.empty() || !vtksys::SystemTools::FileExists(path, true))
      {
        throw std::runtime_error("its OME-XML names the file \"" + Printable(name) +
          "\" for a slice, which is missing. Copy all files of the stack into one folder.");
      }
      const TiffLayout first = stack.Layout;
      stack.Files.push_back(path);
      stack.Pages.clear();
      AddPages(file, stack);
      if (file > 0 && !(stack.Layout == first))
      {
        throw std::runtime_error(
          "its files have pages of several sizes or types. Write all slices alike.");
      }
      pages.push_back(stack.Pages);
    }
    if (page >= pages[file].size())
    {
      throw std::runtime_error("its OME-XML names page " + std::to_string(page) + " of " +
        Printable(name) + ", which has " + std::to_string(pages[file].size()) +
        ". Check that its copy is complete.");
    }
    kept.push_back(pages[file][page]);
  }
  stack.Pages = std::move(kept);
}

/**
 * Returns a function that reads boxes and applies ImageJ's linear calibration, line[0] + line[1] *
 * sample.
 */
template <typename Value>
BoxReader ApplyLine(const LargeFile& file, const std::array<double, 2>& line)
{
  const BoxReader stored = file.Read;
  const int type = file.ScalarType;
  const double first = line[0], slope = line[1];
  return [stored, type, first, slope](const int box[6], void* samples)
  {
    const vtkIdType count =
      vtkIdType{ box[1] - box[0] + 1 } * (box[3] - box[2] + 1) * (box[5] - box[4] + 1);
    const auto array = NewArray(type, 1, count);
    if (!stored(box, array->GetVoidPointer(0)))
    {
      return false;
    }
    auto* const values = static_cast<Value*>(samples);
    for (vtkIdType i = 0; i < count; ++i)
    {
      values[i] = static_cast<Value>(first + slope * array->GetComponent(i, 0));
    }
    return true;
  };
}

/**
 * Converts stored samples to the values that ImageJ shows. The result is floats, or signed 16-bit
 * integers if they were stored as unsigned ones with an offset of 32768.
 */
void Calibrate(const TiffFacts& facts, LargeFile& file)
{
  const bool isLine = facts.Line[0] != 0.0 || facts.Line[1] != 1.0;
  std::ostringstream note;
  if (facts.IsCurved || !std::isfinite(facts.Line[0]) || !std::isfinite(facts.Line[1]))
  {
    note << "ImageJ's calibration of values is not applied: the stored ones are felt";
  }
  else if (isLine)
  {
    const bool isSigned =
      facts.Line[0] == -32768.0 && facts.Line[1] == 1.0 && file.ScalarType == VTK_UNSIGNED_SHORT;
    file.Read = isSigned ? ApplyLine<short>(file, facts.Line) : ApplyLine<float>(file, facts.Line);
    file.ScalarType = isSigned ? VTK_SHORT : VTK_FLOAT;
    note << "values are " << facts.Line[0] << " plus " << facts.Line[1]
         << " times the stored ones, as ImageJ shows them";
  }
  if (!note.str().empty())
  {
    file.Notes.push_back(note.str());
  }
}

LargeFile MakeFile(const TiffLayout& layout, std::size_t slices)
{
  if (slices > static_cast<std::size_t>(std::numeric_limits<int>::max()))
  {
    throw std::runtime_error("it has more pages than an image can have slices.");
  }
  if (slices < 2)
  {
    throw std::runtime_error("it has a single page: one slice is no volume. Name the folder of all "
                             "slices, or a file with a page for each.");
  }
  LargeFile file;
  file.Extent = { 0, static_cast<int>(layout.Width) - 1, 0, static_cast<int>(layout.Height) - 1, 0,
    static_cast<int>(slices) - 1 };
  file.ScalarType = layout.ScalarType;
  return file;
}

/**
 * Locates the samples of a stack of more than 4 GiB, which ImageJ writes as one page followed by
 * all other images.
 */
TiffSamples FindHeadless(
  const std::string& name, TIFF* tiff, const TiffLayout& layout, const TiffVolume& volume)
{
  CheckPage(tiff, layout, static_cast<double>(OpenedFile(name).GetSize()), volume.GetLastPage());
  uint64_t* offsets = nullptr;
  TIFFGetField(tiff, TIFFTAG_STRIPOFFSETS, &offsets);
  return { 1, TIFFIsByteSwapped(tiff) != 0, offsets[0], volume.First, volume.Step };
}

BoxReader ReadHeadless(const std::string& name, const TiffFacts& facts, const BoxExtent& extent)
{
  const TiffLayout& layout = facts.Stack.Layout;
  const TiffSamples& where = facts.Headless;
  const auto page = static_cast<std::int64_t>(layout.Width) * layout.Height; // samples
  const RawVolumeFile samples{ name, extent,
    static_cast<std::size_t>(vtkAbstractArray::GetDataTypeSize(layout.ScalarType)),
    static_cast<vtkTypeInt64>(where.Offset), where.AreSwapped != 0,
    { 1, layout.Width, page * static_cast<std::int64_t>(where.Step) },
    page * static_cast<std::int64_t>(where.First) };
  return [samples](const int box[6], void* to)
  {
    samples.Read(box, to);
    return true;
  };
}

[[noreturn]] void ThrowDamaged()
{
  throw std::runtime_error(
    "a page of it can't be unpacked: it is damaged or truncated. Check that its "
    "copy is complete.");
}

/** Reads the part of a page inside a box, strip by strip or tile by tile. */
void TiffStack::ReadPage(TIFF* tiff, const int box[6], char* samples) const
{
  const bool isTiled = TIFFIsTiled(tiff) != 0;
  const auto size =
    static_cast<std::size_t>(vtkAbstractArray::GetDataTypeSize(this->Layout.ScalarType));
  const auto width = isTiled ? Tag<uint32_t>(tiff, TIFFTAG_TILEWIDTH, 0) : this->Layout.Width;
  const auto told = isTiled ? Tag<uint32_t>(tiff, TIFFTAG_TILELENGTH, 0)
                            : Tag<uint32_t>(tiff, TIFFTAG_ROWSPERSTRIP, this->Layout.Height);
  const uint32_t height = isTiled ? told : std::min(told, this->Layout.Height);
  const tmsize_t bytes = isTiled ? TIFFTileSize(tiff) : TIFFStripSize(tiff);
  if (width == 0 || height == 0 || bytes <= 0 ||
    static_cast<std::size_t>(bytes) < size * width * height)
  {
    ThrowDamaged();
  }
  std::vector<char> piece(static_cast<std::size_t>(bytes));
  const auto first = [&](int at, uint32_t step) { return at / static_cast<int>(step); };
  const std::size_t row = static_cast<std::size_t>(box[1] - box[0] + 1) * size;
  for (int y = first(box[2], height); y <= first(box[3], height); ++y)
  {
    for (int x = first(box[0], width); x <= first(box[1], width); ++x)
    {
      const int left = x * static_cast<int>(width);
      const int top = y * static_cast<int>(height);
      const auto from = static_cast<uint32_t>(left);
      const uint32_t number = isTiled
        ? TIFFComputeTile(tiff, from, static_cast<uint32_t>(top), 0, 0)
        : TIFFComputeStrip(tiff, static_cast<uint32_t>(top), 0);
      const tmsize_t got = isTiled ? TIFFReadEncodedTile(tiff, number, piece.data(), bytes)
                                   : TIFFReadEncodedStrip(tiff, number, piece.data(), bytes);
      const int last[2] = { std::min(box[1], left + static_cast<int>(width) - 1),
        std::min(box[3], top + static_cast<int>(height) - 1) };
      const std::size_t needed = size *
        (static_cast<std::size_t>(last[1] - top) * width +
          static_cast<std::size_t>(last[0] - left) + 1);
      if (got < 0 || static_cast<std::size_t>(got) < needed)
      {
        ThrowDamaged();
      }
      for (int j = std::max(box[2], top); j <= last[1]; ++j)
      {
        const int i = std::max(box[0], left);
        std::memcpy(samples + static_cast<std::size_t>(j - box[2]) * row +
            static_cast<std::size_t>(i - box[0]) * size,
          piece.data() + size * (static_cast<std::size_t>(j - top) * width + (i - left)),
          static_cast<std::size_t>(last[0] - i + 1) * size);
      }
    }
  }
}

void TiffStack::ReadHere(const int box[6], void* samples) const
{
  TiffPointer tiff(nullptr, TIFFClose);
  std::size_t opened = this->Files.size();
  for (int k = box[4]; k <= box[5]; ++k)
  {
    const TiffPage& page = this->Pages[static_cast<std::size_t>(k)];
    if (page.File != opened)
    {
      tiff = OpenQuietly(this->Files[page.File]);
      opened = page.File;
    }
    if (TIFFSetSubDirectory(tiff.get(), page.Offset) != 1 ||
      !(ReadLayout(tiff.get()) == this->Layout))
    {
      throw std::runtime_error("it has changed since it was opened. Open it again.");
    }
    this->ReadPage(tiff.get(), box,
      static_cast<char*>(samples) +
        static_cast<std::size_t>(k - box[4]) * this->CountSliceBytes(box));
  }
}

/** Returns a stack of some of the slices, with only the files that they need. */
TiffStack TakeSlices(const TiffStack& stack, int first, int last)
{
  TiffStack some;
  some.Layout = stack.Layout;
  for (int k = first; k <= last; ++k)
  {
    const TiffPage& page = stack.Pages[static_cast<std::size_t>(k)];
    const std::string& name = stack.Files[page.File];
    if (some.Files.empty() || some.Files.back() != name)
    {
      some.Files.push_back(name);
    }
    some.Pages.push_back({ some.Files.size() - 1, page.Offset });
  }
  return some;
}

void PackTexts(const std::vector<std::string>& texts, BytePacker& packer)
{
  packer.Put<std::uint64_t>(texts.size());
  for (const std::string& text : texts)
  {
    packer.PutText(text);
  }
}

std::vector<std::string> UnpackTexts(ByteUnpacker& unpacker)
{
  std::vector<std::string> texts;
  for (auto left = unpacker.Get<std::uint64_t>(); left > 0; --left)
  {
    texts.push_back(unpacker.GetText());
  }
  return texts;
}

void PackStack(const TiffStack& stack, BytePacker& packer)
{
  PackTexts(stack.Files, packer);
  packer.PutList(stack.Pages);
  packer.Put(stack.Layout);
}

/** Unpacks a stack, and checks the facts that libtiff would trust. */
TiffStack UnpackStack(ByteUnpacker& unpacker)
{
  TiffStack stack;
  stack.Files = UnpackTexts(unpacker);
  stack.Pages = unpacker.GetList<TiffPage>();
  stack.Layout = unpacker.Get<TiffLayout>();
  constexpr auto most = static_cast<uint32_t>(std::numeric_limits<int>::max());
  const TiffLayout& layout = stack.Layout;
  if (layout.Width < 1 || layout.Height < 1 || layout.Width > most || layout.Height > most ||
    vtkAbstractArray::GetDataTypeSize(layout.ScalarType) < 1 ||
    std::any_of(stack.Pages.begin(), stack.Pages.end(),
      [&](const TiffPage& page) { return page.File >= stack.Files.size(); }))
  {
    ThrowDamaged();
  }
  return stack;
}

/** Throws the fault that the reader process found, which is the first text of its answer. */
void CheckAnswer(ReadResult result, const std::string& answer, ByteUnpacker& unpacker)
{
  if (result == ReadResult::Ended)
  {
    throw std::runtime_error(answer + ". Copy or write it again.");
  }
  const std::string fault = unpacker.GetText();
  if (!fault.empty())
  {
    throw std::runtime_error(fault);
  }
}

/** Cost of opening a file, as the number of bytes that take equally long to read. */
constexpr double OpeningBytes = 256 << 10;

bool TiffStack::Read(const int box[6], void* samples) const
{
  constexpr std::size_t most = 64 << 20; // largest answer (bytes), unless a single slice has more
  const std::size_t slice = this->CountSliceBytes(box);
  const int atOnce = std::max(1, static_cast<int>(most / slice));
  auto* to = static_cast<char*>(samples);
  for (int k = box[4]; k <= box[5]; k += atOnce)
  {
    const int last = std::min(k + atOnce - 1, box[5]);
    const TiffStack some = TakeSlices(*this, k, last);
    const std::array<int, 6> part{ box[0], box[1], box[2], box[3], 0, last - k };
    BytePacker packer;
    PackStack(some, packer);
    packer.Put(part);
    std::string answer;
    const double unpacked = CountPageBytes(this->Layout) * static_cast<double>(some.Pages.size()) +
      OpeningBytes * static_cast<double>(some.Files.size());
    const ReadResult result = AskReader(ReadTask::TiffBox, some.Files.front(), answer, packer.Bytes,
      static_cast<std::uint64_t>(std::min(unpacked, 1e15)));
    const std::size_t bytes = slice * some.Pages.size();
    if (result == ReadResult::NoProcess)
    {
      some.ReadHere(part.data(), to);
    }
    else
    {
      ByteUnpacker unpacker(answer);
      CheckAnswer(result, answer, unpacker);
      std::memcpy(to, unpacker.Take(bytes, 1), bytes);
    }
    to += bytes;
  }
  return true;
}

TiffFacts ReadFacts(const std::string& path, int number)
{
  TiffFacts facts;
  TiffStack& stack = facts.Stack;
  const bool isFolder = vtksys::SystemTools::FileIsDirectory(path);
  stack.Files = isFolder ? ListFiles(path) : std::vector<std::string>{ path };
  const TiffPointer tiff = OpenQuietly(stack.Files.front());
  TiffText text = ReadTiffText(Describe(tiff.get()), vtksys::SystemTools::GetFilenameName(path));
  AddResolution(tiff.get(), text, facts.Told.Notes);
  if (const auto turn = Tag<uint16_t>(tiff.get(), TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
      turn != ORIENTATION_TOPLEFT)
  {
    facts.Told.Notes.push_back("the TIFF file's Orientation (" + std::to_string(turn) +
      ") is not used: if it is true, the volume is mirrored or turned");
  }
  const TiffVolume volume = ChooseChannel(isFolder ? TiffText() : text, number, facts.Told);
  std::copy_n(text.Spacing, 3, facts.Spacing.begin());
  std::copy_n(text.Line, 2, facts.Line.begin());
  facts.IsCurved = text.IsCurved;
  if (!isFolder && text.Whole > 1 && TIFFNumberOfDirectories(tiff.get()) == 1)
  {
    stack.Layout = ReadLayout(tiff.get());
    facts.Headless = FindHeadless(path, tiff.get(), stack.Layout, volume);
    facts.Slices = volume.Slices;
    return facts;
  }
  const bool areElsewhere = !isFolder && !text.Planes.empty();
  const std::size_t others = areElsewhere ? 0 : AddFiles(stack);
  const bool areStacks =
    isFolder && stack.Files.size() > 1 && stack.Pages.size() > stack.Files.size();
  const std::string gaps = areStacks
    ? "the folder has files of several pages: they are put one behind the other"
    : isFolder ? DescribeGaps(stack.Files)
               : std::string();
  facts.Told.Notes.insert(facts.Told.Notes.end(), gaps.empty() ? 0 : 1, gaps);
  if (areElsewhere)
  {
    CollectPlanes(GetFolder(path), text, volume, stack);
    facts.Told.Notes.push_back("slices are in " + std::to_string(stack.Files.size()) +
      (stack.Files.size() == 1 ? " file" : " files") + ", as the OME-XML says");
  }
  if (others > 0 && stack.Pages.size() == 1)
  {
    throw std::runtime_error("its pages have several sizes or types, and the first page has its "
                             "own. Take that page away, or write all slices alike.");
  }
  if (others > 0)
  {
    facts.Told.Notes.push_back(
      std::to_string(others) + " TIFF pages of another size or type are left out");
  }
  if (!isFolder && !areElsewhere)
  {
    KeepVolume(text, volume, stack, facts.Told);
  }
  facts.Slices = stack.Pages.size();
  return facts;
}

void PackFacts(const TiffFacts& facts, BytePacker& packer)
{
  PackStack(facts.Stack, packer);
  packer.Put(facts.Headless);
  packer.Put(facts.Slices);
  packer.Put(facts.Spacing);
  packer.Put(facts.Line);
  packer.Put(facts.IsCurved);
  PackTexts(facts.Told.Notes, packer);
  PackTexts(facts.Told.Volumes, packer);
  packer.Put(facts.Told.Volume);
}

TiffFacts UnpackFacts(ByteUnpacker& unpacker, const std::string& path)
{
  TiffFacts facts;
  facts.Stack = UnpackStack(unpacker);
  facts.Headless = unpacker.Get<TiffSamples>();
  facts.Slices = unpacker.Get<std::size_t>();
  facts.Spacing = unpacker.Get<std::array<double, 3>>();
  facts.Line = unpacker.Get<std::array<double, 2>>();
  facts.IsCurved = unpacker.Get<bool>();
  facts.Told.Notes = UnpackTexts(unpacker);
  facts.Told.Volumes = UnpackTexts(unpacker);
  facts.Told.Volume = unpacker.Get<int>();
  const TiffSamples& where = facts.Headless;
  const double pages = static_cast<double>(where.First) +
    static_cast<double>(where.Step) * static_cast<double>(facts.Slices);
  if (where.AreUsed != 0 ? static_cast<double>(where.Offset) +
          (pages - static_cast<double>(where.Step) + 1.0) * CountPageBytes(facts.Stack.Layout) >
        static_cast<double>(OpenedFile(path).GetSize())
                         : facts.Slices != facts.Stack.Pages.size())
  {
    ThrowDamaged();
  }
  return facts;
}

TiffFacts AskForFacts(const std::string& path, int number)
{
  BytePacker packer;
  packer.Put(number);
  std::string answer;
  // Pass all files of the folder, because OME-XML may name any of them.
  const std::size_t files = ListFiles(GetFolder(path)).size();
  const ReadResult result = AskReader(
    ReadTask::Tiff, path, answer, packer.Bytes, static_cast<std::uint64_t>(OpeningBytes) * files);
  if (result == ReadResult::NoProcess)
  {
    TiffFacts facts = ReadFacts(path, number);
    facts.Told.Notes.insert(facts.Told.Notes.end(), answer.empty() ? 0 : 1, answer);
    return facts;
  }
  ByteUnpacker unpacker(answer);
  CheckAnswer(result, answer, unpacker);
  return UnpackFacts(unpacker, path);
}

/** Returns the packed result of a function, or, if it throws, the packed reason. */
template <typename Function>
std::string PackAnswer(const Function& pack)
{
  BytePacker packer;
  try
  {
    packer.PutText({});
    pack(packer);
  }
  catch (const std::runtime_error& fault)
  {
    packer.Bytes.clear();
    packer.PutText(fault.what());
  }
  return std::move(packer.Bytes);
}

} // namespace

bool IsTiffName(const std::string& name)
{
  if (vtksys::SystemTools::FileIsDirectory(name))
  {
    return !vtksys::SystemTools::PathExists(name + "/.zarray") &&
      !vtksys::SystemTools::PathExists(name + "/.zgroup") &&
      !vtksys::SystemTools::PathExists(name + "/zarr.json") && !ListFiles(name).empty();
  }
  const std::string ending =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(name));
  return ending == ".tif" || ending == ".tiff";
}

bool IsTiffFolder(const std::string& folder)
{
  vtksys::Directory all;
  constexpr std::size_t links = 2; // entries of every folder: itself and its parent
  return vtksys::SystemTools::FileIsDirectory(folder) && IsTiffName(folder) && all.Load(folder) &&
    2 * ListFiles(folder).size() > all.GetNumberOfFiles() - links;
}

std::string PackTiff(const std::string& name, const std::string& detail)
{
  return PackAnswer(
    [&](BytePacker& packer)
    {
      ByteUnpacker unpacker(detail);
      PackFacts(ReadFacts(name, unpacker.Get<int>()), packer);
    });
}

std::string PackTiffBox(const std::string& detail)
{
  return PackAnswer(
    [&](BytePacker& packer)
    {
      ByteUnpacker unpacker(detail);
      const TiffStack stack = UnpackStack(unpacker);
      const auto box = unpacker.Get<std::array<int, 6>>();
      const std::size_t begin = packer.Bytes.size();
      packer.Bytes.resize(begin + stack.CountSliceBytes(box.data()) * stack.Pages.size());
      stack.ReadHere(box.data(), &packer.Bytes[begin]);
    });
}

LargeFile OpenTiff(const std::string& name, bool, int number)
{
  const std::string path = MakeAbsolute(name);
  TiffFacts facts = AskForFacts(path, number);
  LargeFile file = MakeFile(facts.Stack.Layout, facts.Slices);
  file.Spacing = facts.Spacing;
  file.Notes = std::move(facts.Told.Notes);
  file.Volumes = std::move(facts.Told.Volumes);
  file.Volume = facts.Told.Volume;
  if (facts.Headless.AreUsed != 0)
  {
    file.Read = ReadHeadless(path, facts, file.Extent);
  }
  else
  {
    const auto stack = std::make_shared<const TiffStack>(facts.Stack);
    file.Read = [stack](const int box[6], void* samples) { return stack->Read(box, samples); };
  }
  Calibrate(facts, file);
  return file;
}

} // namespace VolumeHaptics
