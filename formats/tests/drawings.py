"""Reads a drawing with other libraries, and prints random points with what they are: 1 within a shape, 0 far from all.

Usage: python3 drawings.py FILE METRES LARGER [THICKNESS]

METRES is the length of a pixel (SVG) or of a unit (DXF), LARGER how much larger than the shapes obstacles may be in metres,
THICKNESS that of lines without a width (DXF). Needs svgelements, ezdxf and shapely.
"""

import random
import sys

import ezdxf
import ezdxf.disassemble
import ezdxf.path
import shapely
import svgelements
from shapely import affinity

SAMPLES = 20_000
CAPS = {"butt": "flat", "round": "round", "square": "square"}
JOINS = {"miter": "mitre", "round": "round", "bevel": "bevel"}


def sampled(path, count=256):
    """The subpaths of a path as lists of points, and whether each is closed."""
    for sub in path.as_subpaths():
        points, closed = [], False
        for segment in svgelements.Path(sub):
            if isinstance(segment, svgelements.Move):
                points.append(segment.end)
            elif isinstance(segment, svgelements.Close):
                points.append(segment.end)
                closed = True
            elif isinstance(segment, svgelements.Line):
                points.append(segment.end)
            else:
                points += [segment.point(i / count) for i in range(1, count + 1)]
        yield [(p.x, p.y) for p in points if p is not None], closed


def area(rings, even_odd):
    """What rings fill: the faces of all their lines that they wind about."""
    rings = [ring if ring[0] == ring[-1] else ring + ring[:1] for ring in rings if len(ring) > 2]
    lines = shapely.unary_union([shapely.LineString(ring) for ring in rings])
    faces = []
    for face in shapely.get_parts(shapely.polygonize([lines])):
        p = face.representative_point()
        winding = 0
        for ring in rings:
            for (ax, ay), (bx, by) in zip(ring, ring[1:]):
                if (ay <= p.y) != (by <= p.y) and ax + (p.y - ay) / (by - ay) * (bx - ax) > p.x:
                    winding += 1 if by > ay else -1
        if winding % 2 if even_odd else winding:
            faces.append(face)
    return shapely.unary_union(faces)


def svg(file, metres):
    """The shapes, and the same with round ends."""
    drawing = svgelements.SVG.parse(file, reify=False, ppi=96)
    height = float(drawing.viewbox.height if drawing.height is None else drawing.height)
    shapes = []
    for element in drawing.elements():
        if not isinstance(element, svgelements.Shape) or element.values.get("visibility") == "hidden":
            continue
        values, m = element.values, element.transform
        path = svgelements.Path(element)
        path.transform = svgelements.Matrix()
        parts = list(sampled(path))
        forms = []
        if element.fill.value is not None and not isinstance(element, svgelements.SimpleLine):
            forms.append(area([points for points, _ in parts], values.get("fill-rule") == "evenodd"))
        width = element.stroke_width or 0
        if element.stroke.value is not None and width > 0:
            join = JOINS.get(values.get("stroke-linejoin"), "mitre")
            cap = CAPS.get(values.get("stroke-linecap"), "flat")
            limit = float(values.get("stroke-miterlimit", 4))
            for points, closed in parts:
                if len(set(points)) < 2:
                    continue
                line = shapely.LinearRing(points) if closed and len(set(points)) > 2 else shapely.LineString(points)
                # A mitre beyond the limit is cut off, which shapely does elsewhere: such corners are left out.
                forms.append(line.buffer(width / 2, cap_style=cap, join_style="bevel"))
                if join == "mitre" and sharpest(points, closed) < limit:
                    forms.append(line.buffer(width / 2, cap_style=cap, join_style=join, mitre_limit=limit))
        for form in forms:
            placed = affinity.affine_transform(form, [m.a, m.c, m.b, m.d, m.e, m.f])
            shapes.append(affinity.affine_transform(placed, [metres, 0, 0, -metres, 0, metres * height]))
    return shapes


def sharpest(points, closed):
    """The longest mitre of a line, in halves of its width."""
    longest = 1.0
    distinct = [p for p, q in zip(points, points[1:] + [None]) if p != q]
    if closed:
        distinct = distinct[:-1] if distinct[-1] == distinct[0] else distinct
        distinct += distinct[:2]
    for a, b, c in zip(distinct, distinct[1:], distinct[2:]):
        u, v = complex(b[0] - a[0], b[1] - a[1]), complex(c[0] - b[0], c[1] - b[1])
        cosine = ((1 + (u / abs(u) * (v / abs(v)).conjugate()).real) / 2) ** 0.5
        longest = max(longest, 1 / max(cosine, 1e-9))
    return longest


def dxf(file, metres, thickness):
    """The shapes."""
    document = ezdxf.readfile(file)
    shapes = []
    for entity in ezdxf.disassemble.recursive_decompose(document.modelspace()):
        layer = document.layers.get(entity.dxf.layer) if entity.dxf.layer in document.layers else None
        if layer is not None and (layer.is_off() or layer.is_frozen()):
            continue
        if entity.dxftype() in ("SOLID", "TRACE"):
            corners = [(p.x, p.y) for p in entity.wcs_vertices()]
            shapes.append(affinity.scale(shapely.Polygon(corners), metres, metres, origin=(0, 0)))
            continue
        if entity.dxftype() == "HATCH":
            paths = ezdxf.path.from_hatch(entity)
            rings = [[(p.x, p.y) for p in path.flattening(1e-4 / metres)] for path in paths]
            shapes.append(affinity.scale(area(rings, True), metres, metres, origin=(0, 0)))
            continue
        try:
            path = ezdxf.path.make_path(entity)
        except TypeError:
            continue
        points = [(p.x, p.y) for p in path.flattening(1e-5 / metres)]
        if len(set(points)) < 2:
            continue
        width = entity.dxf.get("const_width", 0) if entity.dxftype() == "LWPOLYLINE" else 0
        line = affinity.scale(shapely.LineString(points), metres, metres, origin=(0, 0))
        shapes.append(line.buffer(max(thickness, width * metres) / 2, cap_style="flat", join_style="bevel"))
    return shapes


def main():
    file, metres, larger = sys.argv[1], float(sys.argv[2]), float(sys.argv[3])
    if file.endswith(".svg"):
        shapes = svg(file, metres)
    else:
        shapes = dxf(file, metres, float(sys.argv[4]))
    shapes = [shape for shape in shapes if not shape.is_empty]
    if not shapes:
        sys.exit("no shape")
    whole = shapely.unary_union(shapes)
    low_x, low_y, high_x, high_y = whole.bounds
    # Samples of curves and corners at a border are not decided.
    slack = 2e-5 * max(high_x - low_x, high_y - low_y)
    inside, far = whole.buffer(-slack), whole.buffer(larger + slack)
    shapely.prepare([inside, far])
    random.seed(1)
    for i in range(SAMPLES):
        x, y = random.uniform(low_x, high_x), random.uniform(low_y, high_y)
        if i % 2:
            # Half of the points are near borders.
            border = whole.boundary.interpolate(random.random(), normalized=True)
            x, y = border.x + random.gauss(0, 4 * slack), border.y + random.gauss(0, 4 * slack)
        if shapely.contains_xy(inside, x, y):
            print(1, x, y)
        elif not shapely.contains_xy(far, x, y):
            print(0, x, y)


main()
