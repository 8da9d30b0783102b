// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Base/XmlStructure.h"

#include "Core/Platform/Files.h"
#include "Core/Platform/HapticFiles.h"

#include "vtkCallbackCommand.h"
#include "vtkLZ4DataCompressor.h"
#include "vtkLZMADataCompressor.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkZLibDataCompressor.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace VolumeHaptics
{
namespace
{

using Text = std::string_view;
constexpr Text Blanks = " \t\r\n";
constexpr std::size_t HeadWords = 3; // number of blocks, size of a block, size of the last block;
                                     // the size of each compressed block follows
constexpr double LargestCompression = 10000.0; // LZMA compresses zeros by a factor of 7000, deflate
                                               // by 1032

[[noreturn]] void Refuse(const std::string& fault)
{
  throw std::runtime_error(fault);
}

Text Trim(Text text)
{
  text.remove_prefix(std::min(text.find_first_not_of(Blanks), text.size()));
  return text.substr(0, text.find_last_not_of(Blanks) + 1);
}

std::int64_t ParseWhole(Text text, const char* what)
{
  text = Trim(text);
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
  {
    Refuse(std::string("its ") + what + " is no whole number");
  }
  return number;
}

/** An XML element, with the text that follows its tag. */
struct Element
{
  Text Name;
  std::map<Text, Text> Attributes;
  std::size_t Begin = 0; ///< position at which the text begins

  Text Get(const char* name) const
  {
    const auto found = this->Attributes.find(name);
    return found == this->Attributes.end() ? Text() : found->second;
  }
  bool Has(const char* name) const { return this->Attributes.count(name) > 0; }
  /** Returns an attribute as a count; 0 if it is missing. */
  double Count(const char* name) const
  {
    const std::int64_t count = this->Has(name) ? ParseWhole(this->Get(name), name) : 0;
    if (count < 0)
    {
      Refuse(std::string("its ") + name + " is below zero");
    }
    return static_cast<double>(count);
  }
};

struct ArrayType
{
  const char* Name;
  int Bits; ///< bits per value; 0 for strings
};
constexpr ArrayType ArrayTypes[] = { { "Bit", 1 }, { "Int8", 8 }, { "UInt8", 8 }, { "Int16", 16 },
  { "UInt16", 16 }, { "Int32", 32 }, { "UInt32", 32 }, { "Int64", 64 }, { "UInt64", 64 },
  { "Float32", 32 }, { "Float64", 64 }, { "String", 0 } };

/** The stored bytes of an array, raw or in base64. */
class Stored
{
public:
  Stored(Text text, bool isBase64)
    : Data(text)
    , IsBase64(isBase64)
  {
  }

  /** Returns the largest possible number of bytes after decoding. */
  double GetSize() const
  {
    return static_cast<double>(this->Data.size()) * (this->IsBase64 ? 0.75 : 1.0);
  }
  /** Returns the data behind a header of `bytes` bytes, which is encoded separately in base64. */
  Stored Behind(std::size_t bytes) const
  {
    const std::size_t letters = this->IsBase64 ? (bytes + 2) / 3 * 4 : bytes;
    return { this->Data.substr(std::min(letters, this->Data.size())), this->IsBase64 };
  }
  /** Decodes and returns the first `count` bytes. */
  std::vector<unsigned char> Read(std::size_t count) const
  {
    if (static_cast<double>(count) > this->GetSize())
    {
      Refuse("one of its arrays ends before its first value");
    }
    std::vector<unsigned char> bytes;
    if (!this->IsBase64)
    {
      bytes.assign(this->Data.begin(), this->Data.begin() + static_cast<std::ptrdiff_t>(count));
      return bytes;
    }
    constexpr Text letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t at = 0; bytes.size() < count; at += 4)
    {
      std::uint32_t group = 0;
      std::size_t letter = 0;
      for (; letter < 4 && at + letter < this->Data.size(); ++letter)
      {
        const std::size_t value = letters.find(this->Data[at + letter]);
        if (value == Text::npos)
        {
          break;
        }
        group |= static_cast<std::uint32_t>(value) << (18 - 6 * letter);
      }
      for (std::size_t i = 0; i + 1 < letter && bytes.size() < count; ++i)
      {
        bytes.push_back(static_cast<unsigned char>(group >> (16 - 8 * i)));
      }
      if (letter < 4 && bytes.size() < count)
      {
        Refuse("one of its arrays is not in base64, as it should be");
      }
    }
    return bytes;
  }

private:
  Text Data;
  bool IsBase64;
};

/** Walks over all elements of a file and checks each. */
class Walk
{
public:
  explicit Walk(Text text)
    : All(text)
  {
  }

  void Check()
  {
    this->FindAppended();
    std::vector<Element> open;
    for (std::size_t at = this->Next(0); at != Text::npos; at = this->Next(at))
    {
      const bool isEnd = this->Elements[at + 1] == '/';
      const std::size_t close = this->FindClose(at);
      Element element = this->Parse(at + (isEnd ? 2 : 1), close);
      const bool isAlone = this->Elements[close - 1] == '/';
      if (isEnd)
      {
        if (open.empty() || open.back().Name != element.Name)
        {
          Refuse("its elements are not closed in their order");
        }
        this->Leave(open.back(), open);
        open.pop_back();
      }
      else
      {
        element.Begin = close + 1;
        constexpr std::size_t deepest = 64;
        if (open.size() >= deepest)
        {
          Refuse("its elements are nested too deeply");
        }
        this->Enter(element, open);
        if (!isAlone)
        {
          open.push_back(element);
        }
      }
      at = close + 1;
    }
    // The parsed text ends where appended data begin. There, the root element is still open.
    if (open.size() != (this->Appended.data() ? 1 : 0) || !this->HasRoot)
    {
      Refuse("the file ends before its last element");
    }
  }

private:
  /** Finds the appended data, whose bytes may look like XML elements. */
  void FindAppended()
  {
    const std::size_t begin = this->All.find("<AppendedData");
    const std::size_t mark = begin == Text::npos ? begin : this->All.find('_', begin);
    const std::size_t end = this->All.rfind("</AppendedData>");
    this->Elements = this->All.substr(0, begin);
    if (begin == Text::npos)
    {
      return;
    }
    if (mark == Text::npos || end == Text::npos || end < mark)
    {
      Refuse("its appended data have no end");
    }
    const Element element = this->ParseIn(this->All, begin + 1, this->All.find('>', begin));
    const Text encoding = element.Get("encoding");
    if (encoding != "raw" && encoding != "base64")
    {
      Refuse("its appended data have an unknown encoding");
    }
    this->IsBase64 = encoding == "base64";
    this->Appended = this->All.substr(mark + 1, end - mark - 1);
    const Text rest = Trim(this->All.substr(end));
    constexpr Text last = "</AppendedData>";
    if (Trim(rest.substr(last.size())) != "</VTKFile>")
    {
      Refuse("the file ends before its last element");
    }
  }

  /** Returns the position of the next element; npos if there is none. */
  std::size_t Next(std::size_t at) const
  {
    while ((at = this->Elements.find('<', at)) != Text::npos)
    {
      const Text rest = this->Elements.substr(at);
      const char* const end = rest.compare(0, 4, "<!--") == 0 ? "-->"
        : rest.compare(0, 2, "<?") == 0                       ? "?>"
                                                              : nullptr;
      if (!end)
      {
        // VTK never writes declarations of types or entities, or CDATA sections.
        rest.compare(0, 2, "<!") == 0 || rest.size() < 2 ? Refuse("it is no XML file of VTK")
                                                         : void();
        return at;
      }
      const std::size_t close = this->Elements.find(end, at);
      at = close == Text::npos ? this->Elements.size() : close;
    }
    return at;
  }

  /** Returns the position of the `>` that ends a tag, ignoring `>` inside quotes. */
  std::size_t FindClose(std::size_t at) const
  {
    char quote = 0;
    for (; at < this->Elements.size(); ++at)
    {
      const char c = this->Elements[at];
      if (c == quote)
      {
        quote = 0;
      }
      else if (quote == 0 && (c == '"' || c == '\''))
      {
        quote = c;
      }
      else if (quote == 0 && c == '>')
      {
        return at;
      }
    }
    Refuse("the file ends before its last element");
  }

  Element Parse(std::size_t at, std::size_t close) const
  {
    return this->ParseIn(this->Elements, at, close);
  }

  static Element ParseIn(Text all, std::size_t at, std::size_t close)
  {
    Element element;
    Text tag = close == Text::npos ? Text() : all.substr(at, close - at);
    const std::size_t end = std::min(tag.find_first_of(" \t\r\n/"), tag.size());
    element.Name = tag.substr(0, end);
    tag.remove_prefix(end);
    while (!(tag = Trim(tag)).empty() && tag != "/")
    {
      const std::size_t equals = tag.find('=');
      const std::size_t open = equals == Text::npos ? equals : tag.find_first_of("\"'", equals);
      const std::size_t shut = open == Text::npos ? open : tag.find(tag[open], open + 1);
      if (shut == Text::npos || !Trim(tag.substr(equals + 1, open - equals - 1)).empty() ||
        !element.Attributes
           .emplace(Trim(tag.substr(0, equals)), tag.substr(open + 1, shut - open - 1))
           .second)
      {
        Refuse("it is no XML file of VTK");
      }
      tag.remove_prefix(shut + 1);
    }
    return element;
  }

  void Enter(const Element& element, const std::vector<Element>& open)
  {
    if (open.empty())
    {
      this->EnterRoot(element);
      return;
    }
    if (open.size() == 1 && element.Name != this->Kind && element.Name != "FieldData")
    {
      Refuse("it has another type than its elements");
    }
    if (element.Name == "Piece")
    {
      this->EnterPiece(element);
    }
    if (element.Name == "DataArray" || element.Name == "Array")
    {
      this->EnterArray(element, open);
    }
  }

  void EnterRoot(const Element& element)
  {
    const Text head = element.Get("header_type");
    if (this->HasRoot || element.Name != "VTKFile" ||
      !(head.empty() || head == "UInt32" || head == "UInt64"))
    {
      Refuse("it is no XML file of VTK");
    }
    this->HasRoot = true;
    this->WordSize = head == "UInt64" ? 8 : 4;
    this->IsBig = element.Get("byte_order") == "BigEndian";
    this->Compressor = element.Get("compressor");
    this->IsCompressed = !this->Compressor.empty();
    this->Kind = element.Get("type");
  }

  [[noreturn]] void RefusePromise() const
  {
    Refuse(std::string("its header announces more ") +
      (this->IsStructured() ? "voxels" : "values") + " than the file has");
  }

  bool IsStructured() const
  {
    return this->Kind == "ImageData" || this->Kind == "StructuredGrid" ||
      this->Kind == "RectilinearGrid";
  }

  /** Returns the number of points of an extent along each axis. */
  static std::array<double, 3> ParseExtent(Text text)
  {
    std::array<double, 3> sizes{};
    std::array<std::int64_t, 6> extent{};
    text = Trim(text);
    for (std::size_t i = 0; i < extent.size(); ++i)
    {
      const std::size_t end = std::min(text.find_first_of(Blanks), text.size());
      extent[i] = ParseWhole(text.substr(0, end), "extent");
      text = Trim(text.substr(end));
      const bool isInt = extent[i] >= INT32_MIN / 2 && extent[i] <= INT32_MAX / 2;
      if (!isInt || (i % 2 == 1 && extent[i] < extent[i - 1] - 1))
      {
        Refuse("its extent can't be true");
      }
      sizes[i / 2] = static_cast<double>(extent[i] - extent[i - i % 2] + 1);
    }
    return sizes;
  }

  void EnterPiece(const Element& piece)
  {
    this->Seen.clear();
    this->Points = this->Cells = std::nullopt;
    if (this->IsStructured())
    {
      const std::array<double, 3> sizes = ParseExtent(piece.Get("Extent"));
      this->Points = sizes[0] * sizes[1] * sizes[2];
      this->Cells = 1.0;
      for (const double size : sizes)
      {
        *this->Cells *= size == 0.0 ? 0.0 : std::max(size - 1.0, 1.0);
      }
      this->PieceVolume += *this->Points;
    }
    else if (this->Kind == "PolyData" || this->Kind == "UnstructuredGrid")
    {
      this->Points = piece.Count("NumberOfPoints");
      this->Cells = piece.Count("NumberOfCells") + piece.Count("NumberOfVerts") +
        piece.Count("NumberOfLines") + piece.Count("NumberOfStrips") + piece.Count("NumberOfPolys");
    }
    else if (this->Kind == "Table")
    {
      this->Points = piece.Count("NumberOfRows");
    }
  }

  /** Checks at the end of an element that all its required parts were present. */
  void Leave(const Element& element, const std::vector<Element>& open)
  {
    if (element.Name == "Piece" && (this->Kind == "PolyData" || this->Kind == "UnstructuredGrid"))
    {
      for (const char* const part : { "Points", "Verts", "Lines", "Strips", "Polys", "Cells" })
      {
        if (element.Count(("NumberOf" + std::string(part)).c_str()) > 0.0 &&
          this->Seen.count(part) == 0)
        {
          Refuse("it has no arrays for its " + std::string(part));
        }
      }
    }
    if (open.size() == 2 && this->IsStructured())
    {
      const std::array<double, 3> sizes = ParseExtent(element.Get("WholeExtent"));
      if (sizes[0] * sizes[1] * sizes[2] > this->PieceVolume)
      {
        Refuse("its extent is larger than its pieces");
      }
    }
  }

  /** Returns the number of tuples that an array must have; nothing if it can't be known. */
  std::optional<double> FindTuples(const Element& array, const Element& part, const Element& piece)
  {
    const Text name = part.Name;
    if (array.Has("NumberOfTuples") && (name == "FieldData" || name == "RowData"))
    {
      return array.Count("NumberOfTuples");
    }
    if (name == "PointData" || name == "Points" || name == "RowData")
    {
      return this->Points;
    }
    if (name == "CellData")
    {
      return this->Cells;
    }
    const Text which = array.Get("Name");
    if (this->Kind == "PolyData" && which == "offsets")
    {
      return piece.Count(("NumberOf" + std::string(name)).c_str());
    }
    return name == "Cells" && (which == "offsets" || which == "types") ? this->Cells : std::nullopt;
  }

  void EnterArray(const Element& array, const std::vector<Element>& open)
  {
    const Text part = open.back().Name;
    const auto* const type = std::find_if(std::begin(ArrayTypes), std::end(ArrayTypes),
      [&array](const ArrayType& known) { return array.Get("type") == known.Name; });
    if (type == std::end(ArrayTypes))
    {
      Refuse("one of its arrays has an unknown type");
    }
    const double components =
      array.Has("NumberOfComponents") ? array.Count("NumberOfComponents") : 1.0;
    const bool isOfCells = part == "Verts" || part == "Lines" || part == "Strips" ||
      part == "Polys" || part == "Cells" || part == "Coordinates";
    constexpr double mostComponents = 65536.0;
    if (components < 1.0 || components > mostComponents ||
      ((isOfCells || part == "Points") && type->Bits == 0) || (isOfCells && components != 1.0) ||
      (part == "Points" && components != 3.0))
    {
      Refuse("one of its arrays has other components than it can have");
    }
    const auto known =
      this->Kinds.emplace(std::make_pair(std::string(part), std::string(array.Get("Name"))), type);
    if (known.first->second != type)
    {
      Refuse("one of its arrays changes its type");
    }
    this->Seen[part] += 1;
    const std::optional<double> tuples =
      this->FindTuples(array, open.back(), open.size() > 1 ? open[open.size() - 2] : open.back());
    const std::optional<double> values =
      tuples ? std::optional<double>(*tuples * components) : std::nullopt;
    const Text format = array.Get("format");
    if (format == "appended")
    {
      const std::int64_t offset = ParseWhole(array.Get("offset"), "offset");
      if (offset < 0 || static_cast<std::size_t>(offset) > this->Appended.size())
      {
        Refuse("one of its arrays begins behind the end of the file");
      }
      this->CheckStored(
        Stored(this->Appended.substr(static_cast<std::size_t>(offset)), this->IsBase64), *type,
        values);
      return;
    }
    const Text text =
      Trim(this->Elements.substr(array.Begin, this->Elements.find('<', array.Begin) - array.Begin));
    if (format == "binary")
    {
      this->CheckStored(Stored(text, true), *type, values);
    }
    else if (format != "ascii" && !format.empty())
    {
      Refuse("one of its arrays has an unknown format");
    }
    else if (type->Bits == 0)
    {
      CheckTexts(ParseLetters(text), values);
    }
    else if (values && *values > 0.5 * (static_cast<double>(text.size()) + 1.0))
    {
      this->RefusePromise();
    }
  }

  std::uint64_t ReadWord(const std::vector<unsigned char>& bytes, std::size_t number) const
  {
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < this->WordSize; ++i)
    {
      const std::size_t at = this->IsBig ? this->WordSize - 1 - i : i;
      word |= std::uint64_t{ bytes[number * this->WordSize + at] } << (8 * i);
    }
    return word;
  }

  /**
   * Checks the bytes of an array against their header, and the header against the number of values.
   */
  void CheckStored(
    const Stored& stored, const ArrayType& type, const std::optional<double>& values) const
  {
    const double room = stored.GetSize();
    double bytes = 0.0;
    if (!this->IsCompressed)
    {
      bytes = static_cast<double>(this->ReadWord(stored.Read(this->WordSize), 0));
      if (bytes > room)
      {
        this->RefusePromise();
      }
    }
    else
    {
      bytes = this->CountUnpacked(stored, room);
    }
    if (type.Bits == 0)
    {
      CheckTexts(this->ReadAll(stored, static_cast<std::size_t>(bytes)), values);
    }
    else if (values && bytes != std::ceil(*values * type.Bits / 8.0))
    {
      Refuse("one of its arrays has another number of values than it should have");
    }
  }

  /** Parses the characters of strings, stored as decimal codes. */
  static std::vector<unsigned char> ParseLetters(Text text)
  {
    std::vector<unsigned char> letters;
    while (!(text = Trim(text)).empty())
    {
      const std::size_t end = std::min(text.find_first_of(Blanks), text.size());
      letters.push_back(static_cast<unsigned char>(ParseWhole(text.substr(0, end), "text")));
      text.remove_prefix(end);
    }
    return letters;
  }

  /**
   * Checks the number of strings: VTK's reader stores each zero-terminated string in the next place
   * of the array.
   */
  static void CheckTexts(
    const std::vector<unsigned char>& letters, const std::optional<double>& values)
  {
    const auto count = static_cast<double>(std::count(letters.begin(), letters.end(), 0));
    if (!values || count != *values)
    {
      Refuse("one of its arrays has another number of texts than it should have");
    }
  }

  /** Reads all bytes of an array. Its header must have been checked before. */
  std::vector<unsigned char> ReadAll(const Stored& stored, std::size_t bytes) const
  {
    std::vector<unsigned char> all;
    if (!this->IsCompressed)
    {
      all = stored.Read(this->WordSize + bytes);
      all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(this->WordSize));
      return all;
    }
    if (bytes == 0)
    {
      return all;
    }
    const auto blocks = static_cast<std::size_t>(this->ReadWord(stored.Read(this->WordSize), 0));
    const std::size_t headSize = (HeadWords + blocks) * this->WordSize;
    const std::vector<unsigned char> head = stored.Read(headSize);
    std::size_t size = 0;
    for (std::size_t i = 0; i < blocks; ++i)
    {
      size += static_cast<std::size_t>(this->ReadWord(head, HeadWords + i));
    }
    const std::vector<unsigned char> packed = stored.Behind(headSize).Read(size);
    const vtkSmartPointer<vtkDataCompressor> compressor = this->MakeCompressor();
    compressor->AddObserver(vtkCommand::ErrorEvent, vtkNew<vtkCallbackCommand>()); // silent
    all.resize(bytes);
    std::size_t from = 0;
    std::size_t to = 0;
    for (std::size_t i = 0; i < blocks; ++i)
    {
      const auto part = static_cast<std::size_t>(this->ReadWord(head, HeadWords + i));
      const std::size_t plain =
        std::min(bytes - to, static_cast<std::size_t>(this->ReadWord(head, 1)));
      if (compressor->Uncompress(packed.data() + from, part, all.data() + to, plain) != plain)
      {
        Refuse("one of its arrays is damaged");
      }
      from += part;
      to += plain;
    }
    return all;
  }

  vtkSmartPointer<vtkDataCompressor> MakeCompressor() const
  {
    if (this->Compressor == "vtkZLibDataCompressor")
    {
      return vtkSmartPointer<vtkZLibDataCompressor>::New();
    }
    if (this->Compressor == "vtkLZ4DataCompressor")
    {
      return vtkSmartPointer<vtkLZ4DataCompressor>::New();
    }
    if (this->Compressor != "vtkLZMADataCompressor")
    {
      Refuse("its compressor is unknown");
    }
    return vtkSmartPointer<vtkLZMADataCompressor>::New();
  }

  double CountUnpacked(const Stored& stored, double room) const
  {
    const std::uint64_t blocks = this->ReadWord(stored.Read(this->WordSize), 0);
    if (blocks == 0)
    {
      return 0.0;
    }
    if (static_cast<double>(blocks) * static_cast<double>(this->WordSize) > room)
    {
      Refuse("one of its arrays has more blocks than its bytes can be");
    }
    const std::vector<unsigned char> head =
      stored.Read((HeadWords + static_cast<std::size_t>(blocks)) * this->WordSize);
    const auto size = static_cast<double>(this->ReadWord(head, 1));
    const auto last = static_cast<double>(this->ReadWord(head, 2));
    double packed = 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < blocks; ++i)
    {
      const auto one = static_cast<double>(this->ReadWord(head, HeadWords + i));
      packed += one;
      largest = std::max(largest, one);
    }
    const double full = static_cast<double>(blocks) - (last > 0.0 ? 1.0 : 0.0);
    const double bytes = full * size + last;
    if (packed > room || last > size || bytes > LargestCompression * packed ||
      (full > 0.0 && size > LargestCompression * largest))
    {
      Refuse("one of its arrays has compressed blocks whose sizes can't be true");
    }
    return bytes;
  }

  const Text All;
  Text Elements; ///< the file without its appended data
  Text Appended;
  bool IsBase64 = false;
  bool HasRoot = false;
  std::size_t WordSize = 4;
  bool IsBig = false;
  bool IsCompressed = false;
  Text Compressor;
  Text Kind;
  double PieceVolume = 0.0;
  std::optional<double> Points, Cells; ///< number in the current piece
  std::map<Text, int> Seen;            ///< array sections found in the current piece
  std::map<std::pair<std::string, std::string>, const ArrayType*> Kinds;
};

} // namespace

std::string DetectFalseXml(const std::string& file)
{
  Files::Status status;
  if (!Files::GetStatus(file, status))
  {
    return {}; // VTK's reader reports this error
  }
  std::string text, error;
  if (!ReadSmallFile(file, static_cast<std::size_t>(status.st_size), text, error))
  {
    return "it " + error;
  }
  try
  {
    Walk(text).Check();
  }
  catch (const std::runtime_error& fault)
  {
    return fault.what();
  }
  return {};
}

} // namespace VolumeHaptics
