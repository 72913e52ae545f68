#!/usr/bin/python3
"""The JSON Schema of a described core's scenarios against the verdicts of the reader."""

import copy
import json
import pathlib
import unittest

import jsonschema

FOLDER = pathlib.Path(__file__).parent


def document_of(entry, base):
    """An entry's document: a complete text, or the base with some values replaced and some removed."""
    if "text" in entry:
        return json.loads(entry["text"])
    document = copy.deepcopy(base)
    for pointer, value in entry.get("set", {}).items():
        *path, last = pointer.split("/")[1:]
        parent = document
        for token in path:
            parent = parent[token]
        parent[last] = value
    for pointer in entry.get("without", []):
        del document[pointer[1:]]
    return document


class Schema(unittest.TestCase):
    """The schema's verdicts."""

    def test_agrees_with_the_reader_over_the_table(self):
        """But for what only the reader detects: where the schema refuses that, too, remove `only_reader`."""
        schema = json.loads((FOLDER / "pool_schema.json").read_text(encoding="utf-8"))
        jsonschema.Draft202012Validator.check_schema(schema)
        validator = jsonschema.Draft202012Validator(schema)
        table = json.loads((FOLDER / "verdicts.json").read_text(encoding="utf-8"))
        differing = [entry["name"] for entry in table["verdicts"]
                     if validator.is_valid(document_of(entry, table["base"])) != ("faults" not in entry or "only_reader" in entry)]
        self.assertEqual(differing, [])


if __name__ == "__main__":
    unittest.main()
