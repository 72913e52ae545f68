#!/usr/bin/python3
"""A second program for the published replay, written from the specification alone, as an independent check of the first."""

import argparse
import json
import sys

sys.dont_write_bytecode = True  # A test should leave nothing behind in the source tree.

import replay  # noqa: E402
import vectors  # noqa: E402

NOT_JSON = {"nan": "NaN", "inf": "Infinity", "-inf": "-Infinity"}


def plain(value):
    """The value with non-finite doubles as the strings that the interface has for them."""
    if isinstance(value, dict):
        return {key: plain(inner) for key, inner in value.items()}
    return NOT_JSON.get(str(value), value) if isinstance(value, float) else value


def replay_one(path):
    """The entry of one scenario; a bad one is reported and the others are still played."""
    try:
        return {"scenario": path, **plain(replay.summarise(replay.Scenario(replay.load(path))))}
    except (OSError, ValueError) as error:
        return {"scenario": path, "status": "failed", "error": str(error)}


def command_replay(arguments):
    """Print one document with an entry per scenario."""
    runs = [replay_one(path) for path in arguments.scenarios]
    print(json.dumps({"runs": runs}, indent=2))
    return 2 if any("status" in run for run in runs) else 0


def command_rows(arguments):
    """Write every row and contact of a short run."""
    try:
        document = replay.all_rows(replay.Scenario(replay.load(arguments.scenario)))
    except (OSError, ValueError) as error:
        print(f"{arguments.scenario}: {error}", file=sys.stderr)
        return 2
    with open(arguments.out, "w", encoding="utf-8") as file:
        json.dump({"scenario": arguments.scenario, **document}, file)
        file.write("\n")
    return 0


def command_vectors(_):
    """Print the test vectors."""
    print(json.dumps(vectors.all_vectors(), indent=1))
    return 0


def main():
    """Reads the command line and plays the scenarios."""
    parser = argparse.ArgumentParser(description=__doc__)
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    play = commands.add_parser("replay", help="play scenarios and print what `run --json` says of the runs")
    play.add_argument("scenarios", nargs="+", metavar="SCENARIO.json")
    play.set_defaults(command=command_replay)
    rows = commands.add_parser("rows", help="write every row and contact of a short run")
    rows.add_argument("scenario", metavar="SCENARIO.json")
    rows.add_argument("--out", required=True, metavar="FILE.json")
    rows.set_defaults(command=command_rows)
    commands.add_parser("vectors", help="print the test vectors").set_defaults(command=command_vectors)
    arguments = parser.parse_args()
    return arguments.command(arguments)


if __name__ == "__main__":
    sys.exit(main())
