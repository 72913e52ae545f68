"""The members of a sweep, written from the format alone: which numbers each has, and the scenario that they make."""

import copy
import math

import clock

INTEGER_KEYS = {"width_px", "height_px", "step", "steps", "every", "seed"}


def grid_size(vary):
    """The combinations of all grids."""
    return math.prod(rule["grid"][2] for rule in vary.values() if "grid" in rule)


def member_count(sweep):
    return sweep.get("members", grid_size(sweep["vary"]))


def inputs(sweep, member, integers=frozenset()):
    """The value of each varied key in a member, keys in order of their bytes. Pointers in `integers` are of integers, too."""
    keys = sorted(sweep["vary"], key=str.encode)
    values = {}
    for k, key in enumerate(keys):
        (kind, rule), = sweep["vary"][key].items()
        is_integer = key.rsplit("/", 1)[1] in INTEGER_KEYS and not key.startswith("/inputs/") or key in integers
        draw = sweep.get("seed", 0), member * len(keys) + k
        u = clock.unit(*draw)
        if kind == "uniform":
            low, high = rule
            if is_integer:
                value = int(low) + ((int(high) - int(low) + 1) * (clock.splitmix64(*draw) >> 11) >> 53)
            else:
                value = float(low) + (float(high) - float(low)) * u
        elif kind == "choice":
            value = rule[math.floor(u * len(rule))]
        elif kind == "member":
            value = member
        else:
            low, high, n = rule
            later = math.prod(sweep["vary"][other]["grid"][2] for other in keys[k + 1:]
                              if "grid" in sweep["vary"][other])
            j = member // later % n
            if n == 1:
                value = low
            elif j == n - 1:
                value = high
            elif is_integer:
                value = int(low) + (int(high) - int(low)) * j // (n - 1)
            else:
                value = float(low) + ((float(high) - float(low)) * j) / (n - 1)
        values[key] = value if isinstance(value, (bool, str)) else int(value) if is_integer else float(value)
    return values


def scenario(sweep, member, integers=frozenset()):
    """A member as a scenario of its own. REQUIRES: the base is inside the sweep."""
    document = copy.deepcopy(sweep["base"])
    document.pop("expect", None)
    for key, value in inputs(sweep, member, integers).items():
        *path, last = key[1:].split("/")
        place = document
        for token in path:
            place = place[int(token)] if isinstance(place, list) else place.setdefault(token, {})
        place[int(last) if isinstance(place, list) else last] = value
    document["name"] = f"member-{member}"
    return document
