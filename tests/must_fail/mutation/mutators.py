"""Every small change of a source file: one constant, operator, comparison, statement, type or coordinate at a time."""

import dataclasses
import math
import re

from source_text import SourceText

_OPERATORS = {
    "+": "-", "-": "+", "*": "/", "/": "*", "%": "/", "+=": "-=", "-=": "+=", "*=": "/=",
    "^": "|", "<<": ">>", ">>": "<<", "&&": "||", "||": "&&"}
_STEPS = {"++": "--", "--": "++"}
_COMPARISONS = {"<": ["<=", ">"], "<=": ["<", ">="], ">": [">=", "<"], ">=": [">", "<="], "==": ["!="], "!=": ["=="]}

# Names for x and for y, and other pairs of the same type that are easily confused.
_PAIRS = [("m_x", "m_y"), ("m_vx", "m_vy"), ("x", "y"), ("vx", "vy"), ("x_px", "y_px"),
          ("vx_px_per_s", "vy_px_per_s"), ("screenW", "screenH"), ("objW", "objH"),
          ("screenWidth", "screenHeight"), ("objWidth", "objHeight"), ("rightBound", "bottomBound"),
          ("window", "sprite"), ("seed", "frame"), ("seed", "index"), ("seed", "k"), ("base_s", "comp_s"),
          ("base_s", "length_s"), ("dt_s", "nominal_dt_s"), ("early", "late"), ("base_dt_s_", "dt_s")]
_LEAVES = ("break;", "return;", "throw ", "throw;")  # These return no value, so they can be dropped.
_FLAGS_FUSED = ("-O2", "-ffp-contract=fast", "-mfma")  # g++ fuses from -O2 on.


@dataclasses.dataclass(frozen=True)
class Mutant:
    """One change of one file: text `begin` to `end` replaced, or all of it compiled with other flags."""

    path: str
    kind: str
    name: str
    begin: int = 0
    end: int = 0
    replacement: str = ""
    flags: tuple = ()
    line: int = 1

    def text_of(self, original):
        return original[:self.begin] + self.replacement + original[self.end:]


def _one_line(text):
    return " ".join(re.sub(r"//[^\n]*", "", text).split())


