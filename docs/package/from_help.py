#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the man pages and the shell completion of the programs from what they answer to --help and --version.

A man page in another language is made from PROGRAM.LANGUAGE.txt beside this script, which must name the options that --help names, or, where there is none, from
the same --help with every sentence in the words of help.LANGUAGE.txt: English, below it the translation, then an empty line. One that is missing there is named and
stays English: what a build without some of its parts says needs no translation.

    from_help.py --bin FOLDER --out FOLDER

FOLDER of --bin holds the programs (those that are there are described); --out gets man1/PROGRAM.1.gz, LANGUAGE/man1/PROGRAM.1.gz and completions/PROGRAM.
`cmake --install` runs it, so that what is installed describes the very programs beside it. Deterministic: no date, no path.
"""

import argparse
import gzip
import re
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

PROGRAMS = ("detent-import", "detent-graph", "detent-play", "detent-edit")
HEADINGS = {"": ("User Commands", "NAME", "DESCRIPTION", "SEE ALSO"), "de": ("Benutzerkommandos", "BEZEICHNUNG", "BESCHREIBUNG", "SIEHE AUCH")}
OPTION = re.compile(r"^ +(-{1,2}[A-Za-z][^ ]*(?:, --?[\w-]+)*)(.*)$")
SECTION = re.compile(r"^(?:\[Option Group: (?P<group>[^\]]+)\]|(?P<title>[A-Z][^:]*):)$")
# CLI11's spelling of a value that comes from a list: {draft->0,precise->2}.


@dataclass
class Help:
    """One --help, cut into what a man page needs."""
    words: list  # program and subcommands
    text: str
    options: list = field(default_factory=list)  # --names
    subcommands: dict = field(default_factory=dict)  # name -> one line


def answer(binary, *words):
    """What a program prints; argv[0] is the bare name, as in a shell that found it on the PATH."""
    run = subprocess.run([binary.name, *words], executable=binary, capture_output=True, text=True, timeout=60)
    if run.returncode != 0:
        sys.exit(f"from_help.py: '{binary.name} {' '.join(words)}' ended with {run.returncode}: {run.stderr.strip()}")
    return run.stdout


def read_help(binary, *words):
    text = answer(binary, *words, "--help")
    found = Help([binary.name, *words], text.rstrip())
    found.options = sorted(set(re.findall(r"(?m)^ +(?:-\w, ?)?(--[a-z][\w-]*)", text)))
    listed = re.search(r"(?ms)^Subcommands:\n(.*?)(?:\n\n|\Z)", text)
    if listed:
        found.subcommands = dict(re.findall(r"(?m)^  (\S+) +(.*)$", listed.group(1)))
    return found


def all_helps(binary, *words):
    """The help of a program or subcommand and of everything below it."""
    found = [read_help(binary, *words)]
    for name in found[0].subcommands:
        found += all_helps(binary, *words, name)
    return found


def escaped(text):
    """As roff: backslashes and minus signs as they are typed, no line taken for a request."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\n".join("\\&" + line if line[:1] in (".", "'") else line for line in text.split("\n"))


def body(text, say):
    """A help text as roff: sections, options as tagged paragraphs, anything else filled; each sentence as `say` has it."""
    lines, out = text.split("\n"), []
    at = 0
    while at < len(lines):
        line = lines[at].rstrip()
        at += 1
        section, option = SECTION.match(line), OPTION.match(line)
        if section:
            out.append(f".SS {escaped(say(section['group'] or section['title']))}")
        elif option and not line.startswith("       "):
            words = option.group(1) + option.group(2)
            tag, _, meaning = words.strip().partition("  ")
            deeper = len(line) - len(line.lstrip()) + 6
            while at < len(lines) and len(lines[at]) - len(lines[at].lstrip()) >= deeper and lines[at].strip():
                meaning += " " + lines[at].strip()
                at += 1
            out += [".TP", f".B {escaped(tag)}", escaped(say(meaning.strip()) if meaning.strip() else tag)]
        elif re.match(r"^ {2,}\S", line):
            tag, _, meaning = line.strip().partition("  ")
            out += [".TP", f".B {escaped(tag)}", escaped(say(meaning.strip()))] if meaning else [escaped(say(line.strip()))]
        elif not line:
            out.append(".PP")
        elif line.startswith("Usage: "):
            out.append(escaped(f"{say('Usage')}: {line.removeprefix('Usage: ')}"))
        elif not line.strip() in ("Options:",):
            out.append(escaped(say(line)))
    return "\n".join(entry for i, entry in enumerate(out) if entry != ".PP" or (i and out[i - 1] not in (".PP",)))


