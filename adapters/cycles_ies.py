"""LM-63 luminaire files for adapters/cycles.py: parsing, unfolding, and resampling onto a regular grid.

Blender's own IES node interpolates with cubic curves and normalises differently; the scene format asks for bilinear
interpolation of candela / max candela. A regular grid whose step divides every angle of the file holds the same
piecewise bilinear function exactly, and an image texture with linear interpolation reads it.
"""

import math
import re
from dataclasses import dataclass

# Angles are taken as whole multiples of this when a common step is sought; LM-63 files state at most two decimals.
ANGLE_RESOLUTION_DEG = 0.01
MOST_GRID_CELLS = 4_000_000


class IesError(ValueError):
    """The file is not a usable LM-63 file."""


@dataclass
class Profile:
    """Type C intensity distribution with its symmetry unfolded: candela[plane][row]."""

    vertical_deg: list
    horizontal_deg: list  # first 0, last 360
    candela: list
    max_candela: float


@dataclass
class Grid:
    """Holds candela / max candela on a regular grid: rows ascend in the vertical angle, columns in 0 to 360 deg."""

    columns: int
    rows: int
    first_vertical_deg: float
    last_vertical_deg: float
    values: list  # row by row


def parse_ies(text):
    """Of the whole text of a file, with its line ends."""
    header, tilt, numbers = _split_file(text)
    tokens = iter(numbers.replace(",", " ").split())

    def number(what):
        token = next(tokens, None)
        if token is None:
            raise IesError(f"the file ends where {what} should stand")
        try:
            return float(token)
        except ValueError:
            raise IesError(f"{what} must be a number, is '{token}'") from None

    tilt_factor = _tilt_factor(tilt, number)
    number("number of lamps"), number("lumens per lamp")
    multiplier = number("candela multiplier")
    rows, planes = int(number("number of vertical angles")), int(number("number of horizontal angles"))
    if number("photometric type") != 1:
        raise IesError("only type C photometry is supported")
    for what in ("units", "width", "length", "height"):
        number(what)
    ballast, ballast_lamp = number("ballast factor"), number("ballast-lamp factor")
    number("input watts")
    vertical = [number("vertical angle") for _ in range(rows)]
    horizontal = [number("horizontal angle") for _ in range(planes)]
    # The second factor of the ballast line multiplies in the revisions of 1986 and 1991 only.
    is_old = not header.startswith(("IESNA:LM-63", "IES:LM-63"))
    factor = multiplier * ballast * tilt_factor * (ballast_lamp if is_old else 1.0)
    candela = [[factor * number("candela value") for _ in range(rows)] for _ in range(planes)]
    peak = max(max(plane) for plane in candela)
    if not peak > 0:
        raise IesError("no candela value is above 0")
    return _unfolded(vertical, horizontal, candela, peak)


def read_ies(path):
    """As parse_ies, of a file. Bytes beyond ASCII stand in labels alone, so any encoding that keeps ASCII will do."""
    with open(path, encoding="latin-1", newline="") as file:
        return parse_ies(file.read())


# The rules of this function are those of src/scene/lights/ies.cpp, to which every file comes first.
def _split_file(text):
    text = text.removeprefix("\xef\xbb\xbf").removeprefix("\ufeff")
    if text.startswith(("\xff\xfe", "\xfe\xff")) or "\0" in text[:64]:
        raise IesError("its text is in UTF-16; save it in ASCII or UTF-8")
    lines = re.split("\r\n|\r|\n", text)
    for index, line in enumerate(lines):
        found = re.fullmatch(r"TILT\s*=\s*(.*)", line.strip(), re.IGNORECASE | re.ASCII)
        if not found:
            continue
        tilt = found[1] if found[1].upper() not in ("NONE", "INCLUDE") else found[1].upper()
        return lines[0].strip().upper(), tilt, "\n".join(lines[index + 1 :])
    raise IesError("there is no line that starts with TILT=")


