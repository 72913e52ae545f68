"""Other people's readers open a run file and find axes, units and names: h5py, xarray.

The type, unit and name of each dataset is in outputs.md.
"""

import re

import h5py
import numpy
import xarray

from program import AGREED, SOURCE, ProgramTest, fling

KINDS = {"fling": 0, "place": 1, "stop": 2, "resize-window": 3, "resize-sprite": 4, "hitch": 5, "grab": 6, "release": 7}
EVENTS = [{"step": 20, "fling": {"vx_px_per_s": -900, "vy_px_per_s": -800}}, {"step": 40, "hitch": {"dt_s": 0.25}},
          {"step": 90, "resize": {"window": {"width_px": 1280, "height_px": 720},
                                  "sprite": {"width_px": 64, "height_px": 32}}}]


class Reader(ProgramTest):
    """One run, written."""

    def setUp(self):
        super().setUp()
        self.write("fling.json", fling(events=EVENTS, description="ein Wurf, schräg"))
        self.summary, = self.expect(AGREED, "run", "fling.json", "--json").json["runs"]
        self.path = self.folder / "fling.h5"


class H5py(Reader):
    """h5py, as h5web, silx and HDFView would."""

    def test_the_root_says_what_the_file_is(self):
        with h5py.File(self.path) as file:
            self.assertIn("schräg", file.attrs["scenario"])
            self.assertEqual((file.attrs["steps"].dtype, file.attrs["state_hash"]), (numpy.int64, self.summary["state_hash"]))
            for name in ("format", "scenario"):
                text = file.attrs.get_id(name)
                self.assertEqual(h5py.check_string_dtype(text.dtype).encoding, "utf-8")
                self.assertEqual(text.shape, ())

    def test_events_are_an_enumeration_that_names_them(self):
        with h5py.File(self.path) as file:
            events = file["events"]
            self.assertEqual(h5py.check_enum_dtype(events["kind"].dtype), KINDS)
            self.assertEqual({name: list(events[name]) for name in events}, {
                "frame": [20, 40, 90, 90], "kind": [0, 5, 3, 4], "a": [-900, 0.25, 1280, 64], "b": [-800, 0, 720, 32]})

    def test_constants_are_in_the_order_of_the_document(self):
        listed = re.search(r"`constants` float64 \[5\]: (.*?) of the core", (SOURCE / "golden/README.md").read_text())[1]
        header = dict(re.findall(r" ([A-Z_]+) = ([\d.]+);", (SOURCE / "sim/physics/physics.h").read_text()))
        with h5py.File(self.path) as file:
            self.assertEqual(list(file.attrs["constants"]), [float(header[name]) for name in re.findall("[A-Z_]+", listed)])

    def test_provenance_has_the_build_and_no_time(self):
        with h5py.File(self.path) as file:
            self.assertEqual(sorted(file["provenance"].attrs),
                             ["compiler", "flags", "instruction_set", "program", "self_test", "target"])
            said = dict(file["provenance"].attrs)
        info = self.expect(AGREED, "info", "--json").json
        self.assertEqual(said, {"program": f"hyrax-sim {info['version']}", **{name: info[name] for name in said if name != "program"}})


