# SPDX-License-Identifier: GPL-3.0-or-later
"""C++ sources as text: their tokens, declarations with their comments, and lines of classes.

It reads the style of this tree: what clang-format has laid out, without macros that declare.
"""

import re
from dataclasses import dataclass, field

TOKEN = re.compile(r"""
    (?P<comment>//[^\n]*|/\*.*?\*/)
  | (?P<raw>R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)")
  | (?P<text>"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+')
  | (?P<directive>^[ \t]*\#(?:\\\n|[^\n])*)
  | (?P<name>[A-Za-z_]\w*)
  | (?P<number>\.?\d(?:[\w.']|[eEpP][+-])*)
  | (?P<mark2>::|->\*?|\+\+|--|<=>|[-+*/%&|^=!]=|&&|\|\||[^\s\w])
""", re.X | re.S | re.M)
TYPES = {"class", "struct", "enum", "union"}
ACCESS = {"public", "protected", "private"}
NO_FUNCTION = {"using", "typedef", "friend", "static_assert", "extern", "template_only", "concept"}
NO_NAME = {"if", "for", "while", "switch", "return", "sizeof", "decltype", "noexcept", "alignas",
           "requires", "operator", "explicit", "defined"}


@dataclass(frozen=True)
class Token:
    kind: str
    text: str
    line: int


@dataclass
class Function:
    """A declaration others may call: its name, class or "", comment in front of or behind it."""

    name: str
    owner: str
    line: int
    comment: str = ""
    getter: bool = False  # without arguments, on one line


@dataclass
class Type:
    """A definition of a class, struct, enum or union; lines with its braces."""

    name: str
    line: int
    last: int = 0


@dataclass
class Declarations:
    functions: list = field(default_factory=list)
    types: list = field(default_factory=list)
    members: list = field(default_factory=list)  # (class, first line, last line) of definitions outside


def tokens_of(text):
    """All tokens; raw strings and quoted text are of the kind text."""
    line, at, found = 1, 0, []
    for match in TOKEN.finditer(text):
        line += text.count("\n", at, match.start())
        at = match.start()
        kind = match.lastgroup if match.lastgroup != "mark" else "raw"
        kind = {"mark2": "mark", "raw": "text"}.get(kind, kind)
        found.append(Token(kind, match[0], line))
    return found


def code_lines(tokens):
    """Numbers of the lines that hold code: no blanks, no comments."""
    lines = set()
    for token in tokens:
        if token.kind != "comment":
            lines.update(range(token.line, token.line + token.text.count("\n") + 1))
    return lines


def closing(tokens, start):
    """Index of the bracket that closes the one at start."""
    pairs = {"(": ")", "{": "}", "[": "]"}
    opens, closes = tokens[start].text, pairs[tokens[start].text]
    depth = 0
    for index in range(start, len(tokens)):
        if tokens[index].kind == "mark":
            depth += (tokens[index].text == opens) - (tokens[index].text == closes)
            if depth == 0:
                return index
    return len(tokens) - 1


def called_name(statement):
    """(index of the name, index of its bracket) of what a statement declares as a function, or None."""
    angle = 0
    for index, token in enumerate(statement):
        if token.kind == "mark":
            if token.text == "<" and index and statement[index - 1].kind == "name":
                angle += 1
            elif token.text == ">" and angle:
                angle -= 1
            elif token.text == "=" and not angle:
                return None
            elif token.text == "(" and not angle:
                before = statement[index - 1] if index else None
                return (index - 1, index) if before and before.kind == "name" and before.text not in NO_NAME else None
    return None


def without_template(statement):
    """A statement behind its template <..> and requires, if it begins with them."""
    while len(statement) > 1 and statement[0].text == "template":
        depth = 0
        for skip in range(1, len(statement)):
            depth += (statement[skip].text == "<") - (statement[skip].text == ">")
            if depth == 0:
                break
        statement = statement[skip + 1:]
    return statement


def type_name(words):
    """The name a definition gives its type, by the tokens behind `struct`: the last of A::B, "" of a specialisation."""
    named = ""
    for token in words:
        if token.kind == "name" and token.text not in TYPES | {"final", "alignas", "nodiscard"}:
            named = token.text
        elif token.text == "<":
            return ""
        elif token.text == ":":
            break
    return named


