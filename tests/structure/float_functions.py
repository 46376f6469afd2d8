#!/usr/bin/env python3
"""Images do not depend on the system's mathematical library: no program calls its functions for floats.

    float_functions.py <nm> <programs...>

They differ in the last bit from one version to the next. src/base/in_double.h has what is called in their place. Those
that IEEE 754 or their meaning define to the bit, as sqrtf and floorf, are the same everywhere.
"""
import pathlib
import re
import subprocess
import sys

INEXACT = (
    "sin cos sincos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh exp exp2 exp10 expm1 log log2 log10 log1p "
    "pow cbrt hypot erf erfc tgamma lgamma lgamma_r cabs carg cexp clog cpow csqrt csin ccos ctan csinh ccosh ctanh"
).split()


def called(nm, program):
    """Names of what the program has from shared libraries, without their versions."""
    text = subprocess.run([nm, "-D", "--undefined-only", program], check=True, capture_output=True, text=True).stdout
    return {name.split("@")[0] for name in re.findall(r" U (\S+)$", text, re.MULTILINE)}


def main(nm, programs):
    problems = []
    for program in programs:
        names = called(nm, program)
        name = pathlib.Path(program).name
        if not names & set(INEXACT):
            problems.append(f"{name}: calls no mathematical function at all, so what follows means nothing")
        problems += [
            f"{name}: calls {function}f; expected the function for double, rounded, as in src/base/in_double.h"
            for function in INEXACT
            if function + "f" in names
        ]
    print("\n".join(problems))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
