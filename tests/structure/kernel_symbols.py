#!/usr/bin/env python3
"""What a scene does not call for is not in the path loop that renders it.

    kernel_symbols.py <nm> <object files of src/tracer/kernels...>

The objects are compiled without inlining, so that every function that a path loop calls has a symbol in its object. Each
object must contain the words of its own effects, which shows that the words are found, and none of those of other effects.
"""
import pathlib
import re
import subprocess
import sys

SPECTRAL = "HeroWavelengths|spectra::"
POLARISED = "StokesRows|ElementShape|polarisation_"
FLUORESCENT = "reradiate|absorbed_before|sample_absorbed"
# Of all materials beyond those of ORB.S.
BOUNDARY = ("Boundary<|Mueller|ThinFilm|Microfacets|(Conductor|Dielectric|ThinElement|Metal|Phong|Plastic|"
            "AnisotropicGgx|GgxLambert)Bsdf")  # fmt: skip

# Kernel: what it must hold, each; what it must not.
KERNELS = {
    "rgb": ([], [SPECTRAL, POLARISED, FLUORESCENT, BOUNDARY, "Stokes|polaris|reradiat"]),
    "rgb_boundary": ([BOUNDARY], ["HeroWavelengths", POLARISED, FLUORESCENT]),
    "spectral": ([SPECTRAL, BOUNDARY], [POLARISED, FLUORESCENT]),
    "bispectral": ([SPECTRAL, FLUORESCENT], [POLARISED]),
    "polarised": ([SPECTRAL, POLARISED], [FLUORESCENT]),
    "stokes": ([SPECTRAL, POLARISED], [FLUORESCENT]),
    "polarised_bispectral": ([SPECTRAL, POLARISED, FLUORESCENT], []),
    "stokes_bispectral": ([SPECTRAL, POLARISED, FLUORESCENT], []),
}


def symbols(nm, file):
    """Names of what the file defines or calls, without constants ("r"), which stand in it whether or not it reads them."""
    text = subprocess.run([nm, "-C", file], check=True, capture_output=True, text=True).stdout
    matches = re.findall(r"^[0-9a-f ]{16} ([A-Za-z]) (.+)$", text, re.MULTILINE)
    return [name for kind, name in matches if kind != "r"]


def main(nm, files):
    problems = []
    seen = {}
    for file in files:
        kernel = pathlib.Path(file).name.split(".")[0]
        if kernel not in KERNELS:
            problems.append(f"{kernel}: nothing here says what its path loop may hold")
            continue
        names = symbols(nm, file)
        seen[kernel] = len(names)
        wanted, unwanted = KERNELS[kernel]
        for words in wanted:
            if not any(re.search(words, name) for name in names):
                problems.append(f"{kernel}: no symbol has {words}, so its absence elsewhere means nothing")
        for words in unwanted:
            found = [name for name in names if re.search(words, name)]
            problems += [f"{kernel}: {name}" for name in found[:3]]
            if len(found) > 3:
                problems.append(f"{kernel}: and {len(found) - 3} more with {words}")
    if missing := KERNELS.keys() - seen.keys():
        problems.append(f"no object of {', '.join(sorted(missing))} was given")
    print("\n".join(problems))
    print(", ".join(f"{kernel}: {count} symbols" for kernel, count in seen.items()), f"- {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
