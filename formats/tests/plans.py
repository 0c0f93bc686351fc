"""Reads a plan with other libraries, and prints random points with what they are: 1 within an obstacle, 0 outside all.

Usage: python3 plans.py FILE REPORT

REPORT is a file with the report as JSON: its bounds, plane and offset lead from coordinates of the scenario to those of the
file, its layers say which features are read. Points nearer than 1e-9 of their coordinates to a border are left out. Needs
shapely, and PyYAML for buildings.
"""

import json
import math
import random
import sys

import shapely
import yaml
from shapely.geometry import shape

SAMPLES = 10_000


def geojson(path, report):
    """The areas and lines of features on the layers that were read."""
    read = {layer["name"] for layer in report["layers"] if "omitted" not in layer}
    features = json.load(open(path, encoding="utf-8"))["features"]
    chosen = [feature for feature in features if (feature["properties"] or {}).get("type", "other") in read]
    return shapely.union_all([shape(feature["geometry"]) for feature in chosen]), False


def wkt(path, _report):
    """The walkable area, if there is one polygon."""
    area = shapely.from_wkt(open(path, encoding="utf-8").read())
    return shapely.union_all(list(area.geoms)), True


def building(path, _report):
    """The walls of the first level, in pixels."""
    root = yaml.safe_load(open(path, encoding="utf-8"))
    level = next(iter(root["levels"].values()))
    places = [vertex[:2] for vertex in level["vertices"]]
    pixels = [math.dist(places[a], places[b]) for a, b, _ in level["measurements"]]
    metres = [measured["distance"][1] for _, _, measured in level["measurements"]]
    scale = sum(m / p for m, p in zip(metres, pixels)) / len(pixels)
    walls = shapely.MultiLineString([[places[a], places[b]] for a, b, _ in level["walls"]])
    return walls.buffer(0.05 / scale, quad_segs=256), False


def main():
    path, report_path = sys.argv[1:]
    report = json.load(open(report_path, encoding="utf-8"))
    read = {"geojson": geojson, "wkt": wkt, "rmf-building": building}[report["format"]]
    area, is_free = read(path, report)
    plane = report.get("plane", {"origin": [0, 0], "scale": [1, 1]})
    low, high = report["bounds"]
    near = 1e-9 * max(map(abs, area.bounds))
    if report["format"] == "rmf-building":
        # Round ends are arcs here and circles there.
        near = 0.05
    parts = [area] if not hasattr(area, "geoms") else list(area.geoms)
    border = shapely.union_all([part.boundary if part.geom_type == "Polygon" else part for part in parts])
    random.seed(7)
    places = [[low[i] + random.random() * (high[i] - low[i]) for i in range(2)] for _ in range(SAMPLES)]
    to_file = lambda place, i: plane["origin"][i] + (place[i] + report["offset"][i]) / plane["scale"][i]
    points = shapely.points([[to_file(place, i) for i in range(2)] for place in places])
    shapely.prepare(area)
    inside, far = shapely.contains(area, points), shapely.distance(border, points) > near
    for place, is_inside, is_far in zip(places, inside, far):
        if is_far:
            print(repr(place[0]), repr(place[1]), int(is_inside != is_free))


main()
