#!/usr/bin/env python3
"""documented_examples_test.py TESSERA NEW_FOLDER [PAGE...]: runs the commands of the documents, page by page, as a reader
would type them, and lets the program read the jobs of the documents.

Each page has a folder of its own, in which the inputs lie that the page speaks of (documented_examples_inputs.py). The lines of
the page's code blocks run there in their order. A line fails that ends with another exit code than 0. A line that is no command
must be in the output of the command before it. What cannot run here stands in EXCEPTED, with its reason; a rule of a table that
no line needs fails, too. PAGE runs some pages alone, without that last check."""

import concurrent.futures
import glob
import os
import re
import shutil
import subprocess
import sys
import time
import tomllib

import documented_examples_inputs as inputs

PAGES = ("README.md", "docs/guide/*.md", "docs/matching.md", "docs/mosaics.md", "docs/nesting.md", "docs/library.md",
         "docs/job-format.md", "docs/bundle.md", "docs/contributing.md", "slurm/README.md")
PAGES_WITH_JOBS = ("docs/guide/", "docs/job-format.md")
PAGES_AT_A_TIME = 2
MOST_S = 600  # for one command, on a machine with much other work
SHELL = ("", "sh", "bash", "console")

# What a command line begins with. In an indented block all other lines are no commands.
COMMAND = re.compile(r"(tessera|mpirun|scripts/|slurm/|bundle/|(RC_PARAMS=\S+ )?build/|export|source|cp|mkdir|tar|cmake|ctest|sbatch|apt-get|/usr/bin/python3)\b")

# Lines that do not run, by page and text, and why.
EXCEPTED = (
    (r"", r"scripts/(demo|test|build|install-packages)\.sh\b", "installs packages and builds the program"),
    (r"", r"cmake ", "builds or installs the program; cli.install and package.cpp_examples do it"),
    (r"docs/library.md", r"build/match_drawings ", "a program that the page builds; package.cpp_examples runs it"),
    (r"docs/library.md", r"/usr/bin/python3 |export PYTHONPATH", "the installed module; package.python runs these programs"),
    (r"docs/library.md", r"apt-get ", "installs packages"),
    (r"", r"sbatch |slurm/campaign\.sh ", "needs Slurm; tests/slurm does it"),
    (r"docs/guide/looking.md", r"tessera serve ", "waits for a browser; cli.serve does it"),
    (r"docs/guide/looking.md", r"srun |ssh ", "needs a cluster"),
    (r"docs/contributing.md", r"ctest ", "runs tests, as what runs this one"),
    (r"docs/contributing.md", r"mpirun .* xterm ", "waits in gdb, on a screen"),
    (r"docs/mosaics.md", r"tessera library build /usr/share/openclipart/svg ", "takes minutes; the page has a small library instead"),
    (r"docs/bundle.md", r"scripts/gpu-bundle\.sh |tar -xf |source bundle/|bundle/gpu-check\.sh ", "gpu_bundle_long does it"),
    (r"docs/nesting.md", r"parts?\.(dxf|svg): ", "a message; documented_messages looks for it in the sources"),
)

# Commands that run with more options than the page gives them: by page, text, options and why.
SHORTENED = (
    (r"docs/guide/benchmarks.md", r"tessera bench ", "--quick", "a benchmark takes minutes; the page says what --quick does"),
    (r"", r"(mpirun -n 5 )?tessera collage \"?my.drawings\"?(\.toml)?( --.*)?$", "--set improve.trials=2",
     "the usual 250 trials take half a minute"),
    (r"", r"tessera (mosaic |collage portrait\.toml)", "--set stop.pieces=40", "thousands of pieces take minutes"),
)

# Commands that end with another exit code than 0, and why.
EXIT_CODES = ()

# What the page takes for granted before a command: a shell command by page and text.
BEFORE = (
    (r"docs/guide/cluster.md", r"tessera collage my\.toml --resume\b(?!=)",  # a run that is interrupted after its first checkpoint
     "rm -r out/my && { tessera collage my.toml --set checkpoint.every_s=0 & } && "
     "until [[ -e out/my/checkpoint.h5 ]]; do sleep 0.01; done && kill %1 && { wait %1; [[ $? == 75 ]]; }"),
)


class Rules:
    """The rules of the tables that a page's line is about, and which of them some line needed."""

    def __init__(self):
        self.needed = set()

    def first(self, table, page, line):
        for rule in table:
            if re.search(rule[0], page) and re.match(rule[1], line):
                self.needed.add(rule)
                return rule
        return None

    def not_needed(self):
        return [rule for table in (EXCEPTED, SHORTENED, EXIT_CODES, BEFORE) for rule in table if rule not in self.needed]


def blocks_of(page):
    """(language, first line, lines) of each code block; the language of an indented one is "indented"."""
    with open(page, encoding="utf-8") as file:
        lines = file.read().split("\n")
    language, first, block = None, 0, []
    for number, line in enumerate(lines, 1):
        fence = re.match(r"```(\w*)$", line)
        indented = line.startswith("    ") and (language == "indented" or language is None and lines[number - 2] == "")
        if language == "indented" and not indented:
            yield language, first, block
            language = None
        if language is None and (fence or indented):
            language, first, block = (fence[1], number + 1, []) if fence else ("indented", number, [])
            if fence:
                continue
        elif fence:
            yield language, first, block
            language = None
        if language is not None:
            block.append(line[4:] if indented else line)


def joined(first, lines):
    """(number, line) of a block, continued lines as one, empty ones and comments left out."""
    text, began = "", first
    for number, line in enumerate(lines, first):
        began = began if text else number
        text += line.strip()
        if text.endswith("\\"):
            text = text[:-1]
            continue
        if text and not text.startswith("#"):
            yield began, text
        text = ""


