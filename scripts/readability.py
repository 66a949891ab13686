#!/usr/bin/env python3
"""scripts/readability.py [COMMIT]: measures the documents and the comments over declarations: words in a sentence, sentences longer
than 25 words, comments that begin in the middle, and words outside the glossary. It is a hint for writers, not a gate."""

import os
import re
import subprocess
import sys

LONG_SENTENCE = 25
# A comment that begins with such a word has no subject: "Of the pieces of a window, as they change."
FRAGMENT = re.compile(r"(Of|By|That|Those|Which|What|Where|How|As|In|On|For|From|With|Without|To be|Nothing|None|Or|Also|The same)\b")
# Private words in the place of the field's: "looked at" for "searched", "come to rest" for "converge", "so many" without a number.
PRIVATE = re.compile(r"\b(come[s]? to rest|at rest|now and then|so (?:many|much|far) (?!as)|whoever|nobody|somebody|looks? at|looked at|"
                     r"is told|are told|is asked|are asked|makes? way|gives? way|goes? by|what of|none of its kind|in its turn|for good|"
                     r"as ever|of its kind|all the same|stands? for|lays? down)\b", re.I)
GROUPS = {
    "README.md": r"README\.md$",
    "docs/guide": r"docs/guide/.*\.md$",
    "docs/concepts": r"docs/concepts/.*\.md$",
    "reference": r"docs/(?!guide|gallery|measurements|scaling)[^/]*\.md$|docs/reference/(?!commands|job-keys).*\.md$",
    "measurements": r"docs/(measurements|scaling)\.md$|docs/measurements/.*\.md$",
    "decisions": r"docs/decisions/.*\.md$",
    "ARCHITECTURE.md": r"ARCHITECTURE\.md$",
    "comments in headers": r"(src|include)/.*\.h$",
}


def files(commit):
    """The pairs (path, text) of all files in a commit or in the working tree."""
    if commit:
        names = subprocess.run(["git", "ls-tree", "-r", "--name-only", commit], capture_output=True, text=True, check=True).stdout
        wanted = [name for name in names.split("\n") if any(re.match(p, name) for p in GROUPS.values())]
        for name in wanted:
            yield name, subprocess.run(["git", "show", f"{commit}:{name}"], capture_output=True, text=True, check=True).stdout
        return
    for root in ("src", "include", "docs", "."):
        for folder, folders, names in os.walk(root):
            if root == ".":
                folders.clear()
            for name in names:
                path = os.path.normpath(os.path.join(folder, name))
                if any(re.match(p, path) for p in GROUPS.values()):
                    with open(path, encoding="utf-8") as file:
                        yield path, file.read()


def prose_of_page(text):
    text = re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S)
    text = re.sub(r"^    .*$|^\|.*$|^#.*$|^\[?!\[.*$", "", text, flags=re.M)
    text = re.sub(r"`[^`\n]*`", "X", text)
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text)
    return re.split(r"\n\s*\n|\n\s*[-*\d]+[. ] ?", text)


def comments_of(text):
    """Blocks of lines that begin with /// or, at the top of a file, with //."""
    return [re.sub(r"^\s*///? ?", "", block, flags=re.M)
            for block in re.findall(r"(?:^[ \t]*///.*\n)+|\A(?:// .*\n)+", text, flags=re.M)]


def sentences_of(paragraph):
    text = re.sub(r"\s+", " ", paragraph).strip()
    return [s for s in re.split(r"(?<=[.!?:;])\s+(?=[A-Z`\"(])", text) if len(s.split()) > 2]


def main(commit):
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    counts = {group: [0] * 6 for group in GROUPS}  # sentences, words, long ones, blocks, fragments, private words
    for path, text in files(commit):
        group = next(g for g, p in GROUPS.items() if re.match(p, path))
        count = counts[group]
        for block in comments_of(text) if path.endswith(".h") else prose_of_page(text):
            sentences = sentences_of(block)
            if not sentences:
                continue
            count[3] += 1
            count[4] += bool(FRAGMENT.match(sentences[0]))
            for sentence in sentences:
                words = len(sentence.split())
                count[0] += 1
                count[1] += words
                count[2] += words > LONG_SENTENCE
                count[5] += len(PRIVATE.findall(sentence))
    print("| | sentences | words in one | longer than 25 words | begin in the middle | private words in 1,000 |\n|---|---|---|---|---|---|")
    for group, (sentences, words, long_ones, blocks, fragments, private) in counts.items():
        if sentences:
            print(f"| {group} | {sentences} | {words / sentences:.1f} | {100 * long_ones / sentences:.0f} % | "
                  f"{100 * fragments / blocks:.0f} % | {1000 * private / words:.1f} |")


main(sys.argv[1] if len(sys.argv) > 1 else None)
