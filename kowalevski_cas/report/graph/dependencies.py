"""Which claim rests on which: the lines worth drawing, between the boxes worth drawing."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from kowalevski_cas.verify.outcome import Outcome


def dependencies(
    outcomes: Sequence[Outcome], labels: Mapping[str, str]
) -> tuple[dict[str, list[str]], dict[str, list[str]]]:
    """The claims of each box, and the boxes that it rests on: no circles, nothing twice.

    A box is called by its first claim. Claims with the same label share one.
    """
    members = _collapsed(outcomes, labels)
    home = {claim: name for name, claims in members.items() for claim in claims}
    rests: dict[str, list[str]] = {name: [] for name in members}
    for outcome in outcomes:
        name = home[outcome.claim]
        for below in (home[claim] for claim in outcome.rests_on if claim in home):
            if below != name and below not in rests[name]:
                rests[name].append(below)
    return members, _reduced(_acyclic(rests))


def _collapsed(outcomes: Sequence[Outcome], labels: Mapping[str, str]) -> dict[str, list[str]]:
    """Claims with one label as one box, where that makes no circle."""
    members: dict[str, list[str]] = {}
    for outcome in outcomes:
        members.setdefault(labels[outcome.claim], []).append(outcome.claim)
    rests = {outcome.claim: outcome.rests_on for outcome in outcomes}

    def reaches(start: str, group: set[str]) -> bool:
        """Whether a claim rests on one of its own box by way of others."""
        seen: set[str] = set()
        stack = [below for below in rests.get(start, ()) if below not in group]
        while stack:
            claim = stack.pop()
            if claim in group:
                return True
            if claim not in seen:
                seen.add(claim)
                stack.extend(rests.get(claim, ()))
        return False

    found: dict[str, list[str]] = {}
    for claims in members.values():
        tangled = any(reaches(claim, {*claims}) for claim in claims)
        found |= {claim: [claim] for claim in claims} if tangled else {claims[0]: claims}
    return found


def _acyclic(rests: dict[str, list[str]]) -> dict[str, list[str]]:
    """The same without the lines that would close a circle."""
    state: dict[str, int] = {}
    kept: dict[str, list[str]] = {name: [] for name in rests}
    for root in rests:
        if root in state:
            continue
        state[root] = 1
        stack = [(root, iter(rests[root]))]
        while stack:
            name, belows = stack[-1]
            below = next(belows, None)
            if below is None:
                state[name] = 2
                stack.pop()
            elif state.get(below) != 1:
                kept[name].append(below)
                if below not in state:
                    state[below] = 1
                    stack.append((below, iter(rests[below])))
    return kept


def _reduced(rests: dict[str, list[str]]) -> dict[str, list[str]]:
    """The same without the lines that follow from others."""
    below_all: dict[str, set[str]] = {}
    for name in upwards(rests):
        below_all[name] = set(rests[name]).union(*(below_all[b] for b in rests[name]))
    return {
        name: [b for b in belows if not any(b in below_all[o] for o in belows if o != b)]
        for name, belows in rests.items()
    }


def upwards(rests: dict[str, list[str]]) -> list[str]:
    """The names, each after everything that it rests on."""
    done: dict[str, None] = {}
    for root in rests:
        stack = [root]
        while stack:
            name = stack[-1]
            waiting = [b for b in rests[name] if b not in done]
            if waiting:
                stack.extend(reversed(waiting))
            else:
                done.setdefault(name)
                stack.pop()
    return list(done)