def without_comment(line):
    return re.sub(r"\s+#\s.*$", "", line)


class PageRun:
    def __init__(self, page, folder, environment, rules):
        self.page, self.folder, self.rules = page, folder, rules
        self.environment = dict(environment, HOME=folder)
        self.exports = ""
        self.faults, self.times = [], []

    def fault(self, number, line, word):
        self.faults.append(f"{self.page}:{number}: {line}")
        print(f"FAILED {self.page}:{number}: {line}\n    {word}", flush=True)

    def ran(self, number, line, started):
        self.times.append((time.monotonic() - started, f"{self.page}:{number}: {line}"))

    def shell(self, command):
        try:
            run = subprocess.run(["bash", "-c", f"{self.exports}\n{command}"], cwd=self.folder, env=self.environment, text=True,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, timeout=MOST_S, check=False,
                                 errors="replace")
        except subprocess.TimeoutExpired as expired:
            return "no", (expired.stdout or b"").decode(errors="replace")
        return run.returncode, run.stdout

    def command(self, number, line):
        """What the command prints; None where it does not run."""
        if self.rules.first(EXCEPTED, self.page, line):
            return None
        plain = without_comment(line)
        if line.startswith("export "):
            self.exports += f"\n{plain}"
        before = self.rules.first(BEFORE, self.page, line)
        if before:
            code, output = self.shell(before[2])
            if code != 0:
                self.fault(number, before[2], f"exit code {code}, before the line of the page; it printed:\n{output[-1500:]}")
        shortened = self.rules.first(SHORTENED, self.page, plain)
        expected = self.rules.first(EXIT_CODES, self.page, line)
        started = time.monotonic()
        code, output = self.shell(f"{plain} {shortened[2]}" if shortened else plain)
        self.ran(number, plain, started)
        if code != (expected[2] if expected else 0):
            self.fault(number, plain, f"exit code {code}; it printed:\n{output[-1500:]}")
        return output

    def block(self, first, lines, indented):
        printed = None
        for number, line in joined(first, lines):
            if COMMAND.match(line):
                printed = self.command(number, line)
            elif not indented and not self.rules.first(EXCEPTED, self.page, line):
                if printed is None or " ".join(line.split()) not in " ".join(printed.split()):
                    self.fault(number, line, "neither a command that this test knows nor what the command before it prints")

    def job(self, first, lines):
        """A whole job, or a part of one: with a library and a canvas the program accepts it."""
        text = "\n".join(lines)
        try:
            known = tomllib.loads(text)
        except tomllib.TOMLDecodeError as error:
            self.fault(first, lines[0], f"no TOML: {error}")
            return
        # Tables of others come last, so that keys without a table stay first.
        text += "" if "library" in known else "\n[library]\nfile = \"../out/animals.h5\"\n"
        text += "" if "canvas" in known else "\n[canvas]\nsize_px = [1000, 1000]\n"
        with open(os.path.join(self.folder, "jobs", "of_page.toml"), "w", encoding="utf-8") as file:
            file.write(text)
        started = time.monotonic()
        code, output = self.shell("tessera plan jobs/of_page.toml")
        self.ran(first, "a job", started)
        if code != 0 or "warning" in output or "unknown" in output:
            self.fault(first, lines[0], f"tessera plan of this job: exit code {code}; it printed:\n{output[-1500:]}")

    def run(self):
        for language, first, lines in blocks_of(self.page):
            if language in SHELL or language == "indented":
                self.block(first, lines, language == "indented")
            is_job = language == "toml" or language == "indented" and re.match(r"\[+[a-z_]+\]+$", lines[0])
            if is_job and self.page.startswith(PAGES_WITH_JOBS):
                self.job(first, lines)


def main(program, folder, pages_asked):
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
    started = time.monotonic()
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    environment = dict(os.environ, TESSERA=program, PATH=f"{os.path.dirname(program)}:{os.environ['PATH']}",
                       OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMPI_MCA_rmaps_base_oversubscribe="1",
                       OMPI_MCA_hwloc_base_binding_policy="none", OMPI_MCA_mpi_yield_when_idle="1", LC_ALL="C.UTF-8")
    environment.pop("SLURM_JOB_END_TIME", None)
    pages = [page for pattern in PAGES for page in sorted(glob.glob(pattern))]
    assert len(pages) > 20, f"found only {len(pages)} pages"
    pages = [page for page in pages if not pages_asked or page in pages_asked]
    rules = Rules()
    maker = inputs.Maker(program, os.path.join(folder, "made"), environment)

    def run_page(page):
        run = PageRun(page, os.path.join(folder, page.replace("/", "_").removesuffix(".md")), environment, rules)
        try:
            maker.fill(run.folder, page)
            run.run()
        except inputs.NoInputError as error:
            run.fault(1, "the inputs of this page", str(error))
        return run

    with concurrent.futures.ThreadPoolExecutor(PAGES_AT_A_TIME) as pool:
        runs = list(pool.map(run_page, pages))
    not_needed = [] if pages_asked else rules.not_needed()
    for rule in not_needed:
        print(f"FAILED no line of a page needs this rule any more: {rule}")
    times = [entry for run in runs for entry in run.times]
    print("the slowest:")
    for taken, line in sorted(times, reverse=True)[:15]:
        print(f"{taken:6.1f} s  {line}")
    faults = sum(len(run.faults) for run in runs) + len(not_needed)
    used = os.times()
    print(f"{len(times)} examples of {len(pages)} pages in {time.monotonic() - started:.0f} s, "
          f"{used.children_user + used.children_system:.0f} s of processor time, {faults} faults")
    return faults > 0


if __name__ == "__main__":
    sys.exit(main(os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2]), sys.argv[3:]))
