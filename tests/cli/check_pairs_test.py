"""`check` of changed golden pairs: one verdict by every command, and no fault hidden by a summary."""

import h5py
import xxhash

from check_program import THIRD, nudge
from program import AGREED, DISAGREED, ProgramTest, fling

DT_S = {"dt_s": 1 / 60}


def set_attribute(h5, place, name, value):
    """Changes an attribute of a golden file, or removes it."""
    with h5py.File(h5, "r+") as file:
        if value is None:
            del file[place].attrs[name]
        else:
            file[place].attrs[name] = value


def renew_checksum(h5, txt):
    """Gives the summary the checksum of the golden file, but not the one of its own lines."""
    checksums = f"checksums: {32 * 'c'} {xxhash.xxh3_128_hexdigest(h5.read_bytes())}\n"
    txt.write_text(txt.read_text().partition("checksums: ")[0] + checksums)


class PairTest(ProgramTest):
    """Golden pairs, all of them blessed by one command, and all of them judged by one."""

    def pair(self, path):
        return [self.folder / f"golden/{path}.{suffix}" for suffix in ("h5", "txt")]

    def scenario(self, path, **changes):
        self.write(f"scenarios/{path}.json", fling(**{"name": path.rpartition("/")[2], "start": THIRD, **changes}))


class OneVerdict(PairTest):
    """`check` and `run` give the same verdict on every changed golden pair."""

    def edits(self, class_, *changes):
        def edit(old, new):
            def change(_, txt):
                self.assertIn(old, txt.read_text())
                txt.write_text(txt.read_text().replace(old, new))
            return change
        return [(class_, {}, {}, edit(old, new)) for old, new in changes]

    def nudged(self, dataset, row):
        """The pair as a program would have blessed it that differs in one value, and has the same state hash."""
        def change(h5, txt):
            nudge(h5, dataset, row)
            renew_checksum(h5, txt)
        return "rounding", {}, {}, change

    def zero(self, sigma_s):
        """A run that is the same for a zero of either sign."""
        jitter = {"kind": "normal", "sigma_s": sigma_s, "seed": 1}
        return {"start": {**THIRD, "vx_px_per_s": 0}, "clock": {"rate_hz": 60, "jitter": jitter}}

    def test_on_every_pair(self):
        """Of each pair: the class, what the scenario was when it was blessed, what it is now, and what changes the files."""
        as_blessed = lambda class_, *changes: [(class_, blessed, {}, None) for blessed in changes]
        pairs = {
            "disagreed": [
                *as_blessed("shape", {"record": {"every": 2}}, {"steps": None, "duration_s": 5}, {"clock": DT_S},
                            {"start": {**THIRD, "y_px": 500.0000000001}}, {"steps": 299}, {"steps": 301},
                            {"events": [{"step": 299, "hitch": DT_S}]}),
                *self.edits("shape", ("steps: 300", "steps: 301"), ("scenario: case", "scenario: casE"),
                            ("ground 5 bounces", "ground 4 bounces"), ("margin: any", "margin: ani"), ("nearest decision: right", "nearest decision: left"),
                            ("checksums: ", "checksums:  "), ("state hash: ", "state hash: 0"), ("reason: for", "reason for")),
                ("shape", {}, {}, lambda _, txt: txt.write_text("nothing\n")),
                ("shape", {}, {}, lambda h5, _: h5.write_bytes(h5.with_name("case-1.h5").read_bytes())),
                self.nudged("contacts/overshoot", 0), self.nudged("trajectory/t", 7)],
            "agreed": [
                *as_blessed(None, {}, {"name": "another"}, {"description": "another text"}, {"expect": {"finite": True}},
                            {"$schema": "schema.json"}, {"start": {**THIRD, "x_px": 1100.0}}),
                (None, self.zero(0), self.zero(-0.0), None),
                *self.edits(None, ("reason: for the test", "reason: for another test")),
                *((None, {}, {}, lambda h5, _, change=change: set_attribute(h5, *change))
                  for change in (("provenance", "compiler", "another"), ("/", "core", 32 * "7"), ("/", "core", None)))],
            "missing": [(None, {}, {}, lambda h5, _: h5.unlink()), (None, {}, {}, lambda _, txt: txt.unlink())],
        }
        paths = {status: [f"{status}/case-{number}" for number in range(len(cases))] for status, cases in pairs.items()}
        cases = [(path, *case) for status in pairs for path, case in zip(paths[status], pairs[status])]
        for path, _, blessed, _, _ in cases:
            self.scenario(path, **blessed)
        self.bless("scenarios")
        for path, _, _, now, change in cases:
            self.scenario(path, **now)
            if change is not None:
                change(*self.pair(path))
        for status, exit_code in (("disagreed", 1), ("agreed", 0), ("missing", 4)):
            folder = f"scenarios/{status}"
            wanted = {f"scenarios/{path}.json": (status, class_) for path, class_, *_ in cases if path.startswith(status)}
            checked = self.expect(exit_code, "check", folder, "--json").json
            self.assertEqual({entry["scenario"]: (entry["status"], entry["class"]) for entry in checked["results"]}, wanted)
            runs = self.expect(exit_code % 4, "run", folder, "--json", "-o", "out/").json["runs"]
            self.assertEqual({entry["scenario"]: (entry["golden"]["status"], entry["golden"].get("class")) for entry in runs},
                             wanted)


