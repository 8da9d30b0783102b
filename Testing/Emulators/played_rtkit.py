#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Plays RealtimeKit on a bus of its own ($DBUS_SESSION_BUS_ADDRESS), without giving any priority.

Written from what rtkit 0.13 publishes (github.com/heftig/rtkit): its interface is org.freedesktop.RealtimeKit1.xml; it
refuses what README and rtkit-daemon.c say: a priority above MaxRealtimePriority, a thread of another process, and a
process whose hard limit RLIMIT_RTTIME, which is read from /proc, is above RTTimeUSecMax.

Each call is a line of output.
"""

import argparse
import os
import signal

from gi.repository import Gio, GLib

NAME = "org.freedesktop.RealtimeKit1"
PATH = "/org/freedesktop/RealtimeKit1"
INTERFACES = """
<node>
  <interface name="org.freedesktop.RealtimeKit1">
    <method name="MakeThreadRealtime">
      <arg name="thread" type="t" direction="in"/>
      <arg name="priority" type="u" direction="in"/>
    </method>
  </interface>
  <interface name="org.freedesktop.DBus.Properties">
    <method name="Get">
      <arg name="interface" direction="in" type="s"/>
      <arg name="property" direction="in" type="s"/>
      <arg name="value" direction="out" type="v"/>
    </method>
  </interface>
</node>"""

parser = argparse.ArgumentParser()
parser.add_argument("--time", type=int, default=200000, help="RTTimeUSecMax")
parser.add_argument("--priority", type=int, default=20, help="MaxRealtimePriority")
parser.add_argument("--words", action="store_true", help="properties are words instead of numbers")
parser.add_argument("--refuse", action="store_true", help="as PolicyKit does for users who are elsewhere")
parser.add_argument("--silent", help="the method that gets no answer")
parser.add_argument("--die", help="the method in which the service ends")
options = parser.parse_args()
held = []


def hard_limit(process):
    with open(f"/proc/{process}/limits", encoding="ascii") as limits:
        text = next(line for line in limits if line.startswith("Max realtime timeout")).split()[4]
    return None if text == "unlimited" else int(text)


def get(name):
    value = {"RTTimeUSecMax": ("x", options.time), "MaxRealtimePriority": ("i", options.priority)}[name]
    if options.words:
        value = ("s", "many")
    return GLib.Variant("(v)", (GLib.Variant(*value),))


def called(connection, sender, _path, _interface, method, arguments, invocation):
    arguments = arguments.unpack()
    print(method, *arguments, flush=True)
    if method == options.die:
        os.kill(os.getpid(), signal.SIGKILL)
    if method == options.silent:
        held.append(invocation)
        return
    if method == "Get":
        invocation.return_value(get(arguments[1]))
        return
    thread, priority = arguments
    process = connection.call_sync(
        "org.freedesktop.DBus", "/org/freedesktop/DBus", "org.freedesktop.DBus", "GetConnectionUnixProcessID",
        GLib.Variant("(s)", (sender,)), None, Gio.DBusCallFlags.NONE, -1, None).unpack()[0]
    limit = hard_limit(process)
    if (
        options.refuse
        or not 0 < priority <= options.priority
        or not os.path.exists(f"/proc/{process}/task/{thread}")
        or limit is None
        or limit > options.time
    ):
        print("refused", flush=True)
        invocation.return_dbus_error("org.freedesktop.DBus.Error.AccessDenied", "Operation not permitted")
    else:
        print("granted", flush=True)
        invocation.return_value(None)


bus = Gio.bus_get_sync(Gio.BusType.SESSION, None)
for interface in Gio.DBusNodeInfo.new_for_xml(INTERFACES).interfaces:
    bus.register_object(PATH, interface, called, None, None)
loop = GLib.MainLoop()
Gio.bus_own_name_on_connection(bus, NAME, Gio.BusNameOwnerFlags.NONE, lambda *_: print("ready", flush=True), None)
loop.run()