class EveryGroup(Reader):
    """xarray opens each group with datasets, of every kind of file."""

    def open(self, path, group):
        """The group of a file; every dataset is along one axis."""
        with xarray.open_dataset(self.folder / path, group=group, engine="h5netcdf") as opened:
            data = opened.load()
        self.assertEqual(len(data.dims), 1, group)
        for name in data.variables:
            self.assertEqual(data[name].dims, tuple(data.dims), f"{group}/{name}")
        return data

    def groups(self, path):
        """Names of the groups that hold datasets, of which none needs a plug-in to be read."""
        found = {}
        with h5py.File(self.folder / path) as file:
            file.visititems(lambda name, item: found.update({name: item.compression}) if isinstance(item, h5py.Dataset) else None)
        self.assertEqual(set(found.values()), {None})
        return sorted({name.rpartition("/")[0] for name in found})

    def test_of_a_run(self):
        self.assertEqual(self.groups("fling.h5"), ["contacts", "events", "trajectory"])
        with h5py.File(self.path) as file:
            for group in self.groups("fling.h5"):
                opened = self.open("fling.h5", group)
                self.assertEqual(sorted(opened.variables), sorted(file[group]))
                for name in file[group]:
                    numpy.testing.assert_array_equal(opened[name], file[group][name])
        for group, axis in (("trajectory", "t"), ("contacts", "step"), ("events", "frame")):
            self.assertEqual(list(self.open("fling.h5", group).coords), [axis])

    def test_of_a_run_of_more_contacts_than_a_batch_and_of_one_of_none(self):
        self.expect(AGREED, "run", "fling.json", "-o", "many.h5", "--set", "/window/width_px=100", "--set", "/steps=9000",
                    "--set", "/events=[]")
        self.assertGreater(self.open("many.h5", "contacts").sizes["step"], 4096)
        self.expect(AGREED, "run", "fling.json", "-o", "still.h5", "--set", "/events=[]", "--set", "/steps=0")
        for group in self.groups("still.h5"):
            self.assertEqual(list(self.open("still.h5", group).sizes.values()), [int(group == "trajectory")])

    def test_of_a_measured_run_of_a_golden_file_and_of_studies(self):
        self.expect(AGREED, "run", "fling.json", "--drift", "--rows", "-o", "measured.h5")
        self.write("scenarios/long.json", fling(name="long", steps=9000, clock={
            "rate_hz": 60, "jitter": {"kind": "uniform", "fraction": 0.3, "seed": 5}}))
        self.bless("scenarios")
        for study in (("needs", "fling.json"), ("frame-rate",), ("hard-cases", "fling.json")):
            self.expect(AGREED, "study", *study, "--quick", "--no-figures")
        of_run = ["contacts", "events", "trajectory"]
        self.assertEqual(self.groups("measured.h5"), sorted([*of_run, *(
            f"drift{group}" for group in ("", "/arcs", "/contacts", "/whole")), "reference", "reference/arcs"]))
        self.assertEqual(self.groups("golden/long.h5"), ["blocks", *of_run])
        for path in ("measured.h5", "golden/long.h5", "needs.h5", "frame-rate.h5", "hard-cases.h5"):
            for group in self.groups(path):
                if group != "blocks":
                    self.open(path, group)
        with xarray.open_dataset(self.folder / "golden/long.h5", group="blocks", engine="h5netcdf") as blocks:
            self.assertEqual(dict(blocks.sizes), {"count": 3, "digest": 48, "row_check": 6 * 9001})
            self.assertEqual(blocks.time_base.dims, ("count",))

    def test_of_a_sweep(self):
        self.write("sweep.json", {"format": "hyrax-sweep/1", "base": fling(), "vary": {"/start/x_px": {"grid": [0, 9, 5]}},
                                  "keep": ["final", "contacts", "state_hash"]})
        self.expect(AGREED, "sweep", "sweep.json")
        text = " ".join((SOURCE / "sim/ensemble/README.md").read_text(encoding="utf-8").split())
        member, wall, digest = re.search(r"the dimensions are `(\w+)`, `(\w+)` \(of `contacts`\) and `(\w+)` \(of `state_hash`\)", text).groups()
        for group, sizes in (("members", {member: 5, wall: 4, digest: 16}), ("inputs", {member: 5})):
            with xarray.open_dataset(self.folder / "sweep.h5", group=group, engine="h5netcdf") as opened:
                self.assertEqual(dict(opened.sizes), sizes)
                self.assertEqual({name: opened[name].dims[0] for name in opened.variables},
                                 dict.fromkeys(opened.variables, member))
                self.assertEqual([opened[name].dims[1] for name in ("contacts", "state_hash") if name in opened], [wall, digest][:len(sizes) - 1])