class Seal(PairTest):
    """A summary's checksums make reading the golden file unnecessary, and must never hide a fault in it."""

    def test_what_is_not_as_blessed_is_named_and_blessing_repairs_it(self):
        def with_text(change):
            return lambda _, txt: txt.write_text(change(txt.read_text()))

        def with_checksum(number, value):
            return with_text(lambda text: text.replace(text.splitlines()[-1].split()[1 + number], value))

        checksums = r"{txt}: its checksums "
        cases = [(change, checksums) for change in (
            with_text(lambda text: text.replace("checksums: ", "checksum: ")), with_text(lambda text: text[:-1]),
            with_text(lambda text: text + "\n"), with_checksum(0, 32 * "0"), with_checksum(1, 32 * "z"))]
        changed = "{h5}.*/{place}@{name}"
        for place, name, value, says in (
                *((place, name, None, "{h5}: lacks .*@{name}.*, which bless writes; restore it") for place, name in (
                    ("/", "name"), ("/", "constants"), ("trajectory/x", "units"), ("contacts/t", "long_name"),
                    ("trajectory", "signal"), ("trajectory/y", "DIMENSION_LIST"))),
                ("trajectory/x", "units", "m", changed), ("contacts/t", "long_name", "time", changed),
                ("trajectory", "signal", "x", changed), ("trajectory/y", "scale", "1", changed),
                ("/", "constants", [1200, 0.6, 0.999, 0.8, 5.5], checksums)):
            change = lambda h5, _, change=(place, name, value): set_attribute(h5, *change)
            cases.append((change, says.replace("{place}", place).replace("{name}", name)))
        cases.append((lambda h5, _: h5py.File(h5, "r+").create_dataset("more", data=1).file.close(), "{h5}.*holds /more, which bless does not write"))
        self.project(*(f"case-{number}" for number in range(len(cases))))
        for number, (change, _) in enumerate(cases):
            change(*self.pair(f"case-{number}"))
        results = self.expect(DISAGREED, "check", "--json").json["results"]
        self.assertEqual([(entry["status"], entry["class"], entry["first_divergence"]) for entry in results],
                         len(cases) * [("disagreed", "shape", None)])
        said = self.expect(DISAGREED, "check", "--verbose").out
        for number, (_, says) in enumerate(cases):
            h5, txt = (f"golden/case-{number}.{suffix}" for suffix in ("h5", "txt"))
            self.assertRegex(said, says.replace("{h5}", h5).replace("{txt}", txt))
        some = [f"scenarios/case-{number}.json" for number in range(0, len(cases), 5)]
        self.bless(*some)
        self.expect(AGREED, "check", *some)

    def test_another_provenance_is_reported_and_agrees(self):
        self.project("third")
        set_attribute(self.folder / "golden/third.h5", "provenance", "compiler", "another")
        self.expect(AGREED, "check", says="golden/third.h5: agrees, but does not have the checksum in "
                    "golden/third.txt: its provenance or its layout differs\n")

    def test_a_file_of_an_earlier_version_may_have_fewer_attributes(self):
        self.project("third")
        h5, txt = self.pair("third")
        set_attribute(h5, "trajectory/x", "units", None)
        text = txt.read_text()
        txt.write_text(text.replace(text.split()[-1], xxhash.xxh3_128_hexdigest(h5.read_bytes())))
        self.expect(AGREED, "check")
