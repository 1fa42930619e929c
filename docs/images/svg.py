"""Panels of an SVG picture: axes, lines, areas and labels, in plain text that can be compared."""

import math
import re

INK, GREY, PALE = "#222222", "#8a8a8a", "#d9d9d9"
RED, GREEN, BLUE, ORANGE = "#cc2f27", "#2a8f55", "#3d6fa5", "#d9822b"


def number(value):
    """A coordinate to a tenth of a pixel."""
    return f"{value:.1f}".replace("-0.0", "0.0")


class Picture:
    """A white picture of `width` x `height` pixels."""

    def __init__(self, width, height, title):
        self.width, self.height, self.title, self.parts = width, height, title, []

    def label(self, x, y, text, *, size=13, colour=INK, anchor="start", weight="normal", turned=False):
        turn = f' transform="rotate(-90 {number(x)} {number(y)})"' if turned else ""
        text = text.replace("&", "&amp;").replace("<", "&lt;")
        self.parts.append(
            f'<text x="{number(x)}" y="{number(y)}" font-size="{size}" fill="{colour}" text-anchor="{anchor}" '
            f'font-weight="{weight}"{turn}>{text}</text>'
        )

    def line(self, points, *, colour=INK, width=1.5, dash=None):
        dash = f' stroke-dasharray="{dash}"' if dash else ""
        shown = " ".join(f"{number(x)},{number(y)}" for x, y in points)
        self.parts.append(f'<polyline points="{shown}" fill="none" stroke="{colour}" stroke-width="{width}"{dash}/>')

    def area(self, points, *, fill, stroke="none", opacity=1.0):
        shown = " ".join(f"{number(x)},{number(y)}" for x, y in points)
        self.parts.append(
            f'<polygon points="{shown}" fill="{fill}" fill-opacity="{opacity}" stroke="{stroke}" stroke-width="1.2" '
            'stroke-linejoin="round"/>'
        )

    def dot(self, x, y, *, radius=4, fill=INK, stroke="white"):
        shape = f'<circle cx="{number(x)}" cy="{number(y)}" r="{radius}"'
        self.parts.append(f'{shape} fill="{fill}" stroke="{stroke}" stroke-width="1.2"/>')

    def cross(self, x, y, *, colour=RED, size=7):
        self.line([(x - size, y - size), (x + size, y + size)], colour=colour, width=3)
        self.line([(x - size, y + size), (x + size, y - size)], colour=colour, width=3)

    def text(self):
        head = (
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width} {self.height}" width="{self.width}" '
            f'height="{self.height}" font-family="Helvetica, Arial, sans-serif" role="img">'
        )
        ground = f'<rect width="{self.width}" height="{self.height}" rx="8" fill="white"/>'
        return "\n".join([head, f"<title>{self.title}</title>", ground, *self.parts, "</svg>"]) + "\n"


class Axes:
    """A panel of a picture: `box` is left, top, width and height in pixels; `x` and `y` the ranges that it shows."""

    def __init__(self, picture, box, x, y):
        self.picture, self.box, self.x, self.y = picture, box, x, y

    def at(self, x, y):
        left, top, width, height = self.box
        (x0, x1), (y0, y1) = self.x, self.y
        return left + (x - x0) / (x1 - x0) * width, top + (y1 - y) / (y1 - y0) * height

    def ticks(self, xs, ys, xlabel, ylabel, form="{:g}"):
        left, top, width, height = self.box
        self.picture.line([(left, top), (left, top + height), (left + width, top + height)], colour=GREY, width=1)
        for x in xs:
            across = self.at(x, self.y[0])[0]
            self.picture.label(across, top + height + 17, form.format(x), size=12, colour=GREY, anchor="middle")
        for y in ys:
            down = self.at(self.x[0], y)[1]
            self.picture.line([(left, down), (left + width, down)], colour=PALE, width=0.7)
            self.picture.label(left - 6, down + 4, form.format(y), size=12, colour=GREY, anchor="end")
        self.picture.label(left + width / 2, top + height + 35, xlabel, size=12, anchor="middle")
        if ylabel:
            self.picture.label(left - 42, top + height / 2, ylabel, size=12, anchor="middle", turned=True)

    def line(self, points, **how):
        self.picture.line([self.at(x, y) for x, y in points], **how)

    def area(self, points, **how):
        self.picture.area([self.at(x, y) for x, y in points], **how)

    def circle(self, x, y, radius, **how):
        """A circle in the units of the axes."""
        turns = [2 * math.pi * k / 90 for k in range(90)]
        self.area([(x + radius * math.cos(a), y + radius * math.sin(a)) for a in turns], **how)


def differ(old, new):
    """Where two pictures differ by more than rounding: coordinates by 1.5 pixels, numbers of labels by 2 %, or their
    parts. None if they do not."""
    if len(old.splitlines()) != len(new.splitlines()):
        return "the number of parts"
    figure = re.compile(r"-?\d+(?:\.\d+)?")
    for a, b in zip(old.splitlines(), new.splitlines()):
        a_label, b_label = (re.fullmatch(r"<text[^>]*>(.*)</text>", line) for line in (a, b))
        labels = (a_label[1], b_label[1]) if a_label and b_label else ("", "")
        if figure.sub("#", a) != figure.sub("#", b):
            return f"{a[:200]}\n{b[:200]}"
        places = zip(figure.findall(a), figure.findall(b))
        told = zip(figure.findall(labels[0]), figure.findall(labels[1]))
        is_far = any(abs(float(p) - float(q)) > 1.5 for p, q in places)
        if is_far or any(abs(float(p) - float(q)) > 0.02 * abs(float(p)) for p, q in told):
            return f"{a[:200]}\n{b[:200]}"
    return None
