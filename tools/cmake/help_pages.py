#!/usr/bin/python3
"""help_pages.py PROGRAM FOLDER: writes the man page (hyrax-sim.1.gz) and the bash completion (hyrax-sim) of hyrax-sim into
FOLDER, from what `PROGRAM --help`, `PROGRAM COMMAND --help` and `PROGRAM --version` print."""

import dataclasses
import gzip
import pathlib
import re
import subprocess
import sys

COMPLETION = r"""# bash completion for hyrax-sim, made of its --help.
_hyrax_sim() {
  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} words=
  COMPREPLY=()
  if [[ $COMP_CWORD -eq 1 ]]; then
    words='@COMMANDS@ --help --version'
  else
    case ${COMP_WORDS[1]},$before in
@VALUES@
    esac
    [[ -n $words || $current != -* ]] || case ${COMP_WORDS[1]} in
@OPTIONS@
    esac
  fi
  [[ -z $words ]] || mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
}
complete -o default -F _hyrax_sim hyrax-sim
"""


@dataclasses.dataclass
class Entry:
    """An argument or option of a command: "-o,--output FILE", and the lines of its help."""

    names: str
    lines: list

    @property
    def options(self):
        """Its option names: -o and --output."""
        return self.names.split(" ")[0].split(",")

    @property
    def values(self):
        """The values that it can have, where the help lists them as a|b."""
        value = self.names.partition(" ")[2]
        return value.split("|") if re.fullmatch(r"\w+(\|\w+)+", value) else []


@dataclasses.dataclass
class Command:
    """The help of one command."""

    name: str
    summary: str
    usage: str
    arguments: list
    options: list
    examples: list


def printed(program, *arguments):
    """What the program prints."""
    return subprocess.run([program, *arguments], check=True, capture_output=True, encoding="utf-8").stdout


def entries(text):
    """The entries of two columns. A line that is indented further continues the help of the one above."""
    found = []
    for line in text.splitlines():
        entry = re.fullmatch(r"  (\S+(?: \S+)*)(?:\s{2,}(.*))?", line)
        if entry:
            found.append(Entry(entry[1], [entry[2]] if entry[2] else []))
        elif line.strip():
            found[-1].lines.append(line.strip())
    return found


def sections(text):
    """{"Options": text, ...} of a help text; what stands before the first one is under ""."""
    parts = re.split(r"^([A-Z][a-z]+):\n", text, flags=re.MULTILINE)
    return {"": parts[0], **dict(zip(parts[1::2], parts[2::2]))}


def command(program, name):
    """The help of a command."""
    parts = sections(printed(program, name, "--help"))
    summary, usage = parts[""].strip().split("\nUsage: ")
    return Command(name, summary, usage, entries(parts.get("Arguments", "")), entries(parts["Options"]),
                   parts["Example"].strip().splitlines())


def roff(text):
    """Text of a man page, where a backslash, a dash, and a dot or quote at the start of a line mean something else."""
    escaped = text.replace("\\", "\\e").replace("-", "\\-")
    return re.sub(r"^(?=[.'])", r"\\&", escaped, flags=re.MULTILINE)


def verbatim(lines):
    """Lines that are not filled."""
    return "\n".join([".nf", *(roff(line.strip()) for line in lines), ".fi"])


def described(entry):
    """An argument or option."""
    return f".TP\n.B {roff(entry.names)}\n{verbatim(entry.lines)}"


def command_section(each):
    """A command."""
    return "\n".join([f".SS {roff(each.name)}", roff(f"{each.summary}."), ".PP", f".B {roff(each.usage)}",
                      *map(described, each.arguments + each.options), ".PP", "Example:", ".RS", verbatim(each.examples), ".RE"])


def man_page(screen, version, commands):
    """The manual. `screen` is the first help screen."""
    about = screen.split("\n", 1)[0]
    examples = re.findall(r"^  (hyrax-sim .*)", screen, re.MULTILINE)
    usage = re.search(r"^Usage: (.*)", screen, re.MULTILINE)[1]
    exit_codes = screen.split("Exit codes: ", 1)[1].strip()
    return "\n".join([
        f'.TH HYRAX\\-SIM 1 "" "{roff(version)}" "User Commands"',
        ".SH NAME", roff(about.replace("hyrax-sim ", "hyrax-sim - ", 1).rstrip(".")),
        ".SH SYNOPSIS", f".B {roff(usage)}",
        ".SH COMMANDS", *map(command_section, commands),
        ".SH EXAMPLES", verbatim(examples),
        ".SH EXIT STATUS", roff(" ".join(exit_codes.split())),
        ".SH FILES", ".TP", ".I /usr/share/hyrax\\-sim/scenarios", "Scenarios.",
        ".TP", ".I /usr/share/hyrax\\-sim/golden", "Their golden files.", ""])


def completion(commands):
    """The completion of commands, options, and values that the help lists."""
    def case(pattern, words):
        return f"      {pattern}) words='{' '.join(words)}' ;;"

    options = [case(each.name, (name for entry in each.options for name in entry.options)) for each in commands]
    values = [case(f"{each.name},{name}", entry.values)
              for each in commands for entry in each.options if entry.values for name in entry.options]
    return (COMPLETION.replace("@COMMANDS@", " ".join(each.name for each in commands))
            .replace("@VALUES@", "\n".join(values)).replace("@OPTIONS@", "\n".join(options)))


def write_pages(program, folder):
    """Writes both."""
    screen = printed(program, "--help")
    names = re.findall(r"^  ([a-z]+) +\S", screen[screen.index("\nCommands:\n"):], re.MULTILINE)
    commands = [command(program, name) for name in names]
    folder.mkdir(parents=True, exist_ok=True)
    page = man_page(screen, printed(program, "--version").strip(), commands)
    (folder / "hyrax-sim.1.gz").write_bytes(gzip.compress(page.encode(), mtime=0))
    (folder / "hyrax-sim").write_text(completion(commands), encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: help_pages.py PROGRAM FOLDER")
    write_pages(sys.argv[1], pathlib.Path(sys.argv[2]))
