// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Builds HID report descriptors item by item, according to the HID 1.11 specification, 6.2.2.
 *
 * \code
 *   HidItems items;
 *   items.Page(0x01).Usage(0x04).Open(HidItems::ApplicationCollection);
 *   items.Id(1).Usage(0x30).Logical(-32767, 32767).Fields(16, 1).Input();
 *   items.Close();
 * \endcode
 */
#ifndef HidItems_h
#define HidItems_h

#include <cstdint>
#include <vector>

namespace emulated
{

class HidItems
{
public:
  enum CollectionType : std::uint8_t
  {
    PhysicalCollection = 0,
    ApplicationCollection = 1,
    LogicalCollection = 2
  };
  /** Flags of a main item: bit 0 constant, bit 1 variable, bit 2 relative. */
  enum FieldKind : std::uint8_t
  {
    Array = 0,
    Variable = 2,
    Padding = 3,
    Relative = 6
  };

  HidItems& Page(std::uint32_t page) { return this->Unsigned(0x04, page); }
  HidItems& Id(std::uint8_t id) { return this->Unsigned(0x84, id); }
  HidItems& Usage(std::uint32_t usage) { return this->Unsigned(0x08, usage); }
  template <typename... More>
  HidItems& Usages(std::uint32_t first, More... more)
  {
    this->Usage(first);
    (this->Usage(static_cast<std::uint32_t>(more)), ...);
    return *this;
  }
  HidItems& UsageRange(std::uint32_t first, std::uint32_t last)
  {
    return this->Unsigned(0x18, first).Unsigned(0x28, last);
  }
  HidItems& Logical(std::int64_t least, std::int64_t most)
  {
    return this->Signed(0x14, least).Signed(0x24, most);
  }
  HidItems& Bounds(std::int64_t least, std::int64_t most)
  {
    return this->Signed(0x34, least).Signed(0x44, most);
  }
  /** Sets a unit, and its exponent as a byte in two's complement. */
  HidItems& Unit(std::uint32_t unit, std::uint8_t exponent)
  {
    return this->Unsigned(0x64, unit).Unsigned(0x54, exponent);
  }
  HidItems& Fields(unsigned bits, unsigned count)
  {
    return this->Unsigned(0x74, bits).Unsigned(0x94, count);
  }
  HidItems& Input(FieldKind kind = Variable) { return this->Unsigned(0x80, kind); }
  HidItems& Output(FieldKind kind = Variable) { return this->Unsigned(0x90, kind); }
  HidItems& Feature(FieldKind kind = Variable) { return this->Unsigned(0xB0, kind); }
  HidItems& Open(CollectionType type) { return this->Unsigned(0xA0, type); }
  HidItems& Close()
  {
    this->Bytes.push_back(0xC0);
    return *this;
  }

  const std::vector<std::uint8_t>& Get() const { return this->Bytes; }

private:
  HidItems& Item(std::uint8_t prefix, std::uint32_t data, int size)
  {
    this->Bytes.push_back(static_cast<std::uint8_t>(prefix | (size == 4 ? 3 : size)));
    for (int b = 0; b < size; ++b)
    {
      this->Bytes.push_back(static_cast<std::uint8_t>(data >> 8 * b & 0xFF));
    }
    return *this;
  }
  HidItems& Unsigned(std::uint8_t prefix, std::uint32_t data)
  {
    return this->Item(prefix, data, data < 0x100 ? 1 : data < 0x10000 ? 2 : 4);
  }
  /** Writes a number in as many bytes as it needs including its sign: 255 takes two bytes. */
  HidItems& Signed(std::uint8_t prefix, std::int64_t data)
  {
    const int size = data >= -0x80 && data < 0x80 ? 1 : data >= -0x8000 && data < 0x8000 ? 2 : 4;
    return this->Item(prefix, static_cast<std::uint32_t>(data), size);
  }

  std::vector<std::uint8_t> Bytes;
};

} // namespace emulated

#endif
