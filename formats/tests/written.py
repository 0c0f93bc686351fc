"""Reads a path from standard input with the modules that people use, and prints a line about it and a line of numbers for each row."""

import io
import math
import sys

form, data = sys.argv[1], sys.stdin.buffer.read()


def heading(orientation):
    assert set(orientation) == {"x", "y", "z", "w"} and orientation["x"] == orientation["y"] == 0.0
    assert all(isinstance(part, float) for part in orientation.values())
    return 2.0 * math.atan2(orientation["z"], orientation["w"])


def place(position):
    assert set(position) == {"x", "y", "z"} and all(isinstance(part, float) for part in position.values())
    return [position["x"], position["y"]]


rows = []
if form == "csv":
    import csv

    first, *lines = csv.reader(io.StringIO(data.decode()))
    print(*first)
    rows = [[float(cell) for cell in line] for line in lines]
elif form == "json":
    import json

    document = json.loads(data)
    columns = document["columns"]
    print(*(f"{name}[{column['unit']}]" for name, column in columns.items()))
    assert all(len(column["values"]) == document["rows"] for column in columns.values())
    rows = list(zip(*(column["values"] for column in columns.values())))
elif form == "geojson":
    import json

    document = json.loads(data)
    assert document["type"] == "FeatureCollection" and all(f["type"] == "Feature" for f in document["features"])
    line, *points = document["features"]
    assert line["geometry"]["type"] == "LineString" and all(p["geometry"]["type"] == "Point" for p in points)
    assert line["geometry"]["coordinates"] == [point["geometry"]["coordinates"] for point in points]
    print(*(point["properties"]["name"] for point in points if "name" in point["properties"]), len(points))
    rows = [[*point["geometry"]["coordinates"], point["properties"]["theta"]] for point in points]
elif form == "svg":
    from xml.etree import ElementTree

    root = ElementTree.fromstring(data)
    svg = "{http://www.w3.org/2000/svg}"
    assert root.tag == svg + "svg" and len(root.get("viewBox").split()) == 4
    print(root.find(svg + "title").text)
    (path,) = (element for element in root.iter(svg + "polyline") if element.get("id") == "path")
    rows = [[float(number) for number in pair.split(",")] for pair in path.get("points").split()]
elif form == "npy":
    import numpy

    array = numpy.load(io.BytesIO(data))
    print(array.dtype, array.shape)
    rows = array.tolist()
elif form == "nav-path":
    import yaml

    message = yaml.safe_load(data)
    assert set(message) == {"header", "poses"}
    print(message["header"]["frame_id"])
    for stamped in message["poses"]:
        assert set(stamped) == {"header", "pose"} and stamped["header"]["frame_id"] == message["header"]["frame_id"]
        stamp = stamped["header"]["stamp"]
        assert isinstance(stamp["sec"], int) and isinstance(stamp["nanosec"], int)
        time = stamp["sec"] + 1e-9 * stamp["nanosec"]
        rows.append([*place(stamped["pose"]["position"]), heading(stamped["pose"]["orientation"]), time])
elif form == "nav-waypoints":
    import yaml

    waypoints = yaml.safe_load(data)
    print(waypoints[0]["frame_id"])
    assert all(set(waypoint) == {"frame_id", "position", "orientation"} for waypoint in waypoints)
    rows = [[*place(waypoint["position"]), heading(waypoint["orientation"])] for waypoint in waypoints]
else:
    sys.exit(f"unknown form {form}")
for row in rows:
    print(*(repr(float(number)) for number in row))
