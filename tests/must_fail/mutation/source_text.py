"""C++ as far as the mutation tool needs it: tokens, functions and statements.

The sources must be formatted by clang-format: a binary operator has blanks around it, a template's
bracket does not.
"""

import dataclasses
import re

_TOKEN = re.compile(r"""
    (?P<skipped>\s+|//[^\n]*|/\*.*?\*/|^[ \t]*\#[^\n]*|\bassert\s*\([^;]*;)  # Asserts are not in a release build.
  | (?P<text>R"(?P<fence>[^(\s]*)\(.*?\)(?P=fence)"|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*')
  | (?P<number>0[xX][0-9A-Fa-f.']+(?:[pP][+-]?\d+)?[uUlL]*|\d[\d']*(?:\.\d*)?(?:[eE][+-]?\d+)?[uUlLfF]*)
  | (?P<word>[A-Za-z_]\w*)
  | (?P<operator><<=|>>=|->|\+\+|--|<=|>=|==|!=|&&|\|\||\+=|-=|\*=|/=|\^=|\|=|&=|<<|>>|::|.)
""", re.VERBOSE | re.MULTILINE | re.DOTALL)

_CLOSES = {"(": ")", "{": "}", "[": "]"}


@dataclasses.dataclass(frozen=True)
class Token:
    """One token and its position in the text."""

    kind: str
    text: str
    begin: int
    end: int


@dataclasses.dataclass(frozen=True)
class Function:
    """The tokens of a function's body, braces included, and of its member initialisers."""

    name: str
    header: int
    body: int
    close: int


@dataclasses.dataclass(frozen=True)
class Statement:
    """The tokens `begin` to `end` (exclusive) of a statement; `kind` is plain, compound, declaration, jump or label."""

    kind: str
    begin: int
    end: int


def _tokens(text):
    return [Token(match.lastgroup, match.group(), match.start(), match.end())
            for match in _TOKEN.finditer(text) if match.lastgroup != "skipped"]


def _without_template(texts):
    """The texts of a declaration's tokens without its template head."""
    if texts[:1] != ["template"]:
        return texts
    depth = 0
    for index, text in enumerate(texts):
        depth += {"<": 1, ">": -1}.get(text, 0)
        if text == ">" and depth == 0:
            return texts[index + 1:]
    return texts


class SourceText:
    """A parsed source file. A block is the list of its statements."""

    def __init__(self, text):
        self.text = text
        self.tokens = _tokens(text)
        self.partner = self._pair_brackets()
        self.functions = []
        self._find_functions(0, len(self.tokens))
        self.blocks = []
        for function in self.functions:
            self._block(function.body)

    def function_of(self, index):
        """The function whose header, initialisers or body has the token; None at the level of a class or file."""
        return next((function for function in self.functions if function.header <= index <= function.close), None)

    def is_between_blanks(self, index):
        """Whether the token is laid out as a binary operator is."""
        token = self.tokens[index]
        return self.text[token.begin - 1].isspace() and self.text[token.end].isspace()

    def lines_of(self, begin, end):
        """The begin and the end of the complete lines around a piece of the text, on one line, without comments."""
        first = self.text.rfind("\n", 0, begin) + 1
        last = self.text.find("\n", end)
        return first, len(self.text) if last < 0 else last

    def _pair_brackets(self):
        partner, opened = {}, []
        for index, token in enumerate(self.tokens):
            if token.kind != "operator":
                continue
            if token.text in _CLOSES:
                opened.append(index)
            elif token.text in _CLOSES.values():
                partner[opened[-1]] = index
                partner[index] = opened.pop()
        return partner

    def _is(self, index, *texts):
        return index < len(self.tokens) and self.tokens[index].text in texts

    def _find_functions(self, index, end):
        header = index
        while index < end:
            if self._is(index, ";"):
                header = index + 1
            elif self._is(index, "("):
                index = self.partner[index]  # A brace in it opens no body.
            elif self._is(index, "{"):
                texts = _without_template([token.text for token in self.tokens[header:index]])
                if texts and texts[0] in ("namespace", "class", "struct"):
                    self._find_functions(index + 1, self.partner[index])
                elif self.tokens[index - 1].kind == "word" and texts[-1] not in ("const", "noexcept", "override"):
                    index = self.partner[index] + 1  # A member initialiser, or an enumeration.
                    continue
                elif "(" in texts:
                    name = texts[texts.index("(") - 1]
                    self.functions.append(Function(name, header, index, self.partner[index]))
                index = self.partner[index]
                header = index + 1
            elif self._is(index, "public", "private", "protected") and self._is(index + 1, ":"):
                index += 1
                header = index + 1
            index += 1

    def _block(self, opening):
        statements = []
        index = opening + 1
        while index < self.partner[opening]:
            end = self._statement(index)
            statements.append(Statement(self._kind(index, end), index, end))
            index = end
        self.blocks.append(statements)

    def _statement(self, index):
        """One past a statement's last token; collects the blocks inside."""
        if self._is(index, "{"):
            self._block(index)
            return self.partner[index] + 1
        if self._is(index, "if", "while", "for", "switch"):
            while not self._is(index, "("):
                index += 1
            index = self._body(self.partner[index] + 1)
            if self._is(index, "else"):
                index = self._body(index + 1)
            return index
        if self._is(index, "try"):
            index = self._statement(index + 1)
            while self._is(index, "catch"):
                index = self._statement(self.partner[index + 1] + 1)
            return index
        if self._is(index, "case", "default"):
            while not self._is(index, ":"):
                index += 1
            return index + 1
        while self.tokens[index].text != ";":
            if self._is(index, "{") and self._is_lambda(index):
                self._block(index)
            index = self.partner[index] if self._is(index, *_CLOSES) else index
            index += 1
        return index + 1

    def _body(self, index):
        """As _statement; a body without braces is a block of its own."""
        end = self._statement(index)
        if not self._is(index, "{", "if"):
            self.blocks.append([Statement(self._kind(index, end), index, end)])
        return end

    def _is_lambda(self, index):
        return self._is(index - 1, ")") and self._is(self.partner[index - 1] - 1, "]")

    def _kind(self, begin, end):
        first, second = self.tokens[begin], self.tokens[min(begin + 1, end - 1)]
        if first.text in ("if", "while", "for", "switch", "try", "{"):
            return "compound"
        if first.text in ("return", "break", "continue", "throw"):
            return "jump"
        if first.text in ("case", "default"):
            return "label"
        if first.text in ("const", "constexpr", "using", "auto", "bool", "double") or (
                first.kind == "word" and second.kind == "word"):
            return "declaration"
        return "declaration" if first.text == "std" and self._declares(begin, end) else "plain"

    def _declares(self, begin, end):
        """Whether std::name is followed by a name, as in `std::int64_t count = 0;`."""
        index = begin + 3
        if self._is(index, "<"):
            while not (self._is(index, ">", ">>") and index < end):
                index += 1
            index += 1
        return self._is(index, "&", "*") or (index < end and self.tokens[index].kind == "word")
