#!/usr/bin/python3
"""packaging/words --check, over a small program with one fault at a time: each is found, and none without one."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

WORDS = sys.argv.pop(1)

PANEL = """
#include "panel.h"  // "not a text"
namespace glisson::widgets {
Panel::Panel() {
  setObjectName("some panel");
  keep_translated(this, [this] { label_->setText(tr("%1 of \\"%2\\" "
                                           "cells").arg(1).arg(QString("a"))); });
  /* setText("Not shown") */
}
}
"""
HEADER = "namespace glisson::widgets { class Panel : public QWidget { Q_OBJECT  public: Panel(); }; }\n"
CORE = 'Failure f() { return failure("empty", GLISSON_TEXT("{0} is empty."), {1\'000}); }\n'
TRANSLATIONS = """<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context><name>errors</name>
<message><source>{0} is empty.</source><translation>{0} ist leer.</translation></message></context>
<context><name>glisson::widgets::Panel</name>
<message><source>%1 of &quot;%2&quot; cells</source><translation>%1 der Zellen von „%2“</translation></message></context>
</TS>
"""


class Words(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)
        self.write("widgets/panel.h", HEADER)
        self.write("widgets/panel.cpp", PANEL)
        self.write("core/room/file.cpp", CORE)
        (self.root / "app").mkdir()
        self.write("translations/glisson_de.ts", TRANSLATIONS)

    def tearDown(self):
        self.folder.cleanup()

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def words(self, *options):
        done = subprocess.run([WORDS, *options, "--root", self.root], capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    def assert_found(self, *parts):
        code, said = self.words("--check")
        self.assertEqual(code, 1, said)
        for part in parts:
            self.assertIn(part, said)
        self.assertEqual(len(said.strip().split("\n")), 1, said)

    def test_passes_what_is_complete(self):
        self.assertEqual(self.words("--check")[0], 0, self.words("--check")[1])

    def test_finds_an_untranslated_text_of_the_window(self):
        self.write("widgets/panel.cpp", PANEL.replace("cells", "nodes"))
        self.assert_found("nodes", "is not translated")

    def test_finds_an_untranslated_sentence_of_the_core(self):
        self.write("core/room/file.cpp", CORE.replace("is empty", "is full"))
        self.assert_found("{0} is full.", "is not translated")

    def test_finds_a_lost_placeholder(self):
        self.write("translations/glisson_de.ts", TRANSLATIONS.replace("„%2“", "ihm"))
        self.assert_found("%2", "other placeholders")

    def test_finds_an_unmarked_text_of_the_window(self):
        self.write("widgets/panel.cpp", PANEL.replace("keep_translated(", 'button_->setToolTip("mesh"); keep_translated('))
        self.assert_found("widgets/panel.cpp:6", "not in tr()", "mesh")

    def test_finds_an_unmarked_sentence_anywhere_in_the_window(self):
        self.write("widgets/panel.cpp", PANEL.replace("keep_translated(", 'const QString text = "Some words"; keep_translated('))
        self.assert_found("not in tr()", "Some words")

    def test_finds_an_unmarked_sentence_of_the_core(self):
        self.write("core/room/file.cpp", CORE + 'Failure g() { return failure("full", "It is full."); }\n')
        self.assert_found("core/room/file.cpp:2", "not in GLISSON_TEXT()", "It is full.")

    def test_finds_a_sentence_that_is_wrong_of_one_thing(self):
        counted = 'GLISSON_TEXT("{0} triangles are flat.")'
        self.write("core/room/file.cpp", CORE + f"const char* g() {{ return {counted}; }}\n")
        known = "</context>\n<context><name>glisson"
        of_many = "<message><source>{0} triangles are flat.</source><translation>{0} sind flach.</translation></message>"
        of_one = "<message><source>{0} triangle is flat.</source><translation>{0} ist flach.</translation></message>"
        self.write("translations/glisson_de.ts", TRANSLATIONS.replace(known, of_many + known))
        self.assert_found("wrong of one", "{0} triangles")
        beside = f'const char* h(int n) {{ return n == 1 ? GLISSON_TEXT("{{0}} triangle is flat.") : {counted}; }}\n'
        self.write("core/room/file.cpp", CORE + beside)
        self.write("translations/glisson_de.ts", TRANSLATIONS.replace(known, of_one + of_many + known))
        self.assertEqual(self.words("--check")[0], 0, self.words("--check")[1])

    def test_takes_new_texts_in_and_keeps_what_is_translated(self):
        self.write("core/room/file.cpp", CORE + 'Failure g() { return failure("f", GLISSON_TEXT("It is full.")); }\n')
        self.assertEqual(self.words()[0], 1)  # there is something to translate now
        kept = (self.root / "translations/glisson_de.ts").read_text()
        self.assertIn("It is full.", kept)
        self.assertIn("{0} ist leer.", kept)
        self.assertIn("der Zellen von", kept)


if __name__ == "__main__":
    unittest.main()
