// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticRegionMessage.h"

#include "VTK/Base/ArrayMemory.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>
#include <type_traits>

namespace VolumeHapticsLive
{
namespace
{

constexpr int MessageTag = 78231;
/**
 * The size (bytes) of the parts in which a message is sent. A message that exceeds the memory can
 * thus be skipped part by part.
 */
constexpr vtkIdType PartSize = vtkIdType{ 1 } << 24;
/** Largest size of a region (bytes). */
constexpr std::int64_t MostBytes = std::int64_t{ 1 } << 36;
/**
 * A number that marks the byte order: a computer with another byte order reads a different number.
 */
constexpr std::int32_t Mark = 0x01020304;
enum Contents : std::int32_t
{
  Error,
  Region
};

void Put(std::vector<char>& message, const void* data, std::size_t size)
{
  const std::size_t start = message.size();
  message.resize(start + size);
  if (size > 0)
  {
    std::memcpy(message.data() + start, data, size);
  }
}

template <typename T>
void Put(std::vector<char>& message, const T& number)
{
  static_assert(!std::is_pointer_v<T>, "addresses mean nothing elsewhere");
  Put(message, &number, sizeof(T));
}

void PutText(std::vector<char>& message, const char* text)
{
  const std::int64_t size = text ? static_cast<std::int64_t>(std::strlen(text)) : 0;
  Put(message, size);
  Put(message, text, static_cast<std::size_t>(size));
}

/**
 * Returns whether an array can be sent: its values must be whole bytes, which excludes arrays of
 * bits.
 */
bool CanSend(vtkDataArray* array)
{
  return array && array->GetDataTypeSize() > 0;
}

void PutArray(std::vector<char>& message, vtkDataArray* array)
{
  PutText(message, array->GetName());
  Put(message, std::int32_t{ array->GetDataType() });
  Put(message, std::int32_t{ array->GetNumberOfComponents() });
  Put(message, std::int64_t{ array->GetNumberOfTuples() });
  const auto size = static_cast<std::size_t>(array->GetDataSize()) * array->GetDataTypeSize();
  if (message.size() + size > MostBytes)
  {
    throw std::length_error("it is too large to be sent");
  }
  Put(message, array->GetVoidPointer(0), size);
}

/** Reads numbers from a message, and checks its end. */
class Reader
{
public:
  explicit Reader(const std::vector<char>& message)
    : Message(message)
  {
  }

  bool Parse(void* data, std::int64_t size)
  {
    if (size < 0 || size > static_cast<std::int64_t>(this->Message.size() - this->Next))
    {
      this->IsGood = false;
      return false;
    }
    std::memcpy(data, this->Message.data() + this->Next, static_cast<std::size_t>(size));
    this->Next += static_cast<std::size_t>(size);
    return true;
  }

  template <typename T>
  T Parse()
  {
    T number = {};
    this->Parse(&number, sizeof(T));
    return number;
  }

  std::string ParseText()
  {
    const auto size = this->Parse<std::int64_t>();
    std::string text;
    if (size > 0 && size <= static_cast<std::int64_t>(this->Message.size() - this->Next))
    {
      text.resize(static_cast<std::size_t>(size));
      this->Parse(text.data(), size);
    }
    return text;
  }

  vtkSmartPointer<vtkDataArray> ParseArray()
  {
    const std::string name = this->ParseText();
    const auto type = this->Parse<std::int32_t>();
    const auto components = this->Parse<std::int32_t>();
    const auto tuples = this->Parse<std::int64_t>();
    vtkSmartPointer<vtkDataArray> array;
    array.TakeReference(vtkDataArray::CreateDataArray(type));
    // Check for the size 0, which arrays of bits have, before dividing.
    const std::int64_t size = array ? array->GetDataTypeSize() : 0;
    const auto rest = static_cast<std::int64_t>(this->Message.size() - this->Next);
    this->IsGood = this->IsGood && size > 0 && components > 0 && tuples >= 0 &&
      tuples <= rest / components / size;
    if (!this->IsGood)
    {
      return nullptr;
    }
    array->SetName(name.c_str());
    array->SetNumberOfComponents(components);
    VolumeHaptics::AllocateTuples(array, tuples);
    this->Parse(array->GetVoidPointer(0), tuples * components * size);
    return array;
  }

  bool IsAtEnd() const { return this->Next == this->Message.size(); }