def _tilt_factor(tilt, number):
    """Returns the factor at 0 deg of tilt, because luminaires here hang level."""
    if tilt == "NONE":
        return 1.0
    if tilt != "INCLUDE":
        raise IesError(f"TILT={tilt}: only NONE and INCLUDE are supported")
    number("lamp geometry")
    pairs = int(number("number of tilt angles"))
    angles = [number("tilt angle") for _ in range(pairs)]
    factors = [number("tilt factor") for _ in range(pairs)]
    return factors[angles.index(0.0)] if 0.0 in angles else 1.0


def _azimuths_of(plane, first, last):
    """Returns the angles of a stored plane by the symmetry that the range of the planes implies."""
    if last == 0:
        return (0, 360)
    if first == 90 and last == 270:
        return (180, 0, 360) if plane == 180 else (plane, 180 - plane if plane < 180 else 540 - plane)
    if last == 90:
        return (plane, 180 - plane, 180 + plane, 360 - plane)
    if last == 180:
        return (plane, 360 - plane)
    return (plane,)


def _plane_at_zero(plane_at):
    """Interpolates between the neighbours of 0 = 360: a profile from 90 to 270 may lack the plane at 180."""
    first, last = min(plane_at), max(plane_at)
    share_of_first = (360 - last) / (360 - last + first)
    pairs = zip(plane_at[first], plane_at[last])
    return [share_of_first * at_first + (1 - share_of_first) * at_last for at_first, at_last in pairs]


def _unfolded(vertical, horizontal, candela, peak):
    starts_right = horizontal[0] == 0 or (horizontal[0], horizontal[-1]) == (90, 270)
    if not starts_right or horizontal[-1] > 360:
        raise IesError("horizontal angles of type C start at 0 (or run from 90 to 270) and end by 360")
    plane_at = {}
    for plane, row in zip(horizontal, candela):
        for azimuth in _azimuths_of(plane, horizontal[0], horizontal[-1]):
            plane_at.setdefault(azimuth, row)
    if 0 not in plane_at:
        plane_at[0] = _plane_at_zero(plane_at)
    plane_at.setdefault(360, plane_at[0])  # A file that stops short of 360 continues with its first plane.
    azimuths = sorted(plane_at)
    return Profile(vertical, azimuths, [plane_at[azimuth] for azimuth in azimuths], peak)


def _common_step_deg(angles):
    """Returns the largest step from the first angle on which all angles lie."""
    units = [round((angle - angles[0]) / ANGLE_RESOLUTION_DEG) for angle in angles]
    for unit, angle in zip(units, angles):
        if abs(unit * ANGLE_RESOLUTION_DEG + angles[0] - angle) > 1e-6:
            raise IesError(f"the angle {angle} is finer than {ANGLE_RESOLUTION_DEG} deg")
    return math.gcd(*units) * ANGLE_RESOLUTION_DEG


def _resampled(angles, values, count):
    """Interpolates values at `count` regular angles, which include all of `angles`, so nothing is lost."""
    if len(angles) == 1:
        return [values[0]] * count
    step = (angles[-1] - angles[0]) / (count - 1)
    out, low = [], 0
    for index in range(count):
        angle = angles[0] + index * step
        while low + 2 < len(angles) and angle >= angles[low + 1]:
            low += 1
        t = (angle - angles[low]) / (angles[low + 1] - angles[low])
        out.append((1 - t) * values[low] + t * values[low + 1])
    return out


def regular_grid(profile):
    vertical, horizontal = profile.vertical_deg, profile.horizontal_deg
    columns = round(360 / _common_step_deg(horizontal)) + 1
    rows = 1 if len(vertical) == 1 else round((vertical[-1] - vertical[0]) / _common_step_deg(vertical)) + 1
    if columns * rows > MOST_GRID_CELLS:
        raise IesError(f"its angles need a regular grid of {columns} x {rows} values, {MOST_GRID_CELLS} are supported")
    planes = [_resampled(vertical, plane, rows) for plane in profile.candela]
    values = []
    for row in range(rows):
        line = _resampled(horizontal, [plane[row] for plane in planes], columns)
        values.extend(value / profile.max_candela for value in line)
    return Grid(columns, rows, vertical[0], vertical[-1], values)
