# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Decides who may use a page's server: only clients with its secret, from no other page, with well-formed messages.

Otherwise every page in the user's browser could lead the hand and see the volume: any page may open a WebSocket to
localhost, and wslink's own key is the same everywhere.
"""

from __future__ import annotations

import contextvars
import hmac
import ipaddress
import json
import secrets
import socket
import warnings
import weakref
from pathlib import Path
from typing import Any, Callable
from urllib.parse import urlsplit

from aiohttp import WSMsgType, web
from wslink.websocket import LinkProtocol

HERE = ("localhost", "127.0.0.1", "::1")
MOST_BYTES = 65536  # largest size of a page's message (bytes), which is an event or a few values
MOST_UNKNOWN = 512  # largest size of a message (bytes) before the page has sent the secret
HEADER = 12  # bytes of wslink's header: a number, the position of the part, and the size of the whole message

# The page whose message is being handled; None while the program itself acts.
_page: contextvars.ContextVar[str | None] = contextvars.ContextVar("page", default=None)

# trame removes the secret from the browser's address, but a reloaded page needs it. The tab therefore stores it where
# only this server and this tab can read it.
_KEEP = """<script>
(() => {
  const address = new URL(location);
  try {
    const kept = address.searchParams.get("secret") || sessionStorage.getItem("secret");
    if (kept) {
      sessionStorage.setItem("secret", kept);
      address.searchParams.set("secret", kept);
      history.replaceState({}, "", address);
      return;
    }
  } catch (error) {
    if (address.searchParams.get("secret")) return;
  }
  document.open();
  document.write(%s);
  document.close();
})();
</script>"""
_NO_SECRET = ("This page needs the secret of its server. Cure: open the address that the program printed, which has it, "
              "or run the notebook's cell again.")


def page_now() -> str | None:
    """Returns the number of the page whose message is being handled; None while the program itself acts."""
    return _page.get()


class _Secret(LinkProtocol):
    """Checks the secret for wslink, which itself would compare letter by letter up to the first difference."""

    def __init__(self, secret: str) -> None:
        super().__init__()
        self._secret = secret.encode()

    async def validateToken(self, token: Any, _client: str) -> bool:
        return isinstance(token, str) and hmac.compare_digest(token.encode(errors="replace"), self._secret)


def _place(address: str) -> tuple[str | None, str]:
    """Returns the host of an address, and the host together with the port."""
    try:
        parts = urlsplit(address)
        return parts.hostname, parts.netloc.lower()
    except ValueError:
        return None, ""


class Door:
    """The door of one trame server. Make it before the server starts.

    secret: the secret in the address, new at each start of the server.
    on_leave: called with the number of a page whose connection has ended.
    in_frames: whether other pages may show this one in a frame, as a notebook does.
    """

    def __init__(self, server: Any, in_frames: bool) -> None:
        self.secret = ""
        self.on_leave: list[Callable[[str], None]] = []
        self._server = weakref.ref(server)
        self._in_frames = in_frames
        self._names = set(HERE)
        self._requests: dict[str, web.Request] = {}  # requests of the pages' connections
        server.add_protocol_to_configure(self._configure)
        server.controller.on_server_bind.add(self._bind)

    def _configure(self, protocol: Any) -> None:
        # begins with a letter, because trame converts texts that look like numbers
        self.secret = "k" + secrets.token_hex(32)
        protocol.registerLinkProtocol(_Secret(self.secret))

    def address(self, host: str, page: str = "", *words: str) -> str:
        query = "&".join([*([f"ui={page}"] if page else []), *words, f"secret={self.secret}"])
        return f"http://{f'[{host}]' if ':' in host else host}:{self._server().port}/index.html?{query}"

    def drop(self, page: str) -> None:
        """Ends the connection of a page that no longer reads, because other pages would wait for it: wslink sends to
        one page after the other."""
        request = self._requests.get(page)
        if request is not None and request.transport is not None:
            request.transport.abort()

    def _bind(self, web_server: Any) -> None:
        """Guards wslink's server once it exists, before it listens."""
        application, handlers = getattr(web_server, "app", None), getattr(web_server, "_ws_handlers", None)
        if not isinstance(application, web.Application) or handlers is None:
            raise RuntimeError('a page to touch in is served by aiohttp alone. Cure: server.start(backend="aiohttp"), '
                               "without --reverse-url")
        server = self._server()
        server.protocol.updateSecret(self.secret)  # for versions of wslink that don't query _Secret
        host = web_server.host
        self._names.update(name.lower() for name in (host, socket.gethostname(), socket.getfqdn()))
        if host not in HERE:
            warnings.warn(f"the page is served at {host}, to the whole network, and without encryption: anyone who listens "
                          "there gets the secret, sees the volume and moves the hand. Cure: host=\"localhost\", "
                          "and from elsewhere ssh -L PORT:localhost:PORT", stacklevel=2)
        application.middlewares.append(self._make_middleware(Path(server.server_options.content) / "index.html"))
        for handler in handlers:
            self._watch(handler)

    # -- origin of the browser --

    def _refusal(self, headers: Any) -> str | None:
        """Returns the reason for a refusal, or None. If another host name leads here (DNS rebinding), the page has that
        name as its host."""
        host = headers.get("Host", "")
        name, place = _place(f"//{host}")
        try:
            known = name in self._names or bool(ipaddress.ip_address(name or ""))
        except ValueError:
            known = False
        if not known:
            return f"this server is not called {host!r}. Cure: open the address that the program printed"
        origin = headers.get("Origin")
        if origin is not None and _place(origin)[1] != place:
            return f"a page of {origin} has no access to this server"
        return None

    def _make_middleware(self, index: Path) -> Any:
        @web.middleware
        async def check(request: web.Request, handler: Any) -> web.StreamResponse:
            refusal = self._refusal(request.headers)
            if refusal:
                return web.Response(status=403, text=refusal)
            if request.path == "/index.html":
                keep = _KEEP % json.dumps(_NO_SECRET)
                text = index.read_text(encoding="utf-8").replace("<head>", f"<head>{keep}", 1)
                headers = {"Cache-Control": "no-store", "Referrer-Policy": "no-referrer"}
                if not self._in_frames:
                    headers["Content-Security-Policy"] = "frame-ancestors 'none'"
                return web.Response(text=text, content_type="text/html", headers=headers)
            return await handler(request)

        return check

    # -- the content of messages --

    def _watch(self, handler: Any) -> None:
        """Requires that a message is a single frame, because wslink would allocate memory of the size that a first
        frame announces."""
        connect, handle, close = handler.onConnect, handler.onMessage, handler.onClose

        async def on_connect(request: web.Request, client: str) -> None:
            self._requests[client] = request
            await connect(request, client)

        async def on_message(is_binary: bool, message: Any, client: str) -> None:
            most = MOST_BYTES if handler.isClientAuthenticated(client) else MOST_UNKNOWN
            data = message.data
            if not (message.type == WSMsgType.BINARY and HEADER < len(data) <= HEADER + most
                    and int.from_bytes(data[4:8], "little") == 0
                    and int.from_bytes(data[8:12], "little") == len(data) - HEADER):
                await handler.connections[client].close(code=1009, message=b"not one whole message")
                return
            _page.set(client)
            await handle(is_binary, message, client)

        async def on_close(client: str) -> None:
            self._requests.pop(client, None)
            for leave in list(self.on_leave):
                leave(client)
            await close(client)

        handler.onConnect, handler.onMessage, handler.onClose = on_connect, on_message, on_close


_doors: weakref.WeakKeyDictionary[Any, Door] = weakref.WeakKeyDictionary()


def door_of(server: Any, in_frames: bool = False) -> Door:
    """Returns the door of a server. Makes one if the server does not run yet."""
    server = server.root_server
    if server not in _doors:
        if server.running:
            raise ValueError("the server is already running, open to every page. Cure: View(haptics, server) before "
                             "server.start(), or volumehaptics.web.serve(haptics)")
        _doors[server] = Door(server, in_frames)
    return _doors[server]
