# SPDX-License-Identifier: GPL-3.0-or-later
"""What the manual holds of the program's own words is current; `ninja manual_files` renews it."""

from program import TOP, ProgramTest, main

FILES = {
    "cards.md": ["help", "--markdown"],
    "error_codes.md": ["help", "codes", "--markdown"],
    "editors/spricka.vim": ["editor", "vim"],
    "editors/spricka.tmLanguage.json": ["editor", "vscode"],
}


class Manual(ProgramTest):
    def test_generated_files_are_current(self):
        for name, command in FILES.items():
            with self.subTest(name):
                text = (TOP / "manual" / name).read_text(encoding="utf-8")
                self.assertEqual(text, self.expect(0, *command).stdout, "run ninja manual_files")


if __name__ == "__main__":
    main()
