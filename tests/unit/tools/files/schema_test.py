"""The JSON Schema of scenario files, and that of a core that describes itself, against the verdicts of their readers."""

import copy
import json
import re
import unittest

import jsonschema

from program import SOURCE

SCHEMA = SOURCE / "tools/files/scenario.schema.json"
FILES, DESCRIBED = SOURCE / "tests/unit/tools/files", SOURCE / "tests/unit/tools/described"


def read(path):
    return json.loads(path.read_text(encoding="utf-8"))


def tokens(pointer):
    return [token.replace("~1", "/").replace("~0", "~") for token in pointer.split("/")[1:]]


def document_of(entry, table):
    """An entry's document: a complete text, or the base with some values replaced and some removed."""
    if "text" in entry:
        return json.loads(entry["text"])
    document = copy.deepcopy({**table["base"], **({"events": table["events"]} if "at" in entry else {})})
    for pointer, value in entry.get("set", {}).items():
        if pointer == "":
            document = value
            continue
        parent, last = place_of(pointer, document)
        parent[last] = value
    for pointer in entry.get("without", []):
        parent, last = place_of(pointer, document)
        del parent[last]
    return document


def place_of(pointer, document):
    """The object or array that holds the place, and its key there; objects on the way are made."""
    *path, last = tokens(pointer)
    for token in path:
        document = document[int(token)] if isinstance(document, list) else document.setdefault(token, {})
    return document, int(last) if isinstance(document, list) else last


def entries_of(table):
    """The table's entries, one for each place of those with `at`."""
    for entry in table["verdicts"]:
        for place in table["places"][entry["at"]] if "at" in entry else [None]:
            yield json.loads(json.dumps(entry).replace('"*"', json.dumps(place)))


def objects_of(schema, place=""):
    """Each object of the schema, with its place."""
    if isinstance(schema, dict):
        yield place, schema
    for key, inner in schema.items() if isinstance(schema, dict) else enumerate(schema) if isinstance(schema, list) else ():
        yield from objects_of(inner, f"{place}/{key}")


class Schema(unittest.TestCase):
    """The schema's verdicts."""

    def test_agrees_with_the_reader_over_the_table(self):
        """But for what only the reader detects: where the schema refuses that, too, remove `only_reader`."""
        for schema, folder, refused in ((SCHEMA, FILES, "refused"), (DESCRIBED / "pool_schema.json", DESCRIBED, "faults")):
            jsonschema.Draft202012Validator.check_schema(read(schema))
            validator, table = jsonschema.Draft202012Validator(read(schema)), read(folder / "verdicts.json")
            differing = [entry["name"] for entry in entries_of(table)
                         if validator.is_valid(document_of(entry, table)) != (refused not in entry or "only_reader" in entry)]
            self.assertEqual(differing, [], schema)

    def test_takes_every_scenario_file_which_names_it(self):
        paths, validator = sorted((SOURCE / "scenarios").rglob("*.json")), jsonschema.Draft202012Validator(read(SCHEMA))
        self.assertGreaterEqual(len(paths), 30)
        for path in paths:
            with self.subTest(path=str(path)):
                validator.validate(read(path))
                self.assertEqual((path.parent / read(path).get("$schema", "")).resolve(), SCHEMA)

    def test_every_object_is_closed(self):
        self.assertEqual([place for place, inner in objects_of(read(SCHEMA)) if "properties" in inner and "additionalProperties" not in inner
                          and not {"if", "then", "else", "dependentSchemas"} & set(place.split("/"))], [])

    def test_titles_have_the_units_and_the_axes_of_their_keys(self):
        axes = {"x": r"\b(Left|right|x)\b", "y": r"\b(Top|downwards|y)\b"}
        units = {"_px_per_s": "px/s", "_px_max": "px", "_px": "px", "_hz": "Hz", "_s": "s"}
        titled = []
        for place, inner in objects_of(read(SCHEMA)):
            key, title = place.rpartition("/")[2], inner.get("title", "")
            unit = re.search(r", (px/s|px|s|Hz)$", title)
            of_key = next((units[suffix] for suffix in units if key.endswith(suffix)), None)
            if unit and of_key:
                titled.append((key, unit[1], of_key))
            axis = re.search(r"(?:^|_|v)([xy])_px", key)
            if axis and title:
                self.assertEqual([each for each, words in axes.items() if re.search(words, title)], [axis[1]], key)
        self.assertGreater(len(titled), 8)
        self.assertEqual([key for key, unit, of_key in titled if unit != of_key], [])
