#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Measures from outside how quickly a window follows the hand, as an eye sees it, and prints it:

    pace.py TITLE [--at X Y] [--steps N] [--rounds N] [--delay S] [--rest S] [--click 1]

A window with this title is open on this screen, on X11, with a volume that can be touched at the fraction X, Y of its
width and height (0.5, 0.5). The pointer goes there, the key t begins the touch, and N steps of the wheel (4) press.
--delay: seconds before that (1). --rest: seconds that the hand rests before the stroke which is measured (0): prints
when the picture beside the hand, which is drawn finely meanwhile, was as it stays, and how much of it the stroke keeps.
--click: a click gives the volume the keyboard's focus, which ParaView's takes.

frames per second: how often the picture around the proxy changes during a stroke of three seconds.

latency: the hand rests until a fine frame is due or being drawn, and then jumps by 60 pixels. It is the time from that
motion until the hand is seen at its new place, which takes the end of the frame, the servo, the haptics of the
window's timer, and a quick frame. The hand is recognised by the blue arrow of the surface's force.

pace.sh does all of that on a screen of its own.
"""

import argparse
import ctypes
import random
import statistics
import sys
import time

X11 = ctypes.CDLL("libX11.so.6")
TEST = ctypes.CDLL("libXtst.so.6")
ZPIXMAP, ALL_PLANES = 2, ctypes.c_ulong(-1)


class Image(ctypes.Structure):
    """The first members of Xlib's structure XImage."""

    _fields_ = [("width", ctypes.c_int), ("height", ctypes.c_int), ("xoffset", ctypes.c_int), ("format", ctypes.c_int),
                ("data", ctypes.c_void_p), ("byte_order", ctypes.c_int), ("bitmap_unit", ctypes.c_int),
                ("bitmap_bit_order", ctypes.c_int), ("bitmap_pad", ctypes.c_int), ("depth", ctypes.c_int),
                ("bytes_per_line", ctypes.c_int), ("bits_per_pixel", ctypes.c_int)]


for function, result, arguments in (
        (X11.XOpenDisplay, ctypes.c_void_p, [ctypes.c_char_p]),
        (X11.XDefaultRootWindow, ctypes.c_ulong, [ctypes.c_void_p]),
        (X11.XGetImage, ctypes.POINTER(Image), [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_int, ctypes.c_int,
                                                ctypes.c_uint, ctypes.c_uint, ctypes.c_ulong, ctypes.c_int]),
        (X11.XDestroyImage, ctypes.c_int, [ctypes.POINTER(Image)]),
        (X11.XFlush, ctypes.c_int, [ctypes.c_void_p]),
        (X11.XKeysymToKeycode, ctypes.c_ubyte, [ctypes.c_void_p, ctypes.c_ulong]),
        (X11.XQueryTree, ctypes.c_int, [ctypes.c_void_p, ctypes.c_ulong, ctypes.POINTER(ctypes.c_ulong),
                                        ctypes.POINTER(ctypes.c_ulong), ctypes.POINTER(ctypes.POINTER(ctypes.c_ulong)),
                                        ctypes.POINTER(ctypes.c_uint)]),
        (X11.XFetchName, ctypes.c_int, [ctypes.c_void_p, ctypes.c_ulong, ctypes.POINTER(ctypes.c_char_p)]),
        (X11.XGetGeometry, ctypes.c_int, [ctypes.c_void_p, ctypes.c_ulong, ctypes.POINTER(ctypes.c_ulong)]
         + 2 * [ctypes.POINTER(ctypes.c_int)] + 4 * [ctypes.POINTER(ctypes.c_uint)]),
        (X11.XTranslateCoordinates, ctypes.c_int, [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_ulong, ctypes.c_int,
                                                   ctypes.c_int, ctypes.POINTER(ctypes.c_int),
                                                   ctypes.POINTER(ctypes.c_int), ctypes.POINTER(ctypes.c_ulong)]),
        (TEST.XTestFakeMotionEvent, ctypes.c_int, [ctypes.c_void_p, ctypes.c_int, ctypes.c_int, ctypes.c_int,
                                                   ctypes.c_ulong]),
        (TEST.XTestFakeButtonEvent, ctypes.c_int, [ctypes.c_void_p, ctypes.c_uint, ctypes.c_int, ctypes.c_ulong]),
        (TEST.XTestFakeKeyEvent, ctypes.c_int, [ctypes.c_void_p, ctypes.c_uint, ctypes.c_int, ctypes.c_ulong])):
    function.restype, function.argtypes = result, arguments


