"""The module as another program has it. Run by ctest, which says where it and the program are."""

import ast
import copy
import inspect
import json
import multiprocessing
import os
import pickle
import re
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import dapple
from dapple import _dapple

SOURCE = Path(__file__).resolve().parents[3]


def ramp():
    """A ramp with a coloured spot, uint8, (40, 60, 3)."""
    y, x = np.mgrid[:40, :60]
    picture = np.repeat((4 * x)[..., None], 3, axis=2)
    picture[(x - 15) ** 2 + (y - 20) ** 2 < 60, 1:] = 220, 40
    return picture.astype(np.uint8)


def grey():
    return ramp()[..., 0]


def program(*arguments):
    done = subprocess.run([os.environ["DAPPLE_PROGRAM"], *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def places(dots):
    return [dots.x.tobytes(), dots.y.tobytes(), dots.radius.tobytes(), dots.pen.tobytes()]


def same(image, **settings):
    return places(dapple.stipple(image, 300, **settings))


@pytest.mark.parametrize(
    "ending, options, settings",
    [
        ("csv", "--dots 3000", {"dots": 3000}),
        ("csv", "--dots 900 --pens cmyk", {"dots": 900, "pens": "cmyk"}),
        ("svg", "--dots 900 --pens cmyk", {"dots": 900, "pens": "cmyk"}),
        ("json", "--dots 500 --detail 0.4", {"dots": 500, "tone": {"detail": 0.4}}),
        ("plt", "--dots 500 --page a4", {"dots": 500, "page": {"paper": "A4"}}),
        ("nc", "--dots 500 --gcode laser", {"dots": 500, "saving": {"gcode_tool": "laser"}}),
        ("dxf", "--dots 500 --style line", {"dots": 500, "style": "line"}),
    ],
)
def test_files_are_the_programs_byte_for_byte(tmp_path, ending, options, settings):
    picture, theirs, ours = tmp_path / "ramp.png", tmp_path / f"theirs.{ending}", tmp_path / f"ours.{ending}"
    Image.fromarray(ramp()).save(picture)
    program("render", picture, "-o", theirs, *options.split())
    dots = dapple.stipple(ramp(), **settings)
    dots.save(ours)
    assert ours.read_bytes() == theirs.read_bytes()
    assert not list(tmp_path.glob("*.part"))
    if ending == "csv":
        table = np.genfromtxt(theirs, delimiter=",", names=True, usecols=(0, 1, 2))
        for name, array in ("x_mm", dots.x), ("y_mm", dots.y), ("radius_mm", dots.radius):
            np.testing.assert_allclose(array, table[name], rtol=3e-7)


def test_a_png_has_the_programs_pixels_and_its_settings(tmp_path):
    picture, theirs, ours = tmp_path / "ramp.png", tmp_path / "theirs.png", tmp_path / "ours.png"
    Image.fromarray(ramp()).save(picture)
    program("render", picture, "-o", theirs, "--dots", 900, "--dpi", 60, "--pens", "cmyk")
    dots = dapple.stipple(ramp(), 900, pens="cmyk", saving={"dpi": 60})
    dots.save(ours)
    with Image.open(theirs) as want, Image.open(ours) as have:
        assert np.array_equal(np.asarray(have), np.asarray(want))
        assert np.array_equal(np.asarray(have), dots.pixels())
        assert have.info["dpi"] == want.info["dpi"]
        assert have.info["dapple"] == want.info["dapple"]
    program("render", picture, "-o", tmp_path / "again.csv", "--settings-from", ours)
    dots.save(tmp_path / "dots.csv")
    assert (tmp_path / "again.csv").read_bytes() == (tmp_path / "dots.csv").read_bytes()
    assert dots._repr_png_().startswith(b"\x89PNG")


def test_a_drawing_tells_its_dots_pens_and_page():
    dots = dapple.stipple(ramp(), 2000, pens="cmyk", page={"width_mm": 90})
    assert len(dots) == 2000
    assert dots.page_mm == pytest.approx((90, 60))
    assert [(a.dtype, a.shape) for a in (dots.x, dots.y, dots.radius, dots.pen)] == [
        (np.float32, (2000,)),
        (np.float32, (2000,)),
        (np.float32, (2000,)),
        (np.int32, (2000,)),
    ]
    assert dots.x is dots.x and not dots.x.flags.writeable
    assert 0 <= dots.x.min() and dots.x.max() <= 90 and dots.radius.min() > 0
    assert (dots.x < 30).sum() > 2 * (dots.x > 60).sum()  # where it is dark
    assert set(np.unique(dots.pen)) <= set(range(4))
    assert [pen.name for pen in dots.pens] == ["Yellow", "Cyan", "Magenta", "Black"]
    assert repr(dots) == "<2000 dots on 90 x 60 mm by Yellow, Cyan, Magenta, Black>"
    assert dots.pixels(25.4).shape == (60, 90, 3)
    crowded = dapple.stipple(grey(), 9000, dot_size={"sizing": "fixed", "radius_mm": 2})
    assert "overlap" in [advice.kind for advice in crowded.advice("gcode")]


def test_settings_come_as_keywords_as_a_project_and_as_its_text():
    want = same(ramp(), tone={"contrast": 0.2}, page={"width_mm": 90})
    project = {"drawing": {"tone": {"contrast": 0.2}, "count": 5}, "picture": {"path": "x.png"}}
    assert same(ramp(), settings=project, page={"width_mm": np.float64(90)}) == want
    assert same(ramp(), settings=json.dumps(project), page={"width_mm": np.int32(90)}) == want
    assert len(dapple.stipple(ramp(), settings=project)) == 5
    assert len(dapple.stipple(ramp(), np.int64(7))) == 7
    assert dapple.usual_settings()["drawing"]["count"] == len(dapple.stipple(ramp()))


def test_the_same_picture_gives_the_same_dots_in_any_array():
    want = same(ramp())
    wide = np.zeros((40, 120, 3), np.uint8)
    wide[:, ::2] = ramp()
    for image in (
        ramp().astype(np.uint16) * 257,
        np.asfortranarray(ramp()),
        np.ascontiguousarray(ramp()[::-1, ::-1])[::-1, ::-1],
        wide[:, ::2],
        np.dstack([ramp(), np.full((40, 60), 255, np.uint8)]),
        (ramp().astype(np.uint16) * 257).astype(">u2"),
        Image.fromarray(ramp()),
        Image.fromarray(ramp()).convert("RGBA"),
    ):
        assert same(image) == want
    want = same(ramp() / np.float32(255))
    assert same(np.float64(ramp()) / 255) == want

    want = same(grey())
    assert same(grey()[..., None]) == want
    assert same(Image.fromarray(grey())) == want
    assert same(Image.fromarray(grey()).convert("LA")) == want
    assert same(Image.fromarray(np.uint16(grey()) * 257)) == want  # mode I;16
    assert same(Image.fromarray(np.int32(grey()) * 257)) == want  # mode I
    two = grey() > 100
    assert same(two) == same(np.uint8(two) * 255) == same(Image.fromarray(two))


def test_colours_of_other_modes_are_those_that_they_show():
    few = np.array([[[255, 0, 0], [0, 0, 0]], [[0, 0, 0], [255, 0, 0]]], np.uint8).repeat(8, 0).repeat(8, 1)
    want = same(few, pens="cmyk")
    assert same(Image.fromarray(few).convert("P", palette=Image.Palette.ADAPTIVE), pens="cmyk") == want
    assert same(Image.fromarray(few).convert("CMYK"), pens="cmyk") == same(
        np.asarray(Image.fromarray(few).convert("CMYK").convert("RGB")), pens="cmyk"
    )


def test_what_is_transparent_shows_paper():
    see_through = np.dstack([grey(), np.where(np.arange(60) < 30, 0, 255)[None].repeat(40, 0)]).astype(np.uint8)
    paper = grey().copy()
    paper[:, :30] = 255
    assert same(see_through) == same(paper)
    keyed = Image.fromarray(np.where(paper == 255, 1, paper // 2 * 2).astype(np.uint8))
    keyed.info["transparency"] = 1
    assert same(keyed) == same(np.where(paper == 255, 255, paper // 2 * 2).astype(np.uint8))


def test_linear_light_is_what_the_encoded_picture_shows():
    encoded = np.float32(grey()) / 255
    light = np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)
    linear, srgb = (dapple.stipple(i, 900, linear=l, relax=0) for i, l in ((light, True), (encoded, False)))
    np.testing.assert_allclose(linear.x, srgb.x, atol=1e-3)
    assert same(light) != same(light, linear=True)


WRONG = [
    (lambda: dapple.stipple("cat.jpg"), TypeError, "image is of <U7; give uint8, uint16 or floats"),
    (lambda: dapple.stipple(None), TypeError, "image is of object"),
    (lambda: dapple.stipple([[0, 255]]), TypeError, "image is of int64"),
    (lambda: dapple.stipple(np.ones((4, 4), complex)), TypeError, "image is of complex128"),
    (lambda: dapple.stipple(np.float32(5)), ValueError, r"image has the shape \(\)"),
    (lambda: dapple.stipple(np.zeros(5)), ValueError, r"image has the shape \(5,\)"),
    (lambda: dapple.stipple(np.zeros((3, 20, 30))), ValueError, r"\(3, 20, 30\); give \(height, width\)"),
    (lambda: dapple.stipple(np.zeros((2, 2, 3, 1))), ValueError, r"image has the shape \(2, 2, 3, 1\)"),
    (lambda: dapple.stipple(np.zeros((4, 4, 0))), ValueError, r"image has the shape \(4, 4, 0\)"),
    (lambda: dapple.stipple(np.zeros((0, 0))), ValueError, "a picture of 0 x 0 pixels"),
    (lambda: dapple.stipple(np.zeros((5, 0, 3), np.uint8)), ValueError, "a picture of 0 x 5 pixels"),
    (lambda: dapple.stipple(np.full((4, 4), np.nan)), ValueError, "has the value nan"),
    (lambda: dapple.stipple(np.full((4, 4), np.nan), linear=True), ValueError, "not finite"),
    (lambda: dapple.stipple(np.full((4, 4), 1e300), linear=True), ValueError, "not finite"),
    (lambda: dapple.stipple(np.full((4, 4), 255.0)), ValueError, "has the value 255; .* within 0 to 1"),
    (lambda: dapple.stipple(np.full((4, 4), -0.5)), ValueError, "has the value -0.5"),
    (lambda: dapple.stipple(ramp(), linear=True), TypeError, "linear light is of floats"),
    (lambda: dapple.stipple(Image.fromarray(np.int32([[70000]]))), TypeError, "image is of int32"),
    (lambda: dapple.stipple(ramp(), 0), ValueError, "dots is 0; give a whole number from 1 to 10000000000"),
    (lambda: dapple.stipple(ramp(), -1), ValueError, "dots is -1"),
    (lambda: dapple.stipple(ramp(), True), TypeError, "dots is True; give a whole number"),
    (lambda: dapple.stipple(ramp(), 1e6), TypeError, "dots is 1000000.0; give a whole number"),
    (lambda: dapple.stipple(ramp(), "many"), TypeError, "dots is 'many'"),
    (lambda: dapple.stipple(ramp(), 10**10 + 1), ValueError, "dots is 10000000001"),
    (lambda: dapple.stipple(ramp(), 10**30), ValueError, "dots is 1000000"),
    (lambda: dapple.stipple(ramp(), threads=-1), ValueError, "threads is -1"),
    (lambda: dapple.stipple(ramp(), contrst=1), ValueError, "settings: drawing.contrst is not known"),
    (lambda: dapple.stipple(ramp(), tone={"contrast": 2}), ValueError, "settings: drawing.tone.contrast is 2"),
    (lambda: dapple.stipple(ramp(), tone=2), ValueError, "settings: drawing.tone"),
    (lambda: dapple.stipple(ramp(), tone={"gamma": np.nan}), ValueError, "settings: a number is infinite"),
    (lambda: dapple.stipple(ramp(), tone=Path("x")), TypeError, "settings: .* cannot be written as JSON"),
    (lambda: dapple.stipple(ramp(), saving={"dpi": "fine"}), ValueError, "settings: saving.dpi"),
    (lambda: dapple.stipple(ramp(), settings="{"), ValueError, "settings: line 1 is not JSON"),
    (lambda: dapple.stipple(ramp(), settings={"count": 5}), ValueError, "settings: count is not known"),
    (lambda: dapple.stipple(ramp(), settings=[5]), ValueError, "settings: "),
    (lambda: dapple.stipple(ramp(), tile="paper17"), ValueError, "settings: drawing.tile cannot be found"),
    (lambda: dapple.Stippler().draw(), ValueError, "there is no picture yet"),
    (lambda: dapple.Stippler().plan(), ValueError, "there is no picture yet"),
    (lambda: dapple.Stippler().set_density([[2.0]]), ValueError, "0 to 1"),
    (lambda: dapple.Stippler().set_density([[np.nan]]), ValueError, "0 to 1"),
    (lambda: dapple.Stippler().set_tile("a tile"), ValueError, "line 1"),
    (lambda: dapple.sample([[1.0, -1]], 5), ValueError, "negative or not finite"),
    (lambda: dapple.sample([[1.0, np.nan]], 5), ValueError, "negative or not finite"),
    (lambda: dapple.sample([[1.0, np.inf]], 5), ValueError, "negative or not finite"),
    (lambda: dapple.sample(np.zeros((0, 5)), 5), ValueError, "0 values for a density of 5 x 0"),
    (lambda: dapple.sample([1.0, 2], 5), ValueError, r"density has the shape \(2,\); give \(height, width\)"),
    (lambda: dapple.sample([[1.0]], 5, interpolation="cubic"), ValueError, "interpolation is 'cubic'; give"),
    (lambda: dapple.Stippler().set_density([[1.0]], interpolation=None), ValueError, "interpolation is None; give"),
    (lambda: dapple.sample("even", 5), TypeError, "density is of <U4; give an array of numbers"),
    (lambda: dapple.sample(np.ones((5, 5)), 0), ValueError, "n is 0; give a whole number from 1 to"),
    (lambda: dapple.lights(np.ones((4, 4, 3))), ValueError, "twice"),
    (lambda: dapple.lights(np.zeros((4, 8, 3))), ValueError, "light"),
    (lambda: dapple.lights(np.ones((4, 8))), ValueError, r"radiance has the shape \(4, 8\); give \(height, width, 3\)"),
    (lambda: dapple.lights(np.full((4, 8, 3), np.nan)), ValueError, "not a number"),
    (lambda: dapple.lights(np.ones((4, 8, 3)), 0), ValueError, "n is 0; give a whole number from 1 to 10000000"),
    (lambda: dapple.lights(np.ones((4, 8, 3)), seed=-1), ValueError, "seed is -1"),
    (lambda: dapple.lights(np.ones((4, 8, 3)), threads=2.5), TypeError, "threads is 2.5"),
    (lambda: dapple.analyse(np.zeros((5, 3))), ValueError, r"points has the shape \(5, 3\); give \(n, 2\)"),
    (lambda: dapple.analyse([[0.5, np.nan]]), ValueError, "points: point 1 is at"),
    (lambda: dapple.analyse([[0.5, 2]], periodic=False), ValueError, "outside the 1 x 1 window"),
    (lambda: dapple.analyse([[0.5, 0.5], [0.2, 0.1]], 0, 1), ValueError, "0 x 1 has no area"),
    (lambda: dapple.tile_text("paper17"), ValueError, "paper17 is not a built-in tile"),
    (lambda: dapple.tile_points("a tile"), ValueError, "line 1"),
    (lambda: dapple.stipple(ramp(), 9).pixels(0), ValueError, "0 pixels to the inch; give more than 0"),
    (lambda: dapple.stipple(ramp(), 9).pixels(np.nan), ValueError, "nan pixels to the inch"),
    (lambda: dapple.stipple(ramp(), 9).pixels(1e9), ValueError, "the page would be 78"),
    (lambda: dapple.stipple(ramp(), 9).advice("bmp"), ValueError, "bmp: not a format"),
    (lambda: dapple.stipple(ramp(), 9).save("x.bmp"), ValueError, "x.bmp: not a format"),
    (lambda: dapple.stipple(ramp(), 9).save("x"), ValueError, "x: not a format"),
    (lambda: dapple.stipple(ramp(), 9).save("/nowhere/x.svg"), FileNotFoundError, "'/nowhere/x.svg'$"),
    (lambda: dapple.stipple(ramp(), 9).save("/nowhere/x.png"), FileNotFoundError, "'/nowhere/x.png'$"),
    (lambda: dapple.stipple(ramp(), 9).save("/dev/full/x.svg"), NotADirectoryError, "'/dev/full/x.svg'$"),
]


@pytest.mark.parametrize("call, error, sentence", WRONG, ids=[f"{i}" for i in range(len(WRONG))])
def test_what_is_wrong_ends_in_one_sentence(call, error, sentence):
    with pytest.raises(error, match=sentence) as caught:
        call()
    assert type(caught.value) is error
    assert "\n" not in str(caught.value)


def test_a_file_that_cannot_be_written_leaves_what_was_there(tmp_path):
    dots = dapple.stipple(ramp(), 300)
    (tmp_path / "x.svg").mkdir()
    (tmp_path / "x.svg" / "old").touch()
    with pytest.raises(IsADirectoryError):
        dots.save(tmp_path / "x.svg")
    assert [file.name for file in tmp_path.iterdir()] == ["x.svg"]


def test_a_stippler_draws_as_stipple_does_and_says_what_it_will():
    stippler = dapple.Stippler(ramp(), threads=1)
    for contrast in 0.25, 0.5:
        settings = {"automatic_tone": False, "tone": {"contrast": contrast}, "pens": "cmyk"}
        dots = stippler.draw(300, **settings)
        assert places(dots) == same(ramp(), **settings)
        plan = stippler.plan(300, **settings)
        assert (plan.dots, plan.page_mm, plan.pens, plan.contrast) == (300, dots.page_mm, dots.pens, contrast)
    stippler.set_picture(grey())
    assert places(stippler.draw(300)) == same(grey())
    stippler.set_tile(dapple.tile_text("aperiodic64"))
    assert places(stippler.draw(300)) == same(grey(), tile="aperiodic64")


def test_threads_may_share_a_stippler():
    stippler, want, found = dapple.Stippler(ramp()), same(ramp()), []
    threads = [threading.Thread(target=lambda: found.append(places(stippler.draw(300)))) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [want] * 4


def test_other_threads_go_on_while_it_draws_and_an_interrupt_ends_it():
    stippler, here, over, handled = dapple.Stippler(ramp()), threading.get_ident(), threading.Event(), []

    def handler(*_):
        handled.append("while it draws")
        if len(handled) == 2:
            raise KeyboardInterrupt

    def draws():
        frame = sys._current_frames()[here]
        return frame.f_code is dapple.Stippler.draw.__code__ and frame.f_lineno > frame.f_code.co_firstlineno + 1

    # Only a thread that runs while the other one is in there sees it there, and what is handled there.
    def interrupt():
        for already in 0, 1:
            while not (draws() and len(handled) == already):
                if over.is_set():
                    return
                time.sleep(0.001)
            os.kill(os.getpid(), signal.SIGINT)

    before = signal.signal(signal.SIGINT, handler)
    thread = threading.Thread(target=interrupt)
    thread.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            stippler.draw(300_000, relax=100)
    finally:
        over.set()
        thread.join()
        signal.signal(signal.SIGINT, before)
    assert places(stippler.draw(300)) == same(ramp())


def test_points_are_as_dense_as_the_density_says():
    density = np.array([[1, 3], [0, 4], [5, 3]], np.uint8).repeat(20, 0).repeat(20, 1)
    points = dapple.sample(density, 8000)
    assert (points.dtype, points.shape) == (np.float32, (8000, 2))
    column, row = np.int64(points).T
    each = np.bincount(row // 20 * 2 + column // 20, minlength=6)
    np.testing.assert_allclose(each, 500 * np.array([1, 3, 0, 4, 5, 3]), atol=60)
    # Sums come nearer to an integral than random points' do, which miss by 1 / sqrt(8000) of its spread.
    y, x = np.mgrid[:60, :40] + 0.5
    mean = (density * np.cos(x / 9 + y / 7)).sum() / density.sum()
    assert abs(np.cos(points[:, 0] / 9 + points[:, 1] / 7).mean() - mean) < 0.2 / np.sqrt(8000)
    assert np.array_equal(dapple.sample(7.0 * density, 500, relax=0), dapple.sample(density, 500, relax=0))
    assert dapple.sample(np.ones((1, 1)), 1).shape == (1, 2)


def densities():
    """Ten, uint8 or float64, that are hard in one way or another."""
    random = np.random.default_rng(5)
    y, x = np.mgrid[:60, :80] + 0.5
    box = np.zeros((60, 80))
    box[20:23, 40:44] = 1
    specks = (random.random((60, 80)) < 0.02) * 1.0
    steps = np.where(x < 40, 1.0, 100)
    return {
        "a small box": box,
        "specks": specks,
        "noise of zeros and ones": (random.random((60, 80)) < 0.44).astype(np.uint8),
        "noise of any value": random.random((60, 80)),
        "noise over a hundredfold": 100 ** random.random((60, 80)),
        "a step of a hundred": steps,
        "two cells": np.array([[1, 100]]),
        "stripes": (x.astype(int) % 3 == 0) * 1.0,
        "a checkerboard": ((x.astype(int) + y.astype(int)) % 2) * 1.0,
        "a bell": np.exp(-((x - 30) ** 2 + (y - 20) ** 2) / 200),
    }


def groups(density, by):
    """Cells in groups of about as much of the density: a number for each cell."""
    mass = density / density.sum()
    order = np.argsort(by, axis=None, kind="stable")
    number = np.empty(density.size, int)
    number[order] = np.minimum(np.cumsum(mass.flat[order]) * 16, 15).astype(int)
    return number.reshape(density.shape)


@pytest.mark.parametrize("name", densities())
def test_points_come_in_the_numbers_that_cells_ask_for(name):
    count = 2000
    density = densities()[name].astype(float)
    points = dapple.sample(density, count)
    column, row = points.astype(int).T  # as the manual has it
    seen = np.zeros(density.shape)
    np.add.at(seen, (row, column), 1)
    assert not seen[density == 0].any()
    for by in density, np.arange(density.size).reshape(density.shape), np.indices(density.shape)[1]:
        number = groups(density, by)
        wanted = np.bincount(number.ravel(), density.ravel() / density.sum() * count)
        found = np.bincount(number.ravel(), seen.ravel())
        some = wanted > 0
        chi2 = ((found - wanted)[some] ** 2 / wanted[some]).sum()
        freedom = some.sum() - 1
        # Random points come beyond it once in a thousand times (Wilson and Hilferty 1931).
        assert chi2 <= freedom * (1 - 2 / (9 * freedom) + 3.09 * np.sqrt(2 / (9 * freedom))) ** 3


def test_sparse_sides_get_their_share():
    # Ten of a thousand points each.
    shares = []
    for turn in range(12):
        wide = np.where(np.arange(80 + turn) < 40, 1.0, 100 * 40 / (40 + turn))[None].repeat(60 + turn, 0)
        points = dapple.sample(np.rot90(wide, turn), 1010)
        back = {0: points[:, 0], 1: wide.shape[1] - points[:, 1], 2: wide.shape[1] - points[:, 0], 3: points[:, 1]}[turn % 4]
        shares.append((back < 40).sum() / 10)
    assert np.mean(shares) == pytest.approx(1, abs=0.08)


def test_a_density_may_also_change_evenly_between_the_middles_of_cells():
    density = np.zeros((9, 9))
    density[4, 4] = 1
    x, y = dapple.sample(density, 2000, interpolation="linear", relax=0).T
    assert 3.5 <= min(x.min(), y.min()) < 3.7 and 5.3 < max(x.max(), y.max()) <= 5.5
    assert (abs(x - 4.5) < 0.5).mean() == pytest.approx(0.75, abs=0.01)  # of a tent from -1 to 1
    linear = dapple.Stippler()
    linear.set_density(density, interpolation="linear")
    assert len(linear.draw(50)) == 50


def test_what_is_masked_is_no_point_no_density_and_bare_paper():
    y, x = np.mgrid[:40, :60]
    mask = x < 30
    density = np.ma.masked_array(np.where(mask, np.nan, 1.0), mask)
    assert dapple.sample(density, 500)[:, 0].min() >= 30
    assert np.array_equal(dapple.sample(density, 500), dapple.sample(density.filled(0), 500))
    stippler = dapple.Stippler()
    stippler.set_density(np.ma.masked_array(mask, mask))
    with pytest.raises(ValueError, match="white everywhere"):
        stippler.draw(50)

    for picture in grey(), np.uint16(grey()) * 257, grey() / np.float32(255), grey() < 100:
        paper = picture.copy()
        paper[mask] = {"b": True, "u": np.iinfo(paper.dtype).max if paper.dtype.kind == "u" else 0}.get(paper.dtype.kind, 1)
        assert same(np.ma.masked_array(picture, mask)) == same(paper)
    paper = ramp()
    paper[mask] = 255
    one_channel = np.zeros(ramp().shape, bool)
    one_channel[mask, 1] = True
    assert same(np.ma.masked_array(ramp(), one_channel), pens="cmyk") == same(paper, pens="cmyk")
    light = np.ma.masked_array(np.where(mask, np.nan, 0.5), mask)
    assert same(light, linear=True) == same(light.filled(1), linear=True)

    points = np.random.default_rng(1).random((300, 2))
    missing = np.zeros(points.shape, bool)
    missing[::3, 1] = True
    kept = np.delete(points, np.s_[::3], axis=0)
    assert dapple.analyse(np.ma.masked_array(points, missing)) == dapple.analyse(kept)
    sky = np.ma.masked_array(np.ones((16, 32, 3)), np.indices((16, 32, 3))[0] >= 8)
    assert np.array_equal(dapple.lights(sky, 20), dapple.lights(sky.filled(0), 20))


def drawn_elsewhere(contrast):
    dots = dapple.stipple(ramp(), 300, automatic_tone=False, tone={"contrast": contrast}, pens="cmyk")
    return dots, dapple.Stippler(ramp()).plan(300), dots.advice(), dapple.analyse(np.stack([dots.x, dots.y], axis=1), 200, 200)


def test_results_come_from_other_processes_and_can_be_copied(tmp_path):
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        found = pool.map(drawn_elsewhere, [0.1, 0.3])
    for contrast, (dots, *others) in zip([0.1, 0.3], found):
        ours, *want = drawn_elsewhere(contrast)
        assert places(dots) == places(ours) and not dots.x.flags.writeable
        assert repr(dots) == repr(ours) and dots.pens == ours.pens and others == want
        assert np.array_equal(dots.pixels(40), ours.pixels(40))
        for name, each in ("theirs.svg", dots), ("ours.svg", ours), ("copy.svg", copy.deepcopy(dots)):
            each.save(tmp_path / name)
            assert (tmp_path / name).read_bytes() == (tmp_path / "theirs.svg").read_bytes()
        assert copy.copy(dots) is dots

    # A stippler as well; it draws what it was given, whatever becomes of that array.
    picture = ramp()
    stippler = dapple.Stippler(picture, threads=1)
    stippler.set_tile(dapple.tile_text("aperiodic64"))
    picture[:] = 255
    for again in pickle.loads(pickle.dumps(stippler)), copy.copy(stippler), copy.deepcopy(stippler):
        assert places(again.draw(300)) == same(ramp(), tile="aperiodic64")
    for take in (lambda: stippler.set_density([[0.2, 0.7]], interpolation="linear"), lambda: stippler.set_picture(grey() / 255, linear=True)):
        take()
        assert places(pickle.loads(pickle.dumps(stippler)).draw(300)) == places(stippler.draw(300))
    assert len(pickle.loads(pickle.dumps(stippler.draw(50)))) == 50


def test_lights_carry_the_maps_flux():
    sky = np.full((32, 64, 3), 0.5)
    sky[8, 32] = 2000
    lights = dapple.lights(sky, 200)
    assert lights.shape == (200,)
    # 4 pi of the sky, and the texel's solid angle.
    texel = 2 * np.pi / 64 * (np.cos(8 * np.pi / 32) - np.cos(9 * np.pi / 32))
    np.testing.assert_allclose(lights["weight"].sum(axis=0), 4 * np.pi * 0.5 + texel * 1999.5, rtol=1e-5)
    np.testing.assert_allclose(np.linalg.norm(lights["direction"], axis=1), 1)
    assert 0 <= lights["u"].min() and lights["v"].max() <= 1 and lights["pdf"].min() > 0
    assert not np.array_equal(lights, dapple.lights(sky, 200, seed=3))


def test_points_are_measured():
    x, y = np.mgrid[:32, :32] + 0.5
    grid = dapple.analyse(np.stack([x.ravel(), y.ravel()], axis=1), 32, 32)
    assert grid.count == 1024
    # A square grid's spacing is 1, the largest sqrt(2 / sqrt(3)).
    assert grid.nearest_minimum == pytest.approx((3**0.5 / 2) ** 0.5)
    assert grid.power_below_05 < 1e-6
    assert dapple.analyse(np.zeros((0, 2))).count == 0


def test_tiles_come_as_text_and_as_points():
    assert "kinds4096" in dapple.tile_names()
    points = dapple.tile_points(dapple.tile_text("paper16"))
    assert points.shape == (1, 16, 2)
    # Doubled, each is one of the others: the paper's tile is the cycle of 2x mod 1.
    doubled = 2 * points[0] % 1
    assert np.abs(doubled[:, None] - points[0]).max(axis=2).min(axis=1).max() < 1e-12
    assert dapple.tile_points(dapple.tile_text("kinds4096")).shape == (8, 4096, 2)


def test_the_manual_and_the_types_are_whole():
    for name in dapple.__all__:
        assert inspect.getdoc(getattr(dapple, name)), name
    stub = ast.parse((SOURCE / "bindings/python/dapple/_dapple.pyi").read_text())
    names = {node.name: node for node in stub.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    assert {name for name in dir(_dapple) if not name.startswith("_")} == {*names, "version"}
    for name in "Stippler", "Drawing":
        methods = {node.name for node in names[name].body} - {"__init__"}
        assert {each for each in dir(getattr(_dapple, name)) if not each.startswith("_")} == methods
    assert re.search(r"project\(dapple VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text())[1] == dapple.__version__


def test_the_examples_of_the_page_run(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Image.fromarray(ramp()).save("cat.jpg")
    examples = re.findall(r"```python\n(.*?)```", (SOURCE / "docs/python.md").read_text(), re.DOTALL)
    exec("".join(examples), {})
    assert {"cat.svg", "cat.gcode", "python_pens.png", "python_sample.png"} <= {
        file.name for file in tmp_path.iterdir()
    }
