#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the figures of Documentation/method.md, each from traces of the filter and from the closed form beside them.

usage: method.py [FOLDER]

Writes method-*.png to FOLDER, by default the folder of this script, and prints how far the traces are from the closed
forms. Needs the package volumehaptics, NumPy and Matplotlib.
"""

import math
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import volumehaptics
from volumehaptics import vtkHapticProperty, vtkVolumeHapticsFilter
from volumehaptics.arrays import arrays

PAPER, PRECISE = vtkVolumeHapticsFilter.PAPER, vtkVolumeHapticsFilter.PRECISE
NAMES = {PAPER: "PAPER", PRECISE: "PRECISE"}
COLOURS = {PAPER: "#e0701a", PRECISE: "#1f6fb4"}
FORM = dict(color="black", linewidth=1.0, linestyle=(0, (5, 3)), label="closed form", zorder=5)
STIFFNESS = 500.0  # N/m, so that a millimetre is half a newton
PER_MILLIMETRE = STIFFNESS / 1000.0


def material(**functions):
    """The same everywhere, unless a function has points [(value, result), ...]; every gradient is a surface."""
    made = vtkHapticProperty()
    for name, points in ({"Stiffness": STIFFNESS} | functions).items():
        function = getattr(made, f"Get{name}")()
        function.RemoveAllPoints()
        for point in points if isinstance(points, list) else [(0.0, points)]:
            function.AddPoint(*point)
    made.DistinctnessFromNoiseOff()
    made.GetDistinctness().RemoveAllPoints()
    made.GetDistinctness().AddPoint(0.0, 1.0)
    return made


def grid(half, spacing=1.0):
    """Coordinates x, y, z (mm) of the samples of a cube about the origin, and the settings of its image."""
    axis = np.arange(-half, half + spacing / 2, spacing)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    return (x, y, z), dict(spacing=(spacing,) * 3, origin=(-half,) * 3)


def feel(image, tip, solver, **settings):
    return arrays(volumehaptics.touch(image, np.asarray(tip, float), solver=solver, **settings))


def figure(width, height, columns=1):
    made, axes = plt.subplots(1, columns, figsize=(width, height), dpi=110, layout="constrained", squeeze=False)
    for axis in axes[0]:
        axis.spines[["top", "right"]].set_visible(False)
    return made, axes[0]


def press():
    """Pressed into what rises evenly: the surface gives way at its strength, and lets go without resistance."""
    (_, _, z), place = grid(16.0)
    slab = volumehaptics.image(100.0 * z, **place)
    depth = np.concatenate([np.linspace(0, 8, 801), np.linspace(8, 0, 801)[1:]])
    tip = np.column_stack([0 * depth, 0 * depth, depth])
    strength = 2.0
    given = np.maximum(np.maximum.accumulate(depth) - strength / PER_MILLIMETRE, 0)  # where the proxy was pushed to
    form = PER_MILLIMETRE * np.maximum(depth - given, 0)
    made, (axis, lateral) = figure(10, 3.9, 2)
    worst = {}
    for solver in (PAPER, PRECISE):
        force = feel(slab, tip, solver, property=material(SurfaceStrength=strength))["NormalForce"]
        worst[solver] = np.abs(force - form).max()
        axis.plot(depth, force, color=COLOURS[solver], linewidth=5 if solver == PAPER else 2.2, label=NAMES[solver])
    axis.plot(depth, form, **FORM)
    axis.set(title="Eqs. 11 and 12: a surface of $T = 2$ N gives way", xlabel="depth of the tip (mm)",
             ylabel="normal force (N)")
    axis.annotate("pressed", (0.9, 1.3), fontsize=9)
    axis.annotate("withdrawn", (6.3, 0.9), fontsize=9)
    axis.legend(frameon=False, loc="center", bbox_to_anchor=(0.5, 0.55), fontsize=9)

    friction, deep = 0.4, 3.0
    way = np.concatenate([np.linspace(0, 5, 501), np.linspace(5, -5, 1001)[1:], np.linspace(-5, 0, 501)[1:]])
    down = np.linspace(0, deep, 301)
    tip = np.concatenate([np.column_stack([0 * down, 0 * down, down]),
                          np.column_stack([way, 0 * way, 0 * way + deep])])
    limit, lag = friction * deep, 0.0  # the spring along the surface holds mu times the normal one
    form = []
    for step in np.diff(way, prepend=0.0):
        lag = np.clip(lag + step, -limit, limit)
        form.append(PER_MILLIMETRE * lag)
    form = np.array(form)
    for solver in (PAPER, PRECISE):
        trace = feel(slab, tip, solver, property=material(SurfaceStrength=100.0, Friction=friction))
        force = -trace["Force"][len(down):, 0]
        worst[solver] = max(worst[solver], np.abs(force - form).max())
        lateral.plot(way, force, color=COLOURS[solver], linewidth=5 if solver == PAPER else 2.2, label=NAMES[solver])
    lateral.plot(way, form, **FORM)
    lateral.set(title=r"Eqs. 8 to 10: friction of $\mu = 0.4$, pressed with 1.5 N", xlabel="tip along the surface (mm)",
                ylabel="lateral force (N)")
    lateral.axhline(0, color="0.8", linewidth=0.8, zorder=0)
    for solver, error in worst.items():
        print(f"press, {NAMES[solver]}: within {error:.6f} N")
    return made


def curved():
    """A turn on a ball and one inside a cavity, 2 mm beyond the surface at 20 mm."""
    (x, y, z), place = grid(28.0)
    distance = np.sqrt(x * x + y * y + z * z)
    made, axes = figure(10, 3.9, 2)
    for axis, name, sign, radius in ((axes[0], "ball", -1.0, 18.0), (axes[1], "cavity", 1.0, 22.0)):
        image = volumehaptics.image(np.clip(100.0 * sign * (distance - 20.0), -800, 800), **place)
        turns = 3
        angle = np.linspace(0, 2 * math.pi * turns, 1000 * turns + 1)
        entry = np.linspace(20.0, radius, 21)[:-1]
        tip = np.concatenate([np.column_stack([entry, 0 * entry, 0 * entry]),
                              radius * np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])])
        # PAPER goes along the tangent in each tick, and so a little outward.
        drift = 20.0 / math.cos(2 * math.pi / 1000) ** np.arange(len(angle))
        for solver, proxy in ((PAPER, drift), (PRECISE, np.full(len(angle), 20.0))):
            form = PER_MILLIMETRE * np.abs(proxy - radius)
            force = np.linalg.norm(
                feel(image, tip, solver, property=material(SurfaceStrength=1000.0))["Force"], axis=1)[len(entry):]
            print(f"{name}, {NAMES[solver]}: within {np.abs(force - form).max():.6f} N")
            axis.plot(angle / (2 * math.pi), force, color=COLOURS[solver], linewidth=3.5, label=NAMES[solver])
            axis.plot(angle / (2 * math.pi), form, **FORM | {"label": "closed form" if solver == PRECISE else None})
        axis.set(title=f"A tip led around a {name}, 2 mm beyond the surface", xlabel="turns", ylabel="force (N)",
                 ylim=(0, 1.75))
    axes[0].legend(frameon=False, fontsize=9)
    return made


def surfaces():
    """The proxy of eqs. 2 to 7 on a section of a ball, and where materials are picked (the paper's figure 4)."""
    (x, y, z), place = grid(28.0)
    shape = lambda distance: 500.0 * (1 + np.tanh((20.0 - distance) / 1.5))
    ball = volumehaptics.image(shape(np.sqrt(x * x + y * y + z * z)), **place)
    angle = np.radians(np.linspace(160, 20, 1401))
    radius = 24.0 - 8.0 * np.sin(np.linspace(0, math.pi, len(angle)))
    tip = np.column_stack([radius * np.cos(angle), radius * np.sin(angle), 0 * angle])
    kernel = 2.0
    made = material(SurfaceStrength=1000.0)
    made.GetDistinctness().RemoveAllPoints()
    made.GetDistinctness().AddPoint(20.0, 0.0)
    made.GetDistinctness().AddPoint(60.0, 1.0)
    trace = feel(ball, tip, PRECISE, property=made, kernel_radius=int(kernel))
    proxy, normal = np.array(trace["Proxy"]), np.array(trace["Normal"])
    held = np.linalg.norm(tip - proxy, axis=1) > 1e-6
    off = np.abs(np.linalg.norm(proxy[held], axis=1) - 20.0).max()
    print(f"surfaces: the proxy is within {off:.6f} mm of the surface")

    made, (axis,) = figure(8.4, 3.6)
    across, up = np.meshgrid(np.linspace(-26, 26, 521), np.linspace(3, 29, 261))
    axis.imshow(shape(np.hypot(across, up)), extent=(-26, 26, 3, 29), origin="lower", cmap="Greys", vmin=-100,
                vmax=3000, interpolation="bilinear")
    axis.plot(tip[:, 0], tip[:, 1], color="#b13a7c", linewidth=1.8, label="tip")
    axis.plot(proxy[:, 0], proxy[:, 1], color=COLOURS[PRECISE], linewidth=2.6, label="proxy")
    for tick in np.flatnonzero(held)[40:-40:70]:
        axis.plot(*np.column_stack([tip[tick, :2], proxy[tick, :2]]), color="0.35", linewidth=0.8)
    tick = int(np.flatnonzero(held)[int(0.63 * held.sum())])
    at, inward = proxy[tick, :2], normal[tick, :2]
    along = np.array([-inward[1], inward[0]])
    axis.plot(*np.column_stack([at - 9 * along, at + 9 * along]), color="#2a9d4f", linewidth=1.6, label="virtual surface")
    axis.annotate("", at + 5 * inward, at, arrowprops=dict(arrowstyle="-|>", color="#2a9d4f", linewidth=1.6))
    axis.annotate("$N$", at + 5.6 * inward, color="#2a9d4f", ha="center", va="center")
    axis.add_patch(plt.Circle(at, kernel, fill=False, color="0.2", linestyle=":", linewidth=1.2))
    for point, name, side in ((at, "$x_p$", (7, -3)), (tip[tick, :2], r"$x_{\mathrm{tip}}$", (-30, -4)),
                              (at + kernel * inward, "$x_s$", (6, -6)), (at - kernel * inward, "$x_v$", (6, 2))):
        axis.plot(*point, "o", color="black", markersize=4, zorder=6)
        axis.annotate(name, point, xytext=side, textcoords="offset points", zorder=6)
    axis.set(xlabel="mm", ylabel="mm", aspect="equal", xlim=(-26, 26), ylim=(6, 25))
    axis.legend(frameon=True, framealpha=0.9, loc="upper left", fontsize=9)
    return made


def edge():
    """A blurred edge, and where the proxy is held on it with either contact alignment."""
    (_, _, z), place = grid(16.0)
    blur, low, high = 2.0, -1000.0, 600.0  # mm, HU
    error = np.vectorize(math.erf)
    shape = lambda at: low + (high - low) * (1 + error(at / (blur * math.sqrt(2)))) / 2
    image = volumehaptics.image(shape(z), **place)
    steepest = (high - low) / (blur * math.sqrt(2 * math.pi))
    made = material(SurfaceStrength=[(low, 0.0), (low + 1, 5.0)], Friction=0.0)
    made.GetDistinctness().RemoveAllPoints()
    made.GetDistinctness().AddPoint(0.05 * steepest, 0.0)
    made.GetDistinctness().AddPoint(0.2 * steepest, 1.0)
    depth = np.linspace(-14, 8, 4401)
    tip = np.column_stack([0 * depth, 0 * depth, depth])
    at = np.linspace(-9, 9, 901)

    drawn, (axis, force) = figure(10, 4.1, 2)
    axis.plot(at, (shape(at) - low) / (high - low), color="0.25", linewidth=2.2, label="$V$, from 0 to 1")
    slope = np.exp(-at**2 / (2 * blur**2))
    axis.plot(at, slope, color="#6b57b8", linewidth=1.6, label="$|g|$, of its largest")
    axis.plot(at, np.clip((slope - 0.05) / 0.15, 0, 1), color="#2a9d4f", linewidth=1.6, label="$W_d$")
    for alignment, name, colour in ((vtkVolumeHapticsFilter.DISTINCTNESS, "Distinctness", COLOURS[PAPER]),
                                    (vtkVolumeHapticsFilter.EDGE, "Edge", COLOURS[PRECISE])):
        trace = feel(image, tip, PRECISE, property=made, contact_alignment=alignment)
        normal, proxy = np.array(trace["NormalForce"]), np.array(trace["Proxy"])
        pressed = int(np.argmax(normal >= 1.0))
        place = proxy[pressed, 2]
        print(f"edge, {name}: at 1 N the proxy is at {place:.3f} mm, {100 * (shape(place) - low) / (high - low):.2f} %")
        axis.axvline(place, color=colour, linewidth=1.6, linestyle="--", label=f"proxy at 1 N, {name}")
        force.plot(depth, normal, color=colour, linewidth=2.2, label=f"alignment {name}")
    force.plot(at, np.clip(PER_MILLIMETRE * at, 0, None), **FORM | {"label": "a wall in the middle of the edge"})
    axis.set(title="A blurred edge, and where the proxy rests on it", xlabel="depth (mm), 0 in the middle",
             ylabel="share",
             xlim=(-8, 19))
    axis.legend(frameon=False, fontsize=8, loc="center right")
    force.set(title="The force of a press", xlabel="depth of the tip (mm)", ylabel="normal force (N)", xlim=(-9, 8))
    force.legend(frameon=False, fontsize=9)
    return drawn


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
    folder = folder if folder.is_dir() else folder.parent
    for name, draw in (("surfaces", surfaces), ("press", press), ("curved", curved), ("edge", edge)):
        made = draw()
        made.savefig(folder / f"method-{name}.png")
        plt.close(made)


main()
