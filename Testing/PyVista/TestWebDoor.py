# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Only a page that has the server's secret may move the hand and see the volume: one page at a time, and only while
that page answers. The attackers are a real Chromium with a page of another origin, and clients that are written here
after the description of wslink's frames (github.com/Kitware/wslink, python/src/wslink/chunking.py): a number, the
offset of the part, and the size of the whole message, each in 4 bytes, least significant first, then MessagePack."""

import asyncio
import contextlib
import functools
import http.server
import os
import re
import secrets
import shutil
import threading
import time
import warnings
from pathlib import Path

import pytest
import volumehaptics

web = pytest.importorskip("volumehaptics.web", reason="needs trame: pip install trame trame-vuetify trame-rca")
import aiohttp  # noqa: E402
import msgpack  # noqa: E402
from volumehaptics import _webdoor, _webview  # noqa: E402

PATIENCE = 60.0  # s; no test depends on how long it takes
CHROMIUM, DRIVER = shutil.which("chromium"), shutil.which("chromedriver")


def frame(content, size=None, place=0):
    data = content if isinstance(content, bytes) else msgpack.packb(content)
    return b"".join([secrets.token_bytes(4), place.to_bytes(4, "little"),
                     (len(data) if size is None else size).to_bytes(4, "little"), data])


class Client:
    """A client that pretends to be a page; it answers the server while `answers` is true."""

    def __init__(self, socket):
        self.socket = socket
        self.answers = True
        self.errors = []
        self.pictures = 0
        self.closed_with = None
        self.template = ""
        self.view = None
        self._numbers = iter(range(1, 1 << 30))
        self._waiting = {}
        self._task = asyncio.get_running_loop().create_task(self._run())

    async def _run(self):
        async for message in self.socket:
            if message.type != aiohttp.WSMsgType.BINARY:
                continue
            try:
                told = msgpack.unpackb(message.data[12:])
            except ValueError:
                continue  # skip a part of a picture
            waiting = self._waiting.pop(told.get("id"), None)
            if waiting is not None:
                waiting.set_result(told)
            elif "stream" in told.get("id", ""):
                self.pictures += 1
            elif self.answers and self.view is not None and isinstance(told.get("result"), dict):
                number = told["result"].get(f"{self.view.name}_ping")
                if number is not None:
                    await self.send("trame.trigger", self.trigger, [number], {})
        self.closed_with = self.socket.close_code

    async def send(self, method, *args, kind="rpc"):
        number = f"{kind}:c0:{next(self._numbers)}"
        await self.socket.send_bytes(frame({"wslink": "1.0", "id": number, "method": method, "args": list(args)}))
        return number

    async def call(self, method, *args, kind="rpc"):
        future = asyncio.get_running_loop().create_future()
        self._waiting[await self.send(method, *args, kind=kind)] = future
        return await asyncio.wait_for(future, PATIENCE)

    async def hello(self, secret):
        return await self.call("wslink.hello", {"secret": secret}, kind="system")

    async def show(self, view):
        """Connects as a page of the view does."""
        assert "result" in await self.hello(view._door.secret)
        state = (await self.call("trame.state.get"))["result"]["state"]
        self.trigger = re.search(r"trigger\('([^']+)', \[" + view.name + "_ping", state[f"trame__template_{view.page}"]).group(1)
        self.view = view
        return self

    async def act(self, kind, **event):
        return await self.call("trame.rca.event", self.view.name, "anonymous", {"type": kind, **event})

    async def size(self, width, height):
        return await self.call("trame.rca.size", self.view.name, "anonymous", {"w": width, "h": height, "p": 1})


async def wait(holds, what):
    end = time.monotonic() + PATIENCE
    while not holds():
        assert time.monotonic() < end, what
        await asyncio.sleep(0.01)


def serving(haptics, steps):
    """Runs steps(view, connect) beside the server of a notebook."""
    async def run():
        shown = await web.show(haptics)
        async with aiohttp.ClientSession() as session:
            async def connect(**headers):
                return Client(await session.ws_connect(f"http://localhost:{shown.view.server.port}/ws", headers=headers))

            try:
                await asyncio.wait_for(steps(shown.view, connect), 3 * PATIENCE)
            finally:
                shown.view.close()
                await shown.view.server.stop()

    asyncio.run(run())


def is_armed(haptics):
    return "100 % of the force" in haptics.device.GetStatusText()


def force(haptics):
    return sum(x * x for x in haptics.device.GetState().GetForce()) ** 0.5


async def press(client, haptics, where=(0.5, 0.5), size=(200, 200), steps=4):
    """Touches the middle of the ball, and presses."""
    w, h = size
    await client.act("MouseMove", x=where[0] * w, y=where[1] * h, w=w, h=h)
    await client.act("KeyDown", key="t", w=w, h=h)
    await wait(lambda: is_armed(haptics), "it does not arm")
    for _ in range(steps):
        await client.act("MouseWheel", spinY=-1, w=w, h=h)
    await wait(lambda: force(haptics) > 0.01, "the wheel does not press")


def test_nobody_enters_without_the_secret(window, hands):
    haptics = hands().haptics
    known = []

    async def steps(view, connect):
        known.append(view._door.secret)
        for guess in ("wslink-secret", "", None, 0, True, [], view._door.secret[:-1], view._door.secret + "0", "\ud800" * 9):
            client = await connect()
            try:
                answer = await client.hello(guess)
            except UnicodeEncodeError:
                continue
            assert "error" in answer, guess
            for method, args in (("trame.state.get", ()), ("trame.rca.event", (view.name, "", {"type": "KeyDown", "key": "t"})),
                                 ("trame.state.update", ([{"key": f"{view.name}_method", "value": "force-field"}],)),
                                 ("application.exit", ())):
                assert "error" in await client.call(method, *args)
            view.draw()
            await asyncio.sleep(0.05)
            assert client.pictures == 0
        assert not haptics.style.GetTouchMode() and haptics.filter.GetMethodName() == "proxy"
        client = await (await connect()).show(view)
        await press(client, haptics)

    serving(haptics, steps)

    async def again(view, _connect):
        known.append(view._door.secret)

    serving(haptics, again)
    assert len(set(known)) == 2 and all(len(secret) >= 32 for secret in known)


def test_the_secret_is_compared_in_constant_time(window, hands, monkeypatch):
    compared = []
    original = _webdoor.hmac.compare_digest

    def compare(a, b):
        compared.append((a, b))
        return original(a, b)

    monkeypatch.setattr(_webdoor.hmac, "compare_digest", compare)

    async def steps(view, connect):
        await (await connect()).hello("guess")
        assert compared == [(b"guess", view._door.secret.encode())]

    serving(hands().haptics, steps)


@pytest.mark.parametrize(("host", "origin", "enters"), [
    ("localhost:{port}", None, True),
    ("localhost:{port}", "http://localhost:{port}", True),
    ("127.0.0.1:{port}", "http://127.0.0.1:{port}", True),
    ("[::1]:{port}", "http://[::1]:{port}", True),
    ("localhost:9999", "http://localhost:9999", True),  # the near end of ssh -L 9999:localhost:PORT
    ("localhost:{port}", "http://localhost:9999", False),  # another server on this computer
    ("localhost:{port}", "https://example.org", False),
    ("localhost:{port}", "null", False),  # a frame in a sandbox, a file
    ("localhost:{port}", "", False),
    ("localhost:{port}", "http://[::1", False),
    ("localhost:{port}", "http://localhost:{port}.example.org", False),
    ("example.org:{port}", "http://example.org:{port}", False),  # a name that resolves to this computer: DNS rebinding
    ("localhost.example.org", None, False),
    ("127.0.0.1.example.org", None, False),
    ("[::1", None, False),
    ("", None, False),
])
def test_hosts_and_origins(window, hands, host, origin, enters):
    async def steps(view, connect):
        port = view.server.port
        headers = {"Host": host.format(port=port)}
        if origin is not None:
            headers["Origin"] = origin.format(port=port)
        if enters:
            client = await connect(**headers)
            assert "result" in await client.hello(view._door.secret)
        else:
            with pytest.raises(aiohttp.WSServerHandshakeError) as refused:
                await connect(**headers)
            assert refused.value.status in (400, 403)

    serving(hands().haptics, steps)


def memory():
    """Returns the memory (MiB) that this process uses."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="asks Linux for the memory in use")
