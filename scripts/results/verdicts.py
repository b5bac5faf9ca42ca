"""The verdicts on each figure, one for each question of checks.py, in tables and in counts."""

from typing import NamedTuple

from .checks import FILES, QUESTIONS, Result, run_checks
from .data import PAGE, InputError, Results, Tests, markdown_table, read_toml

FACTS = PAGE / "paper_facts.toml"


class Verdict(NamedTuple):
    word: str  # agrees, partly, differs, not run yet, or – without checks
    passed: int
    count: int
    worst: Result | None  # the check that uses the largest share of its bound

    def tally(self):
        return f"{self.passed} of {self.count}" if self.count else ""

    def number(self):
        """The worst number and its bound; empty where no bound is used up: counts, signs, pictures."""
        return f"{self.worst.number}, bound: {self.worst.bound}" if self.worst and self.worst.share else ""

    def cell(self):
        return "; ".join(filter(None, (f"{self.word} {self.tally()}".strip(), self.number())))


def verdict_of(results):
    """All checks passed: agrees; some: partly; none: differs. A picture has no number: where no other check has one
    either and data are missing, nothing has been run yet."""
    passed = sum(r.status == "pass" for r in results)
    measured = [r for r in results if r.number]
    if not results:
        word = "–"
    elif not measured and any(r.status == "missing" for r in results):
        word = "not run yet"
    else:
        word = "agrees" if passed == len(results) else "partly" if passed else "differs"
    return Verdict(word, passed, len(results), max(measured, key=lambda r: r.share, default=None))


def of_method(results, method):
    """The checks of a method; those that belong to none count for the paper's."""
    return [r for r in results if r.method == method or (method == "paper" and r.method == "all")]


def of_figure(results, figure):
    return [r for r in results if figure in r.figures]


def verdicts_of(results):
    """Question: Verdict, for the checks of a figure."""
    return {question: verdict_of([r for r in results if r.against == question]) for question in QUESTIONS}


def headline(fact, results):
    """The worst number over all questions, or the text that a figure has instead if all of its checks passed."""
    verdict = verdict_of(results)
    if verdict.word == "agrees" and "headline" in fact:
        return fact["headline"]
    return verdict.worst.text() if verdict.worst else "–"


def read_facts(file=FACTS):
    facts = read_toml(file).get("figure", [])
    for fact in facts:
        for name in ("number", "title", "shows", "pictures", "paper", "short"):
            if name not in fact:
                raise InputError(f"{file}: figure {fact.get('number', '?')}: {name}: is required")
    return facts


def methods_of(results):
    """The methods that have checks, the paper's first."""
    return sorted({r.method for r in results} - {"all"} | {"paper"}, key=lambda method: (method != "paper", method))


def figure_table(results, method):
    """The verdicts on the figures in Markdown; of a method beyond the paper only figures that it has checks for."""
    rows = []
    for fact in read_facts():
        found = of_figure(of_method(results, method), fact["number"])
        if found or method == "paper":
            rows.append([str(fact["number"]), fact["title"], *(verdict.cell() for verdict in verdicts_of(found).values()),
                         headline(fact, found)])
    return markdown_table(["figure", "what it shows", *QUESTIONS.values(), "worst number"], rows)


def summary(results):
    passed = sum(r.status == "pass" for r in results)
    return f"{passed} passed, {len(results) - passed} failed"


def counts(results):
    """A line for each method: how many checks of each question passed."""
    lines = []
    for method in [*methods_of(results), "all"]:
        verdicts = verdicts_of([r for r in results if r.method == method])
        texts = [f"{QUESTIONS[question]} {verdict.tally()}" for question, verdict in verdicts.items() if verdict.count]
        if texts:
            lines.append(f"{'every method' if method == 'all' else 'method ' + method}: {', '.join(texts)}")
    return lines


def accept(folder, figures, reasons, checks, spacing_mm):
    """Prints all checks and their counts, or the verdicts on each figure; gives 1 if a check failed or lacks its data."""
    results = run_checks(Results(folder), Tests(spacing_mm), checks or FILES)
    if figures:
        print("\n\n".join(text for method in methods_of(results)
                          for text in (f"Method `{method}`:", figure_table(results, method))))
        return 0
    for result in results:
        print(result.line())
        if reasons:
            print(f"        reason for the bound: {result.reason}")
    print("\n".join([*counts(results), summary(results)]))
    return 0 if all(result.status == "pass" for result in results) else 1
