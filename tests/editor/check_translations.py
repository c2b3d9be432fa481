#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether each translation of the editor says everything the sources say.

    check_translations.py --root FOLDER --lupdate PROGRAM

Fails where more than --lag of the texts of the sources have no translation (those that have none are named in any case), on a value (%1, %n) or line break that got lost in it, on a missing
plural form, and on a key of a menu (&) that is there in one language and not in the other. After a change of texts, build the
target detent-edit-texts and translate what it marks as unfinished.
"""

import argparse
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path

FORMS = {"de": 2}  # plural forms
MISSING = "not translated"


def values(text):
    return sorted(re.findall(r"%(?:L?\d+|n)", text))


def has_key(text):
    return re.search(r"&[^&\s]", text) is not None


def faults_of(message, language):
    source = message.findtext("source")
    translation = message.find("translation")
    if translation.get("type") in ("vanished", "obsolete"):
        return
    if message.get("numerus"):
        texts = [form.text or "" for form in translation]
        if len(texts) != FORMS[language]:
            yield f"{len(texts)} plural forms, not {FORMS[language]}"
    else:
        texts = [translation.text or ""]
    if translation.get("type") == "unfinished" or not all(texts):
        yield MISSING
        return
    for text in texts:
        if values(text) != values(source):
            yield f"values {values(source)} became {values(text)} in \"{text}\""
        if text.count("\n") != source.count("\n"):
            yield f"line breaks differ in \"{text}\""
        if has_key(text) != has_key(source):
            yield f"a key (&) is in one of both only: \"{text}\""
        if source.strip() == source and text.strip() != text or source.startswith(" ") != text.startswith(" "):
            yield f"spaces at the ends differ in \"{text}\""


def check(file, root, lupdate, lag):
    language = file.stem.split("_")[-1]
    with tempfile.TemporaryDirectory() as folder:
        updated = Path(folder) / file.name
        shutil.copy(file, updated)
        subprocess.run([lupdate, "-silent", "-extensions", "cpp,h", "-locations", "none", "-I", ".", "-tr-function-alias", "tr+=Message,tr+=words",
                        "editor", "importer", "model", "playback", "-ts", updated], cwd=root, check=True, capture_output=True, timeout=300)
        messages = [m for m in ET.parse(updated).getroot().iter("message")]
    faults, missing = [], []
    for message in messages:
        for fault in faults_of(message, language):
            (missing if fault == MISSING else faults).append(f"{file.name}: \"{message.findtext('source')}\": {fault}")
    print(f"{file.name}: {len(messages)} texts, {len(missing)} not translated, {len(faults)} faults")
    for each in missing:
        print(each)
    marked = {m.findtext("source") for m in messages if m.find("translation").get("type") not in ("vanished", "obsolete")}
    return faults + (missing if len(missing) > lag * len(messages) else []), marked


# A literal that may go on over several lines; the group has it as it stands.
LITERAL = r'((?:\s*"(?:[^"\\]|\\.)*")+)'
REST_OF_STATEMENT = re.compile(r'(?:"(?:[^"\\]|\\.)*"|[^;"])*')


def words_of(literals):
    return "".join(re.findall(r'"((?:[^"\\]|\\.)*)"', literals)).replace('\\"', '"')


def sources_said_to_people(root):
    """Files whose failures a window shows; the programs speak English."""
    for room in ("model", "importer", "editor", "playback"):
        for file in sorted((root / room).rglob("*.cpp")):
            place = file.relative_to(root).as_posix()
            if not re.search(r"/program/|/python/|main\.cpp$|^importer/(library|batch)/|^model/(file/|validation|number_table)|" +
                             r"^playback/(identification|performance|study/statistics)/|^playback/magnetic/(?!magnetic_)|^playback/(measure_|.*(calibrate|sweep|spring_button|button_numbers|timing_tables)\.cpp)", place):
                yield place, re.sub(r"//[^\n]*", "", file.read_text())


def unmarked(root, known):
    """Words that a person reads but lupdate does not find: what is not said as Message("..."). `known`: what lupdate finds."""
    said_as_message = r'Message\(' + LITERAL
    for place, text in sources_said_to_people(root):
        for call in re.finditer(r"\bFailureCode::\w+,|\b(?:unreadable|refused|refusal|noCurve|without|broken|noGraph|refuse)\(", text):
            said = re.sub(said_as_message, "", REST_OF_STATEMENT.match(text, call.end()).group())
            said = re.sub(r"RemedyKind::(?!advice)\w+," + LITERAL, "", said)
            for match in re.finditer(LITERAL, said):
                words = words_of(match.group(1))
                if re.match(r"[A-Za-z][^ ]* .*[a-z]", words) and words not in known:
                    yield f"{place}: \"{words}\" is said to people, but not as Message(\"...\")"
        for variable in re.finditer(r"\bMessage\s+\w+[({]" + LITERAL, text):
            yield f"{place}: lupdate does not find \"{words_of(variable.group(1))}\": write auto NAME = Message(\"...\")"
        for code in re.finditer(r"\bFailureCode::\w+,\s*\"([A-Za-z ]+)\"\s*[,}]", text):
            if code.group(1) not in known:
                yield f"{place}: \"{code.group(1)}\" is what a failure is about, but is not among the translated parts"
        for either in re.finditer(r"\?" + LITERAL + r"\s*:" + LITERAL, text):
            if any(len(words_of(part).split()) > 2 and words_of(part) in known for part in either.groups()):
                yield f"{place}: one of two literals ({words_of(either.group(1))}) is no literal any more: Message(\"...\") around each"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2])
    parser.add_argument("--lupdate", type=Path, required=True)
    parser.add_argument("--lag", type=float, default=0.02, help="share of the texts that a translation may be behind (default: 0.02)")
    arguments = parser.parse_args()
    faults = []
    for file in sorted((arguments.root / "editor/translations").glob("detent_*.ts")):
        found, marked = check(file, arguments.root, arguments.lupdate, arguments.lag)
        faults += found + list(unmarked(arguments.root, marked))
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
