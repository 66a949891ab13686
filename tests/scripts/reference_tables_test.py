#!/usr/bin/env python3
"""reference_tables_test.py [FOLDER]: docs/reference/exit-codes.md has a row for every exit code in src/, environment.md one for every
environment variable that the program or a script reads or sets, and neither has a row for another one. FOLDER: another
copy of the project, for the test of this test."""

import glob
import os
import re
import sys

SOURCES = ("src/**/*.h", "src/**/*.cpp", "python/**/*.cpp", "python/**/*.py")
SCRIPTS = ("scripts/*.sh", "slurm/*.sh", "slurm/*.sbatch", "scripts/*.py")

# Names in capitals that are no environment variables: words of SVG and of usages, variables that bash has by itself, an
# option of CMake, a linker's word.
NO_VARIABLES = {"SCOPE_ID", "BASH_SOURCE", "SECONDS", "EUID", "EPOCHREALTIME", "IFS", "PWD", "OUT_DIR", "AS_NEEDED", "LD_LIB",
                "TESSERA_BUILD_TESTS", "NF"}

# Calls that end a process with a code, and returns of a code.
ENDS = re.compile(r"(?:\b_?exit|\b_Exit|\bquick_exit)\(([\w:]+)\)|\bMPI_Abort\([^,()]+, (\w+)\)")
CONSTANT = re.compile(r"constexpr int (k\w+) = (\d+);")
CODES_NAMED = re.compile(r"\bk\w*ExitCode\b")
RETURNED = re.compile(r"\breturn (\d+);")
# Here a number that is returned is an exit code.
RETURNING = re.compile(r"src/(cli|program)/|src/bench/main\.cpp$|src/artwork/drawer/drawer_main\.cpp$")


def texts(patterns):
    for pattern in patterns:
        for path in sorted(glob.glob(pattern, recursive=True)):
            with open(path, encoding="utf-8") as file:
                yield path, file.read()


def without_comments(path, text):
    if path.endswith((".h", ".cpp")):
        return re.sub(r"(?<!:)//.*", "", text)
    return re.sub(r"(?m)(^|\s)#.*$", r"\1", text)


def codes_of(path, text):
    """The numbers and constants that stand for exit codes."""
    found = {word.split("::")[-1] for groups in ENDS.findall(text) for word in groups if word}
    found |= set(CODES_NAMED.findall(text))
    if RETURNING.search(path):
        found |= set(RETURNED.findall(text))
    return found


def used_codes():
    """Code to the file that has it. Variables that hold a code name none."""
    values = {"EXIT_FAILURE": "1", "EXIT_SUCCESS": "0"}
    words = {}
    for path, text in texts(SOURCES[:2]):
        text = without_comments(path, text)
        values.update(CONSTANT.findall(text))
        for word in codes_of(path, text):
            words.setdefault(word, path)
    used = {}
    for word, path in words.items():
        if word.isdigit():
            used.setdefault(word, path)
        elif word in values:
            used.setdefault(values[word], path)
        elif word.startswith("k"):
            sys.exit(f"{path}: {word} has no value that this test finds")
    return used


def variables_of_source(text):
    """Names with an underscore in quotes, wherever they stand: many are given to functions that ask for them. Others, such as
    HOME, count where a function asks the environment for them."""
    return set(re.findall(r'["\'](OMPI_MCA_\w+|[A-Z][A-Z0-9]*_[A-Z0-9_]+)(?:=[^"\'\n]*)?["\']', text) +
               re.findall(r'env\w*\("([A-Z]+)"', text))


def variables_of_script(text):
    return set(re.findall(r"\$\{?!?([A-Z][A-Z0-9_]+)", text) + re.findall(r"(?m)(?:^|[\s;(&|])([A-Z][A-Z0-9_]+)=", text) +
               re.findall(r"(?<![\w-])(OMPI_MCA_\w+|[A-Z][A-Z0-9]*_[A-Z0-9_]+)\b", text))


def used_variables():
    used = {}
    for path, text in texts(SOURCES):
        for name in variables_of_source(without_comments(path, text)):
            used.setdefault(name, path)
    for path, text in texts(SCRIPTS):
        text = without_comments(path, text)
        for name in variables_of_source(text) if path.endswith(".py") else variables_of_script(text):
            used.setdefault(name, path)
    return {name: path for name, path in used.items() if name not in NO_VARIABLES}


def rows(page, name):
    """What stands in code in the first column of the page's tables."""
    with open(page, encoding="utf-8") as file:
        return {found for line in file if line.startswith("|") for found in re.findall(name, line.split("|")[1])}


def faults(page, told, used, kind):
    for name in sorted(set(used) - told):
        yield f"{page} lacks the {kind} {name}, which {used[name]} has"
    for name in sorted(told - set(used)):
        yield f"{page} has the {kind} {name}, which no source and no script has"


def main(root):
    os.chdir(root)
    codes = used_codes()
    variables = used_variables()
    found = list(faults("docs/reference/exit-codes.md", rows("docs/reference/exit-codes.md", r"`(\d+)`"), codes, "exit code"))
    found += faults("docs/reference/environment.md", rows("docs/reference/environment.md", r"`([A-Z]\w+)`"), variables,
                    "variable")
    for fault in found:
        print(fault, file=sys.stderr)
    if len(codes) < 5 or len(variables) < 30:
        sys.exit(f"found only {len(codes)} exit codes and {len(variables)} variables")
    return len(found) > 0


sys.exit(main(sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")))
