#!/usr/bin/env python3
"""Stipples the selected pictures in their place, by the command `dapple`.

With one ink, a group takes the picture's place, with the picture and the dots in it:

    <g dapple:picture="image1" dapple:settings="...">  <image id="image1"/>  <g>paths</g>  </g>

Several inks have a layer each at the end of the document: plotters' programs look for layers nowhere else. The picture
then stays where it is. Whatever of all this is selected, the drawing is made anew of its picture.

The dots' coordinates are millimetres of the document, whatever the groups around them do: pens keep their width, and
dots are round where the picture is turned, stretched or skewed.
"""
import json
import os
import subprocess
import tempfile
import urllib.parse
import urllib.request

import inkex
from inkex import AbortExtension, Transform
from inkex.units import parse_unit
from lxml import etree

DAPPLE = "urn:x-dapple:settings"
PICTURE, SETTINGS = f"{{{DAPPLE}}}picture", f"{{{DAPPLE}}}settings"
LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"
SVG = "{http://www.w3.org/2000/svg}"
etree.register_namespace("dapple", DAPPLE)
MM_PER_PX = 25.4 / 96
DOTS_A_PATH = 500  # Inkscape is slow with an object for each dot, and with all dots in one

# The dialog's rows that a drawing keeps, and what they begin with.
ROWS = {"dots": 10000, "draw": "dots", "pen_width": 0.3, "smallest": 0.15, "largest": 0.6, "inks": "one", "pens": "",
        "settle": "auto", "tone": 0.6, "picture": "hide"}


class Stipple(inkex.EffectExtension):
    def add_arguments(self, pars):
        for row, usual in ROWS.items():
            pars.add_argument(f"--{row}", type=type(usual), default=usual)
        pars.add_argument("--again", type=inkex.Boolean, default=False)

    def effect(self):
        if not self.svg.selection:
            raise AbortExtension("Nothing is selected; select a picture first.")
        for picture in dict.fromkeys(each for selected in self.svg.selection for each in self.pictures_in(selected)):
            self.stipple(picture)

    def pictures_in(self, selected):
        for part in [selected, *selected.iterancestors()]:
            if PICTURE in part.attrib:
                picture = self.picture_of(part)
                if picture is None:
                    raise AbortExtension(f'"{part.label}" has lost its picture; undo its removal, or select another.')
                return [picture]
        pictures = [each for each in selected.iter() if isinstance(each, inkex.Image)]
        if not pictures:
            raise AbortExtension(f'"{selected.get_id()}" is no picture; select one, or copy it as a bitmap (Alt+B).')
        return pictures

    def picture_of(self, part):
        inside = part.find(SVG + "image")  # of a copied group it has another id than the group names
        named = (each for each in self.svg.iter(SVG + "image") if each.get("id") == part.attrib[PICTURE])
        return next(named, None) if inside is None else inside

    def stipple(self, picture):
        groups = (each for each in self.svg.iter(SVG + "g") if PICTURE in each.attrib)
        parts = [each for each in groups if self.picture_of(each) is picture]
        settings = settings_of(parts[0]) if parts and self.options.again else vars(self.options)
        release(picture, parts)
        file = self.file_of(picture)
        page_options, to_mm = page_of(self.svg, picture, *pixels_of(file))
        page = etree.fromstring(run_dapple(file, *page_options, *options_of(settings)), etree.XMLParser(huge_tree=True))
        to_mm @= Transform(scale=tuple(1 / float(side) for side in page.get("viewBox").split()[2:]))
        layers = list(page.iter(SVG + "g"))
        if len(layers) == 1:
            parts = [inkex.Group.new(f"Dots of {picture.label or picture.get_id()}")]
            picture.getparent().replace(picture, parts[0])
            parts[0].append(picture)
        else:
            parts = [inkex.Layer.new(layer.get(LABEL), style=layer.get("style") or "") for layer in layers]
            self.svg.extend(parts)
        for part, layer in zip(parts, layers):
            part.attrib[PICTURE] = picture.get_id()
            part.attrib[SETTINGS] = json.dumps({row: settings[row] for row in ROWS})
            style, paths = paths_of(layer, to_mm)
            dots = self.group_in_mm(part, picture)
            dots.style = style
            dots.extend([inkex.PathElement(d=path) for path in paths])
        if settings["picture"] == "remove":
            picture.delete()
        elif settings["picture"] == "lock":
            picture.set_sensitive(False)
        else:
            picture.style["display"] = "none"

    def group_in_mm(self, part, picture):
        """A group whose user units are millimetres of the document, clipped as the picture is."""
        clip = {name: picture.get(name) for name in ("clip-path", "mask") if picture.get(name)}
        if clip:
            around, part = part, part.add(inkex.Group(**clip))
            part.transform = -around.composed_transform() @ picture.composed_transform()
        group = part.add(inkex.Group())
        group.transform = -part.composed_transform() @ Transform(scale=1 / (px_per_unit(self.svg) * MM_PER_PX))
        return group

    def file_of(self, picture):
        """The bytes of an embedded picture, or the path of a linked one."""
        href = picture.get("xlink:href") or picture.get("href") or ""
        if href.startswith("data:"):
            with urllib.request.urlopen(href) as data:
                return data.read()
        url = urllib.parse.urlparse(href)
        if not url.path or url.scheme not in ("", "file"):
            raise AbortExtension(f'The picture "{picture.get_id()}" is not in a file: "{href}"; embed it first.')
        linked = urllib.parse.unquote(url.path)
        # Inkscape hands over a copy of the document, in which links lead from where that lies.
        for folder in os.path.dirname(str(self.options.input_file)), self.svg_path() or "/":
            path = os.path.join(folder, linked)
            if os.path.isfile(path):
                return os.path.abspath(path)
        if os.path.isfile(picture.get("sodipodi:absref") or ""):
            return picture.get("sodipodi:absref")
        raise AbortExtension(f"{linked}, the file of a linked picture, is missing; put it back, or link another.")


