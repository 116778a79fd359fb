#include "cli/program.h"

int main(int argc, char** argv) { return mixity::cli::run_program({argv + 1, argv + argc}); }
