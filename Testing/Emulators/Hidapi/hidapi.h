// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Declares the functions of hidapi 0.14 that the module uses to list devices, according to the
 * public API reference (libusb.info/hidapi, "hidapi API"): hid_get_report_descriptor() is new in
 * 0.14, and returns the number of bytes that it has copied, or -1. NewerHidapiTest.cxx implements
 * it.
 */
#ifndef PlayedHidapi_h
#define PlayedHidapi_h

#include <cstddef>

#define HID_API_MAKE_VERSION(mj, mn, p) (((mj) << 24) | ((mn) << 8) | (p))
#define HID_API_VERSION HID_API_MAKE_VERSION(0, 14, 0)
#define HID_API_MAX_REPORT_DESCRIPTOR_SIZE 4096

struct hid_device;
struct hid_device_info
{
  char* path;
  unsigned short vendor_id;
  unsigned short product_id;
  wchar_t* serial_number;
  unsigned short release_number;
  wchar_t* manufacturer_string;
  wchar_t* product_string;
  unsigned short usage_page;
  unsigned short usage;
  int interface_number;
  hid_device_info* next;
};

int hid_init();
hid_device_info* hid_enumerate(unsigned short vendor, unsigned short product);
void hid_free_enumeration(hid_device_info* list);
hid_device* hid_open_path(const char* path);
void hid_close(hid_device* device);
int hid_get_report_descriptor(hid_device* device, unsigned char* bytes, std::size_t size);

#endif
