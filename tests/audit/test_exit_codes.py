"""What the exit code of an audit says of a paper that is its own derivation."""

import pytest

from kowalevski_cas.cli import main
from kowalevski_cas.cli.exits import AS_RECORDED, DIFFERENT, NOTHING, UNDECIDED

LAW = r"The equations of motion are \[ \dot x=y,\qquad \dot y=-x. \] "
LAGRANGIAN = r"The Lagrangian is \[ L=\tfrac12\dot x^2-\tfrac12 x^2. \] "
TRUE_OF_IT = r"Then \[ \frac{d}{dt}(\dot x^2+x^2)=0. \] "
TRUE = r"Then \[ \frac{d}{dt}(x^2+y^2)=0. \] "
FALSE = r"Then \[ \frac{d}{dt}(x^2+2y^2)=0. \] "
AS_READ = r"At some places \[ x^2+y^2=3x. \] "
UNREAD = r"Here is \[ \oint x\,dy\frown y. \] "
CLAIMS_UNREAD = r"An integral is \[ \oint x\,dy\frown y. \] "
BESIDE = LAW + TRUE + "An integral is\n"
SENTENCE = r"There are no other integrals of the second degree. "
SKIPPED = "%kc: skip sentence\n"
SKIP = "%kc: skip\n"

PAPERS = [
    ("a law and a true claim", LAW + TRUE, AS_RECORDED, AS_RECORDED),
    ("a false claim", LAW + FALSE, DIFFERENT, DIFFERENT),
    ("a false and a true claim", LAW + TRUE + FALSE, DIFFERENT, DIFFERENT),
    ("a false claim beside one that is not read", LAW + CLAIMS_UNREAD + FALSE, DIFFERENT, DIFFERENT),
    ("a claim that is false as it was read", LAW + TRUE + AS_READ, UNDECIDED, UNDECIDED),
    ("a claiming formula that is not read", LAW + TRUE + CLAIMS_UNREAD, UNDECIDED, UNDECIDED),
    ("the same, skipped", BESIDE + SKIP + UNREAD[8:], AS_RECORDED, AS_RECORDED),
    ("a formula that is not read and claims nothing", LAW + TRUE + UNREAD, AS_RECORDED, UNDECIDED),
    ("a sentence that claims and is not read", LAW + TRUE + "\n" + SENTENCE, UNDECIDED, UNDECIDED),
    ("the same, skipped", LAW + TRUE + "\n" + SKIPPED + SENTENCE, AS_RECORDED, AS_RECORDED),
    ("a law and no claim", LAW, NOTHING, NOTHING),
    ("a law that a Lagrangian gives", LAGRANGIAN + TRUE_OF_IT, AS_RECORDED, AS_RECORDED),
    ("a claim and no law", TRUE, NOTHING, NOTHING),
    ("an identity without a law", r"We have \[ (x+y)^2=x^2+2xy+y^2. \]", NOTHING, NOTHING),
    ("only what is skipped", LAW + "Then\n" + SKIP + TRUE[5:], NOTHING, NOTHING),
    ("no formula", "Nothing is said here.", NOTHING, NOTHING),
    ("only what is not read", UNREAD, NOTHING, NOTHING),
]  # fmt: skip


@pytest.mark.parametrize(
    ("text", "plain", "strict"), [row[1:] for row in PAPERS], ids=[row[0] for row in PAPERS]
)
def test_the_exit_code_of_a_small_paper(tmp_path, capsys, text, plain, strict):
    path = tmp_path / "paper.tex"
    path.write_text(rf"\documentclass{{article}}\begin{{document}}{text}" + "\n\\end{document}\n")
    found = [main(["audit", "--alone", *more, str(path)]) for more in ([], ["--strict"])]
    assert (found, capsys.readouterr().out) and found == [plain, strict]
