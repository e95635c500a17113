#!/usr/bin/python3
"""batched_names_test.py ROOT: no call can reach a neighbour's function by mistake.

Files of a room are compiled several at a time (CMake's unity builds), so that the anonymous namespaces of neighbours are one. Functions
of one name are overloads there; where their parameters convert into each other, or one is a template over its type, a call may be taken
for the other's without a word. Told here for all files of a target, whichever share a batch. See docs/decisions/unity-build.md.
"""

import collections
import itertools
import pathlib
import re
import sys

NUMBERS = {"double", "float", "int", "unsigned", "bool", "std::size_t", "std::int64_t", "std::uint64_t", "Eigen::Index", "qint64"}
TEXTS = {"std::string", "std::string_view", "char", "fs::path", "std::filesystem::path", "QString"}


def main():
    root = pathlib.Path(sys.argv[1])
    files = 0
    faults = []
    for folder in targets(root):
        functions = collections.defaultdict(set)
        for file in sources(folder):
            files += 1
            for name, parameters in hidden_functions(file.read_text()):
                functions[name].add((str(file.relative_to(root)), parameters))
        for name, those in functions.items():
            for (file, one), (other_file, other) in itertools.combinations(sorted(those), 2):
                if file != other_file and len(one) == len(other) and all(map(converts, one, other)):
                    faults.append(f"{file} and {other_file} both hide a {name}({', '.join(one)} | {', '.join(other)})")
    own = list(hidden_functions("#include <a>\nnamespace {\ndouble size(double a);\n}\nnamespace {\ntemplate <class T>\ndouble size(const std::vector<T>& a) { return a[0]; }\n}\n"))
    if len(own) != 2 or not converts(own[0][1][0], own[1][1][0]) or files < 500:
        faults.append(f"this test no longer sees what it is there for ({files} files, {own})")
    print("\n".join(faults) or f"{files} files: none can be mistaken")
    return 1 if faults else 0


def targets(root):
    """A folder a target, but for two whose files are programs of their own."""
    programs = {root / "tests" / "benchmarks", root / "tests" / "widgets"}
    return sorted({f.parent for top in ("app", "core", "widgets", "tests") for f in (root / top).rglob("CMakeLists.txt")} - programs)


def sources(folder):
    """Of one target: what lies below, but for what has a CMakeLists.txt of its own."""
    inner = {f.parent for f in folder.rglob("CMakeLists.txt")} - {folder}
    return [f for f in sorted(folder.rglob("*.cpp")) if not any(i in f.parents for i in inner)]


def hidden_functions(text):
    """(name, types of its parameters) of each free function of an anonymous namespace."""
    text = re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|^#[^\n]*', "", text, flags=re.S | re.M)
    for begin in re.finditer(r"\bnamespace\s*\{", text):
        inside = collapsed(text[begin.end():])
        for statement in re.split(r";|\{\}", inside):
            statement = re.sub(r"\[\[.*?\]\]", "", statement).strip()
            found = re.match(r"(?P<before>[^=()]*?[\w>&*\]])\s+[&*]*(?P<name>\w+)\s*\((?P<inside>.*)\)\s*(?:const|noexcept)?\s*$", statement, re.S)
            if found and not re.match(r"(?:using|return|struct|class|enum|TEST|namespace)\b", statement):
                generic = set(re.findall(r"(?:class|typename|auto)\s+(\w+)", found["before"]))
                yield found["name"], tuple(type_of(p, generic) for p in split(found["inside"]))


def collapsed(text):
    """Up to the brace that closes it; what stands in braces is left out."""
    depth, kept = 0, []
    for char in text:
        if char == "{":
            depth += 1
        elif char == "}":
            depth -= 1
            if depth < 0:
                break
            if depth == 0:
                kept.append("{}")
        elif depth == 0:
            kept.append(char)
    return "".join(kept)


def split(parameters):
    depth, part, parts = 0, "", []
    for char in parameters:
        depth += (char in "<([") - (char in ">)]")
        if char == "," and depth == 0:
            parts.append(part)
            part = ""
        else:
            part += char
    return [p for p in [*parts, part] if p.strip()]


def type_of(parameter, generic):
    parameter = re.sub(r"=.*$", "", parameter, flags=re.S).strip()
    named = re.match(r"(.*[&*>\s])\s*\w+$", parameter, re.S)
    bare = re.sub(r"\bconst\b|[&*]|\s", "", named[1] if named and named[1].strip() != "const" else parameter)
    return "auto" if generic & set(re.findall(r"\w+", bare)) or "auto" in bare else bare


def converts(one, other):
    if one == other or "auto" in (one, other):
        return True
    return any({one, other} <= alike for alike in (NUMBERS, TEXTS))


if __name__ == "__main__":
    sys.exit(main())
