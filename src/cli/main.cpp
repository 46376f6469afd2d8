#include "cli/program.h"

#ifndef ORBS_VERSION
#  define ORBS_VERSION "unknown"
#endif

int main(int argc, char** argv) { return orbs::cli::run_program(argc, argv, ORBS_VERSION); }
