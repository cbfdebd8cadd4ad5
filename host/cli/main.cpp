#include "host/cli/run_tool.hpp"

int main(int argc, char** argv) { return quell::cli::runTool(argc, argv); }
