// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/Hdf5File.h"

#include "VTK/Regions/Formats/OpenedFile.h"

#include "vtk_hdf5.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <stdexcept>

namespace VolumeHaptics
{
namespace
{

/**
 * Largest total number of bytes that HDF5's library may read: a damaged index could make it read
 * the same bytes for ever.
 */
constexpr std::uint64_t MostIndexBytes = std::uint64_t{ 1 } << 30;
constexpr double MostChunks = 1 << 24;
constexpr std::size_t LongestText = 65536;

/** Owns a reference to an HDF5 object. The constructor throws if the object does not exist. */
class Hdf5Id
{
public:
  explicit Hdf5Id(hid_t id)
    : Id(id)
  {
    if (id < 0)
    {
      Hdf5File::ThrowDamaged();
    }
  }
  ~Hdf5Id() { H5Idec_ref(this->Id); }
  Hdf5Id(const Hdf5Id&) = delete;
  Hdf5Id& operator=(const Hdf5Id&) = delete;
  operator hid_t() const { return this->Id; }

private:
  const hid_t Id;
};

/** Suppresses the error messages of HDF5's library during its lifetime. */
class QuietHdf5
{
public:
  QuietHdf5()
  {
    H5Eget_auto2(H5E_DEFAULT, &this->Print, &this->Data);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~QuietHdf5() { H5Eset_auto2(H5E_DEFAULT, this->Print, this->Data); }
  QuietHdf5(const QuietHdf5&) = delete;
  QuietHdf5& operator=(const QuietHdf5&) = delete;

private:
  H5E_auto2_t Print = nullptr;
  void* Data = nullptr;
};

/** The file's contents, as the file driver below serves them to HDF5's library. */
struct Hdf5Bytes
{
  explicit Hdf5Bytes(const std::string& name)
    : Name(name)
    , File(name)
    , Size(static_cast<std::uint64_t>(this->File.GetSize()))
  {
  }