def length(element, name, whole):
    """In user units, of which percents are of so many."""
    text = element.get(name) or 0
    share, unit = parse_unit(text, default_value=0)
    return share / 100 * whole if unit == "%" else element.to_dimensionless(text)


def px_per_unit(svg):
    """As Inkscape has it: the document's own percents are of its viewBox, all of which it shows."""
    box = svg.get_viewbox()[2:]
    scales = [(length(svg, name, side) or side) / side for name, side in zip(("width", "height"), box) if side]
    return (max if "slice" in svg.get("preserveAspectRatio", "") else min)(scales, default=1)


def release(picture, parts):
    """Leaves of a drawing the picture alone, shown where it was."""
    for part in parts:
        if picture.getparent() is part:
            picture.transform = part.transform @ picture.transform
            part.getparent().replace(part, picture)
        else:
            part.delete()
        picture.style["display"] = "inline"
        picture.set_sensitive(True)


def settings_of(part):
    """What a drawing keeps, taken as if it were typed: a document may come from anybody."""
    try:
        kept = json.loads(part.attrib[SETTINGS])
        return {row: type(usual)(kept[row]) for row, usual in ROWS.items()}
    except (KeyError, OverflowError, TypeError, ValueError):
        raise AbortExtension(f'"{part.label}" does not say how it was drawn; draw it with the settings of the dialog.')


def options_of(settings):
    """The settings as options of `dapple render`."""
    draw, inks, pen = settings["draw"], settings["inks"], settings["pen_width"]
    by_pen = draw not in ("dots", "tone")
    shapes = {"pen": "--dot-shape=point", "spiral": "--dot-shape=spiral"}
    options = [shapes.get(draw, f"--style={draw}"), f"--pen-width={pen}"] if by_pen else []
    if inks != "one":
        options.append(f"--pens={settings['pens'] if inks == 'own' else f'{inks}:{pen}' if by_pen else inks}")
    radii = f"--dot-radius={settings['smallest']}..{settings['largest']}"
    options.append(radii if draw == "tone" else f"--dots={settings['dots']}")
    return options + [f"--relax={settings['settle']}", f"--tone-strength={settings['tone']}"]


def run_dapple(file, *options):
    """The SVG that `dapple render` draws of a picture, given by its bytes or its path."""
    name, data = ("-", file) if isinstance(file, bytes) else (file, b"")
    try:
        done = subprocess.run(["dapple", "render", name, "-o", "-", *options], input=data, capture_output=True)
    except FileNotFoundError:
        raise AbortExtension("The program dapple is not installed, or not on Inkscape's PATH; install the package "
                             "dapple, and start Inkscape again.")
    if done.returncode != 0:
        said = done.stderr.decode(errors="replace").strip().splitlines() or [f"dapple: ended with {done.returncode}"]
        raise AbortExtension(said[-1].replace("the standard input", "the embedded picture") + ".")
    return done.stdout


def pixels_of(file):
    """A picture's width and height, turned as it says itself."""
    with tempfile.TemporaryDirectory() as folder:
        stats = os.path.join(folder, "stats.json")
        run_dapple(file, "--dots=1", "--relax=0", f"--stats={stats}")
        with open(stats, encoding="utf-8") as text:
            figures = json.load(text)
    return figures["image_width"], figures["image_height"]


