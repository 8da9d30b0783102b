// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HidOverUsb.h"

#include <algorithm>
#include <cerrno>

namespace emulated
{
namespace
{
using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t MostInputs = 64;
constexpr std::uint8_t TypeOutput = 2;
constexpr std::uint8_t TypeFeature = 3;
constexpr std::uint8_t DescriptorString = 0x03;
constexpr std::uint8_t DescriptorHid = 0x21;
constexpr std::uint8_t DescriptorReport = 0x22;

std::uint8_t Low(std::size_t number)
{
  return static_cast<std::uint8_t>(number & 0xFF);
}

std::uint8_t High(std::size_t number)
{
  return static_cast<std::uint8_t>(number >> 8 & 0xFF);
}

/** Returns whether a report descriptor contains a Report ID item. */
bool DetectIds(const Bytes& descriptor)
{
  std::size_t at = 0;
  while (at < descriptor.size())
  {
    const std::uint8_t item = descriptor[at];
    if ((item & 0xFC) == 0x84)
    {
      return true;
    }
    const std::size_t sizes[4] = { 0, 1, 2, 4 };
    at += 1 + sizes[item & 3];
  }
  return false;
}

int Copy(const Bytes& from, std::uint8_t* to, int room)
{
  const std::size_t size = std::min(from.size(), static_cast<std::size_t>(room));
  std::copy_n(from.begin(), size, to);
  return static_cast<int>(size);
}
} // namespace

HidOverUsb::HidOverUsb(HidModel& model)
  : Model(model)
  , ReportDescriptor(model.GetReportDescriptor())
  , HasIds(DetectIds(this->ReportDescriptor))
{
  model.Input = [this](const std::uint8_t* report, int size)
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      // While no program reads, keep only the newest reports, like a device.
      if (this->Inputs.size() == MostInputs)
      {
        this->Inputs.pop_front();
      }
      this->Inputs.emplace_back(report, report + size);
    }
    this->Ready();
  };
}

std::vector<std::uint8_t> HidOverUsb::MakeHidDescriptor() const
{
  const std::size_t size = this->ReportDescriptor.size();
  return { 9, DescriptorHid, 0x11, 0x01, 0, 1, DescriptorReport, Low(size), High(size) };
}

std::vector<std::uint8_t> HidOverUsb::GetDescriptors() const
{
  const std::size_t vendor = this->Model.GetVendor();
  const std::size_t product = this->Model.GetProduct();
  const Bytes hid = this->MakeHidDescriptor();
  // String 1 names the maker, and string 2 the product. There is no serial number.
  Bytes all = { 18, 1, 0x00, 0x02, 0, 0, 0, 64, Low(vendor), High(vendor), Low(product),
    High(product), 0x00, 0x01, 1, 2, 0, 1 };
  const Bytes configuration = { 9, 2, 41, 0, 1, 1, 0, 0x80, 50 };
  const Bytes interface = { 9, 4, 0, 0, 2, 3, 0, 0, 0 };
  // Two interrupt endpoints of 64 bytes, which the host polls every millisecond.
  const Bytes endpoints = { 7, 5, 0x81, 3, 64, 0, 1, 7, 5, 0x02, 3, 64, 0, 1 };
  for (const Bytes& part : { configuration, interface, hid, endpoints })
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

int HidOverUsb::GetDescriptor(const std::uint8_t setup[8], std::uint8_t* data, int size) const
{
  const std::uint8_t index = setup[2];
  switch (setup[3])
  {
    case DescriptorHid:
      return Copy(this->MakeHidDescriptor(), data, size);
    case DescriptorReport:
      return Copy(this->ReportDescriptor, data, size);
    case DescriptorString:
      break;
    default:
      return -EPIPE;
  }
  if (index > 2)
  {
    return -EPIPE;
  }
  Bytes text = { 4, DescriptorString, 0x09, 0x04 }; // the list of languages contains only English
  if (index > 0)
  {
    const std::string name = index == 1 ? "Emulated" : this->Model.GetName();
    text = { Low(2 + 2 * name.size()), DescriptorString };
    for (const char c : name)
    {
      text.insert(text.end(), { static_cast<std::uint8_t>(c), 0 });
    }
  }
  return Copy(text, data, size);
}

int HidOverUsb::Control(const std::uint8_t setup[8], std::uint8_t* data, int size)
{
  constexpr int GetDescriptorOfDevice = 0x8006, GetDescriptorOfInterface = 0x8106;
  constexpr int GetReport = 0xA101, SetReport = 0x2109, SetIdle = 0x210A, SetProtocol = 0x210B;
  switch (setup[0] << 8 | setup[1])
  {
    case GetDescriptorOfDevice:
    case GetDescriptorOfInterface:
      return this->GetDescriptor(setup, data, size);
    case GetReport:
      return this->GetReport(setup[3], setup[2], data, size);
    case SetReport:
      return this->SetReport(setup[3], data, size);
    case SetIdle:
    case SetProtocol:
      return 0;
    default:
      return -EPIPE;
  }
}

int HidOverUsb::GetReport(std::uint8_t type, std::uint8_t id, std::uint8_t* data, int size)
{
  if (type != TypeFeature)
  {
    return -EPIPE;
  }
  // Models always begin a report with an id. The transmitted report contains the id only if the
  // device uses ids.
  Bytes report(static_cast<std::size_t>(size) + 64, 0);
  report[0] = id;
  const int given = this->Model.GetFeature(report.data(), static_cast<int>(report.size()));
  if (given < 0)
  {
    return -EPIPE;
  }
  report.resize(static_cast<std::size_t>(given));
  if (!this->HasIds && given > 0)
  {
    report.erase(report.begin());
  }
  return Copy(report, data, size);
}

int HidOverUsb::SetReport(std::uint8_t type, const std::uint8_t* data, int size)
{
  Bytes report(this->HasIds ? 0 : 1, 0);
  report.insert(report.end(), data, data + size);
  const int whole = static_cast<int>(report.size());
  const int taken = type == TypeFeature ? this->Model.SetFeature(report.data(), whole)
    : type == TypeOutput                ? this->Model.Output(report.data(), whole)
                                        : -EPIPE;
  return taken < 0 ? -EPIPE : size;
}

int HidOverUsb::Out(std::uint8_t, const std::uint8_t* bytes, int size)
{
  return this->SetReport(TypeOutput, bytes, size);
}

void HidOverUsb::Forget()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Inputs.clear();
}

int HidOverUsb::In(std::uint8_t, std::uint8_t* bytes, int size)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->Inputs.empty())
  {
    return -EAGAIN;
  }
  const int given = Copy(this->Inputs.front(), bytes, size);
  this->Inputs.pop_front();
  return given;
}
} // namespace emulated