  bool IsGood = true;

private:
  const std::vector<char>& Message;
  std::size_t Next = 0;
};

} // namespace

std::vector<char> PackError(const std::string& error)
{
  std::vector<char> message;
  Put(message, Mark);
  Put(message, Contents::Error);
  PutText(message, error.c_str());
  return message;
}

std::vector<char> PackRegion(vtkImageData* image)
{
  std::vector<char> message;
  if (!CanSend(image->GetPointData()->GetScalars()))
  {
    return PackError("The server has no point scalars that can be sent. Choose a point array of "
                     "another type than bits in the filter that Touch names.");
  }
  Put(message, Mark);
  Put(message, Contents::Region);
  Put(message, image->GetExtent(), 6 * sizeof(int));
  Put(message, image->GetOrigin(), 3 * sizeof(double));
  Put(message, image->GetSpacing(), 3 * sizeof(double));
  Put(message, image->GetDirectionMatrix()->GetData(), 9 * sizeof(double));
  PutArray(message, image->GetPointData()->GetScalars());
  vtkFieldData* const fields = image->GetFieldData();
  std::vector<vtkDataArray*> arrays;
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
  {
    if (CanSend(fields->GetArray(i)))
    {
      arrays.push_back(fields->GetArray(i));
    }
  }
  Put(message, static_cast<std::int32_t>(arrays.size()));
  for (vtkDataArray* const array : arrays)
  {
    PutArray(message, array);
  }
  return message;
}

bool UnpackRegion(const std::vector<char>& message, vtkImageData* image, std::string& error)
{
  Reader reader(message);
  if (reader.Parse<std::int32_t>() != Mark)
  {
    error = "The server's numbers can't be read here. Use a client and a server of the same "
            "version, on computers "
            "with the same order of bytes.";
    return false;
  }
  if (reader.Parse<std::int32_t>() != Contents::Region)
  {
    error = reader.ParseText();
    return false;
  }
  int extent[6] = {};
  double origin[3] = {};
  double spacing[3] = {};
  double direction[9] = {};
  reader.Parse(extent, sizeof(extent));
  reader.Parse(origin, sizeof(origin));
  reader.Parse(spacing, sizeof(spacing));
  reader.Parse(direction, sizeof(direction));
  const vtkSmartPointer<vtkDataArray> scalars = reader.ParseArray();
  image->Initialize();
  image->SetExtent(extent);
  image->SetOrigin(origin);
  image->SetSpacing(spacing);
  image->SetDirectionMatrix(direction);
  const auto fields = reader.Parse<std::int32_t>();
  for (std::int32_t i = 0; i < fields && reader.IsGood; ++i)
  {
    if (const vtkSmartPointer<vtkDataArray> array = reader.ParseArray())
    {
      image->GetFieldData()->AddArray(array);
    }
  }
  if (!reader.IsGood || !reader.IsAtEnd() ||
    scalars->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    error =
      "The server sent something that is not a region of a volume. Use a client and a server of "
      "the same version.";
    return false;
  }
  image->GetPointData()->SetScalars(scalars);
  return true;
}

bool SendMessage(vtkMultiProcessController* controller, const std::vector<char>& message)
{
  const auto size = static_cast<vtkIdType>(message.size());
  bool isSent = controller->Send(&size, 1, 1, MessageTag) != 0;
  for (vtkIdType start = 0; isSent && start < size; start += PartSize)
  {
    isSent = controller->Send(
               message.data() + start, std::min(PartSize, size - start), 1, MessageTag) != 0;
  }
  return isSent;
}

bool ReceiveMessage(vtkMultiProcessController* controller, std::vector<char>& message)
{
  vtkIdType size = 0;
  if (!controller->Receive(&size, 1, 1, MessageTag) || size <= 0 || size > MostBytes)
  {
    return false;
  }
  bool isKept = true;
  try
  {
    message.resize(static_cast<std::size_t>(size));
  }
  catch (const std::bad_alloc&)
  {
    isKept = false;
    message.resize(static_cast<std::size_t>(std::min(PartSize, size)));
  }
  bool isGood = true;
  for (vtkIdType start = 0; isGood && start < size; start += PartSize)
  {
    char* const to = message.data() + (isKept ? start : 0);
    isGood = controller->Receive(to, std::min(PartSize, size - start), 1, MessageTag) != 0;
  }
  if (!isKept)
  {
    message = PackError("This computer has no memory for the region around the tip. Lower "
                        "MaximumRegionVoxels, or close what you do not need.");
  }
  return isGood;
}

} // namespace VolumeHapticsLive