  const std::string Name;
  const OpenedFile File;
  const std::uint64_t Size;
  std::uint64_t BytesInAll = 0; ///< total number of bytes read so far
  /**
   * If set, the driver reads no samples; it stores here the position that the library would read
   * from.
   */
  Hdf5Chunk* Located = nullptr;
};

/** An open file, in the form that HDF5's library requires of a file driver. */
struct DriverFile
{
  H5FD_t Public; // must be the first member, because the library casts to it
  Hdf5Bytes* Bytes;
  haddr_t End;
};

DriverFile& ToDriverFile(H5FD_t* file)
{
  return *reinterpret_cast<DriverFile*>(file);
}

H5FD_t* OpenByDriver(const char* name, unsigned, hid_t access, haddr_t)
{
  auto* const* const bytes = static_cast<Hdf5Bytes* const*>(H5Pget_driver_info(access));
  // Refuse any other name: it belongs to a link to another file.
  auto* const file = bytes && (*bytes)->Name == name ? new (std::nothrow) DriverFile{} : nullptr;
  if (!file)
  {
    return nullptr;
  }
  file->Bytes = *bytes;
  return &file->Public;
}

herr_t CloseByDriver(H5FD_t* file)
{
  delete &ToDriverFile(file);
  return 0;
}

haddr_t GetEnd(const H5FD_t* file, H5FD_mem_t)
{
  return reinterpret_cast<const DriverFile*>(file)->End;
}

herr_t SetEnd(H5FD_t* file, H5FD_mem_t, haddr_t end)
{
  ToDriverFile(file).End = end;
  return 0;
}

haddr_t GetFileSize(const H5FD_t* file, H5FD_mem_t)
{
  return reinterpret_cast<const DriverFile*>(file)->Bytes->Size;
}

herr_t ReadByDriver(H5FD_t* file, H5FD_mem_t type, hid_t, haddr_t from, std::size_t size, void* to)
{
  Hdf5Bytes& bytes = *ToDriverFile(file).Bytes;
  if (bytes.Located && type == H5FD_MEM_DRAW)
  {
    bytes.Located->Address = from;
    bytes.Located->Size = size;
    return 0;
  }
  constexpr std::uint64_t perCall = 64;
  bytes.BytesInAll += perCall;
  if (size > MostIndexBytes - std::min(MostIndexBytes, bytes.BytesInAll))
  {
    return -1;
  }
  bytes.BytesInAll += size;
  // Bytes beyond the end of the file are zeros.
  const std::size_t there = from < bytes.Size
    ? static_cast<std::size_t>(std::min<std::uint64_t>(size, bytes.Size - from))
    : 0;
  std::memset(static_cast<char*>(to) + there, 0, size - there);
  try
  {
    bytes.File.Read(to, there, static_cast<std::int64_t>(from));
  }
  catch (const std::exception&)
  {
    return -1;
  }
  return 0;
}

herr_t RefuseToWrite(H5FD_t*, H5FD_mem_t, hid_t, haddr_t, std::size_t, const void*)
{
  return -1;
}

/**
 * Declares support of files that a writer shares with readers, because HDF5's library opens such
 * files only with a driver that supports them.
 */
herr_t DescribeDriver(const H5FD_t*, unsigned long* features)
{
  *features = H5FD_FEAT_SUPPORTS_SWMR_IO;
  return 0;
}

const H5FD_class_t& GetDriver()
{
  static const H5FD_class_t driver = []
  {
    H5FD_class_t made{};
#if H5_VERSION_GE(1, 13, 2)
    made.version = H5FD_CLASS_VERSION;
    made.value = H5_VFD_RESERVED + 91; // a number that HDF5's own drivers do not use
#endif
    made.name = "volumehaptics";
    made.maxaddr = (std::uint64_t{ 1 } << 63) - 1;
    made.fc_degree = H5F_CLOSE_STRONG;
    made.fapl_size = sizeof(Hdf5Bytes*);
    made.open = OpenByDriver;
    made.close = CloseByDriver;
    made.query = DescribeDriver;
    made.get_eoa = GetEnd;
    made.set_eoa = SetEnd;
    made.get_eof = GetFileSize;
    made.read = ReadByDriver;
    made.write = RefuseToWrite;
    return made;
  }();
  return driver;
}

/** An existing attribute, with its type and its number of values. */
struct Hdf5Attribute
{
  Hdf5Attribute(hid_t owner, const std::string& name)
    : Id(H5Aopen(owner, name.c_str(), H5P_DEFAULT))
    , Type(H5Aget_type(this->Id))
    , Space(H5Aget_space(this->Id))
    , Values(H5Sget_simple_extent_npoints(this->Space))
  {
  }