def man_page(helps, version, language="", say=lambda text: text):
    program = helps[0].words[0]
    section, name, description, see_also = HEADINGS[language]
    first = next(line for line in helps[0].text.split("\n") if line and not line.startswith("Usage:"))
    pages = [f'.TH {program.upper()} 1 "" "Detent {version}" "{section}"', f".SH {name}",
             f"{program} \\- {escaped(say(first).split('. ')[0].rstrip('.'))}", f".SH {description}", body(helps[0].text, say)]
    for sub in helps[1:]:
        pages += [f".SH {escaped(' '.join(sub.words[1:]).upper())}", body(sub.text, say)]
    others = ", ".join(f".BR {escaped(name)} (1)" for name in PROGRAMS if name != program).replace(", ", " ,\n")
    return "\n".join(pages + [f".SH {see_also}", others, ""])


def translated(english, text, source):
    found = Help(english.words, text.rstrip())
    found.options = sorted(set(re.findall(r"(?m)^ +(?:-\w, ?)?(--[a-z][\w-]*)", text)))
    if found.options != english.options:
        sys.exit(f"from_help.py: {source.name} names {found.options}, --help names {english.options}")
    return found


class Dictionary:
    """Sentences of --help in another language."""

    def __init__(self, source):
        self.source = source
        entries = [block.split("\n") for block in source.read_text(encoding="utf-8").strip().split("\n\n")]
        wrong = [block for block in entries if len(block) != 2]
        if wrong:
            sys.exit(f"from_help.py: {source.name}: not two lines: {wrong[0]}")
        self.words = dict(entries)

    def __call__(self, english):
        if english not in self.words:
            print(f"from_help.py: {self.source.name} has no words for \"{english}\"", file=sys.stderr)
        return self.words.get(english, english)


def write_page(folder, name, page):
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / f"{name}.1.gz", "wb") as file, \
            gzip.GzipFile(filename="", mode="wb", fileobj=file, mtime=0, compresslevel=9) as packed:
        packed.write(page.encode())


def completion(helps):
    """For bash: subcommands first, then the options of the innermost one, else files."""
    program = helps[0].words[0]
    name = "_" + program.replace("-", "_")
    cases = []
    for found in reversed(helps):
        key = " ".join(found.words[1:])
        cases.append(f'    "{key}") options="{" ".join(found.options)}" commands="{" ".join(found.subcommands)}" ;;')
    known = " ".join(sorted({word for found in helps for word in found.words[1:]}))
    return f"""# bash completion of {program}, made from its --help
{name}() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} path="" options="" commands="" i
  for ((i = 1; i < COMP_CWORD; i++)); do
    [[ " {known} " == *" ${{COMP_WORDS[i]}} "* ]] && path="${{path:+$path }}${{COMP_WORDS[i]}}"
  done
  case $path in
{chr(10).join(sorted(set(cases)))}
  esac
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$word"; compgen -f -- "$word")
  fi
}}
complete -o filenames -F {name} {program}
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--bin", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True)
    arguments = parser.parse_args()
    (arguments.out / "completions").mkdir(parents=True, exist_ok=True)
    dictionaries = [Dictionary(source) for source in sorted(Path(__file__).parent.glob("help.*.txt"))]
    written = 0
    for name in PROGRAMS:
        binary = (arguments.bin / name).resolve()
        if not binary.is_file():
            continue
        helps = all_helps(binary)
        version = answer(binary, "--version").split()[-1]
        write_page(arguments.out / "man1", name, man_page(helps, version))
        for dictionary in dictionaries:
            language = dictionary.source.suffixes[-2].lstrip(".")
            whole = Path(__file__).with_name(f"{name}.{language}.txt")
            page = man_page([translated(helps[0], whole.read_text(encoding="utf-8"), whole)], version, language) if whole.is_file() \
                else man_page(helps, version, language, dictionary)
            write_page(arguments.out / language / "man1", name, page)
        (arguments.out / "completions" / name).write_text(completion(helps))
        written += 1
    if not written:
        sys.exit(f"from_help.py: none of {', '.join(PROGRAMS)} stands in {arguments.bin}. Build them first.")


if __name__ == "__main__":
    main()