@pytest.mark.parametrize("known", [False, True])
def test_frames_that_lie(window, hands, known):
    """A frame of 13 bytes may declare a message of 4 GB."""
    haptics = hands().haptics

    async def steps(view, connect):
        before = memory()
        for lie in (frame(b"x", size=500 << 20), frame(b"x", size=400), frame(b"x" * 9, size=3), frame(b"x", place=12),
                    frame(b"x", size=0), frame(b""), b"", b"x" * 11, frame(b"x" * 100_000)):
            client = await connect()
            if known:
                assert "result" in await client.hello(view._door.secret)
            for _ in range(6):
                with contextlib.suppress(ConnectionError):
                    await client.socket.send_bytes(lie)
            await wait(lambda client=client: client.closed_with is not None, "the connection stays open")
            assert client.closed_with == 1009
        client = await connect()
        await client.socket.send_str("no frame")
        await wait(lambda: client.closed_with is not None, "the connection stays open")
        assert memory() - before < 100

        # Send valid messages with invalid values.
        client = await (await connect()).show(view)
        await press(client, haptics)
        size, place = view.window.GetSize(), view.interactor.GetEventPosition()
        for lie in (float("nan"), float("inf"), -1e300, 1 << 40, "9", None, [], {}, True):
            await client.act("MouseMove", x=lie, y=lie, w=lie, h=lie)
            await client.act("MouseWheel", spinY=float("nan"))
            await client.act("KeyDown", key=[lie])
            await client.call("trame.rca.size", view.name, "", {"w": lie, "h": lie, "p": lie})
            await client.call("trame.rca.event", view.name, "", lie)
            await client.call("trame.rca.event", view.name, "", {"type": lie})
            await client.call("trame.trigger", client.trigger, [lie], {})
            await client.call("trame.state.update", [{"key": f"{view.name}_method", "value": lie},
                                                    {"key": f"{view.name}_preset", "value": lie}])
        await client.call("trame.state.update", [{"key": f"{view.name}_preset", "value": "/etc/passwd.json"}])
        await asyncio.sleep(0.1)
        assert view.window.GetSize() == size and view.interactor.GetEventPosition() == place
        await client.size(1e8, 1)
        assert max(view.window.GetSize()) <= 8192
        assert haptics.filter.GetMethodName() == "proxy"
        assert haptics.style.GetTouchMode() and force(haptics) > 0.01

    serving(haptics, steps)


