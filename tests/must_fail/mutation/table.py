"""The verdicts on mutants as tables, in Markdown that reads well on a terminal, too."""

import collections
import os
import re

_LONG = 60
_AROUND = 24

_KINDS = ("constant", "operator", "comparison", "dropped", "swapped", "confused", "float for double", "fused")


def _fate(mutant, verdict, reasons):
    """caught, unit test, equivalent, survived, or refused."""
    reason = reasons.get((mutant.path, mutant.name))
    if verdict.fate != "survived" or reason is None:
        return verdict.fate
    return "unit test" if reason.is_caught_by_unit_test else "equivalent"


def _cut(line, first, last):
    """The part of a long line around its positions `first` to `last`."""
    first, last = max(first - _AROUND, 0), min(last + _AROUND, len(line))
    return ("..." if first > 0 else "") + line[first:last] + ("..." if last < len(line) else "")


def short(name):
    """A mutant's name; long lines are cut to the part around the change."""
    name, number = re.fullmatch(r"(.*?)( \[\d+\])?", name).groups(default="")
    place, _, change = name.partition(": ")
    before, arrow, after = change.partition(" -> ")
    if not arrow:
        return (name if len(name) <= 2 * _LONG else name[:2 * _LONG] + "...") + number
    same = len(os.path.commonprefix([before, after]))
    same_end = min(len(os.path.commonprefix([before[::-1], after[::-1]])), len(before) - same, len(after) - same)
    before, after = (line if len(line) <= _LONG else _cut(line, same, len(line) - same_end) for line in (before, after))
    return f"{place}: {before} -> {after}{number}"


def table_of(verdicts, reasons):
    """One line per mutant: the change, the scenario that catches it, the step, and the class of the difference."""
    lines = ["| file | mutant | caught by | step | class |", "|---|---|---|---|---|"]
    for mutant, verdict in verdicts.items():
        fate = _fate(mutant, verdict, reasons)
        caught_by = verdict.caught_by if fate == "caught" else fate
        name = short(mutant.name).replace("|", "\\|")
        lines.append(row((mutant.path.rpartition("/")[2], f"`{name}`", caught_by, verdict.step, verdict.difference)))
    return "\n".join(lines) + "\n"


def row(cells):
    """A line of a table in Markdown."""
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def summary_of(verdicts, reasons):
    """Mutants by kind and file; how the caught ones showed; and the score."""
    fates = {mutant: _fate(mutant, verdict, reasons) for mutant, verdict in verdicts.items()}
    count = collections.Counter((mutant.path, fate) for mutant, fate in fates.items())
    columns = ("caught", "unit test", "equivalent", "refused", "survived")
    head = ("file", "mutants", "caught by check", "caught by a unit test", "equivalent", "refused by the compiler",
            "survived")
    lines = [row(head), "|---" * len(head) + "|"]
    for path in dict.fromkeys(mutant.path for mutant in verdicts):
        cells = [count[path, column] for column in columns]
        lines.append(row((f"`{path}`", sum(cells), *cells)))
    total = [sum(1 for fate in fates.values() if fate == column) for column in columns]
    lines += [row(("all", sum(total), *total)), ""]
    lines += [_by_kind(verdicts, fates), _by_class(verdicts, fates), _by_scenario(verdicts, fates)]
    to_be_caught = sum(total) - total[2] - total[3]
    lines.append(f"{total[0] + total[1]} of {to_be_caught} that change a result are caught.")
    return "\n".join(lines) + "\n"


def _by_kind(verdicts, fates):
    lines = [row(("change", "mutants", "caught", "equivalent")), "|---|---|---|---|"]
    for kind in _KINDS:
        of_kind = [fates[mutant] for mutant in verdicts if mutant.kind == kind]
        caught = sum(1 for fate in of_kind if fate in ("caught", "unit test"))
        lines.append(row((kind, len(of_kind), caught, of_kind.count("equivalent"))))
    return "\n".join(lines) + "\n"


def _by_class(verdicts, fates):
    classes = collections.Counter(verdict.difference for mutant, verdict in verdicts.items()
                                  if fates[mutant] == "caught")
    return "Caught as: " + ", ".join(f"{name} {count}" for name, count in classes.most_common()) + ".\n"


def _by_scenario(verdicts, fates):
    scenarios = collections.Counter(verdict.caught_by for mutant, verdict in verdicts.items()
                                    if fates[mutant] == "caught" and verdict.caught_by)
    return "First red: " + ", ".join(f"{name} {count}" for name, count in scenarios.most_common()) + ".\n"