def page_of(svg, picture, pixels_wide, pixels_high):
    """Of the part of a picture that preserveAspectRatio shows: the options that draw it on a page as large as in the
    document, and what takes that page, as a unit square, to millimetres of the document. If the document stretches it,
    the page is as large in area, so that the dots give the picture's tone."""
    # Without a viewBox and sizes Inkscape has a document of 300 by 150.
    wholes = {"x": svg.viewbox_width or 300, "y": svg.viewbox_height or 150}
    x, y = (length(picture, name, whole) for name, whole in wholes.items())
    width = length(picture, "width", wholes["x"]) or pixels_wide  # as Inkscape shows it
    height = length(picture, "height", wholes["y"]) or pixels_high
    x_scale, y_scale = width / pixels_wide, height / pixels_high
    fit = picture.get("preserveAspectRatio") or "xMidYMid"
    if "none" not in fit:
        x_scale = y_scale = max(x_scale, y_scale) if "slice" in fit else min(x_scale, y_scale)
    all_wide, all_high = x_scale * pixels_wide, y_scale * pixels_high
    left = (width - all_wide) * (0 if "xMin" in fit else 1 if "xMax" in fit else 0.5)
    top = (height - all_high) * (0 if "YMin" in fit else 1 if "YMax" in fit else 0.5)
    width, height = min(width, all_wide), min(height, all_high)
    in_mm = Transform(scale=px_per_unit(svg) * MM_PER_PX) @ picture.composed_transform()
    area_mm2 = abs(in_mm.a * in_mm.d - in_mm.b * in_mm.c) * width * height
    if not area_mm2 > 0:
        raise AbortExtension(f'The picture "{picture.get_id()}" has no width or no height; make it larger.')
    options = ["--margin=0", f"--width={(area_mm2 * (width / x_scale) / (height / y_scale)) ** 0.5:.6f}"]
    if "slice" in fit:
        box = -min(left, 0) / all_wide, -min(top, 0) / all_high, width / all_wide, height / all_high
        options.append("--crop={:.6f}%,{:.6f}%,{:.6f}%x{:.6f}%".format(*(100 * each for each in box)))
    return options, in_mm @ Transform(translate=(x + max(left, 0), y + max(top, 0))) @ Transform(scale=(width, height))


def paths_of(layer, to_mm):
    """A layer of dapple's page as few paths: their style, and the `d` of each."""
    def place(x, y):
        return to_mm.a * x + to_mm.c * y + to_mm.e, to_mm.b * x + to_mm.d * y + to_mm.f
    circles = [[float(circle.get(name)) for name in ("cx", "cy", "r")] for circle in layer.iter(SVG + "circle")]
    radii = {radius for _, _, radius in circles}
    pen = {"fill": "none", "stroke": layer.get("stroke"), "stroke-linecap": "round", "stroke-linejoin": "round"}
    if len(radii) > 1:
        style = {"fill": layer.get("fill"), "stroke": "none"}
        pieces = [disc(place(x, y), radius * MM_PER_PX) for x, y, radius in circles]
    elif circles:
        # Touches of a pen as wide as the dots, a micrometre long: vpype and others drop what has no length.
        style = pen | {"stroke": layer.get("fill"), "stroke-width": number(2 * radii.pop() * MM_PER_PX)}
        pieces = [line([place(x, y)]) + "h.001" for x, y, _ in circles]
    else:
        style = pen | {"stroke-width": number(float(layer.get("stroke-width") or 0) * MM_PER_PX)}
        pieces = [stroke(path.get("d"), place) for path in layer.iter(SVG + "path")]
    return style, ["".join(pieces[i:i + DOTS_A_PATH]) for i in range(0, len(pieces), DOTS_A_PATH)]


def stroke(d, place):
    """Of a stroke as dapple writes it: "M1 2L3 4 5 6", or "M1 2h0.189" for a touch of the pen."""
    at = [float(each) for each in d.translate(str.maketrans("MLh", "   ")).split()]
    touch = "h" + number(at.pop() * MM_PER_PX) if "h" in d else ""
    return line([place(x, y) for x, y in zip(at[::2], at[1::2])]) + touch


def disc(middle, radius):
    half = f"a{number(radius)} {number(radius)} 0 1 0 "
    return line([(middle[0] - radius, middle[1])]) + f"{half}{number(2 * radius)} 0{half}{number(-2 * radius)} 0z"


def line(points):
    return "M" + "L".join(f"{number(x)} {number(y)}" for x, y in points)


def number(value):
    return f"{round(value, 3):.8g}"


if __name__ == "__main__":
    Stipple().run()
