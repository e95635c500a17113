#!/usr/bin/python3
"""Living livers on pictures of a laparoscope, as contours: living_livers.py OUT [--data DIR]

Makes OUT/p2ilf (one picture: two ridges, the ligament, the silhouette) from p2ilf_frame, and OUT/encov (four pictures of one
patient: ridge, ligament, silhouette) from encov_patient4 of the shared data, in DIR (their SOURCE.txt say what they are). Both as
glisson-contours/1. EnCoV's drawn lines are ten pixels wide and taken whole; its landmarks are tubes, whose middles are taken, and
its ridge is the right and the left one together, since the pictures do not part them. Nothing is known of the true pose."""

import json
import pathlib
import struct
import sys
import zlib

sys.dont_write_bytecode = True
import numpy as np

from recordings import asked_for


def main():
    asked = asked_for(__doc__, "")
    p2ilf(asked.data / "p2ilf_frame" / "patient2_1", asked.out / "p2ilf")
    encov(asked.data / "encov_patient4", asked.out / "encov")


def p2ilf(data, out):
    out.mkdir(parents=True, exist_ok=True)
    vertices = np.array([[float(x) for x in line.split()[1:4]] for line in (data / "liver_model.obj").read_text().splitlines()
                         if line.startswith("v ")])
    camera = {key: float(value) for key, value in json.loads((data / "camera.json").read_text()).items() if key != "projection"}
    # Ridges are in the same order in the picture and on the model.
    ridges = lambda contours, n: sum(c["contourType"] == "Ridge" for c in contours[:n + 1])
    names = lambda contours: [f"ridge-{ridges(contours, n)}" if c["contourType"] == "Ridge" else c["contourType"].lower()
                              for n, c in enumerate(contours)]
    seen = json.loads((data / "contours_2d.json").read_text())["contour"]
    rest = json.loads((data / "contours_3d.json").read_text())["contour"]
    features = [feature(out, name, vertices[line["modelPoints"]["vertices"]]) for name, line in zip(names(rest), rest)]
    contours = [contour(out, "f0", name, np.column_stack([line["imagePoints"]["x"], line["imagePoints"]["y"]]))
                for name, line in zip(names(seen), seen)]
    write(out, "P2ILF, patient 2", data / "liver_model.obj",
          [[camera["fx"], 0, camera["cx"]], [0, camera["fy"], camera["cy"]], [0, 0, 1]],
          [camera[k] for k in ("k1", "k2", "p1", "p2", "k3")], features, [{"id": "f0", "contours": contours}])


def encov(data, out):
    out.mkdir(parents=True, exist_ok=True)
    ridge = np.vstack([middle_line(points_of(data / "model" / f"{side}_ridge.vtk")) for side in ("right", "left")])
    features = [feature(out, "ridge", ridge),
                feature(out, "ligament", middle_line(points_of(data / "model" / "ligament.vtk")))]
    frames = []
    for file in sorted((data / "frames").glob("*_contours.png")):
        picture, name = png(file).astype(int), "f" + file.name[:2]
        red, green, blue = (picture[..., k] >= 128 for k in range(3))
        drawn = {"ridge": blue & ~red & ~green, "ligament": red & ~green & ~blue, "silhouette": red & green & blue}
        contours = [contour(out, name, line, np.argwhere(there)[:, ::-1][::max(1, int(there.sum()) // 400)])
                    for line, there in drawn.items() if there.sum() > 100]
        frames.append({"id": name, "contours": contours})
    matrix = [[float(x) for x in row.split()] for row in (data / "intrinsic.txt").read_text().splitlines() if row.strip()]
    write(out, "EnCoV, patient 4", data / "model" / "liver.ply", matrix, [], features, frames)


def feature(out, name, points):
    table(out / f"{name}.csv", "x_mm,y_mm,z_mm", points)
    return {"id": name, "points": f"{name}.csv"}


def contour(out, frame, name, pixels):
    table(out / f"{frame}_{name}.csv", "x_px,y_px", pixels)
    return {"id": name, "pixels": f"{frame}_{name}.csv"}


def table(file, header, rows):
    file.write_text(header + "\n" + "\n".join(",".join(f"{x:.6g}" for x in row) for row in rows) + "\n")


def write(out, title, surface, matrix, distortion, features, frames):
    (out / "contours.json").write_text(json.dumps(
        {"format": "glisson-contours/1", "title": title, "model": {"surface": str(surface.resolve())},
         "camera": {"matrix": matrix, "distortion": distortion}, "features": features, "frames": frames}, indent=1) + "\n")


def points_of(file):
    """Of legacy VTK polydata in ASCII."""
    words = file.read_text().split()
    at = words.index("POINTS")
    return np.array(words[at + 3:at + 3 + 3 * int(words[at + 1])], dtype=float).reshape(-1, 3)


def middle_line(points, pieces=40):
    """Of a thin tube: the middles of its slices across its longest way."""
    middle = points.mean(axis=0)
    along = (points - middle) @ np.linalg.svd(points - middle, full_matrices=False)[2][0]
    slices = np.clip(((along - along.min()) / np.ptp(along) * pieces).astype(int), 0, pieces - 1)
    return np.array([points[slices == k].mean(axis=0) for k in range(pieces) if (slices == k).any()])


def png(file):
    """Rows, columns, channels of a picture of 8 bits a channel that is not interlaced."""
    data, at, packed = file.read_bytes(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IHDR":
            width, height, depth, colours, _, _, interlaced = struct.unpack(">IIBBBBB", data[at + 8:at + 21])
        elif kind == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += 12 + length
    channels = {0: 1, 2: 3, 4: 2, 6: 4}[colours]
    if depth != 8 or interlaced:
        sys.exit(f"{file}: only 8 bits, not interlaced")
    rows = np.frombuffer(zlib.decompress(packed), dtype=np.uint8).reshape(height, 1 + width * channels)
    picture = np.zeros((height, width * channels), dtype=np.uint8)
    for y in range(height):
        picture[y] = unfiltered(rows[y, 0], rows[y, 1:], picture[y - 1] if y else picture[0] * 0, channels)
    picture = picture.reshape(height, width, channels)
    return picture if channels >= 3 else np.repeat(picture[..., :1], 3, axis=2)


def unfiltered(kind, row, above, channels):
    if kind == 0:
        return row
    if kind == 2:
        return row + above
    line, up = row.reshape(-1, channels).astype(int), above.reshape(-1, channels).astype(int)
    if kind == 1:
        return np.cumsum(line, axis=0).astype(np.uint8).ravel()
    left, corner = np.zeros(channels, dtype=int), np.zeros(channels, dtype=int)
    for x in range(len(line)):
        if kind == 3:
            guess = (left + up[x]) // 2
        else:
            estimate = left + up[x] - corner
            off = np.stack([abs(estimate - left), abs(estimate - up[x]), abs(estimate - corner)])
            guess = np.choose(np.argmin(off, axis=0), [left, up[x], corner])
        corner, left = up[x], (line[x] + guess) & 255
        line[x] = left
    return line.astype(np.uint8).ravel()


if __name__ == "__main__":
    main()
