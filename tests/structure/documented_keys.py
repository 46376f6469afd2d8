#!/usr/bin/env python3
"""Each page that describes a file format names every key of its schema, and the format as the schema has it.

    documented_keys.py <repository>

A key counts as named where it stands in backticks or, in a JSON example, in quotes. Prints what is missing.
"""
import json
import pathlib
import re
import sys

PAGES = {
    "orbs-scene": "docs/reference/scene-format.md",
    "orbs-case": "docs/use/cases.md",
    "orbs-configuration": "docs/use/renderers.md",
}


def keys_of(schema):
    """All names of properties, at any depth."""
    if isinstance(schema, list):
        return set().union(*map(keys_of, schema), set())
    if not isinstance(schema, dict):
        return set()
    own = schema.get("properties")
    own = set(own) if isinstance(own, dict) else set()
    return own.union(*map(keys_of, schema.values()))


def named_in(text):
    """Words in backticks or quotes; `-e` and `path.EDL.R` are no keys and do no harm."""
    spans = re.findall(r"`([^`\n]+)`", text)
    return {word for span in spans for word in re.findall(r"\w+", span)} | set(re.findall(r'"(\w+)"', text))


def complaints(schema_name, schema, page_name, page):
    missing = sorted(keys_of(schema) - named_in(page))
    found = [f"{page_name}: does not name the key '{key}' of {schema_name}" for key in missing]
    wanted = schema["properties"]["format"]["const"]
    kind = re.escape(wanted.split("/")[0])
    other = set(re.findall(rf"{kind}/\d+", page)) - {wanted}
    return found + [f"{page_name}: says {one}, {schema_name} is of {wanted}" for one in sorted(other)]


def self_test():
    schema = {"properties": {"format": {"const": "x/2"}, "a": {"items": {"properties": {"b": {}}}}}}
    assert complaints("s", schema, "p", "`format` x/2 `a` \"b\"") == []
    assert complaints("s", schema, "p", "format `x/1` `a`") == [
        "p: does not name the key 'b' of s", "p: does not name the key 'format' of s", "p: says x/1, s is of x/2"]


def main():
    self_test()
    root = pathlib.Path(sys.argv[1])
    found = []
    for kind, page in PAGES.items():
        (file,) = (root / "data/schema").glob(kind + "-[0-9]*.schema.json")
        found += complaints(file.name, json.loads(file.read_text()), page, (root / page).read_text())
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
