"""Claims of the paper that are measured over random starts, in 60 digits: `claims.py > claims.json`.

Nothing but the listing, the ODE's closed form and SplitMix64 is shared with the C++ program; starts are those of seed 7,
drawn in binary64 as there.
"""

import json
import math
from decimal import Decimal, getcontext

from clock import unit

getcontext().prec = 60

STARTS = range(100)
SEED = 7
FASTEST = 2000.0
GRAVITY, DRAG = Decimal(1200), Decimal(0.999)  # The binary64 number.


def between(index, low, high):
    """Draw `index`, in low .. high."""
    return low + (high - low) * unit(SEED, index)


def quantile(values, part):
    """Between its neighbours where it falls between."""
    values = sorted(values)
    place = part * (len(values) - 1)
    below = int(place)
    above = min(below + 1, len(values) - 1)
    return values[below] + (Decimal(place) - below) * (values[above] - values[below])


def flights(dt_s, frames, vy):
    """(y, vy) by the listing and by v' = G - k v with k = -ln(drag) / dt, after so many frames from y = 0."""
    dt = Decimal(dt_s)
    y, v = Decimal(0), Decimal(vy)
    for _ in range(frames):
        v = (v + GRAVITY * dt) * DRAG
        y += v * dt
    k, t = -DRAG.ln() / dt, dt * frames
    terminal = GRAVITY / k
    decay = DRAG**frames
    exact_v = terminal + (Decimal(vy) - terminal) * decay
    exact_y = terminal * t + (Decimal(vy) - terminal) * (1 - decay) / k
    return (y, v), (exact_y, exact_v)


def start_vy(start):
    return between(5 * start + 1, -FASTEST, FASTEST)


def energy_drift():
    """Energy drift of a second in frames of 0.2 s, over that at 60 Hz."""
    def drift(dt_s, frames, start):
        (y, v), (exact_y, exact_v) = flights(dt_s, frames, start_vy(start))
        return (v * v - exact_v * exact_v) / 2 - GRAVITY * (y - exact_y)
    return [abs(drift(0.2, 5, start) / drift(1.0 / 60.0, 60, start)) for start in STARTS]


def orders():
    """Order of the root mean square error between 15 Hz and its doubles up to 240 Hz."""
    errors = []
    for rate_hz in (15.0, 30.0, 60.0, 120.0, 240.0):
        squares = []
        for start in STARTS:
            flight_s = math.floor(between(5 * start + 2, 0.25, 1.0) * 15.0 + 0.5) / 15.0
            (y, _), (exact_y, _) = flights(1.0 / rate_hz, math.floor(flight_s * rate_hz + 0.5), start_vy(start))
            squares.append((y - exact_y)**2)
        errors.append((sum(squares) / len(squares)).sqrt())
    return [(before / after).ln() / Decimal(2).ln() for before, after in zip(errors, errors[1:])]


def growth(angle, phase, is_explicit=False):
    """Growth of a spring's amplitude from the first to the last hundred of 500 steps, beside drag."""
    dt = Decimal(1.0 / 60.0)
    w = Decimal(angle) / dt
    y, v = Decimal(math.cos(phase)), w * Decimal(math.sin(phase))
    early = late = Decimal(0)
    for step in range(500):
        before = v
        v = (v - w * w * y * dt) * DRAG
        y += (before if is_explicit else v) * dt
        square = y * y + v * v / (w * w)
        early = max(early, square) if step < 100 else early
        late = max(late, square) if step >= 400 else late
    return (late / early).sqrt() / DRAG**200


def growths(is_explicit):
    return [growth(between(2 * start, 0.05, 1.99), between(2 * start + 1, 0.0, 6.283), is_explicit) for start in STARTS]


def main():
    """Writes medians, and 10 and 90 %."""
    explicit = growths(True)
    print(json.dumps({
        **{name: {key: float(quantile(values, part)) for key, part in (("number", 0.5), ("number_low", 0.1), ("number_high", 0.9))}
           for name, values in (("2.3-oscillators", growths(False)), ("2.4-first-order", orders()),
                                ("4.1-energy-drift", energy_drift()))},
        "past 2": float(growth(2.01, 0.0)),
        "explicit": [float(quantile(explicit, part)) for part in (0.1, 0.9)]}, indent=2))


if __name__ == "__main__":
    main()
