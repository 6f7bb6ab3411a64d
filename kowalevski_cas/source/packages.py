"""What a source takes from other files: their places, their options, and what they put off."""

from __future__ import annotations

from kowalevski_cas.source.built_in import all_branches
from kowalevski_cas.source.conditionals import Conditionals
from kowalevski_cas.source.definitions import Definer
from kowalevski_cas.source.mouth import Mouth
from kowalevski_cas.source.tex import TypedToken, source_of_tokens


class Files:
    """The commands by which files are read and styles are used; their text follows by itself."""

    def __init__(self, mouth: Mouth, definer: Definer, conditionals: Conditionals) -> None:
        self.mouth, self.definer, self.conditionals = mouth, definer, conditionals
        self.options: list[str] = []
        """The options with which the last style is used."""
        self.declared: dict[str, list[TypedToken]] = {}
        """What the options of a style do."""
        self.later: list[list[TypedToken]] = []
        """What is executed where the document begins."""

    def input(self, token: TypedToken) -> None:
        """The text of another file follows, if it was to be found when the files were read."""
        name = source_of_tokens(
            self.mouth.argument() if self.mouth.peek() == "{" else self._bare_name()
        )
        if not token.literal:
            words = f"{name} is named by a macro; it is not read"
            self.definer.notes.append((token.start, words))

    def _bare_name(self) -> list[TypedToken]:
        """The name of a file without braces, up to a blank."""
        found = []
        while (character := self.mouth.character()) is not None and not character.text.isspace():
            found.append(character)
        return found

    def use(self, token: TypedToken) -> None:
        """A style, of which the text follows if it stands beside the paper."""
        options = self.mouth.optional_argument("[", "]") or []
        self.mouth.argument()
        self.options = [name.strip() for name in source_of_tokens(options).split(",")]
        self.declared = {}

    def declare_option(self, token: TypedToken) -> None:
        """What an option of a style does."""
        star = self.mouth.skips("*")
        name = "" if star else source_of_tokens(self.mouth.argument()).strip()
        self.declared[name] = self.mouth.argument()

    def process_options(self, token: TypedToken) -> None:
        """The options that the style is used with do what they do."""
        self.mouth.skips("*")
        for name in reversed(self.options):
            if name in self.declared:
                self.mouth.put_back(self.declared[name])

    def postpone(self, token: TypedToken) -> None:
        """What is executed where the document begins, if it is certain that it is."""
        tokens = self.mouth.argument()
        self.later.append(all_branches(tokens) if self.conditionals.uncertain else tokens)
