# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Simulates a slow connection: relay.py PORT SECONDS prints a port of its own, and delays the data in both
directions."""
import queue
import socket
import sys
import threading
import time


def carry(source, target, delay):
    parts = queue.Queue()

    def deliver():
        while True:
            due, data = parts.get()
            time.sleep(max(0.0, due - time.monotonic()))
            if not data:
                target.shutdown(socket.SHUT_WR)
                return
            target.sendall(data)

    threading.Thread(target=deliver, daemon=True).start()
    while True:
        try:
            data = source.recv(1 << 16)
        except OSError:
            data = b""
        parts.put((time.monotonic() + delay, data))
        if not data:
            return


listener = socket.socket()
listener.bind(("127.0.0.1", 0))
listener.listen(1)
print(listener.getsockname()[1], flush=True)
client, _ = listener.accept()
server = socket.create_connection(("127.0.0.1", int(sys.argv[1])))
for end in (client, server):
    end.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
back = threading.Thread(target=carry, args=(server, client, float(sys.argv[2])))
back.start()
carry(client, server, float(sys.argv[2]))
back.join()
