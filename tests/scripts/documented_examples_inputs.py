"""The inputs of documented_examples_test.py: what the pages speak of, small, made of the repository's files, of Debian's
openclipart and of a few drawings of this file. Pictures are drawn by rsvg-convert."""

import glob
import json
import os
import re
import shutil
import subprocess
import threading

CLIPART = "/usr/share/openclipart/svg/animals"
# Names that the pages use, and the drawings that stand for them here.
NAMED_DRAWINGS = {
    "bird": "birds/puffin-md", "cat": "mammals/housecats/gatto_cat_architetto_fra_02",
    "cat_sitting": "mammals/housecats/gatto_cat_architetto_fra_04", "elephant": "mammals/elefante01_architetto_fr_01",
    "leone_01_architetto_fran_01": "mammals/big_cats/leone_01_architetto_fran_01", "owl": "birds/gufo_civetta_architetto__01",
    "whale": "mammals/bluewhale-md",
}
OTHER_DRAWINGS = 33

# Outlines on a page of 100 x 100.
SHAPES = {
    "bean": "M10 50 C10 10 90 10 90 50 C90 90 70 60 50 60 C30 60 10 90 10 50Z",
    "star": "M50 5 L61 38 L95 38 L67 59 L78 93 L50 72 L22 93 L33 59 L5 38 L39 38Z",
    "corner": "M10 10 H90 V45 H45 V90 H10Z",
    "leaf": "M10 90 C10 30 50 10 90 10 C90 60 60 90 10 90Z",
    "drop": "M50 5 C60 40 85 50 85 70 A35 25 0 0 1 15 70 C15 50 40 40 50 5Z",
    "arrow": "M5 40 H55 V15 L95 50 L55 85 V60 H5Z",
}
COLOURS = ("teal", "crimson", "orange", "olive", "navy", "purple", "sienna")

TANGRAM = ("0,0 4,0 2,2", "0,0 2,2 0,4", "4,2 4,4 2,4", "4,0 4,2 3,1", "2,2 3,3 1,3", "2,2 3,1 4,2 3,3", "0,4 1,3 3,3 2,4")

# A job that takes about a second. The square has far more than 40 pieces, and the rectangle of changing.md lies in it.
JOB = """quality = "draft"
[library]
file = "my.h5"
[canvas]
size_px = {size}
[pieces]
scale_px = {scale}
[output]
width_px = 300
"""
SMALL = {"size": [200, 150], "scale": [25, 60]}
SQUARE = {"size": [450, 450], "scale": [30, 75]}
FLAT = {"size": [1600, 20], "scale": [8, 16]}  # with few pieces: 60,000 px wide it is 750 px high

# What lies in the folder of each page, beside what lies in that of all pages; "NAME: OTHER" is OTHER under the name NAME.
OF_PAGES = {
    "README.md": ["my_drawings", "heart.svg", "out/animals.h5: animals.h5", "portrait.jpg", "jigsaw.h5", "parts.svg", "torn.png"],
    "docs/guide/benchmarks.md": ["out/animals.h5: animals.h5", "all.h5: my.h5", "cup.jpg: portrait.jpg", "silhouettes"],
    "docs/guide/campaigns.md": ["my.h5", "my.toml", "result", "other_result", "theirs.geojson", "theirs.png", "heart.svg", "photo.jpg"],
    "docs/guide/changing.md": ["result: square", "my.h5", "scribble.png", "marks.json"],
    "docs/guide/cluster.md": ["my.h5", "my.toml: improved.toml"],
    "docs/guide/cutting.md": ["parts.svg", "parts.dxf", "parts", "swim.json", "my.h5: shapes.h5"],
    "docs/guide/first-collage.md": ["my_drawings", "my drawings: my_drawings", "line_art: signs", "heart.svg", "out/animals.h5: animals.h5"],
    "docs/guide/install.md": ["tessera"],
    "docs/guide/looking.md": ["result: square", "other_result", "my.h5", "my.toml", "marks.json"],
    "docs/guide/mosaics.md": ["portrait.jpg", "my.h5"],
    "docs/guide/posters.md": ["out/animals.h5: animals.h5"],
    "docs/guide/printing.md": ["result: flat", "my.h5"],
    "docs/guide/puzzles.md": ["photo.jpg", "scan.png", "heart.svg", "tangram", "house.svg"],
    "docs/guide/recognition.md": ["duck.svg", "goose.svg", "torn.png", "my.h5"],
    "docs/guide/styles.md": ["my.h5", "my.toml"],
    "docs/matching.md": ["signs", "photo_mask.png", "q.svg", "large.h5: shapes.h5"],
    "docs/mosaics.md": ["astronaut.jpg: portrait.jpg", "openclipart.h5: my.h5"],
    "docs/job-format.md": ["out/animals.h5: my.h5", "out/birds.h5: shapes.h5", "out/openclipart.h5: my.h5", "jobs/australia.png"],
    "docs/bundle.md": ["bundle"],
    "slurm/README.md": ["my.h5", "my.toml"],
}