class Screen:
    """Moves the mouse, presses keys and reads pixels of the screen."""

    def __init__(self):
        self.display = X11.XOpenDisplay(None)
        if not self.display:
            sys.exit("There is no display. Cure: xvfb-run, or pace.sh")
        self.root = X11.XDefaultRootWindow(self.display)

    def find(self, title):
        """Returns x, y, width and height of the window whose title begins with this text, or None."""
        def search(window):
            name = ctypes.c_char_p()
            X11.XFetchName(self.display, window, ctypes.byref(name))
            if (name.value or b"").decode("latin-1").startswith(title):
                return window
            root, parent, count = ctypes.c_ulong(), ctypes.c_ulong(), ctypes.c_uint()
            children = ctypes.POINTER(ctypes.c_ulong)()
            X11.XQueryTree(self.display, window, ctypes.byref(root), ctypes.byref(parent), ctypes.byref(children),
                           ctypes.byref(count))
            return next((found for i in range(count.value) for found in [search(children[i])] if found), None)

        window = search(self.root)
        if window is None:
            return None
        root, child, x, y = ctypes.c_ulong(), ctypes.c_ulong(), ctypes.c_int(), ctypes.c_int()
        width, height, border, depth = (ctypes.c_uint() for _ in range(4))
        X11.XGetGeometry(self.display, window, ctypes.byref(root), ctypes.byref(x), ctypes.byref(y),
                         ctypes.byref(width), ctypes.byref(height), ctypes.byref(border), ctypes.byref(depth))
        X11.XTranslateCoordinates(self.display, window, self.root, 0, 0, ctypes.byref(x), ctypes.byref(y),
                                  ctypes.byref(child))
        return x.value, y.value, width.value, height.value

    def see(self, x, y, reach):
        """Returns the pixels around a place, as bytes of blue, green, red and an unused byte."""
        image = X11.XGetImage(self.display, self.root, x - reach, y - reach, 2 * reach, 2 * reach, ALL_PLANES, ZPIXMAP)
        pixels = ctypes.string_at(image.contents.data, image.contents.bytes_per_line * image.contents.height)
        X11.XDestroyImage(image)
        return pixels

    def move(self, x, y):
        TEST.XTestFakeMotionEvent(self.display, -1, int(x), int(y), 0)
        X11.XFlush(self.display)

    def press(self, key):
        for down in (1, 0):
            TEST.XTestFakeKeyEvent(self.display, X11.XKeysymToKeycode(self.display, ord(key)), down, 0)
        X11.XFlush(self.display)

    def push(self, button):
        """Clicks a mouse button. Button 4 is a step of the wheel."""
        for down in (1, 0):
            TEST.XTestFakeButtonEvent(self.display, button, down, 0)
        X11.XFlush(self.display)


def shows_contact(pixels):
    """Returns whether some pixels have the blue of the proxy's arrow. Skin, bone and stylus do not have this colour."""
    return sum(blue > red + 90 for blue, red in zip(pixels[0::4], pixels[2::4])) >= 6


def stroke(screen, x, y, seconds):
    """Moves the mouse to and fro. Returns how often the picture changed."""
    frames, before, begin = 0, None, time.monotonic()
    reach = 60
    while (now := time.monotonic()) < begin + seconds:
        phase = (now - begin) / 0.5 % 2.0  # 80 pixels a second, so that each frame is different
        screen.move(x + 40 * (phase if phase < 1 else 2 - phase), y)
        picture = screen.see(x, y, reach)
        frames += before is not None and picture != before
        before = picture
        time.sleep(0.004)
    return frames / (time.monotonic() - begin)


def watch_rest(screen, x, y, seconds):
    """Returns the last picture, and how long (s) it took until the picture looked like this."""
    before, begin, since = None, time.monotonic(), 0.0
    while (now := time.monotonic()) < begin + seconds:
        picture = screen.see(x, y, 40)
        if picture != before:
            before, since = picture, now - begin
        time.sleep(0.02)
    return before, since


def count_equal(one, other):
    """Returns the fraction of equal pixels."""
    return sum(one[i:i + 3] == other[i:i + 3] for i in range(0, len(one), 4)) / (len(one) / 4)


def measure_latency(screen, x, y, rounds):
    """Returns the times (s) from a motion to its picture, at random moments after the hand came to rest."""
    times, side = [], 0
    for _ in range(rounds):
        time.sleep(0.3 + random.uniform(0.0, 0.3))  # a fine frame is due 0.3 s after the last quick frame
        side = 60 - side
        before = shows_contact(screen.see(x + side, y, 14))
        begin = time.monotonic()
        screen.move(x + side, y)
        while not shows_contact(screen.see(x + side, y, 14)):
            if time.monotonic() > begin + 2.0:
                break
            time.sleep(0.001)
        else:
            if not before:
                times.append(time.monotonic() - begin)
    return times


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("title")
    parser.add_argument("--at", nargs=2, type=float, default=(0.5, 0.5))
    parser.add_argument("--steps", type=int, default=4)
    parser.add_argument("--rounds", type=int, default=40)
    parser.add_argument("--delay", type=float, default=1.0)
    parser.add_argument("--rest", type=float, default=0.0)
    parser.add_argument("--click", type=int, default=0)
    options = parser.parse_args()
    screen = Screen()
    end = time.monotonic() + 120
    while (found := screen.find(options.title)) is None:
        if time.monotonic() > end:
            sys.exit(f"there is no window {options.title}")
        time.sleep(0.1)
    left, top, width, height = found
    x, y = left + int(options.at[0] * width), top + int(options.at[1] * height)
    screen.move(x, y)
    time.sleep(options.delay)
    if options.click:
        screen.push(1)
        time.sleep(0.5)
    screen.press("t")
    time.sleep(1.5)  # meanwhile, the force rises, and the style learns how long frames take
    for _ in range(options.steps):
        screen.push(4)
        time.sleep(0.1)
    time.sleep(0.5)
    stroke(screen, x, y, 1.0)
    if options.rest:
        fine, since = watch_rest(screen, x, y - 110, options.rest)
    rate = stroke(screen, x, y, 3.0)
    if options.rest:
        kept = count_equal(fine, screen.see(x, y - 110, 40))
        print(f"the picture beside the hand was as it stayed after {since:.2f} s of rest; the stroke kept {kept:.0%} of it")
    times = sorted(measure_latency(screen, x, y, options.rounds))
    if len(times) < options.rounds // 2:
        sys.exit(f"the hand was seen at its new place {len(times)} times of {options.rounds} only: choose another --at")
    half, most = statistics.median(times), times[int(0.95 * len(times))]
    rest = f" after a rest of {options.rest:g} s" if options.rest else ""
    print(f"{width} x {height}: {rate:.0f} frames per second in a stroke{rest}; latency of {len(times)} motions while a fine "
          f"frame was due: {1e3 * half:.0f} ms median, {1e3 * most:.0f} ms at 95 %, {1e3 * times[-1]:.0f} ms at most")


main()