class Mutators:
    """All mutants of one file, kind by kind, in the order of the text."""

    def __init__(self, path, text, functions):
        self.path = path
        self.source = SourceText(text)
        self.functions = functions
        self.found = []

    def all(self):
        """The mutants, with unique names."""
        for index, token in enumerate(self.source.tokens):
            function = self.source.function_of(index)
            if self.functions and (function.name if function else "declarations") not in self.functions:
                continue
            self._number(index, token)
            self._operator(index, token)
            self._type(index, token)
            if function is not None:
                self._coordinate(index, token)
        for block in self.source.blocks:
            self._statements(block)
        if any(token.text == "double" for token in self.source.tokens):
            self.found.append(Mutant(self.path, "fused", "multiply-adds fused", flags=_FLAGS_FUSED))
        return self.numbered()

    def add(self, kind, index, begin, end, replacement, name=None):
        function = self.source.function_of(index)
        place = function.name if function else "declarations"
        if name is None:
            first, last = self.source.lines_of(begin, end)
            text = self.source.text
            before, after = _one_line(text[first:last]), _one_line(text[first:begin] + replacement + text[end:last])
            name = f"{before} -> {after}"
        line = self.source.text.count("\n", 0, begin) + 1
        self.found.append(Mutant(self.path, kind, f"{place}: {name}", begin, end, replacement, line=line))

    def replace(self, kind, index, replacement):
        token = self.source.tokens[index]
        self.add(kind, index, token.begin, token.end, replacement)

    def _number(self, index, token):
        if token.kind == "number":
            for replacement in numbers_near(token.text):
                self.replace("constant", index, replacement)
        elif token.text in ("true", "false"):
            self.replace("constant", index, "false" if token.text == "true" else "true")

    def _operator(self, index, token):
        if token.kind != "operator":
            return
        text = self.source.text
        if token.text in _STEPS:
            self.replace("operator", index, _STEPS[token.text])
        elif self.source.is_between_blanks(index):
            if token.text in _OPERATORS:
                self.replace("operator", index, _OPERATORS[token.text])
            for replacement in _COMPARISONS.get(token.text, []):
                self.replace("comparison", index, replacement)
        elif token.text in "-!" and not text[token.end].isspace():
            self.replace("operator", index, "")

    def _type(self, index, token):
        tokens = self.source.tokens
        if token.text == "double" and (tokens[index - 1].text != "<" or tokens[index - 2].text == "static_cast"):
            self.replace("float for double", index, "float")

    def _coordinate(self, index, token):
        tokens = self.source.tokens
        is_declared = tokens[index - 1].kind == "word" and tokens[index - 1].text != "return"
        is_initialised = tokens[index - 1].text in (":", ",") and tokens[index + 1].text == "("
        is_taken = tokens[index - 1].text in ("&", "*") and not self.source.is_between_blanks(index - 1)
        if token.kind != "word" or is_declared or is_initialised or is_taken:
            return
        for pair in _PAIRS:
            if token.text in pair:
                other = pair[1 - pair.index(token.text)]
                if any(known.text == other for known in tokens):
                    self.replace("confused", index, other)

    def _statements(self, block):
        for number, statement in enumerate(block):
            if self._is_outside(statement):
                continue
            if statement.kind in ("plain", "compound") or self._text(statement).startswith(_LEAVES):
                begin, end = self._ends(statement)
                self.add("dropped", statement.begin, begin, end, ";", f"without {self._text(statement)}")
            if number > 0:
                self._swap(block[number - 1], statement)

    def _swap(self, first, second):
        if {first.kind, second.kind} & {"jump", "label"} or self._needs(second, first):
            return
        (begin, middle), (next_begin, end) = self._ends(first), self._ends(second)
        text = self.source.text
        swapped = text[next_begin:end] + text[middle:next_begin] + text[begin:middle]
        self.add("swapped", first.begin, begin, end, swapped,
                  f"{self._text(second)} before {self._text(first)}")

    def _needs(self, statement, declaration):
        """Whether a statement uses the name that the one above it declares."""
        if declaration.kind != "declaration":
            return False
        tokens = self.source.tokens
        names = [tokens[index].text for index in range(declaration.begin, declaration.end - 1)
                 if tokens[index].kind == "word" and tokens[index + 1].text in ("=", ";", "(", "{")]
        return any(tokens[index].text in names[:1] for index in range(statement.begin, statement.end))

    def _is_outside(self, statement):
        function = self.source.function_of(statement.begin)
        return bool(self.functions) and function.name not in self.functions

    def _ends(self, statement):
        return self.source.tokens[statement.begin].begin, self.source.tokens[statement.end - 1].end

    def _text(self, statement):
        """The statement on one line; of a compound statement, the part before its body."""
        begin, end = self._ends(statement)
        text = _one_line(self.source.text[begin:end])
        return text if statement.kind != "compound" else re.sub(r" \{ .*", " {...}", text)

    def numbered(self):
        """The mutants, with a number where their names are the same."""
        named, seen = [], {}
        for mutant in self.found:
            seen[mutant.name] = seen.get(mutant.name, 0) + 1
            number = seen[mutant.name]
            named.append(mutant if number == 1 else dataclasses.replace(mutant, name=f"{mutant.name} [{number}]"))
        return named


def numbers_near(literal):
    """A floating constant by one ulp, by 1 % and by sign; an integer by one; a hexadecimal one by its first and last bit."""
    if re.fullmatch(r"0[xX][0-9A-Fa-f']+[uUlL]*", literal):
        digits, suffix = re.fullmatch(r"(.*?)([uUlL]*)", literal).groups()
        value = int(digits.replace("'", ""), 16)
        return [f"0x{value ^ 1:X}{suffix}", f"0x{value ^ 1 << value.bit_length() - 1:X}{suffix}"]
    if re.fullmatch(r"[\d']+[uUlL]*", literal):
        digits, suffix = re.fullmatch(r"([\d']+)([uUlL]*)", literal).groups()
        value = int(digits.replace("'", ""))
        return [f"{value + 1}{suffix}", f"{value - 1}{suffix}" if value > 0 else f"-1{suffix}"]
    digits = literal.replace("'", "")
    value = float.fromhex(digits) if digits[:2] in ("0x", "0X") else float(digits)
    near = [math.nextafter(value, math.inf), math.nextafter(value, -math.inf)]
    if value != 0.0:
        near += [value * 1.01, value * 0.99]
    return [repr(number) for number in near + [-value]]


def mutants_of(path, text, functions=()):
    """Every mutant of a file, or of some of its functions."""
    return Mutators(path, text, functions).all()