  const Hdf5Id Id;
  const Hdf5Id Type;
  const Hdf5Id Space;
  const hssize_t Values;
};

/** A number type of HDF5, and the corresponding VTK type. */
struct KnownType
{
  hid_t Id;
  int ScalarType;
  bool IsBig;
};

/** Returns the VTK type that corresponds to an HDF5 type. ScalarType is 0 if there is none. */
KnownType FindKnownType(hid_t type)
{
  const KnownType all[] = { { H5T_STD_I8LE, VTK_SIGNED_CHAR, false },
    { H5T_STD_I8BE, VTK_SIGNED_CHAR, true }, { H5T_STD_U8LE, VTK_UNSIGNED_CHAR, false },
    { H5T_STD_U8BE, VTK_UNSIGNED_CHAR, true }, { H5T_STD_I16LE, VTK_SHORT, false },
    { H5T_STD_I16BE, VTK_SHORT, true }, { H5T_STD_U16LE, VTK_UNSIGNED_SHORT, false },
    { H5T_STD_U16BE, VTK_UNSIGNED_SHORT, true }, { H5T_STD_I32LE, VTK_INT, false },
    { H5T_STD_I32BE, VTK_INT, true }, { H5T_STD_U32LE, VTK_UNSIGNED_INT, false },
    { H5T_STD_U32BE, VTK_UNSIGNED_INT, true }, { H5T_STD_I64LE, VTK_LONG_LONG, false },
    { H5T_STD_I64BE, VTK_LONG_LONG, true }, { H5T_STD_U64LE, VTK_UNSIGNED_LONG_LONG, false },
    { H5T_STD_U64BE, VTK_UNSIGNED_LONG_LONG, true }, { H5T_IEEE_F32LE, VTK_FLOAT, false },
    { H5T_IEEE_F32BE, VTK_FLOAT, true }, { H5T_IEEE_F64LE, VTK_DOUBLE, false },
    { H5T_IEEE_F64BE, VTK_DOUBLE, true } };
  const auto* const found = std::find_if(std::begin(all), std::end(all),
    [type](const KnownType& known) { return H5Tequal(type, known.Id) > 0; });
  return found == std::end(all) ? KnownType{ type, 0, false } : *found;
}

/** Returns whether an HDF5 superblock is at a position. Throws if the bytes can't be read. */
bool IsSuperblock(const Hdf5Bytes& bytes, std::uint64_t at, bool& isWritten)
{
  constexpr std::size_t size = 12;
  constexpr char signature[] = "\x89HDF\r\n\x1a\n";
  constexpr std::size_t versionAt = 8;
  constexpr std::size_t flagsAt = 11;
  char head[size] = {};
  if (bytes.Size - at < size)
  {
    return false;
  }
  bytes.File.Read(head, size, static_cast<std::int64_t>(at));
  if (!std::equal(head, head + versionAt, signature))
  {
    return false;
  }
  constexpr char latest = 3;
  if (head[versionAt] > latest || head[versionAt] < 0)
  {
    throw std::runtime_error("its HDF5 format is newer than what is read here. Convert it with "
                             "h5repack --high=2 IN OUT.");
  }
  constexpr int forWriting = 1;
  constexpr int forReadersToo = 4;
  const int flags = head[versionAt] == latest ? head[flagsAt] : 0;
  isWritten = (flags & forReadersToo) != 0;
  if ((flags & forWriting) != 0 && !isWritten)
  {
    throw std::runtime_error("it is open for writing, or was never closed. Close it there; if its "
                             "writer has ended, run h5clear -s FILE.");
  }
  return true;
}

/**
 * Returns whether a writer that allows concurrent readers has the file open. Throws if the file is
 * not HDF5.
 */
bool CheckBeginning(const Hdf5Bytes& bytes)
{
  // Other data may precede the superblock, which is at 0, 512, 1024, 2048 and so on.
  for (std::uint64_t at = 0; at < bytes.Size; at = at == 0 ? 512 : 2 * at)
  {
    bool isWritten = false;
    if (IsSuperblock(bytes, at, isWritten))
    {
      return isWritten;
    }
  }
  throw std::runtime_error("it is no HDF5 file. Check what it really is.");
}

} // namespace

struct Hdf5File::Opened
{
  explicit Opened(const std::string& name)
    : Bytes(name)
    , Driver((H5open(), H5FDregister(&GetDriver())))
    , Access(H5Pcreate(H5P_FILE_ACCESS))
    , File(this->OpenFile())
  {
  }
  hid_t OpenFile()
  {
    const bool isWritten = CheckBeginning(this->Bytes);
    Hdf5Bytes* const bytes = &this->Bytes;
    // If a writer shares the file, metadata may be half written, and the library reads them again.
    // Limit its 100 attempts: the pauses between them double, so a damaged file would take too
    // long.
    constexpr unsigned attempts = 10;
    if (H5Pset_driver(this->Access, this->Driver, &bytes) < 0 ||
      H5Pset_metadata_read_attempts(this->Access, attempts) < 0)
    {
      return -1;
    }
    return H5Fopen(this->Bytes.Name.c_str(),
      isWritten ? H5F_ACC_RDONLY | H5F_ACC_SWMR_READ : H5F_ACC_RDONLY, this->Access);
  }