def test_one_page_leads(window, hands):
    haptics = hands().haptics

    async def steps(view, connect):
        first, second = await (await connect()).show(view), await (await connect()).show(view)
        await press(first, haptics)
        before, size = haptics.device.GetState().GetTipPosition(), view.window.GetSize()
        # While the first page leads, the second page must not be able to move, press, arm, choose a method or resize.
        await second.size(500, 300)
        await second.act("MouseMove", x=450, y=20, w=500, h=300)
        for event in (dict(kind="MouseWheel", spinY=-1), dict(kind="KeyDown", key="t"), dict(kind="KeyDown", key="m"),
                      dict(kind="LeftButtonPress", x=450, y=20, w=500, h=300)):
            await second.act(**event)
        await second.call("trame.state.update", [{"key": f"{view.name}_method", "value": "force-field"}])
        await asyncio.sleep(0.2)
        assert haptics.filter.GetMethodName() == "proxy" and view.window.GetSize() == size
        assert haptics.device.GetState().GetTipPosition() == pytest.approx(before, abs=1e-6)
        assert view.server.state[f"{view.name}_method"] == "proxy"  # the second page shows the actual method
        assert haptics.style.GetTouchMode() and force(haptics) > 0.01
        # When the second page closes, the first page must keep the touch.
        await second.socket.close()
        await asyncio.sleep(0.1)
        assert haptics.style.GetTouchMode()
        # Any page must be able to end the touch.
        third = await (await connect()).show(view)
        await third.act("KeyDown", key="Escape")
        assert not haptics.style.GetTouchMode()
        await wait(lambda: force(haptics) == 0.0, "Escape of another page does not let go")
        # Then the third page can start the touch, and the first page's keys have no effect.
        await press(third, haptics)
        await first.act("KeyDown", key="m")
        assert haptics.filter.GetMethodName() == "proxy"

    serving(haptics, steps)


@pytest.mark.parametrize("way", ["closes", "breaks", "stands still"])
def test_the_hand_lets_go_of_a_page_that_is_gone(window, hands, monkeypatch, way):
    """The hand lets go, whether or not other pages answer."""
    monkeypatch.setattr(_webview, "SILENCE", 1.5)
    haptics = hands().haptics

    async def steps(view, connect):
        first, second = await (await connect()).show(view), await (await connect()).show(view)
        await press(first, haptics)
        if way == "closes":
            await first.socket.close()
        elif way == "breaks":
            first.socket._response.connection.transport.abort()
        else:
            first.answers = False
        await wait(lambda: not haptics.style.GetTouchMode(), "it goes on pressing")
        await wait(lambda: force(haptics) == 0.0, "it goes on pressing")
        assert second.closed_with is None
        # Events that the silent page sends when it wakes up must not move the hand.
        if way == "stands still":
            await first.act("MouseWheel", spinY=-1)
            await asyncio.sleep(0.1)
            assert force(haptics) == 0.0

    serving(haptics, steps)


