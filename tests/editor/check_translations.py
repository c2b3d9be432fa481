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
        subprocess.run([lupdate, "-silent", "-locations", "none", "-I", ".", "-tr-function-alias", "tr+=Message,tr+=words",
                        "editor", "importer", "model", "playback/study/perception", "-ts", updated], cwd=root, check=True, capture_output=True, timeout=300)
        messages = [m for m in ET.parse(updated).getroot().iter("message")]
    faults, missing = [], []
    for message in messages:
        for fault in faults_of(message, language):
            (missing if fault == MISSING else faults).append(f"{file.name}: \"{message.findtext('source')}\": {fault}")
    print(f"{file.name}: {len(messages)} texts, {len(missing)} not translated, {len(faults)} faults")
    for each in missing:
        print(each)
    return faults + (missing if len(missing) > lag * len(messages) else [])


def unmarked(root):
    """Words of a file that cannot be read, where lupdate does not find them: what is not said as Message("...")."""
    for file in sorted((root / "importer/page").glob("*.cpp")) + [root / "importer/log/text_lines.cpp"]:
        text = file.read_text()
        for call in re.finditer(r"\bunreadable\(", text):
            said = re.sub(r'Message\((?:\s*"(?:[^"\\]|\\.)*")+', "", text[call.end():text.index(";", call.end())])
            for words in re.findall(r'"([A-Za-z][^"]* [^"]*)"', said):
                yield f"{file.relative_to(root)}: \"{words}\" is said to people, but not as Message(\"...\")"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2])
    parser.add_argument("--lupdate", type=Path, required=True)
    parser.add_argument("--lag", type=float, default=0.02, help="share of the texts that a translation may be behind (default: 0.02)")
    arguments = parser.parse_args()
    faults = list(unmarked(arguments.root))
    for file in sorted((arguments.root / "editor/translations").glob("detent_*.ts")):
        faults += check(file, arguments.root, arguments.lupdate, arguments.lag)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
