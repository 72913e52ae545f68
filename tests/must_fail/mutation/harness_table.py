"""The fates of the drawn mutants: the score with its interval, and tables in Markdown."""

import collections
import math

from table import row, short

_FATES = ("caught", "survived", "equivalent", "refused", "not tried")
_Z_95 = 1.959963984540054  # Two-sided 95 % of the normal distribution.


def interval_of(successes, trials):
    """The 95 % interval of a binomial share (Wilson 1927)."""
    if trials == 0:
        return 0.0, 1.0
    share, z_squared = successes / trials, _Z_95**2
    middle = share + z_squared / (2 * trials)
    half = _Z_95 * math.sqrt(share * (1 - share) / trials + z_squared / (4 * trials**2))
    return max(0.0, (middle - half) / (1 + z_squared / trials)), min(1.0, (middle + half) / (1 + z_squared / trials))


def _fate(mutant, verdict, reasons):
    is_explained = verdict.fate == "survived" and (mutant.path, mutant.name) in reasons
    return "equivalent" if is_explained else verdict.fate


def _score(count):
    caught, tried = count["caught"], count["caught"] + count["survived"]
    if tried == 0:
        return "Score: none, since no mutant could be judged."
    low, high = interval_of(caught, tried)
    return (f"Score: {caught} of {tried} caught, {caught / tried:.1%}; 95 % interval {low:.1%} to {high:.1%} (Wilson). "
            "Refused, equivalent and untried mutants are not counted.")


def report_of(trials, reasons, seed):
    """Score; mutants by folder and fate; a line a mutant. trials: {mutant: (Verdict, seconds)}"""
    fates = {mutant: _fate(mutant, verdict, reasons) for mutant, (verdict, _) in trials.items()}
    count = collections.Counter(fates.values())
    in_folder = collections.Counter((mutant.path.split("/", 2)[1], fate) for mutant, fate in fates.items())
    folders = ["/".join(mutant.path.split("/", 2)[:2]) for mutant in trials]
    lines = [f"Seed {seed}. {_score(count)}", "", row(("folder", "drawn", *_FATES)), "|---" * (len(_FATES) + 2) + "|"]
    for folder in sorted(set(folders)):
        cells = [in_folder[folder.split("/")[1], fate] for fate in _FATES]
        lines.append(row((f"`{folder}`", sum(cells), *cells)))
    lines += [row(("all", len(fates), *(count[fate] for fate in _FATES))), "",
              row(("source", "mutant", "fate", "by", "s")), "|---|---|---|---|---|"]
    for mutant, (verdict, seconds) in trials.items():
        name = short(mutant.name).replace("|", "\\|")
        how = " ".join(filter(None, (verdict.caught_by, verdict.difference)))
        lines.append(row((f"{mutant.path}:{mutant.line}", f"`{name}`", fates[mutant], how, f"{seconds:.0f}")))
    return "\n".join(lines) + "\n"
