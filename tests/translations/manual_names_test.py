#!/usr/bin/python3
"""The manual names what the window shows as the window does: manual_names_test.py PROJECT_FOLDER. Where an English page
has a button, menu or workspace in *italics* or **bold**, each translated page has its translation from the .ts file."""
import pathlib
import re
import sys
import unittest
import xml.etree.ElementTree as xml

PROJECT = pathlib.Path(sys.argv.pop(1))


def name(text):
    """As it is printed in the manual: no key to press, no sign before it, no dots or unit behind."""
    return re.sub(r"^\W+|\s*(\.\.\.|…| mm)$", "", " ".join(text.replace("&", "").split()))


def names_on(page):
    text = re.sub("`[^`]*`", "", page.read_text()).replace("**", "*")
    marked = re.findall(r"\*([^*]+)\*", text)
    # "*Help > Manual*", "*File, Elastography waves*": the whole may be a name, and so may its parts.
    return {name(part) for each in marked for part in [each, *re.split(" > |, ", each)]}


class ManualNames(unittest.TestCase):
    def test_names_are_those_of_the_window(self):
        for language in ["de", "fr", "es"]:
            translations = {}
            for message in xml.parse(PROJECT / "translations" / f"glisson_{language}.ts").iter("message"):
                translations.setdefault(name(message.findtext("source")), set()).add(name(message.findtext("translation")))
            found = 0
            for english in sorted((PROJECT / "resources/manual").glob("*.md")):
                page = english.parent / language / english.name
                for shown in names_on(english) & translations.keys():
                    with self.subTest(page=str(page), name=shown):
                        self.assertTrue(translations[shown] & names_on(page), f"one of {translations[shown]} is wanted")
                    found += 1
            self.assertGreater(found, 50)


if __name__ == "__main__":
    unittest.main()