def test_a_page_that_takes_nothing_stops_no_other(window, hands, monkeypatch):
    """The page acts like a computer that sleeps: wslink sends to one page after the other, and waits for each."""
    monkeypatch.setattr(_webview, "UNANSWERED", 2)
    haptics = hands().haptics

    async def steps(view, connect):
        first, second = await (await connect()).show(view), await (await connect()).show(view)
        await press(first, haptics)
        await wait(lambda: len(view._heard) == 2, "not both answer")
        second._task.cancel()  # it stops reading
        await wait(lambda: len(view._heard) == 1, "it stays")
        pictures = first.pictures
        await first.act("MouseWheel", spinY=-1)
        await wait(lambda: first.pictures > pictures, "the other one gets nothing")
        assert haptics.style.GetTouchMode() and force(haptics) > 0.01

    serving(haptics, steps)


@pytest.mark.parametrize("is_second", (False, True))
def test_a_page_that_arms_a_device_holds_it(window, hands, monkeypatch, is_second):
    """The touch mode is off, as when the server's user holds a device."""
    monkeypatch.setattr(_webview, "SILENCE", 1.5)
    second = volumehaptics.vtkHapticDevice()
    assert second.Open("virtual")
    haptics = hands(device=["virtual", second]).haptics
    device = second if is_second else haptics.device

    async def steps(view, connect):
        first, second = await (await connect()).show(view), await (await connect()).show(view)
        await first.act("MouseMove", x=10, y=10, w=200, h=200)
        device.Arm()  # the program arms it for the server's user
        assert device.IsArmOrdered() and not haptics.style.GetTouchMode()
        first.answers = False
        await wait(lambda: not device.IsArmOrdered(), "force stays on")
        assert device.GetAttentionTime() == 1.5
        assert second.closed_with is None

    serving(haptics, steps)


def test_each_page_has_a_mouse_of_its_size(window, hands):
    """A relative position in the picture is the same place of the scene, whatever the size of the page's picture."""
    haptics = hands().haptics

    async def steps(view, connect):
        small, large = await (await connect()).show(view), await (await connect()).show(view)
        await large.size(800, 600)
        await small.size(200, 150)
        for client, (w, h) in ((small, (200, 150)), (large, (800, 600)), (small, (200, 150))):
            await client.act("MouseMove", x=0.25 * w, y=0.75 * h, w=w, h=h)
            wide, high = view.window.GetSize()
            await wait(lambda wide=wide, high=high: view.interactor.GetEventPosition() == pytest.approx(
                (0.25 * wide, 0.75 * high), abs=1), "the pointer is elsewhere")
        # While a page leads, the window must have this page's size.
        await press(large, haptics, size=(800, 600))
        assert view.window.GetSize() == (800, 600)

    serving(haptics, steps)


def test_the_network_is_warned_of(window, hands, monkeypatch):
    async def steps(host):
        from trame.app import get_server

        server = get_server(f"network-{host}", client_type="vue3")
        view = web.View(hands().haptics, server, "main")
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            server.start(exec_mode="task", port=0, host=host, open_browser=False, disable_logging=True, timeout=0)
            await server.ready
        async with aiohttp.ClientSession() as session:
            client = Client(await session.ws_connect(f"http://127.0.0.1:{server.port}/ws"))
            assert "error" in await client.hello("wslink-secret")
            async with session.get(f"http://127.0.0.1:{server.port}/index.html") as page:
                assert page.headers["Content-Security-Policy"] == "frame-ancestors 'none'"
                assert view._door.secret not in await page.text()
        view.close()
        await server.stop()
        return [str(one.message) for one in told if "to the whole network" in str(one.message)]

    assert not asyncio.run(steps("localhost"))
    told = asyncio.run(steps("0.0.0.0"))
    assert len(told) == 1 and "ssh -L" in told[0]


def test_a_server_that_is_open_already_is_refused(window, hands):
    async def steps():
        from trame.app import get_server

        server = get_server("open", client_type="vue3")
        server.start(exec_mode="task", port=0, host="localhost", open_browser=False, disable_logging=True, timeout=0)
        await server.ready
        with pytest.raises(ValueError, match="before server.start"):
            web.View(hands().haptics, server)
        await server.stop()

    asyncio.run(steps())


# -- tests in a real browser --

