"""Few of many option sets of a kernel that together hold what two options can do to each other."""
import itertools


def pairs(options):
    return set(itertools.combinations(sorted(set(options.replace("-D ", "-D").split())), 2))


def covering(option_sets):
    """Some of the sets, which have all pairs of values that all have: the one that adds most, until none is missing."""
    pairs_of = {options: pairs(options) for options in sorted(option_sets)}
    missing, chosen = set().union(*pairs_of.values()), []
    while missing:
        chosen.append(max(pairs_of, key=lambda options: len(pairs_of[options] & missing)))
        missing -= pairs_of[chosen[-1]]
    return chosen


def covering_kernels(kernels):
    """Those of a list from `quell kernels --json` whose option sets are such few."""
    option_sets = {}
    for kernel in kernels:
        option_sets.setdefault(kernel["stem"], []).append(kernel["options"])
    chosen = {(stem, options) for stem, sets in option_sets.items() for options in covering(sets)}
    return [kernel for kernel in kernels if (kernel["stem"], kernel["options"]) in chosen]
