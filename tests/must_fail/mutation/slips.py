"""Slips of a person in a source file: arguments swapped, a neighbouring enumerator, the wrong member of a struct, one
more or less than a named size. The compiler refuses most that are not of one type."""

import dataclasses
import re

from mutators import Mutators

_ENUM = re.compile(r"\benum class (\w+)[^{;]*\{([^}]*)\}")
_MEMBERS = re.compile(r"^ +((?:std::)?[\w:]+(?:<[^;()]*>)?) ([a-z]\w*(?:, [a-z]\w*)*)(?: = [^;()]*|\{[^;()]*\})?;", re.MULTILINE)
_SIZE = re.compile(r"\bconstexpr (?:int|std::\w+_t) (k[A-Z]\w*) = ")
_COMMENT = re.compile(r"//[^\n]*")
_SYMMETRIC = ("min", "max")


@dataclasses.dataclass(frozen=True)
class Names:
    """What a word can be taken for: {enumeration: its enumerators}, {member: the next one of its type}, the named sizes."""

    enumerators: dict
    neighbours: dict
    sizes: frozenset


def names_in(texts):
    """The names that these sources declare."""
    enumerators, neighbours, sizes = {}, {}, set()
    for text in (_COMMENT.sub("", text) for text in texts):
        for name, body in _ENUM.findall(text):
            enumerators[name] = [each.split("=")[0].strip() for each in body.split(",") if each.strip()]
        last_type, last_name = "", ""
        for kind, names in _MEMBERS.findall(text):
            for name in names.split(", "):
                if kind == last_type and not {last_name, name} & neighbours.keys():
                    neighbours[last_name], neighbours[name] = name, last_name
                last_type, last_name = kind, name
        sizes.update(_SIZE.findall(text))
    return Names(enumerators, neighbours, frozenset(sizes))


class _Slips(Mutators):
    def __init__(self, path, text, names):
        super().__init__(path, text, ())
        self.names = names

    def all(self):
        tokens = self.source.tokens
        for function in self.source.functions:
            for index in range(function.body + 1, function.close):
                if tokens[index].text == "(" and tokens[index - 1].kind == "word" and (
                        tokens[index - 1].text not in _SYMMETRIC):
                    self._arguments(index)
                if tokens[index].kind == "word":
                    self._word(index, tokens[index].text, tokens[index - 1].text, tokens[index + 1].text)
        return self.numbered()

    def _arguments(self, opening):
        arguments = self._split(opening)
        for (begin, middle), (next_begin, end) in zip(arguments, arguments[1:]):
            text = self.source.text
            first, second = text[begin:middle], text[next_begin:end]
            if first != second:
                self.add("swapped arguments", opening, begin, end, second + text[middle:next_begin] + first)

    def _split(self, opening):
        """Begin and end of each argument of a call."""
        tokens, ends, begin = self.source.tokens, [], opening + 1
        index = begin
        while index <= self.source.partner[opening]:
            if tokens[index].text == "," or index == self.source.partner[opening]:
                if index > begin:
                    ends.append((tokens[begin].begin, tokens[index - 1].end))
                begin = index + 1
            elif index in self.source.partner:
                index = self.source.partner[index]
            index += 1
        return ends

    def _word(self, index, text, before, after):
        others = self.names.enumerators.get(self.source.tokens[index - 2].text, ()) if before == "::" else ()
        if text in others and len(others) > 1:
            self.replace("neighbouring enumerator", index, others[(others.index(text) + 1) % len(others)])
        elif before in (".", "->") and after != "(" and text in self.names.neighbours:
            self.replace("wrong member", index, self.names.neighbours[text])
        elif text in self.names.sizes and after != "=" and before != "::":
            for one in ("- 1", "+ 1"):
                self.replace("named size", index, f"({text} {one})")


def slips_of(path, text, names):
    return _Slips(path, text, names).all()