ATTACK = """<!doctype html><title>waiting</title><iframe id="frame" src="http://localhost:{port}/index.html"></iframe><script>
const told = [];
const tell = (word) => {{ told.push(word); if (told.length === 4) document.title = "told " + told.sort().join(" "); }};
for (const [name, url] of [["a", "ws://localhost:{port}/ws"], ["b", "ws://127.0.0.1:{port}/ws"]]) {{
  const socket = new WebSocket(url);
  socket.onopen = () => tell(name + ":open");
  socket.onerror = () => tell(name + ":refused");
}}
fetch("http://localhost:{port}/index.html").then((r) => r.text()).then(() => tell("c:read"), () => tell("c:refused"));
fetch("http://localhost:{port}/index.html", {{method: "POST", mode: "no-cors", body: "x"}})
  .then(() => tell("d:sent"), () => tell("d:refused"));
</script>"""


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


@pytest.fixture
def chromium(tmp_path):
    webdriver = pytest.importorskip("selenium.webdriver", reason="pip install selenium")
    if not (CHROMIUM and DRIVER):
        pytest.skip("needs chromium and chromium-driver")
    options = webdriver.ChromeOptions()
    options.binary_location = CHROMIUM
    for word in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--window-size=700,560",
                 "--host-resolver-rules=MAP *.example 127.0.0.1", f"--user-data-dir={tmp_path / 'chromium'}"):
        options.add_argument(word)
    driver = webdriver.Chrome(options=options, service=webdriver.ChromeService(executable_path=DRIVER))
    yield driver
    driver.quit()


def test_another_origin_has_no_access(window, hands, chromium, tmp_path):
    haptics = hands().haptics

    async def steps(view, _connect):
        (tmp_path / "pages").mkdir()
        (tmp_path / "pages" / "attack.html").write_text(ATTACK.format(port=view.server.port), encoding="utf-8")
        other = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=str(tmp_path / "pages")))
        threading.Thread(target=other.serve_forever, daemon=True).start()
        try:
            for name in ("localhost", "127.0.0.1", "attack.example"):
                await asyncio.to_thread(chromium.get, f"http://{name}:{other.server_port}/attack.html")
                await wait(lambda: chromium.title.startswith("told"), "the page tells nothing")
                assert chromium.title in ("told a:refused b:refused c:refused d:sent", "told a:refused b:refused c:refused d:refused")
            # Open the page under another host name that resolves to this server.
            await asyncio.to_thread(chromium.get, f"http://attack.example:{view.server.port}/index.html")
            assert "is not called" in chromium.page_source
            # Open the server's own page without the secret, then with the secret, then reload it as F5 does.
            await asyncio.to_thread(chromium.get, f"http://localhost:{view.server.port}/index.html?ui={view.page}")
            assert "needs the secret" in chromium.find_element("tag name", "body").text
            assert not view._sizes
            await asyncio.to_thread(chromium.get, view.get_address())
            await wait(lambda: view._sizes, "its own page does not come")
            assert view._door.secret not in chromium.current_url
            before = set(view._sizes)
            await asyncio.to_thread(chromium.refresh)
            await wait(lambda: set(view._sizes) - before, "loaded anew, its own page does not come")
        finally:
            await asyncio.to_thread(chromium.get, "about:blank")
            other.shutdown()
            other.server_close()

    serving(haptics, steps)


def test_a_page_that_stalls_is_let_go_of(window, hands, chromium):
    """Opens a real page whose script stalls for 8 s, beside a page that answers."""
    stall = 8.0
    haptics = hands().haptics

    async def steps(view, connect):
        await asyncio.to_thread(chromium.get, view.get_address())
        other = await (await connect()).show(view)
        await wait(lambda: len(view._sizes) == 1, "no page")
        await wait(lambda: chromium.find_elements("css selector", "[data-id=touch]"), "no button")
        await asyncio.to_thread(chromium.find_element("css selector", "[data-id=touch]").click)
        await wait(lambda: is_armed(haptics), "it does not arm")
        assert view.leader is not None
        script = f"const end = Date.now() + {1000 * stall}; while (Date.now() < end);"
        stalled, start = asyncio.create_task(asyncio.to_thread(chromium.execute_script, script)), time.monotonic()
        await wait(lambda: not haptics.style.GetTouchMode(), "it goes on")
        print(f"let go after {time.monotonic() - start:.2f} s, {'still' if not stalled.done() else 'no longer'} stalled")
        assert other.closed_with is None and other.pictures > 0
        await wait(lambda: force(haptics) == 0.0, "it goes on pressing")
        await stalled
        await asyncio.to_thread(chromium.get, "about:blank")

    serving(haptics, steps)