def svg(content, width=100, height=100, unit="", box=None):
    return (f"<svg xmlns='http://www.w3.org/2000/svg' width='{width}{unit}' height='{height}{unit}' "
            f"viewBox='{box or f'0 0 {width} {height}'}'>{content}</svg>\n")


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


class NoInputError(Exception):
    """An input cannot be made: the message says why."""


class Maker:
    """Makes each input once, in a folder of its own, and gives copies of them to the folders of pages."""

    def __init__(self, program, folder, environment):
        self.program, self.folder, self.environment = program, folder, environment
        self.lock = threading.RLock()
        os.makedirs(folder)

    def fill(self, folder, page):
        """Makes the folder of a page: as the repository's after scripts/demo.sh, as far as the page needs it."""
        os.makedirs(folder)
        for part in ("scripts", "slurm", "docs/matching", "bench"):
            shutil.copytree(part, os.path.join(folder, part))
        os.makedirs(os.path.join(folder, "build", "release", "src"))
        os.symlink(os.path.dirname(self.program), os.path.join(folder, "build", "release", "src", "cli"))
        tests = os.path.join(os.path.dirname(self.program), "..", "..", "tests")
        os.symlink(os.path.realpath(tests), os.path.join(folder, "build", "release", "tests"))
        if page != "docs/guide/install.md":  # whose reader begins in a folder without them
            os.makedirs(os.path.join(folder, "out"))
            shutil.copytree(self.made("jobs"), os.path.join(folder, "jobs"))
        for entry in OF_PAGES.get(page, []):
            name, _, other = entry.partition(": ")
            source, target = self.made(other or name), os.path.join(folder, name)
            if os.path.isdir(source):
                shutil.copytree(source, target, symlinks=True)
            else:
                shutil.copy(source, target)

    def made(self, name):
        path = os.path.join(self.folder, name)
        with self.lock:
            if not os.path.exists(path):
                os.makedirs(os.path.dirname(path), exist_ok=True)
                getattr(self, "make_" + re.sub(r"\W", "_", name))(path)
        return path

    def run(self, *arguments):
        run = subprocess.run(arguments, cwd=self.folder, env=self.environment, text=True, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, check=False)
        if run.returncode != 0:
            raise NoInputError(f"{' '.join(arguments)}: exit code {run.returncode}; it printed:\n{run.stdout[-1500:]}")

    def tessera(self, *arguments):
        self.run(self.program, *arguments)

    def picture(self, path, content, width, height, *options):
        write(path + ".svg", svg(content, width, height))
        self.run("rsvg-convert", path + ".svg", "-o", path, *options)
        os.remove(path + ".svg")

    # Drawings

    def make_my_drawings(self, path):
        os.makedirs(path)
        for name, drawing in NAMED_DRAWINGS.items():
            shutil.copy(f"{CLIPART}/{drawing}.svg", f"{path}/{name}.svg")
        shutil.copy("docs/matching/duck.svg", path)
        small = [file for file in sorted(glob.glob(f"{CLIPART}/**/*.svg", recursive=True)) if 4000 < os.path.getsize(file) < 25000]
        if len(small) < OTHER_DRAWINGS:
            raise NoInputError(f"found {len(small)} drawings in {CLIPART}; needed: Debian's package openclipart-svg")
        for file in small[::len(small) // OTHER_DRAWINGS][:OTHER_DRAWINGS]:
            shutil.copy(file, path)

    def make_signs(self, path):
        os.makedirs(path)
        for (name, outline), colour in zip(SHAPES.items(), COLOURS):
            write(f"{path}/{name}.svg", svg(f"<path fill='{colour}' d='{outline}'/>"))

    def make_tangram(self, path):
        os.makedirs(path)
        for number, (corners, colour) in enumerate(zip(TANGRAM, COLOURS)):
            write(f"{path}/{number}.svg", svg(f"<polygon fill='{colour}' points='{corners}'/>", 404, 404, "", "-.02 -.02 4.04 4.04"))

    def make_heart_svg(self, path):
        shutil.copy("jobs/canvas/heart.svg", path)

    def make_house_svg(self, path):
        shutil.copy("jobs/canvas/house.svg", path)

    def make_duck_svg(self, path):
        shutil.copy("docs/matching/duck.svg", path)

    def make_goose_svg(self, path):
        shutil.copy("docs/matching/duck-5.svg", path)

    def make_q_svg(self, path):
        write(path, svg(f"<path fill='teal' transform='rotate(30 50 50)' d='{SHAPES['leaf']}'/>", 150, 150, "", "-25 -25 150 150"))

    # Photos and pictures

    def make_portrait_jpg(self, path):
        shutil.copy("jobs/photos/astronaut.jpg", path)

    def make_photo_jpg(self, path):
        shutil.copy("jobs/photos/chelsea.png", path)  # 3:2; readers go by the first bytes of a file

    def make_torn_png(self, path):
        """The left part of a duck, which is in the library."""
        self.run("rsvg-convert", self.made("duck.svg"), "--page-width", "180", "--page-height", "260", "-o", path)

    def make_photo_mask_png(self, path):
        self.picture(path, f"<rect width='200' height='200'/><path fill='white' transform='translate(40 10) scale(1.6) "
                           f"rotate(20)' d='{SHAPES['bean']}'/>", 200, 200)

    def make_scribble_png(self, path):
        self.picture(path, "<path d='M60 80 L200 120 L120 180' stroke='red' stroke-width='9' fill='none'/>", *SQUARE["size"])

    def make_scan_png(self, path):
        pieces = "".join(f"<path fill='{colour}' transform='translate({20 + 120 * (k % 3)} {20 + 120 * (k // 3)})' d='{outline}'/>"
                         for k, (outline, colour) in enumerate(zip(SHAPES.values(), COLOURS)))
        self.picture(path, f"<rect width='400' height='280' fill='white'/>{pieces}", 400, 280)

    def make_silhouettes(self, path):
        os.makedirs(path)
        for name, outline in SHAPES.items():
            for number, turn in ((1, 0), (2, 35)):
                self.picture(f"{path}/{name}-{number}.png", f"<rect width='200' height='200'/><path fill='white' transform='"
                             f"translate(30 30) rotate({turn} 70 70) scale(1.4)' d='{outline}'/>", 200, 200)

    def make_jobs_australia_png(self, path):
        self.run("rsvg-convert", os.path.abspath("jobs/canvas/australia.svg"), "-o", path)

    # Parts for a cutter

    def make_parts_svg(self, path):
        write(path, svg("".join(f"<path id='{name}' transform='translate({110 * k} 0)' d='{outline}'/>"
                                for k, (name, outline) in enumerate(SHAPES.items())), 660, 100, "mm"))

    def make_parts_dxf(self, path):
        corners = ((0, 0), (120, 0), (120, 40), (50, 40), (50, 90), (0, 90))
        vertices = "".join(f"0\nVERTEX\n8\n0\n10\n{x}\n20\n{y}\n" for x, y in corners)
        entities = f"0\nPOLYLINE\n8\n0\n66\n1\n70\n1\n{vertices}0\nSEQEND\n0\nCIRCLE\n8\n0\n10\n300\n20\n50\n40\n45\n"
        write(path, f"0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n{entities}0\nENDSEC\n0\nEOF\n")

    def make_parts(self, path):
        os.makedirs(path)
        for name, outline in (("wheel", SHAPES["corner"]), ("wheel_small", SHAPES["arrow"]), ("lid", "M5 5H95V50Z")):
            write(f"{path}/{name}.svg", svg(f"<path d='{outline}'/>", 100, 100, "mm"))
        shutil.copy(self.made("parts.dxf"), f"{path}/plate.dxf")

    def make_swim_json(self, path):
        corners = [[0, 0], [30, 0], [30, 10], [12, 10], [12, 25], [0, 25], [0, 0]]
        triangle = [[0, 0], [20, 0], [0, 16], [0, 0]]
        write(path, json.dumps({"name": "swim", "strip_height": 60, "items": [
            {"id": k, "demand": 2, "allowed_orientations": [0, 180], "shape": {"type": "simple_polygon", "data": data}}
            for k, data in enumerate((corners, triangle))]}))

    # Libraries

    def make_animals_h5(self, path):
        self.tessera("library", "build", CLIPART, "-o", path)

    def make_my_h5(self, path):
        self.tessera("library", "build", self.made("my_drawings"), "--embed", "-o", path)

    def make_shapes_h5(self, path):
        self.tessera("library", "build", self.made("signs"), "--embed", "-o", path)

    def make_jigsaw_h5(self, path):
        self.tessera("puzzle", "make", self.made("photo.jpg"), "--pieces", "12", "--out", "jigsaw")
        self.tessera("library", "build", "jigsaw/pieces", "--puzzle", "--embed", "-o", path)

    # Jobs and results

    def make_jobs(self, path):
        """Those of the repository with few pieces and few trials, and small pictures of them."""
        shutil.copytree("jobs", path)
        for file in glob.glob(f"{path}/*.toml"):
            with open(file, encoding="utf-8") as job:
                text = job.read()
            text = re.sub(r"^trials = [1-9].*", "trials = 1", text, flags=re.M)
            text = re.sub(r"^quality = .*", 'quality = "draft"', text, flags=re.M)
            text = re.sub(r"^width_px = .*", "width_px = 300", text, flags=re.M)
            if file.endswith("/once.toml"):  # every drawing has a place, so few drawings it is
                text = re.sub(r"^exclude = \[.*?\"\]", 'include = ["dino*"]', text, flags=re.M | re.S)
            elif "[stop]" not in text:
                text += "\n[stop]\npieces = 30\n"
            write(file, text)

    def make_my_toml(self, path):
        self.made("my.h5")
        write(path, JOB.format(**SMALL))

    def make_improved_toml(self, path):
        """Long enough to be interrupted."""
        self.made("my.h5")
        write(path, f"improve.trials = 12\n{JOB.format(**SMALL)}")

    def make_result(self, path):
        self.tessera("collage", self.made("my.toml"), "--out", path)

    def make_other_result(self, path):
        self.tessera("collage", self.made("my.toml"), "--set", "seed=2", "--out", path)

    def make_square(self, path):
        self.of_canvas(SQUARE, path)

    def make_marks_json(self, path):
        """As its page saves them, of two pieces of the square."""
        with open(f"{self.made('square')}/manifest.json", encoding="utf-8") as file:
            digest = json.load(file)["pieces"]["digest"]
        write(path, json.dumps({"format": 1, "pieces_digest": digest, "action": "erase", "pieces": [3, 17], "lock": [4]}))

    def make_flat(self, path):
        self.of_canvas(FLAT, path, "[stop]\npieces = 5\n")

    def of_canvas(self, values, path, more=""):
        self.made("my.h5")
        write(path + ".toml", JOB.format(**values) + more)
        self.tessera("collage", path + ".toml", "--out", path)

    def make_theirs_geojson(self, path):
        shutil.copy(f"{self.made('result')}/pieces.geojson", path)

    def make_theirs_png(self, path):
        """A mosaic of the photo, of as few colours as can be."""
        self.picture(path, "<rect width='451' height='300' fill='sienna'/><circle cx='220' cy='150' r='90' fill='wheat'/>", 451, 300)

    # Folders of the program

    def make_tessera(self, path):
        """As an installation: the program, and the jobs that came with it."""
        os.makedirs(f"{path}/share/tessera")
        os.symlink(os.path.dirname(self.program), f"{path}/bin")
        shutil.copytree(self.made("jobs"), f"{path}/share/tessera/jobs")

    def make_bundle(self, path):
        os.makedirs(path)
        shutil.copytree(self.made("my_drawings"), f"{path}/animals")
        shutil.copytree(self.made("jobs"), f"{path}/jobs")