  QuietHdf5 Quiet;
  Hdf5Bytes Bytes;
  Hdf5Id Driver;
  Hdf5Id Access;
  Hdf5Id File;
};

Hdf5File::Hdf5File(const std::string& name)
  : Open(std::make_unique<Opened>(name))
{
}

Hdf5File::~Hdf5File() = default;

void Hdf5File::ThrowDamaged()
{
  throw std::runtime_error("it is damaged: its HDF5 structure ends too early or makes no sense. "
                           "Copy or write it again.");
}

bool Hdf5File::Has(const std::string& path) const
{
  // Check each group of the path, because the library requires that all of them exist before it
  // searches for the last name.
  for (std::size_t end = path.find('/'); end != std::string::npos; end = path.find('/', end + 1))
  {
    if (H5Lexists(this->Open->File, path.substr(0, end).c_str(), H5P_DEFAULT) <= 0)
    {
      return false;
    }
  }
  return H5Lexists(this->Open->File, path.c_str(), H5P_DEFAULT) > 0;
}

bool Hdf5File::HasArray(const std::string& path) const
{
  const hid_t array = H5Dopen2(this->Open->File, path.c_str(), H5P_DEFAULT);
  return array >= 0 && H5Dclose(array) >= 0;
}

std::vector<std::string> Hdf5File::ListMembers(const std::string& group) const
{
  const Hdf5Id opened(H5Gopen2(this->Open->File, group.c_str(), H5P_DEFAULT));
  H5G_info_t info;
  if (H5Gget_info(opened, &info) < 0)
  {
    ThrowDamaged();
  }
  std::vector<std::string> names;
  for (hsize_t i = 0; i < info.nlinks; ++i)
  {
    const auto get = [&](char* to, std::size_t size) {
      return H5Lget_name_by_idx(opened, ".", H5_INDEX_NAME, H5_ITER_INC, i, to, size, H5P_DEFAULT);
    };
    const auto length = get(nullptr, 0);
    if (length <= 0 || static_cast<std::size_t>(length) > LongestText)
    {
      ThrowDamaged();
    }
    std::string name(static_cast<std::size_t>(length), '\0');
    get(&name[0], name.size() + 1);
    names.push_back(name);
  }
  return names;
}

std::string Hdf5File::ReadText(const std::string& group, const std::string& attribute) const
{
  const Hdf5Id opened(H5Gopen2(this->Open->File, group.c_str(), H5P_DEFAULT));
  if (H5Aexists(opened, attribute.c_str()) <= 0)
  {
    return {};
  }
  const Hdf5Attribute found(opened, attribute);
  const std::size_t size = H5Tget_size(found.Type);
  if (H5Tget_class(found.Type) != H5T_STRING || H5Tis_variable_str(found.Type) != 0 ||
    size > LongestText || found.Values != 1)
  {
    return {};
  }
  std::vector<char> text(size + 1, '\0');
  if (H5Aread(found.Id, found.Type, text.data()) < 0)
  {
    ThrowDamaged();
  }
  return text.data();
}

std::vector<double> Hdf5File::ReadNumbers(
  const std::string& group, const std::string& attribute) const
{
  const Hdf5Id opened(H5Gopen2(this->Open->File, group.c_str(), H5P_DEFAULT));
  if (H5Aexists(opened, attribute.c_str()) <= 0)
  {
    return {};
  }
  const Hdf5Attribute found(opened, attribute);
  const hssize_t count = found.Values;
  // Refuse types that VTK does not have: a damaged type would make the library read beyond the
  // values.
  if (FindKnownType(found.Type).ScalarType == 0 || count < 0 || count > hssize_t{ LongestText })
  {
    return {};
  }
  std::vector<double> numbers(static_cast<std::size_t>(count));
  if (count > 0 && H5Aread(found.Id, H5T_NATIVE_DOUBLE, numbers.data()) < 0)
  {
    ThrowDamaged();
  }
  return numbers;
}

Hdf5Array Hdf5File::ReadArray(const std::string& path) const
{
  const Hdf5Id opened(H5Dopen2(this->Open->File, path.c_str(), H5P_DEFAULT));
  const Hdf5Id space(H5Dget_space(opened));
  const Hdf5Id type(H5Dget_type(opened));
  const Hdf5Id made(H5Dget_create_plist(opened));
  Hdf5Array array;
  const KnownType known = FindKnownType(type);
  array.ScalarType = known.ScalarType;
  array.IsBig = known.IsBig;
  array.SampleSize = H5Tget_size(type);
  hsize_t sizes[H5S_MAX_RANK] = {};
  const int rank = H5Sget_simple_extent_dims(space, sizes, nullptr);
  if (rank < 0 || array.SampleSize == 0)
  {
    ThrowDamaged();
  }
  array.Shape.assign(sizes, sizes + rank);
  if (array.ScalarType == 0)
  {
    return array;
  }
  if (H5Pget_external_count(made) > 0)
  {
    throw std::runtime_error("its samples lie in other files. Convert it with h5repack -l CONTI "
                             "IN OUT, or open the raw file itself.");
  }
  array.FillValue.resize(array.SampleSize, 0);
  H5D_fill_value_t fill = H5D_FILL_VALUE_ERROR;
  if (H5Pfill_value_defined(made, &fill) >= 0 && fill == H5D_FILL_VALUE_USER_DEFINED &&
    H5Pget_fill_value(made, type, array.FillValue.data()) < 0)
  {
    ThrowDamaged();
  }
  const H5D_layout_t layout = H5Pget_layout(made);
  if (layout == H5D_CONTIGUOUS)
  {
    const haddr_t address = H5Dget_offset(opened);
    array.IsContiguous = address != HADDR_UNDEF;
    array.Address = address;
  }
  else if (layout == H5D_CHUNKED)
  {
    if (H5Pget_chunk(made, H5S_MAX_RANK, sizes) != rank || rank == 0 ||
      std::find(sizes, sizes + rank, 0) != sizes + rank)
    {
      ThrowDamaged();
    }
    array.ChunkShape.assign(sizes, sizes + rank);
  }
  const int filters = H5Pget_nfilters(made);
  for (int i = 0; i < filters; ++i)
  {
    unsigned int flags = 0;
    unsigned int value = 0;
    std::size_t values = 1;
    const H5Z_filter_t id = H5Pget_filter2(
      made, static_cast<unsigned int>(i), &flags, &values, &value, 0, nullptr, nullptr);
    if (id < 0)
    {
      ThrowDamaged();
    }
    array.Filters.push_back({ id, values > 0 ? value : 0 });
  }
  return array;
}

std::unordered_map<std::uint64_t, Hdf5Chunk> Hdf5File::LocateChunks(
  const std::string& path, const Hdf5Array& array, const std::array<std::uint64_t, 3>& counts) const
{
  if (static_cast<double>(counts[0]) * static_cast<double>(counts[1]) *
      static_cast<double>(counts[2]) >
    MostChunks)
  {
    throw std::runtime_error("its array has more than 16777216 chunks. Convert it with h5repack -l "
                             "CHUNK=64x64x64 IN OUT.");
  }
  const Hdf5Id opened(H5Dopen2(this->Open->File, path.c_str(), H5P_DEFAULT));
  const std::size_t x = array.Shape.size() - 1;
  std::vector<hsize_t> first(array.Shape.size(), 0);
  std::unordered_map<std::uint64_t, Hdf5Chunk> chunks;
  for (std::uint64_t number = 0; number < counts[0] * counts[1] * counts[2]; ++number)
  {
    first[x] = number % counts[0] * array.ChunkShape[x];
    first[x - 1] = number / counts[0] % counts[1] * array.ChunkShape[x - 1];
    first[x - 2] = number / counts[0] / counts[1] * array.ChunkShape[x - 2];
    hsize_t size = 0;
    if (H5Dget_chunk_storage_size(opened, first.data(), &size) < 0)
    {
      ThrowDamaged();
    }
    if (size == 0)
    {
      continue;
    }
    // The library's own list of chunks takes a time that is quadratic in their number (a minute for
    // 2048 x 2048 x 2048 samples). Instead, make the library read each chunk through this driver,
    // which only records the position.
    Hdf5Chunk chunk;
    std::uint32_t skipped = 0;
    char nothing = 0;
    this->Open->Bytes.Located = &chunk;
    const herr_t done = H5Dread_chunk(opened, H5P_DEFAULT, first.data(), &skipped, &nothing);
    this->Open->Bytes.Located = nullptr;
    if (done < 0 || chunk.Size == 0)
    {
      ThrowDamaged();
    }
    chunk.Skipped = skipped;
    chunks[number] = chunk;
  }
  return chunks;
}

} // namespace VolumeHaptics
