"""Everything about time: random draws, jitter, the time rule, and how times in a scenario become frame numbers."""

import itertools
import math

MASK_64 = (1 << 64) - 1
GOLDEN_GAMMA = 0x9E3779B97F4A7C15
MAX_DT_S = 1e9
ALLOWANCE = 1e-9  # of a frame: a time written in decimal still resolves to the intended frame.


def splitmix64(seed, k):
    """Output k of SplitMix64, addressed by index: no state, so a draw can be skipped without losing step."""
    z = (seed + (k + 1) * GOLDEN_GAMMA) & MASK_64
    z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK_64
    z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK_64
    return z ^ (z >> 31)


def unit(seed, k):
    """u_k in [0, 1): the upper 53 bits, so that the conversion and the scaling are both exact."""
    return (splitmix64(seed, k) >> 11) * 2.0**-53


def uniform_dt_s(dt_s, fraction, seed, frame):
    """dt of a frame on a display whose frame time spreads evenly about the base."""
    return dt_s * (1.0 + fraction * (2.0 * unit(seed, frame) - 1.0))


def normal_dt_s(dt_s, sigma_s, seed, frame):
    """dt of a frame with nearly normal spread (Irwin-Hall: twelve draws, hence no libm)."""
    total = 0.0
    for k in range(12 * frame, 12 * frame + 12):
        total += unit(seed, k)
    spread_s = dt_s + sigma_s * (total - 6.0)
    return 0.0 if spread_s <= 0.0 else spread_s


def missed_frames_dt_s(dt_s, probability, seed, frame):
    """dt of a frame on a display that now and then shows the last picture twice."""
    return dt_s * 2.0 if unit(seed, frame) < probability else dt_s


JITTERS = {  # kind: (the key of its parameter, the rule)
    "uniform": ("fraction", uniform_dt_s),
    "normal": ("sigma_s", normal_dt_s),
    "missed_frames": ("probability", missed_frames_dt_s),
}


def jittered_dts_s(kind, dt_s, parameter, seed):
    """The endless dt sequence of a jittered clock, each within the limit that holds for every dt."""
    rule = JITTERS[kind][1]
    for frame in itertools.count():
        yield min(rule(dt_s, parameter, seed, frame), MAX_DT_S)


def same_bits(a, b):
    """Whether two doubles that are not NaN have the same bits: equal, and of one sign if zero."""
    return a == b and (a != 0.0 or math.copysign(1.0, a) == math.copysign(1.0, b))


class Timeline:
    """The time rule: time is counted within a segment of equal dt, and summed with compensation across segments."""

    def __init__(self):
        self.base_s = 0.0
        self.comp_s = 0.0
        self.start_s = 0.0  # base + comp, kept because it stays the same within a segment.
        self.dt_s = None
        self.frames = 0

    def advance(self, dt_s):
        """Pass one frame; return the time after it."""
        # The first test is the cheap one; the second is needed because +0 and -0 compare equal.
        if dt_s != self.dt_s or (dt_s == 0.0 and not same_bits(dt_s, self.dt_s)):
            if self.frames:
                self._close_segment()
            self.dt_s = dt_s
            self.frames = 0
        self.frames += 1
        return self.start_s + self.frames * dt_s

    def _close_segment(self):
        """Neumaier's compensated sum of what was and the length of the segment now over."""
        term_s = self.frames * self.dt_s
        total_s = self.base_s + term_s
        if abs(self.base_s) >= abs(term_s):
            self.comp_s += (self.base_s - total_s) + term_s
        else:
            self.comp_s += (term_s - total_s) + self.base_s
        self.base_s = total_s
        self.start_s = self.base_s + self.comp_s


def steps_of_duration(duration_s, dt_s):
    """The number of frames of a duration."""
    return math.ceil(duration_s / dt_s - ALLOWANCE)


def is_due(start_s, at_s, dt_s):
    """Whether a frame that starts at start_s is late enough for an event at at_s."""
    return start_s >= at_s - ALLOWANCE * dt_s


def first_frame_due(dts_s, at_s, base_dt_s=None):
    """The first frame for an event at at_s, or None beyond the end; base_dt_s is None where the clock is an array."""
    timeline = Timeline()
    start_s = 0.0
    for frame, dt_s in enumerate(dts_s):
        if is_due(start_s, at_s, dt_s if base_dt_s is None else base_dt_s):
            return frame
        start_s = timeline.advance(dt_s)
    return None
