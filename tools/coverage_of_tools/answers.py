"""What a tool says of the judged parameter."""

import collections

from coverage_of_tools.objectives import LEVELS

# value and standard error; ends by level; why the tool itself calls it a failure, or ""; all parameters and the objective
# they are to minimise, if that is known
Answer = collections.namedtuple("Answer", "value stderr ends said theta kind")


def by_error(problem, theta, stderr, said, kind):
    """Value and standard error, as they are printed: +/- 1 and 1.96 of them."""
    value = float(theta[problem.judged])
    ends = {level: (value - z * stderr, value + z * stderr) for level, z in LEVELS.items()}
    return Answer(value, float(stderr), ends, said, [float(one) for one in theta], kind)


def failed(why):
    return Answer(None, None, {}, why, None, "")
