// The program `rasterdiff`: everything it does is one of the verbs in harness/cli.
#include "harness/cli/run.hpp"

int main(int argc, char** argv) { return rasterdiff::harness::cli::run(argc, argv); }