class Reader:
    """Walks through the scopes of one source."""

    def __init__(self, text):
        all_tokens = tokens_of(text)
        self.comments = [t for t in all_tokens if t.kind == "comment"]
        self.tokens = [t for t in all_tokens if t.kind not in ("comment", "directive")]
        self.found = Declarations()

    def read(self):
        self.scope(0, len(self.tokens), "", True)
        return self.found

    def scope(self, start, end, owner, public):
        """Statements between two tokens, of a namespace or of the class `owner`."""
        index = first = start
        while index < end:
            token = self.tokens[index]
            if token.text in ACCESS and owner and self.text(index + 1) == ":":
                public = token.text == "public"
                index += 2
                first = index
            elif token.kind == "mark" and token.text == ";":
                self.statement(first, index, owner, public, None)
                index += 1
                first = index
            elif token.kind == "mark" and token.text in "([":
                index = closing(self.tokens, index) + 1
            elif token.kind == "mark" and token.text == "{":
                last = closing(self.tokens, index)
                index = self.braces(first, index, last, owner, public)
                first = index if self.ends_here(first, last) else first
            else:
                index += 1

    def text(self, index):
        return self.tokens[index].text if index < len(self.tokens) else ""

    def ends_here(self, first, last):
        """Whether a brace ends its statement: not that of a type, list or default value."""
        return self.text(last + 1) not in (";", ",", "{") or self.text(first) == "namespace"

    def braces(self, first, opened, last, owner, public):
        """Handles { .. } of a statement; index behind it."""
        statement = without_template(self.tokens[first:opened])
        words = [t.text for t in statement]
        kind = next((w for w in words if w in TYPES), None)
        if "namespace" in words or words[:1] == ["extern"]:
            self.scope(opened + 1, last, owner, public)
        elif kind and "(" not in words and "=" not in words:
            named = type_name(statement[words.index(kind) + 1:])
            if named:
                self.found.types.append(Type(named, statement[0].line, self.tokens[last].line))
                if kind != "enum":
                    self.scope(opened + 1, last, named, kind != "class")
        elif called_name(statement):
            self.statement(first, opened, owner, public, last)
        return last + 1

    def statement(self, first, end, owner, public, last):
        """A declaration up to its semicolon, or a definition up to its brace that ends at `last`."""
        statement = self.tokens[first:end]
        statement = without_template(statement)
        while len(statement) > 1 and statement[0].text == "[" and statement[1].text == "[":
            close = next((i for i, t in enumerate(statement) if t.text == "]"), len(statement) - 2)
            statement = statement[close + 2:]
        if not statement or statement[0].text in NO_FUNCTION | TYPES:
            return
        named = called_name(statement)
        if named is None or named[0] == 0 or "operator" in [t.text for t in statement[:named[1]]]:
            return
        name, before = statement[named[0]], statement[named[0] - 1].text
        if before == "::":
            if last is not None:
                self.found.members.append((statement[named[0] - 2].text, statement[0].line, self.tokens[last].line))
            return
        if before in ("~", ".", "->", ",", "(") or name.text == owner or not public:
            return
        final = self.tokens[last if last is not None else end]
        empty = statement[named[1] + 1].text == ")" if named[1] + 1 < len(statement) else False
        self.found.functions.append(Function(
            name.text, owner, name.line, self.comment(self.tokens[first].line, final.line),
            empty and final.line - statement[0].line <= 2 and bool(owner)))

    def comment(self, first, last):
        """The comment that ends on the line before a declaration, or stands behind it."""
        words = [c.text.lstrip("/<! ") for c in self.comments if c.text.startswith("///<") and first <= c.line <= last]
        line = first - 1
        above = {c.line: c.text for c in self.comments}
        while line in above and not above[line].startswith("///<"):
            words.insert(0, above[line].lstrip("/ "))
            line -= 1
        return " ".join(words)


def read_declarations(text):
    """The functions, types and members that a source declares."""
    return Reader(text).read()
