"""The fates of mutants: the score with its interval, and tables in Markdown, with the names that reasons.json needs."""

import collections
import math

_FATES = ("caught", "unit test", "survived", "equivalent", "refused", "not tried")
_Z_95 = 1.959963984540054  # Two-sided 95 % of the normal distribution.


def interval_of(successes, trials):
    """The 95 % interval of a binomial share (Wilson 1927)."""
    if trials == 0:
        return 0.0, 1.0
    share, z_squared = successes / trials, _Z_95**2
    middle = share + z_squared / (2 * trials)
    half = _Z_95 * math.sqrt(share * (1 - share) / trials + z_squared / (4 * trials**2))
    return max(0.0, (middle - half) / (1 + z_squared / trials)), min(1.0, (middle + half) / (1 + z_squared / trials))


def fate_of(mutant, verdict, reasons):
    """The verdict's, with the written reason; "unit test": caught by one, of a mutant of which a reason says that."""
    reason = reasons.get((mutant.path, mutant.name))
    if reason is None:
        return verdict.fate
    if reason.is_caught_by_unit_test:
        return "unit test" if verdict.fate == "caught" and verdict.caught_by != "check" else verdict.fate
    return "equivalent" if verdict.fate == "survived" else verdict.fate


def _row(cells):
    return "| " + " | ".join(str(cell).replace("|", "\\|") for cell in cells) + " |"


def _score(count):
    caught = count["caught"] + count["unit test"]
    tried = caught + count["survived"]
    if tried == 0:
        return "Score: none, since no mutant could be judged."
    low, high = interval_of(caught, tried)
    return (f"Score: {caught} of {tried} caught, {caught / tried:.1%}; 95 % interval {low:.1%} to {high:.1%} (Wilson). "
            "Refused, equivalent and untried mutants are not counted.")


def report_of(trials, reasons, group_of):
    """Score; mutants by group and fate; a line a mutant. trials: {mutant: (Verdict, seconds)}"""
    fates = {mutant: fate_of(mutant, verdict, reasons) for mutant, (verdict, _) in trials.items()}
    count = collections.Counter((group_of(mutant), fate) for mutant, fate in fates.items())
    lines = [_score(collections.Counter(fates.values())), "", _row(("source", "mutants", *_FATES)),
             "|---" * (len(_FATES) + 2) + "|"]
    for name, groups in [*((f"`{group}`", [group]) for group in dict.fromkeys(map(group_of, trials))),
                         ("all", {group for group, _ in count})]:
        cells = [sum(count[group, fate] for group in groups) for fate in _FATES]
        lines.append(_row((name, sum(cells), *cells)))
    lines += ["", _row(("source", "mutant", "fate", "by", "s")), "|---|---|---|---|---|"]
    for mutant, (verdict, seconds) in trials.items():
        how = " ".join(filter(None, (verdict.caught_by, verdict.difference)))
        lines.append(_row((f"{mutant.path}:{mutant.line}", f"`{mutant.name}`", fates[mutant], how, f"{seconds:.0f}")))
    return "\n".join(lines) + "\n"
