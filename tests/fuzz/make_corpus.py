#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""make_corpus.py FOLDER SOURCES: small valid files of every form that the readers know, one folder for
each, as first inputs for the fuzzers."""
import json
import pathlib
import struct
import sys

SOURCES = pathlib.Path(sys.argv[2])
POINTS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0.5)]
FACES = [(0, 1, 2), (0, 1, 2, 3)]


def text(rows):
    return "".join(" ".join(str(value) for value in row) + "\n" for row in rows)


def ply():
    def header(form, face="element face 2\nproperty list uchar int vertex_indices\n"):
        return (f"ply\nformat {form} 1.0\ncomment c\nelement vertex 4\nproperty float x\nproperty float y\n"
                f"property float z\n{face}end_header\n").encode()
    body = text(POINTS) + text([(len(f), *f) for f in FACES])
    yield "ascii", header("ascii") + body.encode()
    for order, form in ("<", "binary_little_endian"), (">", "binary_big_endian"):
        data = b"".join(struct.pack(order + "3f", *p) for p in POINTS)
        data += b"".join(struct.pack(f"{order}B{len(f)}i", len(f), *f) for f in FACES)
        yield form, header(form) + data
    strips = "element tristrips 1\nproperty list int int vertex_indices\n"
    yield "strips", header("ascii", strips) + (text(POINTS) + "9 0 1 2 3 -1 0 1 2 3\n").encode()


def obj():
    points = text([("v", *p) for p in POINTS])
    yield "plain", (points + "f 1 2 3\nf 1 2 3 4\n").encode()
    yield "forms", (points + "vt 0 0\nvn 0 0 1\nf 1/1/1 2//1 \\\n3/1\nf -4 -3 -2 # c\ng a\nl 1 2\n").encode()
    yield "concave", b"v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n"


def off():
    faces = text([(len(f), *f) for f in FACES])
    yield "off", ("OFF\n4 2 0\n" + text(POINTS) + faces).encode()
    yield "coff", ("COFF 4 2 0 # c\n" + text([(*p, 1, 0, 0, 1) for p in POINTS]) + faces).encode()


def stl():
    triangle = POINTS[:3]
    yield "ascii", ("solid a\nfacet normal 0 0 1\nouter loop\n" + text([("vertex", *p) for p in triangle]) +
                    "endloop\nendfacet\nendsolid a\n").encode()
    yield "binary", bytes(80) + struct.pack("<I", 1) + struct.pack("<12fH", 0, 0, 1, *sum(triangle, ()), 0)


def gltf():
    data = b"".join(struct.pack("<3f", *p) for p in POINTS) + struct.pack("<6H", 0, 1, 2, 0, 2, 3)
    scene = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "scale": [2, 2, -2], "children": [1]},
                  {"mesh": 0, "rotation": [0, 0, 1, 0], "translation": [1, 2, 3]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1},
                                   {"attributes": {"POSITION": 0}, "mode": 5}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
        "buffers": [{"byteLength": len(data)}]}
    chunk = json.dumps(scene).encode()
    chunk += b" " * (-len(chunk) % 4)
    yield "glb", (struct.pack("<4sIIII", b"glTF", 2, 28 + len(chunk) + len(data), len(chunk), 0x4E4F534A) +
                  chunk + struct.pack("<II", len(data), 0x004E4942) + data)
    import base64
    scene["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    yield "text", json.dumps(scene).encode()


def scene():
    points = [[-2, -1], [-1, 2], [0, -2], [1, 2], [2, -1]]
    shapes = {
        "bezier": {"bezier": points},
        "chain": {"chain": {"degree": 2, "closed": False, "points": points}},
        "bspline": {"bspline": {"degree": 2, "closed": True, "points": points, "knots": [0, 1, 2, 3.5, 4, 5]}},
        "rational": {"rational": {"degree": 2, "closed": False, "points": points, "weights": [1, 2, 1, 0.5, 1]}},
        "family": {"family": {"name": "ellipse", "parameters": {"a": 1, "b": 1.5}, "at": [1, 2]}},
        "formula": {"formula": {"x": "a*cos(t)", "y": "sin(t)^2", "from": "0", "to": "2*pi", "constants": {"a": 2}}}}
    for name, shape in shapes.items():
        view = {"angleDeg": 60, "distance": None if name == "bezier" else 9}
        yield name, json.dumps({"flatland": 2, "curves": [{**shape, "flipNormal": True}], "view": view}).encode()


def svg():
    yield "shapes", (b'<svg xmlns="http://www.w3.org/2000/svg" width="9mm" viewBox="0 0 9 9"><style>.a{display:none}</style>'
                     b'<g transform="rotate(3 1 1)"><rect id="r" width="3" height="2" rx="1"/><circle r="2"/>'
                     b'<ellipse class="a" rx="2" ry="1"/><use href="#r" x="2"/></g><line x2="2" stroke="red"/>'
                     b'<polygon points="0,0 1 0 1,1"/><path d="M0 0A2 1 9 0 1 3 4z"/></svg>')
    for file in sorted((SOURCES / "tests/data/svg").glob("*.svg")):
        yield file.stem, file.read_bytes()


def path():
    yield "path", b"M1 2l3-4.5e0H4V5C1 2 3 4 5 6S1 2 3 4Q1 2 3 4T5 6a1 2 30 0 1 3 4zm1,1 2,2"
    yield "transform", b"translate(3) rotate(45 1 2) skewX(3) scale(2,1) matrix(1 0 0 1 2 3)"
    yield "points", b"1,2 3 4"
    yield "length", b"3.5mm"


def lesson():
    for file in sorted((SOURCES / "ui/lesson/lessons").rglob("*.md")):
        yield file.parent.name + file.stem, file.read_bytes()


def formula():
    for i, text in enumerate(["a*sin(2*t)^-2 + exp(-t^2/2)", "atan2(t, 1) - hypot(t, pow(t, 3)) / log10(e + t)",
                              "-(((1.5e-3 + t)))^2*sqrt(abs(acosh(t)))"]):
        yield str(i), text.encode()


def main():
    root = pathlib.Path(sys.argv[1])
    for form in ply, obj, off, stl, gltf, scene, svg, path, lesson, formula:
        folder = root / form.__name__
        folder.mkdir(parents=True, exist_ok=True)
        for name, content in form():
            (folder / name).write_bytes(content)


main()
